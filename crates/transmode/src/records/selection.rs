//! Which columns of a file are wanted: sensors, time, and what their units are.

use std::path::Path;

use super::format::Format;
use super::table::{Chosen, Heading, Words};
use super::unit::Unit;
use crate::CommandError;
use crate::error::{SelectionError, TimeError};

/// What is wrong with a column that was asked for two times.
pub(super) const TWICE: &str = "twice; name it once";

/// How many names a message lists.
const LISTED: usize = 30;

/// Which columns of a file to use.
#[derive(Clone, Debug, Default)]
pub(crate) struct Selection {
    /// The sensors in the order wanted; all columns but time if empty.
    pub(crate) outputs: Vec<String>,
    pub(crate) time: TimeSource,
    /// Whether a column that cannot be used is passed over, where it would be refused otherwise.
    pub(crate) lenient: bool,
}

/// Where the times of the samples come from.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) enum TimeSource {
    /// The column that is called time, t or timestamp.
    #[default]
    Usual,
    /// The column of this name.
    Column(String),
    /// Equal steps of so many seconds from zero on.
    Period(f64),
    /// The usual column; arrays need not have it, and then the length of a step is not known.
    UsualOrUnknown,
}

/// The columns found, by their index in the file.
#[derive(Clone, Debug)]
pub(crate) struct Selected {
    pub(crate) time: Option<Wanted>,
    pub(crate) sensors: Vec<Wanted>,
}

/// One column and the factor to SI.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wanted {
    pub(crate) index: usize,
    pub(crate) factor: f64,
    /// Added behind that, in the unit after conversion.
    pub(crate) offset: f64,
    /// The unit after conversion, where the file states one.
    pub(crate) si: Option<&'static str>,
}

impl Selected {
    /// The channels to read: the sensors, then time.
    pub(crate) fn chosen(&self, selection: &Selection) -> Chosen {
        let channels = self.sensors.iter().chain(&self.time).map(|wanted| wanted.index).collect();
        Chosen { channels, with_time: self.time.is_some(), words: selection.words() }
    }
}

impl Selection {
    /// What becomes of columns of words: those that nobody asked for are ignored.
    fn words(&self) -> Words {
        match (self.lenient, self.outputs.is_empty()) {
            (true, _) => Words::Ignored,
            (false, true) => Words::ColumnsIgnored,
            (false, false) => Words::Refused,
        }
    }

    /// Refuses an outputs list that no file could satisfy.
    pub(crate) fn check(&self) -> Result<(), CommandError> {
        for (index, column) in self.outputs.iter().enumerate() {
            let fault =
                |why| Err(SelectionError::BadOutputs { column: column.clone(), why }.into());
            if column.is_empty() {
                return fault("as a sensor; separate the names by single commas");
            }
            if self.outputs[..index].contains(column) {
                return fault(TWICE);
            }
            if self.time == TimeSource::Column(column.clone()) {
                return fault("as a sensor and --time as time");
            }
        }
        Ok(())
    }

    /// Finds the columns of a file by their headings.
    pub(crate) fn select(
        &self,
        file: &Path,
        format: Format,
        headings: &[Heading],
    ) -> Result<Selected, CommandError> {
        let time = self.time(file, format, headings)?;
        let sensors = if self.outputs.is_empty() {
            let mut sensors = by_default(file, headings, time)?;
            if self.lenient {
                keep_usual_length(headings, time, &mut sensors);
            }
            sensors
        } else {
            let find = |name: &String| position(file, headings, name);
            self.outputs.iter().map(find).collect::<Result<Vec<_>, _>>()?
        };
        if let Some(time) = time.filter(|time| sensors.contains(time)) {
            let why = "as a sensor, but it is the column of time";
            return Err(
                SelectionError::BadOutputs { column: headings[time].name.clone(), why }.into()
            );
        }
        for (at, index) in sensors.iter().enumerate() {
            // `beta` and `beta [deg]` are one column.
            if sensors[..at].contains(index) {
                return Err(SelectionError::BadOutputs {
                    column: headings[*index].name.clone(),
                    why: TWICE,
                }
                .into());
            }
        }
        if sensors.is_empty() {
            let message = match time {
                Some(_) => "time is its only column; sensors are needed as well".to_owned(),
                None => format!("there is no channel of numbers in this {} file", format.name()),
            };
            return Err(CommandError::InFile { file: file.to_owned(), message });
        }
        let used = || time.iter().chain(&sensors).map(|index| &headings[*index]);
        if let Some((heading, fault)) =
            used().find_map(|heading| Some((heading, heading.fault.as_ref()?)))
        {
            let message = format!("{:?} cannot be used: {fault}", heading.name);
            return Err(CommandError::InFile { file: file.to_owned(), message });
        }
        check_lengths(file, used())?;
        let time_unit = |index| {
            let factor = time_factor(file, &headings[index])?;
            Ok::<_, CommandError>(Wanted { index, factor, offset: 0.0, si: Some("s") })
        };
        Ok(Selected {
            time: time.map(time_unit).transpose()?,
            sensors: sensors
                .into_iter()
                .map(|index| wanted(file, headings, index, self.lenient))
                .collect::<Result<_, _>>()?,
        })
    }

    fn time(
        &self,
        file: &Path,
        format: Format,
        headings: &[Heading],
    ) -> Result<Option<usize>, CommandError> {
        let usual = || headings.iter().position(|heading| is_time(&heading.name));
        match &self.time {
            TimeSource::Column(name) => position(file, headings, name).map(Some),
            // It takes the place of a column of time.
            TimeSource::Period(_) => Ok(None),
            TimeSource::UsualOrUnknown if !format.is_text() => Ok(usual()),
            TimeSource::Usual | TimeSource::UsualOrUnknown => match usual() {
                Some(index) => Ok(Some(index)),
                None => {
                    Err(TimeError::NoColumn { file: file.to_owned(), available: listed(headings) }
                        .into())
                }
            },
        }
    }
}

