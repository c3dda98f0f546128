//! What the modes rest on where all inputs were recorded: form, hold, lags, derivatives, and how much is explained.

use reconstruct::likelihood::{Estimate, Hold};
use reconstruct::output_error::{Compared, Fit};
use report::format_significant;

use super::estimates;
use crate::identify::outcome::{Outcome, Prediction};

/// Below this, a likelihood ratio of e^5, the records do not tell one hold from the other.
const TELLING: f64 = 10.0;

/// A line for each of form, hold, lags, band and what is explained; then the derivatives.
pub(super) fn summary(outcome: &Outcome<'_>, fit: &Fit) -> String {
    let mut lines = vec![format!("inputs: {}", outcome.options.inputs.names.join(", ")), form(fit)];
    lines.push(hold(fit));
    lines.extend(lags(outcome, fit));
    if fit.drift {
        lines.push("sensors: a constant drift of each sensor estimated for each record".to_owned());
    }
    lines.push(format!(
        "band: {} to {} rad/s, without frequency zero, where the offsets of sensors are",
        format_significant(fit.band.lowest_rad_s, 4),
        format_significant(fit.band.highest_rad_s, 4)
    ));
    lines.push(model_error(fit));
    lines.extend(outcome.records.iter().zip(&fit.records).map(|(record, own)| {
        format!("explained in the band: {} in {}", parts(outcome, &own.explained), record.name())
    }));
    lines.extend(outcome.predictions.iter().map(|own| predicted(outcome, own)));
    if !fit.derivatives.is_empty() {
        let rows = fit.derivatives.iter();
        let rows = rows.map(|own| (&own.name, own.estimate.value, own.estimate.standard_error));
        lines.push(format!("\n{}", estimates::table("derivative", rows)));
    }
    if !outcome.coefficients.is_empty() {
        let rows = outcome.coefficients.iter();
        let rows = rows.map(|own| (&own.name, own.value, own.standard_error));
        lines.push(format!("\n{}", estimates::table("coefficient", rows)));
    }
    lines.join("\n")
}

fn form(fit: &Fit) -> String {
    let order = fit.model.a().nrows();
    let own = if fit.derivatives.is_empty() {
        format!("a black box of {order} states")
    } else {
        "the lateral equations, states beta, p, r, phi".to_owned()
    };
    let other = |other: &Compared| {
        let name = if other.is_lateral {
            "the lateral equations".to_owned()
        } else {
            format!("{} states", other.order)
        };
        let exponent = format_significant(other.above.abs() / 2.0, 2);
        let than = if other.above < 0.0 { "less" } else { "more" };
        format!("e^{exponent} times {than} likely than {name}")
    };
    let others: Vec<String> = fit.compared.iter().map(other).collect();
    let others = if others.is_empty() { String::new() } else { format!(", {}", others.join(", ")) };
    format!("form: {own}{others}")
}

fn hold(fit: &Fit) -> String {
    let motion = match fit.hold {
        Hold::FirstOrder => "move on in straight lines",
        _ => "are held",
    };
    let certainty = match fit.hold_evidence {
        None => ", as asked for".to_owned(),
        Some(evidence) if evidence < TELLING => ", or not: the records do not tell".to_owned(),
        Some(evidence) => {
            let exponent = format_significant(evidence.abs() / 2.0, 2);
            format!(", e^{exponent} times more likely than the other way")
        }
    };
    format!("between samples: the inputs {motion}{certainty}")
}

/// The lags that were given or estimated; nothing where there are none.
fn lags(outcome: &Outcome<'_>, fit: &Fit) -> Option<String> {
    let channels = outcome.records.first()?.channels().iter().map(|channel| &channel.name);
    let names = channels.chain(&outcome.options.inputs.names);
    let late = |(name, lag): (&String, &Estimate)| {
        let value = format_significant(lag.value, 3);
        if lag.standard_error > 0.0 {
            let error = format_significant(lag.standard_error, 2);
            return Some(format!("{name} {value} +- {error} s"));
        }
        (lag.value.abs() > 0.0).then(|| format!("{name} {value} s, as given"))
    };
    let all: Vec<String> =
        names.zip(fit.sensor_lags.iter().chain(&fit.input_lags)).filter_map(late).collect();
    (!all.is_empty()).then(|| format!("lags: {}", all.join(", ")))
}

fn model_error(fit: &Fit) -> String {
    let percent = |value: f64| format_significant(100.0 * value, 2);
    format!(
        "left over beside white noise: {} +- {} % of what the sensors read",
        percent(fit.model_error.value),
        percent(fit.model_error.standard_error)
    )
}

/// A percentage for each sensor.
fn parts(outcome: &Outcome<'_>, parts: &[f64]) -> String {
    let channels = outcome.records.first().map_or(&[][..], |record| record.channels());
    let one = |(channel, part): (&reconstruct::Channel, &f64)| {
        format!("{} {:.1} %", channel.name, 100.0 * part)
    };
    channels.iter().zip(parts).map(one).collect::<Vec<_>>().join(", ")
}

fn predicted(outcome: &Outcome<'_>, own: &Prediction) -> String {
    format!("predicted of {}: {}", own.simulation.record, parts(outcome, &own.simulation.fit))
}
