//! One axis laid out on paper: shown range, ticks and their labels, and the place of a value.
//!
//! A logarithmic axis is handled as a linear one over log10 of the value: the plotting library's own stops at 1e-10, and Markov
//! parameters reach rounding level.

use super::check::Span;
use crate::figure::{Axis, Scale};
use crate::font;

/// Size of tick labels.
pub(super) const TICK_PX: u32 = 11;

/// In which direction an axis runs: labels side by side need more room than labels above one another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    Horizontal,
    Vertical,
}

/// The shown range, in the value or its decimal logarithm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct View {
    pub(super) scale: Scale,
    pub(super) low: f64,
    pub(super) high: f64,
}

impl View {
    /// The given range, or the span of the data with a margin around.
    pub(super) fn new(axis: &Axis, span: Span) -> Self {
        const MARGIN: f64 = 0.06; // Of the span, at either end: a marker on the frame is hard to read.
        let mut view = Self { scale: axis.scale, low: 0.0, high: 0.0 };
        if let Some((low, high)) = axis.range {
            (view.low, view.high) = (view.unit(low), view.unit(high));
            return view;
        }
        let (low, high) = span.unwrap_or((0.0, 1.0));
        (view.low, view.high) = (view.unit(low), view.unit(high));
        let least = match view.scale {
            Scale::Linear => (1e-9 * low.abs().max(high.abs())).max(f64::MIN_POSITIVE * 1e9),
            Scale::Log10 => 1e-3,
        };
        if view.high - view.low < least {
            // All values are equal: the axis says so by putting them in its middle.
            let half = match view.scale {
                Scale::Linear if low == 0.0 => 1.0,
                Scale::Linear => 0.1 * low.abs().max(high.abs()),
                Scale::Log10 => 0.5,
            };
            view.low -= half;
            view.high += half;
        } else {
            let margin = MARGIN * (view.high - view.low);
            view.low -= margin;
            view.high += margin;
        }
        view
    }

    /// A value in the units of the view; negative infinity for what a logarithm does not have.
    pub(super) fn unit(self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => value,
            Scale::Log10 if value > 0.0 => value.log10(),
            Scale::Log10 => f64::NEG_INFINITY,
        }
    }

    pub(super) fn span(self) -> f64 {
        self.high - self.low
    }

    /// Moves both ends outwards until the span is this long.
    pub(super) fn stretch(&mut self, span: f64) {
        let more = 0.5 * (span - self.span());
        self.low -= more;
        self.high += more;
    }

    /// Is the value shown? What lies on the frame is.
    pub(super) fn shows(self, value: f64) -> bool {
        let slack = 1e-9 * self.span();
        (self.low - slack..=self.high + slack).contains(&self.unit(value))
    }
}

/// Ticks of an axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ticks {
    /// Distance of the major ticks, which are its multiples, in the units of the view; infinite where there are none.
    pub(super) step: f64,
    /// Labelled ticks that are not multiples of a step: place in the units of the view, label.
    pub(super) extra: Vec<(f64, String)>,
    /// Ticks without label.
    pub(super) minor: Vec<f64>,
    /// How major ticks are labelled.
    pub(super) style: Style,
    /// Width of the widest label.
    pub(super) widest_px: f64,
}

/// How a number on an axis is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Style {
    /// With this many decimals.
    Fixed(usize),
    /// As mantissa with this many decimals, times a power of ten.
    Scientific(usize),
    /// A logarithm, written as the power of ten.
    Power,
    /// A logarithm, written as a decimal number.
    Decimal,
}

impl Style {
    /// The label of a tick at this place.
    pub(super) fn label(self, unit: f64) -> String {
        let text = match self {
            _ if unit == 0.0 && matches!(self, Self::Fixed(_) | Self::Scientific(_)) => {
                "0".to_owned()
            }
            Self::Fixed(decimals) => format!("{unit:.decimals$}"),
            Self::Scientific(decimals) => {
                let text = format!("{unit:.decimals$e}");
                match text.split_once('e') {
                    Some((mantissa, exponent)) => format!("{mantissa}×10{}", superscript(exponent)),
                    None => text,
                }
            }
            Self::Power => format!("10{}", superscript(&format!("{unit:.0}"))),
            Self::Decimal => format!("{:.*}", count(-unit), 10f64.powf(unit)),
        };
        text.replace('-', "−")
    }
}

