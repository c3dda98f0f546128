//! What the command line asks for, as options of the reconstruction.

use std::f64::consts::PI;
use std::num::NonZero;

use cfi_ident::{ConstantTerm, Orders, Structure};
use reconstruct::likelihood::{FrequencyBand, Hold};
use reconstruct::output_error::{self as recorded, Lag, RecordedInputs};
use reconstruct::subspace::OrderChoice;
use reconstruct::{Excitation, Method, NoiseModel, Offsets, Options, Record, Trend};

use crate::CommandError;
use crate::args::IdentifyArgs;
use crate::args::values::{
    ExcitationAsked, HoldAsked, LagAsked, MethodName, OffsetsAsked, OrderAsked, StructureAsked,
    threads_or_all,
};
use crate::error::OptionError;

/// Behind a decimation there is hardly any signal above this part of the Nyquist frequency, and the noise is not white.
const PASSED: f64 = 0.8;

/// Refuses options that the method does not know: they would be ignored without a word.
pub(super) fn check_method(args: &IdentifyArgs) -> Result<(), CommandError> {
    use MethodName::{AsPrinted, Ml, Subspace};
    const BOTH: &[MethodName] = &[Ml, Subspace];
    let deviations = matches!(args.offsets, Some(OffsetsAsked::Deviations(_)));
    let known: [(&'static str, bool, &[MethodName]); 20] = [
        ("--order", args.order.is_some(), BOTH),
        ("--offsets with deviations", deviations, &[Ml]),
        ("--offsets", args.offsets.is_some(), BOTH),
        ("--trend", args.trend.is_some(), &[Ml]),
        ("--hold", args.hold.is_some(), &[Ml]),
        ("--band", args.band.is_some(), &[Ml]),
        ("--feedthrough", !args.feedthrough.is_empty(), BOTH),
        ("--noise", !args.noise.is_empty(), BOTH),
        ("--white-noise", args.white_noise.is_some(), &[Ml]),
        ("--noise-record", args.noise_record.is_some(), BOTH),
        ("--inputs", !args.inputs.is_empty(), BOTH),
        ("--unknown-excitation", args.unknown_excitation.is_some(), &[Ml]),
        ("--structure", args.structure.is_some(), &[Ml]),
        ("--lag", !args.lag.is_empty(), &[Ml]),
        ("--validate", !args.validate.is_empty(), &[Ml]),
        ("--aircraft", args.aircraft.is_some(), &[Ml]),
        ("--threads", args.threads.is_some(), &[Ml]),
        ("--iir", args.iir.is_some(), &[AsPrinted]),
        ("--causal", args.causal.is_some(), &[AsPrinted]),
        ("--anticausal", args.anticausal.is_some(), &[AsPrinted]),
    ];
    let method = args.method();
    for (option, is_given, methods) in known {
        if is_given && !methods.contains(&method) {
            let owner = match methods {
                [one] => one.word(),
                _ => "ml or subspace",
            };
            return Err(OptionError::OtherMethod { option, owner, method: method.word() }.into());
        }
    }
    Ok(())
}

/// The options for these records, with the quiet record and the measured inputs that were read.
pub(super) fn options(
    args: &IdentifyArgs,
    decimation: NonZero<usize>,
    records: &[Record],
    noise: Option<Record>,
    known_inputs: Vec<Vec<Vec<f64>>>,
) -> Result<Options, CommandError> {
    let Some(record) = records.first() else { return Ok(Options::default()) };
    let sensors: Vec<String> =
        record.channels().iter().map(|channel| channel.name.clone()).collect();
    let mut options = Options::default();
    options.method = match args.method() {
        MethodName::Ml => Method::MaximumLikelihood,
        MethodName::Subspace => Method::Subspace,
        MethodName::AsPrinted => Method::Paper,
    };
    if let Some(OrderAsked::States(order)) = args.order {
        options.order = OrderChoice::Fixed(order);
    }
    options.measurement.offsets = match &args.offsets {
        None | Some(OffsetsAsked::Auto) => Offsets::AsNeeded,
        Some(OffsetsAsked::Zero) => Offsets::Zero,
        Some(OffsetsAsked::Free) => Offsets::Free,
        Some(OffsetsAsked::Deviations(deviations)) => {
            Offsets::PriorDeviation(match deviations[..] {
                [one] => vec![one; sensors.len()],
                _ => one_each("--offsets", deviations, &sensors)?,
            })
        }
    };
    options.measurement.trend = match args.trend {
        None => Trend::AsNeeded,
        Some(true) => Trend::Linear,
        Some(false) => Trend::Absent,
    };
    options.hold = match args.hold {
        None | Some(HoldAsked::Auto) => None,
        Some(HoldAsked::ZeroOrder) => Some(Hold::ZeroOrder),
        Some(HoldAsked::FirstOrder) => Some(Hold::FirstOrder),
    };
    options.profile = true;
    options.threads = threads_or_all(args.threads);
    // Recorded inputs have a band of their own, below what a decimation passes.
    options.band = band(args, decimation, record)?.filter(|_| {
        args.band.is_some() || excitation(args) == Excitation::Unrecorded || args.inputs.is_empty()
    });
    options.measurement.feedthrough_sensors = feedthrough(args, record, &sensors)?;
    options.noise = match noise {
        Some(quiet) => NoiseModel::Quiet(quiet),
        None if args.white_noise == Some(true) => NoiseModel::White,
        None if args.noise.is_empty() => NoiseModel::Estimated,
        None => NoiseModel::Levels(one_each("--noise", &args.noise, &sensors)?),
    };
    let names: Vec<String> = args.inputs.iter().map(|name| name.trim().to_owned()).collect();
    (options.sensor_lags, options.input_lags) = lags(args, &sensors, &names)?;
    options.inputs = RecordedInputs { names, signals: known_inputs };
    options.excitation = excitation(args);
    options.structure = match args.structure {
        None | Some(StructureAsked::Auto) => recorded::Structure::Automatic,
        Some(StructureAsked::BlackBox) => recorded::Structure::BlackBox,
        Some(StructureAsked::Lateral) => recorded::Structure::Lateral,
    };
    refuse_beside_recorded_inputs(args)?;
    let length = |given: Option<usize>, default: usize| given.unwrap_or(default);
    let orders =
        Orders::new(length(args.iir, 4), length(args.causal, 25), length(args.anticausal, 25))
            .map_err(|error| CommandError::Reconstruct(error.to_string()))?;
    options.paper.identification.structure = Structure::new(orders, ConstantTerm::Omitted);
    Ok(options)
}

/// The lag of each sensor and of each input; empty where none is late.
fn lags(
    args: &IdentifyArgs,
    sensors: &[String],
    inputs: &[String],
) -> Result<(Vec<Lag>, Vec<Lag>), CommandError> {
    const OPTION: &str = "--lag";
    if args.lag.is_empty() {
        return Ok((Vec::new(), Vec::new()));
    }
    let all: Vec<String> = sensors.iter().chain(inputs).cloned().collect();
    let mut lags: Vec<Option<Lag>> = vec![None; all.len()];
    for LagAsked { column, seconds } in &args.lag {
        let Some(index) = all.iter().position(|name| name == column) else {
            let (column, sensors) = (column.clone(), all);
            return Err(OptionError::NoSensor { option: OPTION, column, sensors }.into());
        };
        if lags[index].is_some() {
            return Err(OptionError::Twice { option: OPTION, column: column.clone() }.into());
        }
        lags[index] = Some(seconds.map_or(Lag::Free, Lag::Given));
    }
    let free = |lag: &Option<Lag>| *lag == Some(Lag::Free);
    if lags.iter().all(free) {
        let message =
            "not all sensors and inputs can be late by a lag that is estimated; leave one in time"
                .to_owned();
        return Err(OptionError::Refused { option: OPTION, message }.into());
    }
    let mut all = lags.into_iter().map(|lag| lag.unwrap_or(Lag::Given(0.0)));
    let of_sensors = all.by_ref().take(sensors.len()).collect();
    Ok((of_sensors, all.collect()))
}

/// What else than the recorded inputs may have excited the system. Who says what noise there is, leaves nothing to estimate from what recorded inputs leave
/// unexplained.
pub(super) fn excitation(args: &IdentifyArgs) -> Excitation {
    let has_noise =
        !args.noise.is_empty() || args.noise_record.is_some() || args.white_noise == Some(true);
    match args.unknown_excitation {
        Some(ExcitationAsked::No) => Excitation::Recorded,
        Some(ExcitationAsked::Yes) => Excitation::Unrecorded,
        None | Some(ExcitationAsked::Auto) if has_noise => Excitation::Unrecorded,
        None | Some(ExcitationAsked::Auto) if needs_inputs_alone(args).is_some() => {
            Excitation::Recorded
        }
        None | Some(ExcitationAsked::Auto) => Excitation::AsNeeded,
    }
}

/// An option that has a meaning only where the recorded inputs are all there was.
fn needs_inputs_alone(args: &IdentifyArgs) -> Option<&'static str> {
    let given = [
        ("--lag", !args.lag.is_empty()),
        ("--validate", !args.validate.is_empty()),
        ("--aircraft", args.aircraft.is_some()),
    ];
    given.into_iter().find(|(_, is_given)| *is_given).map(|(option, _)| option)
}

