//! How far a long file has been read, for a person who watches.

use std::path::Path;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// What takes less is over before anyone looks.
const PATIENCE: Duration = Duration::from_secs(1);

/// Whether anybody watches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Progress {
    /// Bars on standard error, where that is a terminal and reading takes over a second; they are gone at the end.
    Shown,
    /// Nothing is shown.
    Hidden,
}

/// How far one file has been read.
#[derive(Debug)]
pub(crate) struct Bar {
    bar: ProgressBar,
    started: Instant,
    mode: Progress,
}

impl Progress {
    /// For a file of so many bytes.
    pub(crate) fn bytes(self, file: &Path, length: u64) -> Bar {
        let name =
            file.file_name().unwrap_or(file.as_os_str()).to_string_lossy().replace(['{', '}'], "_");
        Bar::new(
            self,
            length,
            &format!("{name} {{bar:30}} {{bytes}} of {{total_bytes}}, {{eta}} left"),
        )
    }

    /// For a record of so many samples.
    pub(crate) fn samples(self, count: u64) -> Bar {
        Bar::new(self, count, "{bar:30} {human_pos}/{human_len} samples, {eta} left")
    }
}

impl Bar {
    fn new(mode: Progress, length: u64, template: &str) -> Self {
        let style =
            ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::hidden())
            .with_style(style);
        Self { bar, started: Instant::now(), mode }
    }

    /// So much more has been read.
    pub(crate) fn advance(&self, amount: u64) {
        if self.mode == Progress::Shown && self.bar.is_hidden() && self.started.elapsed() > PATIENCE
        {
            // Draws only where standard error is a terminal.
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.inc(amount);
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
