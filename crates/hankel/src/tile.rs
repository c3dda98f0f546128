//! One tile of a segment: its samples scaled below one, and the lag products over them.

use pulp::Arch;

use crate::{
    kernel::{BACK, CHUNK, FRONT, LagProducts, PlainSum, SLACK, TILE},
    plan::{BLOCK, Plan},
    scale::{exponent, power_of_two},
};

/// Where the samples of a tile come from: those kept from before, followed by new ones, for each channel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Source<'a> {
    pub(crate) kept: &'a [Vec<f64>],
    pub(crate) new: &'a [&'a [f64]],
}

impl Source<'_> {
    /// Copies the samples from `from` on, counted from the first one kept.
    fn copy(&self, channel: usize, from: usize, target: &mut [f64]) {
        let (kept, new) = (&self.kept[channel], self.new[channel]);
        let old = kept.len().saturating_sub(from).min(target.len());
        let (first, second) = target.split_at_mut(old);
        if old > 0 {
            first.copy_from_slice(&kept[from..from + old]);
        }
        let start = (from + old).saturating_sub(kept.len());
        second.copy_from_slice(&new[start..start + second.len()]);
    }
}

/// The lag products of one tile: the sums of a plan in units of two to the exponents of the two channels.
#[derive(Debug, Clone)]
pub(crate) struct TileSums {
    /// The unit of each channel at m; `None` where all samples are zero.
    pub(crate) x_exponents: Vec<Option<i32>>,
    /// The unit of each channel at m + lag.
    pub(crate) y_exponents: Vec<Option<i32>>,
    pub(crate) high: Vec<f64>,
    pub(crate) low: Vec<f64>,
    /// The sum of each channel's samples, in [`BLOCK`] parts.
    pub(crate) channel_high: Vec<[f64; BLOCK]>,
    pub(crate) channel_low: Vec<[f64; BLOCK]>,
    /// Number of chunks that each sum ran through, about.
    pub(crate) chunks: f64,
}

/// Buffers for tiles, one set for each thread.
#[derive(Debug)]
pub(crate) struct Bench {
    span: usize,
    x: Vec<Vec<f64>>,
    y: Vec<Vec<f64>>,
}

impl Bench {
    pub(crate) fn new(channels: usize, span: usize) -> Self {
        Self {
            span,
            x: vec![vec![0.0; FRONT + TILE + BACK]; channels],
            y: vec![vec![0.0; TILE + 2 * span + SLACK]; channels],
        }
    }

    /// The products with m in the `length` samples from `from` on, at most [`TILE`]; `span` samples before and behind them are read.
    pub(crate) fn sums(
        &mut self,
        plan: &Plan,
        source: &Source<'_>,
        from: usize,
        length: usize,
        arch: Arch,
    ) -> TileSums {
        let span = self.span;
        let window = length + 2 * span;
        let mut sums = TileSums {
            x_exponents: vec![None; self.y.len()],
            y_exponents: vec![None; self.y.len()],
            high: vec![0.0; plan.sums],
            low: vec![0.0; plan.sums],
            channel_high: vec![[0.0; BLOCK]; self.y.len()],
            channel_low: vec![[0.0; BLOCK]; self.y.len()],
            chunks: count(length.div_ceil(CHUNK)),
        };
        for (channel, (x, y)) in self.x.iter_mut().zip(&mut self.y).enumerate() {
            let (used, behind) = y.split_at_mut(window);
            source.copy(channel, from - span, used);
            x[FRONT..FRONT + length].copy_from_slice(&used[span..span + length]);
            x[FRONT + length..].fill(0.0);
            behind.fill(0.0);
            // Each in its own unit: where a signal grows, the samples ahead are larger.
            sums.x_exponents[channel] = normalise(&mut x[FRONT..FRONT + length], arch);
            let (first, last) = plan.reach(channel);
            let (before, used) = used.split_at_mut(span.wrapping_add_signed(first));
            let (used, after) = used.split_at_mut(length + last.abs_diff(first));
            before.fill(0.0);
            after.fill(0.0);
            sums.y_exponents[channel] = normalise(used, arch);
            arch.dispatch(PlainSum {
                numbers: &x[FRONT..FRONT + length.next_multiple_of(BLOCK)],
                high: &mut sums.channel_high[channel],
                low: &mut sums.channel_low[channel],
            });
        }
        for pair in &plan.pairs {
            let range = pair.offset..pair.offset + pair.blocks.len() * BLOCK;
            arch.dispatch(LagProducts {
                x: &self.x[pair.x],
                y: &self.y[pair.y],
                origin: span,
                length,
                blocks: &pair.blocks,
                high: &mut sums.high[range.clone()],
                low: &mut sums.low[range],
            });
        }
        sums
    }
}

/// Multiplies by a power of two that brings the largest modulus to between one half and one; gives the exponent that undoes it.
pub(crate) fn normalise(samples: &mut [f64], arch: Arch) -> Option<i32> {
    let exponent = exponent_of(samples, arch)?;
    let factor = power_of_two(-exponent);
    arch.dispatch(|| samples.iter_mut().for_each(|x| *x *= factor));
    Some(exponent)
}

/// The smallest exponent with every sample below two to it in modulus; `None` if all are zero.
pub(crate) fn exponent_of(samples: &[f64], arch: Arch) -> Option<i32> {
    let largest = arch.dispatch(|| {
        samples.iter().fold(0, |largest: u64, x| largest.max(x.to_bits() & !(1 << 63)))
    });
    (largest > 0).then(|| exponent(f64::from_bits(largest)) + 1)
}

/// The samples times two to a power.
pub(crate) fn scaled_by(samples: &[f64], exponent: i32) -> Vec<f64> {
    let factor = power_of_two(exponent);
    samples.iter().map(|x| x * factor).collect()
}

/// Writes the samples times two to a power to the start of the target.
pub(crate) fn scaled_into(samples: &[f64], exponent: i32, target: &mut [f64], arch: Arch) {
    let factor = power_of_two(exponent);
    arch.dispatch(|| target.iter_mut().zip(samples).for_each(|(y, x)| *y = x * factor));
}

/// A count as a number.
#[expect(clippy::cast_precision_loss, reason = "counts of samples stay far below 2^53")]
pub(crate) fn count(n: usize) -> f64 {
    n as f64
}
