//! What is odd about one channel, from its samples alone.

/// An outlier stands out of the second differences by more than so many median absolute deviations. Of white normal noise, one sample in
/// twenty million does.
const OUTLIER: f64 = 8.0;

/// And by so much more than the second differences around it, up to `AROUND` samples away: in a manoeuvre all of them are large.
const ISOLATED: f64 = 4.0;
const AROUND: usize = 5;

/// A channel is stuck where it repeats one value for so many samples ..
const STUCK: usize = 25;

/// .. and for so many times as long as it does on average, so that a coarse sensor in calm air is not.
const UNUSUAL: f64 = 10.0;

/// A channel is saturated where it stays at its largest or smallest value for so many samples, twice at least, unless it repeats most of its
/// values: then it is coarse.
const SATURATED: usize = 3;

/// How many outliers are named.
const NAMED: usize = 10;

/// One channel. Missing samples are left out of every number.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Signal {
    pub(super) missing: usize,
    pub(super) min: f64,
    pub(super) max: f64,
    pub(super) mean: f64,
    pub(super) rms: f64,
    /// The first few rows.
    pub(super) outliers: Vec<usize>,
    pub(super) outlier_count: usize,
    /// The longest stretch of one value where there should be none: its first row and its length.
    pub(super) stuck: Option<(usize, usize)>,
    /// The value at which it is cut off, and how many samples are.
    pub(super) saturated: Option<(f64, usize)>,
    /// The same for each end at which it is.
    pub(super) cut_off: Vec<(f64, usize)>,
}

impl Signal {
    pub(super) fn of(values: &[f64]) -> Self {
        let mut signal = Self { min: f64::INFINITY, max: f64::NEG_INFINITY, ..Self::default() };
        let (mut sum, mut squares, mut count) = (0.0, 0.0, 0_u64);
        for &value in values {
            if value.is_nan() {
                signal.missing += 1;
                continue;
            }
            signal.min = signal.min.min(value);
            signal.max = signal.max.max(value);
            sum += value;
            squares += value * value;
            count += 1;
        }
        let count = count.max(1) as f64;
        signal.mean = sum / count;
        signal.rms = (squares / count).sqrt();
        if signal.is_constant() {
            return signal;
        }
        let outliers = outliers(values);
        signal.outlier_count = outliers.len();
        signal.outliers = outliers.into_iter().take(NAMED).collect();
        signal.repeats(values);
        signal
    }

    /// Whether the sensor says nothing at all.
    pub(super) fn is_constant(&self) -> bool {
        self.min >= self.max
    }

    /// Finds stuck stretches and saturation among the runs of equal values.
    fn repeats(&mut self, values: &[f64]) {
        let runs = || {
            values.chunk_by(|a, b| a.to_bits() == b.to_bits()).scan(0, |row, run| {
                *row += run.len();
                Some((*row - run.len(), run))
            })
        };
        let unusual =
            |length: usize| length as f64 > UNUSUAL * values.len() as f64 / runs().count() as f64;
        let longest = runs().filter(|(_, run)| !run[0].is_nan()).max_by_key(|(_, run)| run.len());
        self.stuck = longest
            .map(|(row, run)| (row, run.len()))
            .filter(|(_, length)| *length >= STUCK && unusual(*length));
        let repeated = runs().filter(|(_, run)| run.len() > 1).count();
        if 2 * repeated > runs().count() {
            return;
        }
        for edge in [self.max, self.min] {
            let cut = || {
                runs()
                    .filter(|(_, run)| run[0].to_bits() == edge.to_bits() && run.len() >= SATURATED)
            };
            if cut().count() >= 2 {
                self.cut_off.push((edge, cut().map(|(_, run)| run.len()).sum()));
                self.saturated = self.cut_off.last().copied();
            }
        }
    }
}

/// Rows at which a sample jumps away from its neighbours and back.
///
/// A jump by h makes the second differences h, -2 h, h. A step of the signal or of its slope, as at a gap or when a control starts to move, makes
/// others.
fn outliers(values: &[f64]) -> Vec<usize> {
    let second: Vec<f64> = values.windows(3).map(|w| w[0] - 2.0 * w[1] + w[2]).collect();
    let mut sizes: Vec<f64> = second.iter().map(|x| x.abs()).filter(|x| *x > 0.0).collect();
    if sizes.is_empty() {
        return Vec::new();
    }
    let middle = sizes.len() / 2;
    let limit = OUTLIER * *sizes.select_nth_unstable_by(middle, f64::total_cmp).1;
    let is_outlier = |&at: &usize| {
        let peak = second[at];
        if peak.is_nan() || peak.abs() <= limit {
            return false;
        }
        let side =
            |index: usize| second.get(index).is_none_or(|x| (-0.75..-0.25).contains(&(x / peak)));
        let from = at.saturating_sub(AROUND);
        let around = second[from..(at + AROUND + 1).min(second.len())].iter().enumerate();
        let far = around.filter(|(index, _)| (from + index).abs_diff(at) > 1);
        let largest = far.map(|(_, x)| x.abs()).fold(0.0, f64::max);
        side(at.wrapping_sub(1)) && side(at + 1) && peak.abs() > ISOLATED * largest
    };
    (0..second.len()).filter(is_outlier).map(|at| at + 1).collect()
}

#[cfg(test)]
mod tests;
