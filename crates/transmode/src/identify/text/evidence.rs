//! What the modes rest on, where noise is reckoned with: order, noise levels, fit.

use std::fmt::Write;

use reconstruct::likelihood::{Estimate, Hold};
use reconstruct::output_error::Structure;
use reconstruct::{Offsets, Trend};
use report::format_significant;

use super::estimates;
use crate::identify::outcome::Outcome;
use crate::modes::IdentifiedMode;

/// How many other orders are named.
const NAMED: usize = 4;

/// A line for each of order, intervals, noise, hold, band and fit.
pub(super) fn summary(outcome: &Outcome<'_>) -> String {
    let lines = [
        order(outcome),
        outcome.form().map(|form| format!("form: {form}")),
        intervals(outcome),
        noise(outcome),
        model_error(outcome),
        sensors(outcome),
        hold(outcome),
        band(outcome),
        fit(outcome),
        derivatives(outcome),
    ];
    lines.into_iter().flatten().collect::<Vec<_>>().join("\n")
}

fn order(outcome: &Outcome<'_>) -> Option<String> {
    let evidence = outcome.result.order()?;
    let (order, gap) = (evidence.order, format_significant(evidence.gap, 2));
    if evidence.asked {
        return Some(format!("order: {order}, as asked for, with a gap of {gap}"));
    }
    let mut others: Vec<_> =
        evidence.gaps.iter().filter(|(other, _)| *other != order).copied().collect();
    others.sort_by(|a, b| b.1.total_cmp(&a.1));
    let others: Vec<_> = others
        .iter()
        .take(NAMED)
        .map(|(other, gap)| format!("{} for {other}", format_significant(*gap, 2)))
        .collect();
    let mut ratios = outcome.likelihood_ratios();
    if !ratios.is_empty() {
        ratios.insert_str(0, ", and ");
    }
    Some(format!("order: {order}, by a gap of {gap} (next are {}){ratios}", others.join(", ")))
}

/// The derivatives, where the lateral equations were asked for.
fn derivatives(outcome: &Outcome<'_>) -> Option<String> {
    let derivatives = &outcome.result.fit()?.derivatives;
    let asked = outcome.options.structure == Structure::Lateral;
    let rows = derivatives.iter();
    let rows = rows.map(|own| (&own.name, own.estimate.value, own.estimate.standard_error));
    (asked && !derivatives.is_empty())
        .then(|| format!("\n{}", estimates::table("derivative", rows)))
}

fn noise(outcome: &Outcome<'_>) -> Option<String> {
    let origin = match outcome.noise_origin()? {
        "given" => "as given",
        "estimated" => "estimated from the records",
        "rounding" => "the records hold rounding errors only, of which these are upper bounds",
        _ => return Some("noise: its spectrum is that of the quiet record".to_owned()),
    };
    let channels = outcome.records.first()?.channels();
    let levels = outcome.result.noise_levels().unwrap_or_default();
    let levels: Vec<_> = channels
        .iter()
        .zip(levels)
        .enumerate()
        .map(|(index, (channel, level))| quantity(outcome, index, &channel.name, level))
        .collect();
    Some(format!("noise: {}; {origin}", levels.join(", ")))
}

/// The intervals of real modes, which need not be symmetric.
fn intervals(outcome: &Outcome<'_>) -> Option<String> {
    let of = |found: &IdentifiedMode| {
        let [low, high] = found.mode.interval_95?;
        let end = |value: f64| format_significant(value, 4);
        Some(match (low.is_finite(), high.is_finite()) {
            (true, true) => format!("{} {} to {}", found.named.name, end(low), end(high)),
            (true, false) => format!("{} above {}", found.named.name, end(low)),
            (false, true) => format!("{} below {}", found.named.name, end(high)),
            (false, false) => format!("{} anything", found.named.name),
        })
    };
    let all: Vec<_> = outcome.found.iter().filter_map(of).collect();
    (!all.is_empty()).then(|| format!("95 % intervals [1/s]: {}", all.join(", ")))
}

