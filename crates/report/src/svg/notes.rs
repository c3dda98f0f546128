//! Words beside places: each on the side where it covers least.

use super::frame::Pixel;
use super::grid::Cell;
use super::marks::{self, LINE_RADIUS_PX, STEM_RADIUS_PX, outline};
use super::scale::TICK_PX;
use crate::figure::Guide;
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
        // To the sides, above and below, at growing distance.
        let candidates =
            [GAP_PX, 2.0 * GAP_PX, 4.0 * GAP_PX, 7.0 * GAP_PX].into_iter().flat_map(|gap| {
                let (right, left, center) = (gap, -gap - width, -0.5 * width);
                let rise = gap + 0.5 * height;
                let sides = [(right, 0.0), (left, 0.0), (center, -rise), (center, rise)];
                let corners = [(right, -rise), (left, -rise), (right, rise), (left, rise)];
                sides.into_iter().chain(corners).map(move |(dx, dy)| (gap, area(dx, dy)))
            });
        // Pixels that stand out of the frame, here with a rim of two.
        let outside = |a: &Area| {
            (frame.left + 2.0 - a.0).max(0.0)
                + (a.2 - frame.right() + 2.0).max(0.0)
                + (frame.top + 2.0 - a.1).max(0.0)
                + (a.3 - frame.bottom() + 2.0).max(0.0)
        };
        let cost = |(gap, a): &(f64, Area)| {
            let covered = taken.iter().map(|other| overlap(a, other)).sum::<f64>();
            1e3 * outside(a) + covered + 0.1 * gap
        };
        let Some((_, best)) = candidates.min_by(|a, b| cost(a).total_cmp(&cost(b))) else {
            continue;
        };
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

/// Where the markers and lines of the panel are; lines as a chain of small squares.
fn marks_of(cell: &Cell<'_>) -> Vec<Area> {
    let frame = &cell.frame;
    let mut areas = Vec::new();
    let around =
        |areas: &mut Vec<Area>, (x, y): Pixel, r: f64| areas.push((x - r, y - r, x + r, y + r));
    for series in &cell.panel.series {
        let (xy, r) = match series {
            Series::Points(s) => (&s.xy, s.radius_px),
            Series::Stems(s) => (&s.xy, STEM_RADIUS_PX),
            Series::Line(s) => (&s.xy, LINE_RADIUS_PX),
            Series::Ellipses(s) => {
                for point in s.ellipses.iter().flat_map(outline).filter(|point| frame.shows(*point))
                {
                    around(&mut areas, frame.pixel(point), 1.5);
                }
                continue;
            }
            Series::Band(_) | Series::Notes(_) => continue,
        };
        for point in xy.iter().filter(|point| frame.shows(**point)) {
            around(&mut areas, frame.pixel(*point), r);
        }
    }
    for guide in &cell.panel.guides {
        match *guide {
            Guide::UnitCircle => {
                frame.unit_circle().into_iter().flatten().for_each(|at| around(&mut areas, at, 1.0))
            }
            Guide::Horizontal(y) => {
                let y = frame.pixel((frame.x.low, y)).1;
                areas.push((frame.left, y - 1.0, frame.right(), y + 1.0));
            }
            Guide::Vertical(x) => {
                let x = frame.pixel((x, frame.y.low)).0;
                areas.push((x - 1.0, frame.top, x + 1.0, frame.bottom()));
            }
        }
    }
    areas
}

fn overlap(a: &Area, b: &Area) -> f64 {
    let width = (a.2.min(b.2) - a.0.max(b.0)).max(0.0);
    let height = (a.3.min(b.3) - a.1.max(b.1)).max(0.0);
    width * height
}
