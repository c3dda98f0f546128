//! What can be drawn in a panel: points, lines, stems, bands and ellipses.
//!
//! A series says what it is; the renderer chooses pixels. Series are told apart twice, by colour and by marker
//! or dash, so that a figure survives black-and-white print and colour blindness.

use serde::Serialize;

/// Shape of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Marker {
    /// An x: poles.
    Cross,
    /// An o: zeros.
    Circle,
    /// A square.
    Square,
    /// An upright cross.
    Plus,
    /// A square on its corner.
    Diamond,
    /// A triangle, point up.
    Triangle,
    /// A triangle, point down.
    TriangleDown,
}

/// Whether a closed marker is an outline or filled. Cross and plus have no inside.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Fill {
    /// An outline: what lies under it stays visible.
    #[default]
    Open,
    /// Filled.
    Solid,
}

/// Pattern of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Dash {
    /// Unbroken.
    #[default]
    Solid,
    /// Long dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// Dash, dot, dash, dot.
    DashDot,
    /// Dashes of twice the length.
    LongDash,
}

/// Colour of a series: the eight of Okabe and Ito, which colour-blind readers can tell apart, and a grey.
///
/// Source: M. Okabe and K. Ito, Color Universal Design, 2008 (the RGB values of their palette).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Ink {
    /// The next colour not taken, in the order blue, vermillion, green, purple, orange, sky, black. Series with
    /// the same label get the same colour in every panel of a figure.
    #[default]
    Auto,
    /// Black.
    Black,
    /// Grey, for what is in the background.
    Grey,
    /// Orange.
    Orange,
    /// Sky blue.
    Sky,
    /// Bluish green.
    Green,
    /// Yellow: for areas only, lines are too faint on white.
    Yellow,
    /// Blue.
    Blue,
    /// Vermillion.
    Vermillion,
    /// Reddish purple.
    Purple,
}

/// Separate points.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Points {
    /// Entry in the legend; none where empty.
    pub label: String,
    /// Shape.
    pub marker: Marker,
    /// Outline or filled.
    pub fill: Fill,
    /// Colour.
    pub ink: Ink,
    /// Half the width of a marker, in pixels at scale 1.
    pub radius_px: f64,
    /// Where the points are, in the units of the axes.
    pub xy: Vec<(f64, f64)>,
}

impl Points {
    /// Open markers of 4.5 pixels radius in the next free colour.
    pub fn new(
        label: impl Into<String>,
        marker: Marker,
        xy: impl IntoIterator<Item = (f64, f64)>,
    ) -> Self {
        Self {
            label: label.into(),
            marker,
            fill: Fill::Open,
            ink: Ink::Auto,
            radius_px: 4.5,
            xy: xy.into_iter().collect(),
        }
    }

    /// Poles: blue x.
    pub fn poles(label: impl Into<String>, xy: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self::new(label, Marker::Cross, xy).ink(Ink::Blue)
    }

    /// Zeros: vermillion o.
    pub fn zeros(label: impl Into<String>, xy: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self::new(label, Marker::Circle, xy).ink(Ink::Vermillion)
    }

    /// True eigenvalues: large black squares, open, so that what they enclose stays visible.
    pub fn eigenvalues(label: impl Into<String>, xy: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self::new(label, Marker::Square, xy).ink(Ink::Black).radius(7.5)
    }

    /// Sets the colour.
    #[must_use]
    pub fn ink(self, ink: Ink) -> Self {
        Self { ink, ..self }
    }

    /// Sets outline or filled.
    #[must_use]
    pub fn fill(self, fill: Fill) -> Self {
        Self { fill, ..self }
    }

    /// Sets half the width of a marker, in pixels at scale 1.
    #[must_use]
    pub fn radius(self, radius_px: f64) -> Self {
        Self { radius_px, ..self }
    }
}

/// A polyline through points in the given order.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Line {
    /// Entry in the legend; none where empty.
    pub label: String,
    /// Pattern.
    pub dash: Dash,
    /// Colour.
    pub ink: Ink,
    /// Marker at every point, if any.
    pub marker: Option<Marker>,
    /// Width in pixels at scale 1.
    pub width_px: f64,
    /// The corners, in the units of the axes.
    pub xy: Vec<(f64, f64)>,
}

impl Line {
    /// A line of 1.6 pixels without markers in the next free colour.
    pub fn new(
        label: impl Into<String>,
        dash: Dash,
        xy: impl IntoIterator<Item = (f64, f64)>,
    ) -> Self {
        Self {
            label: label.into(),
            dash,
            ink: Ink::Auto,
            marker: None,
            width_px: 1.6,
            xy: xy.into_iter().collect(),
        }
    }

    /// Sets the colour.
    #[must_use]
    pub fn ink(self, ink: Ink) -> Self {
        Self { ink, ..self }
    }

