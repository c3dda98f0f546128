//! Records as NPY and raw files, written as numpy does.

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
