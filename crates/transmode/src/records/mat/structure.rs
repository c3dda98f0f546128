//! Structures in MATLAB files: their fields, and those of structures in them, are variables with a path.

use std::io::{Read, copy, sink};

use super::element::{MatError, Tag, Variable};
use crate::records::binary::ByteOrder;

/// Structures in structures, at most; deeper ones are damage.
const DEEPEST: usize = 32;

/// More variables than this are damage, or no record.
const MOST: usize = 100_000;

/// Bytes of the names of all fields of a structure, at most.
const LONGEST_NAMES: u32 = 1 << 20;

/// The class of a structure.
const STRUCTURE: u32 = 2;

const MATRIX: u32 = 14;

/// Calls `each` with every variable that is no structure, its path as its name; the source then stands in front of its numbers.
pub(super) fn walk(
    source: &mut dyn Read,
    byte_order: ByteOrder,
    each: &mut dyn FnMut(Variable, &mut dyn Read) -> Result<(), MatError>,
) -> Result<(), MatError> {
    let mut walk = Walk { byte_order, each, count: 0 };
    match Variable::read(source, byte_order, None)? {
        Some(variable) => walk.variable(variable, source, 0),
        None => Ok(()),
    }
}

struct Walk<'a> {
    byte_order: ByteOrder,
    each: &'a mut dyn FnMut(Variable, &mut dyn Read) -> Result<(), MatError>,
    count: usize,
}

impl Walk<'_> {
    fn variable(
        &mut self,
        variable: Variable,
        source: &mut dyn Read,
        depth: usize,
    ) -> Result<(), MatError> {
        self.count += 1;
        if depth > DEEPEST || self.count > MOST {
            return Err(MatError::Damaged("its structures have no end"));
        }
        if variable.class() != STRUCTURE {
            return (self.each)(variable, source);
        }
        let fields = self.field_names(source)?;
        let elements = variable.elements();
        if elements.saturating_mul(fields.len() as u64) > MOST as u64 {
            return Err(MatError::Damaged("a structure has too many elements"));
        }
        for element in 1..=elements {
            for field in &fields {
                let index = if elements > 1 { format!("({element})") } else { String::new() };
                let path = format!("{}{index}.{field}", variable.name);
                self.field(path, source, depth)?;
            }
        }
        Ok(())
    }

    fn field(&mut self, path: String, source: &mut dyn Read, depth: usize) -> Result<(), MatError> {
        let tag = Tag::read(source, self.byte_order)?;
        if tag.kind != MATRIX {
            return Err(MatError::Damaged("a field of a structure is no array"));
        }
        let mut inside = source.take(u64::from(tag.size));
        // An empty field has no header.
        if tag.size > 0
            && let Some(variable) = Variable::read(&mut inside, self.byte_order, Some(path))?
        {
            self.variable(variable, &mut inside, depth + 1)?;
        }
        copy(&mut inside, &mut sink())?;
        Ok(())
    }

    fn field_names(&self, source: &mut dyn Read) -> Result<Vec<String>, MatError> {
        let bytes = Tag::read(source, self.byte_order)?.bytes(source, 8)?;
        let length = bytes.first_chunk::<4>().map_or(0, |bytes| self.byte_order.u32(*bytes));
        let length = usize::try_from(length).unwrap_or(0);
        let names = Tag::read(source, self.byte_order)?.bytes(source, LONGEST_NAMES)?;
        if length == 0 {
            return Err(MatError::Damaged("the fields of a structure have no names"));
        }
        let name = |name: &[u8]| {
            let end = name.iter().position(|byte| *byte == 0).unwrap_or(name.len());
            String::from_utf8_lossy(&name[..end]).into_owned()
        };
        Ok(names.chunks(length).map(name).collect())
    }
}
