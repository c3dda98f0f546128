//! One tile of a segment: its samples scaled below one, and the lag products over them.

use doubled::{exponent, power_of_two};
use pulp::Arch;

use crate::{
    kernel::{BACK, BLOCK, CHUNK, FRONT, LagProducts, PlainSum, SLACK, TILE},
    plan::Plan,
    scan::{AllFinite, Largest, Multiply},
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
    /// Whether all samples that were read are finite; nothing else means anything otherwise.
    pub(crate) finite: bool,
    /// Number of chunks that each sum ran through, about.
    pub(crate) chunks: f64,
}

/// Buffers for tiles, one set for each thread.
#[derive(Debug)]
pub(crate) struct Bench {
    span: usize,
    raw: Vec<f64>,
    x: Vec<Vec<f64>>,
    y: Vec<Vec<f64>>,
}

impl Bench {
    pub(crate) fn new(channels: usize, span: usize) -> Self {
        Self {
            span,
            raw: vec![0.0; TILE + 2 * span],
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
            finite: true,
            chunks: length.div_ceil(CHUNK) as f64,
        };
        for (channel, (x, y)) in self.x.iter_mut().zip(&mut self.y).enumerate() {
            let raw = &mut self.raw[..window];
            source.copy(channel, from - span, raw);
            sums.finite &= arch.dispatch(AllFinite(raw));
            // Each in its own unit: where a signal grows, the samples ahead are larger.
            sums.x_exponents[channel] =
                normalised(&raw[span..span + length], &mut x[FRONT..], arch);
            x[FRONT + length..].fill(0.0);
            let (first, last) = plan.reach(channel);
            let used = span.wrapping_add_signed(first)..(span + length).wrapping_add_signed(last);
            y[..used.start].fill(0.0);
            y[used.end..].fill(0.0);
            sums.y_exponents[channel] = normalised(&raw[used.clone()], &mut y[used.start..], arch);
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

/// Copies samples times the power of two that brings the largest modulus to between one half and one; gives the exponent that undoes it.
pub(crate) fn normalised(samples: &[f64], into: &mut [f64], arch: Arch) -> Option<i32> {
    let exponent = exponent_of(samples, arch);
    let factor = power_of_two(-exponent.unwrap_or(0));
    arch.dispatch(Multiply { samples, factor, into });
    exponent
}

/// The smallest exponent with every sample below two to it in modulus; `None` if all are zero.
pub(crate) fn exponent_of(samples: &[f64], arch: Arch) -> Option<i32> {
    let largest = arch.dispatch(Largest(samples));
    (largest > 0.0).then(|| exponent(largest) + 1)
}

/// The samples times two to a power.
pub(crate) fn scaled_by(samples: &[f64], exponent: i32) -> Vec<f64> {
    let factor = power_of_two(exponent);
    samples.iter().map(|x| x * factor).collect()
}
