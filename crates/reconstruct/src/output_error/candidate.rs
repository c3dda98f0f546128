//! A form of the equations, fitted: fit and spectrum of the disturbance in turns until both stand still.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::cells::Matrices;
use super::disturbance::{Weighting, flat, from_residuals};
use super::parametrisation::Parametrisation;
use super::search::{Evaluation, Problem};
use super::spectra::Spectrum;

/// A fit that stands still.
#[derive(Clone, Debug)]
pub(super) struct Candidate {
    pub(super) parametrisation: Parametrisation,
    pub(super) evaluation: Evaluation,
    pub(super) weightings: Vec<Weighting>,
    /// By how much the last round moved the parameters, in squared standard errors.
    pub(super) last_move: f64,
    /// Schwarz's criterion.
    pub(super) criterion: f64,
}

/// How far a fit goes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    /// Fits after the first one, at most.
    rounds: usize,
    /// A search ends where its next step would lower the cost by so much; a standard error costs 1.
    tolerance: f64,
}

/// To compare forms: within a few units of the criterion.
pub(super) const FIRST_LOOK: Effort = Effort { rounds: 3, tolerance: 0.3 };
/// Until fit and spectrum stand still.
pub(super) const TO_THE_END: Effort = Effort { rounds: 10, tolerance: 1e-3 };
/// Of the first fit, whose weights are not final.
const FIRST_TOLERANCE: f64 = 1.0;
/// A round that moves the parameters by less than this, in squared standard errors, is the last.
const STILL: f64 = 1e-2;

impl Candidate {
    /// From the best of the starts.
    pub(super) fn fit(
        parametrisation: Parametrisation,
        spectra: &[Spectrum],
        starts: &[DVector<f64>],
        effort: Effort,
    ) -> Option<Self> {
        let problem = Problem { parametrisation: &parametrisation, spectra };
        let flat: Vec<Weighting> = spectra.iter().map(flat).collect();
        let firsts =
            starts.iter().filter_map(|start| problem.minimise(start, &flat, FIRST_TOLERANCE));
        let first = firsts.min_by(|x, y| x.cost.total_cmp(&y.cost))?;
        Self::settle(parametrisation, spectra, first, effort)
    }

    fn settle(
        parametrisation: Parametrisation,
        spectra: &[Spectrum],
        first: Evaluation,
        effort: Effort,
    ) -> Option<Self> {
        let problem = Problem { parametrisation: &parametrisation, spectra };
        let weightings_of = |evaluation: &Evaluation| -> Option<Vec<Weighting>> {
            let residuals = problem.residuals(evaluation);
            let matrices = parametrisation.matrices(&evaluation.parameters)?;
            let eigenvalues = matrices.a.complex_eigenvalues();
            let eigenvalues = eigenvalues.as_slice();
            residuals
                .iter()
                .zip(spectra)
                .map(|(own, spectrum)| from_residuals(own, spectrum, eigenvalues))
                .collect()
        };
        let mut evaluation = first;
        let mut weightings = weightings_of(&evaluation)?;
        let mut last_move = f64::INFINITY;
        for round in 1..=effort.rounds {
            let next = problem.minimise(&evaluation.parameters, &weightings, effort.tolerance)?;
            let step = &next.parameters - &evaluation.parameters;
            last_move = step.dot(&(&next.gram * &step));
            evaluation = next;
            // The cost belongs to the weights with which it was minimised.
            if last_move < STILL || round == effort.rounds {
                break;
            }
            weightings = weightings_of(&evaluation)?;
        }
        let determinants: f64 = weightings.iter().map(|own| own.log_determinant).sum();
        let numbers: f64 = spectra.iter().map(Spectrum::real_numbers).sum();
        let parameters = (parametrisation.identifiable() + evaluation.determined) as f64;
        let criterion = determinants + evaluation.cost + numbers.ln() * parameters;
        criterion.is_finite().then_some(Self {
            parametrisation,
            evaluation,
            weightings,
            last_move,
            criterion,
        })
    }

    /// The same from where it is to the end.
    pub(super) fn refined(&self, spectra: &[Spectrum]) -> Option<Self> {
        let first = self.evaluation.clone();
        Self::settle(self.parametrisation.clone(), spectra, first, TO_THE_END)
    }

    /// The lowest cost under the weights of this fit, with records that hold something else.
    pub(super) fn cost_of(&self, spectra: &[Spectrum]) -> Option<f64> {
        let problem = Problem { parametrisation: &self.parametrisation, spectra };
        let start = &self.evaluation.parameters;
        let found = problem.minimise(start, &self.weightings, FIRST_LOOK.tolerance)?;
        Some(found.cost)
    }

    /// By how much its fastest growing mode grows in so many seconds, as a logarithm; sampled every `period` seconds.
    pub(super) fn growth(&self, period: f64, seconds: f64) -> f64 {
        let Some(matrices) = self.matrices() else { return f64::INFINITY };
        let values = matrices.a.complex_eigenvalues();
        values.iter().map(|z| z.norm().ln() / period * seconds).fold(f64::NEG_INFINITY, f64::max)
    }

    /// What it leaves of each record, m x F.
    pub(super) fn residuals(&self, spectra: &[Spectrum]) -> Vec<DMatrix<Complex<f64>>> {
        Problem { parametrisation: &self.parametrisation, spectra }.residuals(&self.evaluation)
    }

    /// What the sensors of each record read, m x F, missing samples at their most likely values.
    pub(super) fn readings(&self, spectra: &[Spectrum]) -> Vec<DMatrix<Complex<f64>>> {
        Problem { parametrisation: &self.parametrisation, spectra }.readings(&self.evaluation)
    }

    /// The matrices as fitted.
    pub(super) fn matrices(&self) -> Option<Matrices> {
        self.parametrisation.matrices(&self.evaluation.parameters)
    }
}
