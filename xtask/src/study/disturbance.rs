//! `cargo xtask study disturbance`: what gusts do to the methods, with and without a quiet record
//! that shows their spectrum.

mod document;
mod figures;
mod flights;
mod inputs_known;
mod kind;
mod one_run;
mod summary;
mod tables;
mod turbulence;

use num_complex::Complex;
use report::Document;

use super::definition::{Runs, Seeds, Study};
use super::sections::sections;
use crate::TaskError;
use flights::Simulator;
use kind::{Excitation, Kind};
use one_run::Outcome;
use summary::Summary;

/// Errors, fit, coverage and doubts of each method in gusts of four strengths.
pub(super) struct DisturbanceStudy {
    simulator: Simulator,
}

const GUST_PERCENT: [u32; 4] = [0, 10, 30, 100];

impl Study for DisturbanceStudy {
    const NAME: &'static str = "disturbance";
    const EDITION: u32 = 2;
    const SEEDS: Option<Seeds> = Some(Seeds { page: 100, quick: 1 });
    type Kind = Kind;
    type Outcome = Outcome;

    fn new() -> Result<Self, TaskError> {
        Ok(Self { simulator: Simulator::new()? })
    }

    fn kinds(&self) -> Vec<Kind> {
        let gusts = |excitation| GUST_PERCENT.map(|gust_percent| Kind { excitation, gust_percent });
        Excitation::ALL.into_iter().flat_map(gusts).collect()
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
        let sizes = self.simulator.aircraft.modes.list().map(Complex::norm);
        let sections = sections(
            runs,
            |kind| kind.excitation.title(),
            |kind, outcomes| Summary::of(kind, outcomes, sizes),
        );
        document::compose(&sections, sizes, seeds, command)
    }
}