/// Whether a column is called as time usually is.
pub(crate) fn is_time(name: &str) -> bool {
    let name = match name.rsplit_once('_') {
        Some((name, "s" | "sec" | "ms" | "us" | "ns")) => name,
        _ => name,
    };
    ["time", "t", "timestamp"].iter().any(|usual| name.eq_ignore_ascii_case(usual))
}

/// All columns that could be sensors.
fn by_default(
    file: &Path,
    headings: &[Heading],
    time: Option<usize>,
) -> Result<Vec<usize>, CommandError> {
    let is_sensor = |&index: &usize| {
        let heading = &headings[index];
        // A single number beside arrays is a constant.
        let constant =
            heading.samples == Some(1) && headings.iter().any(|other| other.samples > Some(1));
        Some(index) != time
            && !is_time(&heading.name)
            && !heading.name.is_empty()
            && !constant
            && !heading.by_name_only
    };
    let sensors: Vec<usize> = (0..headings.len()).filter(is_sensor).collect();
    let good: Vec<usize> =
        sensors.iter().copied().filter(|index| headings[*index].fault.is_none()).collect();
    match sensors.first() {
        Some(&first) if good.is_empty() => {
            let heading = &headings[first];
            let fault = heading.fault.clone().unwrap_or_default();
            let message = format!("{:?} cannot be used: {fault}", heading.name);
            Err(CommandError::InFile { file: file.to_owned(), message })
        }
        _ => Ok(good),
    }
}

/// The column of that name, with or without its unit.
pub(crate) fn position(
    file: &Path,
    headings: &[Heading],
    name: &str,
) -> Result<usize, CommandError> {
    let whole = super::text::heading(name);
    let by_name = |wanted: &str| headings.iter().position(|heading| heading.name == wanted);
    let found = by_name(name).or_else(|| {
        by_name(&whole.name)
            .filter(|index| whole.unit.is_some() && headings[*index].unit == whole.unit)
    });
    found.ok_or_else(|| {
        let (file, column, available) = (file.to_owned(), name.to_owned(), listed(headings));
        SelectionError::NoSuchColumn { file, column, available }.into()
    })
}

/// A column with its unit. One that is not known is kept, and its numbers are taken as they are;
/// but not for a sensor by which modes get their names.
pub(super) fn wanted(
    file: &Path,
    headings: &[Heading],
    index: usize,
    lenient: bool,
) -> Result<Wanted, CommandError> {
    let heading = &headings[index];
    let text = heading.unit.as_deref().unwrap_or_default();
    match Unit::parse(text) {
        Some(Unit { si, factor, offset }) => {
            Ok(Wanted { index, factor, offset, si: heading.unit.as_ref().map(|_| si) })
        }
        None if lenient || !is_role(&heading.name) => {
            Ok(Wanted { index, factor: 1.0, offset: 0.0, si: None })
        }
        None => {
            let (column, unit) = (heading.name.clone(), text.to_owned());
            let (file, known) = (file.to_owned(), Unit::known());
            Err(SelectionError::UnknownUnit { file, column, unit, known }.into())
        }
    }
}

/// Whether modes get their names by a channel that is called so.
fn is_role(name: &str) -> bool {
    ["beta", "p", "r", "phi"].contains(&name)
}

fn time_factor(file: &Path, heading: &Heading) -> Result<f64, CommandError> {
    let Some(text) = heading.unit.as_deref().filter(|text| !text.is_empty()) else {
        return Ok(1.0);
    };
    Unit::parse(text).filter(|unit| unit.is_time()).map(|unit| unit.factor).ok_or_else(|| {
        let (column, unit) = (heading.name.clone(), text.to_owned());
        SelectionError::NotTime { file: file.to_owned(), column, unit }.into()
    })
}

/// Keeps the channels as long as time, or as most others are.
fn keep_usual_length(headings: &[Heading], time: Option<usize>, sensors: &mut Vec<usize>) {
    let length = |index: &usize| headings[*index].samples;
    let votes = |samples: Option<usize>| sensors.iter().filter(|at| length(at) == samples).count();
    let most = sensors.iter().map(length).max_by_key(|samples| votes(*samples)).flatten();
    let usual = time.map_or(most, |time| headings[time].samples);
    sensors.retain(|index| usual.is_none() || length(index) == usual);
}

fn check_lengths<'a>(
    file: &Path,
    mut used: impl Iterator<Item = &'a Heading>,
) -> Result<(), CommandError> {
    let Some(first) = used.next() else { return Ok(()) };
    let Some(first_samples) = first.samples else { return Ok(()) };
    for second in used {
        if let Some(second_samples) = second.samples.filter(|samples| *samples != first_samples) {
            return Err(SelectionError::UnequalLengths {
                file: file.to_owned(),
                first: first.name.clone(),
                first_samples,
                second: second.name.clone(),
                second_samples,
            }
            .into());
        }
    }
    Ok(())
}

/// Names for a message; one that is empty would not be seen, and thousands would hide the rest.
fn listed(headings: &[Heading]) -> String {
    let shown = |heading: &Heading| {
        if heading.name.is_empty() { "\"\"".to_owned() } else { heading.name.clone() }
    };
    let mut names: Vec<_> = headings.iter().take(LISTED).map(shown).collect();
    if headings.len() > LISTED {
        names.push(format!("and {} more", headings.len() - LISTED));
    }
    names.join(", ")
}
