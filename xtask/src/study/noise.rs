//! `cargo xtask study noise`: what the methods are worth on records with white noise, beside the information bound.

mod case;
mod document;
mod figures;
pub(crate) mod flights;
pub(crate) mod methods;
mod outcome;
mod statistics;

use report::Document;

pub(crate) use case::Excitation;
pub(crate) use figures::{METHODS, RATIO_AXIS};

use super::campaign::Campaign;
use crate::TaskError;
use case::Case;
use flights::Simulator;
use outcome::Outcome;

/// Errors, deviations and coverage of each method, for four excitations and four levels of noise.
pub(super) struct NoiseStudy {
    simulator: Simulator,
}

impl NoiseStudy {
    pub(super) fn new() -> Result<Self, TaskError> {
        Ok(Self { simulator: Simulator::new()? })
    }
}

impl Campaign for NoiseStudy {
    type Outcome = Outcome;
    const NAME: &'static str = "noise";
    const SEEDS: u64 = 200;
    const QUICK_SEEDS: u64 = 3;

    fn cases(&self, seeds: u64) -> Vec<Case> {
        case::cases(seeds)
    }

    fn run(&self, case: &Case) -> Result<Outcome, TaskError> {
        methods::run(&self.simulator, case)
    }

    fn document(
        &self,
        outcomes: &[Outcome],
        seeds: u64,
        command: &str,
    ) -> Result<Document, TaskError> {
        document::compose(&statistics::summaries(outcomes), seeds, command)
    }
}
