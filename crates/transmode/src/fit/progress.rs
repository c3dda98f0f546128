//! How far a long file has been read, for a person who watches.

use indicatif::{ProgressBar, ProgressStyle};

use crate::records::binary::Placement;

/// A record of fewer numbers than this is read before anyone looks.
const LONG: u64 = 10_000_000;

/// A bar on standard error, only where that is a terminal and the record is long; it is gone at the end.
#[derive(Debug)]
pub(super) struct Progress(ProgressBar);

impl Progress {
    pub(super) fn new(placement: &Placement) -> Self {
        if placement.samples().saturating_mul(placement.channels()) < LONG {
            return Self(ProgressBar::hidden());
        }
        let template = "{bar:30} {human_pos}/{human_len} samples, {eta} left";
        let style =
            ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        Self(ProgressBar::new(placement.samples()).with_style(style))
    }

    pub(super) fn advance(&self, samples: u64) {
        self.0.inc(samples);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
