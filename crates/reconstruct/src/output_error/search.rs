//! Levenberg-Marquardt over the parameters of all records together.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::disturbance::Weighting;
use super::parametrisation::Parametrisation;
use super::residuals::{Nuisances, RecordSums, missing, readings, residuals, sums};
use super::spectra::Spectrum;
use crate::likelihood::cost::inverse_factor::inverse_factor;
use crate::likelihood::cost::missing::Unknowns;

/// All records at one set of parameters.
#[derive(Clone, Debug)]
pub(super) struct Evaluation {
    pub(super) parameters: DVector<f64>,
    pub(super) cost: f64,
    /// Half the Gauss-Newton matrix of the cost.
    pub(super) gram: DMatrix<f64>,
    descent: DVector<f64>,
    /// What each record has of its own.
    nuisances: Vec<Nuisances>,
    /// Initial and final states and drifts that the records determine.
    pub(super) determined: usize,
}

impl Evaluation {
    /// The inverse of the Gauss-Newton matrix on the directions that the records determine, and the step that it makes of the descent.
    pub(super) fn newton(&self) -> Option<(DVector<f64>, DMatrix<f64>)> {
        const RANK_TOLERANCE: f64 = 1e-11;
        let factor = inverse_factor(&self.gram, RANK_TOLERANCE)?;
        let inverse = factor.tr_mul(&factor);
        Some((&inverse * &self.descent, inverse))
    }
}

/// Steps that a search may take.
const MOST_STEPS: usize = 60;
const FIRST_DAMPING: f64 = 1e-3;
const LEAST_DAMPING: f64 = 1e-9;
const MOST_DAMPING: f64 = 1e8;

/// Records and weights.
#[derive(Clone, Copy)]
pub(super) struct Problem<'a> {
    pub(super) parametrisation: &'a Parametrisation,
    pub(super) spectra: &'a [Spectrum],
}

impl Problem<'_> {
    /// `None` where the parameters make no system, or something is not finite.
    fn evaluate(
        &self,
        parameters: &DVector<f64>,
        weightings: &[Weighting],
        unknowns: &[Option<Unknowns>],
    ) -> Option<Evaluation> {
        let matrices = self.parametrisation.matrices(parameters)?;
        let count = matrices.sizes().count();
        let mut gram = DMatrix::zeros(count, count);
        let mut descent = DVector::zeros(count);
        let (mut cost, mut nuisances, mut determined) = (0.0, Vec::new(), 0);
        let free_lags = self.parametrisation.free_lags();
        let records = self.spectra.iter().zip(weightings).zip(unknowns);
        for ((spectrum, weighting), unknowns) in records {
            let RecordSums {
                cost: own,
                gram: own_gram,
                descent: own_descent,
                nuisances: left,
                determined: known,
            } = sums(&matrices, spectrum, weighting, &free_lags, unknowns.as_ref())?;
            cost += own;
            gram += own_gram;
            descent += own_descent;
            nuisances.push(left);
            determined += known;
        }
        let tangent = self.parametrisation.tangent(parameters)?;
        let mut gram = tangent.tr_mul(&(gram * &tangent));
        let mut descent = tangent.tr_mul(&descent);
        for prior in self.parametrisation.priors(parameters) {
            cost += prior.deviation * prior.deviation;
            gram[(prior.parameter, prior.parameter)] += prior.slope * prior.slope;
            descent[prior.parameter] -= prior.slope * prior.deviation;
        }
        let parameters = parameters.clone();
        cost.is_finite().then_some(Evaluation {
            parameters,
            cost,
            gram,
            descent,
            nuisances,
            determined,
        })
    }

    /// What a fit leaves of each record, m x F.
    pub(super) fn residuals(&self, evaluation: &Evaluation) -> Vec<DMatrix<Complex<f64>>> {
        let Some(matrices) = self.parametrisation.matrices(&evaluation.parameters) else {
            return Vec::new();
        };
        let records = self.spectra.iter().zip(&evaluation.nuisances);
        records.map(|(spectrum, own)| residuals(&matrices, spectrum, own)).collect()
    }

    /// What the sensors of each record read, m x F, missing samples at their most likely values.
    pub(super) fn readings(&self, evaluation: &Evaluation) -> Vec<DMatrix<Complex<f64>>> {
        let Some(matrices) = self.parametrisation.matrices(&evaluation.parameters) else {
            return Vec::new();
        };
        let records = self.spectra.iter().zip(&evaluation.nuisances);
        records.map(|(spectrum, own)| readings(&matrices, spectrum, own)).collect()
    }

    /// Of each record.
    fn unknowns(
        &self,
        parameters: &DVector<f64>,
        weightings: &[Weighting],
    ) -> Option<Vec<Option<Unknowns>>> {
        let matrices = self.parametrisation.matrices(parameters)?;
        let free_lags = self.parametrisation.free_lags();
        let records = self.spectra.iter().zip(weightings);
        let of_record = |(spectrum, weighting)| missing(&matrices, spectrum, weighting, &free_lags);
        Some(records.map(of_record).collect())
    }

    /// The lowest cost near these parameters; ends where the next step would lower it by less than `tolerance`.
    pub(super) fn minimise(
        &self,
        start: &DVector<f64>,
        weightings: &[Weighting],
        tolerance: f64,
    ) -> Option<Evaluation> {
        let unknowns = self.unknowns(start, weightings)?;
        let mut here = self.evaluate(start, weightings, &unknowns)?;
        let mut damping = FIRST_DAMPING;
        for _ in 0..MOST_STEPS {
            let scale = here.gram.diagonal().map(|d| if d > 0.0 { 1.0 / d.sqrt() } else { 1.0 });
            let unit = DMatrix::from_fn(here.gram.nrows(), here.gram.ncols(), |i, k| {
                here.gram[(i, k)] * scale[i] * scale[k]
            });
            let slope = here.descent.component_mul(&scale);
            let mut lower = None;
            while damping < MOST_DAMPING {
                let mut matrix = unit.clone();
                for k in 0..matrix.nrows() {
                    matrix[(k, k)] += damping;
                }
                let Some(factor) = matrix.cholesky() else {
                    damping *= 10.0;
                    continue;
                };
                let scaled = factor.solve(&slope);
                let predicted = 2.0 * scaled.dot(&slope) - scaled.dot(&(&unit * &scaled));
                if predicted < tolerance {
                    return Some(here);
                }
                let next = &here.parameters + scaled.component_mul(&scale);
                match self.evaluate(&next, weightings, &unknowns) {
                    Some(trial) if trial.cost < here.cost => {
                        let ratio = (here.cost - trial.cost) / predicted;
                        damping *= if ratio > 0.75 { 0.1 } else { 1.0 };
                        damping = damping.max(LEAST_DAMPING);
                        lower = Some(trial);
                        break;
                    }
                    _ => damping *= 10.0,
                }
            }
            match lower {
                Some(trial) => here = trial,
                None => return Some(here),
            }
        }
        Some(here)
    }
}
