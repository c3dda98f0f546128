//! Numerator and denominator of a realized half, without coefficients that the data cannot tell from zero.

use nalgebra::DMatrix;

use crate::EraError;

/// A rational function in the shift variable `x` of one half: `x = q` on the causal side, `x = 1/q` on the other.
///
/// `sum_k numerator[k] x^-k / sum_k denominator[k] x^-k`, with `denominator[0] = 1`.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct HalfTransfer {
    /// Coefficients of `x^0, x^-1, ..`; at least one.
    pub numerator: Vec<f64>,
    /// Coefficients of `x^0, x^-1, ..`; the first is 1.
    pub denominator: Vec<f64>,
    /// What was left out, and what it changed.
    pub dropped: Dropped,
}

/// Coefficients that were set to zero, since no Markov parameter can tell them from zero.
///
/// The eigenvalues of a nilpotent matrix of order `n` come out of size `eps^(1/n)`, not zero: the coefficients of its
/// characteristic polynomial are at rounding level instead of zero. On the anticausal side such a coefficient stands before
/// the highest power of `q` and would make a pole far away. On the causal side it would move a pole away from 0.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Dropped {
    /// Trailing coefficients of the denominator.
    pub denominator: usize,
    /// Leading and trailing coefficients of the numerator.
    pub numerator: usize,
    /// The largest absolute value among the dropped coefficients of the denominator, whose first coefficient is 1.
    pub largest_denominator: f64,
    /// The largest absolute value among the dropped coefficients of the numerator.
    pub largest_numerator: f64,
    /// Largest absolute difference between the Markov parameters given and those of the whole transfer function.
    pub deviation_before: f64,
    /// The same with the coefficients dropped.
    pub deviation: f64,
    /// The difference that was allowed: twice the one before, and at least the uncertainty of one parameter.
    pub allowed: f64,
}

/// Expands `h_0 + C (xI - A)^-1 B` for one input and one output.
///
/// The denominator is the characteristic polynomial of `A`; the numerator is its product with the first Markov parameters of
/// the realization. Then as many coefficients as possible are dropped from the end of the denominator and from both ends of
/// the numerator, such that no given Markov parameter `markov = [h_0, h_1, ..]` is missed by more than the allowed
/// difference.
pub(crate) fn expand(
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
    c: &DMatrix<f64>,
    markov: &[f64],
    uncertainty: f64,
) -> Result<HalfTransfer, EraError> {
    let order = a.nrows();
    let row_major: Vec<f64> = a.transpose().iter().copied().collect();
    let characteristic = poly::characteristic_polynomial(&row_major, order)
        .map_err(|error| EraError::InvalidModel { reason: error.to_string() })?;
    let mut denominator = characteristic.descending();
    denominator.resize(order + 1, 0.0);
    let realized = first_parameters(a, b, c, markov[0]);

    let mut half = Half { numerator: product(&realized, &denominator), denominator };
    let deviation_before = half.deviation(markov);
    let allowed = (2.0 * deviation_before).max(uncertainty);
    let mut dropped = Dropped {
        denominator: 0,
        numerator: 0,
        largest_denominator: 0.0,
        largest_numerator: 0.0,
        deviation_before,
        deviation: deviation_before,
        allowed,
    };

    // The errors of the coefficients are correlated: dropping one of them alone can do harm where dropping all does not.
    // So the longest tail comes first.
    for kept in 1..half.denominator.len() {
        let shorter = half.denominator[..kept].to_vec();
        let candidate = Half { numerator: product(&realized, &shorter), denominator: shorter };
        if candidate.deviation(markov) <= allowed {
            let tail = &half.denominator[kept..];
            dropped.denominator = tail.len();
            dropped.largest_denominator =
                tail.iter().fold(0.0, |largest, value| value.abs().max(largest));
            half = candidate;
            break;
        }
    }
    let count = half.numerator.len();
    half.clear_numerator((1..count).rev(), markov, &mut dropped);
    half.clear_numerator(0..count, markov, &mut dropped);
    dropped.deviation = half.deviation(markov);
    while half.numerator.len() > 1 && half.numerator.last() == Some(&0.0) {
        half.numerator.pop();
    }
    Ok(HalfTransfer { numerator: half.numerator, denominator: half.denominator, dropped })
}

/// Numerator and denominator in powers of `1/x`, while coefficients are still being dropped.
#[derive(Debug)]
struct Half {
    numerator: Vec<f64>,
    denominator: Vec<f64>,
}

impl Half {
    /// Largest absolute difference between the series of this function and the given parameters; infinite on overflow.
    fn deviation(&self, markov: &[f64]) -> f64 {
        let mut series: Vec<f64> = Vec::with_capacity(markov.len());
        let mut largest = 0.0_f64;
        for (k, given) in markov.iter().enumerate() {
            let mut value = self.numerator.get(k).copied().unwrap_or(0.0);
            for (coefficient, earlier) in self.denominator.iter().skip(1).zip(series.iter().rev()) {
                value -= coefficient * earlier;
            }
            let difference = (value - given).abs();
            if !difference.is_finite() {
                return f64::INFINITY;
            }
            largest = largest.max(difference);
            series.push(value);
        }
        largest
    }

    /// Sets coefficients of the numerator to zero in the given order, up to the first that the parameters need.
    fn clear_numerator(
        &mut self,
        indices: impl Iterator<Item = usize>,
        markov: &[f64],
        dropped: &mut Dropped,
    ) {
        for index in indices {
            let value = std::mem::replace(&mut self.numerator[index], 0.0);
            if self.deviation(markov) > dropped.allowed {
                self.numerator[index] = value;
                return;
            }
            if value != 0.0 {
                dropped.numerator += 1;
                dropped.largest_numerator = dropped.largest_numerator.max(value.abs());
            }
        }
    }
}

/// `h_0, C B, C A B, ..`, one more than there are states.
fn first_parameters(
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
    c: &DMatrix<f64>,
    feedthrough: f64,
) -> Vec<f64> {
    let mut state = b.clone();
    let mut parameters = vec![feedthrough];
    for _ in 0..a.nrows() {
        parameters.push((c * &state)[(0, 0)]);
        state = a * state;
    }
    parameters
}

/// The product of two series in `1/x`, up to the length of the first.
fn product(parameters: &[f64], denominator: &[f64]) -> Vec<f64> {
    (0..parameters.len())
        .map(|k| denominator.iter().zip(parameters[..=k].iter().rev()).map(|(a, h)| a * h).sum())
        .collect()
}

#[cfg(test)]
mod tests;
