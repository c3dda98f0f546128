use crate::records::options::ReadOptions;
use std::sync::Arc;

use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int32Type};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;

use super::*;
use crate::records::Progress;

/// Two groups of rows: time, a sensor with a missing sample, whole numbers, text.
fn file(folder: &Path) -> PathBuf {
    let schema = "message schema { REQUIRED DOUBLE time; OPTIONAL DOUBLE beta; REQUIRED INT32 count; REQUIRED BINARY state; }";
    let schema = Arc::new(parse_message_type(schema).unwrap());
    let path = folder.join("x.parquet");
    let properties = Arc::new(WriterProperties::default());
    let mut writer =
        SerializedFileWriter::new(File::create(&path).unwrap(), schema, properties).unwrap();
    for start in [0.0, 3.0] {
        let mut group = writer.next_row_group().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        let times = [start, start + 1.0, start + 2.0];
        column.typed::<DoubleType>().write_batch(&times, None, None).unwrap();
        column.close().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        column.typed::<DoubleType>().write_batch(&[0.5, 1.5], Some(&[1, 0, 1]), None).unwrap();
        column.close().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        column.typed::<Int32Type>().write_batch(&[7, -8, 9], None, None).unwrap();
        column.close().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        let states = vec![ByteArray::from("on"); 3];
        column.typed::<ByteArrayType>().write_batch(&states, None, None).unwrap();
        column.close().unwrap();
        group.close().unwrap();
    }
    writer.close().unwrap();
    path
}

/// The channels that `choose` wants of a file with so many.
fn read(path: &Path, choose: impl Fn(usize) -> Vec<usize>) -> Result<Table, CommandError> {
    let opened = crate::records::open::open(path, &ReadOptions::default(), Progress::Hidden)?;
    let channels = choose(opened.headings().len());
    opened.read(Chosen { channels, ..Chosen::default() })
}

fn first_three(channels: usize) -> Vec<usize> {
    (0..channels.min(3)).collect()
}

fn loaded(chosen: &[usize]) -> Result<Table, String> {
    let folder = tempfile::tempdir().unwrap();
    let path = file(folder.path());
    read(&path, |_| chosen.to_vec()).map_err(|error| error.to_string())
}

#[test]
fn columns_are_channels_and_a_null_is_a_gap() {
    let table = loaded(&[1, 0, 2]).unwrap();
    let names: Vec<_> = table.headings.iter().map(|heading| heading.name.as_str()).collect();
    assert_eq!(names, ["time", "beta", "count", "state"]);
    assert_eq!(format!("{:?}", table.values[0]), "[0.5, NaN, 1.5, 0.5, NaN, 1.5]");
    assert_eq!(table.values[1], [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
    assert_eq!(table.values[2], [7.0, -8.0, 9.0, 7.0, -8.0, 9.0]);
}

#[test]
fn a_column_of_text_is_refused() {
    let message = loaded(&[3]).unwrap_err();
    assert!(message.contains("\"state\" holds no numbers; choose others"), "{message}");
}

/// Every byte, changed in several ways: a table or a sentence, and never a panic.
#[test]
fn any_changed_byte_gets_an_answer() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(folder.path());
    let whole = std::fs::read(&path).unwrap();
    let (mut good, mut refused) = (0, 0);
    for place in 0..whole.len() {
        for change in [0x01, 0x10, 0x80, 0xff] {
            let mut damaged = whole.clone();
            damaged[place] ^= change;
            std::fs::write(&path, &damaged).unwrap();
            match read(&path, first_three) {
                Ok(_) => good += 1,
                Err(error) => {
                    assert!(!error.to_string().is_empty());
                    refused += 1;
                }
            }
        }
    }
    assert!(good > 0 && refused > 0, "{good} {refused}");
}

#[test]
fn a_damaged_file_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(folder.path());
    let whole = std::fs::read(&path).unwrap();
    for length in (4..whole.len()).step_by(7) {
        std::fs::write(&path, &whole[..length]).unwrap();
        assert!(read(&path, first_three).is_err(), "{length}");
    }
}
