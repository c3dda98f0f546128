//! What kind of change an alarm is, since when, and in which sensor.

use crate::attribution::{farthest, raised, suspects};
use crate::stretch::first_run_beyond;
use crate::{Detector, MonitorError, Stretch, TestKind, Window};

/// A run of equal values is a freeze if it is longer than this many times the longest healthy one, and this many samples.
const FREEZE_FACTOR: usize = 2;
const FREEZE_SAMPLES: usize = 5;

/// Windows from the first alarm on that say what has changed, and as many before.
const JUDGED: usize = 10;
/// Windows in which the edge of a jump may lie.
const EDGE: usize = 2;

/// A kind of change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Change {
    /// The residual's mean has jumped.
    Bias,
    /// The residual's mean moves away steadily.
    Drift,
    /// The residual varies more than it should.
    Noise,
    /// The residual varies less than it should.
    Quiet,
    /// A sensor reads the same number over and over.
    Freeze,
}

impl std::fmt::Display for Change {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Self::Bias => "bias",
            Self::Drift => "drift",
            Self::Noise => "noise",
            Self::Quiet => "quiet",
            Self::Freeze => "freeze",
        })
    }
}

/// What the alarms of a record say together.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Diagnosis {
    /// Index among the windows of the first alarm.
    pub first_alarm: usize,
    /// How many windows raise an alarm.
    pub alarms: usize,
    /// What has changed.
    pub change: Change,
    /// Channels any of which explains alone which transmissibilities are raised; empty where none does.
    pub suspects: Vec<usize>,
    /// For each transmissibility, whether it is raised.
    pub raised: Vec<bool>,
}

impl Detector {
    /// Judges the windows of new data together; nothing where none raises an alarm.
    ///
    /// # Errors
    ///
    /// [`MonitorError::NoSuchChannel`] if `stretches` are not those that `windows` come from.
    pub fn diagnose(
        &self,
        windows: &[Window],
        stretches: &[Stretch<'_>],
    ) -> Result<Option<Diagnosis>, MonitorError> {
        let is_alarm = |window: &&Window| window.alarm().is_some();
        let Some(first_alarm) = windows.iter().position(|window| is_alarm(&window)) else {
            return Ok(None);
        };
        let alarms = windows.iter().filter(is_alarm).count();
        let since: Vec<&Window> = windows[first_alarm..].iter().take(JUDGED).collect();
        let raised = raised(self, &since);
        let frozen = self.frozen(since[0], stretches)?;
        let (change, suspects) = match frozen {
            Some(channel) => (Change::Freeze, vec![channel]),
            None => {
                let change = spread_change(&since).unwrap_or_else(|| {
                    let link = farthest(since[0], TestKind::Level);
                    level_change(windows, first_alarm, link)
                });
                (change, suspects(self, &raised))
            }
        };
        Ok(Some(Diagnosis { first_alarm, alarms, change, suspects, raised }))
    }

    /// The channel that stands still at the first alarm or after.
    fn frozen(
        &self,
        window: &Window,
        stretches: &[Stretch<'_>],
    ) -> Result<Option<usize>, MonitorError> {
        let link = self.links().first().ok_or(MonitorError::NoLink)?;
        let stretch = stretches.get(window.stretch).ok_or_else(|| link.missing(0))?;
        let begin = |(channel, longest): (usize, &usize)| {
            let usual = (FREEZE_FACTOR * longest).max(FREEZE_SAMPLES);
            let values = stretch.get(channel)?;
            let run = first_run_beyond(values, usual, window.first)?;
            Some((run.start, channel))
        };
        let earliest = self.longest_run().iter().enumerate().filter_map(begin).min();
        let near = earliest.filter(|(start, _)| *start <= window.known_at);
        Ok(near.map(|(_, channel)| channel))
    }
}

/// Whether it is the spread that most alarms are about, and to which side. A jump shows in the spread too, but only where it is.
fn spread_change(since: &[&Window]) -> Option<Change> {
    let [_, spread] = TestKind::ALL;
    let alarms: Vec<(usize, TestKind)> = since
        .iter()
        .enumerate()
        .filter_map(|(index, window)| Some((index, window.alarm()?.0)))
        .collect();
    let of_spread: Vec<usize> =
        alarms.iter().filter(|(_, kind)| *kind == spread).map(|(index, _)| *index).collect();
    let is_jump = since.len() > 2 * EDGE && of_spread.iter().all(|index| *index < EDGE);
    if 2 * of_spread.len() <= alarms.len() || is_jump {
        return None;
    }
    let of_spread = of_spread.iter().filter_map(|index| since.get(*index));
    let side: f64 = of_spread.flat_map(|window| window.deviations.iter().map(|off| off[1])).sum();
    Some(if side < 0.0 { Change::Quiet } else { Change::Noise })
}

/// A jump or a steady movement, whichever explains the means of that transmissibility around the first alarm with the smaller squares, each with the beginning
/// that suits it best.
fn level_change(windows: &[Window], first_alarm: usize, link: usize) -> Change {
    let before = first_alarm.saturating_sub(JUDGED);
    let near = windows.iter().skip(before).take(first_alarm - before + JUDGED);
    let means: Vec<f64> = near.filter_map(|window| window.means.get(link)).copied().collect();
    let healthy = means.get(..(first_alarm - before) / 2).unwrap_or_default();
    let usual = healthy.iter().sum::<f64>() / healthy.len().max(1) as f64;
    let levels: Vec<f64> = means.iter().map(|mean| mean - usual).collect();
    // The squares that `a shape(k)` takes away from the sum of all squares.
    let explained = |shape: fn(usize) -> f64| {
        let of = |beginning: usize| {
            let (mut product, mut square) = (0.0, 0.0);
            for (k, level) in levels[beginning..].iter().enumerate() {
                product += level * shape(k);
                square += shape(k) * shape(k);
            }
            product * product / square
        };
        (0..levels.len()).map(of).fold(0.0, f64::max)
    };
    let (step, ramp) = (explained(|_| 1.0), explained(|k| k as f64 + 0.5));
    if ramp > step { Change::Drift } else { Change::Bias }
}

#[cfg(test)]
mod tests;
