//! Group 7: from raw records with their inputs to modes, beside a regression and output error in the time domain.

use num_complex::Complex;
use reconstruct::output_error::{Fit, Options, Structure, identify};

use super::peers::Answer;
use super::times::{TimeRow, speedup, times_table};
use super::timing::{Runs, Timing, measure as time, show_seconds};
use super::{Bench, Group};
use crate::TaskError;
use crate::shared::asked::{Asked, Row, asked_and_reached};
use crate::shared::modes::TrueModes;
use crate::shared::simulator_flights::{self as flights, Flight, Truth};

const AIRCRAFT: &str = "A4";

pub(crate) fn measure(bench: &Bench) -> Result<Group, TaskError> {
    let folder = flights::folder();
    let truth = Truth::read(&folder)?.of(AIRCRAFT)?.modes();
    let pair = flights::read(&folder, AIRCRAFT, "noise")?;
    let both = flights::read(&folder, AIRCRAFT, "both")?;
    bench.say("recorded: two records of 2400 samples");
    let two = time(Runs::MANY, || fit(&pair, Structure::Automatic))?;
    bench.say("recorded: one record of 2400 samples");
    let one = time(Runs::MANY, || fit(&both, Structure::Automatic))?;
    let peer = |task: &str, runs: &str| {
        bench.say(format!("recorded: {task}"));
        let file = folder.join(format!("{AIRCRAFT}_both.csv.gz"));
        bench.peers.run(&[task, runs, &file.to_string_lossy()])
    };
    let (regression, in_time) = (peer("regression", "7"), peer("output-error", "1"));
    let asked = [
        Row::new(
            "2 records of 2400 samples: order, modes, derivatives",
            Asked::AtMost(0.3),
            two.median(),
            show_seconds,
        ),
        speedup("1 record, over output error in the time domain", 10.0, &in_time, &one),
    ];
    let rows = [
        ours(
            "2 records: black boxes and lateral equations",
            &two,
            &fit(&pair, Structure::Automatic)?,
            &truth,
        ),
        ours("1 record: the same", &one, &fit(&both, Structure::Automatic)?, &truth),
        theirs("1 record: regression of the next sample (numpy lstsq)", &regression, &truth),
        theirs("1 record: output error in the time domain (scipy)", &in_time, &truth),
    ];
    Ok(Group {
        title: "Records with their inputs",
        introduction: "The A-4 of the flights in a simulator with sensor noise, aileron and rudder recorded, 120 s at 20 Hz: in two records one after the other, and in one both at once. From \
             the samples to the form of the equations, modes, standard errors and doubts, on one thread. Peers get the one record and four states; the regression's bank angle is integrated, and output error starts \
             from the derivatives of a light aircraft."
            .to_owned(),
        blocks: vec![
            asked_and_reached("Records with their inputs: asked and reached", &asked)?,
            times_table("Records with their inputs: times", &rows)?,
        ],
    })
}

fn fit(flight: &Flight, structure: Structure) -> Result<Fit, TaskError> {
    let mut options = Options::default();
    options.structure = structure;
    identify(&flight.records, &flight.inputs, &options)
        .map_err(TaskError::computation("recorded inputs"))
}

fn ours(what: &str, timing: &Timing, fit: &Fit, truth: &TrueModes) -> TimeRow {
    let found: Vec<_> = fit.modes.iter().map(|mode| mode.continuous.value).collect();
    TimeRow::ours(what, timing, errors(&found, truth))
}

fn theirs(what: &str, answer: &Answer, truth: &TrueModes) -> TimeRow {
    let remark = match answer {
        Answer::Measured { theta, .. } => match theta[..] {
            [roll, re, im] => errors(&[Complex::from(roll), Complex::new(re, im)], truth),
            _ => String::new(),
        },
        Answer::Unavailable(_) => String::new(),
    };
    TimeRow::peer(what, answer, remark)
}

/// Relative errors of roll and Dutch roll.
fn errors(found: &[Complex<f64>], truth: &TrueModes) -> String {
    let off = |truth: Complex<f64>| {
        let all = found.iter().map(|s| (s - truth).norm() / truth.norm());
        100.0 * all.fold(f64::INFINITY, f64::min)
    };
    format!("roll off by {:.2} %, Dutch roll by {:.2} %", off(truth.roll), off(truth.dutch_roll))
}
