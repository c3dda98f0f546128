//! Parquet files: the flat columns of numbers in them are channels; a null is a gap.

mod guarded;

use std::fs::File;
use std::path::Path;

use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::DataType;
use parquet::errors::ParquetError;
use parquet::file::metadata::ColumnChunkMetaData;
use parquet::file::reader::{FileReader, SerializedFileReader};

use guarded::guarded;

use super::format::Format;
use super::format_error::FormatError;
use super::progress::Bar;
use super::table::{Choose, Heading, Places, Table};
use super::{finite, in_file};
use crate::CommandError;

/// Rows that are decoded at once.
const AT_ONCE: usize = 1 << 16;

/// Reads the chosen columns.
pub(crate) fn read(
    file: &Path,
    source: File,
    choose: &mut Choose<'_>,
    bar: &Bar,
) -> Result<Table, CommandError> {
    let fault =
        |error: ParquetError| in_file(file, &FormatError::Archive { what: error.to_string() });
    let length = source
        .metadata()
        .map_err(|error| in_file(file, &FormatError::Archive { what: error.to_string() }))?
        .len();
    let reader = SerializedFileReader::new(source).map_err(fault)?;
    let metadata = reader.metadata();
    let samples = usize::try_from(metadata.file_metadata().num_rows()).ok();
    let heading = |column: &parquet::schema::types::ColumnDescPtr| {
        let nested = column.max_rep_level() > 0;
        let fault = nested.then(|| "it is a list; a plain column is needed".to_owned());
        Heading { samples, fault, ..super::text::heading(&column.path().string()) }
    };
    let headings: Vec<Heading> =
        metadata.file_metadata().schema_descr().columns().iter().map(heading).collect();
    let chosen = choose(Format::Parquet, &headings)?.channels;
    let mut values = vec![Vec::new(); chosen.len()];
    for index in 0..reader.num_row_groups() {
        let group = reader.get_row_group(index).map_err(fault)?;
        for (column, values) in chosen.iter().zip(&mut values) {
            let size = group.metadata().column(*column).compressed_size();
            within(group.metadata().column(*column), length).map_err(fault)?;
            let highest = metadata.file_metadata().schema_descr().column(*column).max_def_level();
            let found = guarded(|| match group.get_column_reader(*column)? {
                ColumnReader::DoubleColumnReader(reader) => numbers(reader, highest, |x| x, values),
                ColumnReader::FloatColumnReader(reader) => {
                    numbers(reader, highest, f64::from, values)
                }
                ColumnReader::Int32ColumnReader(reader) => {
                    numbers(reader, highest, f64::from, values)
                }
                ColumnReader::Int64ColumnReader(reader) => {
                    numbers(reader, highest, |x| x as f64, values)
                }
                ColumnReader::BoolColumnReader(reader) => {
                    numbers(reader, highest, |x| f64::from(u8::from(x)), values)
                }
                _ => Err(ParquetError::General(format!(
                    "column {:?} holds no numbers; choose others with --outputs",
                    headings[*column].name
                ))),
            });
            let found = found.unwrap_or_else(|| {
                let what = format!("column {:?} is damaged", headings[*column].name);
                Err(ParquetError::General(what))
            });
            found.map_err(fault)?;
            bar.advance(u64::try_from(size).unwrap_or(0));
        }
    }
    if values.first().is_none_or(Vec::is_empty) {
        return Err(in_file(file, &FormatError::Empty));
    }
    finite(
        file,
        Table { format: Format::Parquet, headings, chosen, values, places: Places::Samples },
    )
}

/// Refuses a column that does not lie within the file: the library takes its place for granted.
fn within(column: &ColumnChunkMetaData, length: u64) -> Result<(), ParquetError> {
    let start = column.dictionary_page_offset().unwrap_or_else(|| column.data_page_offset());
    let end = start.checked_add(column.compressed_size());
    let lies_within = start >= 0
        && column.compressed_size() >= 0
        && end.and_then(|end| u64::try_from(end).ok()).is_some_and(|end| end <= length);
    if lies_within {
        return Ok(());
    }
    Err(ParquetError::General("a column lies beyond the end of the file".to_owned()))
}

/// Appends all numbers of one column of a row group, NaN where there is none: where the definition level is not the `highest`.
fn numbers<T: DataType>(
    mut reader: ColumnReaderImpl<T>,
    highest: i16,
    number: impl Fn(T::T) -> f64,
    values: &mut Vec<f64>,
) -> Result<(), ParquetError> {
    loop {
        let (mut read, mut levels) = (Vec::new(), Vec::new());
        let (rows, ..) = reader.read_records(AT_ONCE, Some(&mut levels), None, &mut read)?;
        if rows == 0 {
            return Ok(());
        }
        if levels.is_empty() {
            values.extend(read.into_iter().map(&number));
            continue;
        }
        let mut read = read.into_iter();
        let next = |level: i16| {
            if level < highest { f64::NAN } else { read.next().map_or(f64::NAN, &number) }
        };
        values.extend(levels.into_iter().map(next));
    }
}

#[cfg(test)]
mod tests;
