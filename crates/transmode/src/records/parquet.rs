//! Parquet files: the flat columns of numbers in them are channels; a null is a gap.

mod guarded;

use std::fs::File;
use std::path::{Path, PathBuf};

use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::DataType;
use parquet::errors::ParquetError;
use parquet::file::metadata::ColumnChunkMetaData;
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};

use guarded::guarded;

use super::format::Format;
use super::format_error::FormatError;
use super::progress::Bar;
use super::table::{Chosen, Heading, Opened, Table};
use crate::CommandError;
use crate::error::in_file;

/// Rows that are decoded at once.
const AT_ONCE: usize = 1 << 16;

/// A file whose description has been read, which is at its end.
pub(crate) struct OpenedParquet {
    file: PathBuf,
    /// Bytes of the file.
    length: u64,
    reader: SerializedFileReader<File>,
    headings: Vec<Heading>,
    bar: Bar,
}

/// Opens a file and reads which columns it has.
pub(crate) fn open(file: &Path, source: File, bar: Bar) -> Result<OpenedParquet, CommandError> {
    let length = source
        .metadata()
        .map_err(|error| in_file(file, &FormatError::Archive { what: error.to_string() }))?
        .len();
    let reader = SerializedFileReader::new(source).map_err(|error| damaged(file, &error))?;
    let description = reader.metadata().file_metadata();
    let samples = usize::try_from(description.num_rows()).ok();
    let heading = |column: &parquet::schema::types::ColumnDescPtr| {
        let nested = column.max_rep_level() > 0;
        let fault = nested.then(|| "it is a list; a plain column is needed".to_owned());
        Heading { samples, fault, ..super::text::heading(&column.path().string()) }
    };
    let headings = description.schema_descr().columns().iter().map(heading).collect();
    Ok(OpenedParquet { file: file.to_owned(), length, reader, headings, bar })
}

impl Opened for OpenedParquet {
    fn format(&self) -> Format {
        Format::Parquet
    }

    fn headings(&self) -> &[Heading] {
        &self.headings
    }

    fn read(self: Box<Self>, chosen: Chosen) -> Result<Table, CommandError> {
        let chosen = chosen.channels;
        let mut values = vec![Vec::new(); chosen.len()];
        for index in 0..self.reader.num_row_groups() {
            let group = self.reader.get_row_group(index);
            let group = group.map_err(|error| damaged(&self.file, &error))?;
            for (column, values) in chosen.iter().zip(&mut values) {
                self.column(group.as_ref(), *column, values)
                    .map_err(|error| damaged(&self.file, &error))?;
            }
        }
        let Self { file, headings, .. } = *self;
        if values.first().is_none_or(Vec::is_empty) {
            return Err(in_file(&file, &FormatError::Empty));
        }
        Table::of_arrays(Format::Parquet, headings, chosen, values).finite(&file)
    }
}

impl OpenedParquet {
    /// Appends the numbers that a group of rows has in one column.
    fn column(
        &self,
        group: &dyn RowGroupReader,
        column: usize,
        values: &mut Vec<f64>,
    ) -> Result<(), ParquetError> {
        let size = group.metadata().column(column).compressed_size();
        within(group.metadata().column(column), self.length)?;
        let schema = self.reader.metadata().file_metadata().schema_descr();
        let highest = schema.column(column).max_def_level();
        let name = &self.headings[column].name;
        let found = guarded(|| match group.get_column_reader(column)? {
            ColumnReader::DoubleColumnReader(reader) => numbers(reader, highest, |x| x, values),
            ColumnReader::FloatColumnReader(reader) => numbers(reader, highest, f64::from, values),
            ColumnReader::Int32ColumnReader(reader) => numbers(reader, highest, f64::from, values),
            ColumnReader::Int64ColumnReader(reader) => {
                numbers(reader, highest, |x| x as f64, values)
            }
            ColumnReader::BoolColumnReader(reader) => {
                numbers(reader, highest, |x| f64::from(u8::from(x)), values)
            }
            _ => Err(ParquetError::General(format!(
                "column {name:?} holds no numbers; choose others with --outputs"
            ))),
        });
        found
            .unwrap_or_else(|| Err(ParquetError::General(format!("column {name:?} is damaged"))))?;
        self.bar.advance(u64::try_from(size).unwrap_or(0));
        Ok(())
    }
}

fn damaged(file: &Path, error: &ParquetError) -> CommandError {
    in_file(file, &FormatError::Archive { what: error.to_string() })
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
