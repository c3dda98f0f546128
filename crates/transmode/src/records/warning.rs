//! What there is to say of files that could be read.

use std::fmt;
use std::path::PathBuf;

use super::clock::Clock;
use crate::numbers::rounded;

/// One thing that was done to a file and that its owner may not expect.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum LoadWarning {
    /// Gaps split a file, or a window of it.
    Split {
        /// What the record would be called.
        record: String,
        /// How many stretches there are between gaps.
        stretches: usize,
        /// Where the second one starts.
        place: String,
    },
    /// Short gaps that are missing samples of one record.
    Bridged {
        record: String,
        /// Rows that are missing or incomplete.
        missing: usize,
        /// The most of them in a gap.
        longest_gap: usize,
        /// Gaps of up to so long are bridged.
        bridge_s: f64,
        /// Whether interpolated samples stand for them: where the record was decimated, and where it is only predicted.
        interpolated: bool,
    },
    /// Stretches between gaps that were left out.
    ShortStretches {
        record: String,
        count: usize,
        /// Samples in them.
        samples: usize,
        /// Samples that one should have.
        needed: usize,
    },
    /// Of the stretches between gaps the longest alone is used.
    LongestStretch {
        record: String,
        samples: usize,
        /// Samples in all stretches.
        total: usize,
    },
    /// A window that is longer than its file.
    WindowCut {
        record: String,
        /// Times of its first and of its last sample, in seconds.
        time_s: [f64; 2],
    },
    /// Two windows of one file that have samples in common.
    WindowsOverlap { records: [String; 2] },
    /// A sensor whose unit the first file states and the second does not.
    UnitMissing { files: [String; 2], column: String, unit: &'static str },
    /// A recorded input that a file has no column of.
    InputMissing { file: String, column: String },
    /// A recorded input that rests in a record.
    IdleInput { record: String, column: String },
    /// A record in which `monitor` finds no span.
    NoSpan {
        record: String,
        samples: usize,
        /// Samples that one span takes.
        needed: usize,
    },
    /// A period that is fitted to stamps which do not advance evenly by themselves.
    Clock { record: String, period_s: f64, clock: Clock },
    /// Records of two clocks, taken at one period.
    ClocksDiffer { records: [String; 2], periods_s: [f64; 2], common_s: f64 },
    /// A column of time that may be in another unit.
    ClockUnit { file: PathBuf, text: String },
    /// A column of time in whose place a sample period was given.
    TimeUnused { file: PathBuf, column: String, period_s: f64 },
    /// Samples that were interpolated to equal steps.
    Resampled { record: String, period_s: f64 },
    /// Columns of words.
    ColumnsIgnored { file: PathBuf, columns: Vec<String> },
    /// Columns in units that are not known, and these.
    UnitUnknown { file: PathBuf, columns: Vec<(String, String)> },
    /// Rows that repeated the one before.
    RowsRepeated { file: PathBuf, rows: usize },
    /// Angles that jumped by a turn.
    Unwrapped { file: PathBuf, columns: Vec<String> },
    /// Records that were decimated, since they were sampled far faster than anything in them moves.
    Oversampled {
        factor: usize,
        /// Samples in a second, as the files have them.
        rate_hz: f64,
        /// What the filter passes ends here.
        highest_hz: f64,
    },
    /// A sensor that is a multiple of another in all records.
    CopyLeftOut { column: String, other: String, factor: f64 },
}

impl LoadWarning {
    /// Adds a warning, unless one of its code speaks of the same file: of ninety windows of one
    /// file the first stands for all.
    pub(crate) fn add_once(warnings: &mut Vec<Self>, warning: Self) {
        let is_same = |other: &Self| {
            other.code() == warning.code() && other.file_name() == warning.file_name()
        };
        if !warnings.iter().any(is_same) {
            warnings.push(warning);
        }
    }

