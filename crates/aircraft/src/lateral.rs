//! The linear lateral model from derivatives and inertia.

use std::fmt;

use lti::{Continuous, StateSpace};
use nalgebra::DMatrix;

use crate::{AircraftError, Inertia, LateralDerivatives};

/// A control surface of the lateral motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Surface {
    /// Deflection `da`.
    Aileron,
    /// Deflection `dr`.
    Rudder,
}

impl Surface {
    /// Both, aileron first.
    pub const ALL: [Self; 2] = [Self::Aileron, Self::Rudder];
}

impl fmt::Display for Surface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Aileron => "aileron",
            Self::Rudder => "rudder",
        })
    }
}

/// How the side force of a surface enters the sideslip equation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum SideForceScaling {
    /// `Y_da` and `Y_dr` undivided, as the paper prints them. The default, since it reproduces the paper's example.
    #[default]
    AsPrinted,
    /// `Y_da/U0` and `Y_dr/U0`, as the units require and as the first row of `A` has it.
    Dimensional,
}

/// A state of the lateral model, in the order of the state vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LateralState {
    /// Sideslip angle, rad.
    #[doc(alias = "beta")]
    Sideslip,
    /// Roll rate, rad/s.
    #[doc(alias = "p")]
    RollRate,
    /// Yaw rate, rad/s.
    #[doc(alias = "r")]
    YawRate,
    /// Bank angle, rad.
    #[doc(alias = "phi")]
    BankAngle,
}

impl LateralState {
    /// All four, in the order of the state vector.
    pub const ALL: [Self; 4] = [Self::Sideslip, Self::RollRate, Self::YawRate, Self::BankAngle];

    /// Position in the state vector, from 0.
    #[must_use]
    pub fn index(self) -> usize {
        match self {
            Self::Sideslip => 0,
            Self::RollRate => 1,
            Self::YawRate => 2,
            Self::BankAngle => 3,
        }
    }

    /// Unit of the state.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Sideslip | Self::BankAngle => "rad",
            Self::RollRate | Self::YawRate => "rad/s",
        }
    }
}

impl fmt::Display for LateralState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Sideslip => "sideslip",
            Self::RollRate => "roll rate",
            Self::YawRate => "yaw rate",
            Self::BankAngle => "bank angle",
        })
    }
}

/// The lateral motion near steady straight flight: `x' = A x + B u`, `x = [beta, p, r, phi]`.
///
/// `A = Gamma F`, with `F` from the derivatives,
///
/// ```text
///     [ Y_beta/U0          Y_p/U0  (Y_r - U0)/U0  g/U0 ]
/// F = [ L_beta + LT_beta   L_p     L_r            0    ]
///     [ N_beta + NT_beta   N_p     N_r            0    ]
///     [ 0                  1       0              0    ]
/// ```
///
/// and `Gamma` from the inertia, which solves the two moment equations for the accelerations in roll and yaw:
///
/// ```text
///         [ 1  0             0             0 ]
/// Gamma = [ 0  Ixx Izz / d   Ixz Izz / d   0 ]    d = Ixx Izz - Ixz^2
///         [ 0  Ixz Ixx / d   Ixx Izz / d   0 ]
///         [ 0  0             0             1 ]
/// ```
///
/// `B = Gamma [Y_d, L_d, N_d, 0]'` per surface. Angles are in radians, time in seconds. The trim is level flight: the
/// gravity term has no cosine of the pitch angle.
///
/// Source: paper eq. (46) and the matrices below it.
///
/// # Example
///
/// ```
/// use aircraft::{LateralModel, SideForceScaling, Surface, catalog};
///
/// let model = LateralModel::new(catalog::PAPER_AIRCRAFT.derivatives, catalog::PAPER_AIRCRAFT.inertia)?;
/// assert_eq!(model.a()[(0, 3)], 32.174 / 400.0);
///
/// let printed = model.control_matrix(Surface::Rudder, SideForceScaling::AsPrinted);
/// let dimensional = model.control_matrix(Surface::Rudder, SideForceScaling::Dimensional);
/// assert_eq!(printed[0], 10.4733);
/// assert_eq!(dimensional[0], 10.4733 / 400.0);
/// # Ok::<(), aircraft::AircraftError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LateralModel {
    derivatives: LateralDerivatives,
    inertia: Inertia,
}

impl LateralModel {
    /// Checks the numbers.
    ///
    /// # Errors
    ///
    /// A number that is not finite, a speed, gravity or moment of inertia that is not positive, `Ixx Izz <= Ixz^2`.
    pub fn new(derivatives: LateralDerivatives, inertia: Inertia) -> Result<Self, AircraftError> {
        derivatives.check()?;
        inertia.check()?;
        Ok(Self { derivatives, inertia })
    }

