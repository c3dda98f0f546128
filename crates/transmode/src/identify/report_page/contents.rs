//! What the files of a report are called, and what tells that they are ours.

use super::{
    history, order, pole_map, recorded, residuals, spectra, stabilisation, transmissibility,
};

/// The page's name in the folder.
pub(super) const PAGE: &str = "report.html";

/// What the page says it was made by, before the version.
pub(super) const PROGRAM: &str = "transmode";

/// What the figures are called, in the order of the page.
pub(super) const FIGURES: [&str; 8] = [
    pole_map::ID,
    order::ID,
    stabilisation::ID,
    history::ID,
    spectra::ID,
    residuals::ID,
    residuals::WHITENESS_ID,
    transmissibility::ID,
];

/// What the figures of a page with recorded inputs are called, beside the pole map.
pub(super) const FIGURES_WITH_INPUTS: [&str; 3] =
    [recorded::TIME_HISTORIES_ID, recorded::LEFT_OVER_ID, recorded::COHERENCE_ID];
