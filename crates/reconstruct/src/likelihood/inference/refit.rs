//! The problem of a fit that is finished, for what is asked of it afterwards.

use super::fit::Fit;
use crate::likelihood::cost::evaluation::{Evaluation, Problem};
use crate::likelihood::cost::lateral::LateralParameters;
use crate::likelihood::cost::noise::sensor_units;
use crate::likelihood::cost::parameters::{Layout, System};
use crate::likelihood::options::{Noise, Options};
use crate::likelihood::validation;
use crate::{ReconstructError, Record};

/// A fit's problem with the noise as the fit knows it, in sensors of unit noise.
pub(crate) struct Refit {
    pub(crate) problem: Problem,
    /// At the fitted system.
    pub(crate) evaluation: Evaluation,
    /// The variances of the noise, in these sensors, and the square of the model error where there is one.
    pub(crate) variances: Vec<f64>,
    /// The unit of each scaled sensor.
    pub(crate) units: Vec<f64>,
}

pub(crate) fn refit(records: &[Record], fit: &Fit) -> Result<Refit, ReconstructError> {
    refit_with(records, fit, &with_known_noise(fit), fit.model_error.map(|error| error.value))
}

/// The same under other options, with this model error where there is one.
pub(crate) fn refit_with(
    records: &[Record],
    fit: &Fit,
    known: &Options,
    model_error: Option<f64>,
) -> Result<Refit, ReconstructError> {
    let layout = validation::check(records, std::slice::from_ref(&fit.model), known)?;
    let units = sensor_units(records, known);
    let mut problem = Problem::new(layout, records, &units, known)?;
    let mut system = System::scaled(&fit.model, &units, &problem.layout);
    if let Some(derivatives) = &fit.lateral {
        let period = fit.model.period.seconds();
        problem.lateral = lateral(records, &units, &problem.layout, period);
        let own = problem.lateral.as_ref().and_then(|own| own.system(derivatives.clone()));
        system = own.unwrap_or(system);
    }
    let mut variances = vec![1.0; units.len()];
    variances.extend(model_error.map(|error| error * error));
    let evaluation = problem.evaluate(system, &variances);
    Ok(Refit { problem, evaluation, variances, units })
}

/// The options of a fit with the noise levels as it knows them.
fn with_known_noise(fit: &Fit) -> Options {
    let mut known = fit.options.clone();
    let Some(levels) = &fit.noise_levels else { return known };
    let levels = levels.iter().map(|level| level.value).collect();
    match &fit.options.noise {
        Noise::Estimated { .. } => known.noise = Noise::Given(levels),
        Noise::ModelError { .. } => known.noise = Noise::ModelError { first_guess: Some(levels) },
        Noise::Given(_) | Noise::Spectra(_) => {}
    }
    known
}

/// The lateral equations of these records; `None` where their sensors are others.
pub(crate) fn lateral(
    records: &[Record],
    units: &[f64],
    layout: &Layout,
    period: f64,
) -> Option<LateralParameters> {
    let names: Vec<&str> =
        records[0].channels().iter().map(|channel| channel.name.as_str()).collect();
    LateralParameters::new(&names, units, layout, period)
}
