//! The way from files to records.

use std::ops::Range;
use std::path::{Path, PathBuf};

use lti::SamplePeriod;
use reconstruct::{Channel, Record};

use super::bridging::{Stretch, stretches};
use super::clock::Clock;
use super::common_period;
use super::known_inputs;
use super::notes;
use super::open::open;
use super::options::{Angles, LoadOptions, Window};
use super::progress::Progress;
use super::resampling;
use super::same_units;
use super::segments::SHORTEST;
use super::selection::{Selected, Selection};
use super::source::Source;
use super::table::{Opened, Table};
use super::timing::{Steps, Times, scale, shift};
use super::warning::LoadWarning;
use crate::CommandError;
use crate::error::{SelectionError, in_file};
use crate::numbers::without_rounding;

/// Records and where they come from.
#[derive(Debug)]
pub(crate) struct Loaded {
    /// In the order of the files; the windows of a file, and its stretches between gaps, in their own order.
    pub(crate) records: Vec<Record>,
    /// One for each record.
    pub(crate) sources: Vec<Source>,
    /// For each record the measured inputs, in the order in which they were asked for.
    pub(crate) known_inputs: Vec<Vec<Vec<f64>>>,
    pub(crate) warnings: Vec<LoadWarning>,
    /// For each file and measured input the reason why the file has no such column, if it has none.
    missing_inputs: Vec<Vec<Option<CommandError>>>,
}

/// Reads the records in `files`, and those in windows of files that are not among them.
///
/// # Errors
///
/// Whatever is wrong with the first file that is at fault: one sentence with the place and the remedy.
pub(crate) fn load(
    files: &[PathBuf],
    options: &LoadOptions,
    progress: Progress,
) -> Result<Loaded, CommandError> {
    options.selection.check()?;
    known_inputs::check(options)?;
    let files = with_windows(files, &options.windows)?;
    if files.is_empty() {
        return Err(SelectionError::NoFile.into());
    }
    let mut loaded = Loaded {
        records: Vec::new(),
        sources: Vec::new(),
        known_inputs: Vec::new(),
        warnings: Vec::new(),
        missing_inputs: Vec::new(),
    };
    for (file, windows) in &files {
        read(file, windows, options, progress, &mut loaded)?;
    }
    check_missing_inputs(&files, options, &mut loaded)?;
    let warnings = same_units::check(&loaded.records, &loaded.sources)?;
    loaded.warnings.extend(warnings);
    common_period::share(&mut loaded)?;
    loaded.decimate(options.decimate)?;
    Ok(loaded)
}

/// Refuses inputs that no file has, and says of others where they are missing: there they did not move.
fn check_missing_inputs(
    files: &[(&Path, Vec<&Window>)],
    options: &LoadOptions,
    loaded: &mut Loaded,
) -> Result<(), CommandError> {
    let mut missing = std::mem::take(&mut loaded.missing_inputs);
    for (input, column) in options.known_inputs.iter().enumerate() {
        if !options.inputs_may_be_missing
            && missing.iter().all(|of_file| of_file[input].is_some())
            && let Some(error) = missing.first_mut().and_then(|of_file| of_file[input].take())
        {
            return Err(error);
        }
        for ((file, _), of_file) in files.iter().zip(&missing) {
            if of_file[input].is_some() {
                let file = file.file_name().unwrap_or(file.as_os_str()).to_string_lossy();
                let (file, column) = (file.into_owned(), column.clone());
                loaded.warnings.push(LoadWarning::InputMissing { file, column });
            }
        }
    }
    Ok(())
}

/// Each file once, with its windows.
fn with_windows<'a>(
    files: &'a [PathBuf],
    windows: &'a [Window],
) -> Result<Vec<(&'a Path, Vec<&'a Window>)>, CommandError> {
    let mut found: Vec<(&Path, Vec<&Window>)> = Vec::new();
    for file in files {
        if found.iter().any(|(other, _)| is_same_file(other, file)) {
            return Err(SelectionError::SameFile { file: file.clone() }.into());
        }
        found.push((file, Vec::new()));
    }
    for window in windows {
        match found.iter_mut().find(|(file, _)| is_same_file(file, &window.file)) {
            Some((_, windows)) => windows.push(window),
            None => found.push((&window.file, vec![window])),
        }
    }
    Ok(found)
}

/// Whether two paths lead to one file.
pub(crate) fn is_same_file(a: &Path, b: &Path) -> bool {
    a == b || a.canonicalize().is_ok_and(|a| b.canonicalize().is_ok_and(|b| a == b))
}

/// A file in memory: its sensors in SI, and their times.
struct Recording<'a> {
    file: &'a Path,
    /// The sensors, then the measured inputs.
    table: Table,
    times: Times,
    /// Of the sensors.
    units: Vec<Option<&'static str>>,
    /// For each measured input whether the file has a column of it.
    has_input: Vec<bool>,
}