/// Refuses noise that is given where all inputs are recorded: there the disturbance is estimated from the residuals, whatever it is.
fn refuse_beside_recorded_inputs(args: &IdentifyArgs) -> Result<(), CommandError> {
    let given = [
        ("--noise", !args.noise.is_empty()),
        ("--noise-record", args.noise_record.is_some()),
        ("--white-noise", args.white_noise.is_some()),
    ];
    let given = given.iter().find(|(_, is_given)| *is_given);
    if let (Excitation::Unrecorded, Some(option)) = (excitation(args), needs_inputs_alone(args)) {
        let message = "it needs recorded inputs and nothing else that excites; leave it out, or --unknown-excitation yes and the noise".to_owned();
        return Err(OptionError::Refused { option, message }.into());
    }
    match given {
        Some((option, _)) if args.unknown_excitation == Some(ExcitationAsked::No) => {
            let message = "with --unknown-excitation no the disturbance is estimated from what the inputs leave unexplained, whatever its spectrum; leave one of both out"
                .to_owned();
            Err(OptionError::Refused { option, message }.into())
        }
        _ => Ok(()),
    }
}

fn one_each(
    option: &'static str,
    numbers: &[f64],
    sensors: &[String],
) -> Result<Vec<f64>, CommandError> {
    if numbers.len() == sensors.len() {
        return Ok(numbers.to_vec());
    }
    Err(OptionError::Count { option, found: numbers.len(), sensors: sensors.to_vec() }.into())
}

