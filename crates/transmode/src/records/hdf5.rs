//! HDF5 files, MATLAB's of version 7.3 among them: the numeric data sets of one and two dimensions are channels, and so are the
//! numeric fields of tables.
//!
//! A data set in a group is called by its path, `log.imu.p`, without what is common to all. Of a data set of two dimensions the longer one
//! is that of the samples; MATLAB's count its channels from 1, as those of its other files do, others from 0.

use std::path::{Path, PathBuf};

use hdf5_reader::error::Error;
use hdf5_reader::group::Group;
use hdf5_reader::{ByteOrder, Dataset, Datatype, Hdf5File, OpenOptions};

use super::format::Format;
use super::format_error::FormatError;
use super::paths;
use super::table::{Chosen, Heading, Opened, Table};
use crate::CommandError;
use crate::error::in_file;

/// Groups in groups, at most: links may lead in circles.
const DEEPEST: usize = 16;

/// Data sets and fields, at most.
const MOST: usize = 10_000;

/// What is unpacked may be so many times as long as the file, which no record is, and this many bytes in any case.
const LARGEST_RATIO: usize = 200;
const ALWAYS_ALLOWED: usize = 64 << 20;

/// One numeric array.
struct Array {
    path: String,
    dataset: Dataset,
    samples: usize,
    channels: usize,
    /// Whether the channels of a sample are neighbours.
    by_sample: bool,
    /// Bytes of one element of the data set, the place of the number in it, and what it is.
    width: usize,
    offset: usize,
    number: Number,
}

/// How a number is written.
#[derive(Clone, Copy)]
enum Number {
    Float { bytes: usize, big: bool },
    Whole { bytes: usize, big: bool, signed: bool },
}

/// A file whose data sets are known, and not their numbers.
pub(crate) struct OpenedHdf5 {
    file: PathBuf,
    format: Format,
    arrays: Vec<Array>,
    headings: Vec<Heading>,
    /// For each channel its array and its index there.
    homes: Vec<(usize, usize)>,
}

/// Opens a file of `length` bytes and reads which data sets it has.
pub(crate) fn open(
    file: &Path,
    format: Format,
    length: u64,
    variable: Option<&str>,
) -> Result<OpenedHdf5, CommandError> {
    let most = usize::try_from(length).unwrap_or(usize::MAX).saturating_mul(LARGEST_RATIO);
    let options = OpenOptions::default().with_max_read_bytes(most.max(ALWAYS_ALLOWED));
    let fault = |error: Error| damaged(file, &error);
    let opened = Hdf5File::open_with_options(file, options).map_err(fault)?;
    let mut found = Found { arrays: Vec::new(), others: Vec::new() };
    found.group(&opened.root_group().map_err(fault)?, "", 0).map_err(fault)?;
    let Found { arrays, others } = found;
    let all: Vec<&str> = arrays
        .iter()
        .map(|array| array.path.as_str())
        .chain(others.iter().map(|(path, _)| path.as_str()))
        .collect();
    let names = paths::chosen(&all, variable);
    if let (Some(variable), true) = (variable, names.iter().all(Option::is_none)) {
        return Err(in_file(file, &FormatError::no_variable(variable, &all)));
    }
    if arrays.is_empty() {
        let found = if others.is_empty() { "nothing" } else { "other data sets" }.to_owned();
        return Err(in_file(file, &FormatError::NoNumbers { found }));
    }
    let first = usize::from(format == Format::Mat73);
    let (mut headings, mut homes) = (Vec::new(), Vec::new());
    for (index, (array, name)) in arrays.iter().zip(&names).enumerate() {
        let Some(name) = name else { continue };
        for channel in 0..array.channels {
            let name = match array.channels {
                1 => name.clone(),
                _ => format!("{name}_{}", channel + first),
            };
            headings.push(Heading { samples: Some(array.samples), ..super::text::heading(&name) });
            homes.push((index, channel));
        }
    }
    for ((_, why), name) in others.iter().zip(&names[arrays.len()..]) {
        let Some(name) = name else { continue };
        headings.push(Heading { fault: Some(why.clone()), ..Heading::named(name) });
        homes.push((usize::MAX, 0));
    }
    Ok(OpenedHdf5 { file: file.to_owned(), format, arrays, headings, homes })
}

impl Opened for OpenedHdf5 {
    fn format(&self) -> Format {
        self.format
    }

    fn headings(&self) -> &[Heading] {
        &self.headings
    }

    fn read(self: Box<Self>, chosen: Chosen) -> Result<Table, CommandError> {
        let Self { file, format, arrays, headings, homes } = *self;
        let chosen = chosen.channels;
        let mut values = vec![Vec::new(); chosen.len()];
        for (index, array) in arrays.iter().enumerate() {
            let wanted: Vec<(usize, usize)> = chosen
                .iter()
                .enumerate()
                .filter(|(_, channel)| homes[**channel].0 == index)
                .map(|(slot, channel)| (slot, homes[*channel].1))
                .collect();
            if wanted.is_empty() {
                continue;
            }
            let bytes = array.dataset.read_raw_bytes().map_err(|error| damaged(&file, &error))?;
            for (slot, channel) in wanted {
                values[slot] = array.channel(&bytes, channel);
            }
        }
        if values.first().is_none_or(Vec::is_empty) {
            return Err(in_file(&file, &FormatError::Empty));
        }
        Table::of_arrays(format, headings, chosen, values).finite(&file)
    }
}

