//! The legend: one entry per label and style, in rows under the panels.

use super::frame::Pixel;
use super::grid::{LABEL_PX, LINE_PX};
use super::ink::GREY;
use super::marks::{self, BAND_OPACITY, LINE_RADIUS_PX, STEM_RADIUS_PX, size};
use crate::figure::{Figure, Guide, Legend};
use crate::font;
use crate::series::{Dash, Fill, Marker, Series};
use kuva::render::render::{Scene, TextAnchor};

/// Width of the widest sample in front of an entry.
const SAMPLE_PX: f64 = 28.0;
/// Width of a sample that is a single marker.
const MARKER_PX: f64 = 18.0;
/// From the sample to its text.
const GAP_PX: f64 = 6.0;
/// From one entry to the next.
const BETWEEN_PX: f64 = 22.0;
/// Height of a one-line entry.
const ROW_PX: f64 = 20.0;

/// What stands for a series.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Sample {
    Point(Marker, Fill, f64),
    Line(Dash, f64, Option<Marker>),
    Stem(Marker, Fill),
    Band,
    Ellipse(Dash),
}

#[derive(Debug)]
struct Entry {
    sample: Sample,
    colour: &'static str,
    lines: Vec<String>,
    left: f64,
    top: f64,
}

/// The entries in their places, from (0, 0) at the top left corner of the legend.
#[derive(Debug)]
pub(super) struct Placed {
    entries: Vec<Entry>,
    pub(super) height: f64,
}

impl Placed {
    pub(super) fn new(figure: &Figure, colours: &[Vec<&'static str>], width: f64) -> Self {
        let mut entries = match figure.legend {
            Legend::Hidden => Vec::new(),
            Legend::Below => entries(figure, colours, width - 24.0),
        };
        let mut height = 0.0;
        let mut first = 0;
        while first < entries.len() {
            let mut used = entries[first].width();
            let mut end = first + 1;
            while end < entries.len() && used + BETWEEN_PX + entries[end].width() <= width - 24.0 {
                used += BETWEEN_PX + entries[end].width();
                end += 1;
            }
            let mut left = 0.5 * (width - used);
            let mut row = 0.0_f64;
            for entry in &mut entries[first..end] {
                (entry.left, entry.top) = (left, height);
                left += entry.width() + BETWEEN_PX;
                row = row.max(entry.height());
            }
            height += row;
            first = end;
        }
        Self { height: if entries.is_empty() { 0.0 } else { height + 10.0 }, entries }
    }

    pub(super) fn draw(&self, scene: &mut Scene, top: f64) {
        for entry in &self.entries {
            let middle = top + entry.top + 0.5 * ROW_PX;
            entry.draw_sample(scene, (entry.left + 0.5 * entry.sample_width(), middle));
            let mut baseline = middle + 0.36 * f64::from(LABEL_PX);
            for line in &entry.lines {
                let at = (entry.left + entry.sample_width() + GAP_PX, baseline);
                scene.add(marks::text(line, at, LABEL_PX, TextAnchor::Start, None));
                baseline += LINE_PX;
            }
        }
    }
}

fn entries(figure: &Figure, colours: &[Vec<&'static str>], width: f64) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    let mut add = |label: &str, sample: Sample, colour: &'static str| {
        let lines = font::wrap(label, LABEL_PX, width - SAMPLE_PX - GAP_PX);
        let known =
            entries.iter().any(|e| e.lines == lines && e.sample == sample && e.colour == colour);
        if !known && !lines.is_empty() {
            entries.push(Entry { sample, colour, lines, left: 0.0, top: 0.0 });
        }
    };
    for (panel, colours) in figure.panels.iter().zip(colours) {
        for (series, colour) in panel.series.iter().zip(colours) {
            let sample = match series {
                Series::Points(s) => Sample::Point(s.marker, s.fill, size(s.radius_px, 2.0, 8.0)),
                Series::Line(s) => Sample::Line(s.dash, size(s.width_px, 0.5, 5.0), s.marker),
                Series::Stems(s) => Sample::Stem(s.marker, s.fill),
                Series::Band(_) => Sample::Band,
                Series::Ellipses(s) => Sample::Ellipse(s.dash),
                Series::Notes(_) => continue,
            };
            add(series.label(), sample, colour);
        }
    }
    let labelled = figure
        .panels
        .iter()
        .flat_map(|panel| &panel.series)
        .any(|series| !series.label().is_empty());
    if labelled && figure.panels.iter().any(|panel| panel.guides.contains(&Guide::UnitCircle)) {
        add("unit circle", Sample::Line(Dash::Solid, 1.1, None), GREY);
    }
    entries
}

impl Entry {
    fn sample_width(&self) -> f64 {
        match self.sample {
            Sample::Point(..) | Sample::Stem(..) => MARKER_PX,
            Sample::Line(..) | Sample::Band | Sample::Ellipse(_) => SAMPLE_PX,
        }
    }

    fn width(&self) -> f64 {
        SAMPLE_PX
            + GAP_PX
            + self.lines.iter().map(|line| font::width(line, LABEL_PX)).fold(0.0, f64::max)
    }

    fn height(&self) -> f64 {
        self.lines.iter().skip(1).fold(ROW_PX, |sum, _| sum + LINE_PX)
    }

    fn draw_sample(&self, scene: &mut Scene, at: Pixel) {
        let (x, y) = at;
        let half = 0.5 * SAMPLE_PX;
        match self.sample {
            Sample::Point(marker, fill, radius) => {
                scene.add(marks::marker(marker, fill, self.colour, at, radius))
            }
            Sample::Line(dash, width, marker) => {
                scene.add(marks::line(&[(x - half, y), (x + half, y)], self.colour, width, dash));
                if let Some(marker) = marker {
                    scene.add(marks::marker(marker, Fill::Open, self.colour, at, LINE_RADIUS_PX));
                }
            }
            Sample::Stem(marker, fill) => {
                scene.add(marks::line(
                    &[(x, y + 8.0), (x, y - 4.0)],
                    self.colour,
                    1.3,
                    Dash::Solid,
                ));
                scene.add(marks::marker(marker, fill, self.colour, (x, y - 4.0), STEM_RADIUS_PX));
            }
            Sample::Band => {
                let corners = [
                    (x - half, y - 6.0),
                    (x + half, y - 6.0),
                    (x + half, y + 6.0),
                    (x - half, y + 6.0),
                ];
                scene.add(marks::area(&corners, self.colour, BAND_OPACITY));
            }
            Sample::Ellipse(dash) => {
                let point = |i: u8| {
                    let (sin, cos) = (f64::from(i) / 36.0 * std::f64::consts::TAU).sin_cos();
                    (x + 12.0 * cos, y + 5.5 * sin)
                };
                let points: Vec<Pixel> = (0..=36).map(point).collect();
                scene.add(marks::line(&points, self.colour, 1.4, dash));
            }
        }
    }
}
