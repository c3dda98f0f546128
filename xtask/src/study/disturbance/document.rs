//! The study of disturbances as a document: what was asked and reached, figures, tables for each
//! excitation.

use report::{Block, Document};

use super::summary::Summary;
use super::{figures, tables};
use crate::TaskError;
use crate::shared::asked::{Asked, Row, asked_and_reached};
use crate::shared::averages::quantile;
use crate::shared::modes::PerMode;
use crate::study::sections::{Section, sampling_error};

/// The place of the fit with the quiet record among estimates, fits and results.
const QUIET_ESTIMATE: usize = 3;
const QUIET_FIT: usize = 1;
const QUIET_RESULT: usize = 3;

/// The whole document. `sizes` are |s| of spiral, roll, Dutch roll; `command` is what was typed.
pub(super) fn compose(
    sections: &[Section<Summary>],
    sizes: PerMode,
    seeds: u64,
    command: &str,
) -> Result<Document, TaskError> {
    let mut document = Document::new("Study: disturbances")
        .with(Block::paragraph(
            "The paper's aircraft (B as printed) at 10 Hz with sensors beta, p and r, in turbulence: two records of 180 s, one moved through the aileron and one \
             through the rudder, and a quiet record of 180 s in which nobody moves the controls. Each has gusts of its own, all of the same strength, and white noise in \
             every sensor of a hundredth of the sensor's response to the controls. No method but the one for comparison knows what the controls did, and none the strength of gusts or noise. Four \
             states are given to the methods.",
        ))
        .with(Block::bullets([
            format!("command: `{command}`"),
            format!("{seeds} flights of each kind; {}", sampling_error(seeds)),
            "gusts: white noise through a filter of first order with a corner at 1 rad/s (speed over scale of turbulence, 400 ft/s over 400 ft), moving on between \
             samples. A side gust g is an angle like sideslip and enters the state equations like -beta: x' = A x - a g, a the first column of A. The vane reads the sideslip \
             relative to the air, beta - g, as vanes do. Turbulence begins 60 s before each record, so that no record begins at rest"
                .to_owned(),
            "size of the gusts: root mean square of the three sensors' ratios of gust motion (all three records) to response to the controls, each about its mean. The \
             controls of each record are scaled so that the size is the same in both"
                .to_owned(),
            "controls: AR(1) with 0.9, a pilot who never rests, with his power where the modes are; and a 3-2-1-1 with steps of 0.7 s every 15 s, each to a random side, a test \
             programme. Both are held between samples"
                .to_owned(),
            "alone: white noise of unknown levels, the default. Quiet record: `NoiseModel::Quiet`. True start: the same likelihood, searched from the true system; it tells a bad start \
             from a bad spectrum. True spectrum: that of gusts and noise, as if the quiet record had no end"
                .to_owned(),
            "inputs known: an autoregression with the controls as inputs (20 lags), its Markov parameters realised with four states"
                .to_owned(),
            "information bound: the mean covariance at the true system under the true spectrum, for unknown controls, to first order. Chi-squared of the fit alone is under the true levels of the \
             sensors' noise"
                .to_owned(),
            "deviations and intervals hold to first order, and take the quiet record's spectrum for the true one. In gusts of 1 the Dutch roll's deviation is as large as its \
             damping: there even the true spectrum does not make its ellipses honest"
                .to_owned(),
        ]));
    document.push(asked(sections, sizes)?);
    document.push(figures::errors(sections));
    document.push(figures::coverage(sections));
    for Section { title, summaries } in sections {
        document.push(Block::section(format!("Controls: {title}")));
        document.push(tables::errors(summaries, sizes)?);
        document.push(tables::confidence(summaries)?);
        document.push(tables::trust(summaries)?);
    }
    Ok(document)
}

/// The figures to reach, with the quiet record.
fn asked(sections: &[Section<Summary>], sizes: PerMode) -> Result<Block, TaskError> {
    let mut rows = Vec::new();
    for Section { title, summaries } in sections {
        let two = |value: f64| format!("{value:.2}");
        let whole = |part: f64| format!("{:.1} %", 100.0 * part);
        let middles =
            summaries.iter().map(|summary| quantile(&summary.fits[QUIET_FIT].chi_squared, 0.5));
        let farthest = middles
            .fold(1.0, |far: f64, x| if (x - 1.0).abs() > (far - 1.0).abs() { x } else { far });
        rows.push(Row::new(
            format!(
                "{title}: chi-squared per degree of freedom, the median that is farthest from 1"
            ),
            Asked::Within(0.9, 1.1),
            farthest,
            two,
        ));
        for (mode, name, most) in [(2, "Dutch roll", 0.08), (1, "roll", 0.5)] {
            let largest = summaries
                .iter()
                .filter_map(|summary| summary.errors[QUIET_ESTIMATE].rms)
                .map(|rms| rms[mode] / sizes[mode])
                .fold(0.0, f64::max);
            rows.push(Row::new(
                format!("{title}: root mean square error of the {name}, largest of all gusts"),
                Asked::AtMost(most),
                largest,
                whole,
            ));
        }
        for (kinds, label) in [(0..=30, "gusts to 0.3"), (100..=100, "gusts of 1")] {
            let kinds: Vec<_> = summaries
                .iter()
                .filter(|summary| kinds.contains(&summary.kind.gust_percent))
                .collect();
            let covered: f64 =
                kinds.iter().flat_map(|summary| summary.fits[QUIET_FIT].coverage).sum();
            rows.push(Row::new(
                format!("{title}: coverage of 95 % regions, {label}"),
                Asked::Within(0.92, 0.98),
                covered / (3.0 * kinds.len() as f64),
                whole,
            ));
        }
        let part = |number: fn(&Summary) -> usize| {
            let all: usize = summaries.iter().map(|summary| summary.runs).sum();
            summaries.iter().map(number).sum::<usize>() as f64 / all as f64
        };
        rows.push(Row::new(
            format!("{title}: wrong results without a doubt"),
            Asked::AtMost(0.01),
            part(|summary| summary.trust[QUIET_RESULT].wrong_and_not_doubted),
            whole,
        ));
        rows.push(Row::new(
            format!("{title}: right results with a doubt"),
            Asked::AtMost(0.05),
            part(|summary| {
                let trust = &summary.trust[QUIET_RESULT];
                trust.doubted + trust.wrong_and_not_doubted - trust.wrong
            }),
            whole,
        ));
        rows.push(Row::new(
            format!("{title}: searches that end worse than from the true system"),
            Asked::AtMost(0.01),
            part(|summary| summary.missed),
            whole,
        ));
    }
    asked_and_reached("Asked and reached with a quiet record", &rows)
}
