//! Figures as plain data: a grid of panels, each with two axes and its series.

use crate::series::Series;
use serde::Serialize;

/// Scale of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Scale {
    /// Equal steps for equal differences.
    #[default]
    Linear,
    /// Equal steps for equal ratios.
    Log10,
}

/// One axis of a panel.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Axis {
    /// What the axis measures, with its unit: `"frequency (rad/s)"`.
    pub label: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// Shown range (low, high); from the data where none. What lies outside is not drawn.
    pub range: Option<(f64, f64)>,
}

impl Axis {
    /// A linear axis that fits its data.
    pub fn linear(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Linear, range: None }
    }

    /// A logarithmic axis that fits its data, which have to be positive. Zeros are allowed, and not drawn,
    /// where the axis has a range.
    pub fn log(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Log10, range: None }
    }

    /// Sets the shown range.
    #[must_use]
    pub fn range(self, low: f64, high: f64) -> Self {
        Self { range: Some((low, high)), ..self }
    }
}

/// Relation between the units of the two axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Aspect {
    /// Each axis has its own scale.
    #[default]
    Free,
    /// One unit of x is as long as one unit of y: circles are round. The range of one axis is widened to fit.
    Equal,
}

/// A thin line behind the data that helps to read it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Guide {
    /// The circle of radius 1 around the origin: limit of stability in discrete time. An axis without a range
    /// shows all of it.
    UnitCircle,
    /// A horizontal line at this y.
    Horizontal(f64),
    /// A vertical line at this x.
    Vertical(f64),
}

/// One pair of axes with what is drawn between them.
///
/// # Example
///
/// ```
/// use report::{Axis, Panel, Points};
///
/// let panel = Panel::new("Transmissibility", Axis::linear("Re z"), Axis::linear("Im z"))
///     .equal_axes()
///     .unit_circle()
///     .with(Points::poles("pole", [(0.9, 0.1), (0.9, -0.1)]))
///     .with(Points::zeros("zero", [(0.5, 0.0)]));
/// assert_eq!(panel.series.len(), 2);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Panel {
    /// Title above the panel; may be empty.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Relation between the units of the axes.
    pub aspect: Aspect,
    /// Lines behind the data.
    pub guides: Vec<Guide>,
    /// What is drawn, from the bottom to the top.
    pub series: Vec<Series>,
}

impl Panel {
    /// An empty panel with free axes.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self {
            title: title.into(),
            x,
            y,
            aspect: Aspect::Free,
            guides: Vec::new(),
            series: Vec::new(),
        }
    }

    /// A pole-zero map in the z plane: axes "real part" and "imaginary part", equal, with the unit circle.
    pub fn z_plane(title: impl Into<String>) -> Self {
        Self::new(title, Axis::linear("real part"), Axis::linear("imaginary part"))
            .equal_axes()
            .unit_circle()
    }

    /// Shows only the given ranges (low, high): the zoom on one part of a map. With equal axes one of the two is
    /// widened to fill the panel, so ranges of about equal length waste least.
    #[must_use]
    pub fn zoom(mut self, x: (f64, f64), y: (f64, f64)) -> Self {
        self.x.range = Some(x);
        self.y.range = Some(y);
        self
    }

    /// Makes one unit of x as long as one unit of y.
    #[must_use]
    pub fn equal_axes(mut self) -> Self {
        self.aspect = Aspect::Equal;
        self
    }

    /// Draws the unit circle behind the data.
    #[must_use]
    pub fn unit_circle(self) -> Self {
        self.guide(Guide::UnitCircle)
    }

    /// Draws a line behind the data.
    #[must_use]
    pub fn guide(mut self, guide: Guide) -> Self {
        self.guides.push(guide);
        self
    }

    /// Adds a series on top.
    #[must_use]
    pub fn with(mut self, series: impl Into<Series>) -> Self {
        self.series.push(series.into());
        self
    }
}

/// Where the legend goes. It is common to all panels and outside them, so it never covers data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Legend {
    /// Under the panels; one entry per label and style. Not drawn where no series has a label.
    #[default]
    Below,
    /// No legend.
    Hidden,
}

/// A grid of panels with a title and a caption.
///
/// The title and the caption are set by the page (HTML, Markdown), not drawn into the picture. Several panels are
/// lettered (a), (b), ... in front of their titles. An axis label that the panel on the left or below has too is
/// drawn once.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Figure {
    /// File name without extension and anchor in the page: letters a-z, digits, `-` and `_`, a letter first.
    pub id: String,
    /// Short title.
    pub title: String,
    /// What the reader should see in it, in sentences.
    pub caption: String,
    /// Panels, row by row.
    pub panels: Vec<Panel>,
    /// Panels in a row.
    pub columns: usize,
    /// Where the legend goes.
    pub legend: Legend,
}

impl Figure {
    /// A figure without panels, one column wide.
    pub fn new(
        id: impl Into<String>,
        title: impl Into<String>,
        caption: impl Into<String>,
    ) -> Self {
        Self {
            id: id.into(),
            title: title.into(),
            caption: caption.into(),
            panels: Vec::new(),
            columns: 1,
            legend: Legend::Below,
        }
    }

    /// Sets the number of panels in a row.
    #[must_use]
    pub fn columns(self, columns: usize) -> Self {
        Self { columns, ..self }
    }

    /// Adds a panel to the right of the last one, or in a new row where the row is full.
    #[must_use]
    pub fn with(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// Sets where the legend goes.
    #[must_use]
    pub fn legend(self, legend: Legend) -> Self {
        Self { legend, ..self }
    }
}
