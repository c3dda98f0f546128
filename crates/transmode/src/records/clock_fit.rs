//! Time stamps that are coarse, late or drifting -> the period behind them.
//!
//! A logger samples evenly and writes stamps that are rounded, that several rows share, or that the
//! operating system delayed. The rows are counted first: each stamp is compared with where the row
//! before says that it should be, and a row that is whole periods late follows a gap. The period is
//! then the slope of the least-squares line through the stamps over their counts.
//!
//! That the rows are even is an assumption, and the deviations say how far the stamps bear it out:
//! they must stay within the rounding of the stamps, and within half a period beyond that.

use crate::numbers::{shortest_within, without_rounding};

/// Fewer stamps than this say too little of a period that cannot be read off their steps.
const FEWEST: usize = 8;

/// Stamps may deviate by this part of a period from even rows: beyond it rows can no longer be counted ..
const LARGEST_DEVIATION: f64 = 0.5;

/// .. and by this part of it in the root mean square. At a tenth of the sampling frequency a fifth
/// of a period moves a sample by an eighth of the amplitude.
const LARGEST_RMS: f64 = 0.2;

/// A clock may run so much faster or slower for a while, as crystals do in the cold, if its
/// stamps are otherwise close.
const LARGEST_DRIFT: f64 = 1e-3;

/// Stamps of a drifting clock are this close, in periods, to where the rows before say.
const CLOSE: f64 = 0.1;

/// What follows a gap is this close, in periods, to a whole number of them, beyond what stamps scatter.
const LARGEST_OFFSET: f64 = 0.1;

/// A step beyond this many times the usual one is a gap where several rows share a stamp.
const SHARED_GAP: f64 = 2.5;

/// Rows can share stamps only where the period is shorter than this part of the stamps' resolution.
const SHARED_PERIOD: f64 = 0.97;

/// How fast the expected place of a stamp follows the stamps.
const GAIN: f64 = 0.1;

/// Stamps deviate by half of what they are rounded to, and a line through few of them by a little more.
const WITHIN_ROUNDING: f64 = 0.55;

/// Deviations below this part of a period are those of numbers, not of stamps.
const EXACT: f64 = 1e-6;

/// So many periods in a step of the resolution, and rounding makes steps of one and two.
const COARSE: f64 = 4.0;

/// Gaps before this part of all rows are too many to be gaps, if there is another explanation.
const MANY_GAPS: f64 = 0.1;

/// How often rows are counted with a better period.
const ROUNDS: usize = 3;

/// The most decimals that stamps are tried for.
const MOST_DECIMALS: i32 = 9;

/// What the stamps were taken for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Assumed {
    /// Even rows, their stamps rounded to a decimal place in seconds.
    Rounded { resolution_s: f64 },
    /// Even rows, their stamps late or early.
    Scattered,
}

/// A period with what speaks for it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ClockFit {
    pub(crate) period_s: f64,
    /// The largest distance of a stamp from the line, in seconds.
    pub(crate) largest_deviation_s: f64,
    pub(crate) assumed: Assumed,
    /// Indices of the samples that follow a gap. Ascending.
    pub(crate) after_gaps: Vec<usize>,
}

/// Fits a period to stamps in seconds that are finite; `None` where they are not those of even rows.
pub(crate) fn fit(time_s: &[f64]) -> Option<ClockFit> {
    if time_s.len() < FEWEST || time_s.windows(2).any(|pair| pair[1] < pair[0]) {
        return None;
    }
    let resolution_s = resolution(time_s);
    if let Some(fit) = resolution_s.and_then(|resolution_s| without_gaps(time_s, resolution_s)) {
        return Some(fit);
    }
    let shared = time_s.windows(2).any(|pair| pair[1] <= pair[0]);
    let rows = if shared { shared_rows(time_s, resolution_s?)? } else { counted_rows(time_s)? };
    let line = Line::through(time_s, &rows)?;
    let (largest, rms) = line.deviations(time_s, &rows);
    let rounding_s = resolution_s.unwrap_or(0.0);
    let period_s = line.period_s;
    let by_rounding = largest <= WITHIN_ROUNDING * rounding_s + 1e-9 * period_s
        || (shared && largest <= rounding_s.max(2.0 * period_s));
    let scattered = largest <= LARGEST_DEVIATION * period_s && rms <= LARGEST_RMS * period_s;
    let wanders = || {
        let span_s = time_s[time_s.len() - 1] - time_s[0];
        largest <= LARGEST_DRIFT * span_s && rows.largest_surprise <= CLOSE + rounding_s / period_s
    };
    if !(by_rounding || scattered || (!shared && wanders())) {
        return None;
    }
    if shared && period_s > SHARED_PERIOD * rounding_s {
        return None;
    }
    let assumed = match resolution_s {
        Some(resolution_s) if by_rounding => Assumed::Rounded { resolution_s },
        _ => Assumed::Scattered,
    };
    Some(ClockFit {
        period_s: line.plain_period(rms),
        largest_deviation_s: largest,
        assumed,
        after_gaps: rows.after_gaps,
    })
}

