//! The study of noise as a document: what was asked and reached, tables for each excitation,
//! figures.

use report::{Block, Column, Document, format_significant};

use super::figures;
use super::summary::{BAD_FIT, Summary};
use crate::TaskError;
use crate::shared::asked::{Asked, Row, asked_and_reached};
use crate::shared::averages::root_mean_square;
use crate::shared::methods::METHODS;
use crate::shared::modes::MODES;
use crate::shared::noisy_flights::Excitation;
use crate::study::sections::{Section, dash, sampling_error, table, three};

/// The whole document. `command` is what was typed.
pub(super) fn compose(
    sections: &[Section<Summary>],
    seeds: u64,
    command: &str,
) -> Result<Document, TaskError> {
    let mut document = Document::new("Study: noise")
        .with(Block::paragraph(
            "The paper's aircraft (B as printed) at 10 Hz with sensors beta, p and r: two records, one moved through the aileron and one through the rudder, \
             2000 samples each, 300 with the 3-2-1-1. White noise in every sensor, its level the root mean square of the sensor's signal (about its mean, mean of the two records) over the \
             signal to noise ratio; no method knows the levels. Four states are given to the methods; the order that the gap shows is counted beside. \
             The information bound is the mean covariance at the true system with known levels, for unknown inputs. A Dutch roll is lost where a real \
             eigenvalue is in its place: that counts in errors and coverage, but has no score. The top of the likelihood is missed where a search from the true system ends higher.",
        ))
        .with(Block::bullets([
            format!("command: `{command}`"),
            format!("{seeds} pairs of records for each excitation and signal to noise ratio"),
            sampling_error(seeds),
            "excitations: white and AR(1) with 0.9 are held between samples; the band-limited one is white noise behind a Butterworth filter of fourth order with a \
             corner at 1 Hz and moves on between samples; the 3-2-1-1 has steps of 0.7 s, held. The methods are not told which is held: maximum likelihood finds out"
                .to_owned(),
            "95 % regions: of spiral and roll from the likelihood itself (`profile_intervals`), of the Dutch roll the ellipse of its covariance"
                .to_owned(),
        ]));
    document.push(asked(sections)?);
    document.push(figures::errors(sections));
    for Section { title, summaries } in sections {
        document.push(Block::section(format!("Excitation: {title}")));
        document.push(error_table(summaries)?);
        document.push(median_table(summaries)?);
        document.push(confidence_table(summaries)?);
    }
    document.push(Block::section("Confidence"));
    document.push(figures::scores(sections));
    document.push(figures::coverage(sections));
    Ok(document)
}

/// The figures to reach, worst over what they are asked for.
fn asked(sections: &[Section<Summary>]) -> Result<Block, TaskError> {
    let mut rows = Vec::new();
    for Section { title, summaries } in sections {
        let at = |from: u32, to: u32| {
            let inside =
                move |summary: &&Summary| (to..=from).contains(&summary.kind.signal_to_noise);
            summaries.iter().filter(inside)
        };
        let multisteps =
            summaries.iter().any(|summary| summary.kind.excitation == Excitation::Multistep);
        let (lowest, limited) = if multisteps { (100, None) } else { (30, Some(10)) };
        let worst = |from, to| {
            let ratios = at(from, to).filter_map(Summary::ratio).flatten();
            ratios.fold(0.0, f64::max)
        };
        let two = |value: f64| format!("{value:.2}");
        rows.push(Row::new(
            format!("{title}: largest error over the bound, ratio {lowest} and more"),
            Asked::AtMost(1.15),
            worst(u32::MAX, lowest),
            two,
        ));
        if let Some(ratio) = limited {
            rows.push(Row::new(
                format!("{title}: largest error over the bound, ratio {ratio}"),
                Asked::AtMost(1.3),
                worst(ratio, ratio),
                two,
            ));
        }
        let pooled: Vec<f64> = at(u32::MAX, lowest)
            .flat_map(|summary| summary.fits.scores.iter().flatten().copied())
            .collect();
        rows.push(Row::new(
            format!("{title}: deviation of the scores, ratio {lowest} and more"),
            Asked::Within(0.9, 1.1),
            root_mean_square(&pooled),
            two,
        ));
        let (mut covered, mut all) = (0.0, 0.0);
        for summary in at(u32::MAX, lowest) {
            covered += summary.fits.coverage.iter().sum::<f64>();
            all += 3.0;
        }
        rows.push(Row::new(
            format!("{title}: coverage of 95 % regions, ratio {lowest} and more"),
            Asked::Within(0.92, 0.98),
            covered / all,
            |part| format!("{:.1} %", 100.0 * part),
        ));
        let (bad, runs) = at(u32::MAX, 0)
            .fold((0, 0), |(bad, runs), summary| (bad + summary.bad_fits, runs + summary.runs));
        rows.push(Row::new(
            format!(
                "{title}: runs with chi-squared per degree of freedom above {BAD_FIT}, all ratios"
            ),
            Asked::AtMost(0.01),
            bad as f64 / runs as f64,
            |part| format!("{:.1} %", 100.0 * part),
        ));
    }
    asked_and_reached("Asked and reached", &rows)
}