    /// Puts a marker at every point.
    #[must_use]
    pub fn marker(self, marker: Marker) -> Self {
        Self { marker: Some(marker), ..self }
    }

    /// Sets the width in pixels at scale 1.
    #[must_use]
    pub fn width(self, width_px: f64) -> Self {
        Self { width_px, ..self }
    }
}

/// Vertical stems from zero (on a logarithmic axis, from its lower end), each with a marker on top.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Stems {
    /// Entry in the legend; none where empty.
    pub label: String,
    /// Shape on top.
    pub marker: Marker,
    /// Outline or filled.
    pub fill: Fill,
    /// Colour.
    pub ink: Ink,
    /// Tops of the stems, in the units of the axes.
    pub xy: Vec<(f64, f64)>,
}

impl Stems {
    /// Stems with filled circles in the next free colour.
    pub fn new(label: impl Into<String>, xy: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self {
            label: label.into(),
            marker: Marker::Circle,
            fill: Fill::Solid,
            ink: Ink::Auto,
            xy: xy.into_iter().collect(),
        }
    }

    /// Sets the colour.
    #[must_use]
    pub fn ink(self, ink: Ink) -> Self {
        Self { ink, ..self }
    }

    /// Sets the shape on top.
    #[must_use]
    pub fn marker(self, marker: Marker, fill: Fill) -> Self {
        Self { marker, fill, ..self }
    }
}

/// The area between a lower and an upper curve.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Band {
    /// Entry in the legend; none where empty.
    pub label: String,
    /// Colour, drawn translucent.
    pub ink: Ink,
    /// `(x, lower, upper)` with x ascending, in the units of the axes.
    pub bounds: Vec<(f64, f64, f64)>,
}

impl Band {
    /// A band in the next free colour.
    pub fn new(
        label: impl Into<String>,
        bounds: impl IntoIterator<Item = (f64, f64, f64)>,
    ) -> Self {
        Self { label: label.into(), ink: Ink::Auto, bounds: bounds.into_iter().collect() }
    }

    /// Sets the colour.
    #[must_use]
    pub fn ink(self, ink: Ink) -> Self {
        Self { ink, ..self }
    }
}

/// One ellipse, in the units of the axes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Ellipse {
    /// Centre.
    pub center: (f64, f64),
    /// Half lengths of the two axes.
    pub semi_axes: (f64, f64),
    /// Angle from the x axis to the first half axis, counter-clockwise.
    pub angle_rad: f64,
}

/// Outlines of ellipses, for example of confidence regions.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Ellipses {
    /// Entry in the legend; none where empty.
    pub label: String,
    /// Pattern of the outline.
    pub dash: Dash,
    /// Colour.
    pub ink: Ink,
    /// The ellipses.
    pub ellipses: Vec<Ellipse>,
}

impl Ellipses {
    /// Outlines in the next free colour.
    pub fn new(
        label: impl Into<String>,
        dash: Dash,
        ellipses: impl IntoIterator<Item = Ellipse>,
    ) -> Self {
        Self { label: label.into(), dash, ink: Ink::Auto, ellipses: ellipses.into_iter().collect() }
    }

    /// Sets the colour.
    #[must_use]
    pub fn ink(self, ink: Ink) -> Self {
        Self { ink, ..self }
    }
}

/// Words beside a place in the panel.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Notes {
    /// `(x, y, text)`; the text is set beside the place, not over it.
    pub notes: Vec<(f64, f64, String)>,
}

impl Notes {
    /// Notes in black.
    pub fn new<S: Into<String>>(notes: impl IntoIterator<Item = (f64, f64, S)>) -> Self {
        Self { notes: notes.into_iter().map(|(x, y, text)| (x, y, text.into())).collect() }
    }
}

/// Anything that can be drawn in a panel. Later series lie over earlier ones.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
#[non_exhaustive]
pub enum Series {
    /// Separate points.
    Points(Points),
    /// A polyline.
    Line(Line),
    /// Vertical stems.
    Stems(Stems),
    /// The area between two curves.
    Band(Band),
    /// Outlines of ellipses.
    Ellipses(Ellipses),
    /// Words.
    Notes(Notes),
}

macro_rules! series_from {
    ($($kind:ident),*) => {$(
        impl From<$kind> for Series {
            fn from(series: $kind) -> Self {
                Self::$kind(series)
            }
        }
    )*};
}
series_from!(Points, Line, Stems, Band, Ellipses, Notes);

impl Series {
    /// Entry in the legend; empty where there is none.
    pub fn label(&self) -> &str {
        match self {
            Self::Points(s) => &s.label,
            Self::Line(s) => &s.label,
            Self::Stems(s) => &s.label,
            Self::Band(s) => &s.label,
            Self::Ellipses(s) => &s.label,
            Self::Notes(_) => "",
        }
    }
}
