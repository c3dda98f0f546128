//! Sums of lag products in vector registers: four instructions a product, twice the working precision.
//!
//! One lane holds one lag, and every lag runs through the samples in the same order, so that the result depends neither on the
//! width of the vectors nor on the machine. A product is added to a sum that was started from a large constant, the *bias*:
//!
//! ```text
//! next = fl(s + x y)          one fused multiply-add
//! part = s - next             exact, since s stays within a factor of two of the bias
//! rest = fl(x y + part)       what the first addition lost: at most bias 2^-53
//! low  = fl(low + rest)
//! ```
//!
//! At the end `s - bias` and `low` are the high and the low half of the sum. This is the error-free extraction of Rump, Ogita & Oishi, *Accurate
//! floating-point summation*, SIAM J. Sci. Comput. 31 (2008), with the bias as their sigma, fused with the product;
//! Dot2 of Ogita, Rump & Oishi (2005) takes nine instructions instead.
//!
//! Two multiply-adds, a subtraction and an addition are six floating-point operations a product.

use std::ops::Range;

use pulp::{Simd, WithSimd};

/// Lags are summed in blocks of this many neighbours, one to a vector lane: a multiple of every vector width.
pub(crate) const BLOCK: usize = 8;

/// Products between two emptyings of the biased sums. Fewer lose less, but empty more often.
pub(crate) const CHUNK: usize = 128;

/// Twice [`CHUNK`] products of factors below one: the biased sum stays between half and three halves of it.
const BIAS: f64 = 256.0;

/// The lags that are summed together start at most this many samples apart.
const REACH: usize = 64;

/// Samples m of a tile. With the lags of a typical batch it fills whole chunks, and its buffers fit the first cache.
pub(crate) const TILE: usize = 2048 - REACH;

/// Fewer tiles than this are not worth a thread.
pub(crate) const TILES_A_THREAD: usize = 4;

/// Zeros in front of the tile in the buffer of x.
pub(crate) const FRONT: usize = CHUNK + REACH;

/// Zeros behind the tile in the buffer of x.
pub(crate) const BACK: usize = REACH + CHUNK;

/// Samples behind the latest lag that the buffer of y must have; their values do not matter.
pub(crate) const SLACK: usize = CHUNK + 2 * BLOCK + REACH;

/// Rounding of one chunk's sum, standard deviation, for factors below one: `low` does a random walk of steps below `bias 2^-53`,
/// each rounded to 53 bits of where it has got to. A quarter of `CHUNK bias 2^-106` is twice what random signals show.
pub(crate) const CHUNK_ERROR: f64 = 0.25 * (CHUNK as f64) * BIAS * UNIT * UNIT;

/// Half the distance from one to the next double.
const UNIT: f64 = f64::EPSILON / 2.0;

/// Adds to `high + low` the sums of x(m) y(m + lag), m from 0 to `length`, for every lag of every block.
#[derive(Debug)]
pub(crate) struct LagProducts<'a> {
    /// `x[FRONT + m]` is x(m), below one in modulus; zeros around it.
    pub(crate) x: &'a [f64],
    /// `y[origin + m]` is y(m), below one in modulus.
    pub(crate) y: &'a [f64],
    pub(crate) origin: usize,
    pub(crate) length: usize,
    /// First lags of the blocks, ascending.
    pub(crate) blocks: &'a [isize],
    /// [`BLOCK`] sums for each block.
    pub(crate) high: &'a mut [f64],
    pub(crate) low: &'a mut [f64],
}

impl WithSimd for LagProducts<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        // Two registers a vector of lags, and a few for the factors: what 32 and 16 registers hold.
        let most = match S::F64_LANES {
            8 => 8,
            2 | 4 => 2,
            _ => 1,
        };
        let Some(origin) = self.blocks.first().copied() else { return };
        let mut done = 0;
        while done < self.blocks.len() {
            let first = self.blocks[done];
            let near = |lag: &&isize| lag.abs_diff(first) <= REACH;
            let count = self.blocks[done..].iter().take(most).take_while(near).count();
            let blocks = &self.blocks[done..done + count];
            let range = done * BLOCK..(done + count) * BLOCK;
            let work = Batch {
                x: self.x,
                y: &self.y[self.origin.wrapping_add_signed(origin)..],
                origin,
                blocks,
                // Whatever is summed together, chunks end at the same samples.
                chunks: first.abs_diff(origin) / CHUNK
                    ..(self.length + blocks[count - 1].abs_diff(origin)).div_ceil(CHUNK),
                high: &mut self.high[range.clone()],
                low: &mut self.low[range],
            };
            match (S::F64_LANES, count) {
                (8, 1) => work.sum::<S, 1, 1>(simd),
                (8, 2) => work.sum::<S, 2, 1>(simd),
                (8, 3) => work.sum::<S, 3, 1>(simd),
                (8, 4) => work.sum::<S, 4, 1>(simd),
                (8, 5) => work.sum::<S, 5, 1>(simd),
                (8, 6) => work.sum::<S, 6, 1>(simd),
                (8, 7) => work.sum::<S, 7, 1>(simd),
                (8, _) => work.sum::<S, 8, 1>(simd),
                (4, 1) => work.sum::<S, 1, 2>(simd),
                (4, _) => work.sum::<S, 2, 2>(simd),
                (2, 1) => work.sum::<S, 1, 4>(simd),
                (2, _) => work.sum::<S, 2, 4>(simd),
                _ => work.sum::<S, 1, 8>(simd),
            }
            done += count;
        }
    }
}