/// The characters of a whole number, raised.
fn superscript(digits: &str) -> String {
    let raise = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0'..='9' => char::from_u32(0x2070 + u32::from(c) - u32::from('0')).unwrap_or(c),
        other => other,
    };
    digits.chars().map(raise).collect()
}

impl Ticks {
    /// Ticks at the same distance on both axes of this size: the coarser of the two.
    pub(super) fn equal(x: View, y: View, width_px: f64, height_px: f64) -> (Self, Self) {
        let ticks = (
            Self::new(x, width_px, Direction::Horizontal),
            Self::new(y, height_px, Direction::Vertical),
        );
        let step = ticks.0.step.max(ticks.1.step);
        let exponent = (step.log10() + 1e-9).floor();
        let coarser = |view: View| Self::major(view, step, linear_style(view, exponent));
        (coarser(x), coarser(y))
    }

    /// As many ticks as have room on an axis of this length.
    pub(super) fn new(view: View, length_px: f64, direction: Direction) -> Self {
        match view.scale {
            Scale::Linear => Self::linear(view, length_px, direction),
            Scale::Log10 => Self::logarithmic(view, length_px, direction),
        }
    }

    fn linear(view: View, length_px: f64, direction: Direction) -> Self {
        let first = (view.span() * 20.0 / length_px).log10().floor();
        for exponent in [first, first + 1.0, first + 2.0, first + 3.0] {
            for factor in [1.0, 2.0, 5.0] {
                let step = power_of_ten(exponent) * factor;
                let ticks = Self::major(view, step, linear_style(view, exponent));
                if ticks.fits(step / view.span() * length_px, direction) || step > view.span() {
                    return ticks;
                }
            }
        }
        // Not reached while the span has a length; an axis without ticks is better than none.
        Self::major(view, f64::INFINITY, Style::Fixed(0))
    }

