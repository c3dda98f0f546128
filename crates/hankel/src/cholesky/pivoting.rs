//! The factorisation: column by column, the one farthest from those before it next.

use doubled::DoubleDouble;
use pulp::{Simd, WithSimd};

use super::Cholesky;

/// The loops of the factorisation, with the machine's vectors.
pub(super) struct Factorise<'a> {
    pub(super) factor: &'a mut Cholesky,
    pub(super) level: f64,
}

impl WithSimd for Factorise<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.factor.factorise(self.level);
    }
}

impl Cholesky {
    #[inline(always)]
    fn factorise(&mut self, level: f64) {
        let (size, stride) = (self.order.len(), self.stride);
        for k in 0..size {
            // Ties go to the first, so that the order is that of the columns where nothing speaks against it.
            let (mut pivot, mut largest) = (k, -1.0);
            for i in k..size {
                let sine = self.sine_squared(i);
                if sine > largest {
                    (pivot, largest) = (i, sine);
                }
            }
            if largest <= level * level {
                return;
            }
            self.swap(k, pivot);
            let diagonal = self.at(k, k).sqrt();
            for i in k + 1..size {
                let at = i + k * stride;
                let x = DoubleDouble::sum(self.high[at], self.low[at]) / diagonal;
                (self.high[at], self.low[at]) = (x.high(), x.low());
            }
            (self.high[k + k * stride], self.low[k + k * stride]) =
                (diagonal.high(), diagonal.low());
            self.found += 1;
            let (done, rest) = self.high.split_at_mut((k + 1) * stride);
            let (done_low, rest_low) = self.low.split_at_mut((k + 1) * stride);
            let (done, done_low) = (&done[k * stride..], &done_low[k * stride..]);
            let columns = rest.chunks_exact_mut(stride).zip(rest_low.chunks_exact_mut(stride));
            for (j, (high, low)) in (k + 1..).zip(columns) {
                // Whole vectors: a few values above the diagonal change too, and nobody reads them.
                let from = j - j % LANES;
                subtract_multiple(
                    (&mut high[from..], &mut low[from..]),
                    (&done[from..], &done_low[from..]),
                    (done[j], done_low[j]),
                );
            }
        }
    }

    /// Squared distance of a column from the span of those before, over its squared norm.
    #[inline(always)]
    fn sine_squared(&self, i: usize) -> f64 {
        let norm = self.norms[self.order[i]];
        if norm > 0.0 { self.high[i + i * self.stride] / (norm * norm) } else { 0.0 }
    }

    /// Exchanges two columns, and the rows with them: in the factor so far, and in the lower triangle of what is left.
    #[inline(always)]
    fn swap(&mut self, k: usize, pivot: usize) {
        if k == pivot {
            return;
        }
        let (size, stride) = (self.order.len(), self.stride);
        self.order.swap(k, pivot);
        for values in [&mut self.high, &mut self.low] {
            for column in 0..k {
                values.swap(k + column * stride, pivot + column * stride);
            }
            values.swap(k + k * stride, pivot + pivot * stride);
            for between in k + 1..pivot {
                values.swap(between + k * stride, pivot + between * stride);
            }
            for row in pivot + 1..size {
                values.swap(row + k * stride, row + pivot * stride);
            }
        }
    }
}

/// Elements that are worked on together; vectors of every width divide it.
pub(super) const LANES: usize = 8;

/// `target -= factor * source`, each in two halves.
#[inline(always)]
pub(super) fn subtract_multiple(
    target: (&mut [f64], &mut [f64]),
    source: (&[f64], &[f64]),
    factor: (f64, f64),
) {
    let step = |high: &mut f64, low: &mut f64, x: f64, x_low: f64| {
        let product = -factor.0 * x;
        let error = (-factor.0).mul_add(x, -product) - factor.0.mul_add(x_low, factor.1 * x);
        let sum = *high + product;
        let back = sum - *high;
        let rest = ((*high - (sum - back)) + (product - back)) + (*low + error);
        *high = sum + rest;
        *low = rest - (*high - sum);
    };
    let (mut high, mut low) = (target.0.chunks_exact_mut(LANES), target.1.chunks_exact_mut(LANES));
    let (x, x_low) = (source.0.chunks_exact(LANES), source.1.chunks_exact(LANES));
    let (x_rest, x_low_rest) = (x.remainder(), x_low.remainder());
    for (((high, low), x), x_low) in high.by_ref().zip(low.by_ref()).zip(x).zip(x_low) {
        for i in 0..LANES {
            step(&mut high[i], &mut low[i], x[i], x_low[i]);
        }
    }
    let rest = high.into_remainder().iter_mut().zip(low.into_remainder());
    for ((high, low), (x, x_low)) in rest.zip(x_rest.iter().zip(x_low_rest)) {
        step(high, low, *x, *x_low);
    }
}
