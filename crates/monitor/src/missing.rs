//! What missing samples cost a window: each is one more unknown of its residuals.
//!
//! A residual is linear in the samples, so that a window of whitened residuals is w = w_0 + G u, where w_0 comes from interpolated samples in the place of the
//! missing ones, u is how far these are off, and a column of G is the response of the whitened residual to one sample. Nothing is known of u, and what the window
//! says without it is the part of w that is orthogonal to G:
//!
//! ```text
//! w' = (I - P) w,     P the projection onto the columns of G
//! ```
//!
//! Its variance has n - rank G degrees of freedom less one for the mean, and its mean has the variance sigma^2 1'(I - P)1 / n^2. Both are brought to what they are
//! in a whole window, so that the limits hold as they are. Neither depends on how the missing samples were interpolated.

use nalgebra::{DMatrix, DVector};

use crate::{Link, MonitorError, Whitening};

/// Below this part of a sample's whole response, a window hardly sees it: an interpolated value is far better than that.
const HARDLY: f64 = 1e-4;

/// A window tells something while this part of its degrees of freedom is left, and of the variance of its mean.
const ENOUGH: f64 = 0.5;

/// A channel with numbers in all places, and the places of those that were missing.
#[derive(Debug, Clone)]
pub(crate) struct Filled {
    pub(crate) values: Vec<f64>,
    pub(crate) missing: Vec<usize>,
}

/// Straight lines between the samples that are there; held at the ends.
pub(crate) fn fill(channel: &[f64]) -> Filled {
    let (there, missing): (Vec<usize>, Vec<usize>) =
        (0..channel.len()).partition(|&k| !channel[k].is_nan());
    let mut values = channel.to_vec();
    for &hole in &missing {
        let next = there.partition_point(|&k| k < hole);
        let before = next.checked_sub(1).map(|index| there[index]);
        values[hole] = match (before, there.get(next).copied()) {
            (Some(left), Some(right)) => {
                let part = (hole - left) as f64 / (right - left) as f64;
                channel[left] + part * (channel[right] - channel[left])
            }
            (Some(edge), None) | (None, Some(edge)) => channel[edge],
            (None, None) => 0.0,
        };
    }
    Filled { values, missing }
}

/// The whitened residual's response to a sample of one channel.
#[derive(Debug, Clone)]
struct Response {
    /// Samples from the first value to the one that is changed.
    before: usize,
    values: Vec<f64>,
}

impl Response {
    /// Of a link to its input (`[1, 0]`) or its output (`[0, 1]`).
    fn of(link: &Link, whitening: &Whitening, impulse: [f64; 2]) -> Result<Self, MonitorError> {
        let orders = link.model.structure().orders;
        let reach = orders.causal() + orders.iir() + orders.anticausal() + whitening.order() + 1;
        let [input, output] = impulse.map(|height| {
            let mut values = vec![0.0; 2 * reach + 1];
            values[reach] = height;
            values
        });
        let residual = link.model.residuals(&input, &output)?;
        let before = reach - (residual.first + whitening.order());
        Ok(Self { before, values: whitening.apply(&residual.values) })
    }

    /// At a sample, where one `at` another is changed.
    fn value(&self, sample: usize, at: usize) -> f64 {
        let index = (sample + self.before).checked_sub(at);
        index.and_then(|index| self.values.get(index)).copied().unwrap_or(0.0)
    }

    fn norm(&self) -> f64 {
        self.values.iter().map(|value| value * value).sum::<f64>().sqrt()
    }
}

/// A window's numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Moments {
    /// The mean, divided so that its variance is that of a whole window's.
    pub(crate) level: f64,
    pub(crate) variance: f64,
    /// Degrees of freedom of the variance.
    pub(crate) freedom: f64,
}

/// The missing samples of a link's two channels, and what each does to the whitened residual.
#[derive(Debug, Clone)]
pub(crate) struct Missing {
    channels: Vec<(Response, Vec<usize>)>,
}

impl Missing {
    /// In a stretch of which the two channels lack these samples.
    pub(crate) fn of(
        link: &Link,
        whitening: &Whitening,
        missing: [&[usize]; 2],
    ) -> Result<Self, MonitorError> {
        let mut channels = Vec::new();
        for (impulse, samples) in [[1.0, 0.0], [0.0, 1.0]].into_iter().zip(missing) {
            if !samples.is_empty() {
                channels.push((Response::of(link, whitening, impulse)?, samples.to_vec()));
            }
        }
        Ok(Self { channels })
    }

    /// The columns of G for `window` samples from `first` on, each over the norm of its whole response; those left out that the window hardly sees.
    fn columns(&self, first: usize, window: usize) -> Vec<DVector<f64>> {
        let mut columns = Vec::new();
        for (response, samples) in &self.channels {
            let norm = response.norm();
            if norm <= 0.0 {
                continue;
            }
            for &sample in samples {
                let column =
                    DVector::from_fn(window, |k, _| response.value(first + k, sample) / norm);
                if column.norm() > HARDLY {
                    columns.push(column);
                }
            }
        }
        columns
    }

    /// What is left of a window; `None` where that is too little.
    pub(crate) fn moments(&self, values: &[f64], first: usize) -> Option<Moments> {
        let columns = self.columns(first, values.len());
        let n = values.len() as f64;
        let (mut rest, mut ones) =
            (DVector::from_column_slice(values), DVector::from_element(values.len(), 1.0));
        let mut rank = 0.0;
        if !columns.is_empty() {
            let decomposition = DMatrix::from_columns(&columns).svd(true, false);
            let basis = decomposition.u?;
            for (direction, size) in basis.column_iter().zip(&decomposition.singular_values) {
                if *size > HARDLY {
                    rest.axpy(-direction.dot(&rest), &direction, 1.0);
                    ones.axpy(-direction.dot(&ones), &direction, 1.0);
                    rank += 1.0;
                }
            }
        }
        let (left, weight) = (n - rank - 1.0, ones.norm_squared() / n);
        if left < ENOUGH * (n - 1.0) || weight < ENOUGH {
            return None;
        }
        // The least-squares mean, `1'(I - P)w / 1'(I - P)1`, and what it leaves.
        let mean = rest.sum() / (weight * n);
        rest.axpy(-mean, &ones, 1.0);
        let (level, variance) = (mean * weight.sqrt(), rest.norm_squared() / left);
        Some(Moments { level, variance, freedom: left })
    }
}

#[cfg(test)]
mod tests;
