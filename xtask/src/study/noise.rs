//! `cargo xtask study noise`: what the methods are worth on records with white noise, beside the
//! information bound.

mod document;
mod figures;
mod kind;
mod one_run;
mod summary;

use report::Document;

use super::definition::{Runs, Seeds, Study};
use super::sections::sections;
use crate::TaskError;
use crate::shared::noisy_flights::{Excitation, Simulator};
use kind::Kind;
use one_run::Outcome;
use summary::Summary;

/// Errors, deviations and coverage of each method, for four excitations and four levels of noise.
pub(super) struct NoiseStudy {
    simulator: Simulator,
}

const SIGNAL_TO_NOISE: [u32; 4] = [1000, 100, 30, 10];

impl Study for NoiseStudy {
    const NAME: &'static str = "noise";
    const EDITION: u32 = 4;
    const SEEDS: Option<Seeds> = Some(Seeds { page: 200, quick: 3 });
    type Kind = Kind;
    type Outcome = Outcome;

    fn new() -> Result<Self, TaskError> {
        Ok(Self { simulator: Simulator::new()? })
    }

    fn kinds(&self) -> Vec<Kind> {
        let levels = |excitation| {
            SIGNAL_TO_NOISE.map(|signal_to_noise| Kind { excitation, signal_to_noise })
        };
        Excitation::ALL.into_iter().flat_map(levels).collect()
    }

    fn run(&self, kind: Kind, seed: u64) -> Result<Outcome, TaskError> {
        one_run::run(&self.simulator, kind, seed)
    }

    fn document(
        &self,
        runs: &Runs<Self>,
        seeds: u64,
        command: &str,
    ) -> Result<Document, TaskError> {
        let sections = sections(runs, |kind| kind.excitation.title(), Summary::of);
        document::compose(&sections, seeds, command)
    }
}