/// The fit in which no row is missing, where rounding explains all: stamps that are hardly finer than
/// the period take steps that look like gaps.
pub(crate) fn without_gaps_if_many(time_s: &[f64], after_gaps: usize) -> Option<ClockFit> {
    let is_many = after_gaps as f64 >= MANY_GAPS * time_s.len() as f64;
    (is_many && time_s.len() >= FEWEST).then(|| without_gaps(time_s, resolution(time_s)?)).flatten()
}

fn without_gaps(time_s: &[f64], resolution_s: f64) -> Option<ClockFit> {
    let numbers = (0..time_s.len()).map(|row| row as f64).collect();
    let rows = Rows { numbers, after_gaps: Vec::new(), largest_surprise: 0.0 };
    let line = Line::through(time_s, &rows)?;
    let (largest, rms) = line.deviations(time_s, &rows);
    let is_coarse = line.period_s <= COARSE * resolution_s;
    let is_explained = largest <= WITHIN_ROUNDING * resolution_s;
    // Where each row has a step of its own that is the resolution, rounding explains no repetition.
    let is_own = (line.period_s / resolution_s - 1.0).abs() <= 1.0 - SHARED_PERIOD;
    (is_coarse && is_explained && !is_own).then(|| ClockFit {
        period_s: line.plain_period(rms),
        largest_deviation_s: largest,
        assumed: Assumed::Rounded { resolution_s },
        after_gaps: Vec::new(),
    })
}

/// The same for stamps that advance in equal steps but for gaps, which are known: nothing is refused.
/// `None` with too few of them.
pub(crate) fn of_even(time_s: &[f64], usual_s: f64, after_gaps: &[usize]) -> Option<ClockFit> {
    if time_s.len() < FEWEST {
        return None;
    }
    let steps = time_s.windows(2).map(|pair| ((pair[1] - pair[0]) / usual_s).round().max(1.0));
    let mut numbers = vec![0.0];
    numbers.extend(steps.scan(0.0, |row, step| {
        *row += step;
        Some(*row)
    }));
    let rows = Rows { numbers, after_gaps: after_gaps.to_vec(), largest_surprise: 0.0 };
    let line = Line::through(time_s, &rows)?;
    let (largest, rms) = line.deviations(time_s, &rows);
    let resolution_s = resolution(time_s)
        .filter(|step| largest > EXACT * usual_s && largest <= WITHIN_ROUNDING * step);
    Some(ClockFit {
        period_s: line.plain_period(rms),
        largest_deviation_s: largest,
        assumed: resolution_s
            .map_or(Assumed::Scattered, |resolution_s| Assumed::Rounded { resolution_s }),
        after_gaps: rows.after_gaps,
    })
}

/// The coarsest decimal place that all stamps are whole multiples of.
fn resolution(time_s: &[f64]) -> Option<f64> {
    let largest = time_s.iter().fold(0.0_f64, |largest, time| largest.max(time.abs()));
    (0..=MOST_DECIMALS).map(|decimals| 10_f64.powi(decimals)).find_map(|scale| {
        let rounding = (4.0 * f64::EPSILON * largest * scale).max(1e-6);
        let whole = |time: &f64| (time * scale - (time * scale).round()).abs() <= rounding;
        (rounding < 0.1 && time_s.iter().all(whole)).then_some(1.0 / scale)
    })
}

/// Rows with their numbers.
struct Rows {
    /// Periods from the first row on, those of gaps included.
    numbers: Vec<f64>,
    after_gaps: Vec<usize>,
    /// How far a stamp was from where the rows before say, in periods, gaps apart.
    largest_surprise: f64,
}

/// Counts rows whose stamps all differ.
fn counted_rows(time_s: &[f64]) -> Option<Rows> {
    let mut steps: Vec<f64> = time_s.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let middle = steps.len() / 2;
    let median = *steps.select_nth_unstable_by(middle, f64::total_cmp).1;
    let usual = || steps.iter().filter(|step| (0.5..1.5).contains(&(**step / median)));
    let mut period_s = usual().sum::<f64>() / usual().count().max(1) as f64;
    let mut rows = None;
    for _ in 0..ROUNDS {
        let counted = count(time_s, period_s)?;
        period_s = Line::through(time_s, &counted)?.period_s;
        rows = Some(counted);
    }
    rows
}

