//! The header of a table of text: names, and units beside or below them.

use crate::records::selection::is_time;
use crate::records::table::Heading;
use crate::records::unit;

/// `beta [deg]` and `p (rad/s)` into name and unit.
pub(crate) fn heading(text: &str) -> Heading {
    let text = text.trim();
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some((name, unit)) = text.strip_suffix(close).and_then(|text| text.rsplit_once(open))
            && !name.trim().is_empty()
        {
            let unit = Some(unit.trim().to_owned());
            return Heading { name: name.trim().to_owned(), unit, ..Heading::default() };
        }
    }
    // `time_s`, `t_ms`: of times alone, since `p_s` may be anything.
    let unit = text.rsplit_once('_').filter(|(name, _)| is_time(name)).map(|(_, unit)| unit);
    let unit = unit.filter(|unit| matches!(*unit, "s" | "sec" | "ms" | "us" | "ns"));
    Heading { unit: unit.map(str::to_owned), ..Heading::named(text) }
}

/// The headings of all columns. What is in brackets is an index and part of the name where it is a
/// number, as in `xyz[0]` and `gyroADC(1)`: but for `[1]`, which may be the unit of a ratio, unless a
/// column beside it has the same name without it.
pub(super) fn headings(names: &[String]) -> Vec<Heading> {
    let mut found: Vec<Heading> = names.iter().map(|name| heading(name)).collect();
    let bases: Vec<String> = found.iter().map(|heading| heading.name.clone()).collect();
    for (index, heading) in found.iter_mut().enumerate() {
        let Some(unit) = heading.unit.as_deref().filter(|unit| is_index(unit)) else { continue };
        let is_shared = || {
            let mut others = bases.iter().enumerate().filter(|(other, _)| *other != index);
            others.any(|(_, base)| *base == bases[index])
        };
        if unit != "1" || is_shared() {
            *heading = Heading::named(names[index].trim());
        }
    }
    found
}

/// Whether brackets hold an index, or several.
fn is_index(text: &str) -> bool {
    text.bytes().any(|byte| byte.is_ascii_digit())
        && text.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b',' | b':' | b' '))
}

/// The units that a row below the header holds, if that is what it is: no field of it is a number, and one at least is a unit.
///
/// An empty field says nothing; one that is no unit is kept, and refused where its channel is used.
pub(super) fn units(fields: &[String]) -> Option<Vec<Option<String>>> {
    let bare = |field: &String| {
        let inside = |open, close| field.strip_prefix(open)?.strip_suffix(close);
        inside('[', ']').or_else(|| inside('(', ')')).unwrap_or(field).trim().to_owned()
    };
    let number = |text: &String| text.replace(',', ".").parse::<f64>().is_ok();
    let texts: Vec<String> = fields.iter().map(bare).collect();
    // `1` is a unit, but a row of ones is a row of numbers.
    let is_row = !texts.iter().any(number)
        && texts.iter().any(|text| unit::Unit::parse(text).is_some() && !text.is_empty());
    is_row.then(|| texts.into_iter().map(|text| (!text.is_empty()).then_some(text)).collect())
}

#[cfg(test)]
mod tests;
