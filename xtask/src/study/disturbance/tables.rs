//! The tables of the study of disturbances, each of one excitation.

use report::{Block, Column, format_significant};

use super::summary::{ESTIMATES, FITS, MISSED, RESULTS, Summary, WRONG};
use crate::TaskError;
use crate::shared::averages::quantile;
use crate::shared::modes::PerMode;
use crate::study::sections::{dash, table, three};

const GUSTS: &str = "gusts";

/// Errors of everything in 1/s and in percent.
pub(super) fn errors(summaries: &[Summary], sizes: PerMode) -> Result<Block, TaskError> {
    let header = [
        Column::right(GUSTS),
        Column::left("method"),
        Column::right("rms (1/s)"),
        Column::right("median (1/s)"),
        Column::right("rms (%)"),
        Column::right("median (%)"),
        Column::right("no result"),
    ];
    let mut rows = Vec::new();
    let absolute = |errors: Option<PerMode>| {
        errors.map_or_else(dash, |errors| three(errors, |x| format_significant(x, 2)))
    };
    let relative = |errors: Option<PerMode>| {
        let percent = |errors: PerMode| [0, 1, 2].map(|mode| 100.0 * errors[mode] / sizes[mode]);
        errors.map_or_else(dash, |errors| three(percent(errors), |x| format_significant(x, 2)))
    };
    for summary in summaries {
        for (name, errors) in ESTIMATES.iter().zip(&summary.errors) {
            rows.push([
                gusts(summary),
                (*name).to_owned(),
                absolute(errors.rms),
                absolute(errors.median),
                relative(errors.rms),
                relative(errors.median),
                errors.failed.to_string(),
            ]);
        }
        let bound = Some(summary.bound);
        let (name, none) = ("information bound".to_owned(), dash());
        let cells = [gusts(summary), name, absolute(bound), none, relative(bound), dash(), dash()];
        rows.push(cells);
    }
    table("Errors, absolute and in percent of |s|: spiral / roll / Dutch roll", header, rows)
}

/// What the fits state about themselves.
pub(super) fn confidence(summaries: &[Summary]) -> Result<Block, TaskError> {
    let header = [
        Column::right(GUSTS),
        Column::left("method"),
        Column::right("chi-squared: median (5 % to 95 %)"),
        Column::right("coverage (%)"),
        Column::right("deviation of scores"),
        Column::right("not converged"),
        Column::right("worse than from the true system"),
    ];
    let title = format!(
        "Confidence: spiral / roll / Dutch roll; chi-squared per degree of freedom; worse is a sum of squares larger by more than {MISSED}"
    );
    let mut rows = Vec::new();
    for summary in summaries {
        for (which, (name, fits)) in FITS.iter().zip(&summary.fits).enumerate() {
            let [low, middle, high] = [0.05, 0.5, 0.95]
                .map(|part| format_significant(quantile(&fits.chi_squared, part), 3));
            rows.push([
                gusts(summary),
                (*name).to_owned(),
                format!("{middle} ({low} to {high})"),
                three(fits.coverage, |part| format!("{:.0}", 100.0 * part)),
                three(fits.score_deviation(), |x| format_significant(x, 2)),
                fits.unconverged.to_string(),
                if which == 1 { summary.missed.to_string() } else { dash() },
            ]);
        }
    }
    table(title, header, rows)
}

/// Whether results that cannot be trusted say so.
pub(super) fn trust(summaries: &[Summary]) -> Result<Block, TaskError> {
    let header = [
        Column::right(GUSTS),
        Column::left("method"),
        Column::right("doubted"),
        Column::right("wrong"),
        Column::right("wrong and not doubted"),
        Column::right("right and doubted"),
        Column::left("doubts"),
    ];
    let title = format!(
        "Doubts; wrong is a roll or Dutch roll that is off by more than {:.0} % of its size",
        100.0 * WRONG
    );
    let mut rows = Vec::new();
    for summary in summaries {
        for (name, trust) in RESULTS.iter().zip(&summary.trust) {
            let of_all = |number: usize| format!("{number} of {}", trust.results);
            let mut doubts: Vec<_> = trust.doubts.iter().collect();
            doubts.sort_by_key(|(_, runs)| std::cmp::Reverse(**runs));
            let doubts: Vec<_> =
                doubts.into_iter().map(|(doubt, runs)| format!("{doubt} {runs}")).collect();
            let right_and_doubted = trust.doubted + trust.wrong_and_not_doubted - trust.wrong;
            rows.push([
                gusts(summary),
                (*name).to_owned(),
                of_all(trust.doubted),
                of_all(trust.wrong),
                of_all(trust.wrong_and_not_doubted),
                of_all(right_and_doubted),
                if doubts.is_empty() { dash() } else { doubts.join(", ") },
            ]);
        }
    }
    table(title, header, rows)
}

fn gusts(summary: &Summary) -> String {
    format!("{:.1}", f64::from(summary.kind.gust_percent) / 100.0)
}
