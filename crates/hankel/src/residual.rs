//! What a solution leaves of the target, computed from the data themselves, and the step that it asks for.
//!
//! The Gram matrix forgets what is below [`Gram::rounding`] of it; where the condition number squared is larger than its inverse,
//! a pass over the data brings the rest:
//!
//! ```text
//! r = t - X b,    b <- b + (X' X)^-1 X' r
//! ```
//!
//! with each element of r and of X' r computed in doubled precision and rounded once. A step shrinks the error by about
//! `condition^2 * rounding`, so one or two suffice (Björck, *Numerical Methods for Least Squares Problems*, SIAM 1996: corrected seminormal
//! equations).

use doubled::DoubleDouble;
use pulp::Arch;

use crate::{
    Column, HankelError, Layout, LeastSquares, Options,
    combination::{Combination, ROWS, Term},
    gaps::pieces,
    in_order::in_order,
    kernel::{BACK, FRONT, LagProducts, SLACK, TILE},
    layout::signed,
    plan::BLOCK,
    scale::{power_of_two, scaled},
    sums::times,
    tile::{exponent_of, normalise, scaled_into},
};

/// A correction relative to the solution that is rounding.
const ROUNDING: f64 = f64::EPSILON;

impl LeastSquares {
    /// Repeats the correction from the data until it is at rounding level, does not shrink any more, or `steps` are done.
    ///
    /// `layout`, `record` and `options` are those of the Gram matrix. The residual norm becomes that of the data as well, exact to the digits of
    /// a double however small it is. A step costs about as much as the Gram matrix.
    ///
    /// # Errors
    ///
    /// As [`crate::gram`]; [`HankelError::DifferentLayouts`] if the layout has another number of columns than the solution.
    ///
    /// # Example
    ///
    /// ```
    /// use hankel::{Column, Layout, Options, gram};
    ///
    /// let record: [&[f64]; 2] = [&[1.0, 2.0, 4.0, 8.5], &[1.0, 1.0, 3.0, 2.0]];
    /// let layout = Layout::new(2, vec![Column::new(1, 0), Column::new(0, 0)])?;
    /// let options = Options::default();
    /// let found = gram(&layout, &record, &options)?.least_squares(1, None)?;
    /// let refined = found.refined(&layout, &record, &options, 3)?;
    /// assert!(refined.refinement.converged);
    /// assert!((refined.coefficients[0] - 32.0 / 15.0).abs() < 1e-15);
    /// # Ok::<(), hankel::HankelError>(())
    /// ```
    pub fn refined(
        &self,
        layout: &Layout,
        record: &[&[f64]],
        options: &Options,
        steps: usize,
    ) -> Result<Self, HankelError> {
        self.refined_on(layout, &[record], options, steps)
    }

    /// The same with several segments, between which there are gaps.
    ///
    /// # Errors
    ///
    /// As [`LeastSquares::refined`].
    pub fn refined_on(
        &self,
        layout: &Layout,
        segments: &[&[&[f64]]],
        options: &Options,
        steps: usize,
    ) -> Result<Self, HankelError> {
        let size = self.coefficients.len() + 1;
        if !layout.is_symmetric() || layout.columns().len() != size {
            return Err(HankelError::DifferentLayouts);
        }
        let mut all: Vec<Vec<&[f64]>> = Vec::new();
        for segment in segments {
            for (from, to) in pieces(layout, segment, options.missing)? {
                all.push(segment.iter().map(|channel| &channel[from..to]).collect());
            }
        }
        let mut pass = Pass {
            fit: self,
            layout,
            segments: &all,
            threads: options.threads.max(1),
            residual: Residual::Rounded,
        };
        let mut best = self.clone();
        let mut state = pass.run(&best.scaled);
        // Rounding r to doubles moves the solution by its norm times the rounding unit over the smallest singular value.
        let moved = state.squares.sqrt() * self.factor.condition();
        if moved > self.factor.scaled_norm(&best.scaled) {
            pass.residual = Residual::InTwoParts;
            state = pass.run(&best.scaled);
        }
        let mut previous = f64::INFINITY;
        for _ in 0..steps {
            let correction = self.correction(&state.gradient);
            let size = self.factor.scaled_norm(&correction);
            let norm = self.factor.scaled_norm(&best.scaled);
            let relative = if size > 0.0 { size / norm } else { 0.0 };
            // A correction that does not shrink means that the condition number is beyond what refinement can mend.
            if !(relative < 0.5 * previous || relative <= ROUNDING) {
                break;
            }
            for (b, step) in best.scaled.iter_mut().zip(&correction) {
                *b += step;
            }
            best.refinement.steps += 1;
            best.refinement.last_correction = relative;
            best.refinement.converged = relative <= ROUNDING;
            // What a correction at rounding level changes in the residual is rounding too.
            if best.refinement.converged {
                break;
            }
            previous = relative;
            state = pass.run(&best.scaled);
        }
        best.describe(state.squares.sqrt())?;
        Ok(best)
    }
}

