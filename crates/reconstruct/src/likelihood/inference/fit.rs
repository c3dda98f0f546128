//! The result: the system, how certain it is, and how the search went.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::derivatives::Derivative;
use super::goodness_of_fit::{ChiSquared, Whiteness};
use super::offset_test::OffsetTest;
use super::uncertainty::{Estimate, Mode};
use crate::SharedModel;
use crate::likelihood::cost::noise::LEAST_MODEL_ERROR;
use crate::likelihood::options::Options;
use crate::likelihood::search::hold_selection::PRICE;
use crate::likelihood::search::report::{SearchReport, StartReport};
use crate::model::Hold;

/// What the likelihood says about several records.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Fit {
    /// The system, in the sensors' units. In its basis the states of the records have unit second moments; each (b_j, d_j) has unit length, before
    /// sensors are scaled back.
    pub model: SharedModel,
    /// The covariance of A by columns, C by columns, then b_j and, for the sensors in `feedthrough_sensors`, the entries of d_j of each record. It is singular along changes of basis and of
    /// scale, which it leaves out.
    pub covariance: DMatrix<f64>,
    /// The modes with their uncertainty, by real part of the eigenvalue, a complex pair once.
    pub modes: Vec<Mode>,
    /// Indices of the sensors with an entry of d_j: those of the options under a zero-order hold, all under a first-order hold.
    pub feedthrough_sensors: Vec<usize>,
    /// What it was made with: offsets, hold and band as they came out where that was left open.
    pub options: Options,
    /// How the excitation moves between samples: as in the options, or what is more likely.
    pub hold: Hold,
    /// Minus twice the logarithm of the other hold's likelihood over this one's, with 2 for each number of a record that one of them has more; at most 20
    /// where the excitation is held. `None` where the hold was given, or where the search for the other one did not arrive.
    pub hold_evidence: Option<f64>,
    /// Minus twice the logarithm of the likelihood, up to a constant of the records and of [`Options::noise`](crate::likelihood::Options::noise), with 2 for each number that was fitted: Akaike's criterion, by
    /// which fits of several orders or under several holds compare.
    pub criterion: f64,
    /// How many numbers were fitted: those of `identifiable` and the coefficients of known signals that the records determine.
    pub parameters: usize,
    /// Directions of the parameters that the records determine.
    pub determined: usize,
    /// Directions that can be identified where the records excite everything: n J + m n - J, and one more for each free entry of d_j.
    pub identifiable: usize,
    /// The derivatives of the lateral equations, see [`identify_lateral`](crate::likelihood::identify_lateral); empty where all entries of the matrices are free.
    pub derivatives: Vec<Derivative>,
    /// The correlations of their estimates.
    pub correlations: DMatrix<f64>,
    /// All that was free instead of the entries of the matrices, see `cost/lateral.rs`.
    pub(crate) lateral: Option<DVector<f64>>,
    /// How many of these numbers rest on what is known beforehand rather than on the records.
    pub(crate) known_beforehand: f64,
    /// Standard deviations of the noise in the sensors' units; `None` where the noise has a spectrum.
    pub noise_levels: Option<Vec<Estimate>>,
    /// The relative model error eps of [`Noise::ModelError`](crate::likelihood::Noise::ModelError); `None` for other noise.
    pub model_error: Option<Estimate>,
    /// The size of the residuals.
    pub chi_squared: ChiSquared,
    /// The same for each record alone: value per degree of freedom, parameters shared out by numbers of samples.
    pub record_chi_squared: Vec<f64>,
    /// Whether the residuals of each record are white.
    pub whiteness: Vec<Whiteness>,
    /// For each pair of records, how differently they were excited.
    pub contrasts: Vec<Contrast>,
    /// Whether the sensors read zero in trim; `None` where the options do not say that they do, or frequency zero is not used.
    pub offset_test: Option<OffsetTest>,
    /// How the search ended.
    pub search: SearchReport,
    /// Each start that was given, in the order given.
    pub starts: Vec<StartReport>,
    /// Index of the start that led here.
    pub best_start: usize,
    /// Restarts with a slow mode moved elsewhere that found a better optimum than all starts, in rounds.
    pub restarts: usize,
    /// Other local optima that are nearly as likely.
    pub rivals: Vec<Rival>,
}

impl Fit {
    /// Whether the model error is the least that is assumed: the records show none as large. False without one.
    #[must_use]
    pub fn has_least_model_error(&self) -> bool {
        /// What the last update may leave above it.
        const LEFT: f64 = 1.2;
        self.model_error.is_some_and(|error| error.value < LEFT * LEAST_MODEL_ERROR)
    }

    /// The variances of white noise and, where there is one, the square of the model error, in the sensors' units; empty where the noise has a spectrum.
    pub(crate) fn variances(&self) -> Vec<f64> {
        let levels = self.noise_levels.iter().flatten().chain(&self.model_error);
        levels.map(|level| level.value * level.value).collect()
    }

    /// Minus twice the logarithm of the likelihood, up to the constant of the criteria.
    pub(crate) fn objective(&self) -> f64 {
        self.criterion - PRICE * self.parameters as f64
    }

    /// The criterion with the logarithm of the number of residuals for each number that was fitted instead of 2: Schwarz's, which prefers fewer states.
    #[must_use]
    pub fn bayesian_criterion(&self) -> f64 {
        let parameters = self.parameters as f64;
        let residuals = self.chi_squared.degrees_of_freedom + parameters;
        self.criterion + (residuals.ln() - PRICE) * parameters
    }
}

/// How differently two records were excited. Where one direction serves both, nothing tells the states from a feedback to the excitation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Contrast {
    /// The records.
    pub records: [usize; 2],
    /// What chi-squared rises by, per unit of its value for a degree of freedom, where one of them takes the direction of the other; the smaller of both ways.
    pub statistic: f64,
}

/// Another system that the records allow.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Rival {
    /// Minus twice the logarithm of its likelihood over the best one's: 6 is a ratio of 1 to 20.
    pub above: f64,
    /// Its eigenvalues in rad/s, a complex pair once.
    pub eigenvalues: Vec<Complex<f64>>,
}