    /// The file that it speaks of, where that is one.
    fn file_name(&self) -> Option<String> {
        match self {
            Self::Clock { record, .. }
            | Self::Resampled { record, .. }
            | Self::NoSpan { record, .. } => {
                let whole = record.split_once('#').map_or(record.as_str(), |(whole, _)| whole);
                // `file:start:end` of a window.
                let is_edge = |edge: &str| edge.is_empty() || edge.parse::<f64>().is_ok();
                let mut parts = whole.rsplitn(3, ':');
                let (end, start, file) = (parts.next()?, parts.next(), parts.next());
                Some(match (start, file) {
                    (Some(start), Some(file)) if is_edge(start) && is_edge(end) => file.to_owned(),
                    _ => whole.to_owned(),
                })
            }
            Self::ClockUnit { file, .. } => Some(file.display().to_string()),
            _ => None,
        }
    }

    /// What its line begins with: what was assumed and does no harm is a note.
    pub(crate) fn label(&self) -> &'static str {
        match self {
            Self::Bridged { .. }
            | Self::Clock { .. }
            | Self::ClocksDiffer { .. }
            | Self::ClockUnit { .. }
            | Self::TimeUnused { .. }
            | Self::Resampled { .. }
            | Self::ColumnsIgnored { .. }
            | Self::UnitUnknown { .. }
            | Self::RowsRepeated { .. }
            | Self::Unwrapped { .. }
            | Self::Oversampled { .. }
            | Self::CopyLeftOut { .. } => "note",
            _ => "warning",
        }
    }

    /// A short name for other programs.
    pub(crate) fn code(&self) -> &'static str {
        match self {
            Self::Split { .. } => "gaps",
            Self::Bridged { .. } => "bridged",
            Self::ShortStretches { .. } => "short-stretches",
            Self::LongestStretch { .. } => "longest-stretch",
            Self::WindowCut { .. } => "window-cut",
            Self::WindowsOverlap { .. } => "windows-overlap",
            Self::UnitMissing { .. } => "unit-missing",
            Self::InputMissing { .. } => "input-missing",
            Self::IdleInput { .. } => "idle-input",
            Self::NoSpan { .. } => "no-span",
            Self::Clock { .. } => "clock",
            Self::ClocksDiffer { .. } => "clocks-differ",
            Self::ClockUnit { .. } => "clock-unit",
            Self::TimeUnused { .. } => "time-unused",
            Self::Resampled { .. } => "resampled",
            Self::ColumnsIgnored { .. } => "columns-ignored",
            Self::UnitUnknown { .. } => "unit-unknown",
            Self::RowsRepeated { .. } => "rows-repeated",
            Self::Unwrapped { .. } => "unwrapped",
            Self::Oversampled { .. } => "oversampled",
            Self::CopyLeftOut { .. } => "copy-left-out",
        }
    }
}

