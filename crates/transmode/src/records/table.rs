//! A file as a table of named channels, whatever its format.

use std::path::Path;

use crate::CommandError;
use crate::records::format::Format;
use crate::records::selection::is_time;

/// What a file says of one channel before its numbers are read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Heading {
    /// Without blanks around it and without its unit.
    pub(crate) name: String,
    /// As it is written, without its brackets; `None` where the file says nothing.
    pub(crate) unit: Option<String>,
    /// Number of samples, where the file says it in advance.
    pub(crate) samples: Option<usize>,
    /// Why its numbers cannot be read, where it is known in advance.
    pub(crate) fault: Option<String>,
    /// Whether that is because it holds words.
    pub(crate) is_words: bool,
    /// Whether it is a channel only where it is asked for.
    pub(crate) by_name_only: bool,
}

/// The channels that were chosen. All are equally long.
#[derive(Clone, Debug)]
pub(crate) struct Table {
    pub(crate) format: Format,
    /// Of all channels of the file.
    pub(crate) headings: Vec<Heading>,
    /// Indices of those that were chosen, in the order chosen.
    pub(crate) chosen: Vec<usize>,
    /// `values[c][row]` of the chosen one `c`, in its own unit; NaN where nothing was recorded, never infinite.
    pub(crate) values: Vec<Vec<f64>>,
    pub(crate) places: Places,
    /// Whether the times were written as a clock shows them.
    pub(crate) with_clock: bool,
    /// Columns that were wanted like all others, and turned out to hold no numbers.
    pub(crate) ignored: Vec<Ignored>,
    /// Rows that repeated the one before, and were left out.
    pub(crate) repeated: usize,
}

/// A column that is no channel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Ignored {
    /// Its index in the file.
    pub(crate) index: usize,
    /// What it holds.
    pub(crate) why: String,
}

/// Which channels are read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Chosen {
    /// Their indices in the order wanted, each at most once.
    pub(crate) channels: Vec<usize>,
    /// Whether the last of them is time, which a text may write as a clock shows it.
    pub(crate) with_time: bool,
    /// What becomes of a column of words.
    pub(crate) words: Words,
}

/// What becomes of words where numbers should be, time apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Words {
    /// They are refused: each channel was asked for by name.
    #[default]
    Refused,
    /// A column that has held no number yet is ignored.
    ColumnsIgnored,
    /// Any of them makes its column an ignored one.
    Ignored,
}

/// A file of which the headings have been read, and no numbers yet.
pub(crate) trait Opened {
    fn format(&self) -> Format;

    /// Of all channels of the file.
    fn headings(&self) -> &[Heading];

    /// Reads the numbers of the chosen channels, and no others.
    fn read(self: Box<Self>, chosen: Chosen) -> Result<Table, CommandError>;
}

/// What a message calls a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Places {
    /// By its line in the file.
    Lines(RowLines),
    /// By its index, from 0.
    Samples,
}

/// On which line of a text each row of numbers stands.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct RowLines {
    /// Rows that do not stand right below the row before, with their lines. Ascending.
    jumps: Vec<(usize, u64)>,
    rows: usize,
    /// The line on which the next row is expected.
    expected: u64,
}

impl Heading {
    /// A channel that is called so and says no more.
    pub(crate) fn named(name: impl Into<String>) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// Where some of the preferred ones are channels, time apart, the others are only by name.
    pub(crate) fn prefer(headings: &mut [Self], is_preferred: &[bool]) {
        let is_channel = |heading: &Self| {
            heading.fault.is_none() && heading.samples > Some(1) && !is_time(&heading.name)
        };
        let mut preferred = headings.iter().zip(is_preferred).filter(|(_, preferred)| **preferred);
        if preferred.any(|(heading, _)| is_channel(heading)) {
            for (heading, preferred) in headings.iter_mut().zip(is_preferred) {
                heading.by_name_only |= !preferred;
            }
        }
    }
}

impl Table {
    /// The chosen channels of a file of arrays.
    pub(crate) fn of_arrays(
        format: Format,
        headings: Vec<Heading>,
        chosen: Vec<usize>,
        values: Vec<Vec<f64>>,
    ) -> Self {
        let (places, ignored) = (Places::Samples, Vec::new());
        Self { format, headings, chosen, values, places, with_clock: false, ignored, repeated: 0 }
    }

    pub(crate) fn rows(&self) -> usize {
        self.values.first().map_or(0, Vec::len)
    }

    /// The same channels, with no sample yet.
    pub(crate) fn without_values(&self) -> Self {
        Self {
            format: self.format,
            headings: self.headings.clone(),
            chosen: self.chosen.clone(),
            values: Vec::new(),
            places: Places::Samples,
            with_clock: self.with_clock,
            ignored: Vec::new(),
            repeated: 0,
        }
    }

    /// Refuses infinite numbers in an array.
    pub(crate) fn finite(self, file: &Path) -> Result<Self, CommandError> {
        for (column, values) in self.values.iter().enumerate() {
            if let Some(sample) = values.iter().position(|value| value.is_infinite()) {
                return Err(CommandError::InfiniteSample {
                    file: file.to_owned(),
                    sample: sample as u64,
                    column: self.heading(column).name.clone(),
                    value: values[sample],
                });
            }
        }
        Ok(self)
    }

    /// Leaves out rows that repeat the one before in all chosen channels and in their time stamp, where they are few and no other row has the stamp of the one before.
    pub(crate) fn leave_out_repeats(&mut self, stamps: &mut Vec<f64>) {
        /// One row in so many, at most.
        const FEW: usize = 20;
        let is_same = |a: f64, b: f64| a.to_bits() == b.to_bits();
        let standing: Vec<usize> =
            (1..stamps.len()).filter(|row| is_same(stamps[*row], stamps[row - 1])).collect();
        let is_repeat =
            |row: &usize| self.values.iter().all(|values| is_same(values[*row], values[row - 1]));
        if standing.is_empty()
            || standing.len() * FEW > stamps.len()
            || !standing.iter().all(is_repeat)
        {
            return;
        }
        let mut kept = vec![true; stamps.len()];
        standing.iter().for_each(|row| kept[*row] = false);
        for values in self.values.iter_mut().chain([stamps]) {
            let mut flags = kept.iter();
            values.retain(|_| flags.next().copied().unwrap_or(true));
        }
        if let Places::Lines(lines) = &mut self.places {
            let mut left = RowLines::default();
            (0..kept.len()).filter(|row| kept[*row]).for_each(|row| left.push(lines.line(row)));
            *lines = left;
        }
        self.repeated = standing.len();
    }

    /// The heading of the chosen channel `column`.
    pub(crate) fn heading(&self, column: usize) -> &Heading {
        &self.headings[self.chosen[column]]
    }
}

impl Places {
    /// `line 12`, or `sample 10 (from 0)`.
    pub(crate) fn of(&self, row: usize) -> String {
        match self {
            Self::Lines(lines) => format!("line {}", lines.line(row)),
            Self::Samples => format!("sample {row} (from 0)"),
        }
    }
}

impl RowLines {
    /// One more row, on this line.
    pub(crate) fn push(&mut self, line: u64) {
        if line != self.expected {
            self.jumps.push((self.rows, line));
        }
        self.rows += 1;
        self.expected = line + 1;
    }

    /// The line, from 1, of a row, from 0.
    pub(crate) fn line(&self, row: usize) -> u64 {
        let above = self.jumps.partition_point(|(first, _)| *first <= row);
        let (first, line) = above.checked_sub(1).map_or((0, 0), |index| self.jumps[index]);
        line + (row - first) as u64
    }
}
