//! The result as JSON: a stable form for other programs, which docs/identify.schema.json describes.

mod form;
mod paper;
mod recorded;

use reconstruct::likelihood::{ComplexEstimate, Estimate, Hold, NearDouble, SearchStatus};
use reconstruct::subspace::OrderEvidence;
use reconstruct::{ComparedOrder, Offsets, Trend, likelihood};
use serde::Serialize;

use super::doubts;
use super::outcome::Outcome;
use crate::CommandError;
use crate::inspect::Cause;
use crate::json::{self, Number};
use crate::modes::IdentifiedMode;
use crate::records::clock::Clock;
use form::FormOutput;
use paper::TransmissibilityOutput;
use recorded::RecordedOutput;

#[derive(Serialize)]
struct Output<'a> {
    schema: u32,
    method: &'static str,
    order: usize,
    order_evidence: Option<OrderOutput>,
    sample_period_s: f64,
    /// Every how many samples of the files one is kept.
    decimation: usize,
    channels: Vec<&'a str>,
    records: Vec<RecordOutput<'a>>,
    modes: Vec<ModeOutput>,
    noise: Vec<NoiseOutput<'a>>,
    noise_origin: Option<&'static str>,
    model_error: Option<ModelErrorOutput>,
    offsets: Option<&'static str>,
    /// What each sensor adds to its readings, taken as common to all records.
    offset_values: Vec<OffsetOutput<'a>>,
    drift: Option<bool>,
    band_rad_s: Option<[f64; 2]>,
    hold: Option<HoldOutput>,
    goodness: GoodnessOutput,
    search: Option<SearchOutput>,
    /// Smallest spread of a group of zeros that the paper's method refused as a mode.
    closest_refused: Option<f64>,
    transmissibilities: Option<Vec<TransmissibilityOutput<'a>>>,
    form: Option<FormOutput<'a>>,
    recorded_inputs: Option<RecordedOutput<'a>>,
    warnings: Vec<Warning>,
}

/// The part of what the sensors read that no linear system explains.
#[derive(Serialize)]
struct ModelErrorOutput {
    value: f64,
    deviation: f64,
}

/// How the excitation moves between samples.
#[derive(Serialize)]
struct HoldOutput {
    order: u8,
    /// Minus twice the logarithm of the other hold's likelihood over this one's; none where the hold was given.
    evidence: Option<f64>,
}

#[derive(Serialize)]
struct OrderOutput {
    asked: bool,
    gap: f64,
    gaps: Vec<GapOutput>,
    compared: Vec<ComparedOutput>,
}

#[derive(Serialize)]
struct ComparedOutput {
    order: usize,
    above: f64,
}

#[derive(Serialize)]
struct GapOutput {
    order: usize,
    gap: f64,
}

#[derive(Serialize)]
struct RecordOutput<'a> {
    file: &'a str,
    samples: usize,
    bridged_rows: usize,
    excitation_rank: Option<usize>,
    /// Probability of residuals as little white by chance.
    chi2_per_dof: Option<f64>,
    whiteness_p_value: Option<f64>,
    clock: ClockOutput,
}

/// Where the sample period of a record comes from.
#[derive(Serialize)]
struct ClockOutput {
    basis: &'static str,
    fitted_period_s: Option<f64>,
    largest_deviation_s: Option<f64>,
}

/// A mode; a complex pair appears once, with a positive imaginary part.
#[derive(Serialize)]
struct ModeOutput {
    name: String,
    eigenvalue: Number,
    deviation: Option<Number>,
    /// Of a real eigenvalue, from the likelihood itself.
    eigenvalue_interval_95: Option<[Option<f64>; 2]>,
    discrete_eigenvalue: Option<Number>,
    frequency_rad_s: f64,
    frequency_interval_95_rad_s: Option<[f64; 2]>,
    damping_ratio: f64,
    damping_ratio_interval_95: Option<[f64; 2]>,
    period_s: Option<f64>,
    time_constant_s: Option<f64>,
    time_constant_interval_95_s: Option<[f64; 2]>,
    time_to_half_or_double_s: f64,
    level: Option<String>,
    shape: Vec<Number>,
    strength: Vec<f64>,
    spread: Option<f64>,
    near_double: Option<NearDoubleOutput>,
}

/// Another eigenvalue from which the records hardly tell this one, and what they tell of the two.
#[derive(Serialize)]
struct NearDoubleOutput {
    partner: Number,
    mean: Number,
    mean_deviation: Number,
    half_difference_squared: Number,
    half_difference_squared_deviation: Number,
}

#[derive(Serialize)]
struct NoiseOutput<'a> {
    channel: &'a str,
    /// The level: a standard deviation.
    deviation: f64,
    /// How uncertain the level itself is.
    level_deviation: Option<f64>,
    unit: Option<&'static str>,
}