    fn logarithmic(view: View, length_px: f64, direction: Direction) -> Self {
        let (first, last) = (view.low.ceil(), view.high.floor());
        let style = if first > -2.5 && last < 3.5 { Style::Decimal } else { Style::Power };
        let mut step = 1.0;
        let mut ticks = Self::major(view, step, style);
        for candidate in [1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0] {
            (step, ticks) = (candidate, Self::major(view, candidate, style));
            if ticks.fits(step / view.span() * length_px, direction) {
                break;
            }
        }
        let decade_px = length_px / view.span();
        let inside = |unit: &f64| (view.low..=view.high).contains(unit);
        let multiples = |factors: &'static [f64]| {
            let decades = whole_numbers(view.low.floor(), view.high.floor());
            decades
                .flat_map(move |decade| factors.iter().map(move |factor| decade + factor.log10()))
        };
        if step < 1.5 && decade_px >= 24.0 {
            ticks.minor =
                multiples(&[2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]).filter(inside).collect();
        } else if step > 1.5 && decade_px >= 4.0 {
            ticks.minor = whole_numbers(first, last).collect();
        }
        if whole_numbers(first, last).count() < 2 {
            ticks.label_between_decades(view, length_px, direction);
        }
        ticks
    }

    /// Labels 2 and 5 times a power of ten, or, where that gives no two labels either, the values a linear axis would label.
    fn label_between_decades(&mut self, view: View, length_px: f64, direction: Direction) {
        let decades = whole_numbers(view.low.floor(), view.high.floor());
        let multiples =
            decades.flat_map(|decade| [1.0, 2.0, 5.0].map(|factor: f64| decade + factor.log10()));
        let inside = |unit: &f64| (view.low..=view.high).contains(unit);
        let name = |unit: f64| (unit, sub_decade_label(unit, self.style));
        self.extra = multiples.filter(inside).map(name).collect();
        if self.extra.len() < 2 {
            let values = View {
                scale: Scale::Linear,
                low: 10f64.powf(view.low),
                high: 10f64.powf(view.high),
            };
            // Towards the upper end they come closer together.
            let linear = Self::linear(values, 0.7 * length_px, direction);
            self.extra = linear
                .places(values)
                .map(|value| (value.log10(), linear.style.label(value)))
                .collect();
        }
        self.keep_what_has_room(view, length_px, direction);
        // The extra ticks take the place of the major ones.
        self.step = f64::INFINITY;
        self.widest_px =
            self.extra.iter().map(|(_, label)| font::width(label, TICK_PX)).fold(0.0, f64::max);
    }

    /// Drops each extra label that would touch the one kept before it.
    fn keep_what_has_room(&mut self, view: View, length_px: f64, direction: Direction) {
        let mut kept: Vec<(f64, String)> = Vec::new();
        for (unit, label) in self.extra.drain(..) {
            let has_room = kept.last().is_none_or(|(before, text)| {
                let room = match direction {
                    Direction::Horizontal => {
                        0.5 * (font::width(text, TICK_PX) + font::width(&label, TICK_PX)) + 2.0
                    }
                    Direction::Vertical => f64::from(TICK_PX) + 1.0,
                };
                (unit - before) / view.span() * length_px >= room
            });
            if has_room {
                kept.push((unit, label));
            }
        }
        self.extra = kept;
    }

    fn major(view: View, step: f64, style: Style) -> Self {
        let mut ticks = Self { step, extra: Vec::new(), minor: Vec::new(), style, widest_px: 0.0 };
        ticks.widest_px = ticks
            .places(view)
            .map(|unit| font::width(&style.label(unit), TICK_PX))
            .fold(0.0, f64::max);
        ticks
    }

    /// The major ticks, in ascending order.
    pub(super) fn places(&self, view: View) -> impl Iterator<Item = f64> + use<> {
        let step = self.step;
        let slack = 1e-9;
        // With an infinite step not even zero is a tick.
        let none = if step.is_finite() { 0.0 } else { f64::NAN };
        whole_numbers(none + (view.low / step - slack).ceil(), (view.high / step + slack).floor())
            .map(move |n| n * step)
    }

    fn fits(&self, step_px: f64, direction: Direction) -> bool {
        match direction {
            Direction::Horizontal => step_px >= (self.widest_px + 8.0).max(34.0),
            Direction::Vertical => step_px >= 26.0,
        }
    }
}

/// Whole numbers from first to last, at most a thousand of them.
fn whole_numbers(first: f64, last: f64) -> impl Iterator<Item = f64> {
    (0..1000_u16).map(move |i| first + f64::from(i)).take_while(move |n| *n <= last)
}

/// An exact power of ten where there is one.
fn power_of_ten(exponent: f64) -> f64 {
    format!("1e{exponent:.0}").parse().unwrap_or_else(|_| 10f64.powf(exponent))
}

fn linear_style(view: View, step_exponent: f64) -> Style {
    let largest = view.low.abs().max(view.high.abs());
    if (1e-4..1e5).contains(&largest) {
        Style::Fixed(count(-step_exponent))
    } else {
        Style::Scientific(count(largest.log10().floor() - step_exponent))
    }
}

/// A small non-negative number of digits.
fn count(digits: f64) -> usize {
    (0..16_u8).take_while(|n| f64::from(*n) + 0.5 < digits).count()
}

fn sub_decade_label(unit: f64, style: Style) -> String {
    let decade = (unit + 1e-9).floor();
    let factor = 10f64.powf(unit - decade).round();
    if style == Style::Decimal {
        let decimals = count(-decade);
        format!("{:.decimals$}", factor * power_of_ten(decade))
    } else {
        format!("{factor:.0}×{}", style.label(decade))
    }
}

#[cfg(test)]
mod tests;
