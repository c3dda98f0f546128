//! One pass over the data: residual and gradient, tile by tile.

use doubled::{DoubleDouble, exponent, power_of_two, times_power_of_two};
use pulp::Arch;

use crate::{
    Layout, LeastSquares,
    column::{Column, signed},
    combination::{Combination, ROWS, Term},
    in_order::{Sharing, in_order},
    kernel::{BACK, BLOCK, FRONT, LagProducts, SLACK, TILE, TILES_A_THREAD},
    scan::AllFinite,
    sums::times,
    tile::normalised,
};

/// What one pass over the data yields, in the units of the factor's columns and of the target.
pub(super) struct State {
    pub(super) squares: f64,
    pub(super) gradient: Vec<DoubleDouble>,
}

/// What of the residual enters the gradient.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Residual {
    /// Each element as a double.
    Rounded,
    /// What rounding loses as well.
    InTwoParts,
}

/// Everything that stays the same from pass to pass.
pub(super) struct Pass<'a> {
    pub(super) fit: &'a LeastSquares,
    pub(super) layout: &'a Layout,
    pub(super) segments: &'a [Vec<&'a [f64]>],
    pub(super) threads: usize,
    pub(super) residual: Residual,
}

/// A stretch of rows of a segment.
struct Job {
    segment: usize,
    row: usize,
    rows: usize,
}

/// What one stretch of rows contributes.
struct Part {
    /// Not a number if a sample is none.
    squares: f64,
    gradient: Vec<DoubleDouble>,
}

impl Pass<'_> {
    pub(super) fn run(&self, solution: &[f64]) -> State {
        let mut jobs = Vec::new();
        for (segment, channels) in self.segments.iter().enumerate() {
            let rows = self.layout.rows(channels.first().map_or(0, |channel| channel.len()));
            jobs.extend((0..rows).step_by(TILE).map(|row| Job {
                segment,
                row,
                rows: TILE.min(rows - row),
            }));
        }
        let arch = Arch::new();
        let mut squares = DoubleDouble::ZERO;
        let mut gradient = vec![DoubleDouble::ZERO; solution.len()];
        let work = |jobs: &[Job]| -> Vec<Part> {
            let mut bench = Bench::new(self.layout, self.fit.target);
            jobs.iter().map(|job| bench.part(self, solution, job, arch)).collect()
        };
        let sharing = Sharing { threads: self.threads, least: TILES_A_THREAD };
        in_order(&jobs, sharing, work, |part| {
            squares += DoubleDouble::from(part.squares);
            for (sum, new) in gradient.iter_mut().zip(&part.gradient) {
                *sum += *new;
            }
        });
        State { squares: squares.value(), gradient }
    }
}

/// The lags of one channel's columns, in blocks.
struct Lags {
    channel: usize,
    blocks: Vec<isize>,
    /// Which regressor each needed lag belongs to, and where its sum is.
    users: Vec<(usize, usize)>,
}

/// Buffers for one thread.
struct Bench {
    lags: Vec<Lags>,
    samples: Vec<Vec<f64>>,
    exponents: Vec<Option<i32>>,
    residual: Vec<f64>,
    lost: Vec<f64>,
    padded: Vec<f64>,
    high: Vec<f64>,
    low: Vec<f64>,
}

impl Bench {
    fn new(layout: &Layout, target: usize) -> Self {
        let mut users: Vec<(Column, usize)> = layout.columns().iter().copied().zip(0..).collect();
        users.remove(target);
        for (column, index) in &mut users {
            column.lag -= layout.earliest();
            if *index > target {
                *index -= 1;
            }
        }
        users.sort_unstable();
        let mut lags: Vec<Lags> = Vec::new();
        for (column, index) in users {
            if lags.last().is_none_or(|lags| lags.channel != column.channel) {
                lags.push(Lags { channel: column.channel, blocks: Vec::new(), users: Vec::new() });
            }
            let Some(lags) = lags.last_mut() else { continue };
            if lags.blocks.last().is_none_or(|first| column.lag - first >= signed(BLOCK)) {
                lags.blocks.push(column.lag);
            }
            let first = lags.blocks.last().copied().unwrap_or(column.lag);
            let sum = (lags.blocks.len() - 1) * BLOCK + column.lag.abs_diff(first);
            lags.users.push((index, sum));
        }
        let most = lags.iter().map(|lags| lags.blocks.len() * BLOCK).max().unwrap_or(0);
        Self {
            lags,
            samples: vec![vec![0.0; TILE + layout.span() + SLACK + ROWS]; layout.channels()],
            exponents: vec![None; layout.channels()],
            residual: vec![0.0; TILE.next_multiple_of(ROWS)],
            lost: vec![0.0; TILE.next_multiple_of(ROWS)],
            padded: vec![0.0; FRONT + TILE + BACK],
            high: vec![0.0; most],
            low: vec![0.0; most],
        }
    }

