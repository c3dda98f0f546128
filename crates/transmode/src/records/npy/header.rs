//! The dictionary in an NPY header: `{'descr': '<f8', 'fortran_order': False, 'shape': (2000, 3), }`.

use crate::records::binary::Layout;
use crate::records::format_error::FormatError;

/// What one element of an array is.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Descr {
    Number(String),
    /// The fields of a structure, in their order.
    Structure(Vec<Field>),
}

/// A field of a structure: `('p', '<f4')`, or `('xyz', '<f4', (3,))`.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Field {
    pub(super) name: String,
    pub(super) descr: String,
    /// Numbers in it.
    pub(super) count: u64,
}

/// The three entries.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Header {
    pub(super) descr: Descr,
    pub(super) layout: Layout,
    pub(super) shape: Vec<u64>,
}

impl Header {
    /// Reads the entries in any order; a literal of Python, of the form that numpy writes.
    pub(super) fn parse(text: &str) -> Result<Self, FormatError> {
        let (mut descr, mut layout, mut shape) = (None, None, None);
        let mut rest = Rest(text);
        rest.expect('{')?;
        while !rest.take('}') {
            let key = rest.quoted()?;
            rest.expect(':')?;
            let repeated = match key {
                "descr" if rest.next_is('[') => {
                    descr.replace(Descr::Structure(rest.fields()?)).is_some()
                }
                "descr" => descr.replace(Descr::Number(rest.quoted()?.to_owned())).is_some(),
                "fortran_order" => layout.replace(rest.layout()?).is_some(),
                "shape" => shape.replace(rest.sizes()?).is_some(),
                _ => return bad("an entry is neither descr nor fortran_order nor shape"),
            };
            if repeated {
                return bad("an entry is there twice");
            }
            if !rest.take(',') {
                rest.expect('}')?;
                break;
            }
        }
        if !rest.0.trim().is_empty() {
            return bad("something follows its end");
        }
        match (descr, layout, shape) {
            (Some(descr), Some(layout), Some(shape)) => Ok(Self { descr, layout, shape }),
            _ => bad("descr, fortran_order or shape is missing"),
        }
    }
}

fn bad<T>(what: &'static str) -> Result<T, FormatError> {
    Err(FormatError::BadHeader { what })
}

/// What is left to read.
struct Rest<'a>(&'a str);

impl<'a> Rest<'a> {
    fn next_is(&mut self, expected: char) -> bool {
        self.0 = self.0.trim_start();
        self.0.starts_with(expected)
    }

    fn take(&mut self, expected: char) -> bool {
        let found = self.next_is(expected);
        if found {
            self.0 = &self.0[expected.len_utf8()..];
        }
        found
    }

    fn expect(&mut self, expected: char) -> Result<(), FormatError> {
        if self.take(expected) { Ok(()) } else { bad("it is no dictionary of three entries") }
    }

    fn quoted(&mut self) -> Result<&'a str, FormatError> {
        for quote in ['\'', '"'] {
            if self.take(quote) {
                let Some((inside, rest)) = self.0.split_once(quote) else {
                    return bad("a quote never ends");
                };
                self.0 = rest;
                return Ok(inside);
            }
        }
        bad("a text in quotes is missing")
    }

    /// Fortran's order has the samples of a channel beside each other.
    fn layout(&mut self) -> Result<Layout, FormatError> {
        self.0 = self.0.trim_start();
        for (word, layout) in
            [("False", Layout::SampleBySample), ("True", Layout::ChannelByChannel)]
        {
            if let Some(rest) = self.0.strip_prefix(word) {
                self.0 = rest;
                return Ok(layout);
            }
        }
        bad("fortran_order is neither True nor False")
    }

    /// `[('t', '<f8'), ('xyz', '<f4', (3,))]`; a field with a title has a pair in place of its name.
    fn fields(&mut self) -> Result<Vec<Field>, FormatError> {
        let mut fields = Vec::new();
        self.expect('[')?;
        while !self.take(']') {
            self.expect('(')?;
            let name = if self.take('(') {
                self.quoted()?;
                self.expect(',')?;
                let name = self.quoted()?;
                self.expect(')')?;
                name
            } else {
                self.quoted()?
            };
            self.expect(',')?;
            if self.next_is('[') {
                return Err(FormatError::Structured);
            }
            let descr = self.quoted()?.to_owned();
            let mut count = 1_u64;
            if self.take(',') && !self.next_is(')') {
                for size in self.sizes()? {
                    count = count.saturating_mul(size);
                }
            }
            self.expect(')')?;
            fields.push(Field { name: name.to_owned(), descr, count });
            if !self.take(',') {
                self.expect(']')?;
                break;
            }
        }
        Ok(fields)
    }

    fn sizes(&mut self) -> Result<Vec<u64>, FormatError> {
        let mut sizes = Vec::new();
        self.expect('(')?;
        while !self.take(')') {
            self.0 = self.0.trim_start();
            let end = self.0.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.0.len());
            let (digits, rest) = self.0.split_at(end);
            let Ok(size) = digits.parse() else {
                return bad("the shape holds something else than sizes");
            };
            sizes.push(size);
            // Python 2 marks a long integer.
            self.0 = rest.strip_prefix('L').unwrap_or(rest);
            if !self.take(',') {
                self.expect(')')?;
                break;
            }
        }
        Ok(sizes)
    }
}

#[cfg(test)]
mod tests;
