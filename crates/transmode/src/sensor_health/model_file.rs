//! A transmissibility that `transmode fit --json` wrote.

use std::path::{Path, PathBuf};

use cfi_ident::{CfiModel, ConstantTerm, Orders, Structure};
use monitor::{Link, Stretch};
use serde::Deserialize;

use crate::CommandError;
use crate::records::check_same_period;

/// Residuals of different records are not as close as this.
const SAME_RESIDUAL: f64 = 1e-6;

/// What is needed of the file.
#[derive(Deserialize)]
struct Written {
    schema: u32,
    input: String,
    output: String,
    sample_period_s: Option<f64>,
    residual_rms: f64,
    orders: OrdersWritten,
    constant_term: bool,
    parameters: Vec<ParameterWritten>,
}

#[derive(Deserialize)]
struct OrdersWritten {
    iir: usize,
    causal: usize,
    anticausal: usize,
}

#[derive(Deserialize)]
struct ParameterWritten {
    name: String,
    value: f64,
}

/// A model and the sensors that it relates.
#[derive(Debug)]
pub(super) struct ModelFile {
    place: PathBuf,
    input: String,
    output: String,
    sample_period_s: Option<f64>,
    /// Root mean square of its residual in the record to which it was fitted.
    residual_rms: f64,
    model: CfiModel,
}

/// Reads a file that `transmode fit --json` wrote.
pub(super) fn read(place: &Path) -> Result<ModelFile, CommandError> {
    let bytes = std::fs::read(place)
        .map_err(|source| CommandError::Read { file: place.to_owned(), source })?;
    let fault = |message: String| CommandError::InFile { file: place.to_owned(), message };
    let written: Written = serde_json::from_slice(&bytes).map_err(|error| {
        fault(format!("this is no result of transmode fit --json ({error}); write it again"))
    })?;
    if written.schema != 1 {
        let message = format!("schema {} is not known, 1 is; write the file again", written.schema);
        return Err(fault(message));
    }
    let OrdersWritten { iir, causal, anticausal } = written.orders;
    let orders = Orders::new(iir, causal, anticausal).map_err(|error| fault(error.to_string()))?;
    let constant_term =
        if written.constant_term { ConstantTerm::Included } else { ConstantTerm::Omitted };
    let structure = Structure::new(orders, constant_term);
    let expected = structure.parameters().map(|parameter| parameter.to_string());
    if !expected.eq(written.parameters.iter().map(|parameter| parameter.name.clone())) {
        let message = "its parameters are not those of its orders; write the file again";
        return Err(fault(message.to_owned()));
    }
    let theta: Vec<f64> = written.parameters.iter().map(|parameter| parameter.value).collect();
    let model =
        CfiModel::from_theta(structure, &theta).map_err(|error| fault(error.to_string()))?;
    Ok(ModelFile {
        place: place.to_owned(),
        input: written.input,
        output: written.output,
        sample_period_s: written.sample_period_s,
        residual_rms: written.residual_rms,
        model,
    })
}

/// All sensors of these models, each once.
pub(super) fn sensors(models: &[ModelFile]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for name in models.iter().flat_map(|model| [&model.input, &model.output]) {
        if !names.contains(name) {
            names.push(name.clone());
        }
    }
    names
}

impl ModelFile {
    /// The model between the sensors of that name.
    pub(super) fn link(&self, sensors: &[String], period_s: f64) -> Result<Link, CommandError> {
        let fault = |message| CommandError::InFile { file: self.place.clone(), message };
        if let Some(own_s) = self.sample_period_s {
            check_same_period(own_s, period_s, "the reference").map_err(fault)?;
        }
        let index = |name: &String| {
            sensors.iter().position(|sensor| sensor == name).ok_or_else(|| {
                fault(format!("it relates {name:?}, which is not among the sensors {}; choose it with --outputs", sensors.join(", ")))
            })
        };
        Ok(Link {
            model: self.model.clone(),
            input: index(&self.input)?,
            output: index(&self.output)?,
        })
    }

    /// Whether the model has in these stretches the very residual that it had where it was fitted.
    pub(super) fn was_fitted_to(&self, link: &Link, stretches: &[Stretch<'_>]) -> bool {
        let (mut squares, mut equations) = (0.0, 0.0);
        for stretch in stretches.iter().flat_map(monitor::complete) {
            let (Some(input), Some(output)) = (stretch.get(link.input), stretch.get(link.output))
            else {
                return false;
            };
            // A stretch that is too short for a residual had none there either.
            let residuals = self.model.residuals(input, output).map(|found| found.values);
            for residual in residuals.unwrap_or_default() {
                squares += residual * residual;
                equations += 1.0;
            }
        }
        let rms = (squares / f64::max(equations, 1.0)).sqrt();
        (rms - self.residual_rms).abs() <= SAME_RESIDUAL * self.residual_rms
    }
}
