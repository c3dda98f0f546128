//! The shared records and the oracle of the least-squares problem.

use std::path::Path;

use serde_json::Value;

/// A path below the workspace's shared test data.
fn shared(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/data").join(name)
}

/// The columns `beta` and `channel` of a noise-free record.
pub(crate) fn noise_free(surface: &str, channel: &str) -> (Vec<f64>, Vec<f64>) {
    let text =
        std::fs::read_to_string(shared(&format!("records/noise_free_{surface}.csv"))).unwrap();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let position = |name: &str| header.iter().position(|h| *h == name).unwrap();
    let (input, output) = (position("beta"), position(channel));
    lines
        .map(|line| {
            let fields: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
            (fields[input], fields[output])
        })
        .unzip()
}

/// The solutions in `exact_least_squares.json`.
pub(crate) struct Oracle(Value);

impl Oracle {
    pub(crate) fn load() -> Self {
        let path =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/exact_least_squares.json");
        Self(serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap())
    }

    /// `exact`: the exact least-squares solution of the record; `true`: the parameters of the system.
    pub(crate) fn theta(&self, surface: &str, channel: &str, which: &str) -> Vec<f64> {
        numbers(&self.0[format!("{surface}_{channel}")][which])
    }
}

/// The aircraft part of the shared reference values.
pub(crate) fn aircraft() -> Value {
    let all: Value =
        serde_json::from_str(&std::fs::read_to_string(shared("reference.json")).unwrap()).unwrap();
    all["aircraft"]["as_printed"].clone()
}

pub(crate) fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

/// A list of `[re, im]` with exactly conjugate pairs.
pub(crate) fn complex_numbers(list: &Value) -> Vec<nalgebra::Complex<f64>> {
    let numbers = list.as_array().unwrap().iter().map(numbers);
    numbers.map(|pair| nalgebra::Complex::new(pair[0], pair[1])).collect()
}
