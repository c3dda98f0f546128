//! Combinations of shifted signals, row by row, in twice the working precision: the other half of a pass over the data.
//!
//! One lane holds one row. Products are added to a biased sum as in [`crate::kernel`], at four instructions each.

use pulp::{Simd, WithSimd};

use crate::kernel::{BLOCK, two_sum};

/// Vectors of rows that are worked on together: enough independent sums to hide the latency of one.
const UNROLL: usize = 8;

/// Rows that one round of the loop yields: a multiple of this many are computed.
pub(crate) const ROWS: usize = UNROLL * BLOCK;

/// One term of a combination: `weight * samples[row + start]`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Term<'a> {
    pub(crate) weight: f64,
    /// Below one in modulus, [`ROWS`] more than there are rows.
    pub(crate) samples: &'a [f64],
    pub(crate) start: usize,
}

/// Writes the sums of the terms for each row: rounded, and what the rounding lost.
#[derive(Debug)]
pub(crate) struct Combination<'a> {
    pub(crate) terms: &'a [Term<'a>],
    /// A power of two, at least twice the sum of the weights' moduli.
    pub(crate) bias: f64,
    /// A multiple of [`ROWS`] rows.
    pub(crate) rows: &'a mut [f64],
    /// As many.
    pub(crate) lost: &'a mut [f64],
}

impl WithSimd for Combination<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let width = UNROLL * S::F64_LANES;
        let bias = simd.splat_f64s(self.bias);
        let rounds = self.rows.chunks_exact_mut(width).zip(self.lost.chunks_exact_mut(width));
        for (round, (rows, lost)) in rounds.enumerate() {
            let rows = S::as_mut_simd_f64s(rows).0;
            let lost = S::as_mut_simd_f64s(lost).0;
            let mut sum = [bias; UNROLL];
            let mut low = [simd.splat_f64s(0.0); UNROLL];
            for term in self.terms {
                let weight = simd.splat_f64s(term.weight);
                let from = round * width + term.start;
                let samples = S::as_simd_f64s(&term.samples[from..from + width]).0;
                let samples: &[S::f64s; UNROLL] =
                    samples.try_into().expect("the length of the range");
                for i in 0..UNROLL {
                    let next = simd.mul_add_f64s(weight, samples[i], sum[i]);
                    let part = simd.sub_f64s(sum[i], next);
                    low[i] = simd.add_f64s(low[i], simd.mul_add_f64s(weight, samples[i], part));
                    sum[i] = next;
                }
            }
            for i in 0..UNROLL {
                (rows[i], lost[i]) = two_sum(simd, simd.sub_f64s(sum[i], bias), low[i]);
            }
        }
    }
}

#[cfg(test)]
mod tests;
