//! Which sensors may be at fault: a faulty one is seen by all transmissibilities that contain it, and by no other.

use crate::statistics::at_least;
use crate::{Detector, TestKind, Window};

/// A transmissibility that exceeds its limits as often as this by chance counts as healthy.
const BY_CHANCE: f64 = 1e-3;

/// For each transmissibility, whether it exceeds its own limits in these windows more often than by chance.
pub(crate) fn raised(detector: &Detector, windows: &[&Window]) -> Vec<bool> {
    let limit = detector.limit_of_one();
    let exceeds = |deviations: &[f64; 2]| deviations.iter().any(|off| off * off > limit);
    let chance = detector.options().false_alarms;
    let mut raised: Vec<bool> = (0..detector.links().len())
        .map(|link| {
            let times = windows
                .iter()
                .filter(|window| window.deviations.get(link).is_some_and(exceeds))
                .count();
            times > 0 && at_least(times, windows.len(), chance) <= BY_CHANCE.max(chance)
        })
        .collect();
    // A fault that only all of them together can see is most likely where it is largest.
    if let Some(window) = windows.first().filter(|_| !raised.contains(&true)) {
        raised[farthest_of_alarm(window)] = true;
    }
    raised
}

/// The channels that alone explain which transmissibilities are raised: those in all raised ones, and first among them those in no other.
///
/// The others may be at fault too, where their fault is too small for the transmissibilities that are not raised. None where no single channel is in all of them.
pub(crate) fn suspects(detector: &Detector, raised: &[bool]) -> Vec<usize> {
    let links = detector.links();
    let channels = detector.longest_run().len();
    let in_all_raised = |channel: &usize| {
        let mut of = links.iter().zip(raised).filter(|(_, raised)| **raised);
        of.all(|(link, _)| link.contains(*channel))
    };
    if !raised.contains(&true) {
        return Vec::new();
    }
    let possible: Vec<usize> = (0..channels).filter(in_all_raised).collect();
    let in_no_other = |channel: &usize| {
        links.iter().zip(raised).all(|(link, raised)| *raised || !link.contains(*channel))
    };
    let (mut exact, others): (Vec<usize>, Vec<usize>) = possible.into_iter().partition(in_no_other);
    exact.extend(others);
    exact
}

/// The transmissibility that is farthest off in what the window's alarm is about.
fn farthest_of_alarm(window: &Window) -> usize {
    farthest(window, window.alarm().map_or(TestKind::Level, |(kind, _)| kind))
}

/// The transmissibility that is farthest off in this window in what that test looks at.
pub(crate) fn farthest(window: &Window, kind: TestKind) -> usize {
    let place = match kind {
        TestKind::Level => 0,
        TestKind::Spread => 1,
    };
    let size = |link: &(usize, &[f64; 2])| link.1[place].abs();
    let links = window.deviations.iter().enumerate();
    links.max_by(|a, b| size(a).total_cmp(&size(b))).map_or(0, |(link, _)| link)
}

#[cfg(test)]
mod tests;
