//! Columns of words, such as a mode of flight, told from the first rows.

use super::columns::shortened;
use super::dialect;
use crate::records::selection::is_time;
use crate::records::table::Heading;

/// Rows that are looked at.
pub(super) const LOOKED_AT: usize = 100;

/// Notes in the headings which columns hold words and no number in these rows.
pub(super) fn mark(headings: &mut [Heading], rows: &[Vec<String>]) {
    for (index, heading) in headings.iter_mut().enumerate() {
        // What is wrong with a time has sentences of its own.
        if is_time(&heading.name) || heading.name.is_empty() {
            continue;
        }
        let fields = || rows.iter().filter_map(|row| row.get(index));
        let word = fields().find(|text| is_word(text));
        if let Some(word) = word
            && fields().all(|text| is_word(text) || is_missing(text))
        {
            heading.fault = Some(format!("it holds words ({:?})", shortened(word)));
            heading.is_words = true;
        }
    }
}

fn is_missing(text: &str) -> bool {
    dialect::number(text.as_bytes(), b';').is_some_and(|number| number.value.is_nan())
}

/// Whether a text is no number, and no attempt at one.
fn is_word(text: &str) -> bool {
    let first = text.trim_start_matches(['+', '-', '.', ',']).chars().next();
    first.is_some_and(|first| !first.is_ascii_digit())
        && !text.eq_ignore_ascii_case("inf")
        && !text.to_ascii_lowercase().ends_with("inf")
        && dialect::number(text.as_bytes(), b';').is_none()
}
