//! The study of simulated flights as a document: what it is, a line for each kind, figures, a line
//! for each flight.

use report::{Block, Column, Document, format_significant};

use super::figures;
use super::kind::{Aircraft, Motion};
use super::summary::{Case, FAR, Summary, WRONG};
use crate::TaskError;
use crate::shared::simulator_flights::Truth;
use crate::study::sections::{Section, dash, table};

/// The whole document, of a section for each kind. `command` is what was typed.
pub(super) fn compose(
    sections: &[Section<Case>],
    truth: &Truth,
    command: &str,
) -> Result<Document, TaskError> {
    let mut document = Document::new("Study: flights in a simulator")
        .with(Block::paragraph(
            "Six aircraft in JSBSim 1.3.3, a nonlinear six-degree-of-freedom simulator that nobody of this project wrote: two records of 120 s at 20 Hz each, one moved through the \
             aileron and one through the rudder, with sensors beta, p and r; the 3-2-1-1 takes 30 s. Everything is left at its default: maximum likelihood, order, noise and band \
             from the records. In the sections with inputs recorded, the program is also given what the surfaces did, and nothing else is said. The truth is the simulator linearised in trim. No flight is quite linear, each couples into the longitudinal motion, and none holds white noise \
             unless it was added: a result can be off because the records are too short, and because the best linear system of this motion is not the one in trim.",
        ))
        .with(Block::bullets([
            format!("command: `{command}`"),
            "records and truth: `tests/data/simulator`, with their provenance".to_owned(),
            "errors: |s - true s| of the eigenvalue that is closest to the true one, of roll and Dutch roll over |true s|, of the spiral in 1/s".to_owned(),
            format!("score: error of the real part in standard errors. Were the deviations honest and the flights linear, 95 % of the scores would be within {FAR:.0}"),
            "trusted: without a doubt, so that `transmode identify` would end with exit code 0".to_owned(),
            format!("wrong: roll or Dutch roll off by more than {:.0} %", 100.0 * WRONG),
        ]));
    document.push(aircraft(truth)?);
    document.push(motions(sections)?);
    document.push(by_kind(sections)?);
    for recorded in [false, true] {
        if let Some(figure) = figures::errors(sections, recorded) {
            document.push(figure);
        }
    }
    document.push(figures::honesty(sections));
    document.push(Block::section("Each flight"));
    for section in sections {
        document.push(flights(section)?);
    }
    Ok(document)
}

fn aircraft(truth: &Truth) -> Result<Block, TaskError> {
    let header = [
        Column::left("aircraft"),
        Column::right("roll"),
        Column::right("Dutch roll"),
        Column::right("spiral"),
        Column::right("altitude (m)"),
        Column::right("speed (m/s)"),
        Column::left("what is special"),
    ];
    let mut rows = Vec::new();
    for aircraft in Aircraft::ALL {
        let known = truth.of(aircraft.name())?;
        let modes = known.modes();
        let number = |value: f64| format_significant(value, 4);
        let (re, im) = (number(modes.dutch_roll.re), number(modes.dutch_roll.im));
        rows.push([
            aircraft.name().to_owned(),
            number(modes.roll.re),
            format!("{re} ± {im}j"),
            number(modes.spiral.re),
            format!("{:.0}", known.altitude_m),
            format!("{:.0}", known.true_airspeed_m_s),
            known.about.clone(),
        ]);
    }
    table("The aircraft: true eigenvalues in 1/s", header, rows)
}

fn motions(sections: &[Section<Case>]) -> Result<Block, TaskError> {
    let shown = |motion: &Motion| {
        let own = |case: &Case| case.kind.motion == *motion;
        sections.iter().any(|section| section.summaries.iter().any(own))
    };
    let rows = Motion::ALL.into_iter().filter(shown);
    let rows = rows.map(|motion| [motion.name().to_owned(), motion.about().to_owned()]);
    table("The kinds of flight", [Column::left("kind"), Column::left("what it is")], rows)
}

