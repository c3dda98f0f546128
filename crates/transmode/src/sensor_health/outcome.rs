//! All that one run found.

use monitor::{Diagnosis, Window};

use super::reference::Reference;
use crate::records::LoadWarning;

/// One new record and what was found in it.
#[derive(Debug)]
pub(super) struct Watched {
    pub(super) name: String,
    /// The time of the first sample.
    pub(super) start_s: f64,
    pub(super) windows: Vec<Window>,
    /// Whole windows of which missing samples leave too little.
    pub(super) not_judged: usize,
    pub(super) diagnosis: Option<Diagnosis>,
}

/// All that one run found.
#[derive(Debug)]
pub(super) struct MonitorOutcome {
    pub(super) reference: Reference,
    pub(super) watched: Vec<Watched>,
    pub(super) warnings: Vec<LoadWarning>,
}
