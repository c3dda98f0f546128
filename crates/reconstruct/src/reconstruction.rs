//! From records to modes with confidence: the one entry point to all methods.

mod doubt;
mod options;
mod orders;
mod spectra;
mod starts;

use lti::{Discrete, Mode, SamplePeriod, StateSpace};
use nalgebra::DMatrix;

pub use doubt::ReconstructionDoubt;
pub use options::{Method, Options};
pub use orders::ComparedOrder;
use orders::Fitted;
pub use spectra::spectral_fits;
use starts::FirstStage;

use crate::{
    AsPrinted, ChiSquared, Estimate, ExcitationRank, Intersection, LikelihoodFit, ModeEstimate,
    NoiseOrigin, OrderEvidence, ReconstructError, Record, SharedModel, SubspaceMode, Whiteness,
    as_printed, profile_intervals,
};

/// A mode of the reconstructed system.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FoundMode {
    /// Eigenvalue in z and s, frequency, damping, time constant.
    pub mode: Mode,
    /// The same with deviations, 95 % intervals and ellipse; from the likelihood alone.
    pub estimate: Option<ModeEstimate>,
    /// The 95 % interval of a real mode's eigenvalue s in rad/s from the likelihood itself, see [`profile_intervals`](crate::profile_intervals); where
    /// [`Options::profile`] asks for it.
    pub interval_95: Option<[f64; 2]>,
    /// For each record the variance along the mode that nothing else explains, in units of the noise's variance: 1 is noise. Empty for the
    /// printed method.
    pub strength: Vec<f64>,
}

/// What several records say about the system they come from.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Reconstruction {
    /// The method that led here.
    pub method: Method,
    /// The modes by real part of z, a complex pair once.
    pub modes: Vec<FoundMode>,
    /// A, C and b_j; none from the printed method.
    pub model: Option<SharedModel>,
    /// The number of states, with the evidence for it; none from the printed method.
    pub order: Option<OrderEvidence>,
    /// Orders that the gaps left open, and that were compared by their likelihoods; from the likelihood alone.
    pub compared_orders: Vec<ComparedOrder>,
    /// Standard deviation of each sensor's noise in its unit. Without a deviation of their own (0) where they were given or come from the subspaces;
    /// none from the printed method or where the noise has a spectrum.
    pub noise_levels: Option<Vec<Estimate>>,
    /// The size of the residuals, with its probability where the noise was known; from the likelihood alone.
    pub goodness: Option<ChiSquared>,
    /// Whether the residuals of each record are white; from the likelihood alone.
    pub whiteness: Vec<Whiteness>,
    /// How many independent excitations each record shows; empty for the printed method.
    pub excitations: Vec<ExcitationRank>,
    /// Why the result should not be trusted; empty if there is no such reason.
    pub doubts: Vec<ReconstructionDoubt>,
    /// The printed method's own result.
    pub printed: Option<AsPrinted>,
    /// The first stage's own result, of the block rows by rule.
    pub intersection: Option<Intersection>,
    /// The second stage's own result: covariances, starts, how the search went.
    pub likelihood: Option<LikelihoodFit>,
}

/// Reconstructs the modes of a system from records of its sensors, each under an excitation that nobody measured.
///
/// | method | needs | gives |
/// |---|---|---|
/// | [`Method::MaximumLikelihood`] | two records of three sensors or three of two | modes with deviations and intervals, tests of fit |
/// | [`Method::Subspace`] | the same | modes, order, ranks of the excitations; closed form |
/// | [`Method::AsPrinted`] | two records of three sensors, no noise | modes |
///
/// Signal subspaces are intersected with half, once and one and a half times the block rows of their rule: together they give the order, and for
/// the likelihood the first guess of the noise levels and the starts, of which the best top counts. Where the records hold nothing but rounding errors beside
/// the signal, it is given a level of 1e-9 of each sensor's root mean square, so that its deviations are upper bounds.
///
/// Where another order has the larger gap, or a fit is doubtful and a higher order has some gap as well, those orders are fitted, too; the likelihood then decides, for a higher
/// order only if its fit leaves nothing to doubt.
///
/// What makes the result untrustworthy is in its [`doubts`](Reconstruction::doubts), each of which can be printed.
///
/// # Errors
///
/// Those of [`as_printed`], [`intersect`](crate::intersect) and [`maximise`](crate::maximise): records that don't fit together, that are too few or too short for the order, that hold a
/// dead or repeated channel; options that don't fit the records.
///
/// # Example
///
/// x1 and x2 decay by 0.9 and 0.5 a step; three sensors read x1 + x2, x1 - x2 and x1 + 3 x2 with noise of 0.01. The first record is excited through
/// b = (1, 1), the second through b = (1, 2).
///
/// ```
/// use lti::SamplePeriod;
/// use reconstruct::{Channel, Options, Record, reconstruct};
///
/// let mut state = 1_u32;
/// let mut uniform = || {
///     state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
///     f64::from(state) / 2_147_483_648.0 - 1.0
/// };
/// let mut record = |name: &str, b: [f64; 2]| {
///     let mut x = [0.0, 0.0];
///     let mut outputs = vec![Vec::new(); 3];
///     for _ in 0..500 {
///         let [x1, x2] = x;
///         for (output, value) in outputs.iter_mut().zip([x1 + x2, x1 - x2, x1 + 3.0 * x2]) {
///             output.push(value + 0.01 * 3.0_f64.sqrt() * uniform());
///         }
///         let u = uniform();
///         x = [0.9 * x1 + b[0] * u, 0.5 * x2 + b[1] * u];
///     }
///     let channels = outputs.into_iter().zip(["y1", "y2", "y3"]).map(|(values, name)| Channel::new(name, values));
///     Record::new(name, SamplePeriod::new(1.0)?, channels.collect()).map_err(Box::<dyn std::error::Error>::from)
/// };
/// let records = [record("first", [1.0, 1.0])?, record("second", [1.0, 2.0])?];
/// let found = reconstruct(&records, &Options::default())?;
/// assert_eq!(found.modes.len(), 2);
/// let slow = found.modes[1].estimate.as_ref().unwrap().discrete;
/// assert!((slow.value.re - 0.9).abs() < 3.0 * slow.real_deviation());
/// assert!(slow.real_deviation() < 1e-3);
/// for doubt in &found.doubts {
///     println!("{doubt}");
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn reconstruct(
    records: &[Record],
    options: &Options,
) -> Result<Reconstruction, ReconstructError> {
    match options.method {
        Method::AsPrinted => printed(records, options),
        Method::Subspace => subspace(starts::first_stage(records, options)?),
        Method::MaximumLikelihood => likelihood(records, options),
    }
}

