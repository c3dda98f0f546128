//! Everything that is read before anything is computed: records, measured inputs, the quiet record; and what gaps make of them.

use std::num::NonZero;

use reconstruct::{Excitation, ReconstructError, Record};

use super::options;
use crate::CommandError;
use crate::args::IdentifyArgs;
use crate::args::values::{MethodName, QuietFile};
use crate::error::{OptionError, in_file};
use crate::inspect::{Cause, causes};
use crate::records::bridging::Bridge;
use crate::records::copies::copies;
use crate::records::{self, LoadOptions, LoadWarning, Loaded, Progress, Source};

/// What the methods are given.
#[derive(Debug)]
pub(super) struct Input {
    pub(super) records: Vec<Record>,
    /// One for each record.
    pub(super) sources: Vec<Source>,
    /// For each record its measured inputs; empty where there are none at all.
    pub(super) known_inputs: Vec<Vec<Vec<f64>>>,
    pub(super) noise: Option<Record>,
    /// Every how many samples of the files one is kept.
    pub(super) decimation: NonZero<usize>,
    /// What is odd about the sensors.
    pub(super) causes: Vec<Cause>,
    pub(super) warnings: Vec<LoadWarning>,
}

/// Reads all files and refuses what cannot be used.
pub(super) fn read(args: &IdentifyArgs, progress: Progress) -> Result<Input, CommandError> {
    let mut options = args.files.options();
    options.known_inputs = args.inputs.iter().map(|name| name.trim().to_owned()).collect();
    options.bridge = bridge(args);
    let (loaded, causes) = load(args, &mut options, progress)?;
    let Loaded { records, sources, known_inputs, warnings, .. } = loaded;
    let decimation = options.decimate;
    let noise = None;
    let mut input = Input { records, sources, known_inputs, noise, decimation, causes, warnings };
    leave_out_copies(&mut input, &args.files.outputs)?;
    check_number(args, &input)?;
    if args.method() == MethodName::AsPrinted {
        keep_longest(&mut input);
    }
    let unrecorded = !takes_inputs_alone(args);
    leave_out_idle(&mut input, &options.known_inputs, unrecorded)?;
    if let Some(file) = &args.noise_record {
        let noise = quiet(file, &options, &mut input, progress)?;
        input.noise = Some(noise);
    }
    Ok(input)
}

/// Reads the records with what is odd about their sensors, and decimates them: if nobody said whether to, where they are sampled far faster than anything in them moves.
///
/// A recorded input would be neither held nor straight between the samples that are left, and the printed method knows of no noise: there all samples stay.
fn load(
    args: &IdentifyArgs,
    options: &mut LoadOptions,
    progress: Progress,
) -> Result<(Loaded, Vec<Cause>), CommandError> {
    let files = &args.files.files;
    let asked = args.files.decimate;
    let is_free =
        asked.is_none() && args.inputs.is_empty() && args.method() != MethodName::AsPrinted;
    let is_asked = asked.is_some_and(|factor| factor.get() > 1);
    // Interpolated samples are no unknowns.
    let most_missing = if is_free || is_asked { usize::MAX } else { options.most_missing };
    let whole = NonZero::<usize>::MIN;
    let all = LoadOptions { most_missing, decimate: whole, ..options.clone() };
    let mut loaded = records::load(files, &all, progress)?;
    let mut causes = odd_sensors(&loaded);
    if is_free {
        options.decimate = loaded.decimate_if_oversampled()?;
        let missing = loaded.records.iter().map(Record::missing_rows).max().unwrap_or(0);
        if missing > options.most_missing {
            loaded = records::load(files, options, progress)?;
            causes = odd_sensors(&loaded);
        }
    } else {
        loaded.decimate(options.decimate)?;
    }
    Ok((loaded, causes))
}

fn odd_sensors(loaded: &Loaded) -> Vec<Cause> {
    let all = loaded.records.iter().zip(&loaded.sources);
    all.flat_map(|(record, source)| causes(record, &source.units, source.span_s[0])).collect()
}

/// Which gaps are missing samples of one record.
pub(super) fn bridge(args: &IdentifyArgs) -> Bridge {
    // The printed method fits each record without noise, so that it asks for samples without gaps.
    match args.method() {
        MethodName::AsPrinted => Bridge::Never,
        _ => args.bridge.map_or(Bridge::Usual, Bridge::UpTo),
    }
}