/// A few blocks that are summed together.
struct Batch<'a> {
    x: &'a [f64],
    /// From y(origin) on.
    y: &'a [f64],
    origin: isize,
    blocks: &'a [isize],
    /// Chunk c multiplies y(origin + c CHUNK + i) with x(origin + c CHUNK + i - first lag of the block).
    chunks: Range<usize>,
    high: &'a mut [f64],
    low: &'a mut [f64],
}

impl Batch<'_> {
    /// `G` blocks of `H` vectors each.
    #[expect(clippy::needless_range_loop, reason = "the indices are those of registers")]
    #[inline(always)]
    fn sum<S: Simd, const G: usize, const H: usize>(self, simd: S) {
        let high = S::as_mut_simd_f64s(self.high).0;
        let low = S::as_mut_simd_f64s(self.low).0;
        let bias = simd.splat_f64s(BIAS);
        for chunk in self.chunks {
            let from = chunk * CHUNK;
            let y: &[f64; CHUNK + BLOCK] =
                self.y[from..from + CHUNK + BLOCK].try_into().expect("the length of the range");
            let mut factors = [&[0.0; CHUNK]; G];
            for g in 0..G {
                let at = (FRONT + from).wrapping_add_signed(self.origin - self.blocks[g]);
                factors[g] = self.x[at..at + CHUNK].try_into().expect("the length of the range");
            }
            let mut sum = [[bias; H]; G];
            let mut rest = [[simd.splat_f64s(0.0); H]; G];
            for i in 0..CHUNK {
                let mut lags = [bias; H];
                for h in 0..H {
                    let at = i + h * S::F64_LANES;
                    lags[h] = S::as_simd_f64s(&y[at..at + S::F64_LANES]).0[0];
                }
                for g in 0..G {
                    let x = simd.splat_f64s(factors[g][i]);
                    for h in 0..H {
                        let next = simd.mul_add_f64s(x, lags[h], sum[g][h]);
                        let part = simd.sub_f64s(sum[g][h], next);
                        rest[g][h] = simd.add_f64s(rest[g][h], simd.mul_add_f64s(x, lags[h], part));
                        sum[g][h] = next;
                    }
                }
            }
            for g in 0..G {
                for h in 0..H {
                    let at = g * H + h;
                    let (total, error) = two_sum(simd, high[at], simd.sub_f64s(sum[g][h], bias));
                    high[at] = total;
                    low[at] = simd.add_f64s(low[at], simd.add_f64s(error, rest[g][h]));
                }
            }
        }
    }
}

/// The rounded sum and what it lost (Knuth).
#[inline(always)]
pub(crate) fn two_sum<S: Simd>(simd: S, a: S::f64s, b: S::f64s) -> (S::f64s, S::f64s) {
    let sum = simd.add_f64s(a, b);
    let back = simd.sub_f64s(sum, a);
    let error = simd.add_f64s(simd.sub_f64s(a, simd.sub_f64s(sum, back)), simd.sub_f64s(b, back));
    (sum, error)
}

/// Adds to `high + low` the plain sum of numbers below one in modulus, in [`BLOCK`] interleaved sums whatever the vector width.
#[derive(Debug)]
pub(crate) struct PlainSum<'a> {
    /// A multiple of [`BLOCK`] numbers.
    pub(crate) numbers: &'a [f64],
    pub(crate) high: &'a mut [f64; BLOCK],
    pub(crate) low: &'a mut [f64; BLOCK],
}

impl WithSimd for PlainSum<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let high = S::as_mut_simd_f64s(self.high).0;
        let low = S::as_mut_simd_f64s(self.low).0;
        for numbers in self.numbers.chunks_exact(BLOCK) {
            let numbers = S::as_simd_f64s(numbers).0;
            for ((high, low), number) in high.iter_mut().zip(low.iter_mut()).zip(numbers) {
                let (sum, error) = two_sum(simd, *high, *number);
                *high = sum;
                *low = simd.add_f64s(*low, error);
            }
        }
    }
}

#[cfg(test)]
mod tests;
