//! From a causal sequence of Markov parameters to a state-space model.

use lti::{Discrete, SamplePeriod, StateSpace};
use nalgebra::DMatrix;

use crate::balanced::{Balanced, balance, magnitude};
use crate::order::{Floor, FloorOrigin};
use crate::{EraError, EraOptions, OrderReason};

/// A state-space model of a sequence of Markov parameters, with what is known about its accuracy.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Realization {
    /// The model: `H_0 = D`, `H_k = C A^(k-1) B`. Balanced: its reachability and observability matrices, as long as the
    /// Hankel matrix, have the same Gramian `diag(sigma)`.
    pub system: StateSpace<Discrete>,
    /// All singular values of the Hankel matrix, largest first, in units of the Markov parameters.
    pub singular_values: Vec<f64>,
    /// Number of states.
    pub order: usize,
    /// Why that many.
    pub reason: OrderReason,
    /// The level that a singular value must exceed to be realized.
    pub floor: Floor,
    /// The uncertainty of one entry of a Markov parameter that corresponds to the floor.
    pub parameter_floor: f64,
    /// Norm of the difference between the model's and the given `H_1, H_2, ..`, relative to the norm of the latter; zero
    /// for an all-zero sequence, infinite where the model overflows.
    pub residual: f64,
    /// Largest over smallest realized singular value: errors of the data grow by up to this factor in `A`. One at order 0.
    pub condition: f64,
}

/// Realizes Markov parameters of a causal system.
///
/// `H_0 = D` and `H_k = C A^(k-1) B` for `k = 1, 2, ..`. With the singular value decomposition `H = U S V'` of the
/// block-Hankel matrix `H[i, j] = H_(i+j+1)` and its shift `H'[i, j] = H_(i+j+2)`,
/// `A = S^-1/2 U' H' V S^-1/2`, `B` is the first block column of `S^1/2 V'`, and `C` the first block row of `U S^1/2`.
///
/// | symbol | argument | shape |
/// |---|---|---|
/// | `H_0, H_1, ..` | `markov` | outputs by inputs each, at least three of them |
/// | `T` | `period` | seconds |
///
/// Nothing is realized below rounding level: see [`Realization::floor`]. The sequence is scaled by a power of two first, so
/// that neither tiny nor huge numbers are lost. The sequence is taken to go on beyond its end; where it is known to be zero
/// there, append zeros until there are more than twice as many
/// parameters as states.
///
/// Source: J.-N. Juang and R. S. Pappa, "An eigensystem realization algorithm for modal parameter identification and model
/// reduction", Journal of Guidance, Control, and Dynamics 8 (1985) 620-627. The paper uses it in part V.C.
///
/// # Errors
///
/// Fewer parameters than the Hankel matrix needs, shapes that differ, values that are not finite, options out of range.
///
/// # Example
///
/// `1, 1/2, 1/4, ..` is the response of `x(k+1) = x(k)/2 + u(k)`, `y = x`.
///
/// ```
/// use era::{EraOptions, realize};
/// use lti::SamplePeriod;
/// use nalgebra::DMatrix;
///
/// let markov: Vec<_> = [0.0, 1.0, 0.5, 0.25, 0.125].iter().map(|&h| DMatrix::from_element(1, 1, h)).collect();
/// let realization = realize(&markov, SamplePeriod::new(0.1)?, &EraOptions::default())?;
/// assert_eq!(realization.order, 1);
/// assert!((realization.system.a()[(0, 0)] - 0.5).abs() < 1e-14);
/// assert!(realization.residual < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn realize(
    markov: &[DMatrix<f64>],
    period: SamplePeriod,
    options: &EraOptions,
) -> Result<Realization, EraError> {
    let (feedthrough, tail) = markov.split_first().ok_or(EraError::NoFeedthrough)?;
    check_blocks(feedthrough.shape(), (0..).zip(markov))?;
    if tail.is_empty() {
        return Err(EraError::TooFewMarkovParameters { found: 0, needed: 2 });
    }
    realize_tail(feedthrough, tail, magnitude(markov), period, options)
}

