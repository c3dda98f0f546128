//! The figures of the study of noise.

use report::{Axis, Band, Dash, Figure, Guide, Ink, Line, Marker, Panel};

use super::case::Excitation;
use super::statistics::Summary;
use crate::study::averages::histogram;
use crate::study::look::Look;
use crate::study::modes::MODES;

/// The methods in the order of [`Summary::methods`].
pub(crate) const METHODS: [Look; 3] = [
    ("as printed", Ink::Vermillion, Dash::Dotted, Marker::Cross),
    ("subspace", Ink::Sky, Dash::Dashed, Marker::Triangle),
    ("maximum likelihood", Ink::Blue, Dash::Solid, Marker::Circle),
];

pub(crate) const RATIO_AXIS: &str = "signal to noise ratio";

/// Errors against the signal to noise ratio: a row for each excitation, a column for each mode.
pub(crate) fn errors(summaries: &[Summary]) -> Figure {
    let caption = "Root mean square error of each method, and the information bound for unknown inputs. For the printed method it is the \
                   closest of all zeros of its differences (more than fifty for each sensor), which nobody could pick without knowing the answer.";
    let mut figure =
        Figure::new("study-errors", "Error against the signal to noise ratio", caption).columns(3);
    for excitation in present(summaries) {
        for (mode, name) in MODES.iter().enumerate() {
            let title = format!("{}, {name}", excitation.title());
            let mut panel = Panel::new(title, Axis::log(RATIO_AXIS), Axis::log("rms error (1/s)"));
            for (method, (label, ink, dash, marker)) in METHODS.iter().enumerate() {
                let points = of(summaries, excitation, |summary| {
                    summary.methods[method].rms.map(|rms| rms[mode])
                });
                if !points.is_empty() {
                    panel = panel.with(Line::new(*label, *dash, points).ink(*ink).marker(*marker));
                }
            }
            let bound = of(summaries, excitation, |summary| Some(summary.bound[mode]));
            figure = figure.with(
                panel.with(Line::new("information bound", Dash::LongDash, bound).ink(Ink::Black)),
            );
        }
    }
    figure
}

/// How the errors of maximum likelihood over their own deviations are distributed: a panel for each excitation.
pub(crate) fn scores(summaries: &[Summary]) -> Figure {
    const REACH: f64 = 5.0;
    const BINS: u32 = 40;
    let caption = "Errors of maximum likelihood over the deviations that it states, all modes and noise levels, and the normal distribution. \
                   What lies beyond five deviations counts in the outermost bins.";
    let mut figure =
        Figure::new("study-scores", "Are the stated deviations honest?", caption).columns(2);
    for excitation in present(summaries) {
        let all: Vec<f64> = summaries
            .iter()
            .filter(|summary| summary.kind.0 == excitation)
            .flat_map(|summary| summary.scores.iter().flatten().copied())
            .collect();
        let steps = histogram(&all, (-REACH, REACH), BINS);
        let bars = steps.iter().flat_map(|(left, right, y)| [(*left, 0.0, *y), (*right, 0.0, *y)]);
        let normal = (0..=100).map(|k| {
            let z = REACH * (f64::from(k) / 50.0 - 1.0);
            (z, (-0.5 * z * z).exp() / std::f64::consts::TAU.sqrt())
        });
        figure = figure.with(
            Panel::new(
                excitation.title(),
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
pub(crate) fn coverage(summaries: &[Summary]) -> Figure {
    const LOOK: [(Ink, Dash, Marker); 3] = [
        (Ink::Blue, Dash::Solid, Marker::Circle),
        (Ink::Vermillion, Dash::Dashed, Marker::Square),
        (Ink::Green, Dash::Dotted, Marker::Triangle),
    ];
    let caption = "Part of the runs in which the 95 % interval (of the Dutch roll: ellipse) of maximum likelihood holds the truth. \
                   The line is at 95 %, the area from 92 to 98 %.";
    let lowest = summaries.iter().flat_map(|summary| summary.coverage).fold(0.85, f64::min);
    let mut figure =
        Figure::new("study-coverage", "Coverage of the 95 % regions", caption).columns(2);
    for excitation in present(summaries) {
        let mut panel = Panel::new(
            excitation.title(),
            Axis::log(RATIO_AXIS),
            Axis::linear("coverage (%)").range(100.0 * lowest - 2.0, 101.0),
        )
        .guide(Guide::Horizontal(95.0));
        let ends = of(summaries, excitation, |_| Some(1.0));
        panel = panel.with(
            Band::new("92 to 98 %", ends.iter().map(|(x, _)| (*x, 92.0, 98.0))).ink(Ink::Grey),
        );
        for (mode, (ink, dash, marker)) in LOOK.into_iter().enumerate() {
            let points = of(summaries, excitation, |summary| Some(100.0 * summary.coverage[mode]));
            panel = panel.with(Line::new(MODES[mode], dash, points).ink(ink).marker(marker));
        }
        figure = figure.with(panel);
    }
    figure
}

/// The excitations that were studied.
pub(crate) fn present(summaries: &[Summary]) -> impl Iterator<Item = Excitation> {
    Excitation::ALL
        .into_iter()
        .filter(|excitation| summaries.iter().any(|summary| summary.kind.0 == *excitation))
}

/// A number of each summary of one excitation over the signal to noise ratio, ascending.
fn of(
    summaries: &[Summary],
    excitation: Excitation,
    number: impl Fn(&Summary) -> Option<f64>,
) -> Vec<(f64, f64)> {
    let chosen = summaries.iter().filter(|summary| summary.kind.0 == excitation);
    let mut points: Vec<_> = chosen
        .filter_map(|summary| number(summary).map(|y| (f64::from(summary.kind.1), y)))
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}
