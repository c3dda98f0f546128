//! Records as NPY, NPZ, MATLAB and raw files, written as numpy and MATLAB do.

use std::io::Write;

/// How an NPY file is written.
#[derive(Clone, Copy)]
pub(crate) struct Array {
    /// `<f8`, `>f8`, `<f4` or `>f4`.
    pub(crate) descr: &'static str,
    pub(crate) fortran_order: bool,
}

impl Default for Array {
    fn default() -> Self {
        Self { descr: "<f8", fortran_order: false }
    }
}

/// An array of samples x channels from its columns.
pub(crate) fn npy(columns: &[Vec<f64>], array: Array) -> Vec<u8> {
    let samples = columns[0].len();
    let shape = format!("({samples}, {})", columns.len());
    let mut bytes = header(array.descr, array.fortran_order, &shape);
    let mut add = |value: f64| {
        #[expect(clippy::cast_possible_truncation, reason = "the file holds four bytes")]
        let short = value as f32;
        match array.descr {
            "<f8" => bytes.extend(value.to_le_bytes()),
            ">f8" => bytes.extend(value.to_be_bytes()),
            "<f4" => bytes.extend(short.to_le_bytes()),
            ">f4" => bytes.extend(short.to_be_bytes()),
            other => panic!("{other}"),
        }
    };
    if array.fortran_order {
        columns.iter().flatten().copied().for_each(add);
    } else {
        (0..samples).for_each(|k| columns.iter().for_each(|column| add(column[k])));
    }
    bytes
}

/// The header of version 1.0, padded to a multiple of 64 bytes.
pub(crate) fn header(descr: &str, fortran_order: bool, shape: &str) -> Vec<u8> {
    let order = if fortran_order { "True" } else { "False" };
    let entries = format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}");
    let length = (10 + entries.len() + 1).next_multiple_of(64) - 10;
    let size = u16::try_from(length).unwrap().to_le_bytes();
    let text = format!("{entries:width$}\n", width = length - 1);
    [b"\x93NUMPY\x01\x00", &size[..], text.as_bytes()].concat()
}

/// Little-endian doubles, one sample of all channels after another.
pub(crate) fn raw(columns: &[Vec<f64>]) -> Vec<u8> {
    let sample = |k: usize| columns.iter().flat_map(move |column| column[k].to_le_bytes());
    (0..columns[0].len()).flat_map(sample).collect()
}

/// An array of one dimension.
pub(crate) fn npy_vector(values: &[f64]) -> Vec<u8> {
    let mut bytes = header("<f8", false, &format!("({},)", values.len()));
    bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    bytes
}

/// An archive of files, deflated.
pub(crate) fn archive(members: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let mut writer = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (name, bytes) in members {
        writer.start_file(*name, zip::write::SimpleFileOptions::default()).unwrap();
        writer.write_all(bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

/// Compressed as gzip does.
pub(crate) fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// Compressed as in `save -v7`, or not, as in `save -v6`.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Mat {
    V6,
    V7,
}

/// A MATLAB file of level 5: name, class, rows, columns, numbers column by column. Class 4 is text, 6 is double.
pub(crate) fn mat(version: Mat, variables: &[(&str, u32, [usize; 2], &[f64])]) -> Vec<u8> {
    let mut file = b"MATLAB 5.0 MAT-file, written by a test".to_vec();
    file.resize(124, b' ');
    file.extend(b"\x00\x01IM");
    let word = |value: usize| u32::try_from(value).unwrap().to_le_bytes();
    let element = |kind: usize, bytes: &[u8]| {
        let mut element = [word(kind), word(bytes.len())].concat();
        element.extend(bytes);
        element.resize(element.len().next_multiple_of(8), 0);
        element
    };
    for (name, class, [rows, columns], numbers) in variables {
        let flags = [class.to_le_bytes(), [0; 4]].concat();
        let numbers: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
        let parts = [
            element(6, &flags),
            element(5, &[word(*rows), word(*columns)].concat()),
            element(1, name.as_bytes()),
            element(9, &numbers),
        ];
        let matrix = element(14, &parts.concat());
        if version == Mat::V6 {
            file.extend(matrix);
            continue;
        }
        let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::fast());
        encoder.write_all(&matrix).unwrap();
        let packed = encoder.finish().unwrap();
        file.extend([word(15), word(packed.len())].concat());
        file.extend(packed);
    }
    file
}
