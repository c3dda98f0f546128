//! The study of noise as a document: what was asked and reached, tables for each excitation, figures.

use report::{Block, Column, Document, Table, format_significant};

use super::case::Excitation;
use super::figures::{self, METHODS, present};
use super::statistics::{BAD_FIT, Summary};
use crate::TaskError;
use crate::bench::row::{Asked, Row, asked_and_reached};
use crate::study::averages::root_mean_square;
use crate::study::modes::MODES;

/// The whole document. `command` is what was typed.
pub(crate) fn compose(
    summaries: &[Summary],
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
            format!(
                "sampling error of the study itself: {:.0} % of each root mean square, {:.1} % of a coverage of 95 %",
                100.0 / (2.0 * seeds as f64).sqrt(),
                100.0 * (0.95 * 0.05 / seeds as f64).sqrt()
            ),
            "excitations: white and AR(1) with 0.9 are held between samples; the band-limited one is white noise behind a Butterworth filter of fourth order with a \
             corner at 1 Hz and moves on between samples; the 3-2-1-1 has steps of 0.7 s, held. The methods are not told which is held: maximum likelihood finds out"
                .to_owned(),
            "95 % regions: of spiral and roll from the likelihood itself (`profile_intervals`), of the Dutch roll the ellipse of its covariance"
                .to_owned(),
        ]));
    document.push(asked(summaries)?);
    document.push(figures::errors(summaries));
    for excitation in present(summaries) {
        let chosen: Vec<&Summary> =
            summaries.iter().filter(|summary| summary.kind.0 == excitation).collect();
        document.push(Block::section(format!("Excitation: {}", excitation.title())));
        document.push(error_table(&chosen)?);
        document.push(median_table(&chosen)?);
        document.push(confidence_table(&chosen)?);
    }
    document.push(Block::section("Confidence"));
    document.push(figures::scores(summaries));
    document.push(figures::coverage(summaries));
    Ok(document)
}

/// The figures to reach, worst over what they are asked for.
fn asked(summaries: &[Summary]) -> Result<Block, TaskError> {
    let mut rows = Vec::new();
    for excitation in present(summaries) {
        let title = excitation.title();
        let at = |from: u32, to: u32| {
            summaries.iter().filter(move |summary| {
                summary.kind.0 == excitation && (to..=from).contains(&summary.kind.1)
            })
        };
        let (lowest, limited) = match excitation {
            Excitation::Multistep => (100, None),
            _ => (30, Some(10)),
        };
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
            .flat_map(|summary| summary.scores.iter().flatten().copied())
            .collect();
        rows.push(Row::new(
            format!("{title}: deviation of the scores, ratio {lowest} and more"),
            Asked::Within(0.9, 1.1),
            root_mean_square(&pooled),
            two,
        ));
        let (mut covered, mut all) = (0.0, 0.0);
        for summary in at(u32::MAX, lowest) {
            covered += summary.coverage.iter().sum::<f64>();
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

fn error_table(summaries: &[&Summary]) -> Result<Block, TaskError> {
    let methods = METHODS.iter().map(|(name, ..)| Column::right(*name));
    let header = [Column::right("ratio"), Column::left("mode")]
        .into_iter()
        .chain(methods)
        .chain(["information bound", "likelihood over bound"].map(Column::right));
    let mut table = Table::new("Root mean square errors in 1/s", header);
    for summary in summaries {
        for (mode, name) in MODES.iter().enumerate() {
            let mut cells = vec![summary.kind.1.to_string(), (*name).to_owned()];
            cells.extend(
                summary.methods.iter().map(|method| number(method.rms.map(|rms| rms[mode]))),
            );
            cells.push(number(Some(summary.bound[mode])));
            cells.push(summary.ratio().map_or_else(dash, |ratio| format!("{:.2}", ratio[mode])));
            table.push(cells).map_err(TaskError::computation("report"))?;
        }
    }
    Ok(table.into())
}

fn median_table(summaries: &[&Summary]) -> Result<Block, TaskError> {
    let methods = METHODS.iter().map(|(name, ..)| Column::right(*name));
    let header = [Column::right("ratio")].into_iter().chain(methods);
    let mut table = Table::new("Median errors in 1/s: spiral / roll / Dutch roll", header);
    for summary in summaries {
        let cell = |median: Option<[f64; 3]>| {
            median.map_or_else(dash, |median| {
                median.map(|error| format_significant(error, 2)).join(" / ")
            })
        };
        let cells = std::iter::once(summary.kind.1.to_string())
            .chain(summary.methods.iter().map(|method| cell(method.median)));
        table.push(cells).map_err(TaskError::computation("report"))?;
    }
    Ok(table.into())
}

fn confidence_table(summaries: &[&Summary]) -> Result<Block, TaskError> {
    let bad = format!("chi-squared above {BAD_FIT}");
    let header = [
        Column::right("ratio"),
        Column::right("deviation of scores"),
        Column::right("coverage (%)"),
        Column::right(bad),
        Column::right("Dutch roll lost"),
        Column::right("not converged"),
        Column::right("top missed"),
        Column::right("no result: printed / subspace / likelihood"),
        Column::right("gap shows four states"),
    ];
    let mut table =
        Table::new("Confidence of maximum likelihood: spiral / roll / Dutch roll", header);
    for summary in summaries {
        let three = |values: [f64; 3], digits: usize| {
            values.map(|value| format!("{value:.digits$}")).join(" / ")
        };
        let of_all = |number: usize| format!("{number} of {}", summary.runs);
        table
            .push([
                summary.kind.1.to_string(),
                three(summary.score_deviation(), 2),
                three(summary.coverage.map(|part| 100.0 * part), 1),
                of_all(summary.bad_fits),
                of_all(summary.lost),
                of_all(summary.unconverged),
                of_all(summary.missed),
                summary.methods.each_ref().map(|method| method.failed.to_string()).join(" / "),
                of_all(summary.right_order),
            ])
            .map_err(TaskError::computation("report"))?;
    }
    Ok(table.into())
}

fn number(value: Option<f64>) -> String {
    value.map_or_else(dash, |value| format_significant(value, 3))
}

fn dash() -> String {
    "-".to_owned()
}