/// Leaves out sensors that are multiples of others, which say nothing and would make noise look
/// known exactly; refuses them where they were asked for.
fn leave_out_copies(input: &mut Input, asked: &[String]) -> Result<(), CommandError> {
    check_channels(&input.records)?;
    fn values(record: &Record) -> Vec<&[f64]> {
        record.channels().iter().map(|channel| channel.values.as_slice()).collect()
    }
    let copies = copies(&input.records.iter().map(values).collect::<Vec<_>>());
    let Some(first) = input.records.first() else { return Ok(()) };
    let name = |index: usize| first.channels()[index].name.clone();
    if let (Some(found), false) = (copies.first(), asked.is_empty()) {
        let [copy, original] = [found.copy, found.original].map(name);
        return Err(OptionError::Copy { copy, original, factor: found.factor }.into());
    }
    let warnings: Vec<LoadWarning> = copies
        .iter()
        .map(|found| LoadWarning::CopyLeftOut {
            column: name(found.copy),
            other: name(found.original),
            factor: found.factor,
        })
        .collect();
    if copies.is_empty() {
        return Ok(());
    }
    input.warnings.extend(warnings);
    let is_kept = |index: usize| !copies.iter().any(|found| found.copy == index);
    for (record, source) in input.records.iter_mut().zip(&mut input.sources) {
        let channels = record.marked().into_iter().enumerate();
        let kept = channels.filter(|(index, _)| is_kept(*index)).map(|(_, channel)| channel);
        *record = Record::with_missing(record.name(), record.period(), kept.collect())
            .map_err(|error| in_file(&source.file, &error))?;
        let units = std::mem::take(&mut source.units).into_iter().enumerate();
        source.units = units.filter(|(index, _)| is_kept(*index)).map(|(_, unit)| unit).collect();
    }
    Ok(())
}

/// Refuses fewer excitations than the method needs. The stretches between the gaps of one record are taken to have one excitation.
fn check_number(args: &IdentifyArgs, input: &Input) -> Result<(), CommandError> {
    let method = args.method();
    let sensors = input.records.first().map_or(0, |record| record.channels().len());
    check_channels(&input.records)?;
    if takes_inputs_alone(args) {
        return Ok(());
    }
    let found = input.sources.last().map_or(0, |last| last.whole + 1);
    let fewest = if method == MethodName::AsPrinted { 3 } else { 2 };
    if sensors < fewest {
        return Err(OptionError::TooFewSensors { sensors, needed: fewest }.into());
    }
    // J (m - 1) > m.
    let needed = if sensors == 2 { 3 } else { 2 };
    if found >= needed {
        return Ok(());
    }
    let split = input.sources.windows(2).zip(&input.records).find_map(|(pair, record)| {
        (pair[0].whole == pair[1].whole).then(|| whole_name(record).to_owned())
    });
    Err(OptionError::TooFewRecords { found, needed, sensors, split }.into())
}

/// Refuses records of different sensors: their number alone would be misleading.
fn check_channels(records: &[Record]) -> Result<(), CommandError> {
    let names = |record: &Record| -> Vec<String> {
        record.channels().iter().map(|channel| channel.name.clone()).collect()
    };
    let Some(first) = records.first() else { return Ok(()) };
    let Some(second) = records.iter().find(|record| names(record) != names(first)) else {
        return Ok(());
    };
    let error = ReconstructError::DifferentChannels {
        first: first.name().to_owned(),
        expected: names(first).join(", "),
        second: second.name().to_owned(),
        found: names(second).join(", "),
    };
    Err(CommandError::Reconstruct(format!("{error}; choose them with --outputs")))
}

/// The name of the record that gaps split.
fn whole_name(record: &Record) -> &str {
    record.name().rsplit_once('#').map_or(record.name(), |(whole, _)| whole)
}

/// The paper's method compares records with each other, and those of one excitation are equal to it: of each record it takes the longest stretch.
fn keep_longest(input: &mut Input) {
    let wholes = input.sources.last().map_or(0, |last| last.whole + 1);
    let mut kept = Vec::new();
    for whole in 0..wholes {
        let stretches =
            || (0..input.records.len()).filter(|&index| input.sources[index].whole == whole);
        // The first of equally long ones.
        let samples = |index: &usize| input.records[*index].samples();
        let Some(longest) = stretches().rev().max_by_key(samples) else { continue };
        let (count, total) = (stretches().count(), stretches().map(|k| samples(&k)).sum());
        if count > 1 {
            input.warnings.push(LoadWarning::LongestStretch {
                record: input.records[longest].name().to_owned(),
                samples: samples(&longest),
                total,
            });
        }
        kept.push(longest);
    }
    keep(&mut input.records, &kept);
    keep(&mut input.sources, &kept);
    keep(&mut input.known_inputs, &kept);
}

fn keep<T>(items: &mut Vec<T>, kept: &[usize]) {
    let mut next = 0..items.len();
    items.retain(|_| next.next().is_some_and(|index| kept.contains(&index)));
}

/// Whether the recorded inputs may be all that moved the system: then one record is enough.
pub(super) fn takes_inputs_alone(args: &IdentifyArgs) -> bool {
    args.method() == MethodName::Ml
        && !args.inputs.is_empty()
        && options::excitation(args) != Excitation::Unrecorded
}