/// A line for each kind, and one for all.
fn by_kind(sections: &[Section<Case>]) -> Result<Block, TaskError> {
    let header = [
        Column::left("kind"),
        Column::right("roll (%)"),
        Column::right("Dutch roll (%)"),
        Column::right("spiral (1/s)"),
        Column::right(format!("scores within {FAR:.0}")),
        Column::right("trusted"),
        Column::right("wrong"),
        Column::right("wrong and trusted"),
    ];
    let row = |name: &str, summary: &Summary| {
        let both = |mode: usize, show: fn(f64) -> String| {
            format!("{} / {}", show(summary.median[mode]), show(summary.worst[mode]))
        };
        let of_all = |number: usize| format!("{number} of {}", summary.flights);
        [
            name.to_owned(),
            both(1, percent),
            both(2, percent),
            both(0, absolute),
            share(summary.within, summary.scores),
            of_all(summary.trusted),
            of_all(summary.wrong),
            of_all(summary.wrong_and_trusted),
        ]
    };
    let each = sections.iter().map(|section| row(section.title, &Summary::of(&section.summaries)));
    let all = |recorded: bool| {
        let cases = sections.iter().flat_map(|section| &section.summaries);
        Summary::of(cases.filter(|case| case.kind.recorded == recorded))
    };
    let together = [("all without inputs", false), ("all with inputs recorded", true)];
    let together = together.map(|(name, recorded)| row(name, &all(recorded)));
    let rows = each.chain(together);
    table("Median and worst error of the aircraft, scores and doubts", header, rows)
}

/// A line for each aircraft.
fn flights(section: &Section<Case>) -> Result<Block, TaskError> {
    let header = [
        Column::left("aircraft"),
        Column::right("roll (%)"),
        Column::right("score"),
        Column::right("Dutch roll (%)"),
        Column::right("score"),
        Column::right("spiral (1/s)"),
        Column::right("score"),
        Column::right("order"),
        Column::right("model error (%)"),
        Column::right("band (rad/s)"),
        Column::left("doubts"),
    ];
    let rows = section.summaries.iter().map(|case| {
        let errors = case.errors();
        let score = |mode: usize| {
            let score = case.found().and_then(|found| found.modes[mode].score());
            score.map_or_else(dash, one_decimal)
        };
        let band = case.found().and_then(|found| found.band_rad_s);
        let model_error = case.found().and_then(|found| found.model_error);
        let doubts = match &case.outcome.result {
            Ok(found) if found.doubts.is_empty() => dash(),
            Ok(found) => found.doubts.join(", "),
            Err(refusal) => format!("no result: {refusal}"),
        };
        [
            case.kind.aircraft.name().to_owned(),
            percent(errors[1]),
            score(1),
            percent(errors[2]),
            score(2),
            absolute(errors[0]),
            score(0),
            case.found().map_or_else(dash, |found| found.order.to_string()),
            model_error.map_or_else(dash, percent),
            band.map_or_else(
                || "all".to_owned(),
                |[low, high]| {
                    format!("{} to {}", format_significant(low, 2), format_significant(high, 2))
                },
            ),
            doubts,
        ]
    });
    table(section.title, header, rows)
}

/// Without a sign where nothing is left of it.
fn one_decimal(score: f64) -> String {
    let text = format!("{score:.1}");
    if text == "-0.0" { "0.0".to_owned() } else { text }
}

/// A part in percent; a dash where there was no result.
fn percent(part: f64) -> String {
    if part.is_finite() { format_significant(100.0 * part, 2) } else { dash() }
}

fn absolute(error: f64) -> String {
    if error.is_finite() { format_significant(error, 2) } else { dash() }
}

fn share(number: usize, all: usize) -> String {
    if all == 0 { dash() } else { format!("{:.0} %", 100.0 * number as f64 / all as f64) }
}
