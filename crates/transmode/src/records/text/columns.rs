//! The fields of the chosen columns as numbers, row by row.

use std::path::Path;

use super::clock::Clock;
use super::dialect;
use crate::CommandError;
use crate::error::TableError;
use crate::records::table::{Chosen, Heading, Ignored, RowLines, Words};

/// Which columns to read, and what of them has been read.
pub(super) struct Columns<'a> {
    headings: &'a [Heading],
    /// For each column of the file, its place among the chosen ones.
    slots: Vec<Option<usize>>,
    pub(super) values: Vec<Vec<f64>>,
    pub(super) lines: RowLines,
    /// The decimal mark of the numbers so far.
    mark: Option<u8>,
    /// The column of time, which may hold what a clock shows.
    time: Option<usize>,
    clock: Clock,
    /// Whether it has held a number, so that no clock's time may follow.
    time_is_number: bool,
    words: Words,
    /// For each chosen column, whether it has held a number.
    has_number: Vec<bool>,
    /// For each chosen column, the first word in it and its line.
    word: Vec<Option<(String, u64)>>,
}

/// What was read.
pub(super) struct Read {
    pub(super) values: Vec<Vec<f64>>,
    /// The columns that these are of.
    pub(super) chosen: Vec<usize>,
    pub(super) ignored: Vec<Ignored>,
    pub(super) lines: RowLines,
}

/// What is wrong with one field.
pub(super) struct Fault {
    column: String,
    text: String,
    kind: FaultKind,
}

enum FaultKind {
    NotText,
    NotANumber,
    NotATime,
    ClockWithUnit,
    /// The decimal comma comes late, or the point.
    Mixed {
        comma: bool,
    },
}

impl<'a> Columns<'a> {
    pub(super) fn new(headings: &'a [Heading], chosen: &Chosen) -> Self {
        let mut slots = vec![None; headings.len()];
        for (place, column) in chosen.channels.iter().enumerate() {
            slots[*column] = Some(place);
        }
        Self {
            headings,
            slots,
            values: vec![Vec::new(); chosen.channels.len()],
            lines: RowLines::default(),
            mark: None,
            time: if chosen.with_time { chosen.channels.last().copied() } else { None },
            clock: Clock::default(),
            time_is_number: false,
            words: chosen.words,
            has_number: vec![false; chosen.channels.len()],
            word: vec![None; chosen.channels.len()],
        }
    }

    /// Whether the times were those of a clock.
    pub(super) fn clock_is_read(&self) -> bool {
        self.clock.is_read()
    }

    /// The columns of numbers, without those of words.
    pub(super) fn finish(self, chosen: Vec<usize>) -> Read {
        let Self { values, word, lines, .. } = self;
        let mut read = Read { values: Vec::new(), chosen: Vec::new(), ignored: Vec::new(), lines };
        for ((index, values), word) in chosen.into_iter().zip(values).zip(word) {
            if let Some((text, line)) = word {
                let why = format!("holds {text:?} on line {line}, which is no finite number");
                read.ignored.push(Ignored { index, why });
            } else {
                read.values.push(values);
                read.chosen.push(index);
            }
        }
        read
    }

    /// One more field of column `index`, if it was chosen.
    pub(super) fn push(
        &mut self,
        index: usize,
        field: &[u8],
        separator: u8,
        line: u64,
    ) -> Result<(), Fault> {
        // A row that is too long is refused when its fields have been counted.
        let Some(&Some(slot)) = self.slots.get(index) else { return Ok(()) };
        let fault = |kind| {
            let text = shortened(&String::from_utf8_lossy(field));
            Fault { column: self.headings[index].name.clone(), text, kind }
        };
        let is_time = self.time == Some(index) && !field.is_empty();
        if is_time && !self.time_is_number {
            match self.clock.seconds(field) {
                Some(_) if self.headings[index].unit.is_some() => {
                    return Err(fault(FaultKind::ClockWithUnit));
                }
                Some(seconds) => {
                    self.values[slot].push(seconds);
                    return Ok(());
                }
                None if self.clock.is_read() || field.contains(&b':') => {
                    return Err(fault(FaultKind::NotATime));
                }
                None => {}
            }
        }
        let number = dialect::number(field, separator).filter(|number| !number.value.is_infinite());
        let Some(number) = number else {
            let is_text = std::str::from_utf8(field).is_ok();
            let is_ignored = match self.words {
                Words::Refused => false,
                Words::ColumnsIgnored => is_text && !self.has_number[slot],
                Words::Ignored => true,
            };
            if is_ignored && self.time != Some(index) {
                let text = || shortened(&String::from_utf8_lossy(field));
                self.word[slot].get_or_insert_with(|| (text(), line));
                self.values[slot].push(f64::NAN);
                return Ok(());
            }
            return Err(fault(if is_text { FaultKind::NotANumber } else { FaultKind::NotText }));
        };
        if number.mark.is_some() && number.mark != self.mark {
            if self.mark.is_some() {
                return Err(fault(FaultKind::Mixed { comma: number.mark == Some(b',') }));
            }
            self.mark = number.mark;
        }
        self.time_is_number |= is_time && !number.value.is_nan();
        self.has_number[slot] |= !number.value.is_nan();
        self.values[slot].push(number.value);
        Ok(())
    }
}

impl Fault {
    /// The fault as an error of this line of the file.
    pub(super) fn at(self, file: &Path, line: u64) -> CommandError {
        let Self { column, text, kind } = self;
        let file = file.to_owned();
        match kind {
            FaultKind::NotText => TableError::NotText { file, line },
            FaultKind::NotANumber => TableError::NotANumber { file, line, column, text },
            FaultKind::NotATime => TableError::NotATime { file, line, column, text },
            FaultKind::ClockWithUnit => TableError::ClockWithUnit { file, line, column, text },
            FaultKind::Mixed { comma } => {
                TableError::MixedMarks { file, line, column, text, comma }
            }
        }
        .into()
    }
}

/// Enough of a field to recognise it, in case the file is one endless line.
pub(super) fn shortened(text: &str) -> String {
    const LONGEST: usize = 40;
    if text.chars().count() <= LONGEST {
        return text.to_owned();
    }
    text.chars().take(LONGEST).chain("...".chars()).collect()
}
