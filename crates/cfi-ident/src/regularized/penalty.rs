//! What is penalised: the choice of P(g), and its value.

use nalgebra::DVector;

use super::program::nuclear_norm;
use crate::{FitError, Parameter, Structure};

/// What is penalised. `g_i` are the Markov parameters in units of the two signals' root mean squares; see the module for the objective.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Regularization {
    /// Half the sum of squares of all Markov parameters.
    Ridge,
    /// The sum of magnitudes of all Markov parameters: those that are not needed become zero.
    Lasso,
    /// Squares weighted by `rho^-|i|`: impulse responses that decay like `rho^(|i|/2)` in both directions of time cost the same
    /// at every lag.
    ExponentiallyWeighted {
        /// `rho`, above 0 and at most 1; 1 is the ridge.
        decay: f64,
    },
    /// The sum of singular values of the causal and of the anticausal Hankel matrix: the convex stand-in for their ranks, which are
    /// the orders of the two halves. `h_0` is a direct feedthrough and is not penalised.
    NuclearNorm,
}

/// The largest weight of [`Regularization::ExponentiallyWeighted`], beyond which rounding drowns the other parameters.
const LARGEST_WEIGHT: f64 = 1e12;

impl Regularization {
    pub(super) fn check(self, reach: usize) -> Result<(), FitError> {
        if let Self::ExponentiallyWeighted { decay } = self {
            let what = "the decay of the exponential weights";
            if !(decay > 0.0 && decay <= 1.0) {
                return Err(FitError::BadValue {
                    what,
                    value: decay,
                    needed: "above 0 and at most 1",
                });
            }
            if weight(decay, reach) > LARGEST_WEIGHT {
                return Err(FitError::BadValue {
                    what,
                    value: decay,
                    needed: "large enough to keep all weights below 1e12",
                });
            }
        }
        Ok(())
    }
}

/// rho^-|i|
fn weight(decay: f64, index: usize) -> f64 {
    decay.powf(-(index as f64))
}

/// The weight of each parameter's square, twice the penalty's factor; zero for what is not penalised by squares.
pub(super) fn square_weights(structure: Structure, regularization: Regularization) -> DVector<f64> {
    let of = |parameter| match (parameter, regularization) {
        (Parameter::Markov(_), Regularization::Ridge) => 1.0,
        (Parameter::Markov(i), Regularization::ExponentiallyWeighted { decay }) => {
            weight(decay, i.unsigned_abs())
        }
        _ => 0.0,
    };
    DVector::from_iterator(structure.parameter_count(), structure.parameters().map(of))
}

/// P(g): the penalty without its factor.
pub(super) fn penalty(
    structure: Structure,
    regularization: Regularization,
    x: &DVector<f64>,
) -> f64 {
    let g = &x.as_slice()[structure.denominator_count()..];
    match regularization {
        Regularization::Ridge | Regularization::ExponentiallyWeighted { .. } => {
            square_weights(structure, regularization).component_mul(x).dot(x) / 2.0
        }
        Regularization::Lasso => g.iter().map(|g| g.abs()).sum(),
        Regularization::NuclearNorm => {
            let (future, past) = g.split_at(structure.orders.anticausal());
            let future: Vec<f64> = future.iter().rev().copied().collect();
            nuclear_norm(&past[1..]) + nuclear_norm(&future)
        }
    }
}
