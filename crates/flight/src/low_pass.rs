//! A system behind a low-pass filter in continuous time.

use std::f64::consts::FRAC_PI_8;

use lti::{Continuous, StateSpace};
use nalgebra::DMatrix;

use crate::FlightError;
use crate::error::check_corner;

/// States of the filter.
const FILTER: usize = 4;

/// A Butterworth filter of fourth order in front of one input of a system: the result has that input alone, the system's states first.
///
/// The filter's gain is 1 at frequency zero and `1 / sqrt(2)` at the corner. The system's feedthrough is left out: with four integrations before it, the
/// input reads through the states.
///
/// # Errors
///
/// [`FlightError::Corner`], [`FlightError::NoSuchInput`], [`FlightError::System`].
///
/// # Example
///
/// ```
/// use flight::behind_low_pass;
/// use lti::{Continuous, StateSpace};
/// use nalgebra::dmatrix;
///
/// let lag = StateSpace::<Continuous>::new(dmatrix![-1.0], dmatrix![1.0], dmatrix![1.0], dmatrix![0.0])?;
/// let filtered = behind_low_pass(&lag, 0, 6.0)?;
/// assert_eq!((filtered.order(), filtered.inputs()), (5, 1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn behind_low_pass(
    system: &StateSpace<Continuous>,
    input: usize,
    corner_rad_s: f64,
) -> Result<StateSpace<Continuous>, FlightError> {
    check_corner(corner_rad_s)?;
    let (n, inputs, outputs) = (system.order(), system.inputs(), system.outputs());
    if input >= inputs || n == 0 {
        return Err(FlightError::NoSuchInput { order: n, inputs, input });
    }
    let mut a = DMatrix::zeros(n + FILTER, n + FILTER);
    a.view_mut((0, 0), (n, n)).copy_from(system.a());
    // The second section's output moves the system.
    a.view_mut((0, n + 2), (n, 1)).copy_from(&system.b().column(input));
    let square = corner_rad_s * corner_rad_s;
    for (section, angle) in [(n, FRAC_PI_8), (n + 2, 3.0 * FRAC_PI_8)] {
        a[(section, section + 1)] = 1.0;
        a[(section + 1, section)] = -square;
        a[(section + 1, section + 1)] = -2.0 * angle.cos() * corner_rad_s;
    }
    a[(n + 3, n)] = square;
    let mut b = DMatrix::zeros(n + FILTER, 1);
    b[(n + 1, 0)] = square;
    let mut c = DMatrix::zeros(outputs, n + FILTER);
    c.view_mut((0, 0), (outputs, n)).copy_from(system.c());
    let d = DMatrix::zeros(outputs, 1);
    StateSpace::<Continuous>::new(a, b, c, d).map_err(|error| FlightError::system(&error))
}

#[cfg(test)]
mod tests;
