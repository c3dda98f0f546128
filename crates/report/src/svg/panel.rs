//! One panel: axes by the plotting library, guides, series, labels.

use super::grid::{Cell, LABEL_PX, LINE_PX, TICK_LENGTH_PX, TITLE_PX};
use super::ink::{BLACK, GREY, GRID};
use super::marks::{BAND_OPACITY, LINE_RADIUS_PX, STEM_RADIUS_PX, outline, size};
use super::scale::{TICK_PX, Ticks, View};
use super::{marks, notes};
use crate::figure::{Guide, Scale};
use crate::series::{Dash, Fill, Series};
use kuva::render::axis::add_axes_and_grid;
use kuva::render::layout::{AxisLine, ComputedLayout, Layout, TickFormat};
use kuva::render::render::{Primitive, Scene, TextAnchor};
use kuva::render::theme::Theme;
use std::sync::Arc;

/// Draws a cell at its place; `clip_id` names its plot area.
pub(super) fn draw(scene: &mut Scene, cell: &Cell<'_>, colours: &[&'static str], clip_id: &str) {
    let transform = Some(format!("translate({:.2},{:.2})", cell.left, cell.top));
    scene.add(Primitive::GroupStart { transform, title: None, extra_attrs: None });
    axes(scene, cell);
    guides(scene, cell);
    for (series, colour) in cell.panel.series.iter().zip(colours) {
        draw_series(scene, cell, series, colour, clip_id);
    }
    labels(scene, cell);
    scene.add(Primitive::GroupEnd);
}

fn axes(scene: &mut Scene, cell: &Cell<'_>) {
    let frame = &cell.frame;
    // The library counts in steps from tick to tick: its own axes give up below a span of 2e-16.
    let (x, x_format) = in_steps(frame.x, &cell.x_ticks);
    let (y, y_format) = in_steps(frame.y, &cell.y_ticks);
    let theme = Theme {
        axis_color: BLACK.into(),
        tick_color: BLACK.into(),
        grid_color: GRID.into(),
        ..Theme::light()
    };
    let mut layout = Layout::new((x.0, x.1), (y.0, y.1))
        .with_width(cell.width)
        .with_height(cell.height)
        .with_force_margins(frame.left, cell.width - frame.right())
        .with_force_margins_y(frame.top, cell.height - frame.bottom())
        .with_x_tick_step(x.2)
        .with_y_tick_step(y.2)
        .with_x_tick_format(x_format)
        .with_y_tick_format(y_format)
        .with_tick_size(TICK_PX)
        .with_tick_length(TICK_LENGTH_PX)
        .with_grid_line_width(0.8)
        .with_theme(theme);
    layout.axis_line = AxisLine::Box;
    (layout.x_axis_min, layout.x_axis_max) = (Some(x.0), Some(x.1));
    (layout.y_axis_min, layout.y_axis_max) = (Some(y.0), Some(y.1));
    add_axes_and_grid(scene, &ComputedLayout::from_layout(&layout), &layout);
    more_ticks(scene, cell);
}

/// Ends of an axis in steps, distance of its ticks in steps (one, or infinite where there are none), and how ticks are labelled.
fn in_steps(view: View, ticks: &Ticks) -> ((f64, f64, f64), TickFormat) {
    let (step, style) = (ticks.step, ticks.style);
    if step.is_infinite() {
        return ((0.0, 1.0, f64::INFINITY), TickFormat::Auto);
    }
    // Ticks on the frame stay on it.
    let settled = |end: f64| if (end - end.round()).abs() < 1e-9 { end.round() } else { end };
    let format = TickFormat::Custom(Arc::new(move |count: f64| style.label(count.round() * step)));
    ((settled(view.low / step), settled(view.high / step), 1.0), format)
}

/// The ticks of a logarithmic axis that are not whole powers of ten.
fn more_ticks(scene: &mut Scene, cell: &Cell<'_>) {
    let frame = &cell.frame;
    let below = |scene: &mut Scene, unit: f64, length: f64| {
        let (x, y) = (frame.pixel_of_units((unit, frame.y.low)).0, frame.bottom());
        scene.add(marks::line(&[(x, y), (x, y + length)], BLACK, 1.0, Dash::Solid));
        x
    };
    for unit in &cell.x_ticks.minor {
        below(scene, *unit, 0.6 * TICK_LENGTH_PX);
    }
    for (unit, label) in &cell.x_ticks.extra {
        let x = below(scene, *unit, TICK_LENGTH_PX);
        // The height of the font above its baseline, as the library has it.
        let baseline = frame.bottom() + TICK_LENGTH_PX + 0.928 * f64::from(TICK_PX);
        scene.add(marks::text(label, (x, baseline), TICK_PX, TextAnchor::Middle, None));
    }
    let beside = |scene: &mut Scene, unit: f64, length: f64| {
        let (x, y) = (frame.left, frame.pixel_of_units((frame.x.low, unit)).1);
        scene.add(marks::line(&[(x - length, y), (x, y)], BLACK, 1.0, Dash::Solid));
        y
    };
    for unit in &cell.y_ticks.minor {
        beside(scene, *unit, 0.6 * TICK_LENGTH_PX);
    }
    for (unit, label) in &cell.y_ticks.extra {
        let y = beside(scene, *unit, TICK_LENGTH_PX) + 0.36 * f64::from(TICK_PX);
        let place = (frame.left - TICK_LENGTH_PX - 3.0, y);
        scene.add(marks::text(label, place, TICK_PX, TextAnchor::End, None));
    }
}