/// Refuses recorded inputs that are constant in all records. Beside something that was not recorded, one that is constant in some of them, but not zero,
/// is refused as well. Where an input rests it is set to zero.
fn leave_out_idle(
    input: &mut Input,
    names: &[String],
    unrecorded: bool,
) -> Result<(), CommandError> {
    if names.is_empty() {
        input.known_inputs.clear();
        return Ok(());
    }
    for (position, column) in names.iter().enumerate() {
        let value = |signal: &[f64]| {
            let first = signal.first().copied()?;
            // Minus zero is zero.
            signal.iter().all(|value| (value - first).abs() <= 0.0).then_some(first + 0.0)
        };
        let constants: Vec<_> =
            input.known_inputs.iter().map(|list| value(&list[position])).collect();
        let rests_always = constants.iter().all(Option::is_some);
        for (index, constant) in constants.iter().enumerate() {
            let record = input.records[index].name().to_owned();
            match constant {
                Some(value) if rests_always || (unrecorded && value.abs() > 0.0) => {
                    let column = column.clone();
                    return Err(OptionError::ConstantInput { column, record, value: *value }.into());
                }
                Some(_) => {
                    input.known_inputs[index][position].fill(0.0);
                    // Of its stretches only once, and not where the file has no such column.
                    let whole = whole_name(&input.records[index]).to_owned();
                    let missing = input.warnings.iter().any(|warning| {
                        matches!(warning, LoadWarning::InputMissing { file, column: own } if whole.starts_with(file.as_str()) && own == column)
                    });
                    let warning = LoadWarning::IdleInput { record: whole, column: column.clone() };
                    if !missing && !input.warnings.contains(&warning) {
                        input.warnings.push(warning);
                    }
                }
                None => {}
            }
        }
    }
    Ok(())
}

/// Reads the quiet record with the sensors of the others.
fn quiet(
    file: &QuietFile,
    options: &LoadOptions,
    input: &mut Input,
    progress: Progress,
) -> Result<Record, CommandError> {
    let mut options = LoadOptions {
        known_inputs: Vec::new(),
        // What its spectrum is estimated from leaves the missing samples out, however many there are.
        most_missing: usize::MAX,
        ..options.clone()
    };
    if let Some(record) = input.records.first() {
        let names = record.channels().iter().map(|channel| channel.name.clone());
        options.selection.outputs = names.collect();
    }
    let files = match file {
        QuietFile::Whole(file) => {
            options.windows.clear();
            vec![file.clone()]
        }
        QuietFile::Stretch(window) => {
            options.windows = vec![window.clone()];
            Vec::new()
        }
    };
    let Loaded { records, sources, warnings, .. } = records::load(&files, &options, progress)?;
    let (samples, total) = (
        records.iter().map(Record::samples).max().unwrap_or(0),
        records.iter().map(Record::samples).sum(),
    );
    input.warnings.extend(warnings);
    let longest = records.iter().zip(&sources).find(|(record, _)| record.samples() == samples);
    let Some((record, source)) = longest else {
        return Err(CommandError::InFile {
            file: file.path().clone(),
            message: "it holds no samples".to_owned(),
        });
    };
    if records.len() > 1 {
        let record = record.name().to_owned();
        input.warnings.push(LoadWarning::LongestStretch { record, samples, total });
    }
    check_length(record)?;
    let overlaps = |other: &Source| {
        records::is_same_file(&other.file, &source.file)
            && other.span_s[0] <= source.span_s[1]
            && source.span_s[0] <= other.span_s[1]
    };
    if let Some(index) = input.sources.iter().position(overlaps) {
        let (noise, record) = (record.name().to_owned(), input.records[index].name().to_owned());
        return Err(OptionError::NoiseOverlaps { noise, record }.into());
    }
    // The clocks of two loggers, or stamps that are rounded.
    if let Some(period_s) = input.records.first().map(|first| first.period().seconds())
        && records::is_near_period(record.period().seconds(), period_s)
    {
        return records::with_period(record, period_s)
            .map_err(|error| in_file(&source.file, &*error));
    }
    Ok(record.clone())
}

/// Refuses a quiet record that no spectrum can be had from.
fn check_length(record: &Record) -> Result<(), CommandError> {
    /// Equations for each unknown of the shortest autoregression.
    const EQUATIONS: usize = 10;
    let (found, sensors) = (record.samples(), record.channels().len());
    let needed = records::SHORTEST.max(EQUATIONS * sensors + 1);
    if found >= needed {
        return Ok(());
    }
    Err(OptionError::NoiseTooShort { noise: record.name().to_owned(), found, needed }.into())
}
