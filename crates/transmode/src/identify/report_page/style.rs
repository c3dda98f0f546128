//! What all sections have in common: labels with units, colours of records, how many of them are drawn.

use report::{Dash, Ink};

use crate::identify::outcome::Outcome;

/// As many records are drawn, so that a page of windows stays readable.
pub(super) const LARGEST_RECORDS: usize = 6;

/// As many sensors are drawn.
pub(super) const LARGEST_SENSORS: usize = 6;

/// Records are told apart by colour and by dash.
const LOOKS: [(Ink, Dash); LARGEST_RECORDS] = [
    (Ink::Blue, Dash::Solid),
    (Ink::Vermillion, Dash::Dashed),
    (Ink::Green, Dash::DashDot),
    (Ink::Purple, Dash::Dotted),
    (Ink::Orange, Dash::LongDash),
    (Ink::Black, Dash::Solid),
];

/// The look of a record; `record` is below [`LARGEST_RECORDS`].
pub(super) fn look(record: usize) -> (Ink, Dash) {
    LOOKS[record % LOOKS.len()]
}

/// The unit of a channel in a record, after conversion; `None` where the file states none.
fn unit(input: &Outcome<'_>, record: usize, channel: usize) -> Option<&'static str> {
    let units = input.sources.get(record).map(|source| &source.units)?;
    units.get(channel).copied().flatten().filter(|unit| !unit.is_empty())
}

/// `p (rad/s)`, or `p` where the unit is not known.
pub(super) fn with_unit(input: &Outcome<'_>, record: usize, channel: usize) -> String {
    let name = channel_name(input, channel);
    unit(input, record, channel).map_or_else(|| name.to_owned(), |unit| format!("{name} ({unit})"))
}

/// `power density of p ((rad/s)^2/Hz)`; without a unit `(1/Hz)`, the square of whatever the file holds left unsaid.
pub(super) fn density(input: &Outcome<'_>, record: usize, channel: usize) -> String {
    let name = channel_name(input, channel);
    match unit(input, record, channel) {
        Some(unit) if unit.contains('/') => format!("density of {name} (({unit})²/Hz)"),
        Some(unit) => format!("density of {name} ({unit}²/Hz)"),
        None => format!("density of {name} (its unit²/Hz)"),
    }
}

/// `|p / beta| ((rad/s)/rad)`.
pub(super) fn ratio(input: &Outcome<'_>, to: usize, from: usize) -> String {
    let names = format!("|{} / {}|", channel_name(input, to), channel_name(input, from));
    let wrapped = |unit: &str| {
        if unit.contains('/') { format!("({unit})") } else { unit.to_owned() }
    };
    match (unit(input, 0, to), unit(input, 0, from)) {
        (Some(to), Some(from)) if to == from => names,
        (Some(to), Some(from)) => format!("{names} ({}/{})", wrapped(to), wrapped(from)),
        _ => names,
    }
}

/// The name of a channel; all records have the same.
pub(super) fn channel_name<'a>(input: &Outcome<'a>, channel: usize) -> &'a str {
    let channels = input.records.first().map_or(&[][..], |record| record.channels());
    channels.get(channel).map_or("", |channel| channel.name.as_str())
}

/// A sentence where not all of `count` things are drawn, with a space before it; otherwise nothing.
pub(super) fn drawn(count: usize, limit: usize, what: &str) -> String {
    if count > limit {
        format!(" The first {limit} of {count} {what} are drawn.")
    } else {
        String::new()
    }
}
