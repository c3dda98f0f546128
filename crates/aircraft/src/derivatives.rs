//! Stability and control derivatives, inertia, and their checks.

use crate::AircraftError;

/// Lateral stability and control derivatives in steady straight flight.
///
/// Force derivatives are divided by mass, moment derivatives by the moment of inertia of their own axis (roll by `Ixx`, yaw by
/// `Izz`). Angles are in radians. The subscript 0 of the paper marks the trim condition and is left out here.
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `trim_speed_ft_s` | `U0` | ft/s |
/// | `gravity_ft_s2` | `g` | ft/s^2 |
/// | `y_beta_ft_s2`, `y_p_ft_s`, `y_r_ft_s` | `Y_beta`, `Y_p`, `Y_r` | ft/s^2, ft/s, ft/s |
/// | `l_beta_per_s2`, `l_t_beta_per_s2` | `L_beta`, `LT_beta` (thrust) | 1/s^2 |
/// | `l_p_per_s`, `l_r_per_s` | `L_p`, `L_r` | 1/s |
/// | `n_beta_per_s2`, `n_t_beta_per_s2` | `N_beta`, `NT_beta` (thrust) | 1/s^2 |
/// | `n_p_per_s`, `n_r_per_s` | `N_p`, `N_r` | 1/s |
/// | `y_aileron_ft_s2`, `y_rudder_ft_s2` | `Y_da`, `Y_dr` | ft/s^2 |
/// | `l_aileron_per_s2`, `l_rudder_per_s2` | `L_da`, `L_dr` | 1/s^2 |
/// | `n_aileron_per_s2`, `n_rudder_per_s2` | `N_da`, `N_dr` | 1/s^2 |
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LateralDerivatives {
    /// Trim speed along the body's x axis; positive.
    #[doc(alias = "U0")]
    pub trim_speed_ft_s: f64,
    /// Acceleration of gravity; positive.
    #[doc(alias = "g")]
    pub gravity_ft_s2: f64,
    /// Side force due to sideslip.
    #[doc(alias = "Y_beta")]
    pub y_beta_ft_s2: f64,
    /// Side force due to roll rate.
    #[doc(alias = "Y_p")]
    pub y_p_ft_s: f64,
    /// Side force due to yaw rate.
    #[doc(alias = "Y_r")]
    pub y_r_ft_s: f64,
    /// Rolling moment due to sideslip.
    #[doc(alias = "L_beta")]
    pub l_beta_per_s2: f64,
    /// Rolling moment of the thrust due to sideslip.
    #[doc(alias = "LT_beta")]
    pub l_t_beta_per_s2: f64,
    /// Rolling moment due to roll rate.
    #[doc(alias = "L_p")]
    pub l_p_per_s: f64,
    /// Rolling moment due to yaw rate.
    #[doc(alias = "L_r")]
    pub l_r_per_s: f64,
    /// Yawing moment due to sideslip.
    #[doc(alias = "N_beta")]
    pub n_beta_per_s2: f64,
    /// Yawing moment of the thrust due to sideslip.
    #[doc(alias = "NT_beta")]
    pub n_t_beta_per_s2: f64,
    /// Yawing moment due to roll rate.
    #[doc(alias = "N_p")]
    pub n_p_per_s: f64,
    /// Yawing moment due to yaw rate.
    #[doc(alias = "N_r")]
    pub n_r_per_s: f64,
    /// Side force due to the aileron.
    #[doc(alias = "Y_da")]
    pub y_aileron_ft_s2: f64,
    /// Rolling moment due to the aileron.
    #[doc(alias = "L_da")]
    pub l_aileron_per_s2: f64,
    /// Yawing moment due to the aileron.
    #[doc(alias = "N_da")]
    pub n_aileron_per_s2: f64,
    /// Side force due to the rudder.
    #[doc(alias = "Y_dr")]
    pub y_rudder_ft_s2: f64,
    /// Rolling moment due to the rudder.
    #[doc(alias = "L_dr")]
    pub l_rudder_per_s2: f64,
    /// Yawing moment due to the rudder.
    #[doc(alias = "N_dr")]
    pub n_rudder_per_s2: f64,
}

/// Moments and product of inertia in the axes of the derivatives.
///
/// Only ratios of products of two of them matter, so that any common unit does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inertia {
    /// Roll moment of inertia; positive.
    #[doc(alias = "Ixx")]
    pub ixx_slug_ft2: f64,
    /// Yaw moment of inertia; positive.
    #[doc(alias = "Izz")]
    pub izz_slug_ft2: f64,
    /// Product of inertia, `Ixz^2 < Ixx Izz`.
    #[doc(alias = "Ixz")]
    pub ixz_slug_ft2: f64,
}

fn finite(name: &'static str, value: f64) -> Result<(), AircraftError> {
    if value.is_finite() { Ok(()) } else { Err(AircraftError::NotFinite { name, value }) }
}

pub(crate) fn positive(name: &'static str, value: f64) -> Result<(), AircraftError> {
    finite(name, value)?;
    if value > 0.0 { Ok(()) } else { Err(AircraftError::NotPositive { name, value }) }
}

impl LateralDerivatives {
    pub(crate) fn check(&self) -> Result<(), AircraftError> {
        positive("trim_speed_ft_s", self.trim_speed_ft_s)?;
        positive("gravity_ft_s2", self.gravity_ft_s2)?;
        for (name, value) in [
            ("y_beta_ft_s2", self.y_beta_ft_s2),
            ("y_p_ft_s", self.y_p_ft_s),
            ("y_r_ft_s", self.y_r_ft_s),
            ("l_beta_per_s2", self.l_beta_per_s2),
            ("l_t_beta_per_s2", self.l_t_beta_per_s2),
            ("l_p_per_s", self.l_p_per_s),
            ("l_r_per_s", self.l_r_per_s),
            ("n_beta_per_s2", self.n_beta_per_s2),
            ("n_t_beta_per_s2", self.n_t_beta_per_s2),
            ("n_p_per_s", self.n_p_per_s),
            ("n_r_per_s", self.n_r_per_s),
            ("y_aileron_ft_s2", self.y_aileron_ft_s2),
            ("l_aileron_per_s2", self.l_aileron_per_s2),
            ("n_aileron_per_s2", self.n_aileron_per_s2),
            ("y_rudder_ft_s2", self.y_rudder_ft_s2),
            ("l_rudder_per_s2", self.l_rudder_per_s2),
            ("n_rudder_per_s2", self.n_rudder_per_s2),
        ] {
            finite(name, value)?;
        }
        Ok(())
    }
}

impl Inertia {
    pub(crate) fn check(&self) -> Result<(), AircraftError> {
        positive("ixx_slug_ft2", self.ixx_slug_ft2)?;
        positive("izz_slug_ft2", self.izz_slug_ft2)?;
        finite("ixz_slug_ft2", self.ixz_slug_ft2)?;
        let (product, square) =
            (self.ixx_slug_ft2 * self.izz_slug_ft2, self.ixz_slug_ft2 * self.ixz_slug_ft2);
        // Written so that an overflow of both is refused as well.
        if product.is_finite() && product > square {
            Ok(())
        } else {
            Err(AircraftError::IndefiniteInertia { product, square })
        }
    }
}
