//! Group 4: how far the Gram kernel is from what the processor can do.

use std::collections::BTreeSet;

use hankel::{Column, Layout};

use super::ours::{self, PAPER};
use super::peak::fma_peak;
use super::records::{self, Surface};
use super::timing::{Runs, measure as time, show_seconds};
use super::{Bench, Group};
use crate::TaskError;
use crate::shared::asked::{Asked, Row, asked_and_reached};

const SAMPLES: usize = 1_000_000;

/// Floating-point operations of one compensated product: two fused multiply-adds, a subtraction and
/// an addition.
const FLOPS_PER_PRODUCT: f64 = 6.0;

/// Neighbouring lags that the kernel sums together.
const BLOCK: usize = 8;

pub(crate) fn measure(bench: &Bench) -> Result<Group, TaskError> {
    bench.say("limit: peak");
    let peak = fma_peak()?;
    bench.say("limit: Gram matrices");
    let channels = records::record(Surface::Aileron, SAMPLES)?;
    let record = [channels[0].as_slice(), &channels[1], &channels[2]];
    let cases = [
        ("composite fit, 54 regressors and target", ours::cfi_layout(PAPER)?, 2),
        ("block-Hankel, 3 channels, 20 block rows", ours::block_hankel(3, 20)?, 3),
    ];
    let mut rows = Vec::new();
    let mut counts = Vec::new();
    for (what, layout, channels) in cases {
        let timing = time(Runs::MANY, || ours::gram(&layout, &record[..channels], 1))?;
        let work = lag_products(&layout);
        let rate = |products: usize| {
            FLOPS_PER_PRODUCT * products as f64 * SAMPLES as f64 / timing.median()
        };
        let show = |fraction: f64| format!("{:.0} %", 100.0 * fraction);
        rows.push(Row::new(
            format!("{what}: part of the peak"),
            Asked::AtLeast(0.5),
            rate(work.wanted) / peak.flops,
            show,
        ));
        counts.push(format!(
            "The {what} has {} different lag products a sample, {} with the lanes that pad blocks of {BLOCK} lags: {:.1} Gflop/s in {}, {:.1} with the padding ({} of the peak).",
            work.wanted,
            work.padded,
            rate(work.wanted) / 1e9,
            show_seconds(timing.median()),
            rate(work.padded) / 1e9,
            show(rate(work.padded) / peak.flops),
        ));
    }
    Ok(Group {
        title: "How far from the limit",
        introduction: format!(
            "The peak of one core, the fastest of several loops in this run, with {} and {} doubles a register: {:.1} Gflop/s of fused multiply-adds, which count as two. A compensated product is \
             6 flops: two fused multiply-adds, a subtraction and an addition. Where additions run on the units of the multiply-adds, a kernel of nothing but such \
             products comes to three quarters of the peak. The time is that of the whole call, with checks and scaling.",
            peak.instruction_set,
            peak.lanes,
            peak.flops / 1e9
        ),
        blocks: vec![
            asked_and_reached("Part of the multiply-add peak: asked and reached", &rows)?,
            report::Block::bullets(counts),
        ],
    })
}

/// Products that a layout takes for each sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Work {
    /// Different ones.
    wanted: usize,
    /// With the lags that fill up blocks.
    padded: usize,
}

/// Counts the pairs of channels and the lags between their columns, each once, whichever comes
/// first.
fn lag_products(layout: &Layout) -> Work {
    let columns = layout.columns();
    let mut lags: BTreeSet<(usize, usize, isize)> = BTreeSet::new();
    for (index, a) in columns.iter().enumerate() {
        lags.extend(columns[index..].iter().map(|b| between(a, b)));
    }
    let mut padded = 0;
    let mut covered: Option<(usize, usize, isize)> = None;
    for (x, y, lag) in &lags {
        let inside = covered.is_some_and(|(u, v, end)| (u, v) == (*x, *y) && *lag < end);
        if !inside {
            padded += BLOCK;
            covered = Some((*x, *y, lag.saturating_add_unsigned(BLOCK)));
        }
    }
    Work { wanted: lags.len(), padded }
}

/// The lag of the second column behind the first, lower channel first.
fn between(a: &Column, b: &Column) -> (usize, usize, isize) {
    let (a, b) = if (a.channel, a.lag) <= (b.channel, b.lag) { (a, b) } else { (b, a) };
    (a.channel, b.channel, b.lag - a.lag)
}

#[cfg(test)]
mod tests;