fn read(
    file: &Path,
    windows: &[&Window],
    options: &LoadOptions,
    progress: Progress,
    loaded: &mut Loaded,
) -> Result<(), CommandError> {
    let (mut recording, missing) = recording(file, options, progress, &mut loaded.warnings)?;
    loaded.missing_inputs.push(missing);
    let name = file.file_name().unwrap_or(file.as_os_str()).to_string_lossy().into_owned();
    if windows.is_empty() {
        let rows = 0..recording.times.samples();
        return recording.records(name, rows, options, loaded);
    }
    let mut taken: Vec<(String, Range<usize>)> = Vec::new();
    for window in windows {
        let rows = recording.times.within(window.start_s, window.end_s);
        if rows.is_empty() {
            let last = recording.times.samples().saturating_sub(1);
            return Err(SelectionError::WindowOutside {
                file: file.to_owned(),
                start_s: window.start_s.unwrap_or(f64::NEG_INFINITY),
                end_s: window.end_s.unwrap_or(f64::INFINITY),
                first_s: recording.times.at(0),
                last_s: recording.times.at(last),
            }
            .into());
        }
        let name = format!("{name}{}", window.suffix());
        if recording.times.reaches_beyond(window.start_s, window.end_s) {
            let time_s = [rows.start, rows.end - 1].map(|row| recording.times.at(row));
            loaded.warnings.push(LoadWarning::WindowCut { record: name.clone(), time_s });
        }
        // Both ends belong to a window, so that windows that touch have one sample in common.
        let shares = |(_, other): &&(String, Range<usize>)| {
            rows.end.min(other.end) > rows.start.max(other.start) + 1
        };
        if let Some((other, _)) = taken.iter().find(shares) {
            let records = [other.clone(), name.clone()];
            loaded.warnings.push(LoadWarning::WindowsOverlap { records });
        }
        taken.push((name.clone(), rows.clone()));
        recording.records(name, rows, options, loaded)?;
    }
    Ok(())
}

fn recording<'a>(
    file: &'a Path,
    options: &LoadOptions,
    progress: Progress,
    warnings: &mut Vec<LoadWarning>,
) -> Result<(Recording<'a>, Vec<Option<CommandError>>), CommandError> {
    let opened = open(file, &options.reading, progress)?;
    let mut selected = options.selection.select(file, opened.format(), opened.headings())?;
    let missing = known_inputs::select(file, opened.headings(), options, &mut selected)?;
    let has_input: Vec<bool> = missing.iter().map(Option::is_none).collect();
    let (mut table, times) = in_si(file, opened, &mut selected, &options.selection)?;
    let inputs = has_input.iter().filter(|has| **has).count();
    let sensor_count = selected.sensors.len() - inputs;
    let units: Vec<_> =
        selected.sensors.iter().take(sensor_count).map(|sensor| sensor.si).collect();
    warnings.extend(notes::of_columns(file, &table, &selected, &options.selection));
    if options.angles == Angles::Unwrapped {
        warnings.extend(notes::unwrap(file, &mut table, &selected));
    }
    Ok((Recording { file, table, times, units, has_input }, missing))
}

/// Reads the selected columns of a file: their numbers in SI, and their times. Columns that turn
/// out to hold words are taken from the selection.
pub(crate) fn in_si(
    file: &Path,
    opened: Box<dyn Opened>,
    selected: &mut Selected,
    selection: &Selection,
) -> Result<(Table, Times), CommandError> {
    let mut table = opened.read(selected.chosen(selection))?;
    let is_ignored = |index: usize| table.ignored.iter().any(|column| column.index == index);
    selected.sensors.retain(|sensor| !is_ignored(sensor.index));
    if let (true, Some(column)) = (selected.sensors.is_empty(), table.ignored.first()) {
        let name = &table.headings[column.index].name;
        let message = format!("{name:?} cannot be used: it {}", column.why);
        return Err(CommandError::InFile { file: file.to_owned(), message });
    }
    let factor = selected.time.map(|time| time.factor);
    let times = Times::take(file, &mut table, factor, &selection.time)?;
    for (values, sensor) in table.values.iter_mut().zip(&selected.sensors) {
        scale(values, sensor.factor);
        shift(values, sensor.offset);
    }
    Ok((table, times))
}

