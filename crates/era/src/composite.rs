//! Realization of a noncausal model: one system in each direction of time.

use lti::SamplePeriod;
use nalgebra::DMatrix;
use poly::{Poly, Rational};

use crate::balanced::magnitude;
use crate::realize::realize_tail;
use crate::transfer::{HalfTransfer, expand};
use crate::{EraError, EraOptions, NoncausalMarkov, Realization};

/// Options of the two halves.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct CompositeOptions {
    /// For `h_1, h_2, ..`; its order is the paper's `n_s`.
    pub causal: EraOptions,
    /// For `h_-1, h_-2, ..`; its order is the paper's `n_u`.
    pub anticausal: EraOptions,
}

impl CompositeOptions {
    /// Options of either side.
    #[must_use]
    pub fn new(causal: EraOptions, anticausal: EraOptions) -> Self {
        Self { causal, anticausal }
    }

    /// The same options on both sides.
    #[must_use]
    pub fn both(options: EraOptions) -> Self {
        Self::new(options, options)
    }
}

/// Two systems whose responses together are a noncausal impulse response.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct CompositeRealization {
    /// `sum_(i>=0) h_i q^-i`.
    pub causal: Realization,
    /// `sum_(i>=1) h_-i w^-i` in reversed time, `w = 1/q`, without feedthrough: its state runs backward,
    /// `x(k-1) = A x(k) + B u(k)`.
    pub anticausal: Realization,
    /// What was realized.
    pub markov: NoncausalMarkov,
}

/// A transfer function in `q`, with what was left out on the way.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct CompositeTransfer {
    /// The sum of both halves over the product of their denominators.
    pub rational: Rational<f64>,
    /// The causal half in powers of `1/q`.
    pub causal: HalfTransfer,
    /// The anticausal half in powers of `q`.
    pub anticausal: HalfTransfer,
}

/// Realizes the causal and the time-reversed half of a noncausal model.
///
/// `sum_(i=-d)^r h_i q^-i` is taken for the beginning of a Laurent series on the unit circle. Its causal half becomes a
/// system in `q`, the other half a system in `w = 1/q`; each is [`realize`](crate::realize())d alone.
/// The `h_i` come from one fit, so that their rounding errors are relative to the largest of all: the floor of each half is
/// at least that. A half that is zero up to rounding gets order 0.
///
/// Source: paper part V.C.
///
/// # Errors
///
/// As [`realize`](crate::realize()); a half without any parameter is allowed, one with a single parameter is not.
///
/// # Example
///
/// `3 q^2 + 2 q + 5`: the causal half is a gain, the other half is nilpotent of order two.
///
/// ```
/// use era::{CompositeOptions, NoncausalMarkov, realize_composite};
/// use lti::SamplePeriod;
///
/// let h = NoncausalMarkov::siso(&[2.0, 3.0, 0.0, 0.0, 0.0, 0.0], &[5.0, 0.0, 0.0])?;
/// let realization = realize_composite(&h, SamplePeriod::new(0.1)?, &CompositeOptions::default())?;
/// assert_eq!((realization.causal.order, realization.anticausal.order), (0, 2));
///
/// let transfer = realization.transfer_function()?;
/// assert_eq!(transfer.rational.denominator().degree(), Some(0));
/// assert!((transfer.rational.eval_complex(2.0.into()).re - 21.0).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn realize_composite(
    markov: &NoncausalMarkov,
    period: SamplePeriod,
    options: &CompositeOptions,
) -> Result<CompositeRealization, EraError> {
    let (feedthrough, tail) = markov.causal().split_first().ok_or(EraError::NoFeedthrough)?;
    let none = DMatrix::zeros(feedthrough.nrows(), feedthrough.ncols());
    let shared = magnitude(markov.causal()).max(magnitude(markov.anticausal()));
    Ok(CompositeRealization {
        causal: realize_tail(feedthrough, tail, shared, period, &options.causal)?,
        anticausal: realize_tail(&none, markov.anticausal(), shared, period, &options.anticausal)?,
        markov: markov.clone(),
    })
}

impl CompositeRealization {
    /// The transfer function in `q`, for one input and one output.
    ///
    /// With `n_s`, `n_u` states, numerators `b_k` and denominators `a_k` of the halves in powers of `1/q` and of `q`,
    /// `T(q) = sum_k b_k q^(m-k) / sum_k a_k q^(m-k) + sum_k b'_k q^k / sum_k a'_k q^k`, `m` the larger degree of the
    /// first half. Each half drops the coefficients that no given Markov parameter can tell from zero, and says so:
    /// [`HalfTransfer::dropped`]. In particular a finite anticausal sequence gives a polynomial in `q`.
    ///
    /// Nothing is cancelled between the halves.
    ///
    /// # Errors
    ///
    /// More than one input or output.
    pub fn transfer_function(&self) -> Result<CompositeTransfer, EraError> {
        let (outputs, inputs) = self.markov.causal()[0].shape();
        if (outputs, inputs) != (1, 1) {
            return Err(EraError::NotScalar { outputs, inputs });
        }
        let uncertainty = self.causal.parameter_floor.max(self.anticausal.parameter_floor);
        let given = |blocks: &[DMatrix<f64>]| -> Vec<f64> {
            blocks.iter().map(|block| block[(0, 0)]).collect()
        };
        let mut reversed = vec![0.0];
        reversed.extend(given(self.markov.anticausal()));
        let causal = half(&self.causal, &given(self.markov.causal()), uncertainty)?;
        let anticausal = half(&self.anticausal, &reversed, uncertainty)?;

        let degree = causal.numerator.len().max(causal.denominator.len());
        let in_q = |coefficients: &[f64]| {
            let mut descending = coefficients.to_vec();
            descending.resize(degree, 0.0);
            Poly::from_descending(&descending)
        };
        let (causal_numerator, causal_denominator) =
            (in_q(&causal.numerator), in_q(&causal.denominator));
        let anticausal_numerator = Poly::new(anticausal.numerator.clone());
        let anticausal_denominator = Poly::new(anticausal.denominator.clone());
        let numerator = &causal_numerator * &anticausal_denominator
            + &anticausal_numerator * &causal_denominator;
        let rational = Rational::new(numerator, &causal_denominator * &anticausal_denominator)
            .map_err(|error| EraError::InvalidModel { reason: error.to_string() })?;
        Ok(CompositeTransfer { rational, causal, anticausal })
    }
}

fn half(
    realization: &Realization,
    markov: &[f64],
    uncertainty: f64,
) -> Result<HalfTransfer, EraError> {
    let system = &realization.system;
    expand(system.a(), system.b(), system.c(), markov, uncertainty)
}

#[cfg(test)]
mod tests;
