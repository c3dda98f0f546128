//! How figures of all studies look.

use report::{Dash, Ink, Marker};

/// A name and its look in all figures.
pub(crate) type Look = (&'static str, Ink, Dash, Marker);
