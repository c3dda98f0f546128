//! `cargo xtask study disturbance`: what gusts do to the methods, with and without a quiet record that shows their spectrum.

mod case;
mod document;
mod figures;
mod flights;
mod inputs_known;
mod methods;
mod outcome;
mod statistics;
mod tables;
mod turbulence;

use report::Document;

use super::campaign::Campaign;
use crate::TaskError;
use case::Case;
use flights::Simulator;
use outcome::Outcome;

/// Errors, fit, coverage and doubts of each method in gusts of four strengths.
pub(super) struct DisturbanceStudy {
    simulator: Simulator,
}

impl DisturbanceStudy {
    pub(super) fn new() -> Result<Self, TaskError> {
        Ok(Self { simulator: Simulator::new()? })
    }
}

impl Campaign for DisturbanceStudy {
    type Outcome = Outcome;
    const NAME: &'static str = "disturbance";
    const SEEDS: u64 = 100;
    const QUICK_SEEDS: u64 = 1;

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
        let sizes = self.simulator.modes().list().map(num_complex::Complex::norm);
        document::compose(&statistics::summaries(outcomes, sizes), sizes, seeds, command)
    }
}
