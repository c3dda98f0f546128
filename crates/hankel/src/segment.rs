//! One uninterrupted stretch of samples: tiles in its middle, and the two ends where the windows of the entries differ.
//!
//! With `rows` rows and a span of `s` samples, all windows contain m = s .. rows - 1: the *core*. An entry whose window starts at
//! `start <= s` has the products of m = start .. s - 1 and of m = rows .. rows + start - 1 on top. Everything is added and nothing
//! subtracted, so that signals that grow or decay by many decades lose nothing.

use doubled::DoubleDouble;
use pulp::{Arch, Simd, WithSimd};

use crate::{
    Layout,
    in_order::{Sharing, in_order},
    kernel::{TILE, TILES_A_THREAD},
    scan::AllFinite,
    sums::Sums,
    tile::{Bench, Source, TileSums, exponent_of, scaled_by},
};

/// A segment that further samples may still be added to. Memory: the sums, and `TILE + 4 span` samples of each channel.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Segment {
    sums: Sums,
    /// The first samples, up to twice the span.
    head: Vec<Vec<f64>>,
    /// The last samples, from `core` on.
    kept: Vec<Vec<f64>>,
    /// Members of the core that the sums contain.
    core: usize,
    /// Samples received.
    samples: usize,
}

impl Segment {
    pub(crate) fn new(layout: &Layout) -> Self {
        let channels = layout.channels();
        Self {
            sums: Sums::new(channels, layout.plan().sum_owners()),
            head: vec![Vec::new(); channels],
            kept: vec![Vec::new(); channels],
            core: 0,
            samples: 0,
        }
    }

    pub(crate) fn samples(&self) -> usize {
        self.samples
    }

    /// The first samples, up to twice the span.
    pub(crate) fn head(&self) -> &[Vec<f64>] {
        &self.head
    }

    /// The last `count` samples, at most twice the span.
    pub(crate) fn tail(&self, count: usize) -> Vec<&[f64]> {
        self.kept.iter().map(|kept| &kept[kept.len() - count.min(kept.len())..]).collect()
    }

    /// Adds samples. If that returns `false`, some are not finite, and the segment means nothing any more.
    pub(crate) fn push(
        &mut self,
        layout: &Layout,
        record: &[&[f64]],
        threads: usize,
        arch: Arch,
    ) -> bool {
        let span = layout.span();
        let new = record.first().map_or(0, |channel| channel.len());
        for (head, channel) in self.head.iter_mut().zip(record) {
            let missing = (2 * span).saturating_sub(self.samples).min(new);
            head.extend_from_slice(&channel[..missing]);
        }
        self.samples += new;
        let tiles = self.samples.saturating_sub(self.core + 2 * span) / TILE;
        let source = Source { kept: &self.kept, new: record };
        let jobs: Vec<(usize, usize)> = (0..tiles).map(|i| (span + i * TILE, TILE)).collect();
        let mut finite = add_tiles(&mut self.sums, layout, &source, &jobs, threads, arch);
        let done = tiles * TILE;
        self.core += done;
        for (kept, channel) in self.kept.iter_mut().zip(record) {
            let old = done.min(kept.len());
            kept.drain(..old);
            let rest = &channel[done - old..];
            finite &= arch.dispatch(AllFinite(rest));
            kept.extend_from_slice(rest);
        }
        finite
    }

    /// The entries and the sums of columns of this segment as it stands.
    pub(crate) fn entries(&self, layout: &Layout, arch: Arch) -> Sums {
        let (plan, span) = (layout.plan(), layout.span());
        let rows = layout.rows(self.samples);
        let mut result = Sums::new(layout.channels(), plan.entry_owners());
        if rows == 0 {
            return result;
        }
        let mut core = self.sums.clone();
        let no_more = vec![&[][..]; self.kept.len()];
        let source = Source { kept: &self.kept, new: &no_more };
        let length = rows.saturating_sub(span + self.core);
        if length > 0 {
            add_tiles(&mut core, layout, &source, &[(span, length)], 1, arch);
        }
        // The ends in the same units.
        let exponents = |ends: &[Vec<f64>]| -> Vec<Option<i32>> {
            ends.iter().map(|samples| exponent_of(samples, arch)).collect()
        };
        core.raise(&exponents(&self.head), plan.sum_owners());
        core.raise(&exponents(&self.kept), plan.sum_owners());
        let unit = |ends: &[Vec<f64>]| -> Vec<Vec<f64>> {
            ends.iter()
                .zip(&core.exponents)
                .map(|(samples, exponent)| scaled_by(samples, -exponent))
                .collect()
        };
        let ends = Ends {
            head: &unit(&self.head),
            tail: &unit(&self.kept),
            rows,
            span,
            first_kept: self.core,
        };
        result.exponents.clone_from(&core.exponents);
        result.seen.clone_from(&core.seen);
        result.variances.clone_from(&core.variances);
        arch.dispatch(Fill { ends, layout, core: &core, result: &mut result });
        result
    }
}

