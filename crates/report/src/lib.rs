//! Tables and figures as plain data, rendered to CSV, JSON, Markdown, SVG, PNG and HTML.
//!
//! A program composes a [`Document`] of [`Block`]s: text, [`Table`]s and [`Figure`]s. A figure is a grid of
//! [`Panel`]s with two [`Axis`] each, and the [`Series`] between them. Nothing here reads or writes files: every
//! renderer returns text or bytes. The plotting library is known to this crate alone, and no type of it is public.
//!
//! ```
//! use report::{Figure, Panel, Points};
//!
//! let map = Panel::z_plane("sideslip to roll rate")
//!     .with(Points::poles("pole", [(0.9788, 0.1672), (0.9788, -0.1672)]))
//!     .with(Points::zeros("zero", [(0.9912, 0.0)]));
//! let figure = Figure::new("map", "Pole-zero map", "Poles and zeros of one transmissibility.").with(map);
//! assert_eq!(figure.panels.len(), 1);
//! ```

mod csv;
mod document;
mod error;
mod figure;
mod font;
pub mod html;
mod inline;
pub mod json;
pub mod markdown;
mod number;
pub mod png;
mod series;
pub mod svg;
mod table;

pub use document::{Block, CalloutKind, Document, ListKind};
pub use error::ReportError;
pub use figure::{Aspect, Axis, Figure, Guide, Legend, Panel, Scale};
pub use number::{format_complex, format_conjugate_pair, format_significant};
pub use series::{
    Band, Dash, Ellipse, Ellipses, Fill, Ink, Line, Marker, Notes, Points, Series, Stems,
};
pub use table::{Align, Column, Table};
