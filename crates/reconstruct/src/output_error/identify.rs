//! From records and their inputs to the most likely system.

use super::candidate::{Candidate, FIRST_LOOK};
use super::fit::{Context, Fit, conclude};
use super::forms::{Forms, Search};
use super::options::{Options, RecordedInputs, check};
use super::parametrisation::Form;
use crate::likelihood::FrequencyBand;
use crate::model::record::{check_compatible, refuse_constant_channels};
use crate::{ReconstructError, Record, Trend};

/// Fits one system to records whose inputs were all recorded; one record is enough.
///
/// # Errors
///
/// Records that do not fit together or hold a constant channel; [`ReconstructError::Option`] for inputs and options that do not fit the records;
/// [`ReconstructError::Start`] where no system could be fitted.
///
/// # Example
///
/// A mode that decays by 0.9 a step, driven by an input that is known.
///
/// ```
/// use lti::SamplePeriod;
/// use reconstruct::output_error::{Options, RecordedInputs, identify};
/// use reconstruct::subspace::OrderChoice;
/// use reconstruct::{Channel, Record};
///
/// let u: Vec<f64> = (0..400).map(|k| if k * k % 7 < 3 { 1.0 } else { -1.0 }).collect();
/// let mut x = vec![0.0];
/// for &u in &u[..399] {
///     x.push(0.9 * x[x.len() - 1] + u);
/// }
/// // A sensor with a disturbance.
/// let y = x.iter().zip(0_u32..).map(|(x, k)| x + 0.01 * f64::from(k * k % 11)).collect();
/// let record = Record::new("a", SamplePeriod::new(1.0)?, vec![Channel::new("y", y)])?;
/// let inputs = RecordedInputs { names: vec!["u".to_owned()], signals: vec![vec![u]] };
/// let mut options = Options::default();
/// options.order = OrderChoice::Fixed(1);
/// let fit = identify(&[record], &inputs, &options)?;
/// assert!((fit.modes[0].discrete.value.re - 0.9).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn identify(
    records: &[Record],
    inputs: &RecordedInputs,
    options: &Options,
) -> Result<Fit, ReconstructError> {
    if records.is_empty() {
        return Err(ReconstructError::TooFewRecords { found: 0, needed: 1 });
    }
    check_compatible(records)?;
    refuse_constant_channels(records)?;
    check(records, inputs, options)?;
    let period = records[0].period();
    let band = options.band.unwrap_or_else(|| FrequencyBand::before_the_modes(period));
    let search = Search::new(records, inputs, options, band, options.trend == Trend::Linear)?;
    let Forms { mut best, mut compared, mut hold_evidence } = search.best_form()?;
    let mut search = search;
    if options.trend == Trend::AsNeeded && has_integrator(&best, records) {
        // A state may stand in for the drift of a sensor.
        let drifting = Search::new(records, inputs, options, band, true)?;
        let forms = drifting.best_form()?;
        if forms.best.criterion < best.criterion {
            (best, compared, hold_evidence) = (forms.best, forms.compared, forms.hold_evidence);
            search = drifting;
        }
    }
    let mut wanted = search;
    let further = fastest(&best, records).and_then(|fastest| band.reaching_beyond(fastest, period));
    if let Some(band) = further.filter(|_| options.band.is_none()) {
        wanted = Search::new(records, inputs, options, band, wanted.drift)?;
    }
    match wanted.from(&best, FIRST_LOOK) {
        Some(found) => best = found,
        // Its weights belong to the first band.
        None => wanted = Search::new(records, inputs, options, band, wanted.drift)?,
    }
    if options.trend == Trend::AsNeeded && !wanted.drift {
        let drifting = Search::new(records, inputs, options, wanted.band, true)?;
        if drifting.explains_more(&best) {
            wanted = drifting;
            best = wanted.from(&best, FIRST_LOOK).unwrap_or(best);
        }
    }
    let best = best.refined(&wanted.spectra).unwrap_or(best);
    let context = Context {
        records,
        inputs,
        spectra: &wanted.spectra,
        band: wanted.band,
        drift: wanted.drift,
    };
    conclude(&context, &best, hold_evidence, compared)
}

/// Whether a mode moves by less than a radian or a factor of e in the longest record.
fn has_integrator(found: &Candidate, records: &[Record]) -> bool {
    let Some(matrices) = found.matrices() else { return false };
    let samples = records.iter().map(Record::samples).max().unwrap_or(0) as f64;
    let is_lateral = matches!(found.parametrisation.form, Form::Lateral(_));
    !is_lateral && matrices.a.complex_eigenvalues().iter().any(|z| z.ln().norm() * samples < 1.0)
}

/// The largest |s| of the eigenvalues, in rad/s.
fn fastest(found: &Candidate, records: &[Record]) -> Option<f64> {
    let period = records[0].period().seconds();
    let values = found.matrices()?.a.complex_eigenvalues();
    values.iter().map(|z| z.ln().norm() / period).filter(|s| s.is_finite()).max_by(f64::total_cmp)
}
