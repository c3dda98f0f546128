//! The result as JSON: a stable form for other programs.

use num_complex::Complex;
use reconstruct::{AsPrinted, Doubt, Identification, Record};
use serde::Serialize;

use crate::CommandError;
use crate::modes::Found;
use crate::records::LoadWarning;

#[derive(Serialize)]
struct Output<'a> {
    schema: u32,
    method: &'static str,
    order: usize,
    sample_period_s: f64,
    records: Vec<RecordOutput<'a>>,
    modes: Vec<ModeOutput>,
    /// Smallest spread of a group of zeros that was refused as a mode.
    closest_refused: Option<f64>,
    transmissibilities: Vec<TransmissibilityOutput<'a>>,
    warnings: Vec<Warning>,
}

#[derive(Serialize)]
struct RecordOutput<'a> {
    file: &'a str,
    samples: usize,
}

/// A complex number.
#[derive(Serialize)]
struct Number {
    re: f64,
    im: f64,
}

impl From<Complex<f64>> for Number {
    fn from(value: Complex<f64>) -> Self {
        Self { re: value.re, im: value.im }
    }
}

/// A mode; a complex pair appears once, with a positive imaginary part.
#[derive(Serialize)]
struct ModeOutput {
    name: String,
    eigenvalue: Number,
    discrete_eigenvalue: Option<Number>,
    frequency_rad_s: f64,
    damping_ratio: f64,
    period_s: Option<f64>,
    time_constant_s: Option<f64>,
    time_to_half_or_double_s: f64,
    spread: Option<f64>,
}

/// How one transmissibility was identified.
#[derive(Serialize)]
struct TransmissibilityOutput<'a> {
    record: &'a str,
    input: &'a str,
    output: &'a str,
    rank: usize,
    parameters: usize,
    condition: f64,
    relative_residual: f64,
    realized_orders: [usize; 2],
    zeros: Vec<Number>,
    poles: Vec<Number>,
}

#[derive(Serialize)]
struct Warning {
    code: &'static str,
    text: String,
}

/// The JSON text, indented, with a line feed at its end.
pub(super) fn render(
    records: &[Record],
    result: &AsPrinted,
    found: &[Found],
    warnings: &[LoadWarning],
) -> Result<Vec<u8>, CommandError> {
    let doubts =
        result.doubts.iter().map(|doubt| Warning { code: code(doubt), text: doubt.to_string() });
    let output = Output {
        schema: 1,
        method: "as-printed",
        order: result.modes.len(),
        sample_period_s: result.period.seconds(),
        records: records
            .iter()
            .map(|record| RecordOutput { file: record.name(), samples: record.samples() })
            .collect(),
        modes: found.iter().map(mode).collect(),
        closest_refused: result.shared.closest_refused,
        transmissibilities: result.identifications.iter().map(transmissibility).collect(),
        warnings: warnings
            .iter()
            .map(|warning| Warning { code: warning.code(), text: warning.to_string() })
            .chain(doubts)
            .collect(),
    };
    let mut text = serde_json::to_vec_pretty(&output)
        .map_err(|error| CommandError::Write { file: "-".into(), source: error.into() })?;
    text.push(b'\n');
    Ok(text)
}

fn mode(found: &Found) -> ModeOutput {
    let mode = &found.mode.mode;
    ModeOutput {
        name: found.named.name.to_string(),
        eigenvalue: mode.eigenvalue.into(),
        discrete_eigenvalue: mode.discrete_eigenvalue.map(Number::from),
        frequency_rad_s: mode.natural_frequency_rad_s,
        damping_ratio: mode.damping_ratio,
        period_s: mode.period_s,
        time_constant_s: mode.time_constant_s,
        time_to_half_or_double_s: mode.time_to_half_or_double_s,
        spread: found.spread,
    }
}

fn transmissibility(identified: &Identification) -> TransmissibilityOutput<'_> {
    let fit = &identified.fit;
    let numbers = |values: &[Complex<f64>]| values.iter().map(|&value| value.into()).collect();
    TransmissibilityOutput {
        record: &identified.record,
        input: &identified.input,
        output: &identified.output,
        rank: fit.rank,
        parameters: fit.model.structure().parameter_count(),
        condition: fit.condition,
        relative_residual: fit.relative_residual,
        realized_orders: [
            identified.realization.causal.order,
            identified.realization.anticausal.order,
        ],
        zeros: numbers(&identified.zeros),
        poles: numbers(&identified.poles),
    }
}

fn code(doubt: &Doubt) -> &'static str {
    match doubt {
        Doubt::NoSharedZero => "no-shared-zero",
        Doubt::Noise { .. } => "noise",
        Doubt::NothingAboveNoise { .. } => "nothing-above-noise",
        Doubt::RankDeficient { .. } => "rank-deficient",
        Doubt::IllConditioned { .. } => "ill-conditioned",
        Doubt::Spread { .. } => "spread",
        _ => "other",
    }
}
