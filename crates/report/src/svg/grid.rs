//! Where everything goes: panels in rows and columns, plot areas in line, room for every label.

use super::check;
use super::frame::Frame;
use super::scale::{Direction, TICK_PX, Ticks, View};
use crate::ReportError;
use crate::figure::{Aspect, Figure, Panel};
use crate::font;

/// Size of axis labels and legend entries.
pub(super) const LABEL_PX: u32 = 12;
/// Size of panel titles.
pub(super) const TITLE_PX: u32 = 13;
/// Distance of baselines in wrapped labels.
pub(super) const LINE_PX: f64 = 15.0;
/// Length of a major tick.
pub(super) const TICK_LENGTH_PX: f64 = 5.0;

/// What a picture is drawn for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Medium {
    /// A page or a screen: panels side by side.
    Page,
    /// A narrow screen: panels below one another, so that their text keeps its size.
    Phone,
}

/// One panel in its place.
#[derive(Debug)]
pub(super) struct Cell<'a> {
    pub(super) panel: &'a Panel,
    /// Top left corner and size of the cell on the paper.
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) width: f64,
    pub(super) height: f64,
    /// The plot area, relative to the cell.
    pub(super) frame: Frame,
    pub(super) x_ticks: Ticks,
    pub(super) y_ticks: Ticks,
    pub(super) title: Vec<String>,
    pub(super) x_label: Vec<String>,
    pub(super) y_label: Vec<String>,
}

/// The panels of a figure in their places, and the size of the whole.
#[derive(Debug)]
pub(super) struct Grid<'a> {
    pub(super) cells: Vec<Cell<'a>>,
    pub(super) width: f64,
    pub(super) height: f64,
}

impl<'a> Grid<'a> {
    pub(super) fn new(figure: &'a Figure, medium: Medium) -> Result<Self, ReportError> {
        check::figure(figure)?;
        let columns = match medium {
            Medium::Page => figure.columns.min(figure.panels.len()),
            Medium::Phone => 1,
        };
        let plot_width = match (medium, columns) {
            (Medium::Phone, _) => 280.0,
            (Medium::Page, 1) => 460.0,
            (Medium::Page, 2) => 290.0,
            (Medium::Page, 3) => 205.0,
            (Medium::Page, _) => 160.0,
        };
        let mut cells = Vec::with_capacity(figure.panels.len());
        for (i, panel) in figure.panels.iter().enumerate() {
            cells.push(Cell::new(figure, i, panel, plot_width)?);
        }
        for row in cells.chunks_mut(columns) {
            let height = row.iter().map(|cell| cell.frame.height).fold(0.0, f64::max);
            row.iter_mut().for_each(|cell| cell.settle(height));
        }
        if medium == Medium::Page {
            share_labels(&mut cells, columns);
        }
        Ok(Self::placed(cells, columns))
    }

    /// Gives all cells of a column the same left margin, and all cells of a row the same height.
    fn placed(mut cells: Vec<Cell<'a>>, columns: usize) -> Self {
        let (mut right, mut bottom) = (0.0, 0.0);
        for column in 0..columns {
            let margin = cells
                .iter()
                .skip(column)
                .step_by(columns)
                .map(Cell::left_margin)
                .fold(0.0, f64::max);
            let overhang = cells
                .iter()
                .skip(column)
                .step_by(columns)
                .map(Cell::right_margin)
                .fold(0.0, f64::max);
            let left = right;
            for cell in cells.iter_mut().skip(column).step_by(columns) {
                cell.left = left;
                cell.frame.left = margin;
                cell.width = margin + cell.frame.width + overhang;
                right = left + cell.width;
            }
        }
        for row in cells.chunks_mut(columns) {
            let above = row.iter().map(Cell::top_margin).fold(0.0, f64::max);
            let below = row.iter().map(Cell::bottom_margin).fold(0.0, f64::max);
            let top = bottom;
            for cell in row {
                cell.top = top;
                cell.frame.top = above;
                cell.height = above + cell.frame.height + below;
                bottom = top + cell.height;
            }
        }
        Self { cells, width: right, height: bottom }
    }
}

