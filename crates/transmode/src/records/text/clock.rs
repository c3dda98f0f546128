//! A column of time that holds what a clock shows -> seconds from midnight of the first row's day on.
//!
//! | written as | example |
//! |---|---|
//! | time of day | `12:34:56.25` |
//! | day of the year and time of day, as IRIG time codes have it | `330:12:34:56.25` |
//! | date and time of day, as in ISO 8601 | `2026-11-26T12:34:56.25`, `2026-11-26 12:34:56.25` |
//! | the same with an offset | `2026-11-26T12:34:56.25Z`, `2026-11-26T14:34:56.25+02:00` |
//!
//! | date of three numbers and time of day | `26.11.2026 12:34:56.25`, `11/26/2026 12:34:56 PM`, `26/11/2026 12:34:56` |
//! | minutes and seconds | `34:56.25` |
//!
//! Of a date with its year at the end, points mean that the day comes first. Else a number above 12 tells, or the day that the next midnight
//! leads to; until then all rows are of one day, and the order does not matter.
//!
//! Where an offset is given, the midnight is that of UTC. A time of day that goes back by more than half a day has passed midnight, a day of the year that goes back to
//! the first has passed New Year.

use jiff::Timestamp;
use jiff::civil::{Date, DateTime, Time};
use jiff::tz::TimeZone;

const SECOND: i64 = 1_000_000_000;
const HOUR: i64 = 3600 * SECOND;
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
    /// Days of midnights and years that were passed; full hours, where only minutes are written.
    carried: i64,
    last: Stamp,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    TimeOfDay,
    DayOfYear,
    Date,
    WithOffset,
    MinutesAndSeconds,
    /// The day comes first, or the month does; both, as long as nothing tells.
    YearLast {
        day_first: Option<bool>,
    },
}

impl Form {
    /// Whether a row in this form may follow those in the other.
    fn follows(self, before: Self) -> bool {
        match (self, before) {
            (Self::YearLast { day_first: Some(a) }, Self::YearLast { day_first: Some(b) }) => {
                a == b
            }
            (Self::YearLast { .. }, Self::YearLast { .. }) => true,
            _ => self == before,
        }
    }
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
        let text = std::str::from_utf8(field).ok()?;
        let in_minutes = self.0.is_some_and(|before| before.form == Form::MinutesAndSeconds);
        let (mut form, mut stamp) = match parse(text, None) {
            Some(found) => found,
            // The first row has told that it is no hour.
            None if in_minutes => of_minutes(text)?,
            None => return None,
        };
        let (mut carried, mut shift) = (0, 0);
        if let Some(before) = &self.0 {
            if !form.follows(before.form) {
                return None;
            }
            if let (Form::YearLast { day_first: None }, Form::YearLast { day_first }) =
                (form, before.form)
            {
                ((form, stamp), shift) = match day_first {
                    Some(_) => (parse(text, day_first)?, 0),
                    None => by_midnight(text, before.last)?,
                };
            }
            let back = Stamp { day: before.last.day - stamp.day, ..before.last };
            carried = before.carried
                + match form {
                    Form::TimeOfDay => i64::from(back.nanoseconds - stamp.nanoseconds > DAY / 2),
                    // In hours.
                    Form::MinutesAndSeconds => {
                        i64::from(back.nanoseconds - stamp.nanoseconds > HOUR / 2)
                    }
                    // As many days as the year had.
                    Form::DayOfYear if back.day >= SHORTEST_YEAR - 1 => before.last.day,
                    _ => 0,
                };
        }
        let first_day = self.0.map_or(stamp.day, |before| before.first_day + shift);
        self.0 = Some(Read { form, first_day, carried, last: stamp });
        let carry = if form == Form::MinutesAndSeconds { HOUR } else { DAY };
        let nanoseconds = carried * carry + (stamp.day - first_day) * DAY + stamp.nanoseconds;
        // Exact for a hundred days.
        Some(nanoseconds as f64 / SECOND as f64)
    }
}

/// Whether a text is written as a clock shows the time.
pub(super) fn is_time(text: &str) -> bool {
    parse(text, None).is_some()
}

