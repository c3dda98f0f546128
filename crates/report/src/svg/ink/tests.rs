use super::*;
use crate::figure::{Axis, Panel};
use crate::series::{Dash, Line, Marker, Points};

fn panel(labels: &[&str]) -> Panel {
    let line = |label: &&str| Line::new(*label, Dash::Solid, [(0.0, 0.0), (1.0, 1.0)]);
    labels.iter().map(line).fold(Panel::new("", Axis::linear("x"), Axis::linear("y")), Panel::with)
}

#[test]
fn the_same_label_has_the_same_colour_in_every_panel() {
    let figure = Figure::new("f", "", "").with(panel(&["a", "b"])).with(panel(&["b", "c", "a"]));
    let colours = assign(&figure);
    assert_eq!(colours[0], ["#0072b2", "#d55e00"]);
    assert_eq!(colours[1], ["#d55e00", "#009e73", "#0072b2"]);
}

#[test]
fn a_colour_asked_for_is_not_given_away() {
    let asked = Points::new("p", Marker::Cross, [(0.0, 0.0)]).ink(Ink::Blue);
    let figure = Figure::new("f", "", "").with(panel(&["a", ""]).with(asked));
    assert_eq!(assign(&figure)[0], ["#d55e00", "#009e73", "#0072b2"]);
}

#[test]
fn more_series_than_colours_begin_again() {
    let figure = Figure::new("f", "", "").with(panel(&["a", "b", "c", "d", "e", "f", "g", "h"]));
    let colours = &assign(&figure)[0];
    assert_eq!(colours[0], colours[7]);
    let mut first: Vec<_> = colours[..7].to_vec();
    first.sort_unstable();
    first.dedup();
    assert_eq!(first.len(), 7);
}

#[test]
fn every_ink_has_a_variant_for_the_dark() {
    let inks = [
        Ink::Black,
        Ink::Grey,
        Ink::Orange,
        Ink::Sky,
        Ink::Green,
        Ink::Yellow,
        Ink::Blue,
        Ink::Vermillion,
        Ink::Purple,
    ];
    for ink in inks {
        assert!(ON_DARK.iter().any(|(light, _)| *light == hex(ink)), "{ink:?}");
    }
}

/// Relative luminance (WCAG 2.1).
fn luminance(hex: &str) -> f64 {
    let channel = |at: usize| {
        let value = f64::from(u8::from_str_radix(&hex[at..at + 2], 16).unwrap()) / 255.0;
        if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
    };
    0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5)
}

#[test]
fn lines_stand_out_from_the_dark_page() {
    // The paper of the page in the dark.
    let page = luminance("#17191c");
    for (light, dark) in ON_DARK {
        if [PAPER, GRID].contains(&light) {
            continue;
        }
        let contrast = (luminance(dark) + 0.05) / (page + 0.05);
        assert!(contrast > 5.0, "{light} becomes {dark}: {contrast:.1}");
    }
}