/// Computes tiles, in parallel if there are many, and adds them in their order; whether all samples were finite.
fn add_tiles(
    sums: &mut Sums,
    layout: &Layout,
    source: &Source<'_>,
    jobs: &[(usize, usize)],
    threads: usize,
    arch: Arch,
) -> bool {
    let plan = layout.plan();
    let work = |jobs: &[(usize, usize)]| -> Vec<TileSums> {
        let mut bench = Bench::new(layout.channels(), layout.span());
        jobs.iter().map(|(from, length)| bench.sums(plan, source, *from, *length, arch)).collect()
    };
    let mut finite = true;
    in_order(jobs, Sharing { threads, least: TILES_A_THREAD }, work, |tile| {
        finite &= tile.finite;
        sums.add_tile(&tile, plan);
    });
    finite
}

/// Everything that the entries are made of.
struct Fill<'a> {
    ends: Ends<'a>,
    layout: &'a Layout,
    core: &'a Sums,
    result: &'a mut Sums,
}

impl WithSimd for Fill<'_> {
    type Output = ();

    /// For the fused multiply-adds: a loop without vectors.
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.ends.fill(self.layout, self.core, self.result);
    }
}

/// The first and the last samples of a segment, scaled.
struct Ends<'a> {
    head: &'a [Vec<f64>],
    tail: &'a [Vec<f64>],
    /// Index in the segment of the tail's first sample.
    first_kept: usize,
    rows: usize,
    span: usize,
}

impl Ends<'_> {
    /// Sample m of a channel, which lies in the head or in the tail.
    #[inline(always)]
    fn sample(&self, channel: usize, m: usize) -> f64 {
        match self.head[channel].get(m) {
            Some(x) => *x,
            None => self.tail[channel][m - self.first_kept],
        }
    }

    /// Adds the ends to the core. Entries of one sum are neighbours with ascending starts, and share what they have in common.
    #[inline(always)]
    fn fill(&self, layout: &Layout, core: &Sums, result: &mut Sums) {
        let plan = layout.plan();
        let (span, rows) = (self.span, self.rows);
        let mut done = 0;
        for users in plan.entries.chunk_by(|a, b| a.sum == b.sum) {
            let values = &mut result.products[done..done + users.len()];
            done += users.len();
            let pair = &plan.pairs[users[0].pair];
            let lag = users[0].lag;
            let head = Products::new(self.head, (pair.x, pair.y), lag, 0);
            if rows <= span {
                // Short segments are all head.
                for (value, entry) in values.iter_mut().zip(users) {
                    let mut total = Total::default();
                    head.each(entry.start..entry.start + rows, |product| total.add(product));
                    *value = total.value();
                }
                continue;
            }
            let core = core.products[users[0].sum];
            let mut left = Total::default();
            let mut from = span;
            for (value, entry) in values.iter_mut().zip(users).rev() {
                head.each((entry.start..from).rev(), |product| left.add(product));
                from = entry.start;
                *value = core + left.value();
            }
            let from = rows - self.first_kept;
            let tail = Products::new(self.tail, (pair.x, pair.y), lag, from);
            let mut right = Total::default();
            let mut to = 0;
            for (value, entry) in values.iter_mut().zip(users) {
                tail.each(to..entry.start, |product| right.add(product));
                to = entry.start;
                *value += right.value();
            }
        }
        let columns = layout.columns().iter().chain(if layout.is_symmetric() {
            &[]
        } else {
            layout.right_columns()
        });
        for (value, column) in result.plain.iter_mut().zip(columns) {
            let start = column.lag.abs_diff(layout.earliest());
            let mut add = |m| *value += DoubleDouble::from(self.sample(column.channel, m));
            if rows <= span {
                (start..start + rows).for_each(add);
            } else {
                (start..span).for_each(&mut add);
                (rows..rows + start).for_each(&mut add);
                *value += core.plain[column.channel];
            }
        }
    }
}

/// Products of one pair of channels at one lag.
struct Products<'a> {
    x: &'a [f64],
    y: &'a [f64],
    lag: isize,
    from: usize,
}

impl<'a> Products<'a> {
    /// Product m is that of x(from + m) and y(from + m + lag).
    fn new(samples: &'a [Vec<f64>], channels: (usize, usize), lag: isize, from: usize) -> Self {
        Self { x: &samples[channels.0], y: &samples[channels.1], lag, from }
    }

    /// Hands over the products at the given m in their order.
    #[inline(always)]
    fn each(&self, range: impl Iterator<Item = usize>, mut take: impl FnMut(DoubleDouble)) {
        for m in range {
            let m = self.from + m;
            take(DoubleDouble::product(self.x[m], self.y[m.wrapping_add_signed(self.lag)]));
        }
    }
}

/// A sum that is quick to add to: what the high part loses is collected in the low one (Dot2 of Ogita, Rump & Oishi 2005).
#[derive(Debug, Clone, Copy, Default)]
struct Total {
    high: f64,
    low: f64,
}

impl Total {
    #[inline(always)]
    fn add(&mut self, product: DoubleDouble) {
        let sum = DoubleDouble::sum(self.high, product.high());
        self.high = sum.high();
        self.low += sum.low() + product.low();
    }

    #[inline(always)]
    fn value(self) -> DoubleDouble {
        DoubleDouble::sum(self.high, self.low)
    }
}