/// Counts rows by where each stamp is expected; `None` where one comes a period early.
fn count(time_s: &[f64], period_s: f64) -> Option<Rows> {
    let (first, rest) = time_s.split_first()?;
    let (mut expected, mut number) = (*first, 0.0);
    let mut rows = Rows { numbers: vec![0.0], after_gaps: Vec::new(), largest_surprise: 0.0 };
    let (mut squares, mut off_at_gaps) = (0.0, 0.0_f64);
    for (index, time) in rest.iter().enumerate() {
        expected += period_s;
        let late = (time - expected) / period_s;
        let missing = late.round();
        if !late.is_finite() || missing < 0.0 {
            return None;
        }
        if missing > 0.0 {
            rows.after_gaps.push(index + 1);
        }
        number += 1.0 + missing;
        rows.numbers.push(number);
        let surprise = (late - missing).abs();
        if missing > 0.0 {
            off_at_gaps = off_at_gaps.max(surprise);
        } else {
            squares += surprise * surprise;
        }
        rows.largest_surprise = rows.largest_surprise.max(surprise);
        expected += missing * period_s + GAIN * (late - missing) * period_s;
    }
    // A recorder that drops rows keeps its clock.
    let scatter = (squares / time_s.len() as f64).sqrt();
    (off_at_gaps <= LARGEST_OFFSET + 3.0 * scatter).then_some(rows)
}

/// Counts rows of which several share a stamp. What is missing at a gap is its step less the usual
/// one between stamps.
fn shared_rows(time_s: &[f64], resolution_s: f64) -> Option<Rows> {
    let mut steps: Vec<f64> =
        time_s.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0.0).collect();
    if steps.len() < FEWEST / 2 {
        return None;
    }
    let middle = steps.len() / 2;
    let usual = (*steps.select_nth_unstable_by(middle, f64::total_cmp).1).max(resolution_s);
    let is_gap = |step: f64| step > SHARED_GAP * usual;
    let covered: f64 = steps.iter().filter(|step| !is_gap(**step)).sum();
    let gaps = steps.iter().filter(|step| is_gap(**step)).count();
    let period_s = covered / (time_s.len() - 1 - gaps) as f64;
    let mut rows = Rows { numbers: vec![0.0], after_gaps: Vec::new(), largest_surprise: 0.0 };
    let mut number = 0.0;
    for (index, pair) in time_s.windows(2).enumerate() {
        let step = pair[1] - pair[0];
        number += 1.0;
        if is_gap(step) {
            rows.after_gaps.push(index + 1);
            number += ((step - usual) / period_s).round().max(1.0);
        }
        rows.numbers.push(number);
    }
    Some(rows)
}

/// A straight line through stamps over row numbers.
struct Line {
    period_s: f64,
    /// The means of the stamps and of the numbers.
    middle: [f64; 2],
    /// Sum of the squared distances of the numbers from their mean.
    spread: f64,
}

impl Line {
    fn through(time_s: &[f64], rows: &Rows) -> Option<Self> {
        let count = time_s.len() as f64;
        let (first, numbers) = (*time_s.first()?, &rows.numbers);
        let middle_time = first + time_s.iter().map(|time| time - first).sum::<f64>() / count;
        let middle_number = numbers.iter().sum::<f64>() / count;
        let (mut product, mut spread) = (0.0, 0.0);
        for (time, number) in time_s.iter().zip(numbers) {
            product += (number - middle_number) * (time - middle_time);
            spread += (number - middle_number).powi(2);
        }
        let period_s = product / spread;
        let middle = [middle_time, middle_number];
        (period_s.is_finite() && period_s > 0.0).then_some(Self { period_s, middle, spread })
    }

    /// The largest deviation of the stamps from the line, and its root mean square.
    fn deviations(&self, time_s: &[f64], rows: &Rows) -> (f64, f64) {
        let [middle_time, middle_number] = self.middle;
        let (mut largest, mut squares) = (0.0_f64, 0.0);
        for (time, number) in time_s.iter().zip(&rows.numbers) {
            let deviation = time - middle_time - (number - middle_number) * self.period_s;
            largest = largest.max(deviation.abs());
            squares += deviation * deviation;
        }
        (largest, (squares / time_s.len() as f64).sqrt())
    }

    /// The period as a person would write it: a whole number of samples a second, or a short
    /// decimal, where the line allows it.
    fn plain_period(&self, rms: f64) -> f64 {
        let uncertain = 3.0 * rms / self.spread.sqrt();
        let rate = (1.0 / self.period_s).round();
        if rate >= 1.0 && (1.0 / rate - self.period_s).abs() <= uncertain {
            return 1.0 / rate;
        }
        shortest_within(without_rounding(self.period_s), uncertain / 3.0)
    }
}

#[cfg(test)]
mod tests;
