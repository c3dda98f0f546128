//! `cargo xtask study disturbance`: what gusts do to the methods, with and without a quiet record
//! that shows their spectrum.

mod document;
mod figures;
mod flights;
mod inputs_known;
mod one_run;
mod summary;
mod tables;
mod turbulence;

use num_complex::Complex;
use report::Document;
use serde::{Deserialize, Serialize};

use super::definition::{Runs, Study};
use super::sections::sections;
use crate::TaskError;
use flights::Simulator;
use one_run::Outcome;
use summary::Summary;

/// Errors, fit, coverage and doubts of each method in gusts of four strengths.
pub(super) struct DisturbanceStudy {
    simulator: Simulator,
}

/// How the controls move, for 180 s at 10 Hz. White motion, which no surface can follow, is left to
/// the study of noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Excitation {
    /// u(k+1) = 0.9 u(k) + white Gaussian noise, held between samples: a pilot who never rests,
    /// with his power where the modes are.
    Autoregressive,
    /// A 3-2-1-1 with steps of 0.7 s every 15 s, each to a random side: a test programme.
    Multisteps,
}

impl Excitation {
    pub(crate) const ALL: [Self; 2] = [Self::Autoregressive, Self::Multisteps];

    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Autoregressive => "AR(1), 0.9",
            Self::Multisteps => "3-2-1-1 every 15 s",
        }
    }
}

/// What is varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Kind {
    excitation: Excitation,
    /// Size of the gusts' motion in percent of that of the response to the controls.
    gust_percent: u32,
}

const GUST_PERCENT: [u32; 4] = [0, 10, 30, 100];

impl Study for DisturbanceStudy {
    const NAME: &'static str = "disturbance";
    const EDITION: u32 = 1;
    const SEEDS: u64 = 100;
    const QUICK_SEEDS: u64 = 1;
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
