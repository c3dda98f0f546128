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

/// Work without a known end.
#[derive(Debug)]
pub(crate) struct Working {
    bar: ProgressBar,
    started: Instant,
    mode: Progress,
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

impl Progress {
    /// For work of many steps, of which nobody knows how long they take.
    pub(crate) fn work(self, what: &'static str) -> Working {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        Working { bar: bar.with_message(what), started: Instant::now(), mode: self }
    }
}

impl Working {
    /// Another step is done.
    pub(crate) fn tick(&self) {
        /// How often a spinner turns by itself.
        const TURN: Duration = Duration::from_millis(120);
        if self.mode == Progress::Shown && self.bar.is_hidden() && self.started.elapsed() > PATIENCE
        {
            // Draws only where standard error is a terminal.
            self.bar.set_style(ProgressStyle::default_spinner());
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
            self.bar.enable_steady_tick(TURN);
        }
        self.bar.tick();
    }
}

impl Drop for Working {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
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
