//! The elements of a MATLAB file: a tag with type and size, then the bytes, padded to a multiple of eight.

use std::io::{Error, ErrorKind, Read};

use crate::records::binary::ByteOrder;

/// Why a file was not read.
#[derive(Debug)]
pub(super) enum MatError {
    Read(Error),
    Damaged(&'static str),
}

impl From<Error> for MatError {
    fn from(error: Error) -> Self {
        match error.kind() {
            ErrorKind::UnexpectedEof => Self::Damaged("it ends there"),
            // What the decompressor says.
            ErrorKind::InvalidData | ErrorKind::InvalidInput => {
                Self::Damaged("what is compressed is garbled")
            }
            _ => Self::Read(error),
        }
    }
}

/// What an element is and how long.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Tag {
    pub(super) kind: u32,
    pub(super) size: u32,
    /// Bytes that stand in the tag itself, where there are at most four.
    short: Option<[u8; 4]>,
}

/// A variable without its numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Variable {
    pub(super) name: String,
    class: u32,
    complex: bool,
    dimensions: Vec<u64>,
}

/// Longer names and more dimensions than this are damage: MATLAB allows 63 letters.
const LONGEST: u32 = 4096;

impl Tag {
    pub(super) fn read(
        source: &mut (impl Read + ?Sized),
        byte_order: ByteOrder,
    ) -> Result<Self, MatError> {
        let (mut first, mut second) = ([0; 4], [0; 4]);
        source.read_exact(&mut first)?;
        source.read_exact(&mut second)?;
        let word = byte_order.u32(first);
        // A short element has its size in the upper half of the first word, and its bytes in the second.
        match word >> 16 {
            0 => Ok(Self { kind: word, size: byte_order.u32(second), short: None }),
            size @ 1..=4 => Ok(Self { kind: word & 0xffff, size, short: Some(second) }),
            _ => Err(MatError::Damaged("a tag has no type that is known")),
        }
    }

    /// All bytes of a small element.
    pub(super) fn bytes(self, source: &mut dyn Read, longest: u32) -> Result<Vec<u8>, MatError> {
        if let Some(short) = self.short {
            return Ok(short[..self.size as usize].to_vec());
        }
        if self.size > longest {
            return Err(MatError::Damaged("a name or a shape is too long"));
        }
        let mut bytes = vec![0; self.size.next_multiple_of(8) as usize];
        source.read_exact(&mut bytes)?;
        bytes.truncate(self.size as usize);
        Ok(bytes)
    }
}

impl Variable {
    /// Reads the first parts of a matrix: flags, dimensions, name. A field has no name of its own but a path. `None` for one without either, as
    /// MATLAB writes for its own use.
    pub(super) fn read(
        source: &mut dyn Read,
        byte_order: ByteOrder,
        path: Option<String>,
    ) -> Result<Option<Self>, MatError> {
        let flags = Tag::read(source, byte_order)?;
        let bytes = flags.bytes(source, LONGEST)?;
        let Some(first) = bytes.first_chunk::<4>().filter(|_| flags.kind == 6) else {
            return Err(MatError::Damaged("a variable does not start with its flags"));
        };
        let flags = byte_order.u32(*first);
        let class = flags & 0xff;
        // Objects have a layout of their own, without dimensions.
        if class == 17 {
            let name = Tag::read(source, byte_order)?.bytes(source, LONGEST)?;
            let name = path.unwrap_or_else(|| String::from_utf8_lossy(&name).into_owned());
            return Ok(Some(Self { name, class, complex: false, dimensions: Vec::new() }));
        }
        let bytes = Tag::read(source, byte_order)?.bytes(source, LONGEST)?;
        let size = |bytes: &[u8; 4]| u64::from(byte_order.u32(*bytes));
        let dimensions = bytes.as_chunks::<4>().0.iter().map(size).collect();
        let name = Tag::read(source, byte_order)?.bytes(source, LONGEST)?;
        let name = path.unwrap_or_else(|| String::from_utf8_lossy(&name).into_owned());
        if name.is_empty() {
            return Ok(None);
        }
        Ok(Some(Self { name, class, complex: flags & 0x0800 != 0, dimensions }))
    }

