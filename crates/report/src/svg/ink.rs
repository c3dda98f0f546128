//! Colours: the palette, its variants for dark pages, and who gets which colour.

use crate::figure::Figure;
use crate::series::{Ink, Series};

/// Background of every picture.
pub(crate) const PAPER: &str = "#ffffff";
/// Axes and text.
pub(crate) const BLACK: &str = "#000000";
/// Guides and other background lines.
pub(crate) const GREY: &str = "#767676";
/// Grid lines.
pub(crate) const GRID: &str = "#e4e4e4";

/// Colour on white paper, and its replacement on a dark page, for every colour a picture can hold.
pub(crate) const ON_DARK: [(&str, &str); 11] = [
    (PAPER, "none"),
    (BLACK, "#e8e8e8"),
    (GREY, "#9a9a9a"),
    (GRID, "#3a3d42"),
    ("#e69f00", "#f0b429"),
    ("#56b4e9", "#7cc7f2"),
    ("#009e73", "#2fc99b"),
    ("#f0e442", "#f0e442"),
    ("#0072b2", "#5aaeea"),
    ("#d55e00", "#ff8a3d"),
    ("#cc79a7", "#e29cc3"),
];

/// The hexadecimal colour of an ink; automatic ink is black.
pub(super) fn hex(ink: Ink) -> &'static str {
    match ink {
        Ink::Auto | Ink::Black => BLACK,
        Ink::Grey => GREY,
        Ink::Orange => "#e69f00",
        Ink::Sky => "#56b4e9",
        Ink::Green => "#009e73",
        Ink::Yellow => "#f0e442",
        Ink::Blue => "#0072b2",
        Ink::Vermillion => "#d55e00",
        Ink::Purple => "#cc79a7",
    }
}

const AUTOMATIC: [Ink; 7] =
    [Ink::Blue, Ink::Vermillion, Ink::Green, Ink::Purple, Ink::Orange, Ink::Sky, Ink::Black];

/// The colour of each series of each panel. Automatic colours follow the labels: the same label has the same colour in every panel,
/// and colours asked for by name are not given away unless all are taken.
pub(super) fn assign(figure: &Figure) -> Vec<Vec<&'static str>> {
    let asked: Vec<Ink> =
        figure.panels.iter().flat_map(|panel| panel.series.iter().map(wish)).collect();
    let mut free: Vec<Ink> = AUTOMATIC.into_iter().filter(|ink| !asked.contains(ink)).collect();
    if free.is_empty() {
        free = AUTOMATIC.to_vec();
    }
    let mut keys: Vec<(String, usize)> = Vec::new();
    let mut colour_of = |series: &Series, position: usize| {
        if wish(series) != Ink::Auto {
            return hex(wish(series));
        }
        // Series without a label are known by their position in the panel.
        let key = match series.label() {
            "" => (String::new(), position),
            label => (label.to_owned(), 0),
        };
        let place = keys.iter().position(|known| *known == key).unwrap_or_else(|| {
            keys.push(key);
            keys.len() - 1
        });
        hex(free[place % free.len()])
    };
    let mut of_panel = |series: &Vec<Series>| -> Vec<_> {
        series.iter().enumerate().map(|(i, s)| colour_of(s, i)).collect()
    };
    figure.panels.iter().map(|panel| of_panel(&panel.series)).collect()
}

fn wish(series: &Series) -> Ink {
    match series {
        Series::Points(s) => s.ink,
        Series::Line(s) => s.ink,
        Series::Stems(s) => s.ink,
        Series::Band(s) => s.ink,
        Series::Ellipses(s) => s.ink,
        Series::Notes(_) => Ink::Black,
    }
}

#[cfg(test)]
mod tests;
