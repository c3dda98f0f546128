//! What the documents of all studies have in common: sections of kinds, cells of tables, figures of
//! errors and of coverage.

use report::{Axis, Band, Block, Column, Dash, Figure, Guide, Ink, Line, Marker, Panel, Table};

use crate::TaskError;
use crate::shared::methods::Look;
use crate::shared::modes::{MODES, PerMode};

/// Kinds that are shown together, summed up: a section of the document, and a panel of each figure
/// for each thing that is drawn.
pub(super) struct Section<S> {
    pub(super) title: &'static str,
    pub(super) summaries: Vec<S>,
}

/// Neighbouring kinds whose section has the same title, each summed up.
pub(super) fn sections<K: Copy, O, S>(
    runs: &[(K, Vec<O>)],
    title: impl Fn(K) -> &'static str,
    summary: impl Fn(K, &[O]) -> S,
) -> Vec<Section<S>> {
    let neighbours = runs.chunk_by(|(a, _), (b, _)| title(*a) == title(*b));
    let section = |kinds: &[(K, Vec<O>)]| Section {
        title: title(kinds[0].0),
        summaries: kinds.iter().map(|(kind, outcomes)| summary(*kind, outcomes)).collect(),
    };
    neighbours.map(section).collect()
}

/// How well so many runs can tell a root mean square and a coverage.
pub(super) fn sampling_error(seeds: u64) -> String {
    format!(
        "sampling error of the study itself: {:.0} % of each root mean square, {:.1} % of a coverage of 95 %",
        100.0 / (2.0 * seeds as f64).sqrt(),
        100.0 * (0.95 * 0.05 / seeds as f64).sqrt()
    )
}

/// A table of finished cells.
pub(super) fn table<const N: usize>(
    title: impl Into<String>,
    header: [Column; N],
    rows: impl IntoIterator<Item = [String; N]>,
) -> Result<Block, TaskError> {
    let mut table = Table::new(title, header);
    for row in rows {
        table.push(row).map_err(TaskError::computation("report"))?;
    }
    Ok(table.into())
}

/// A number for each mode in one cell.
pub(super) fn three(values: PerMode, show: impl Fn(f64) -> String) -> String {
    values.map(show).join(" / ")
}

/// The cell where there is nothing.
pub(super) fn dash() -> String {
    "-".to_owned()
}

/// What figures draw over: what the x axis says, and the place of a summary on it.
#[derive(Clone, Copy)]
pub(super) struct Over<S> {
    pub(super) axis: fn() -> Axis,
    pub(super) place: fn(&S) -> f64,
}

impl<S> Over<S> {
    /// A number of each summary of a section, by place.
    fn points(&self, section: &Section<S>, y: impl Fn(&S) -> Option<f64>) -> Vec<(f64, f64)> {
        let points = section.summaries.iter().filter_map(|s| y(s).map(|y| ((self.place)(s), y)));
        let mut points: Vec<_> = points.collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        points
    }

    /// Errors with these looks, and the information bound: a row for each section, a column for
    /// each mode.
    pub(super) fn errors(
        &self,
        mut figure: Figure,
        label: &str,
        sections: &[Section<S>],
        looks: &[Look],
        error: impl Fn(&S, usize) -> Option<PerMode>,
        bound: impl Fn(&S) -> PerMode,
    ) -> Figure {
        figure = figure.columns(3);
        for section in sections {
            for (mode, name) in MODES.iter().enumerate() {
                let title = format!("{}, {name}", section.title);
                let mut panel = Panel::new(title, (self.axis)(), Axis::log(label));
                for (index, (label, ink, dash, marker)) in looks.iter().enumerate() {
                    let points = self.points(section, |s| error(s, index).map(|e| e[mode]));
                    if !points.is_empty() {
                        let line = Line::new(*label, *dash, points).ink(*ink).marker(*marker);
                        panel = panel.with(line);
                    }
                }
                let bound = self.points(section, |s| Some(bound(s)[mode]));
                let bound = Line::new("information bound", Dash::LongDash, bound).ink(Ink::Black);
                figure = figure.with(panel.with(bound));
            }
        }
        figure
    }

    /// How often 95 % regions hold the truth: a panel for each section, with a line for each mode
    /// and an area of `honest` percent.
    pub(super) fn coverage(
        &self,
        mut figure: Figure,
        range: (f64, f64),
        honest: (f64, f64),
        sections: &[Section<S>],
        title: impl Fn(&str) -> String,
        coverage: impl Fn(&S) -> PerMode,
    ) -> Figure {
        const LOOKS: [(Ink, Dash, Marker); 3] = [
            (Ink::Blue, Dash::Solid, Marker::Circle),
            (Ink::Vermillion, Dash::Dashed, Marker::Square),
            (Ink::Green, Dash::Dotted, Marker::Triangle),
        ];
        figure = figure.columns(2);
        let (low, high) = honest;
        for section in sections {
            let percent = Axis::linear("coverage (%)").range(range.0, range.1);
            let places = self.points(section, |_| Some(0.0)).into_iter();
            let area = Band::new(format!("{low} to {high} %"), places.map(|(x, _)| (x, low, high)));
            let mut panel = Panel::new(title(section.title), (self.axis)(), percent)
                .guide(Guide::Horizontal(95.0))
                .with(area.ink(Ink::Grey));
            for (mode, (ink, dash, marker)) in LOOKS.into_iter().enumerate() {
                let points = self.points(section, |s| Some(100.0 * coverage(s)[mode]));
                panel = panel.with(Line::new(MODES[mode], dash, points).ink(ink).marker(marker));
            }
            figure = figure.with(panel);
        }
        figure
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_share_a_section() {
        let runs = [(10, vec!["a", "b"]), (3, vec!["c"]), (-1, vec![])];
        let title = |kind: i32| if kind > 0 { "up" } else { "down" };
        let found = sections(&runs, title, |kind, outcomes| (kind, outcomes.len()));
        let [up, down] = &found[..] else { panic!("two sections") };
        assert_eq!((up.title, up.summaries.as_slice()), ("up", &[(10, 2), (3, 1)][..]));
        assert_eq!((down.title, down.summaries.as_slice()), ("down", &[(-1, 0)][..]));

        let over = Over { axis: || Axis::linear("kind"), place: |s: &(i32, usize)| f64::from(s.0) };
        let some = |summary: &(i32, usize)| (summary.1 > 0).then_some(summary.1 as f64);
        assert_eq!(over.points(up, some), [(3.0, 1.0), (10.0, 2.0)]);
        assert_eq!(over.points(down, some), []);
    }
}
