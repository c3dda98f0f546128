//! Derivatives in nondimensional form, for an aircraft whose size, mass and inertia a file has.

use std::path::Path;

use aircraft::{By, Geometry, Inertia, nondimensional};
use nalgebra::{RowVector3, Vector3};
use reconstruct::output_error::{Derivative, Fit};
use serde::Deserialize;

use crate::CommandError;
use crate::aircraft_file::{self, InertiaFields};
use crate::error::in_file;

/// A coefficient with its standard error.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Coefficient {
    pub(crate) name: String,
    pub(crate) value: f64,
    pub(crate) standard_error: f64,
}

/// What is needed of a file that describes an aircraft; what else it holds is left alone.
#[derive(Deserialize)]
struct Description {
    #[serde(with = "GeometryFields")]
    geometry: Geometry,
    #[serde(with = "InertiaFields")]
    inertia: Inertia,
}

#[derive(Deserialize)]
#[serde(remote = "Geometry", deny_unknown_fields)]
struct GeometryFields {
    wing_area_ft2: f64,
    span_ft: f64,
    mass_slug: f64,
    air_density_slug_ft3: f64,
    true_airspeed_ft_s: f64,
}

/// The coefficients of a fit of the lateral equations; none of a black box.
pub(super) fn coefficients(file: &Path, fit: &Fit) -> Result<Vec<Coefficient>, CommandError> {
    let described: Description = aircraft_file::read(file)?;
    let scale = |by: By| {
        nondimensional(&described.geometry, &described.inertia, by)
            .map_err(|error| in_file(file, &error))
    };
    let (angle, rate) = (scale(By::Angle)?, scale(By::Rate)?);
    // Each variable with its derivatives Y, L, N.
    let mut variables = vec!["beta".to_owned(), "p".to_owned(), "r".to_owned()];
    let controls = fit.derivatives.iter().filter_map(|own| own.name.strip_prefix("L_"));
    variables.extend(controls.filter(|name| !["beta", "p", "r"].contains(name)).map(str::to_owned));
    let mut all = Vec::new();
    for variable in &variables {
        let by_rate = ["p", "r"].contains(&variable.as_str());
        let matrix = if by_rate { rate } else { angle };
        for (row, force) in ["Y", "l", "n"].into_iter().enumerate() {
            // Y_p and Y_r hold more than the side force.
            if by_rate && row == 0 {
                continue;
            }
            let weights: RowVector3<f64> = matrix.row(row).into_owned();
            all.extend(combined(fit, variable, weights, format!("C_{force}_{variable}")));
        }
    }
    Ok(all)
}

/// A combination of the derivatives Y, L and N by one variable.
fn combined(
    fit: &Fit,
    variable: &str,
    weights: RowVector3<f64>,
    name: String,
) -> Option<Coefficient> {
    let place = |force: &str| {
        let wanted = format!("{force}_{variable}");
        fit.derivatives.iter().position(|own: &Derivative| own.name == wanted)
    };
    let places = [place("Y")?, place("L")?, place("N")?];
    let values = Vector3::from(places.map(|k| fit.derivatives[k].estimate.value));
    let errors = Vector3::from(places.map(|k| fit.derivatives[k].estimate.standard_error));
    let scaled = weights.transpose().component_mul(&errors);
    let mut variance = 0.0;
    for (i, &row) in places.iter().enumerate() {
        for (k, &column) in places.iter().enumerate() {
            variance += scaled[i] * fit.correlations[(row, column)] * scaled[k];
        }
    }
    let value = (weights * values)[0];
    Some(Coefficient { name, value, standard_error: variance.max(0.0).sqrt() })
}
