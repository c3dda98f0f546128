//! The figures of the study of disturbances.

use report::{Axis, Dash, Figure, Ink, Marker};

use super::summary::{ESTIMATES, FITS, Summary};
use crate::shared::methods::Look;
use crate::study::sections::{Over, Section};

/// All is drawn over the size of the gusts.
const OVER_GUSTS: Over<Summary> = Over {
    axis: || Axis::linear("gust motion / response"),
    place: |summary| f64::from(summary.kind.gust_percent) / 100.0,
};

/// What is drawn of the estimates: their places among them, and their looks.
const SHOWN: [usize; 4] = [1, 3, 5, 6];
const LOOKS: [Look; 4] = [
    (ESTIMATES[SHOWN[0]], Ink::Vermillion, Dash::Dotted, Marker::Cross),
    (ESTIMATES[SHOWN[1]], Ink::Blue, Dash::Solid, Marker::Circle),
    (ESTIMATES[SHOWN[2]], Ink::Green, Dash::Dashed, Marker::Square),
    (ESTIMATES[SHOWN[3]], Ink::Orange, Dash::DashDot, Marker::Triangle),
];

/// The median size of a normal error over its deviation: of a real number, and of a complex one
/// with equal parts, sqrt(ln 2).
const NORMAL_MEDIAN: [f64; 3] =
    [0.674_489_750_196_082, 0.674_489_750_196_082, 0.832_554_611_157_698];

/// Errors against the size of the gusts: a row for each excitation, a column for each mode.
pub(super) fn errors(sections: &[Section<Summary>]) -> Figure {
    let caption = "Median error of maximum likelihood without and with a quiet record and with the true spectrum, and of the regression that knows the controls. At the \
                   information bound it would be about the black line: the median of the bound's deviations, times 0.67 for a real mode and 0.83 for the \
                   two parts of the Dutch roll.";
    OVER_GUSTS.errors(
        Figure::new("study-disturbance-errors", "Error against the size of the gusts", caption),
        "median error (1/s)",
        sections,
        &LOOKS,
        |summary, index| summary.errors[SHOWN[index]].median,
        |summary| [0, 1, 2].map(|mode| NORMAL_MEDIAN[mode] * summary.middle_bound[mode]),
    )
}

/// How often the 95 % regions hold the truth: a column for each excitation, a row without and one
/// with the quiet record, one with the true spectrum.
pub(super) fn coverage(sections: &[Section<Summary>]) -> Figure {
    let caption = "Part of the runs in which the 95 % interval (of the Dutch roll: ellipse) of maximum likelihood holds the truth. The line is at 95 %, the area from \
                   90 to 99 %, which a hundred runs with honest regions nearly always reach.";
    let figure = Figure::new("study-disturbance-coverage", "Coverage of the 95 % regions", caption);
    [0, 1, 3].into_iter().fold(figure, |figure, which| {
        OVER_GUSTS.coverage(
            figure,
            (-3.0, 103.0),
            (90.0, 99.0),
            sections,
            |title| format!("{}: {title}", FITS[which]),
            |summary| summary.fits[which].coverage,
        )
    })
}
