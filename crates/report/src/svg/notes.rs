//! Words beside places: each on the side where it covers least.

use super::grid::Cell;
use super::marks;
use super::scale::TICK_PX;
use crate::font;
use crate::series::{Notes, Series};
use kuva::render::render::{Scene, TextAnchor};

/// A rectangle on the paper: left, top, right, bottom.
type Area = (f64, f64, f64, f64);

/// Distance of a note from its place.
const GAP_PX: f64 = 9.0;

pub(super) fn draw(scene: &mut Scene, cell: &Cell<'_>, notes: &Notes) {
    let frame = &cell.frame;
    let mut taken: Vec<Area> = marks_of(cell);
    for (x, y, text) in notes.notes.iter().filter(|(x, y, _)| frame.shows((*x, *y))) {
        let at = frame.pixel((*x, *y));
        let (width, height) = (font::width(text, TICK_PX), f64::from(TICK_PX));
        let area = |dx: f64, dy: f64| {
            let (left, top) = (at.0 + dx, at.1 + dy - 0.5 * height);
            (left, top, left + width, top + height)
        };
        let (right, left, center) = (GAP_PX, -GAP_PX - width, -0.5 * width);
        let rise = GAP_PX + 0.5 * height;
        let near = [(right, 0.0), (left, 0.0), (center, -rise), (center, rise)];
        let corners = [(right, -rise), (left, -rise), (right, rise), (left, rise)];
        let far = [
            (center, -2.0 * rise),
            (center, 2.0 * rise),
            (right, -2.0 * rise),
            (right, 2.0 * rise),
        ];
        let candidates = near.into_iter().chain(corners).chain(far).map(|(dx, dy)| area(dx, dy));
        let outside = |a: &Area| {
            (frame.left + 2.0 - a.0).max(0.0)
                + (a.2 - frame.right() + 2.0).max(0.0)
                + (frame.top + 2.0 - a.1).max(0.0)
                + (a.3 - frame.bottom() + 2.0).max(0.0)
        };
        let cost =
            |a: &Area| 1e3 * outside(a) + taken.iter().map(|other| overlap(a, other)).sum::<f64>();
        let Some(best) = candidates.min_by(|a, b| cost(a).total_cmp(&cost(b))) else { continue };
        scene.add(marks::text(
            text,
            (best.0, best.3 - 0.15 * height),
            TICK_PX,
            TextAnchor::Start,
            None,
        ));
        taken.push(best);
    }
}

/// Where the markers of the panel are.
fn marks_of(cell: &Cell<'_>) -> Vec<Area> {
    let mut areas = Vec::new();
    for series in &cell.panel.series {
        let (xy, r) = match series {
            Series::Points(s) => (&s.xy, s.radius_px),
            Series::Stems(s) => (&s.xy, super::panel::STEM_RADIUS_PX),
            Series::Line(s) => (&s.xy, super::panel::LINE_RADIUS_PX),
            _ => continue,
        };
        let shown = xy
            .iter()
            .filter(|point| cell.frame.shows(**point))
            .map(|point| cell.frame.pixel(*point));
        areas.extend(shown.map(|(x, y)| (x - r, y - r, x + r, y + r)));
    }
    areas
}

fn overlap(a: &Area, b: &Area) -> f64 {
    let width = (a.2.min(b.2) - a.0.max(b.0)).max(0.0);
    let height = (a.3.min(b.3) - a.1.max(b.1)).max(0.0);
    width * height
}
