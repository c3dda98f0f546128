//! MATLAB files of level 5 (`save -v7` and `-v6`): the numeric vectors and matrices in them are channels.
//!
//! A vector is a channel, called like the variable; a matrix `x` of samples x channels has the channels `x_1`, `x_2` and so on, and so has one
//! of channels x samples, if it is much wider than high. Fields of structures are variables called `log.imu.p`, without what is common to all. Single numbers
//! and whatever is no numeric array are passed over unless they are asked for.
//!
//! The format is read here, in two small files. The crates for it: matfile 0.5.0 (October 2024) panics on a damaged size, prints to standard output,
//! and refuses doubles that Octave shortened to bytes; matio-rs binds a C library that would have to be installed.
//!
//! Format: The MathWorks, "MAT-File Format", level 5.

mod element;
mod structure;

use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use flate2::read::ZlibDecoder;

use super::binary::ByteOrder;
use super::format::Format;
use super::format_error::FormatError;
use super::paths;
use super::segments::SHORTEST;
use super::table::{Chosen, Heading, Opened, Table};
use crate::CommandError;
use crate::error::in_file;
use element::{MatError, Tag, Variable};

/// Bytes of the header.
const HEADER: u64 = 128;

/// The types of an element on the outermost level.
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;

/// More columns than this are refused: the matrix is the wrong way round.
const MOST_COLUMNS: u64 = 10_000;

/// A variable and where its element starts.
struct Place {
    at: u64,
    /// Which of the variables in that element it is, if it is a structure.
    ordinal: usize,
    variable: Variable,
}

/// A file whose variables are known, and not their numbers.
pub(crate) struct OpenedMat<R> {
    file: PathBuf,
    source: R,
    byte_order: ByteOrder,
    places: Vec<Place>,
    headings: Vec<Heading>,
    /// For each channel its variable and its column there.
    homes: Vec<(usize, usize)>,
}

/// Opens a file of `length` bytes and reads what variables it has.
pub(crate) fn open<R: Read + Seek>(
    file: &Path,
    mut source: R,
    length: u64,
    variable: Option<&str>,
) -> Result<OpenedMat<R>, CommandError> {
    let fault = |at, error| in_words(file, at, error);
    let byte_order = byte_order(&mut source).map_err(|error| fault(0, error))?;
    let mut places: Vec<Place> = Vec::new();
    let mut at = HEADER;
    while at < length {
        let mut found = Vec::new();
        let mut each = |element: &mut dyn Read| {
            structure::walk(element, byte_order, &mut |variable, _| {
                found.push(variable);
                Ok(())
            })
        };
        let (_, next) =
            visit(&mut source, byte_order, at, &mut each).map_err(|error| fault(at, error))?;
        if next > length {
            return Err(fault(at, MatError::Damaged("the file ends within a variable")));
        }
        let place = |(ordinal, variable)| Place { at, ordinal, variable };
        places.extend(found.into_iter().enumerate().map(place));
        at = next;
    }
    let names: Vec<&str> = places.iter().map(|place| place.variable.name.as_str()).collect();
    let names = paths::chosen(&names, variable);
    if let (Some(variable), true) = (variable, names.iter().all(Option::is_none)) {
        let all: Vec<&str> = places.iter().map(|place| place.variable.name.as_str()).collect();
        return Err(in_file(file, &FormatError::no_variable(variable, &all)));
    }
    let mut is_in_structure: Vec<bool> =
        places.iter().map(|place| place.variable.name.contains('.')).collect();
    let mut next = names.iter();
    is_in_structure.retain(|_| next.next().is_some_and(Option::is_some));
    let mut at = 0;
    places.retain(|_| {
        at += 1;
        names[at - 1].is_some()
    });
    for (place, name) in places.iter_mut().zip(names.into_iter().flatten()) {
        place.variable.name = name;
    }
    let (mut headings, homes) = headings(&places);
    if variable.is_none() {
        // Beside plain vectors, structures and matrices of rows hold other things.
        let is_plain = |(index, _): &(usize, usize)| {
            !is_in_structure[*index] && !is_wide(&places[*index].variable)
        };
        let is_plain: Vec<bool> = homes.iter().map(is_plain).collect();
        Heading::prefer(&mut headings, &is_plain);
    }
    if headings.iter().all(|heading| heading.fault.is_some()) {
        return Err(in_file(file, &FormatError::NoNumbers { found: kinds(&places) }));
    }
    Ok(OpenedMat { file: file.to_owned(), source, byte_order, places, headings, homes })
}

impl<R: Read + Seek> Opened for OpenedMat<R> {
    fn format(&self) -> Format {
        Format::Mat
    }

    fn headings(&self) -> &[Heading] {
        &self.headings
    }