    /// The derivatives.
    #[must_use]
    pub fn derivatives(&self) -> &LateralDerivatives {
        &self.derivatives
    }

    /// The inertia.
    #[must_use]
    pub fn inertia(&self) -> &Inertia {
        &self.inertia
    }

    /// The inertia coupling `Gamma`, 4 by 4.
    #[must_use]
    pub fn gamma(&self) -> DMatrix<f64> {
        let Inertia { ixx_slug_ft2: ixx, izz_slug_ft2: izz, ixz_slug_ft2: ixz } = self.inertia;
        let determinant = ixx * izz - ixz * ixz;
        let own = ixx * izz / determinant;
        let mut gamma = DMatrix::identity(4, 4);
        gamma[(1, 1)] = own;
        gamma[(1, 2)] = ixz * izz / determinant;
        gamma[(2, 1)] = ixz * ixx / determinant;
        gamma[(2, 2)] = own;
        gamma
    }

    /// The dynamics matrix `A`, 4 by 4, states sideslip, roll rate, yaw rate, bank angle.
    #[must_use]
    pub fn a(&self) -> DMatrix<f64> {
        let d = &self.derivatives;
        let speed = d.trim_speed_ft_s;
        #[rustfmt::skip]
        let uncoupled = DMatrix::from_row_slice(4, 4, &[
            d.y_beta_ft_s2 / speed, d.y_p_ft_s / speed, (d.y_r_ft_s - speed) / speed, d.gravity_ft_s2 / speed,
            d.l_beta_per_s2 + d.l_t_beta_per_s2, d.l_p_per_s, d.l_r_per_s, 0.0,
            d.n_beta_per_s2 + d.n_t_beta_per_s2, d.n_p_per_s, d.n_r_per_s, 0.0,
            0.0, 1.0, 0.0, 0.0,
        ]);
        self.gamma() * uncoupled
    }

    /// The column of `B` of one surface, 4 by 1, per radian of deflection.
    #[must_use]
    pub fn control_matrix(&self, surface: Surface, scaling: SideForceScaling) -> DMatrix<f64> {
        let d = &self.derivatives;
        let (side, roll, yaw) = match surface {
            Surface::Aileron => (d.y_aileron_ft_s2, d.l_aileron_per_s2, d.n_aileron_per_s2),
            Surface::Rudder => (d.y_rudder_ft_s2, d.l_rudder_per_s2, d.n_rudder_per_s2),
        };
        let side = match scaling {
            SideForceScaling::AsPrinted => side,
            SideForceScaling::Dimensional => side / d.trim_speed_ft_s,
        };
        self.gamma() * DMatrix::from_column_slice(4, 1, &[side, roll, yaw, 0.0])
    }

    /// The model as a system: inputs are the surfaces, outputs the chosen states, both in the order given.
    ///
    /// [`Surface::ALL`] and [`LateralState::ALL`] give the full model with `C = I` and `D = 0`.
    ///
    /// # Errors
    ///
    /// No surface, no output, or numbers so large that a matrix overflows.
    ///
    /// # Example
    ///
    /// ```
    /// use aircraft::{LateralModel, LateralState, SideForceScaling, Surface, catalog};
    ///
    /// let model = LateralModel::new(catalog::PAPER_AIRCRAFT.derivatives, catalog::PAPER_AIRCRAFT.inertia)?;
    /// let outputs = [LateralState::RollRate, LateralState::Sideslip];
    /// let system = model.state_space(&[Surface::Aileron], SideForceScaling::AsPrinted, &outputs)?;
    /// assert_eq!((system.order(), system.inputs(), system.outputs()), (4, 1, 2));
    /// assert_eq!(system.c()[(0, 1)], 1.0);
    /// # Ok::<(), aircraft::AircraftError>(())
    /// ```
    pub fn state_space(
        &self,
        surfaces: &[Surface],
        scaling: SideForceScaling,
        outputs: &[LateralState],
    ) -> Result<StateSpace<Continuous>, AircraftError> {
        if surfaces.is_empty() {
            return Err(AircraftError::NoSurface);
        }
        if outputs.is_empty() {
            return Err(AircraftError::NoOutput);
        }
        let mut b = DMatrix::zeros(4, surfaces.len());
        for (j, &surface) in surfaces.iter().enumerate() {
            b.set_column(j, &self.control_matrix(surface, scaling).column(0));
        }
        let mut c = DMatrix::zeros(outputs.len(), 4);
        for (i, output) in outputs.iter().enumerate() {
            c[(i, output.index())] = 1.0;
        }
        let d = DMatrix::zeros(outputs.len(), surfaces.len());
        StateSpace::<Continuous>::new(self.a(), b, c, d)
            .map_err(|error| AircraftError::InvalidModel { reason: error.to_string() })
    }
}

#[cfg(test)]
mod tests;