#[derive(Serialize)]
struct OffsetOutput<'a> {
    channel: &'a str,
    value: f64,
    deviation: f64,
    unit: Option<&'static str>,
}

#[derive(Serialize)]
struct GoodnessOutput {
    chi2_per_dof: Option<f64>,
    p_value: Option<f64>,
}

#[derive(Serialize)]
struct SearchOutput {
    status: &'static str,
    steps: usize,
    evaluations: usize,
    starts: usize,
}

#[derive(Serialize)]
struct Warning {
    code: &'static str,
    text: String,
    /// What is odd about the sensors, where it is a doubt.
    causes: Vec<CauseOutput>,
}

#[derive(Serialize)]
struct CauseOutput {
    code: &'static str,
    record: String,
    channel: String,
    text: String,
}

/// The JSON text, indented, with a line feed at its end.
pub(super) fn render(outcome: &Outcome<'_>) -> Result<Vec<u8>, CommandError> {
    let result = outcome.result;
    let solution = result.paper();
    let fit = result.fit();
    let output_error = result.output_error();
    let doubts = doubts::said(outcome);
    let cause = |cause: Cause| CauseOutput {
        code: cause.code,
        record: cause.record,
        channel: cause.column,
        text: cause.text,
    };
    let doubts = doubts.into_iter().map(|doubt| Warning {
        code: doubt.code,
        text: doubt.text,
        causes: doubt.causes.into_iter().map(cause).collect(),
    });
    let warnings = outcome.warnings.iter();
    let output = Output {
        schema: 1,
        method: if output_error.is_some() { "output-error" } else { outcome.method.word() },
        order: result.order().map_or_else(
            || {
                output_error.map_or_else(
                    || solution.map_or(0, |solution| solution.modes.len()),
                    |fit| fit.model.a().nrows(),
                )
            },
            |evidence| evidence.order,
        ),
        order_evidence: result.order().map(|evidence| order(evidence, result.compared_orders())),
        sample_period_s: outcome.records.first().map_or(0.0, |record| record.period().seconds()),
        decimation: outcome.decimation.get(),
        channels: channels(outcome),
        records: records(outcome),
        modes: outcome.found.iter().map(|found| mode(outcome, found)).collect(),
        noise: noise(outcome),
        noise_origin: outcome.noise_origin(),
        model_error: fit
            .and_then(|fit| fit.model_error)
            .or_else(|| output_error.map(|fit| fit.model_error))
            .map(|error| ModelErrorOutput { value: error.value, deviation: error.standard_error }),
        offsets: fit
            .map(|fit| match fit.options.measurement.offsets {
                Offsets::Free => "free",
                Offsets::PriorDeviation(_) => "prior",
                _ => "zero",
            })
            .or_else(|| output_error.map(|_| "free")),
        offset_values: offsets(outcome),
        drift: fit
            .map(|fit| fit.options.measurement.trend == Trend::Linear)
            .or_else(|| output_error.map(|fit| fit.drift)),
        band_rad_s: fit
            .and_then(|fit| fit.options.band)
            .or_else(|| output_error.map(|fit| fit.band))
            .map(|band| [band.lowest_rad_s, band.highest_rad_s]),
        hold: fit
            .map(|fit| hold(fit.hold, fit.hold_evidence))
            .or_else(|| output_error.map(|fit| hold(fit.hold, fit.hold_evidence))),
        goodness: GoodnessOutput {
            chi2_per_dof: fit.map(|fit| fit.chi_squared.per_degree_of_freedom()),
            p_value: fit.and_then(|fit| fit.chi_squared.p_value),
        },
        search: fit.map(search),
        closest_refused: solution.and_then(|solution| solution.shared.closest_refused),
        transmissibilities: solution.map(paper::transmissibilities),
        form: form::form(outcome),
        recorded_inputs: recorded::recorded(outcome),
        warnings: warnings
            .map(|warning| Warning {
                code: warning.code(),
                text: warning.to_string(),
                causes: Vec::new(),
            })
            .chain(doubts)
            .collect(),
    };
    json::text(&output)
}

fn order(evidence: &OrderEvidence, compared: &[ComparedOrder]) -> OrderOutput {
    let gaps = evidence.gaps.iter().map(|&(order, gap)| GapOutput { order, gap });
    let compared =
        compared.iter().map(|other| ComparedOutput { order: other.order, above: other.above });
    OrderOutput {
        asked: evidence.asked,
        gap: evidence.gap,
        gaps: gaps.collect(),
        compared: compared.collect(),
    }
}

fn channels<'a>(outcome: &Outcome<'a>) -> Vec<&'a str> {
    let first = outcome.records.first().map_or(&[][..], |record| record.channels());
    first.iter().map(|channel| channel.name.as_str()).collect()
}