impl Recording<'_> {
    /// The records in a range of samples: one, or one for each stretch between gaps.
    fn records(
        &mut self,
        name: String,
        rows: Range<usize>,
        options: &LoadOptions,
        loaded: &mut Loaded,
    ) -> Result<(), CommandError> {
        if let Some(period_s) = options.resample_s
            && !self.times.is_resampled()
        {
            let (table, times) =
                resampling::of_table(self.file, &self.table, &self.times, rows, period_s)?;
            let mut even = Recording {
                file: self.file,
                table,
                times,
                units: self.units.clone(),
                has_input: self.has_input.clone(),
            };
            LoadWarning::add_once(
                &mut loaded.warnings,
                LoadWarning::Resampled { record: name.clone(), period_s },
            );
            let rows = 0..even.times.samples();
            return even.records(name, rows, options, loaded);
        }
        let Steps { even, clock, is_assumed } =
            self.times.sampling(self.file, &self.table, rows.clone())?;
        if is_assumed {
            let (record, period_s) = (name.clone(), even.period_s);
            LoadWarning::add_once(
                &mut loaded.warnings,
                LoadWarning::Clock { record, period_s, clock },
            );
        }
        if let Some(text) = self.times.unit_note(even.period_s) {
            let file = self.file.to_owned();
            LoadWarning::add_once(&mut loaded.warnings, LoadWarning::ClockUnit { file, text });
        }
        let channels: Vec<&[f64]> = self.table.values.iter().map(Vec::as_slice).collect();
        let longest = options.bridge.longest(even.period_s);
        let gaps: Vec<(usize, usize)> = even
            .after_gaps
            .iter()
            .map(|&row| (row, self.times.absent(row, even.period_s)))
            .collect();
        let mut stretches =
            stretches(rows.clone(), &gaps, &channels, longest, options.most_missing);
        let is_whole = matches!(stretches.as_slice(), [one] if one.rows == rows);
        if !is_whole {
            stretches = self.long_enough(&name, stretches, &mut loaded.warnings)?;
        }
        if let Some(longest_gap) = stretches.iter().map(|stretch| stretch.longest_gap).max()
            && longest_gap > 0
        {
            let missing = stretches.iter().map(|stretch| stretch.missing).sum();
            let bridge_s = without_rounding(longest as f64 * even.period_s);
            loaded.warnings.push(LoadWarning::Bridged {
                record: name.clone(),
                missing,
                longest_gap,
                bridge_s,
                interpolated: false,
            });
        }
        let is_one = stretches.len() == 1;
        let whole = loaded.sources.last().map_or(0, |last| last.whole + 1);
        for (index, stretch) in stretches.into_iter().enumerate() {
            let name = if is_one { name.clone() } else { format!("{name}#{}", index + 1) };
            self.record((name, whole), stretch, (even.period_s, clock), options, loaded)?;
        }
        Ok(())
    }

    /// Leaves out what is too short, and says what gaps did.
    fn long_enough(
        &self,
        record: &str,
        mut stretches: Vec<Stretch>,
        warnings: &mut Vec<LoadWarning>,
    ) -> Result<Vec<Stretch>, CommandError> {
        let record = record.to_owned();
        if let [_, second, ..] = &stretches[..] {
            let (stretches, place) = (stretches.len(), self.table.places.of(second.rows.start));
            warnings.push(LoadWarning::Split { record: record.clone(), stretches, place });
        }
        let longest = stretches.iter().map(Stretch::samples).max().unwrap_or(0);
        let short = || stretches.iter().filter(|stretch| stretch.samples() < SHORTEST);
        let (count, samples) = (short().count(), short().map(Stretch::samples).sum());
        if longest < SHORTEST {
            let file = self.file.to_owned();
            return Err(SelectionError::OnlyGaps { file, needed: SHORTEST, longest }.into());
        }
        if count > 0 {
            warnings.push(LoadWarning::ShortStretches { record, count, samples, needed: SHORTEST });
        }
        stretches.retain(|stretch| stretch.samples() >= SHORTEST);
        Ok(stretches)
    }

    fn record(
        &mut self,
        (name, whole): (String, usize),
        stretch: Stretch,
        (period_s, clock): (f64, Clock),
        options: &LoadOptions,
        loaded: &mut Loaded,
    ) -> Result<(), CommandError> {
        let is_all = stretch.absent.is_empty() && stretch.rows == (0..self.times.samples());
        let mut channels = Vec::new();
        for index in 0..self.table.values.len() {
            let values = &mut self.table.values[index];
            let values = if is_all && options.windows.is_empty() {
                // The only record of its file: nobody needs the numbers any more.
                std::mem::take(values)
            } else {
                stretch.of(values)
            };
            channels.push(Channel::new(self.table.heading(index).name.clone(), values));
        }
        let known = channels.split_off(self.units.len());
        let period = SamplePeriod::new(period_s).map_err(|error| in_file(self.file, &error))?;
        let checked = |channels| {
            Record::with_missing(name.clone(), period, channels)
                .map_err(|error| in_file(self.file, &error))
        };
        let record = checked(channels)?;
        // Missing samples of inputs are interpolated.
        let known = if known.is_empty() { known } else { checked(known)?.channels().to_vec() };
        // In rows of the record, of which the file may have fewer.
        let start_s = self.times.at(stretch.rows.start);
        let at = |sample: usize| match stretch.absent.first() {
            None => self.times.at(stretch.rows.start + sample),
            Some(_) => start_s + sample as f64 * period_s,
        };
        let span_s = [at(0), at(record.samples().saturating_sub(1))];
        let mut known = known.into_iter().map(|channel| channel.values);
        let still = || vec![0.0; record.samples()];
        let of = |has: &bool| if *has { known.next().unwrap_or_else(still) } else { still() };
        let inputs = self.has_input.iter().map(of).collect();
        loaded.known_inputs.push(inputs);
        loaded.records.push(record);
        loaded.sources.push(Source {
            file: self.file.to_owned(),
            span_s,
            bridged: stretch.missing,
            units: self.units.clone(),
            whole,
            clock,
        });
        Ok(())
    }
}

#[cfg(test)]
mod tests;
