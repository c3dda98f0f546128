//! An aircraft in a side gust.

use lti::{Continuous, StateSpace};
use nalgebra::DMatrix;

use crate::FlightError;
use crate::error::check_corner;

/// The aircraft in a side gust g, an angle like sideslip, that white noise n shapes: the result has n as its only input and g as its last state.
///
/// ```text
/// g' = -w g + w n,     x' = A x - a g,     vane = beta - g
/// ```
///
/// `w` is the corner frequency of the gust's first-order filter, `a` the first column of `A`: all that sideslip does to the aircraft it does through the air.
/// The first state of the aircraft must be sideslip. An output reads the gust as far as it reads sideslip, with the opposite sign.
///
/// # Errors
///
/// [`FlightError::Corner`], [`FlightError::NoSuchInput`] without a state, [`FlightError::System`].
///
/// # Example
///
/// ```
/// use flight::in_side_gust;
/// use lti::{Continuous, StateSpace};
/// use nalgebra::dmatrix;
///
/// let weathercock = StateSpace::<Continuous>::new(
///     dmatrix![-0.1, -1.0; 3.0, -0.1], dmatrix![0.0; 1.0], dmatrix![1.0, 0.0; 0.0, 1.0], dmatrix![0.0; 0.0])?;
/// let gusty = in_side_gust(&weathercock, 1.0)?;
/// assert_eq!(gusty.c(), &dmatrix![1.0, 0.0, -1.0; 0.0, 1.0, 0.0]);
/// assert_eq!(gusty.a()[(1, 2)], -3.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn in_side_gust(
    aircraft: &StateSpace<Continuous>,
    corner_rad_s: f64,
) -> Result<StateSpace<Continuous>, FlightError> {
    check_corner(corner_rad_s)?;
    let (n, outputs) = (aircraft.order(), aircraft.outputs());
    if n == 0 {
        return Err(FlightError::NoSuchInput { order: n, inputs: aircraft.inputs(), input: 0 });
    }
    let mut a = DMatrix::zeros(n + 1, n + 1);
    a.view_mut((0, 0), (n, n)).copy_from(aircraft.a());
    a.view_mut((0, n), (n, 1)).copy_from(&-aircraft.a().column(0));
    a[(n, n)] = -corner_rad_s;
    let mut b = DMatrix::zeros(n + 1, 1);
    b[n] = corner_rad_s;
    let mut c = DMatrix::zeros(outputs, n + 1);
    c.view_mut((0, 0), (outputs, n)).copy_from(aircraft.c());
    for output in 0..outputs {
        c[(output, n)] = -aircraft.c()[(output, 0)];
    }
    let d = DMatrix::zeros(outputs, 1);
    StateSpace::<Continuous>::new(a, b, c, d).map_err(|error| FlightError::system(&error))
}
