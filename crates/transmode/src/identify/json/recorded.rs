//! The part of the JSON that a fit with recorded inputs fills.

use reconstruct::likelihood::{Derivative, Estimate};
use reconstruct::output_error::Fit;
use serde::Serialize;

use crate::identify::outcome::Outcome;

#[derive(Serialize)]
pub(super) struct RecordedOutput<'a> {
    inputs: &'a [String],
    structure: &'static str,
    compared: Vec<ComparedOutput>,
    lags: Vec<LagOutput<'a>>,
    derivatives: Vec<DerivativeOutput<'a>>,
    correlations: Vec<Vec<f64>>,
    coefficients: Vec<DerivativeOutput<'a>>,
    explained: Vec<ExplainedOutput<'a>>,
    validation: Vec<ExplainedOutput<'a>>,
    a: Vec<Vec<f64>>,
    b: Vec<Vec<f64>>,
    c: Vec<Vec<f64>>,
    d: Vec<Vec<f64>>,
}

#[derive(Serialize)]
struct ComparedOutput {
    structure: &'static str,
    order: usize,
    above: f64,
}

#[derive(Serialize)]
struct LagOutput<'a> {
    channel: &'a str,
    value_s: f64,
    deviation_s: f64,
    estimated: bool,
}

#[derive(Serialize)]
pub(super) struct DerivativeOutput<'a> {
    name: &'a str,
    value: f64,
    deviation: f64,
}

impl<'a> From<&'a Derivative> for DerivativeOutput<'a> {
    fn from(own: &'a Derivative) -> Self {
        let Estimate { value, standard_error, .. } = own.estimate;
        Self { name: &own.name, value, deviation: standard_error }
    }
}

/// The form of the equations in a word.
pub(super) fn word(is_lateral: bool) -> &'static str {
    if is_lateral { "lateral" } else { "black-box" }
}

#[derive(Serialize)]
struct ExplainedOutput<'a> {
    record: &'a str,
    channel: &'a str,
    part: f64,
}

pub(super) fn recorded<'a>(outcome: &Outcome<'a>) -> Option<RecordedOutput<'a>> {
    let fit = outcome.result.output_error()?;
    let channels: Vec<&str> = super::channels(outcome);
    let by_channel = |record: &'a str, parts: &[f64]| {
        let each = channels.iter().zip(parts);
        each.map(|(&channel, &part)| ExplainedOutput { record, channel, part }).collect::<Vec<_>>()
    };
    let explained = outcome.records.iter().zip(&fit.records);
    let predictions = outcome.predictions.iter();
    Some(RecordedOutput {
        inputs: &outcome.options.inputs.names,
        structure: word(!fit.derivatives.is_empty()),
        compared: fit
            .compared
            .iter()
            .map(|other| ComparedOutput {
                structure: word(other.is_lateral),
                order: other.order,
                above: other.above,
            })
            .collect(),
        lags: lags(outcome, fit, &channels),
        derivatives: fit.derivatives.iter().map(DerivativeOutput::from).collect(),
        correlations: rows(&fit.correlations),
        coefficients: outcome
            .coefficients
            .iter()
            .map(|own| DerivativeOutput {
                name: &own.name,
                value: own.value,
                deviation: own.standard_error,
            })
            .collect(),
        explained: explained
            .flat_map(|(record, own)| by_channel(record.name(), &own.explained))
            .collect(),
        validation: predictions
            .flat_map(|own| by_channel(&own.simulation.record, &own.simulation.fit))
            .collect(),
        a: rows(fit.model.a()),
        b: rows(fit.model.b()),
        c: rows(fit.model.c()),
        d: rows(fit.model.d()),
    })
}

fn lags<'a>(outcome: &Outcome<'a>, fit: &Fit, channels: &[&'a str]) -> Vec<LagOutput<'a>> {
    let inputs = outcome.options.inputs.names.iter().map(String::as_str);
    let names = channels.iter().copied().chain(inputs);
    let one = |(channel, lag): (&'a str, &Estimate)| LagOutput {
        channel,
        value_s: lag.value,
        deviation_s: lag.standard_error,
        estimated: lag.standard_error > 0.0,
    };
    names.zip(fit.sensor_lags.iter().chain(&fit.input_lags)).map(one).collect()
}

pub(super) fn rows(matrix: &nalgebra::DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}