impl<'a> Cell<'a> {
    /// A cell with the height it would like best; ticks and labels come when the row has settled.
    fn new(
        figure: &Figure,
        index: usize,
        panel: &'a Panel,
        width: f64,
    ) -> Result<Self, ReportError> {
        let (x_span, y_span) = check::panel(figure, index + 1, panel)?;
        let (x, y) = (View::new(&panel.x, x_span), View::new(&panel.y, y_span));
        let ratio = match panel.aspect {
            Aspect::Free => 0.68,
            Aspect::Equal => (y.span() / x.span()).clamp(0.6, 1.0),
        };
        let title = match figure.panels.len() {
            1 => panel.title.clone(),
            _ => format!("({}) {}", letter(index), panel.title),
        };
        let frame = Frame { left: 0.0, top: 0.0, width, height: (width * ratio).round(), x, y };
        Ok(Self {
            panel,
            left: 0.0,
            top: 0.0,
            width: 0.0,
            height: 0.0,
            frame,
            x_ticks: Ticks::new(x, frame.width, Direction::Horizontal),
            y_ticks: Ticks::new(y, frame.height, Direction::Vertical),
            title: font::wrap(&title, TITLE_PX, width + 20.0),
            x_label: font::wrap(&panel.x.label, LABEL_PX, width),
            y_label: Vec::new(),
        })
    }

    /// Takes the height of the row, and widens one of two equal axes to fill it.
    fn settle(&mut self, height: f64) {
        let frame = &mut self.frame;
        frame.height = height;
        if self.panel.aspect == Aspect::Equal {
            let unit_px = (frame.width / frame.x.span()).min(frame.height / frame.y.span());
            frame.x.stretch(frame.width / unit_px);
            frame.y.stretch(frame.height / unit_px);
        }
        (self.x_ticks, self.y_ticks) = match self.panel.aspect {
            Aspect::Equal => Ticks::equal(frame.x, frame.y, frame.width, frame.height),
            Aspect::Free => (
                Ticks::new(frame.x, frame.width, Direction::Horizontal),
                Ticks::new(frame.y, frame.height, Direction::Vertical),
            ),
        };
        self.y_label = font::wrap(&self.panel.y.label, LABEL_PX, height);
    }

    /// Distance from the plot area to the baseline of the innermost line of the vertical label.
    pub(super) fn y_label_offset(&self) -> f64 {
        TICK_LENGTH_PX + 3.0 + self.y_ticks.widest_px + 8.0
    }

    fn left_margin(&self) -> f64 {
        self.y_label_offset() + LINE_PX * lines(&self.y_label) + 4.0
    }

    fn right_margin(&self) -> f64 {
        // Half of the last tick label may stand out.
        (0.5 * self.x_ticks.widest_px).max(8.0) + 8.0
    }

    fn top_margin(&self) -> f64 {
        12.0 + (LINE_PX + 1.0) * lines(&self.title)
    }

    fn bottom_margin(&self) -> f64 {
        TICK_LENGTH_PX + f64::from(TICK_PX) + 6.0 + LINE_PX * lines(&self.x_label) + 8.0
    }
}

fn lines(text: &[String]) -> f64 {
    text.iter().fold(0.0, |sum, _| sum + 1.0)
}

/// Drops the vertical label that the panel on the left has too, and the horizontal label that the panel below has too.
fn share_labels(cells: &mut [Cell<'_>], columns: usize) {
    for i in 0..cells.len() {
        if i % columns > 0 && cells[i].panel.y.label == cells[i - 1].panel.y.label {
            cells[i].y_label.clear();
        }
        if cells.get(i + columns).is_some_and(|below| below.panel.x.label == cells[i].panel.x.label)
        {
            cells[i].x_label.clear();
        }
    }
}

/// a, b, ..., z, aa, ab, ...
fn letter(index: usize) -> String {
    let last = char::from(b"abcdefghijklmnopqrstuvwxyz"[index % 26]);
    match index / 26 {
        0 => last.to_string(),
        more => format!("{}{last}", letter(more - 1)),
    }
}

#[cfg(test)]
mod tests;