fn guides(scene: &mut Scene, cell: &Cell<'_>) {
    let frame = &cell.frame;
    for guide in &cell.panel.guides {
        let lines = match *guide {
            Guide::UnitCircle => frame.unit_circle(),
            Guide::Horizontal(y) if frame.y.shows(y) => {
                let y = frame.pixel_of_units((frame.x.low, frame.y.unit(y))).1;
                vec![vec![(frame.left, y), (frame.right(), y)]]
            }
            Guide::Vertical(x) if frame.x.shows(x) => {
                let x = frame.pixel_of_units((frame.x.unit(x), frame.y.low)).0;
                vec![vec![(x, frame.top), (x, frame.bottom())]]
            }
            Guide::Horizontal(_) | Guide::Vertical(_) => Vec::new(),
        };
        lines.iter().for_each(|line| scene.add(marks::line(line, GREY, 1.1, Dash::Solid)));
    }
    let stems = cell.panel.series.iter().any(|series| matches!(series, Series::Stems(_)));
    if stems && frame.y.scale == Scale::Linear && frame.y.shows(0.0) {
        let y = frame.pixel_of_units((frame.x.low, 0.0)).1;
        scene.add(marks::line(&[(frame.left, y), (frame.right(), y)], GREY, 1.1, Dash::Solid));
    }
}

fn draw_series(scene: &mut Scene, cell: &Cell<'_>, series: &Series, colour: &str, clip_id: &str) {
    let frame = &cell.frame;
    let shown = |xy: &[(f64, f64)]| -> Vec<(f64, f64)> {
        xy.iter().filter(|point| frame.shows(**point)).map(|point| frame.pixel(*point)).collect()
    };
    let polyline = |scene: &mut Scene, points: &[(f64, f64)], width_px: f64, dash: Dash| {
        frame
            .clip(points)
            .iter()
            .for_each(|part| scene.add(marks::line(part, colour, width_px, dash)));
    };
    match series {
        Series::Points(s) => {
            // Small panels get smaller markers.
            let radius =
                size(s.radius_px, 0.5, 50.0) * if frame.width < 220.0 { 0.85 } else { 1.0 };
            shown(&s.xy)
                .into_iter()
                .for_each(|at| scene.add(marks::marker(s.marker, s.fill, colour, at, radius)));
        }
        Series::Line(s) => {
            let points: Vec<_> = s.xy.iter().map(|point| frame.pixel(*point)).collect();
            let width = size(s.width_px, 0.2, 20.0);
            polyline(scene, &points, width, s.dash);
            if let Some(marker) = s.marker {
                let marks = shown(&s.xy)
                    .into_iter()
                    .map(|at| marks::marker(marker, Fill::Open, colour, at, LINE_RADIUS_PX));
                marks.for_each(|mark| scene.add(mark));
            }
        }
        Series::Stems(s) => {
            let foot = match frame.y.scale {
                Scale::Linear => 0.0,
                Scale::Log10 => frame.y.low,
            };
            for (x, y) in &s.xy {
                let (top, unit) = (frame.pixel((*x, *y)), frame.x.unit(*x));
                polyline(scene, &[frame.pixel_of_units((unit, foot)), top], 1.3, Dash::Solid);
            }
            let tops = shown(&s.xy)
                .into_iter()
                .map(|at| marks::marker(s.marker, s.fill, colour, at, STEM_RADIUS_PX));
            tops.for_each(|mark| scene.add(mark));
        }
        Series::Band(s) => {
            // Bounded: far enough outside that the slope inside is right, near enough that it can be written.
            let near = |(x, y): (f64, f64)| (x.clamp(-1e6, 1e6), y.clamp(-1e6, 1e6));
            let upper = s.bounds.iter().map(|(x, _, high)| near(frame.pixel((*x, *high))));
            let lower = s.bounds.iter().rev().map(|(x, low, _)| near(frame.pixel((*x, *low))));
            let corners: Vec<_> = upper.chain(lower).collect();
            let (x, y, width, height) = (frame.left, frame.top, frame.width, frame.height);
            scene.add(Primitive::ClipStart { x, y, width, height, id: clip_id.to_owned() });
            scene.add(marks::area(&corners, colour, BAND_OPACITY));
            scene.add(Primitive::ClipEnd);
        }
        Series::Ellipses(s) => {
            for ellipse in &s.ellipses {
                let points: Vec<_> = outline(ellipse).map(|point| frame.pixel(point)).collect();
                polyline(scene, &points, 1.4, s.dash);
            }
        }
        Series::Notes(s) => notes::draw(scene, cell, s),
    }
}

fn labels(scene: &mut Scene, cell: &Cell<'_>) {
    let frame = &cell.frame;
    let middle = (frame.left + 0.5 * frame.width, frame.top + 0.5 * frame.height);
    let mut y = frame.top - 8.0;
    for line in cell.title.iter().rev() {
        scene.add(marks::text(line, (middle.0, y), TITLE_PX, TextAnchor::Middle, None));
        y -= LINE_PX + 1.0;
    }
    let mut y = frame.bottom() + TICK_LENGTH_PX + f64::from(TICK_PX) + 4.0;
    for line in &cell.x_label {
        y += LINE_PX;
        scene.add(marks::text(line, (middle.0, y), LABEL_PX, TextAnchor::Middle, None));
    }
    let mut x = frame.left - cell.y_label_offset();
    for line in cell.y_label.iter().rev() {
        scene.add(marks::text(line, (x, middle.1), LABEL_PX, TextAnchor::Middle, Some(-90.0)));
        x -= LINE_PX;
    }
}
