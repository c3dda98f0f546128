//! The healthy record: transmissibilities from its first half, limits from its second.

use cfi_ident::{ConstantTerm, FitOptions, Orders, Segment, Structure};
use monitor::{Detector, Link, MonitorError, Options, Stretch};
use reconstruct::Record;

use super::model_file::ModelFile;
use crate::CommandError;
use crate::args::MonitorArgs;
use crate::numbers::{whole, without_rounding};
use crate::records::{Loaded, check_same_period};

/// Samples in a span where no other length is asked for.
const SPAN_SAMPLES: f64 = 50.0;

/// What new records are compared with.
#[derive(Debug)]
pub(super) struct Reference {
    pub(super) name: String,
    pub(super) samples: usize,
    pub(super) period_s: f64,
    pub(super) sensors: Vec<String>,
    pub(super) detector: Detector,
    /// Whether the models come from files.
    pub(super) given: bool,
    /// A model that was fitted to the reference itself.
    pub(super) fitted_to_itself: bool,
}

impl Reference {
    pub(super) fn span_s(&self) -> f64 {
        self.period_s * self.detector.options().window as f64
    }

    /// The time of a sample of a record that starts then, without what rounding adds.
    pub(super) fn time(&self, start_s: f64, sample: usize) -> f64 {
        without_rounding(start_s + self.period_s * sample as f64)
    }

    /// How many healthy spans raise an alarm in an hour.
    pub(super) fn false_alarms_per_hour(&self) -> f64 {
        self.detector.options().false_alarms * 3600.0 / self.span_s()
    }

    /// The two sensors of each transmissibility.
    pub(super) fn pairs(&self) -> impl Iterator<Item = [&str; 2]> {
        self.detector.links().iter().map(|link| [self.sensor(link.input), self.sensor(link.output)])
    }

    pub(super) fn sensor(&self, index: usize) -> &str {
        self.sensors.get(index).map_or("", String::as_str)
    }

    /// Refuses a record of other sensors or another sample period.
    pub(super) fn check(&self, record: &Record) -> Result<(), CommandError> {
        let fault = |message| Err(CommandError::InFile { file: record.name().into(), message });
        let names = names(record);
        if names != self.sensors {
            return fault(format!(
                "it has the sensors {}, and the reference has {}; choose the same ones with --outputs",
                names.join(", "),
                self.sensors.join(", ")
            ));
        }
        check_same_period(record.period().seconds(), self.period_s, "the reference").or_else(fault)
    }
}

/// Fits, unless there are models, and calibrates.
pub(super) fn calibrate(
    args: &MonitorArgs,
    healthy: Loaded,
    models: &[ModelFile],
) -> Result<Reference, CommandError> {
    let fault = |message: String| CommandError::InFile { file: args.reference.clone(), message };
    let records = healthy.records;
    let Some(first) = records.first() else {
        return Err(fault("it holds no samples".to_owned()));
    };
    let (period_s, sensors) = (first.period().seconds(), names(first));
    if sensors.len() < 2 {
        return Err(fault("it has one sensor, and a transmissibility relates two".to_owned()));
    }
    let span = args.span.map_or(SPAN_SAMPLES, |span_s| (span_s / period_s).round());
    let Some(window) = whole(span).filter(|window| *window >= 2) else {
        return Err(fault(format!(
            "a span of {} s is {span} of its samples of {period_s} s; 2 to 1000000000 are possible: change --span",
            args.span.unwrap_or_default()
        )));
    };
    let false_alarms = args.false_alarms.per_span(span * period_s);
    if false_alarms >= 0.5 {
        return Err(fault(format!(
            "--false-alarms asks for a chance of {false_alarms} in a span of {} s; less than 1/2 is needed",
            span * period_s
        )));
    }
    let channels: Vec<Vec<Vec<f64>>> = records.iter().map(marked).collect();
    let whole: Vec<Stretch<'_>> = channels.iter().map(|record| stretch(record)).collect();
    let (training, calibrating) = halves(&whole);
    let links = if models.is_empty() {
        fit(args, &training, sensors.len()).map_err(fault)?
    } else {
        models.iter().map(|model| model.link(&sensors, period_s)).collect::<Result<Vec<_>, _>>()?
    };
    let fitted_to_itself =
        models.iter().zip(&links).any(|(model, link)| model.was_fitted_to(link, &whole));
    let options = Options { window, false_alarms };
    let detector = Detector::calibrate(links, &training, &calibrating, options)
        .map_err(|error| fault(match error {
            MonitorError::TooFewWindows { found, needed, .. } => format!(
                "its second half holds {found} spans of {} s, and {needed} are needed to calibrate; give a longer reference or a shorter --span",
                span * period_s
            ),
            other => other.to_string(),
        }))?;
    let short = args.reference.file_name().unwrap_or_default().to_string_lossy().into_owned();
    Ok(Reference {
        fitted_to_itself,
        name: short,
        samples: records.iter().map(Record::samples).sum(),
        period_s,
        sensors,
        detector,
        given: !models.is_empty(),
    })
}

/// A transmissibility from the first sensor to each of the others.
fn fit(args: &MonitorArgs, training: &[Stretch<'_>], sensors: usize) -> Result<Vec<Link>, String> {
    let orders = Orders::new(args.iir, args.causal, args.anticausal).map_err(|e| e.to_string())?;
    let structure = Structure::new(orders, ConstantTerm::Omitted);
    let link = |output: usize| {
        let segments = training
            .iter()
            .flat_map(monitor::complete)
            .map(|stretch| Segment::new(stretch[0], stretch[output]))
            .collect::<Result<Vec<_>, _>>()
            .map_err(|error| error.to_string())?;
        let fit = cfi_ident::fit(&segments, &structure, &FitOptions::default())
            .map_err(|error| format!("its first half, to which the models are fitted: {error}"))?;
        Ok(Link { model: fit.model, input: 0, output })
    };
    (1..sensors).map(link).collect()
}

/// The first and the second half of all samples.
fn halves<'a>(records: &[Stretch<'a>]) -> (Vec<Stretch<'a>>, Vec<Stretch<'a>>) {
    let samples = |record: &Stretch<'_>| record.first().map_or(0, |channel| channel.len());
    let mut left = records.iter().map(samples).sum::<usize>() / 2;
    let (mut first, mut second) = (Vec::new(), Vec::new());
    for record in records {
        let at = left.min(samples(record));
        left -= at;
        let (early, late): (Stretch<'_>, Stretch<'_>) =
            record.iter().map(|values| values.split_at(at)).unzip();
        for (part, half) in [(early, &mut first), (late, &mut second)] {
            if part.first().is_some_and(|values| !values.is_empty()) {
                half.push(part);
            }
        }
    }
    (first, second)
}

/// The channels of a record, NaN where a sample is missing.
pub(super) fn marked(record: &Record) -> Vec<Vec<f64>> {
    record.marked().into_iter().map(|channel| channel.values).collect()
}

pub(super) fn stretch(channels: &[Vec<f64>]) -> Stretch<'_> {
    channels.iter().map(Vec::as_slice).collect()
}

fn names(record: &Record) -> Vec<String> {
    record.channels().iter().map(|channel| channel.name.clone()).collect()
}