impl Array {
    fn channel(&self, bytes: &[u8], channel: usize) -> Vec<f64> {
        let place = |sample: usize| {
            if self.by_sample {
                sample * self.channels + channel
            } else {
                channel * self.samples + sample
            }
        };
        let number = |sample: usize| {
            let from = place(sample).checked_mul(self.width)?.checked_add(self.offset)?;
            self.number.read(bytes.get(from..)?)
        };
        (0..self.samples).map(|sample| number(sample).unwrap_or(f64::NAN)).collect()
    }
}

impl Number {
    /// What a type stands for, where it is a number.
    fn of(kind: &Datatype) -> Option<Self> {
        match kind {
            Datatype::FloatingPoint { size: size @ (4 | 8), byte_order } => {
                Some(Self::Float { bytes: usize::from(*size), big: is_big(byte_order) })
            }
            Datatype::FixedPoint { size: size @ (1 | 2 | 4 | 8), signed, byte_order } => {
                let (bytes, signed) = (usize::from(*size), *signed);
                Some(Self::Whole { bytes, big: is_big(byte_order), signed })
            }
            // A truth value, as h5py writes it.
            Datatype::Enum { base, .. } => Self::of(base),
            _ => None,
        }
    }

    fn read(self, bytes: &[u8]) -> Option<f64> {
        let (length, big) = match self {
            Self::Float { bytes, big } | Self::Whole { bytes, big, .. } => (bytes, big),
        };
        // In little-endian order, filled up with zeros.
        let mut all = [0; 8];
        for (index, byte) in bytes.get(..length)?.iter().enumerate() {
            all[if big { length - 1 - index } else { index }] = *byte;
        }
        let whole = u64::from_le_bytes(all);
        Some(match self {
            Self::Float { bytes: 4, .. } => {
                f64::from(f32::from_le_bytes([all[0], all[1], all[2], all[3]]))
            }
            Self::Float { .. } => f64::from_le_bytes(all),
            Self::Whole { signed: false, .. } => whole as f64,
            Self::Whole { .. } => {
                let unused = 64 - 8 * length;
                ((whole << unused).cast_signed() >> unused) as f64
            }
        })
    }
}

fn is_big(order: &ByteOrder) -> bool {
    matches!(order, ByteOrder::BigEndian)
}

/// What has been found in a file so far.
struct Found {
    arrays: Vec<Array>,
    /// Data sets that are no channels, and why.
    others: Vec<(String, String)>,
}

impl Found {
    fn group(&mut self, group: &Group, path: &str, depth: usize) -> Result<(), Error> {
        if depth > DEEPEST {
            return Ok(());
        }
        let (groups, datasets) = group.members()?;
        let within = |name: &str| {
            let name = name.rsplit('/').next().unwrap_or(name);
            if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") }
        };
        for dataset in datasets {
            if self.arrays.len() + self.others.len() >= MOST {
                return Ok(());
            }
            let path = within(dataset.name());
            self.dataset(dataset, path);
        }
        for group in groups {
            // What MATLAB keeps for its own use.
            if !group.name().rsplit('/').next().unwrap_or_default().starts_with('#') {
                self.group(&group, &within(group.name()), depth + 1)?;
            }
        }
        Ok(())
    }

    fn dataset(&mut self, dataset: Dataset, path: String) {
        let size = |size: &u64| usize::try_from(*size).unwrap_or(usize::MAX);
        let (samples, channels, by_sample) = match dataset.shape() {
            [] => (1, 1, true),
            [n] => (size(n), 1, true),
            [rows, columns] if rows >= columns => (size(rows), size(columns), true),
            [rows, columns] => (size(columns), size(rows), false),
            other => {
                let why = format!("it has {} dimensions; one or two are needed", other.len());
                return self.others.push((path, why));
            }
        };
        if samples == 0 || channels == 0 {
            return self.others.push((path, "it is empty".to_owned()));
        }
        if channels > MOST {
            let why = format!("it has {channels} channels; {MOST} are read at most");
            return self.others.push((path, why));
        }
        let is_text = dataset.attribute("MATLAB_class").is_ok_and(|class| {
            class.read_string().is_ok_and(|class| matches!(class.as_str(), "char" | "cell"))
        });
        let kind = dataset.dtype().clone();
        let array = |path, dataset, [width, offset]: [usize; 2], number| Array {
            path,
            dataset,
            samples,
            channels,
            by_sample,
            width,
            offset,
            number,
        };
        if let Datatype::Compound { size, fields } = &kind
            && channels == 1
        {
            let width = usize::try_from(*size).unwrap_or(usize::MAX);
            for field in fields {
                let path = format!("{path}.{}", field.name);
                let offset = usize::try_from(field.byte_offset).unwrap_or(usize::MAX);
                match Number::of(&field.datatype) {
                    Some(number) => {
                        self.arrays.push(array(path, dataset.clone(), [width, offset], number));
                    }
                    None => self.others.push((path, "it holds no numbers".to_owned())),
                }
            }
            return;
        }
        match Number::of(&kind).filter(|_| !is_text) {
            Some(number) => {
                let width = match number {
                    Number::Float { bytes, .. } | Number::Whole { bytes, .. } => bytes,
                };
                self.arrays.push(array(path, dataset, [width, 0], number));
            }
            None => self.others.push((path, "it holds no numbers".to_owned())),
        }
    }
}

fn damaged(file: &Path, error: &Error) -> CommandError {
    in_file(file, &FormatError::Hdf5 { what: error.to_string() })
}
