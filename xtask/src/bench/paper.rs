//! Group 5: the paper's own fits and its whole reconstruction.

use reconstruct::paper;

use super::ours::{self, How, PAPER};
use super::times::{TimeRow, times_table};
use super::timing::{Runs, measure as time, show_seconds};
use super::{Bench, Group};
use crate::TaskError;
use crate::shared::asked::{Asked, Row, asked_and_reached};
use crate::shared::paper_aircraft::PaperAircraft;

pub(crate) fn measure(bench: &Bench) -> Result<Group, TaskError> {
    bench.say("paper: four fits");
    let records = PaperAircraft::new()?.paper_records()?;
    let four = |how| {
        time(Runs::MANY, || {
            let mut fits = Vec::with_capacity(4);
            for record in &records {
                let [input, outputs @ ..] = record.channels() else { continue };
                for output in outputs {
                    fits.push(ours::fit(&input.values, &output.values, PAPER, how)?);
                }
            }
            Ok(fits)
        })
    };
    let gram = four(How::Gram { threads: 1 })?;
    let qr = four(How::Qr)?;
    bench.say("paper: reconstruction");
    let whole = time(Runs::MANY, || {
        paper::identify(&records, &paper::Options::default())
            .map_err(TaskError::computation("reconstruction"))
    })?;
    let rows = [
        Row::new("four fits", Asked::AtMost(3e-3), gram.median(), show_seconds),
        Row::new("the whole reconstruction", Asked::AtMost(10e-3), whole.median(), show_seconds),
    ];
    let times = [
        TimeRow::ours("four fits", &gram, "from the Gram matrix, refined"),
        TimeRow::ours("four fits by QR", &qr, "our cross-check"),
        TimeRow::ours("reconstruction", &whole, "four fits, ERA, zeros, matching"),
    ];
    Ok(Group {
        title: "The paper's example",
        introduction: "Two noise-free records of 2000 samples, aileron and rudder moving; sideslip as pseudo input, roll rate and yaw rate as pseudo outputs. One thread."
            .to_owned(),
        blocks: vec![
            asked_and_reached("The paper's example: asked and reached", &rows)?,
            times_table("The paper's example: times", &times)?,
        ],
    })
}
