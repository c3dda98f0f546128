//! The figures of the study of simulated flights.

use report::{Axis, Dash, Figure, Fill, Guide, Ink, Line, Marker, Notes, Panel, Points};

use super::kind::Aircraft;
use super::summary::Case;
use crate::shared::modes::MODES;
use crate::study::sections::Section;

/// How an aircraft is drawn.
fn look(aircraft: Aircraft) -> (Ink, Marker) {
    match aircraft {
        Aircraft::Boeing787 => (Ink::Blue, Marker::Circle),
        Aircraft::Cub => (Ink::Vermillion, Marker::Square),
        Aircraft::Md11 => (Ink::Green, Marker::Triangle),
        Aircraft::Skyhawk => (Ink::Purple, Marker::Diamond),
        Aircraft::Concorde => (Ink::Orange, Marker::TriangleDown),
        Aircraft::Boeing737 => (Ink::Black, Marker::Square),
    }
}

/// Errors of each flight without or with its inputs recorded: a panel for each mode, a strip for each kind. `None` where there is no such flight.
pub(super) fn errors(sections: &[Section<Case>], recorded: bool) -> Option<Figure> {
    let own = |section: &&Section<Case>| {
        section.summaries.first().is_some_and(|case| case.kind.recorded == recorded)
    };
    let sections: Vec<&Section<Case>> = sections.iter().filter(own).collect();
    if sections.is_empty() {
        return None;
    }
    let (id, title) = if recorded {
        ("study-simulator-recorded", "Error of each flight, inputs recorded")
    } else {
        ("study-simulator-errors", "Error of each flight")
    };
    let caption = "Errors by kind of flight and aircraft, of roll and Dutch roll over |s|. Filled: nothing to doubt. Open: the result carries a doubt. \
                   The line is at 10 %, above which a result counts as wrong. Here actlag10 is called lag, multistep 3-2-1-1, quantised 12 bits.";
    let mut figure = Figure::new(id, title, caption).columns(1);
    for (mode, label) in [(1, "error / |s|"), (2, "error / |s|"), (0, "error (1/s)")] {
        let all = sections.iter().flat_map(|section| &section.summaries);
        let errors: Vec<f64> =
            all.map(|case| case.errors()[mode]).filter(|error| error.is_finite()).collect();
        let lowest = errors.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = errors.iter().copied().fold(0.1, f64::max);
        // Room for the strips' headings above the points.
        let top = 6.0 * highest;
        // A little more than the strips, so that ticks are whole numbers.
        let x = Axis::linear("kind of flight, in the order of the tables")
            .range(0.45, sections.len() as f64 + 0.55);
        let y = Axis::log(label).range(0.6 * lowest.min(0.1), top);
        let mut panel = Panel::new(MODES[mode], x, y);
        if mode != 0 {
            panel = panel.guide(Guide::Horizontal(super::summary::WRONG));
        }
        let ends = (1..sections.len()).map(|place| Guide::Vertical(place as f64 + 0.5));
        panel = ends.fold(panel, Panel::guide);
        for (index, aircraft) in Aircraft::ALL.into_iter().enumerate() {
            let (ink, marker) = look(aircraft);
            for (fill, label) in [(Fill::Solid, aircraft.name()), (Fill::Open, "")] {
                let points: Vec<_> = places(&sections, index)
                    .filter(|(_, case)| case.trusted() == (fill == Fill::Solid))
                    .map(|(x, case)| (x, case.errors()[mode]))
                    .filter(|(_, error)| error.is_finite())
                    .collect();
                panel = panel.with(Points::new(label, marker, points).ink(ink).fill(fill));
            }
        }
        let headings = sections.iter().enumerate().filter_map(|(place, section)| {
            let first = section.summaries.first()?;
            // Notes are set to the right of their place.
            Some((place as f64 + 0.46, top / 1.8, first.kind.motion.short_name()))
        });
        figure = figure.with(panel.with(Notes::new(headings)));
    }
    Some(figure)
}

/// The flights of an aircraft, each at its place: strip by strip, beside those of the others.
fn places<'a>(
    sections: &'a [&'a Section<Case>],
    aircraft: usize,
) -> impl Iterator<Item = (f64, &'a Case)> {
    let side = (aircraft as f64 - 2.5) * 0.13;
    sections.iter().enumerate().flat_map(move |(place, section)| {
        let own = move |case: &&Case| case.kind.aircraft == Aircraft::ALL[aircraft];
        section.summaries.iter().filter(own).map(move |case| (place as f64 + 1.0 + side, case))
    })
}

/// Errors of the real parts against the standard errors that the fits state: a panel for each mode.
pub(super) fn honesty(sections: &[Section<Case>]) -> Figure {
    /// Fifty points lie close together.
    const RADIUS_PX: f64 = 3.0;
    let caption = "Errors of the real parts against the standard errors that the fits state of them, in 1/s. On the lines the error is one and two standard errors: 95 % of the \
                   points would lie below the upper one. Open: the result carries a doubt.";
    let mut figure =
        Figure::new("study-simulator-honesty", "Are the stated errors honest?", caption).columns(3);
    for mode in [1, 2, 0] {
        let points = |trusted: bool| -> Vec<(f64, f64)> {
            let all = sections.iter().flat_map(|section| &section.summaries);
            let modes = all.filter(|case| case.trusted() == trusted).filter_map(Case::found);
            let modes = modes.map(|found| found.modes[mode]);
            modes
                .filter_map(|mode| Some((mode.standard_error?, mode.real_error.abs())))
                .filter(|(_, error)| *error > 0.0)
                .collect()
        };
        let (trusted, doubted) = (points(true), points(false));
        let stated = || trusted.iter().chain(&doubted).map(|(stated, _)| *stated);
        let ends = (stated().fold(f64::INFINITY, f64::min), stated().fold(0.0, f64::max));
        let mut panel =
            Panel::new(MODES[mode], Axis::log("standard error (1/s)"), Axis::log("error (1/s)"));
        if ends.0 < ends.1 {
            for (times, label, dash) in [
                (1.0, "one standard error", Dash::Dotted),
                (2.0, "two standard errors", Dash::Dashed),
            ] {
                let ends = [ends.0, ends.1].map(|stated| (stated, times * stated));
                panel = panel.with(Line::new(label, dash, ends).ink(Ink::Black));
            }
        }
        figure = figure.with(
            panel
                .with(
                    Points::new("nothing to doubt", Marker::Circle, trusted)
                        .ink(Ink::Blue)
                        .fill(Fill::Solid)
                        .radius(RADIUS_PX),
                )
                .with(
                    Points::new("with a doubt", Marker::Circle, doubted)
                        .ink(Ink::Vermillion)
                        .radius(RADIUS_PX),
                ),
        );
    }
    figure
}
