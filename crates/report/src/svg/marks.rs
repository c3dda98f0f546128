//! Markers, lines and words as primitives of the plotting library, and the sizes that all who draw or avoid them share.

use super::frame::Pixel;
use crate::series::{Dash, Ellipse, Fill, Marker};
use kuva::render::render::{PathData, Primitive, TextAnchor};
use std::fmt::Write;

/// Half the width of the marker on a stem.
pub(super) const STEM_RADIUS_PX: f64 = 2.8;
/// Half the width of a marker on a line.
pub(super) const LINE_RADIUS_PX: f64 = 3.2;
/// How much of a band's colour is seen.
pub(super) const BAND_OPACITY: f64 = 0.25;
/// Width of the outline of a marker.
const OUTLINE_PX: f64 = 1.5;

/// A marker of this half width around a point.
pub(super) fn marker(marker: Marker, fill: Fill, colour: &str, at: Pixel, r: f64) -> Primitive {
    let inside = match fill {
        Fill::Open => "none",
        Fill::Solid => colour,
    };
    // Corners such that all shapes look equally large.
    let corners: Vec<(f64, f64)> = match marker {
        Marker::Circle => {
            return Primitive::Circle {
                cx: at.0,
                cy: at.1,
                r,
                fill: inside.into(),
                fill_opacity: None,
                stroke: Some(colour.into()),
                stroke_width: Some(OUTLINE_PX),
            };
        }
        Marker::Cross => {
            return strokes(
                colour,
                at,
                [[(-r, -r), (r, r)], [(-r, r), (r, -r)]]
                    .map(|s| s.map(|p| (0.92 * p.0, 0.92 * p.1))),
            );
        }
        Marker::Plus => {
            return strokes(
                colour,
                at,
                [[(-1.2 * r, 0.0), (1.2 * r, 0.0)], [(0.0, -1.2 * r), (0.0, 1.2 * r)]],
            );
        }
        Marker::Square => vec![(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
        Marker::Diamond => vec![(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
        Marker::Triangle => vec![(0.0, -1.15), (1.1, 0.75), (-1.1, 0.75)],
        Marker::TriangleDown => vec![(0.0, 1.15), (1.1, -0.75), (-1.1, -0.75)],
    };
    let corners: Vec<Pixel> =
        corners.into_iter().map(|(x, y)| (at.0 + r * x, at.1 + r * y)).collect();
    path(format!("{}Z", moves(&corners)), inside, colour, OUTLINE_PX, None, None)
}

fn strokes(colour: &str, at: Pixel, strokes: [[(f64, f64); 2]; 2]) -> Primitive {
    let d = strokes.map(|stroke| moves(&stroke.map(|(x, y)| (at.0 + x, at.1 + y)))).concat();
    path(d, "none", colour, OUTLINE_PX + 0.3, None, None)
}

/// A polyline.
pub(super) fn line(points: &[Pixel], colour: &str, width_px: f64, dash: Dash) -> Primitive {
    path(moves(points), "none", colour, width_px, pattern(dash, width_px), None)
}

/// A closed area without outline.
pub(super) fn area(corners: &[Pixel], colour: &str, opacity: f64) -> Primitive {
    path(format!("{}Z", moves(corners)), colour, "none", 0.0, None, Some(opacity))
}

/// 145 points around an ellipse, the first repeated at the end.
pub(super) fn outline(ellipse: &Ellipse) -> impl Iterator<Item = (f64, f64)> + use<> {
    let Ellipse { center, semi_axes, angle_rad } = *ellipse;
    let (sin, cos) = angle_rad.sin_cos();
    (0..=144_u8).map(move |i| {
        let (v, u) = (f64::from(i) / 144.0 * std::f64::consts::TAU).sin_cos();
        let (u, v) = (u * semi_axes.0, v * semi_axes.1);
        (center.0 + u * cos - v * sin, center.1 + u * sin + v * cos)
    })
}

/// A size that can be drawn, whatever was asked for.
pub(super) fn size(asked_px: f64, least: f64, most: f64) -> f64 {
    if asked_px.is_nan() { least } else { asked_px.clamp(least, most) }
}

/// A line of text on a baseline.
pub(super) fn text(
    content: &str,
    at: Pixel,
    size: u32,
    anchor: TextAnchor,
    rotate: Option<f64>,
) -> Primitive {
    Primitive::Text {
        x: at.0,
        y: at.1,
        content: literal(content),
        size,
        anchor,
        rotate,
        bold: false,
        color: None,
    }
}

/// Text without what XML cannot hold, and with the library's formula sign taken literally.
pub(super) fn literal(text: &str) -> String {
    let legal =
        |c: char| if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') { ' ' } else { c };
    text.chars().map(legal).collect::<String>().replace('$', "\\$")
}

fn path(
    d: String,
    fill: &str,
    stroke: &str,
    stroke_width: f64,
    dash: Option<String>,
    opacity: Option<f64>,
) -> Primitive {
    Primitive::Path(Box::new(PathData {
        d,
        fill: Some(fill.into()),
        stroke: stroke.into(),
        stroke_width,
        opacity,
        stroke_dasharray: dash,
    }))
}

fn moves(points: &[Pixel]) -> String {
    let mut d = String::with_capacity(16 * points.len());
    for (i, (x, y)) in points.iter().enumerate() {
        let _ = write!(d, "{}{x:.2},{y:.2}", if i == 0 { 'M' } else { 'L' });
    }
    d
}

fn pattern(dash: Dash, width_px: f64) -> Option<String> {
    let lengths: &[f64] = match dash {
        Dash::Solid => return None,
        Dash::Dashed => &[4.0, 2.5],
        Dash::Dotted => &[1.2, 2.0],
        Dash::DashDot => &[5.0, 2.0, 1.2, 2.0],
        Dash::LongDash => &[9.0, 3.0],
    };
    let scaled: Vec<String> =
        lengths.iter().map(|length| format!("{:.1}", length * width_px.max(0.8))).collect();
    Some(scaled.join(" "))
}
