//! The oracle values of tests/data/reference.json.

use num_complex::Complex;
use serde_json::Value;

use crate::TaskError;

/// A place in the file, for example `/aircraft/as_printed/delta`.
pub(crate) fn numbers(pointer: &str) -> Result<Vec<f64>, TaskError> {
    let list = lookup(pointer)?;
    list.iter().map(|value| value.as_f64().ok_or_else(|| missing(pointer))).collect()
}

/// A list of real and imaginary parts.
pub(crate) fn roots(pointer: &str) -> Result<Vec<Complex<f64>>, TaskError> {
    let number =
        |value: &Value| Some(Complex::new(value.get(0)?.as_f64()?, value.get(1)?.as_f64()?));
    lookup(pointer)?.iter().map(|value| number(value).ok_or_else(|| missing(pointer))).collect()
}

/// A list of exact numbers, as text: integers or fractions.
pub(crate) fn exact(pointer: &str) -> Result<Vec<String>, TaskError> {
    let text =
        |value: &Value| value.as_str().map(str::to_owned).unwrap_or_else(|| value.to_string());
    Ok(lookup(pointer)?.iter().map(text).collect())
}

/// A matrix, row by row in one list.
pub(crate) fn matrix(pointer: &str) -> Result<Vec<f64>, TaskError> {
    let rows = lookup(pointer)?;
    rows.iter()
        .flat_map(|row| row.as_array().map(Vec::as_slice).unwrap_or_default())
        .map(|value| value.as_f64().ok_or_else(|| missing(pointer)))
        .collect()
}

fn lookup(pointer: &str) -> Result<Vec<Value>, TaskError> {
    let file: Value = serde_json::from_str(include_str!("../../../tests/data/reference.json"))
        .map_err(TaskError::computation("tests/data/reference.json"))?;
    file.pointer(pointer).and_then(Value::as_array).cloned().ok_or_else(|| missing(pointer))
}

fn missing(pointer: &str) -> TaskError {
    TaskError::Computation {
        part: "tests/data/reference.json",
        message: format!("nothing usable at {pointer}"),
    }
}