/// [`realize`] for one input and one output: `markov = [h_0, h_1, ..]`.
///
/// # Errors
///
/// As [`realize`].
///
/// # Example
///
/// ```
/// use era::{EraOptions, Order, realize_siso};
/// use lti::SamplePeriod;
///
/// // The Fibonacci numbers obey a recursion of order two, so that there is nothing to realize beyond that.
/// let fibonacci = [0.0, 1.0, 1.0, 2.0, 3.0, 5.0, 8.0, 13.0, 21.0];
/// let realization = realize_siso(&fibonacci, SamplePeriod::new(1.0)?, &EraOptions::with_order(Order::Fixed(4)))?;
/// assert_eq!(realization.order, 2);
/// assert!((realization.system.a().trace() - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn realize_siso(
    markov: &[f64],
    period: SamplePeriod,
    options: &EraOptions,
) -> Result<Realization, EraError> {
    realize(&scalars(markov), period, options)
}

/// One-by-one matrices.
pub(crate) fn scalars(values: &[f64]) -> Vec<DMatrix<f64>> {
    values.iter().map(|&value| DMatrix::from_element(1, 1, value)).collect()
}

/// Checks that all blocks are finite and of the expected shape.
pub(crate) fn check_blocks<'a>(
    expected: (usize, usize),
    blocks: impl Iterator<Item = (isize, &'a DMatrix<f64>)>,
) -> Result<(), EraError> {
    let (expected_rows, expected_columns) = expected;
    if expected_rows == 0 || expected_columns == 0 {
        return Err(EraError::NoChannels { rows: expected_rows, columns: expected_columns });
    }
    for (index, block) in blocks {
        let (rows, columns) = block.shape();
        if (rows, columns) != expected {
            return Err(EraError::ShapeMismatch {
                index,
                rows,
                columns,
                expected_rows,
                expected_columns,
            });
        }
        if !block.iter().all(|value| value.is_finite()) {
            return Err(EraError::NotFinite { index });
        }
    }
    Ok(())
}

/// Realizes checked parameters; an empty tail is a static gain.
pub(crate) fn realize_tail(
    feedthrough: &DMatrix<f64>,
    tail: &[DMatrix<f64>],
    shared_magnitude: f64,
    period: SamplePeriod,
    options: &EraOptions,
) -> Result<Realization, EraError> {
    options.check()?;
    let (outputs, inputs) = feedthrough.shape();
    let balanced = if tail.is_empty() {
        static_gain(outputs, inputs, options.noise_floor.unwrap_or(0.0))
    } else {
        balance(tail, (outputs, inputs), shared_magnitude, options)?
    };
    let Balanced { a, b, c, .. } = balanced;
    let system = StateSpace::<Discrete>::new(a, b, c, feedthrough.clone(), period)
        .map_err(|error| EraError::InvalidModel { reason: error.to_string() })?;
    Ok(Realization {
        system,
        singular_values: balanced.singular_values,
        order: balanced.order,
        reason: balanced.reason,
        floor: balanced.floor,
        parameter_floor: balanced.parameter_floor,
        residual: balanced.residual,
        condition: balanced.condition,
    })
}

fn static_gain(outputs: usize, inputs: usize, noise: f64) -> Balanced {
    let origin = if noise > 0.0 { FloorOrigin::Noise } else { FloorOrigin::Rounding };
    Balanced {
        a: DMatrix::zeros(0, 0),
        b: DMatrix::zeros(0, inputs),
        c: DMatrix::zeros(outputs, 0),
        singular_values: Vec::new(),
        floor: Floor { value: noise, origin },
        order: 0,
        reason: OrderReason::NoParameters,
        condition: 1.0,
        residual: 0.0,
        parameter_floor: noise,
    }
}

#[cfg(test)]
mod tests;