/// The band asked for; behind a decimation what its filter passes.
fn band(
    args: &IdentifyArgs,
    decimation: NonZero<usize>,
    record: &Record,
) -> Result<Option<FrequencyBand>, CommandError> {
    let nyquist_rad_s = PI / record.period().seconds();
    let decimated = decimation.get() > 1;
    let passed = if decimated { PASSED * nyquist_rad_s } else { nyquist_rad_s };
    let Some(band) = args.band else {
        let all = FrequencyBand { lowest_rad_s: 0.0, highest_rad_s: passed };
        return Ok((decimated && args.method() == MethodName::Ml).then_some(all));
    };
    let (lowest_rad_s, highest_rad_s) =
        (band.lowest.unwrap_or(0.0), band.highest.unwrap_or(passed));
    for (edge_rad_s, is_beyond) in [
        (lowest_rad_s, lowest_rad_s >= highest_rad_s.min(nyquist_rad_s)),
        (highest_rad_s, highest_rad_s > nyquist_rad_s * (1.0 + 1e-9)),
    ] {
        if is_beyond {
            return Err(OptionError::BandTooHigh { edge_rad_s, nyquist_rad_s }.into());
        }
    }
    Ok(Some(FrequencyBand { lowest_rad_s, highest_rad_s }))
}

fn feedthrough(
    args: &IdentifyArgs,
    record: &Record,
    sensors: &[String],
) -> Result<Vec<usize>, CommandError> {
    let option = "--feedthrough";
    let mut found = Vec::new();
    for column in &args.feedthrough {
        let column = column.trim().to_owned();
        match record.position(&column) {
            None => {
                let sensors = sensors.to_vec();
                return Err(OptionError::NoSensor { option, column, sensors }.into());
            }
            Some(index) if found.contains(&index) => {
                return Err(OptionError::Twice { option, column }.into());
            }
            Some(index) => found.push(index),
        }
    }
    Ok(found)
}
