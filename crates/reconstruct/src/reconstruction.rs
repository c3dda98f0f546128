//! Which modes do these records show, and what is there to doubt? The one entry point to all methods.

mod doubt;
mod lateral;
mod model_error;
mod noise_choice;
mod options;
mod result;
mod spectra;
mod starts;
mod white_noise;

use lti::{Discrete, Mode, SamplePeriod, StateSpace};
use nalgebra::DMatrix;

pub use doubt::{Doubt, RecordCondition};
pub use options::{Excitation, Method, Options};

pub use result::{ComparedForm, ComparedOrder, Details, FoundMode, Reconstruction};
pub use spectra::spectral_fits;
use starts::FirstStage;
use white_noise::Fitted;

use crate::likelihood::{offset_estimates, profile_intervals};
use crate::subspace::Intersection;
use crate::{ReconstructError, Record, output_error, paper, subspace};

/// Reconstructs the modes of a system from records of its sensors, each under an excitation that nobody measured.
///
/// | method | needs | gives |
/// |---|---|---|
/// | [`Method::MaximumLikelihood`] | two records of three sensors or three of two | modes with deviations and intervals, tests of fit |
/// | [`Method::OutputError`] | one record or more with its inputs recorded | modes with standard errors, derivatives, lags |
/// | [`Method::Subspace`] | the same | modes, order, ranks of the excitations; closed form |
/// | [`Method::Paper`] | two records of three sensors, no noise | modes |
///
/// Signal subspaces are intersected with half, once and one and a half times the block rows of their rule: together they give the order, and for
/// the likelihood the first guess of the noise levels and the starts, of which the best local optimum counts. Where the records hold nothing but rounding errors beside
/// the signal, it is given a level of 1e-9 of each sensor's root mean square, so that its deviations are upper bounds.
///
/// Where another order has the larger gap, or a fit is doubtful and a higher order has some gap as well, those orders are fitted, too; the likelihood then decides, for a higher
/// order only if its fit leaves nothing to doubt.
///
/// What makes the result untrustworthy is in its [`doubts`](Reconstruction::doubts), each of which can be printed.
///
/// # Errors
///
/// Those of [`paper::identify`], [`subspace::identify`](crate::subspace::identify) and [`likelihood::identify`](crate::likelihood::identify): records that don't fit together, that are too few or too short for the order, that hold a
/// dead or repeated channel; options that don't fit the records.
///
/// # Example
///
/// Two records of x1 and x2, which decay by 0.9 and 0.5 a step; three sensors read x1 + x2, x1 - x2 and x1 + 3 x2 with noise of 0.01. The first
/// record is excited through b = (1, 1), the second through b = (1, 2).
///
/// ```
#[doc = include_str!("doctest/two_decays.md")]
/// use reconstruct::{Options, reconstruct};
///
/// let records = two_decays(0.9, 500, 0.01)?;
/// let found = reconstruct(&records, &Options::default())?;
/// assert_eq!(found.modes.len(), 2);
/// let slow = found.modes[1].estimate.as_ref().ok_or("no estimate")?.discrete;
/// assert!((slow.value.re - 0.9).abs() < 3.0 * slow.real_standard_error());
/// assert!(slow.real_standard_error() < 1e-3);
/// for doubt in &found.doubts {
///     println!("{}: {doubt}", doubt.code());
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn reconstruct(
    records: &[Record],
    options: &Options,
) -> Result<Reconstruction, ReconstructError> {
    match options.method {
        Method::Paper => by_paper(records, options),
        Method::Subspace => {
            by_subspace(starts::first_stage(records, &options.with_unrecorded_excitation())?)
        }
        Method::OutputError => by_output_error(records, options),
        Method::MaximumLikelihood if options.inputs.names.is_empty() => {
            by_likelihood(records, options)
        }
        Method::MaximumLikelihood => by_excitation(records, options),
    }
}

fn by_paper(records: &[Record], options: &Options) -> Result<Reconstruction, ReconstructError> {
    let solution = paper::identify(records, &options.paper)?;
    let mut modes = Vec::new();
    for mode in &solution.modes {
        let z = solution.shared.zeros[mode.shared].value;
        if z.im >= 0.0 {
            modes.push(FoundMode {
                mode: Mode::from_discrete_eigenvalue(z, solution.period).map_err(failed)?,
                estimate: None,
                interval_95: None,
                excitation_snr: Vec::new(),
            });
        }
    }
    Ok(Reconstruction {
        modes: ordered(modes),
        doubts: solution.doubts.iter().cloned().map(Doubt::Paper).collect(),
        details: Details::Paper(solution),
    })
}

