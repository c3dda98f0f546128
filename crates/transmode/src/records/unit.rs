//! Units that a file may state, and what they are in SI with angles in radians.
//!
//! Exact by definition: the international foot, 0.3048 m; the nautical mile, 1852 m; the standard acceleration of gravity, 9.80665 m/s^2
//! (NIST Special Publication 811, 2008 edition, appendix B.8).

use std::f64::consts::PI;

/// A unit that is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Unit {
    /// What it is converted to; empty for a number without dimension.
    pub(crate) si: &'static str,
    /// Multiplies numbers in the unit.
    pub(crate) factor: f64,
}

const FOOT: f64 = 0.3048;
const DEGREE: f64 = PI / 180.0;

/// Spellings in lower case, what they are in SI, and the factor. The first spelling of each line is the one that a message names.
const UNITS: [(&[&str], &str, f64); 34] = [
    (&["rad", "radian", "radians"], "rad", 1.0),
    (&["deg", "\u{b0}", "\u{ba}", "degree", "degrees"], "rad", DEGREE),
    (&["mrad"], "rad", 1e-3),
    (&["rad/s", "rad/sec", "rps"], "rad/s", 1.0),
    (
        &["deg/s", "\u{b0}/s", "\u{ba}/s", "deg/sec", "dps", "degrees/s", "degree/s"],
        "rad/s",
        DEGREE,
    ),
    (&["mrad/s"], "rad/s", 1e-3),
    (&["rad/s^2", "rad/s2", "rad/s/s", "rad/sec^2"], "rad/s^2", 1.0),
    (&["deg/s^2", "deg/s2", "deg/s/s", "\u{b0}/s^2", "\u{b0}/s2", "deg/sec^2"], "rad/s^2", DEGREE),
    (&["m", "meter", "meters", "metre", "metres"], "m", 1.0),
    (&["mm"], "m", 1e-3),
    (&["cm"], "m", 1e-2),
    (&["km"], "m", 1e3),
    (&["ft", "foot", "feet"], "m", FOOT),
    (&["nmi"], "m", 1852.0),
    (&["m/s", "m/sec", "mps"], "m/s", 1.0),
    (&["km/h", "kph", "kmh"], "m/s", 1.0 / 3.6),
    (&["ft/s", "ft/sec", "fps"], "m/s", FOOT),
    (&["ft/min", "fpm"], "m/s", FOOT / 60.0),
    (&["kt", "kts", "kn", "knot", "knots", "ktas", "kcas", "kias", "keas"], "m/s", 1852.0 / 3600.0),
    (&["m/s^2", "m/s2", "m/s/s", "m/sec^2"], "m/s^2", 1.0),
    (&["ft/s^2", "ft/s2", "ft/s/s", "ft/sec^2"], "m/s^2", FOOT),
    (&["g", "g0", "gs", "g's"], "m/s^2", 9.80665),
    (&["s", "sec", "secs", "second", "seconds"], "s", 1.0),
    (&["ms", "msec", "millisecond", "milliseconds"], "s", 1e-3),
    (&["us", "\u{b5}s", "\u{3bc}s", "usec", "microsecond", "microseconds"], "s", 1e-6),
    (&["ns", "nanosecond", "nanoseconds"], "s", 1e-9),
    (&["min", "minute", "minutes"], "s", 60.0),
    (&["h", "hr", "hour", "hours"], "s", 3600.0),
    (&["n"], "N", 1.0),
    (&["pa"], "Pa", 1.0),
    (&["k"], "K", 1.0),
    (&["v"], "V", 1.0),
    (&["-", "1", "", "none", "n/a"], "", 1.0),
    (&["%", "percent"], "", 0.01),
];

impl Unit {
    /// The unit that is written so; upper case and lower case are not told apart, nor blanks, nor `**2` and `\u{b2}` from `^2`.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        let plain = text.to_lowercase().replace(char::is_whitespace, "");
        let plain = plain.replace("**", "^").replace('\u{b2}', "^2");
        let known = UNITS.iter().find(|(spellings, ..)| spellings.contains(&plain.as_str()));
        known.map(|&(_, si, factor)| Self { si, factor })
    }

    pub(crate) fn is_time(self) -> bool {
        self.si == "s"
    }

    /// The units that are known, for a message.
    pub(crate) fn known() -> String {
        let named = UNITS.iter().filter_map(|(spellings, ..)| spellings.first().copied());
        named.collect::<Vec<_>>().join(", ")
    }
}

#[cfg(test)]
mod tests;
