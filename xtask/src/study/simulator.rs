//! `cargo xtask study simulator`: what the default settings are worth on flights in a nonlinear
//! simulator that nobody of the project wrote.

mod document;
mod figures;
mod kind;
mod one_run;
mod summary;

use std::path::PathBuf;

use num_complex::Complex;
use report::Document;

use super::definition::{Runs, Seeds, Study};
use super::sections::sections;
use crate::TaskError;
use crate::shared::simulator_flights::{self as flights, Truth};
use kind::{Aircraft, Kind, Motion};
use one_run::Outcome;
use summary::Case;

/// Errors, scores and doubts of the default settings on flights of six aircraft.
pub(super) struct SimulatorStudy {
    /// Where the records are.
    folder: PathBuf,
    truth: Truth,
}

impl Study for SimulatorStudy {
    const NAME: &'static str = "simulator";
    const EDITION: u32 = 3;
    const SEEDS: Option<Seeds> = None;
    type Kind = Kind;
    type Outcome = Outcome;

    fn new() -> Result<Self, TaskError> {
        let folder = flights::folder();
        Ok(Self { truth: Truth::read(&folder)?, folder })
    }

    fn kinds(&self) -> Vec<Kind> {
        let of_all =
            |motion, recorded| Aircraft::ALL.map(|aircraft| Kind { motion, aircraft, recorded });
        let without = Motion::RECONSTRUCTED.iter().flat_map(|motion| of_all(*motion, false));
        let with = Motion::RECORDED.into_iter().flat_map(|motion| of_all(motion, true));
        without.chain(with).collect()
    }

    fn quick_kinds(&self) -> Vec<Kind> {
        let quick = |kind: &Kind| {
            matches!(kind.motion, Motion::Clean | Motion::Multistep | Motion::Turb1)
                && matches!(kind.aircraft, Aircraft::Md11 | Aircraft::Concorde)
        };
        self.kinds().into_iter().filter(quick).collect()
    }

    fn run(&self, kind: Kind, _seed: u64) -> Result<Outcome, TaskError> {
        let flight = flights::read(&self.folder, kind.aircraft.name(), kind.motion.name())?;
        let truth = self.truth.of(kind.aircraft.name())?.modes();
        Ok(one_run::run(flight, kind.recorded, &truth))
    }

    fn document(
        &self,
        runs: &Runs<Self>,
        _seeds: u64,
        command: &str,
    ) -> Result<Document, TaskError> {
        let missing = TaskError::computation("study");
        let mut cases = Vec::new();
        for (kind, outcomes) in runs {
            let [outcome] = &outcomes[..] else { return Err(missing("not one run of each kind")) };
            let sizes = self.truth.of(kind.aircraft.name())?.modes().list().map(Complex::norm);
            cases.push((*kind, vec![Case { kind: *kind, outcome: outcome.clone(), sizes }]));
        }
        let sections = sections(&cases, Kind::title, |_, cases| cases[0].clone());
        document::compose(&sections, &self.truth, command)
    }
}

#[cfg(test)]
mod tests;