fn printed(records: &[Record], options: &Options) -> Result<Reconstruction, ReconstructError> {
    let found = as_printed(records, &options.printed)?;
    let mut modes = Vec::new();
    for mode in &found.modes {
        let z = found.shared.zeros[mode.shared].value;
        if z.im >= 0.0 {
            modes.push(FoundMode {
                mode: Mode::from_discrete_eigenvalue(z, found.period).map_err(failed)?,
                estimate: None,
                interval_95: None,
                strength: Vec::new(),
            });
        }
    }
    Ok(Reconstruction {
        method: Method::AsPrinted,
        modes: ordered(modes),
        model: None,
        order: None,
        compared_orders: Vec::new(),
        noise_levels: None,
        goodness: None,
        whiteness: Vec::new(),
        excitations: Vec::new(),
        doubts: found.doubts.iter().cloned().map(ReconstructionDoubt::Printed).collect(),
        printed: Some(found),
        intersection: None,
        likelihood: None,
    })
}

fn subspace(stage: FirstStage) -> Result<Reconstruction, ReconstructError> {
    let FirstStage { intersection: found, order, doubts, .. } = stage;
    let modes = modes(&found.model.a, found.model.period)?.into_iter().map(|mode| FoundMode {
        strength: strength(&found, &mode),
        mode,
        estimate: None,
        interval_95: None,
    });
    let levels = found.noise.deviations.iter().map(|&value| Estimate { value, deviation: 0.0 });
    let white = !matches!(found.noise.origin, NoiseOrigin::Quiet { .. });
    Ok(Reconstruction {
        method: Method::Subspace,
        modes: ordered(modes.collect()),
        model: Some(found.model.clone()),
        order: Some(order),
        compared_orders: Vec::new(),
        noise_levels: white.then(|| levels.collect()),
        goodness: None,
        whiteness: Vec::new(),
        excitations: found.records.iter().map(|record| record.excitation.clone()).collect(),
        doubts,
        printed: None,
        likelihood: None,
        intersection: Some(found),
    })
}

fn likelihood(records: &[Record], options: &Options) -> Result<Reconstruction, ReconstructError> {
    let (Fitted { stage, fit, doubts, compared }, second) = orders::fitted(records, options)?;
    let FirstStage { intersection: first, order, .. } = stage;
    let intervals = if options.profile {
        profile_intervals(records, &fit, &second)?
    } else {
        vec![None; fit.modes.len()]
    };
    let modes = fit.modes.iter().zip(intervals).map(|(estimate, interval_95)| FoundMode {
        strength: strength(&first, &estimate.mode),
        mode: estimate.mode.clone(),
        estimate: Some(estimate.clone()),
        interval_95,
    });
    Ok(Reconstruction {
        method: Method::MaximumLikelihood,
        modes: ordered(modes.collect()),
        model: Some(fit.model.clone()),
        order: Some(order),
        compared_orders: compared,
        noise_levels: fit.noise_levels.clone(),
        goodness: Some(fit.chi_squared),
        whiteness: fit.whiteness.clone(),
        excitations: first.records.iter().map(|record| record.excitation.clone()).collect(),
        doubts,
        printed: None,
        intersection: Some(first),
        likelihood: Some(fit),
    })
}

/// The strength of the first stage's mode that is closest.
fn strength(found: &Intersection, mode: &Mode) -> Vec<f64> {
    let z = mode.discrete_eigenvalue.unwrap_or_default();
    let distance = |mode: &&SubspaceMode| (mode.pole - z).norm();
    let closest = found.modes.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    closest.map_or_else(Vec::new, |mode| mode.strength.clone())
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
