//! Units that a file may state, and what they are in SI with angles in radians.
//!
//! Exact by definition: the international foot, 0.3048 m; the nautical mile, 1852 m; the standard acceleration of gravity, 9.80665 m/s^2
//! (NIST Special Publication 811, 2008 edition, appendix B.8); so are the inch, 0.0254 m, the mile, 1609.344 m, and the avoirdupois pound,
//! 0.45359237 kg, which make the pound-force, the slug and the psi. The inch of mercury is 3386.389 Pa (there, B.8, at 32 degF).

use std::f64::consts::PI;

/// A unit that is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Unit {
    /// What it is converted to; empty for a number without dimension.
    pub(crate) si: &'static str,
    /// Multiplies numbers in the unit.
    pub(crate) factor: f64,
    /// Added behind that.
    pub(crate) offset: f64,
}

const FOOT: f64 = 0.3048;
const INCH: f64 = 0.0254;
const MILE: f64 = 1609.344;
const POUND: f64 = 0.453_592_37;
const GRAVITY: f64 = 9.806_65;
const DEGREE: f64 = PI / 180.0;

/// Spellings in lower case, what they are in SI, and the factor. The first spelling of each line is the one that a message names.
const UNITS: [(&[&str], &str, f64); 58] = [
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
    (&["g", "g0", "gs", "g's"], "m/s^2", GRAVITY),
    (&["s", "sec", "secs", "second", "seconds"], "s", 1.0),
    (&["ms", "msec", "millisecond", "milliseconds"], "s", 1e-3),
    (&["us", "\u{b5}s", "\u{3bc}s", "usec", "microsecond", "microseconds"], "s", 1e-6),
    (&["ns", "nanosecond", "nanoseconds"], "s", 1e-9),
    (&["min", "minute", "minutes"], "s", 60.0),
    (&["h", "hr", "hour", "hours"], "s", 3600.0),
    (&["n", "newton", "newtons"], "N", 1.0),
    (&["pa"], "Pa", 1.0),
    (&["k", "kelvin"], "K", 1.0),
    (&["v", "volt", "volts"], "V", 1.0),
    (&["mph", "mi/h"], "m/s", MILE / 3600.0),
    (&["in", "inch", "inches"], "m", INCH),
    (&["mi", "mile", "miles"], "m", MILE),
    (&["rpm", "rev/min", "1/min"], "rad/s", PI / 30.0),
    (&["hz", "1/s"], "Hz", 1.0),
    (&["khz"], "Hz", 1e3),
    (&["kg", "kilogram", "kilograms"], "kg", 1.0),
    (&["lbm"], "kg", POUND),
    (&["slug", "slugs"], "kg", POUND * GRAVITY / FOOT),
    (&["lbf"], "N", POUND * GRAVITY),
    (&["n*m", "n\u{b7}m", "n-m"], "N m", 1.0),
    (&["ft-lbf", "ft*lbf", "lbf*ft", "lbf-ft"], "N m", POUND * GRAVITY * FOOT),
    (&["psi", "lbf/in^2"], "Pa", POUND * GRAVITY / (INCH * INCH)),
    (&["psf", "lbf/ft^2"], "Pa", POUND * GRAVITY / (FOOT * FOOT)),
    (&["hpa"], "Pa", 1e2),
    (&["kpa"], "Pa", 1e3),
    (&["bar"], "Pa", 1e5),
    (&["mbar", "mb"], "Pa", 1e2),
    (&["inhg"], "Pa", 3386.389),
    (&["gauss"], "T", 1e-4),
    (&["tesla"], "T", 1.0),
    (&["mv"], "V", 1e-3),
    (&["a", "amp", "ampere", "amps"], "A", 1.0),
    (&["w", "watt", "watts"], "W", 1.0),
    (&["-", "1", "", "none", "n/a"], "", 1.0),
    (&["%", "percent"], "", 0.01),
];

/// Spellings that differ from others by their capitals alone.
const CAPITALS: [(&str, &str, f64); 8] = [
    ("kN", "N", 1e3),
    ("MN", "N", 1e6),
    ("mN", "N", 1e-3),
    ("Nm", "N m", 1.0),
    ("kNm", "N m", 1e3),
    ("MPa", "Pa", 1e6),
    ("mT", "T", 1e-3),
    ("uT", "T", 1e-6),
];

/// Temperatures, whose zeros differ: spellings in lower case, factor and offset to kelvin.
const TEMPERATURES: [(&[&str], f64, f64); 2] = [
    (&["degc", "\u{b0}c", "\u{ba}c", "celsius", "deg_c"], 1.0, 273.15),
    (&["degf", "\u{b0}f", "\u{ba}f", "fahrenheit", "deg_f"], 5.0 / 9.0, 459.67 * 5.0 / 9.0),
];

impl Unit {
    /// The unit that is written so; upper case and lower case are not told apart but where only they differ (`kN`, `kn`), nor blanks, nor
    /// `**2` and `\u{b2}` from `^2`.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        let exact = CAPITALS.iter().find(|(spelling, ..)| *spelling == text.trim());
        if let Some(&(_, si, factor)) = exact {
            return Some(Self { si, factor, offset: 0.0 });
        }
        let plain = text.to_lowercase().replace(char::is_whitespace, "");
        let plain = plain.replace("**", "^").replace('\u{b2}', "^2");
        let is_called = |spellings: &[&str]| spellings.contains(&plain.as_str());
        if let Some(&(_, factor, offset)) = TEMPERATURES.iter().find(|(all, ..)| is_called(all)) {
            return Some(Self { si: "K", factor, offset });
        }
        let known = UNITS.iter().find(|(spellings, ..)| is_called(spellings));
        known.map(|&(_, si, factor)| Self { si, factor, offset: 0.0 })
    }

    pub(crate) fn is_time(self) -> bool {
        self.si == "s"
    }

    /// The units that are known, for a message.
    pub(crate) fn known() -> String {
        let named = UNITS.iter().filter_map(|(spellings, ..)| spellings.first().copied());
        let capitals = CAPITALS.iter().map(|(spelling, ..)| *spelling);
        let temperatures = TEMPERATURES.iter().filter_map(|(all, ..)| all.first().copied());
        named.chain(capitals).chain(temperatures).collect::<Vec<_>>().join(", ")
    }
}

#[cfg(test)]
mod tests;