    /// Samples and channels, or why it has none.
    pub(super) fn shape(&self) -> Result<[u64; 2], String> {
        if !(6..=15).contains(&self.class) {
            return Err(format!("it is no numeric array but a {}", self.kind()));
        }
        if self.complex {
            return Err("its numbers are complex; real ones are needed".to_owned());
        }
        match self.dimensions[..] {
            [0, _] | [_, 0] => Err("it is empty".to_owned()),
            // A row is a vector, too.
            [1, n] | [n, 1] => Ok([n, 1]),
            [rows, columns] => Ok([rows, columns]),
            _ => Err(format!(
                "it has {} dimensions; a vector or a matrix is needed",
                self.dimensions.len()
            )),
        }
    }

    pub(super) fn class(&self) -> u32 {
        self.class
    }

    /// Number of its elements.
    pub(super) fn elements(&self) -> u64 {
        self.dimensions.iter().fold(1, |product, size| product.saturating_mul(*size))
    }

    /// What MATLAB calls its class.
    pub(super) fn kind(&self) -> &'static str {
        match self.class {
            1 => "cell array",
            2 => "structure",
            3 | 17 => "object",
            4 => "text",
            5 => "sparse matrix",
            6..=15 => "numeric array",
            16 => "function",
            _ => "variable of unknown class",
        }
    }

    /// Calls `each` with every number and its column; the source stands behind the name.
    pub(super) fn numbers(
        &self,
        source: &mut dyn Read,
        byte_order: ByteOrder,
        mut each: impl FnMut(usize, f64),
    ) -> Result<(), MatError> {
        let [rows, columns] =
            self.shape().map_err(|_| MatError::Damaged("a variable changed while it was read"))?;
        let tag = Tag::read(source, byte_order)?;
        let (width, decode) = decoder(tag.kind, byte_order)
            .ok_or(MatError::Damaged("its numbers are of no type that is known"))?;
        if u128::from(rows) * u128::from(columns) * width as u128 != u128::from(tag.size) {
            return Err(MatError::Damaged(
                "a variable has more or fewer numbers than its shape says",
            ));
        }
        let mut short = tag.short.as_ref().map(|short| &short[..]);
        let source: &mut dyn Read = if let Some(short) = &mut short { short } else { source };
        let mut bytes = [0; 4096];
        let (mut left, mut row, mut column) = (u64::from(tag.size), 0, 0);
        while left > 0 {
            let count = usize::try_from(left).unwrap_or(usize::MAX).min(bytes.len());
            source.read_exact(&mut bytes[..count])?;
            for number in bytes[..count].chunks_exact(width) {
                each(column, decode(number));
                row += 1;
                if row == rows {
                    (row, column) = (0, column + 1);
                }
            }
            left -= count as u64;
        }
        Ok(())
    }
}

type Decode = fn(&[u8]) -> f64;

/// How wide numbers of a type are and what they stand for. MATLAB shortens doubles that are whole numbers.
fn decoder(kind: u32, byte_order: ByteOrder) -> Option<(usize, Decode)> {
    macro_rules! number {
        ($type:ty) => {{
            const WIDTH: usize = size_of::<$type>();
            let little: Decode =
                |b| b.first_chunk().map_or(f64::NAN, |b| <$type>::from_le_bytes(*b) as f64);
            let big: Decode =
                |b| b.first_chunk().map_or(f64::NAN, |b| <$type>::from_be_bytes(*b) as f64);
            Some((WIDTH, if byte_order == ByteOrder::Little { little } else { big }))
        }};
    }
    match kind {
        1 => number!(i8),
        2 => number!(u8),
        3 => number!(i16),
        4 => number!(u16),
        5 => number!(i32),
        6 => number!(u32),
        7 => number!(f32),
        9 => number!(f64),
        12 => number!(i64),
        13 => number!(u64),
        _ => None,
    }
}