fn records<'a>(outcome: &Outcome<'a>) -> Vec<RecordOutput<'a>> {
    let (excitations, whiteness) = (outcome.result.excitations(), outcome.result.whiteness());
    let sizes = outcome.result.fit().map_or(&[][..], |fit| &fit.record_chi_squared);
    let record = |(index, record): (usize, &'a reconstruct::Record)| RecordOutput {
        file: record.name(),
        samples: record.samples(),
        bridged_rows: outcome.sources.get(index).map_or(0, |source| source.bridged),
        excitation_rank: excitations.get(index).map(|excitation| excitation.rank),
        chi2_per_dof: sizes.get(index).copied(),
        whiteness_p_value: whiteness.get(index).map(|test| test.p_value),
        clock: outcome.sources.get(index).map_or(Clock::GIVEN, |source| source.clock).into(),
    };
    outcome.records.iter().enumerate().map(record).collect()
}

impl From<Clock> for ClockOutput {
    fn from(clock: Clock) -> Self {
        Self {
            basis: clock.word(),
            fitted_period_s: clock.fitted_period_s,
            largest_deviation_s: clock.largest_deviation_s,
        }
    }
}

fn mode(outcome: &Outcome<'_>, found: &IdentifiedMode) -> ModeOutput {
    let (mode, estimate) = (&found.mode.mode, found.mode.estimate.as_ref());
    let interval = |estimate: &Estimate| estimate.interval_95();
    ModeOutput {
        name: found.named.name.to_string(),
        eigenvalue: mode.eigenvalue.into(),
        deviation: estimate.map(|estimate| Number {
            re: estimate.continuous.real_standard_error(),
            im: estimate.continuous.imaginary_standard_error(),
        }),
        eigenvalue_interval_95: found
            .mode
            .interval_95
            .map(|interval| interval.map(|end| end.is_finite().then_some(end))),
        discrete_eigenvalue: mode.discrete_eigenvalue.map(Number::from),
        frequency_rad_s: mode.natural_frequency_rad_s,
        frequency_interval_95_rad_s: estimate
            .map(|estimate| interval(&estimate.natural_frequency_rad_s)),
        damping_ratio: mode.damping_ratio,
        damping_ratio_interval_95: estimate.map(|estimate| interval(&estimate.damping_ratio)),
        period_s: mode.period_s,
        time_constant_s: mode.time_constant_s,
        time_constant_interval_95_s: found.time_constant_interval_95(),
        time_to_half_or_double_s: mode.time_to_half_or_double_s,
        level: outcome.level(found).map(|level| level.to_string()),
        shape: found.shape.iter().map(|&part| part.into()).collect(),
        strength: found.mode.excitation_snr.clone(),
        spread: found.spread,
        near_double: estimate.and_then(|estimate| estimate.near_double).map(NearDoubleOutput::from),
    }
}

impl From<NearDouble> for NearDoubleOutput {
    fn from(double: NearDouble) -> Self {
        let deviation = |estimate: &ComplexEstimate| Number {
            re: estimate.real_standard_error(),
            im: estimate.imaginary_standard_error(),
        };
        Self {
            partner: double.partner.into(),
            mean: double.mean.value.into(),
            mean_deviation: deviation(&double.mean),
            half_difference_squared: double.half_difference_squared.value.into(),
            half_difference_squared_deviation: deviation(&double.half_difference_squared),
        }
    }
}

fn noise<'a>(outcome: &Outcome<'a>) -> Vec<NoiseOutput<'a>> {
    let estimated = outcome.noise_origin() == Some("estimated");
    let likelihood = outcome.result.fit().is_some();
    let Some(first) = outcome.records.first() else { return Vec::new() };
    let levels = outcome.result.noise_levels().unwrap_or_default();
    first
        .channels()
        .iter()
        .zip(levels)
        .enumerate()
        .map(|(index, (channel, level))| NoiseOutput {
            channel: &channel.name,
            deviation: level.value,
            level_deviation: (estimated && likelihood).then_some(level.standard_error),
            unit: outcome.unit(index),
        })
        .collect()
}

fn offsets<'a>(outcome: &Outcome<'a>) -> Vec<OffsetOutput<'a>> {
    let offsets = outcome.result.offsets().iter().enumerate();
    channels(outcome)
        .into_iter()
        .zip(offsets)
        .map(|(channel, (index, offset))| OffsetOutput {
            channel,
            value: offset.value,
            deviation: offset.standard_error,
            unit: outcome.unit(index),
        })
        .collect()
}

fn hold(hold: Hold, evidence: Option<f64>) -> HoldOutput {
    let order = if hold == Hold::FirstOrder { 1 } else { 0 };
    HoldOutput { order, evidence }
}

fn search(fit: &likelihood::Fit) -> SearchOutput {
    SearchOutput {
        status: match fit.search.status {
            SearchStatus::Converged => "converged",
            SearchStatus::AtRoundingLevel => "at-rounding-level",
            _ => "not-converged",
        },
        steps: fit.search.steps,
        evaluations: fit.search.evaluations,
        starts: fit.starts.len(),
    }
}
