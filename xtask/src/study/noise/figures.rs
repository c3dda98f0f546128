//! The figures of the study of noise.

use report::{Axis, Band, Dash, Figure, Ink, Line, Panel};

use super::summary::Summary;
use crate::shared::averages::histogram;
use crate::shared::methods::{METHODS, RATIO_AXIS};
use crate::study::sections::{Over, Section};

/// All is drawn over the signal to noise ratio.
const OVER_RATIO: Over<Summary> = Over {
    axis: || Axis::log(RATIO_AXIS),
    place: |summary| f64::from(summary.kind.signal_to_noise),
};

/// Errors against the signal to noise ratio: a row for each excitation, a column for each mode.
pub(super) fn errors(sections: &[Section<Summary>]) -> Figure {
    let caption = "Root mean square error of each method, and the information bound for unknown inputs. For the printed method it is the \
                   closest of all zeros of its differences (more than fifty for each sensor), which nobody could pick without knowing the answer.";
    OVER_RATIO.errors(
        Figure::new("study-errors", "Error against the signal to noise ratio", caption),
        "rms error (1/s)",
        sections,
        &METHODS,
        |summary, method| summary.methods[method].rms,
        |summary| summary.bound,
    )
}

/// How the errors of maximum likelihood over their own deviations are distributed: a panel for each
/// excitation.
pub(super) fn scores(sections: &[Section<Summary>]) -> Figure {
    const REACH: f64 = 5.0;
    const BINS: u32 = 40;
    let caption = "Errors of maximum likelihood over the deviations that it states, all modes and noise levels, and the normal distribution. \
                   What lies beyond five deviations counts in the outermost bins.";
    let mut figure =
        Figure::new("study-scores", "Are the stated deviations honest?", caption).columns(2);
    for section in sections {
        let scores = section.summaries.iter().flat_map(|summary| summary.fits.scores.iter());
        let all: Vec<f64> = scores.flatten().copied().collect();
        let steps = histogram(&all, (-REACH, REACH), BINS);
        let bars = steps.iter().flat_map(|(left, right, y)| [(*left, 0.0, *y), (*right, 0.0, *y)]);
        let normal = (0..=100).map(|k| {
            let z = REACH * (f64::from(k) / 50.0 - 1.0);
            (z, (-0.5 * z * z).exp() / std::f64::consts::TAU.sqrt())
        });
        figure = figure.with(
            Panel::new(
                section.title,
                Axis::linear("error over deviation").range(-REACH, REACH),
                Axis::linear("density"),
            )
            .with(Band::new("maximum likelihood", bars).ink(Ink::Blue))
            .with(Line::new("normal distribution", Dash::Solid, normal).ink(Ink::Black)),
        );
    }
    figure
}

/// How often the 95 % regions hold the truth: a panel for each excitation.
pub(super) fn coverage(sections: &[Section<Summary>]) -> Figure {
    let caption = "Part of the runs in which the 95 % interval (of the Dutch roll: ellipse) of maximum likelihood holds the truth. \
                   The line is at 95 %, the area from 92 to 98 %.";
    let all = sections.iter().flat_map(|section| &section.summaries);
    let lowest = all.flat_map(|summary| summary.fits.coverage).fold(0.85, f64::min);
    OVER_RATIO.coverage(
        Figure::new("study-coverage", "Coverage of the 95 % regions", caption),
        (100.0 * lowest - 2.0, 101.0),
        (92.0, 98.0),
        sections,
        str::to_owned,
        |summary| summary.fits.coverage,
    )
}
