//! Eigenvalues and their shapes in the sensors -> modes with names.

use aircraft::{Eigenpair, ModeShape, NamedMode, name_modes};
use lti::Mode;
use num_complex::Complex;
use reconstruct::{AsPrinted, Record};

use crate::CommandError;

/// A mode as a person asks for it.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(crate) named: NamedMode,
    pub(crate) mode: Mode,
    /// The shared zero that it comes from.
    pub(crate) zero: Complex<f64>,
    /// Largest distance between the differences' versions of that zero.
    pub(crate) spread: f64,
}

/// Names the modes: by their shapes where the channels are called beta, p and r, otherwise by the pattern of the eigenvalues.
///
/// Complex pairs come once; the fastest mode comes first.
pub(crate) fn name(result: &AsPrinted, record: &Record) -> Result<Vec<Found>, CommandError> {
    let fault = |message: String| CommandError::Reconstruct(message);
    let upper = || result.modes.iter().filter(|mode| mode.eigenvalue.im >= 0.0);
    let pairs: Vec<Eigenpair> = upper()
        .map(|mode| Eigenpair {
            eigenvalue: mode.eigenvalue,
            shape: lateral_shape(&mode.shape, record),
        })
        .collect();
    let named = name_modes(&pairs).map_err(|error| fault(error.to_string()))?;
    let mut found = named
        .into_iter()
        .zip(upper())
        .map(|(named, mode)| {
            let zero = &result.shared.zeros[mode.shared];
            Ok(Found {
                named,
                mode: Mode::from_eigenvalue(mode.eigenvalue)
                    .map_err(|error| fault(error.to_string()))?,
                zero: zero.value,
                spread: zero.spread,
            })
        })
        .collect::<Result<Vec<_>, CommandError>>()?;
    found.sort_by(|a, b| b.mode.natural_frequency_rad_s.total_cmp(&a.mode.natural_frequency_rad_s));
    Ok(found)
}

fn lateral_shape(shape: &[Complex<f64>], record: &Record) -> Option<ModeShape> {
    let part = |name: &str| {
        let index =
            record.channels().iter().position(|channel| channel.name.eq_ignore_ascii_case(name))?;
        shape.get(index).copied().filter(|value| value.is_finite())
    };
    Some(ModeShape::from_sensors(part("beta")?, part("p")?, part("r")?))
}
