//! A column of time that holds what a clock shows -> seconds from midnight of the first row's day on.
//!
//! | written as | example |
//! |---|---|
//! | time of day | `12:34:56.25` |
//! | day of the year and time of day, as IRIG time codes have it | `330:12:34:56.25` |
//! | date and time of day, as in ISO 8601 | `2026-11-26T12:34:56.25`, `2026-11-26 12:34:56.25` |
//! | the same with an offset | `2026-11-26T12:34:56.25Z`, `2026-11-26T14:34:56.25+02:00` |
//!
//! Where an offset is given, the midnight is that of UTC. A time of day that goes back by more than half a day has passed midnight, a day of the year that goes back to
//! the first has passed New Year.

use jiff::Timestamp;
use jiff::civil::{DateTime, Time};
use jiff::tz::TimeZone;

const SECOND: i64 = 1_000_000_000;
const DAY: i64 = 86_400 * SECOND;
/// In days.
const SHORTEST_YEAR: i64 = 365;

/// The clock of one file.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Clock(Option<Read>);

/// What was read so far.
#[derive(Clone, Copy, Debug)]
struct Read {
    form: Form,
    first_day: i64,
    /// Days of midnights and years that were passed.
    carried: i64,
    last: Stamp,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    TimeOfDay,
    DayOfYear,
    Date,
    WithOffset,
}

/// Days from some day on, and nanoseconds of the day.
#[derive(Clone, Copy, Debug)]
struct Stamp {
    day: i64,
    nanoseconds: i64,
}

impl Clock {
    /// Whether a field was read as a time.
    pub(super) fn is_read(&self) -> bool {
        self.0.is_some()
    }

    /// The next field; `None` if it is no time, or not written as those before.
    pub(super) fn seconds(&mut self, field: &[u8]) -> Option<f64> {
        let (form, stamp) = parse(std::str::from_utf8(field).ok()?)?;
        let mut carried = 0;
        if let Some(before) = &self.0 {
            if before.form != form {
                return None;
            }
            let back = Stamp { day: before.last.day - stamp.day, ..before.last };
            carried = before.carried
                + match form {
                    Form::TimeOfDay => i64::from(back.nanoseconds - stamp.nanoseconds > DAY / 2),
                    // As many days as the year had.
                    Form::DayOfYear if back.day >= SHORTEST_YEAR - 1 => before.last.day,
                    _ => 0,
                };
        }
        let first_day = self.0.map_or(stamp.day, |before| before.first_day);
        self.0 = Some(Read { form, first_day, carried, last: stamp });
        let nanoseconds = (carried + stamp.day - first_day) * DAY + stamp.nanoseconds;
        // Exact for a hundred days.
        Some(nanoseconds as f64 / SECOND as f64)
    }
}

fn parse(text: &str) -> Option<(Form, Stamp)> {
    // Numbers and most other texts are told at once.
    if !text.contains(':') {
        return None;
    }
    let text = &text.replace(',', ".");
    if let Some(nanoseconds) = time_of_day(text) {
        return Some((Form::TimeOfDay, Stamp { day: 0, nanoseconds }));
    }
    if let Some((day, rest)) = text.split_once(':')
        && let Some(day) = day.parse().ok().filter(|day| (1..=366).contains(day))
        && let Some(nanoseconds) = time_of_day(rest)
    {
        return Some((Form::DayOfYear, Stamp { day, nanoseconds }));
    }
    let stamp = |time: Timestamp| {
        let nanoseconds = i64::try_from(time.as_nanosecond()).ok()?;
        Some(Stamp { day: nanoseconds.div_euclid(DAY), nanoseconds: nanoseconds.rem_euclid(DAY) })
    };
    if let Ok(time) = text.parse::<Timestamp>() {
        return Some((Form::WithOffset, stamp(time)?));
    }
    let local: DateTime = text.parse().ok()?;
    Some((Form::Date, stamp(local.to_zoned(TimeZone::UTC).ok()?.timestamp())?))
}

/// `12:34:56.25`: hours, minutes and seconds, the seconds with or without a fraction.
fn time_of_day(text: &str) -> Option<i64> {
    // A time of day alone: other texts that the parser knows hold a date.
    let is_plain = text.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b':' | b'.'));
    if !is_plain || text.matches(':').count() != 2 {
        return None;
    }
    // Some recorders leave out the zero of a morning's hour.
    let padded = if text.find(':') == Some(1) { format!("0{text}") } else { text.to_owned() };
    let time: Time = padded.parse().ok()?;
    let seconds = i64::from(time.hour()) * 3600 + i64::from(time.minute()) * 60;
    Some((seconds + i64::from(time.second())) * SECOND + i64::from(time.subsec_nanosecond()))
}

#[cfg(test)]
mod tests;