/// What the noise leaves to a relative model error.
fn model_error(outcome: &Outcome<'_>) -> Option<String> {
    let fit = outcome.result.fit()?;
    let error = fit.model_error?;
    let percent = |value: f64, digits| format_significant(100.0 * value, digits);
    if fit.has_least_model_error() {
        return Some("model error: 0.1 % of what the sensors read, the least that is assumed beside the noise".to_owned());
    }
    Some(format!(
        "model error: {} +- {} % of what the sensors read, beside the noise",
        percent(error.value, 2),
        percent(error.standard_error, 2)
    ))
}

/// Offsets and drift, where the records called for them.
fn sensors(outcome: &Outcome<'_>) -> Option<String> {
    let (asked, used) = (&outcome.options.measurement, &outcome.result.fit()?.options.measurement);
    let offsets = asked.offsets != used.offsets && used.offsets == Offsets::Free;
    let drift = asked.trend != used.trend && used.trend == Trend::Linear;
    let what = match (offsets, drift) {
        (true, true) => "a constant offset and a constant drift of each sensor",
        (true, false) => "a constant offset of each sensor",
        (false, true) => "a constant drift of each sensor",
        (false, false) => return None,
    };
    let mut line = format!("sensors: {what} estimated for each record");
    let channels = outcome.records.first().map_or(&[][..], |record| record.channels());
    let common: Vec<_> = channels
        .iter()
        .zip(outcome.result.offsets())
        .enumerate()
        .map(|(index, (channel, offset))| quantity(outcome, index, &channel.name, *offset))
        .collect();
    if !common.is_empty() {
        let _ = write!(line, "; taken as common to all records: {}", common.join(", "));
    }
    Some(line)
}

/// A sensor's name, the estimate with its standard error, the sensor's unit.
fn quantity(outcome: &Outcome<'_>, sensor: usize, name: &str, estimate: Estimate) -> String {
    let error = if estimate.standard_error > 0.0 {
        format!(" +- {}", format_significant(estimate.standard_error, 2))
    } else {
        String::new()
    };
    let unit = outcome.unit(sensor).filter(|unit| !unit.is_empty());
    let unit = unit.map_or_else(String::new, |unit| format!(" {unit}"));
    format!("{name} {}{error}{unit}", format_significant(estimate.value, 3))
}

/// How the excitation moves between samples, with the evidence where the records told.
fn hold(outcome: &Outcome<'_>) -> Option<String> {
    // A likelihood ratio of e^3.
    const DECISIVE: f64 = 6.0;
    let fit = outcome.result.fit()?;
    let motion = match fit.hold {
        Hold::FirstOrder => "moves on straight",
        _ => "is held",
    };
    let certainty = match fit.hold_evidence {
        None => "",
        Some(evidence) if evidence > DECISIVE => ", as the records show",
        Some(_) => ", or not: the records hardly tell",
    };
    Some(format!("between samples: the excitation {motion}{certainty}"))
}

fn band(outcome: &Outcome<'_>) -> Option<String> {
    let band = outcome.result.fit()?.options.band?;
    Some(format!(
        "band: {} to {} rad/s",
        format_significant(band.lowest_rad_s, 4),
        format_significant(band.highest_rad_s, 4)
    ))
}

fn fit(outcome: &Outcome<'_>) -> Option<String> {
    let goodness = outcome.result.fit()?.chi_squared;
    // Where the level was chosen for want of noise, the size of the residuals says nothing.
    if outcome.noise_origin() == Some("rounding") {
        return None;
    }
    let value = format_significant(goodness.per_degree_of_freedom(), 4);
    Some(match goodness.p_value {
        Some(p_value) => {
            let p_value = format_significant(p_value, 2);
            format!("fit: chi-squared per degree of freedom {value}, p-value {p_value}")
        }
        None => format!(
            "fit: chi-squared per degree of freedom {value}, by construction, since the noise levels come from the same residuals"
        ),
    })
}