fn parse(text: &str, day_first: Option<bool>) -> Option<(Form, Stamp)> {
    // Numbers and most other texts are told at once.
    if !text.contains(':') {
        return None;
    }
    let text = &text.replace(',', ".");
    if let Some(nanoseconds) = time_of_day(text) {
        return Some((Form::TimeOfDay, Stamp { day: 0, nanoseconds }));
    }
    // Without a fraction it may as well be hours and minutes.
    if text.contains('.')
        && let Some(found) = of_minutes(text)
    {
        return Some(found);
    }
    if let Some((day, rest)) = text.split_once(':')
        && let Some(day) = day.parse().ok().filter(|day| (1..=366).contains(day))
        && let Some(nanoseconds) = time_of_day(rest)
    {
        return Some((Form::DayOfYear, Stamp { day, nanoseconds }));
    }
    if let Some(found) = year_last(text, day_first) {
        return Some(found);
    }
    let stamp = |time: Timestamp| {
        let nanoseconds = i64::try_from(time.as_nanosecond()).ok()?;
        Some(Stamp { day: nanoseconds.div_euclid(DAY), nanoseconds: nanoseconds.rem_euclid(DAY) })
    };
    // `2026/11/26` is ISO 8601 but for its slashes.
    let text = &text.replace('/', "-");
    if let Ok(time) = text.parse::<Timestamp>() {
        return Some((Form::WithOffset, stamp(time)?));
    }
    let local: DateTime = text.parse().ok()?;
    Some((Form::Date, stamp(local.to_zoned(TimeZone::UTC).ok()?.timestamp())?))
}

/// `26.11.2026 12:34:56` and `11/26/2026 12:34:56`.
fn year_last(text: &str, day_first: Option<bool>) -> Option<(Form, Stamp)> {
    let (date, time) = text.split_once([' ', 'T'])?;
    let mark = ['.', '/', '-'].into_iter().find(|mark| date.matches(*mark).count() == 2)?;
    let mut parts = date.split(mark);
    let (first, second, year) = (parts.next()?, parts.next()?, parts.next()?);
    if first.len() > 2 || second.len() > 2 || !matches!(year.len(), 2 | 4) {
        return None;
    }
    let (first, second): (i8, i8) = (first.parse().ok()?, second.parse().ok()?);
    let century = if year.len() == 2 { 2000 } else { 0 };
    let year: i16 = year.parse::<i16>().ok()? + century;
    let day_first = match (day_first, mark) {
        (_, '.') => Some(true),
        _ if first > 12 => Some(true),
        _ if second > 12 => Some(false),
        (asked, _) => asked,
    };
    // Any order will do for as long as nothing tells: only differences count.
    let (day, month) = if day_first.unwrap_or(true) { (first, second) } else { (second, first) };
    let date = Date::new(year, month, day).ok()?;
    let nanoseconds = time_of_day(time.trim()).or_else(|| half_day(time.trim()))?;
    let epoch = Date::constant(1970, 1, 1);
    let day = i64::from(date.since(epoch).ok()?.get_days());
    Some((Form::YearLast { day_first }, Stamp { day, nanoseconds }))
}

/// A date that may mean two days, after a row of another: the one that is the next day. Also says by
/// how much the days so far, which were read with the day first, are to be moved.
fn by_midnight(text: &str, before: Stamp) -> Option<((Form, Stamp), i64)> {
    let (form, stamp) = parse(text, None)?;
    match stamp.day - before.day {
        // Nothing is told while all rows are of one day.
        0 => Some(((form, stamp), 0)),
        1 | 2 => Some((parse(text, Some(true))?, 0)),
        _ => {
            let (form, stamp) = parse(text, Some(false))?;
            Some(((form, stamp), stamp.day - (before.day + 1)))
        }
    }
}

/// `01:34:56 PM`.
fn half_day(text: &str) -> Option<i64> {
    let (time, half) = text.split_at_checked(text.len().checked_sub(2)?)?;
    let afternoon = match half.to_ascii_uppercase().as_str() {
        "AM" => false,
        "PM" => true,
        _ => return None,
    };
    let nanoseconds = time_of_day(time.trim())?;
    let hours = nanoseconds / HOUR;
    let noon = if hours == 12 { -12 * HOUR } else { 0 };
    (1..=12).contains(&hours).then_some(nanoseconds + noon + if afternoon { 12 * HOUR } else { 0 })
}

/// `34:56.25`: minutes and seconds.
fn of_minutes(text: &str) -> Option<(Form, Stamp)> {
    let (minutes, seconds) = text.split_once(':')?;
    let is_plain = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    if minutes.contains('.') || !is_plain(minutes) || !is_plain(seconds) || minutes.len() > 4 {
        return None;
    }
    let minutes: i64 = minutes.parse().ok()?;
    let padded = if seconds.find('.').unwrap_or(seconds.len()) == 1 {
        format!("0{seconds}")
    } else {
        seconds.to_owned()
    };
    let nanoseconds = minutes * 60 * SECOND + time_of_day(&format!("00:00:{padded}"))?;
    Some((Form::MinutesAndSeconds, Stamp { day: 0, nanoseconds }))
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
