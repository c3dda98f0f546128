//! What can go wrong between plain data and a rendered page.

/// Why a table, figure or document could not be built or rendered.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// A row has another number of cells than the table has columns.
    #[error("table {table:?}: row has {found} cells, the table has {needed} columns")]
    RowWidth {
        /// Title of the table.
        table: String,
        /// Cells in the refused row.
        found: usize,
        /// Columns of the table.
        needed: usize,
    },
    /// An identifier that cannot serve as a file name and an HTML anchor.
    #[error(
        "figure id {id:?}: needs 1 to 80 characters out of a-z, 0-9, '-' and '_', and a letter first"
    )]
    FigureId {
        /// The refused identifier.
        id: String,
    },
    /// Two figures of one document with the same identifier.
    #[error("figure id {id:?} occurs twice in the document, needs to be unique")]
    DuplicateFigureId {
        /// The repeated identifier.
        id: String,
    },
    /// A figure without panels.
    #[error("figure {figure:?}: no panels, at least 1 is needed")]
    NoPanels {
        /// Identifier of the figure.
        figure: String,
    },
    /// A grid with no column.
    #[error("figure {figure:?}: 0 columns, at least 1 is needed")]
    NoColumns {
        /// Identifier of the figure.
        figure: String,
    },
    /// A panel with nothing to draw and no ranges that say what to show.
    #[error("figure {figure:?}, panel {panel}: no data in the {axis} direction and no range given")]
    NoData {
        /// Identifier of the figure.
        figure: String,
        /// Panel number, from 1, row by row.
        panel: usize,
        /// `"x"` or `"y"`.
        axis: &'static str,
    },
    /// A number that is infinite or not a number.
    #[error(
        "figure {figure:?}, panel {panel}, series {series:?}, item {index}: {value} is not finite"
    )]
    NotFinite {
        /// Identifier of the figure.
        figure: String,
        /// Panel number, from 1, row by row.
        panel: usize,
        /// Label of the series.
        series: String,
        /// Index of the item in the series, from 0.
        index: usize,
        /// What was found.
        value: f64,
    },
    /// A value that a logarithmic axis cannot show.
    #[error(
        "figure {figure:?}, panel {panel}, series {series:?}, item {index}: {value} on a logarithmic {axis} axis, needs > 0 (or 0 where the axis has a range)"
    )]
    NotPositive {
        /// Identifier of the figure.
        figure: String,
        /// Panel number, from 1, row by row.
        panel: usize,
        /// Label of the series.
        series: String,
        /// Index of the item in the series, from 0.
        index: usize,
        /// `"x"` or `"y"`.
        axis: &'static str,
        /// What was found.
        value: f64,
    },
    /// An axis range that is empty, reversed, not finite, or not positive on a logarithmic axis.
    #[error(
        "figure {figure:?}, panel {panel}: {axis} range {low} to {high}, needs finite low < high (and low > 0 on a logarithmic axis)"
    )]
    Range {
        /// Identifier of the figure.
        figure: String,
        /// Panel number, from 1, row by row.
        panel: usize,
        /// `"x"` or `"y"`.
        axis: &'static str,
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
    },
    /// Equal axes asked for together with a logarithmic scale.
    #[error("figure {figure:?}, panel {panel}: equal axes need two linear scales")]
    EqualAspectOnLog {
        /// Identifier of the figure.
        figure: String,
        /// Panel number, from 1, row by row.
        panel: usize,
    },
    /// A picture that cannot be rasterised.
    #[error("svg to png: {reason}")]
    Raster {
        /// What the rasteriser said.
        reason: String,
    },
    /// A document that cannot be written as JSON.
    #[error("json: {reason}")]
    Json {
        /// What the writer said.
        reason: String,
    },
}
