//! Triangular systems with the factor, and the inverse that covariances are made of.

use doubled::DoubleDouble;
use nalgebra::DMatrix;
use pulp::{Arch, Simd, WithSimd};

use super::{Cholesky, pivoting::subtract_multiple};

impl Cholesky {
    /// z with L z = b for the columns above rounding, b in pivot order and scaled.
    pub(crate) fn forward(&self, b: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut high: Vec<f64> = b[..self.found].iter().map(|b| b.high()).collect();
        let mut low: Vec<f64> = b[..self.found].iter().map(|b| b.low()).collect();
        Arch::new().dispatch(Forward { factor: self, high: &mut high, low: &mut low });
        high.iter().zip(&low).map(|(high, low)| DoubleDouble::sum(*high, *low)).collect()
    }

    /// y with L' y = z for the independent columns, in pivot order.
    pub(crate) fn backward(&self, z: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut y = z[..self.rank].to_vec();
        Arch::new().dispatch(Backward { factor: self, y: &mut y });
        y
    }

    /// `(D X' X D)^+`, D scaling each column of X to norm one: p x p, in the order of the layout.
    ///
    /// Times the variance of the target's errors, and with D on both sides, it is the covariance of the coefficients of smallest norm.
    #[must_use]
    pub fn inverse(&self) -> DMatrix<f64> {
        let (size, rank) = (self.size(), self.rank);
        let mut half = DMatrix::zeros(rank, size);
        Arch::new().dispatch(Inverse { factor: self, half: &mut half });
        let mut inverse = half.tr_mul(&half);
        if rank < size {
            let null = self.null_directions();
            let rest = DMatrix::identity(size, size) - &null * null.transpose();
            inverse = &rest * inverse * &rest;
        }
        inverse
    }
}

/// Forward substitution in place.
struct Forward<'a> {
    factor: &'a Cholesky,
    high: &'a mut [f64],
    low: &'a mut [f64],
}

impl WithSimd for Forward<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { factor, high, low } = self;
        let Cholesky { found, stride, .. } = factor;
        for k in 0..*found {
            let pivot = DoubleDouble::sum(high[k], low[k]) / factor.at(k, k);
            (high[k], low[k]) = (pivot.high(), pivot.low());
            let range = k + 1 + k * stride..found + k * stride;
            subtract_multiple(
                (&mut high[k + 1..], &mut low[k + 1..]),
                (&factor.high[range.clone()], &factor.low[range]),
                (pivot.high(), pivot.low()),
            );
        }
    }
}

/// Backward substitution in place.
struct Backward<'a> {
    factor: &'a Cholesky,
    y: &'a mut [DoubleDouble],
}

impl WithSimd for Backward<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { factor, y } = self;
        for k in (0..factor.rank).rev() {
            let mut value = y[k];
            for (i, later) in y.iter().enumerate().skip(k + 1) {
                value -= factor.at(i, k) * *later;
            }
            y[k] = value / factor.at(k, k);
        }
    }
}

/// Columns of the inverse of the factor, each scaled by the norm of its column.
struct Inverse<'a> {
    factor: &'a Cholesky,
    half: &'a mut DMatrix<f64>,
}

impl WithSimd for Inverse<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Cholesky { high, order, norms, stride, rank, .. } = self.factor;
        for k in 0..*rank {
            let mut column = self.half.column_mut(order[k]);
            let unit = &mut column.as_mut_slice()[k..];
            unit[0] = norms[order[k]];
            for i in k..*rank {
                let (done, rest) = unit.split_at_mut(i - k + 1);
                let pivot = done[i - k] / high[i + i * stride];
                done[i - k] = pivot;
                let below = &high[i + 1 + i * stride..rank + i * stride];
                rest.iter_mut().zip(below).for_each(|(x, l)| *x -= pivot * l);
            }
        }
    }
}
