//! The fit as JSON: a stable form for other programs.

use cfi_ident::ConstantTerm;
use poly::Root;
use serde::Serialize;

use super::outcome::{Estimate, FitOutcome};
use super::warning::Warning;
use crate::CommandError;
use crate::json::{self, Number};

#[derive(Serialize)]
struct Output<'a> {
    schema: u32,
    file: &'a str,
    format: &'static str,
    input: &'a str,
    output: &'a str,
    /// `null` where the file does not say it.
    sample_period_s: Option<f64>,
    samples: u64,
    missing_samples: u64,
    samples_used: usize,
    segments: usize,
    segments_without_equation: usize,
    orders: OrdersOutput,
    constant_term: bool,
    equations: usize,
    rank: usize,
    degrees_of_freedom: usize,
    condition: f64,
    singular_values: &'a [f64],
    expected_error: f64,
    residual_norm: f64,
    residual_rms: f64,
    relative_residual: f64,
    noise_variance: Option<f64>,
    parameters: Vec<ParameterOutput>,
    /// Each root of D as often as it counts; `null` if they are not known.
    poles: Option<Vec<Number>>,
    warnings: Vec<WarningOutput>,
}

#[derive(Serialize)]
struct OrdersOutput {
    iir: usize,
    causal: usize,
    anticausal: usize,
}

#[derive(Serialize)]
struct ParameterOutput {
    name: String,
    value: f64,
    /// Standard deviation; `null` where the equations say nothing about it.
    deviation: Option<f64>,
    identifiable: bool,
}

#[derive(Serialize)]
struct WarningOutput {
    code: &'static str,
    text: String,
}

/// The JSON text, indented, with a line feed at its end.
pub(super) fn render(outcome: &FitOutcome, warnings: &[Warning]) -> Result<Vec<u8>, CommandError> {
    let fit = &outcome.fit;
    let structure = fit.model.structure();
    let orders = structure.orders;
    let output =
        Output {
            schema: 1,
            file: &outcome.file,
            format: outcome.format,
            input: &outcome.input,
            output: &outcome.output,
            sample_period_s: outcome.sample_period_s,
            samples: outcome.samples,
            missing_samples: outcome.missing,
            samples_used: fit.samples_used,
            segments: outcome.segments,
            segments_without_equation: fit.segments_without_equation,
            orders: OrdersOutput {
                iir: orders.iir(),
                causal: orders.causal(),
                anticausal: orders.anticausal(),
            },
            constant_term: structure.constant_term == ConstantTerm::Included,
            equations: fit.equations,
            rank: fit.rank,
            degrees_of_freedom: fit.degrees_of_freedom,
            condition: fit.condition,
            singular_values: &fit.singular_values,
            expected_error: fit.expected_error,
            residual_norm: fit.residual_norm,
            residual_rms: fit.residual_rms,
            relative_residual: fit.relative_residual,
            noise_variance: fit.noise_variance,
            parameters: outcome.estimates().iter().map(parameter).collect(),
            poles: outcome.poles.as_ref().ok().map(|poles| poles.iter().flat_map(pole).collect()),
            warnings: outcome
                .notes
                .iter()
                .map(|note| WarningOutput { code: note.code(), text: note.to_string() })
                .chain(warnings.iter().map(|warning| WarningOutput {
                    code: warning.code(),
                    text: warning.to_string(),
                }))
                .collect(),
        };
    json::text(&output)
}

fn parameter(estimate: &Estimate) -> ParameterOutput {
    ParameterOutput {
        name: estimate.parameter.to_string(),
        value: estimate.value,
        deviation: estimate.deviation,
        identifiable: estimate.identifiable,
    }
}

fn pole(root: &Root) -> impl Iterator<Item = Number> {
    let value = root.value;
    std::iter::repeat_with(move || value.into()).take(root.multiplicity)
}
