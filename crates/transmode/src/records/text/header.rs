//! The header of a table of text: names, and units beside or below them.

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
    Heading::named(text)
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
