//! What the JSON of all commands has in common.

use num_complex::Complex;
use serde::Serialize;

use crate::CommandError;

/// A complex number.
#[derive(Serialize)]
pub(crate) struct Number {
    pub(crate) re: f64,
    pub(crate) im: f64,
}

impl From<Complex<f64>> for Number {
    fn from(value: Complex<f64>) -> Self {
        Self { re: value.re, im: value.im }
    }
}

/// The text of a result, indented, with a line feed at its end.
pub(crate) fn text(result: &impl Serialize) -> Result<Vec<u8>, CommandError> {
    let mut text = serde_json::to_vec_pretty(result)
        .map_err(|error| CommandError::Write { file: "-".into(), source: error.into() })?;
    text.push(b'\n');
    Ok(text)
}