/// What one pass over the data yields, in the units of the factor's columns and of the target.
struct State {
    squares: f64,
    gradient: Vec<DoubleDouble>,
}

/// What of the residual enters the gradient.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Residual {
    /// Each element as a double.
    Rounded,
    /// What rounding loses as well.
    InTwoParts,
}

/// Everything that stays the same from pass to pass.
struct Pass<'a> {
    fit: &'a LeastSquares,
    layout: &'a Layout,
    segments: &'a [Vec<&'a [f64]>],
    threads: usize,
    residual: Residual,
}

/// A stretch of rows of a segment.
struct Job {
    segment: usize,
    row: usize,
    rows: usize,
}

/// What one stretch of rows contributes.
struct Part {
    squares: f64,
    gradient: Vec<DoubleDouble>,
}

impl Pass<'_> {
    fn run(&self, solution: &[f64]) -> State {
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
        in_order(&jobs, self.threads, work, |part| {
            squares += DoubleDouble::from(part.squares);
            for (sum, new) in gradient.iter_mut().zip(&part.gradient) {
                *sum += *new;
            }
        });
        State { squares: squares.value().max(0.0), gradient }
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
        for (channel, samples) in self.samples.iter_mut().enumerate() {
            let source = &pass.segments[job.segment][channel][job.row..job.row + window];
            self.exponents[channel] = exponent_of(source, arch);
            scaled_into(source, -self.exponents[channel].unwrap_or(0), samples, arch);
            samples[window..].fill(0.0);
        }
        let unit = self.combine(pass, solution, job, arch);
        let squares = sum_of_squares(&self.residual[..job.rows]) * power_of_two(2 * unit);
        let mut gradient = vec![DoubleDouble::ZERO; solution.len()];
        self.padded[FRONT..FRONT + job.rows].copy_from_slice(&self.residual[..job.rows]);
        self.add_gradient(pass, job, unit, arch, &mut gradient);
        if pass.residual == Residual::InTwoParts {
            self.padded[FRONT..FRONT + job.rows].copy_from_slice(&self.lost[..job.rows]);
            self.add_gradient(pass, job, unit, arch, &mut gradient);
        }
        Part { squares, gradient }
    }

    /// Adds the products of the padded residual, in units of two to `unit`, with all regressors.
    fn add_gradient(
        &mut self,
        pass: &Pass<'_>,
        job: &Job,
        unit: i32,
        arch: Arch,
        gradient: &mut [DoubleDouble],
    ) {
        self.padded[FRONT + job.rows..].fill(0.0);
        let Some(shrunk) = normalise(&mut self.padded[FRONT..FRONT + job.rows], arch) else {
            return;
        };
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
                let step = unit + shrunk + exponent - pass.fit.factor.exponent(*index);
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
            .map(|(_, _, weight, exponent)| crate::scale::exponent(weight.abs()) + 1 + exponent)
            .max()
            .unwrap_or(0);
        let terms: Vec<Term<'_>> = weighted
            .iter()
            .map(|(channel, start, weight, exponent)| Term {
                weight: scaled(*weight, exponent - largest),
                samples: &self.samples[*channel],
                start: *start,
            })
            .collect();
        let total: f64 = terms.iter().map(|term| term.weight.abs()).sum();
        let bias = power_of_two(crate::scale::exponent(total.max(1.0)) + 2);
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