fn error_table(summaries: &[Summary]) -> Result<Block, TaskError> {
    let [printed, subspace, likelihood] = METHODS.map(|(name, ..)| Column::right(name));
    let header = [
        Column::right("ratio"),
        Column::left("mode"),
        printed,
        subspace,
        likelihood,
        Column::right("information bound"),
        Column::right("likelihood over bound"),
    ];
    let number = |value| format_significant(value, 3);
    let rows = summaries.iter().flat_map(|summary| {
        let ratio = summary.ratio();
        let row = move |mode: usize| {
            let [printed, subspace, likelihood] = summary
                .methods
                .each_ref()
                .map(|method| method.rms.map_or_else(dash, |rms| number(rms[mode])));
            [
                summary.kind.signal_to_noise.to_string(),
                MODES[mode].to_owned(),
                printed,
                subspace,
                likelihood,
                number(summary.bound[mode]),
                ratio.map_or_else(dash, |ratio| format!("{:.2}", ratio[mode])),
            ]
        };
        [0, 1, 2].map(row)
    });
    table("Root mean square errors in 1/s", header, rows)
}

fn median_table(summaries: &[Summary]) -> Result<Block, TaskError> {
    let [printed, subspace, likelihood] = METHODS.map(|(name, ..)| Column::right(name));
    let rows = summaries.iter().map(|summary| {
        let [printed, subspace, likelihood] = summary.methods.each_ref().map(|method| {
            method.median.map_or_else(dash, |median| three(median, |x| format_significant(x, 2)))
        });
        [summary.kind.signal_to_noise.to_string(), printed, subspace, likelihood]
    });
    let header = [Column::right("ratio"), printed, subspace, likelihood];
    table("Median errors in 1/s: spiral / roll / Dutch roll", header, rows)
}

fn confidence_table(summaries: &[Summary]) -> Result<Block, TaskError> {
    let header = [
        Column::right("ratio"),
        Column::right("deviation of scores"),
        Column::right("coverage (%)"),
        Column::right(format!("chi-squared above {BAD_FIT}")),
        Column::right("Dutch roll lost"),
        Column::right("not converged"),
        Column::right("top missed"),
        Column::right("no result: printed / subspace / likelihood"),
        Column::right("gap shows four states"),
    ];
    let rows = summaries.iter().map(|summary| {
        let of_all = |number: usize| format!("{number} of {}", summary.runs);
        [
            summary.kind.signal_to_noise.to_string(),
            three(summary.fits.score_deviation(), |x| format!("{x:.2}")),
            three(summary.fits.coverage, |part| format!("{:.1}", 100.0 * part)),
            of_all(summary.bad_fits),
            of_all(summary.fits.lost),
            of_all(summary.fits.unconverged),
            of_all(summary.missed),
            summary.methods.each_ref().map(|method| method.failed.to_string()).join(" / "),
            of_all(summary.right_order),
        ]
    });
    table("Confidence of maximum likelihood: spiral / roll / Dutch roll", header, rows)
}