    fn read(self: Box<Self>, chosen: Chosen) -> Result<Table, CommandError> {
        let Self { file, mut source, byte_order, places, headings, homes } = *self;
        let chosen = chosen.channels;
        let mut values = vec![Vec::new(); chosen.len()];
        for (index, place) in places.iter().enumerate() {
            let mut wanted: Vec<(usize, usize)> = Vec::new();
            for (slot, channel) in chosen.iter().enumerate() {
                if homes[*channel].0 == index {
                    wanted.push((homes[*channel].1, slot));
                }
            }
            if wanted.is_empty() {
                continue;
            }
            let is_wide = is_wide(&place.variable);
            let rows = place.variable.shape().map_or(1, |[rows, _]| rows);
            let rows = usize::try_from(rows).unwrap_or(usize::MAX);
            let mut ordinal = 0;
            let mut each = |element: &mut dyn Read| {
                structure::walk(element, byte_order, &mut |variable, inside| {
                    ordinal += 1;
                    if ordinal != place.ordinal + 1 {
                        return Ok(());
                    }
                    let mut row = 0;
                    variable.numbers(inside, byte_order, |column, number| {
                        // MATLAB writes column after column; in a wide matrix those are samples.
                        let channel = if is_wide { row } else { column };
                        row = if row + 1 == rows { 0 } else { row + 1 };
                        for (_, slot) in wanted.iter().filter(|(wanted, _)| *wanted == channel) {
                            values[*slot].push(number);
                        }
                    })
                })
            };
            visit(&mut source, byte_order, place.at, &mut each)
                .map_err(|error| in_words(&file, place.at, error))?;
        }
        Table::of_arrays(Format::Mat, headings, chosen, values).finite(&file)
    }
}

fn in_words(file: &Path, at: u64, error: MatError) -> CommandError {
    match error {
        MatError::Read(source) => CommandError::Read { file: file.to_owned(), source },
        MatError::Damaged(what) => in_file(file, &FormatError::DamagedMat { at, what }),
    }
}

/// The order of bytes, from the header.
fn byte_order(source: &mut impl Read) -> Result<ByteOrder, MatError> {
    let mut header = [0; 128];
    source.read_exact(&mut header)?;
    match &header[124..] {
        [0, 1, b'I', b'M'] => Ok(ByteOrder::Little),
        [1, 0, b'M', b'I'] => Ok(ByteOrder::Big),
        _ => Err(MatError::Damaged("its header says no version that is known")),
    }
}

/// Has the matrix that starts at `at` read, unpacked; `None` if something else starts there. Also says where the next element starts.
fn visit<T>(
    source: &mut (impl Read + Seek),
    byte_order: ByteOrder,
    at: u64,
    each: &mut dyn FnMut(&mut dyn Read) -> Result<T, MatError>,
) -> Result<(Option<T>, u64), MatError> {
    source.seek(SeekFrom::Start(at))?;
    let tag = Tag::read(source, byte_order)?;
    let next = at + 8 + u64::from(tag.size);
    let mut element = source.take(u64::from(tag.size));
    let found = match tag.kind {
        MATRIX => Some(each(&mut element)?),
        COMPRESSED => {
            let mut unpacked = ZlibDecoder::new(element);
            let inner = Tag::read(&mut unpacked, byte_order)?;
            if inner.kind == MATRIX {
                Some(each(&mut unpacked.take(u64::from(inner.size)))?)
            } else {
                None
            }
        }
        _ => None,
    };
    Ok((found, next))
}

/// Whether a matrix is one of channels x samples: as wide as a record is long, and few rows high.
fn is_wide(variable: &Variable) -> bool {
    variable.shape().is_ok_and(|[rows, columns]| {
        columns > rows && columns >= SHORTEST as u64 && rows <= MOST_COLUMNS
    })
}

/// The channels, and for each its variable and its column there.
fn headings(places: &[Place]) -> (Vec<Heading>, Vec<(usize, usize)>) {
    let (mut headings, mut homes) = (Vec::new(), Vec::new());
    for (index, Place { variable, .. }) in places.iter().enumerate() {
        match variable.shape() {
            Ok(shape) if is_wide(variable) => {
                name_columns(&mut headings, &variable.name, [shape[1], shape[0]]);
                homes.extend((0..usize::try_from(shape[0]).unwrap_or(0)).map(|row| (index, row)));
            }
            Ok([rows, columns]) if columns > rows || columns > MOST_COLUMNS => {
                let fault = format!(
                    "the matrix has {rows} rows and {columns} columns; samples x channels are needed: transpose it"
                );
                headings.push(Heading { fault: Some(fault), ..Heading::named(&variable.name) });
                homes.push((index, 0));
            }
            Ok(shape) => {
                name_columns(&mut headings, &variable.name, shape);
                homes.extend((0..usize::try_from(shape[1]).unwrap_or(0)).map(|at| (index, at)));
            }
            Err(fault) => {
                headings.push(Heading { fault: Some(fault), ..Heading::named(&variable.name) });
                homes.push((index, 0));
            }
        }
    }
    (headings, homes)
}

/// Headings for the channels of one variable of so many samples and channels.
fn name_columns(headings: &mut Vec<Heading>, name: &str, [samples, channels]: [u64; 2]) {
    for channel in 1..=channels {
        let name = if channels == 1 { name.to_owned() } else { format!("{name}_{channel}") };
        let samples = usize::try_from(samples).ok();
        headings.push(Heading { samples, ..Heading::named(name) });
    }
}

/// What there is instead of numbers.
fn kinds(places: &[Place]) -> String {
    let mut kinds: Vec<_> = places.iter().map(|place| place.variable.kind()).collect();
    kinds.sort_unstable();
    kinds.dedup();
    if kinds.is_empty() { "nothing".to_owned() } else { kinds.join(", ") }
}
