//! Simple loops over samples with the machine's vectors: largest modulus, finiteness, scaling.
//!
//! They are structs and not closures because a vectorised function does not reach into a closure that the compiler chose not to inline.

use pulp::{Simd, WithSimd};

/// The largest modulus; 0 without samples. All samples are finite.
#[derive(Debug)]
pub(crate) struct Largest<'a>(pub(crate) &'a [f64]);

impl WithSimd for Largest<'_> {
    type Output = f64;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> f64 {
        let (vectors, rest) = S::as_simd_f64s(self.0);
        let mut largest = [simd.splat_f64s(0.0); 4];
        let quads = vectors.chunks_exact(4);
        for vector in quads.remainder() {
            largest[0] = simd.max_f64s(largest[0], simd.abs_f64s(*vector));
        }
        for quad in quads {
            for (largest, vector) in largest.iter_mut().zip(quad) {
                *largest = simd.max_f64s(*largest, simd.abs_f64s(*vector));
            }
        }
        let pairs = [0, 2].map(|i| simd.max_f64s(largest[i], largest[i + 1]));
        let largest = simd.reduce_max_f64s(simd.max_f64s(pairs[0], pairs[1]));
        rest.iter().fold(largest, |largest, x| largest.max(x.abs()))
    }
}

/// Whether all samples are finite.
#[derive(Debug)]
pub(crate) struct AllFinite<'a>(pub(crate) &'a [f64]);

impl WithSimd for AllFinite<'_> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        // Zero times a finite number is zero, and times anything else NaN, which stays.
        let zero = simd.splat_f64s(0.0);
        let (vectors, rest) = S::as_simd_f64s(self.0);
        let mut sums = [zero; 4];
        let quads = vectors.chunks_exact(4);
        for vector in quads.remainder() {
            sums[0] = simd.mul_add_e_f64s(zero, *vector, sums[0]);
        }
        for quad in quads {
            for (sum, vector) in sums.iter_mut().zip(quad) {
                *sum = simd.mul_add_e_f64s(zero, *vector, *sum);
            }
        }
        let sum = simd.add_f64s(simd.add_f64s(sums[0], sums[1]), simd.add_f64s(sums[2], sums[3]));
        !simd.reduce_sum_f64s(sum).is_nan() && rest.iter().all(|x| x.is_finite())
    }
}

/// Multiplies samples by a factor into the start of a longer slice.
#[derive(Debug)]
pub(crate) struct Multiply<'a> {
    pub(crate) samples: &'a [f64],
    pub(crate) factor: f64,
    pub(crate) into: &'a mut [f64],
}

impl WithSimd for Multiply<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let into = &mut self.into[..self.samples.len()];
        let (vectors, rest) = S::as_simd_f64s(self.samples);
        let (into, into_rest) = S::as_mut_simd_f64s(into);
        let factor = simd.splat_f64s(self.factor);
        for (into, vector) in into.iter_mut().zip(vectors) {
            *into = simd.mul_f64s(*vector, factor);
        }
        for (into, sample) in into_rest.iter_mut().zip(rest) {
            *into = sample * self.factor;
        }
    }
}

#[cfg(test)]
mod tests;