impl fmt::Display for LoadWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Split { record, stretches, place } => write!(
                f,
                "gaps split {record} into {stretches} stretches, which count as one record; the second starts at {place}"
            ),
            Self::Bridged { record, missing, longest_gap, bridge_s, interpolated } => {
                let (rows, verb) = if *missing == 1 { ("row", "is") } else { ("rows", "are") };
                let taken = if *interpolated {
                    "interpolated"
                } else {
                    "taken as unknown inside one record"
                };
                write!(
                    f,
                    "{record}: {missing} {rows} in gaps of up to {longest_gap} {verb} missing or incomplete, and {taken} (gaps longer than {bridge_s} s would split it, --bridge)"
                )
            }
            Self::LongestStretch { record, samples, total } => write!(
                f,
                "only the longest stretch between gaps is used: {record}, {samples} of {total} samples"
            ),
            Self::WindowCut { record, time_s: [first, last] } => write!(
                f,
                "{record} reaches beyond its file, and is what the file has of it: from {first} s to {last} s"
            ),
            Self::WindowsOverlap { records: [first, second] } => write!(
                f,
                "{first} and {second} overlap: what they have in common counts twice, as if it had been measured twice"
            ),
            Self::UnitMissing { files: [stated, silent], column, unit } => write!(
                f,
                "{silent} does not say the unit of {column}, and its numbers are taken to be in {unit}, as {stated} has it"
            ),
            Self::IdleInput { record, column } => {
                write!(f, "the recorded input {column} rests in {record} and is left out there")
            }
            Self::InputMissing { file, column } => write!(
                f,
                "{file} has no column {column:?}: that input is taken not to have moved in it"
            ),
            Self::NoSpan { record, samples, needed } => write!(
                f,
                "{record} was left out: its {samples} samples are too few for one span, which takes {needed}"
            ),
            Self::Clock { record, period_s, clock } => {
                write!(
                    f,
                    "{record}: sample period {} s, fitted to the time stamps",
                    shown(*period_s)
                )?;
                if let Some(largest) = clock.largest_deviation_s {
                    let part = 100.0 * largest / period_s;
                    write!(
                        f,
                        "; the largest deviation is {} s ({} % of a period)",
                        rounded(largest, 2),
                        rounded(part, 2)
                    )?;
                }
                write!(f, "; assumed: {clock}")
            }
            Self::ClocksDiffer { records: [first, second], periods_s: [short, long], common_s } => {
                let part = rounded(long / short - 1.0, 2);
                write!(
                    f,
                    "the clocks of {first} and {second} differ by a part of {part} (sample periods {} s and {} s); {} s is used for all records",
                    shown(*short),
                    shown(*long),
                    shown(*common_s)
                )
            }
            Self::ClockUnit { file, text } => write!(f, "{}: column {text}", file.display()),
            Self::TimeUnused { file, column, period_s } => write!(
                f,
                "{}: column {column} is not used, since --sample-period {period_s} s takes its place",
                file.display()
            ),
            Self::Resampled { record, period_s } => write!(
                f,
                "{record} was interpolated to a sample every {period_s} s; content beyond half that rate, or half that of its own samples, is lost"
            ),
            Self::ColumnsIgnored { file, columns } => {
                write!(f, "{}: {} ignored, no numbers", file.display(), listed(columns))
            }
            Self::UnitUnknown { file, columns } => {
                let columns: Vec<String> =
                    columns.iter().map(|(name, unit)| format!("{name} [{unit}]")).collect();
                let (noun, verb) =
                    if columns.len() == 1 { ("unit", "is") } else { ("units", "are") };
                write!(
                    f,
                    "{}: the {noun} of {} {verb} not known; the numbers are taken as they are",
                    file.display(),
                    listed(&columns)
                )
            }
            Self::RowsRepeated { file, rows } => {
                let (noun, verb) = if *rows == 1 { ("row", "is") } else { ("rows", "are") };
                write!(
                    f,
                    "{}: {rows} {noun} that repeat the one before, time stamp and all, {verb} left out",
                    file.display()
                )
            }
            Self::Unwrapped { file, columns } => write!(
                f,
                "{}: {} jumps by a turn and is taken to go on (--unwrap=false leaves it as it is)",
                file.display(),
                listed(columns)
            ),
            Self::CopyLeftOut { column, other, factor } => {
                write!(f, "{column} is left out: it is {} times {other}", rounded(*factor, 4))
            }
            Self::Oversampled { factor, rate_hz, highest_hz } => write!(
                f,
                "of {} samples in a second every {factor}{} is kept, behind a low-pass filter that passes up to {} Hz: beyond, the sensors show next to nothing but noise (--decimate 1 keeps all)",
                rounded(*rate_hz, 6),
                ordinal_ending(*factor),
                rounded(*highest_hz, 2)
            ),
            Self::ShortStretches { record, count, samples, needed } => {
                let (noun, verb) =
                    if *count == 1 { ("stretch", "was") } else { ("stretches", "were") };
                write!(
                    f,
                    "{count} {noun} of {record} between gaps, {samples} samples in all, {verb} left out: shorter than {needed} samples"
                )
            }
        }
    }
}

/// `st` of 21st.
fn ordinal_ending(number: usize) -> &'static str {
    match (number % 10, number % 100) {
        (_, 11..=13) => "th",
        (1, _) => "st",
        (2, _) => "nd",
        (3, _) => "rd",
        _ => "th",
    }
}

/// A period without digits that nobody needs.
fn shown(period_s: f64) -> f64 {
    rounded(period_s, 8)
}

/// Names for a message; hundreds would hide the rest.
fn listed(names: &[String]) -> String {
    const LISTED: usize = 8;
    let mut text = names.iter().take(LISTED).cloned().collect::<Vec<_>>().join(", ");
    if names.len() > LISTED {
        text += &format!(" and {} more", names.len() - LISTED);
    }
    text
}