fn by_subspace(stage: FirstStage) -> Result<Reconstruction, ReconstructError> {
    let FirstStage { intersection, order, doubts, .. } = stage;
    let model = &intersection.model;
    let modes = modes(&model.a, model.period)?.into_iter().map(|mode| FoundMode {
        excitation_snr: excitation_snr(&intersection, &mode),
        mode,
        estimate: None,
        interval_95: None,
    });
    Ok(Reconstruction {
        modes: ordered(modes.collect()),
        doubts,
        details: Details::Subspace { intersection, order },
    })
}

/// Output error, unless something else than the recorded inputs excited the system.
fn by_excitation(
    records: &[Record],
    options: &Options,
) -> Result<Reconstruction, ReconstructError> {
    let beside_unrecorded = || by_likelihood(records, &options.with_unrecorded_excitation());
    match options.excitation {
        Excitation::Unrecorded => beside_unrecorded(),
        Excitation::Recorded => by_output_error(records, options),
        Excitation::AsNeeded => {
            let found = by_output_error(records, options)?;
            let says_so = |doubt: &Doubt| matches!(doubt, Doubt::OutputError(doubt) if doubt.is_of_unrecorded_excitation());
            if !found.doubts.iter().any(says_so) {
                return Ok(found);
            }
            // Where that leaves doubts as well, which of both is right is for the user to say.
            Ok(beside_unrecorded().ok().filter(|other| other.doubts.is_empty()).unwrap_or(found))
        }
    }
}

fn by_output_error(
    records: &[Record],
    options: &Options,
) -> Result<Reconstruction, ReconstructError> {
    let fit = output_error::identify(records, &options.inputs, &options.output_error())?;
    let modes = fit.modes.iter().map(|estimate| FoundMode {
        mode: estimate.mode.clone(),
        estimate: Some(estimate.clone()),
        interval_95: None,
        excitation_snr: Vec::new(),
    });
    Ok(Reconstruction {
        modes: ordered(modes.collect()),
        doubts: fit.doubts.iter().cloned().map(Doubt::OutputError).collect(),
        details: Details::OutputError(Box::new(fit)),
    })
}

fn by_likelihood(
    records: &[Record],
    options: &Options,
) -> Result<Reconstruction, ReconstructError> {
    let found = noise_choice::fitted(records, options)?;
    let (Fitted { stage, fit, doubts, compared }, compared_form) =
        lateral::in_form(records, options, found)?;
    let FirstStage { intersection, order, .. } = stage;
    let intervals = if options.profile {
        profile_intervals(records, &fit)?
    } else {
        vec![None; fit.modes.len()]
    };
    let offsets = offset_estimates(records, &fit)?;
    let modes = fit.modes.iter().zip(intervals).map(|(estimate, interval_95)| FoundMode {
        excitation_snr: excitation_snr(&intersection, &estimate.mode),
        mode: estimate.mode.clone(),
        estimate: Some(estimate.clone()),
        interval_95,
    });
    Ok(Reconstruction {
        modes: ordered(modes.collect()),
        doubts,
        details: Details::MaximumLikelihood {
            intersection,
            order,
            fit: Box::new(fit),
            compared_orders: compared,
            compared_form,
            offsets,
        },
    })
}

/// How well the records excite the first stage's mode that is closest.
fn excitation_snr(found: &Intersection, mode: &Mode) -> Vec<f64> {
    let z = mode.discrete_eigenvalue.unwrap_or_default();
    let distance = |mode: &&subspace::Mode| (mode.pole - z).norm();
    let closest = found.modes.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    closest.map_or_else(Vec::new, |mode| mode.excitation_snr.clone())
}

fn modes(a: &DMatrix<f64>, period: SamplePeriod) -> Result<Vec<Mode>, ReconstructError> {
    let n = a.nrows();
    let (none, empty) = (DMatrix::zeros(n, 0), DMatrix::zeros(0, n));
    let system = StateSpace::<Discrete>::new(a.clone(), none, empty, DMatrix::zeros(0, 0), period);
    system.and_then(|system| system.modes()).map_err(failed)
}

fn ordered(mut modes: Vec<FoundMode>) -> Vec<FoundMode> {
    let z = |found: &FoundMode| found.mode.discrete_eigenvalue.unwrap_or_default();
    modes.sort_by(|x, y| z(x).re.total_cmp(&z(y).re).then(z(x).im.total_cmp(&z(y).im)));
    modes
}

fn failed(error: lti::LtiError) -> ReconstructError {
    ReconstructError::Step { step: "modes", message: error.to_string() }
}

#[cfg(test)]
mod tests;
