//! Which aircraft flies: one of the catalog, or one that a file describes.

use std::path::Path;

use aircraft::{Inertia, LateralDerivatives, LateralModel, SideForceScaling, catalog};
use serde::Deserialize;

use super::SimulateError;
use crate::CommandError;
use crate::aircraft_file::{self, InertiaFields};
use crate::error::in_file;

/// An aircraft and where its numbers come from.
#[derive(Debug)]
pub(super) struct ChosenAircraft {
    pub(super) name: String,
    pub(super) source: String,
    pub(super) model: LateralModel,
    pub(super) scaling: SideForceScaling,
}

/// A file that describes an aircraft. Its fields are those of the library, with their units in their names.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Description {
    name: String,
    #[serde(default)]
    source: Option<String>,
    #[serde(with = "DerivativesFields")]
    derivatives: LateralDerivatives,
    #[serde(with = "InertiaFields")]
    inertia: Inertia,
}

#[derive(Deserialize)]
#[serde(remote = "LateralDerivatives", deny_unknown_fields)]
struct DerivativesFields {
    trim_speed_ft_s: f64,
    #[serde(default = "standard_gravity")]
    gravity_ft_s2: f64,
    y_beta_ft_s2: f64,
    #[serde(default)]
    y_p_ft_s: f64,
    #[serde(default)]
    y_r_ft_s: f64,
    l_beta_per_s2: f64,
    #[serde(default)]
    l_t_beta_per_s2: f64,
    l_p_per_s: f64,
    l_r_per_s: f64,
    n_beta_per_s2: f64,
    #[serde(default)]
    n_t_beta_per_s2: f64,
    n_p_per_s: f64,
    n_r_per_s: f64,
    #[serde(default)]
    y_aileron_ft_s2: f64,
    l_aileron_per_s2: f64,
    n_aileron_per_s2: f64,
    y_rudder_ft_s2: f64,
    l_rudder_per_s2: f64,
    n_rudder_per_s2: f64,
}

fn standard_gravity() -> f64 {
    32.174
}

/// The aircraft of that name in the catalog, or the one that the file of that name describes.
///
/// The side force of the rudder is scaled as the source of the numbers has it: as printed for the paper's aircraft, over the speed for a file.
pub(super) fn find(text: &str) -> Result<ChosenAircraft, CommandError> {
    if let Some(entry) = catalog::find(text) {
        let model = LateralModel::new(entry.derivatives, entry.inertia)
            .map_err(|error| SimulateError::computation(&error))?;
        let (name, source) = (entry.name.to_owned(), entry.source.to_owned());
        return Ok(ChosenAircraft { name, source, model, scaling: scaling_of(entry) });
    }
    let file = Path::new(text);
    if !file.exists() {
        let known: Vec<&str> = catalog::ALL.iter().map(|entry| entry.name).collect();
        let (text, known) = (text.to_owned(), known.join(", "));
        return Err(SimulateError::NoSuchAircraft { text, known }.into());
    }
    let described: Description = aircraft_file::read(file)?;
    let model = LateralModel::new(described.derivatives, described.inertia)
        .map_err(|error| in_file(file, &error))?;
    let source = described.source.unwrap_or_else(|| text.to_owned());
    Ok(ChosenAircraft {
        name: described.name,
        source,
        model,
        scaling: SideForceScaling::Dimensional,
    })
}

/// The paper prints `Y_dr` undivided, and its records are those of that system.
fn scaling_of(entry: &catalog::CatalogEntry) -> SideForceScaling {
    if entry.name == catalog::PAPER_AIRCRAFT.name {
        SideForceScaling::AsPrinted
    } else {
        SideForceScaling::Dimensional
    }
}
