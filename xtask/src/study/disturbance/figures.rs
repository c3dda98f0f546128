//! The figures of the study of disturbances.

use report::{Axis, Band, Dash, Figure, Guide, Ink, Line, Marker, Panel};

use super::case::Excitation;
use super::statistics::{ESTIMATES, FITS, Summary};
use crate::study::look::Look;
use crate::study::modes::MODES;

const GUST_AXIS: &str = "gust motion / response";

/// What is drawn of the estimates: its place among them, and its look.
const SHOWN: [(usize, Look); 4] = [
    (1, (ESTIMATES[1], Ink::Vermillion, Dash::Dotted, Marker::Cross)),
    (3, (ESTIMATES[3], Ink::Blue, Dash::Solid, Marker::Circle)),
    (5, (ESTIMATES[5], Ink::Green, Dash::Dashed, Marker::Square)),
    (6, (ESTIMATES[6], Ink::Orange, Dash::DashDot, Marker::Triangle)),
];

/// The median size of a normal error over its deviation: of a real number, and of a complex one with equal parts, sqrt(ln 2).
const NORMAL_MEDIAN: [f64; 3] =
    [0.674_489_750_196_082, 0.674_489_750_196_082, 0.832_554_611_157_698];

/// Errors against the size of the gusts: a row for each excitation, a column for each mode.
pub(crate) fn errors(summaries: &[Summary]) -> Figure {
    let caption = "Median error of maximum likelihood without and with a quiet record and with the true spectrum, and of the regression that knows the controls. At the \
                   information bound it would be about the black line: the median of the bound's deviations, times 0.67 for a real mode and 0.83 for the \
                   two parts of the Dutch roll.";
    let mut figure =
        Figure::new("study-disturbance-errors", "Error against the size of the gusts", caption)
            .columns(3);
    for excitation in present(summaries) {
        for (mode, name) in MODES.iter().enumerate() {
            let title = format!("{}, {name}", excitation.title());
            let mut panel =
                Panel::new(title, Axis::linear(GUST_AXIS), Axis::log("median error (1/s)"));
            for (place, (label, ink, dash, marker)) in SHOWN {
                let points = of(summaries, excitation, |summary| {
                    summary.errors[place].median.map(|median| median[mode])
                });
                if !points.is_empty() {
                    panel = panel.with(Line::new(label, dash, points).ink(ink).marker(marker));
                }
            }
            let bound = of(summaries, excitation, |summary| {
                Some(NORMAL_MEDIAN[mode] * summary.middle_bound[mode])
            });
            figure = figure.with(
                panel.with(Line::new("information bound", Dash::LongDash, bound).ink(Ink::Black)),
            );
        }
    }
    figure
}

/// How often the 95 % regions hold the truth: a column for each excitation, a row without and one with the quiet record, one with the true spectrum.
pub(crate) fn coverage(summaries: &[Summary]) -> Figure {
    const LOOK: [(Ink, Dash, Marker); 3] = [
        (Ink::Blue, Dash::Solid, Marker::Circle),
        (Ink::Vermillion, Dash::Dashed, Marker::Square),
        (Ink::Green, Dash::Dotted, Marker::Triangle),
    ];
    let caption = "Part of the runs in which the 95 % interval (of the Dutch roll: ellipse) of maximum likelihood holds the truth. The line is at 95 %, the area from \
                   90 to 99 %, which a hundred runs with honest regions nearly always reach.";
    let mut figure =
        Figure::new("study-disturbance-coverage", "Coverage of the 95 % regions", caption)
            .columns(2);
    for which in [0, 1, 3] {
        for excitation in present(summaries) {
            let mut panel = Panel::new(
                format!("{}: {}", FITS[which], excitation.title()),
                Axis::linear(GUST_AXIS),
                Axis::linear("coverage (%)").range(-3.0, 103.0),
            )
            .guide(Guide::Horizontal(95.0));
            let ends = of(summaries, excitation, |_| Some(1.0));
            panel = panel.with(
                Band::new("90 to 99 %", ends.iter().map(|(x, _)| (*x, 90.0, 99.0))).ink(Ink::Grey),
            );
            for (mode, (ink, dash, marker)) in LOOK.into_iter().enumerate() {
                let points = of(summaries, excitation, |summary| {
                    Some(100.0 * summary.fits[which].coverage[mode])
                });
                panel = panel.with(Line::new(MODES[mode], dash, points).ink(ink).marker(marker));
            }
            figure = figure.with(panel);
        }
    }
    figure
}

/// The excitations that were studied.
pub(crate) fn present(summaries: &[Summary]) -> impl Iterator<Item = Excitation> {
    Excitation::ALL
        .into_iter()
        .filter(|excitation| summaries.iter().any(|summary| summary.kind.0 == *excitation))
}

/// A number of each summary of one excitation over the size of the gusts, ascending.
fn of(
    summaries: &[Summary],
    excitation: Excitation,
    number: impl Fn(&Summary) -> Option<f64>,
) -> Vec<(f64, f64)> {
    let chosen = summaries.iter().filter(|summary| summary.kind.0 == excitation);
    chosen
        .filter_map(|summary| number(summary).map(|y| (f64::from(summary.kind.1) / 100.0, y)))
        .collect()
}
