//! How far a long file has been read, for a person who watches.

use std::path::Path;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread::JoinHandle;
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

/// Work without a known end; it is over when this is dropped.
#[derive(Debug)]
pub(crate) struct Working {
    /// What the thread waits for, which tells by being dropped.
    over: Option<Sender<()>>,
    spinner: Option<JoinHandle<()>>,
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
    /// For work of which nobody knows how long it takes.
    pub(crate) fn work(self, what: &'static str) -> Working {
        if self == Self::Hidden {
            return Working { over: None, spinner: None };
        }
        let (over, wait) = mpsc::channel();
        // Without a thread nothing turns, and the work is done all the same.
        let spinner = std::thread::Builder::new().spawn(move || spin(what, &wait)).ok();
        Working { over: Some(over), spinner }
    }
}

/// Turns a spinner from a second on until the work is over.
fn spin(what: &'static str, wait: &Receiver<()>) {
    /// How often it turns.
    const TURN: Duration = Duration::from_millis(120);
    if wait.recv_timeout(PATIENCE) != Err(RecvTimeoutError::Timeout) {
        return;
    }
    // Draws only where standard error is a terminal.
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr())
        .with_style(ProgressStyle::default_spinner())
        .with_message(what);
    bar.enable_steady_tick(TURN);
    let _ = wait.recv();
    bar.finish_and_clear();
}

impl Drop for Working {
    fn drop(&mut self) {
        self.over = None;
        if let Some(spinner) = self.spinner.take() {
            let _ = spinner.join();
        }
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
