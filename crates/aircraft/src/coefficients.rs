//! From dimensional derivatives, as accelerations, to nondimensional coefficients.

use nalgebra::Matrix3;

use crate::AircraftError;
use crate::derivatives::{Inertia, positive};

/// Size, mass and flight condition of an aircraft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Geometry {
    /// Wing area, S.
    pub wing_area_ft2: f64,
    /// Wing span, b.
    pub span_ft: f64,
    /// Mass, m.
    pub mass_slug: f64,
    /// Density of the air, rho.
    pub air_density_slug_ft3: f64,
    /// True airspeed, U.
    pub true_airspeed_ft_s: f64,
}

/// What a derivative is taken by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// An angle in rad: sideslip or a surface.
    Angle,
    /// A rate in rad/s: roll or yaw. It is made nondimensional by b / 2U.
    Rate,
}

/// Takes the derivatives Y, L and N of the equations of motion solved for the accelerations to the coefficients C_Y, C_l and C_n.
///
/// | from | unit | to |
/// |---|---|---|
/// | Y: beta' over the variable | 1/s (angle), 1 (rate) | C_Y |
/// | L, N: p' and r' over the variable, products of inertia within them | 1/s^2, 1/s | C_l, C_n |
///
/// With q = rho U^2 / 2: C_Y = Y m U / (q S), C_l = (L - (Ixz / Ixx) N) Ixx / (q S b), C_n = (N - (Ixz / Izz) L) Izz / (q S b); those by a rate times 2 U / b
/// (Klein & Morelli, Aircraft System Identification, 2006, chapter 3).
///
/// # Errors
///
/// Numbers that are not positive or not finite; moments of inertia that belong to no body.
///
/// # Example
///
/// ```
/// use aircraft::{By, Geometry, Inertia, nondimensional};
///
/// let geometry = Geometry {
///     wing_area_ft2: 200.0,
///     span_ft: 30.0,
///     mass_slug: 100.0,
///     air_density_slug_ft3: 0.002,
///     true_airspeed_ft_s: 200.0,
/// };
/// let inertia = Inertia { ixx_slug_ft2: 1000.0, izz_slug_ft2: 2000.0, ixz_slug_ft2: 0.0 };
/// // q S = 40 * 200, so that L of -1.2 / s^2 is C_l = -1.2 * 1000 / (8000 * 30).
/// let scale = nondimensional(&geometry, &inertia, By::Angle)?;
/// assert!((scale[(1, 1)] * -1.2 + 0.005).abs() < 1e-15);
/// # Ok::<(), aircraft::AircraftError>(())
/// ```
pub fn nondimensional(
    geometry: &Geometry,
    inertia: &Inertia,
    by: By,
) -> Result<Matrix3<f64>, AircraftError> {
    for (name, value) in [
        ("wing_area_ft2", geometry.wing_area_ft2),
        ("span_ft", geometry.span_ft),
        ("mass_slug", geometry.mass_slug),
        ("air_density_slug_ft3", geometry.air_density_slug_ft3),
        ("true_airspeed_ft_s", geometry.true_airspeed_ft_s),
    ] {
        positive(name, value)?;
    }
    inertia.check()?;
    let speed = geometry.true_airspeed_ft_s;
    let force = 0.5 * geometry.air_density_slug_ft3 * speed * speed * geometry.wing_area_ft2;
    let moment = force * geometry.span_ft;
    let Inertia { ixx_slug_ft2: ixx, izz_slug_ft2: izz, ixz_slug_ft2: ixz } = *inertia;
    #[rustfmt::skip]
    let matrix = Matrix3::new(
        geometry.mass_slug * speed / force, 0.0, 0.0,
        0.0, ixx / moment, -ixz / moment,
        0.0, -ixz / moment, izz / moment,
    );
    Ok(match by {
        By::Angle => matrix,
        By::Rate => matrix * (2.0 * speed / geometry.span_ft),
    })
}

#[cfg(test)]
mod tests;