    fn part(&mut self, pass: &Pass<'_>, solution: &[f64], job: &Job, arch: Arch) -> Part {
        let layout = pass.layout;
        let window = job.rows + layout.span();
        let mut finite = true;
        for (channel, samples) in self.samples.iter_mut().enumerate() {
            let source = &pass.segments[job.segment][channel][job.row..job.row + window];
            finite &= arch.dispatch(AllFinite(source));
            self.exponents[channel] = normalised(source, samples, arch);
            samples[window..].fill(0.0);
        }
        if !finite {
            return Part { squares: f64::NAN, gradient: vec![DoubleDouble::ZERO; solution.len()] };
        }
        let unit = self.combine(pass, solution, job, arch);
        let squares = sum_of_squares(&self.residual[..job.rows]) * power_of_two(2 * unit);
        let mut gradient = vec![DoubleDouble::ZERO; solution.len()];
        let shrunk = normalised(&self.residual[..job.rows], &mut self.padded[FRONT..], arch);
        self.add_gradient(pass, job, shrunk.map(|shrunk| unit + shrunk), arch, &mut gradient);
        if pass.residual == Residual::InTwoParts {
            let shrunk = normalised(&self.lost[..job.rows], &mut self.padded[FRONT..], arch);
            self.add_gradient(pass, job, shrunk.map(|shrunk| unit + shrunk), arch, &mut gradient);
        }
        Part { squares, gradient }
    }

    /// Adds the products of the padded residual, in units of two to `unit`, with all regressors. Without a unit it is zero.
    fn add_gradient(
        &mut self,
        pass: &Pass<'_>,
        job: &Job,
        unit: Option<i32>,
        arch: Arch,
        gradient: &mut [DoubleDouble],
    ) {
        let Some(unit) = unit else { return };
        self.padded[FRONT + job.rows..].fill(0.0);
        for lags in &self.lags {
            let Some(exponent) = self.exponents[lags.channel] else { continue };
            let count = lags.blocks.len() * BLOCK;
            let (high, low) = (&mut self.high[..count], &mut self.low[..count]);
            high.fill(0.0);
            low.fill(0.0);
            arch.dispatch(LagProducts {
                x: &self.padded,
                y: &self.samples[lags.channel],
                origin: 0,
                length: job.rows,
                blocks: &lags.blocks,
                high,
                low,
            });
            for (index, sum) in &lags.users {
                let step = unit + exponent - pass.fit.factor.exponent(*index);
                let product = DoubleDouble::sum(self.high[*sum], self.low[*sum]);
                gradient[*index] += times(product, power_of_two(step));
            }
        }
    }

    /// The residual of each row, in units of two to the number returned, times the unit of the target.
    fn combine(&mut self, pass: &Pass<'_>, solution: &[f64], job: &Job, arch: Arch) -> i32 {
        let layout = pass.layout;
        let target = pass.fit.target;
        let start = |column: &Column| column.lag.abs_diff(layout.earliest());
        // Every weight in units of the target: the coefficient times what the scaling of channel and column differ by.
        let mut others = solution.iter().enumerate();
        let mut weighted: Vec<(usize, usize, f64, i32)> = Vec::with_capacity(solution.len() + 1);
        for (index, column) in layout.columns().iter().enumerate() {
            let Some(exponent) = self.exponents[column.channel] else {
                if index != target {
                    others.next();
                }
                continue;
            };
            let (weight, unit) = if index == target {
                (1.0, pass.fit.unit)
            } else {
                let Some((i, b)) = others.next() else { continue };
                (-b, pass.fit.factor.exponent(i))
            };
            weighted.push((column.channel, start(column), weight, exponent - unit));
        }
        // A common unit in which the weights add up to less than one.
        let largest = weighted
            .iter()
            .filter(|(_, _, weight, _)| *weight != 0.0)
            .map(|(_, _, weight, step)| exponent(weight.abs()) + 1 + step)
            .max()
            .unwrap_or(0);
        let terms: Vec<Term<'_>> = weighted
            .iter()
            .map(|(channel, start, weight, exponent)| Term {
                weight: times_power_of_two(*weight, exponent - largest),
                samples: &self.samples[*channel],
                start: *start,
            })
            .collect();
        let total: f64 = terms.iter().map(|term| term.weight.abs()).sum();
        let bias = power_of_two(exponent(total.max(1.0)) + 2);
        let rows = job.rows.next_multiple_of(ROWS);
        arch.dispatch(Combination {
            terms: &terms,
            bias,
            rows: &mut self.residual[..rows],
            lost: &mut self.lost[..rows],
        });
        largest
    }
}

/// In eight interleaved sums.
fn sum_of_squares(values: &[f64]) -> f64 {
    let mut sums = [0.0; BLOCK];
    let chunks = values.chunks_exact(BLOCK);
    let rest: f64 = chunks.remainder().iter().map(|x| x * x).sum();
    for chunk in chunks {
        for (sum, x) in sums.iter_mut().zip(chunk) {
            *sum += x * x;
        }
    }
    sums.iter().sum::<f64>() + rest
}
