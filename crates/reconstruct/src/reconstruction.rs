//! From records to modes with confidence: the one entry point to all methods.

mod doubt;
mod options;
mod orders;
mod spectra;
mod starts;

use lti::{Discrete, Mode, SamplePeriod, StateSpace};
use nalgebra::DMatrix;

pub use doubt::Doubt;
pub use options::{Method, Options};
pub use orders::ComparedOrder;
use orders::Fitted;
pub use spectra::spectral_fits;
use starts::FirstStage;

use crate::likelihood::{Estimate, Fit, Whiteness, profile_intervals};
use crate::subspace::{ExcitationRank, Intersection, NoiseOrigin, OrderEvidence};
use crate::{ReconstructError, Record, SharedModel, likelihood, paper, subspace};

/// A mode of the reconstructed system.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FoundMode {
    /// Eigenvalue in z and s, frequency, damping, time constant.
    pub mode: Mode,
    /// The same with standard errors, 95 % intervals and ellipse; from the likelihood alone.
    pub estimate: Option<likelihood::Mode>,
    /// The 95 % interval of a real mode's eigenvalue s in rad/s from the likelihood itself, see [`profile_intervals`]; where
    /// [`Options::profile`] asks for it.
    pub interval_95: Option<[f64; 2]>,
    /// For each record the variance along the mode that nothing else explains, in units of the noise's variance: 1 is noise. Empty for the
    /// paper's method.
    pub excitation_snr: Vec<f64>,
}

/// What several records say about the system they come from.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Reconstruction {
    /// The modes by real part of z, a complex pair once.
    pub modes: Vec<FoundMode>,
    /// Why the result should not be trusted; empty if there is no such reason.
    pub doubts: Vec<Doubt>,
    /// What the method has to say beyond that.
    pub details: Details,
}

/// The result of each method in its own terms.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Details {
    /// From [`Method::Paper`].
    Paper(paper::Solution),
    /// From [`Method::Subspace`].
    Subspace {
        /// The intersection with the block rows by rule.
        intersection: Intersection,
        /// The number of states, with the evidence for it over all numbers of block rows.
        order: OrderEvidence,
    },
    /// From [`Method::MaximumLikelihood`].
    MaximumLikelihood {
        /// The first stage, with the block rows by rule.
        intersection: Intersection,
        /// The number of states, with the evidence for it over all numbers of block rows.
        order: OrderEvidence,
        /// The second stage: system, covariances, starts, how the search went.
        fit: Box<Fit>,
        /// Orders that the gaps left open, and that were compared by their likelihoods.
        compared_orders: Vec<ComparedOrder>,
    },
}

impl Reconstruction {
    /// The method that led here.
    #[must_use]
    pub fn method(&self) -> Method {
        match self.details {
            Details::Paper(_) => Method::Paper,
            Details::Subspace { .. } => Method::Subspace,
            Details::MaximumLikelihood { .. } => Method::MaximumLikelihood,
        }
    }

    /// The paper's method in its own terms, where it led here.
    #[must_use]
    pub fn paper(&self) -> Option<&paper::Solution> {
        match &self.details {
            Details::Paper(solution) => Some(solution),
            Details::Subspace { .. } | Details::MaximumLikelihood { .. } => None,
        }
    }

    /// The intersection of signal subspaces, with the block rows by rule; none from the paper's method.
    #[must_use]
    pub fn intersection(&self) -> Option<&Intersection> {
        match &self.details {
            Details::Paper(_) => None,
            Details::Subspace { intersection, .. }
            | Details::MaximumLikelihood { intersection, .. } => Some(intersection),
        }
    }

    /// The likelihood's own result, where it led here.
    #[must_use]
    pub fn fit(&self) -> Option<&Fit> {
        match &self.details {
            Details::MaximumLikelihood { fit, .. } => Some(fit),
            Details::Paper(_) | Details::Subspace { .. } => None,
        }
    }

    /// The number of states, with the evidence for it; none from the paper's method.
    #[must_use]
    pub fn order(&self) -> Option<&OrderEvidence> {
        match &self.details {
            Details::Paper(_) => None,
            Details::Subspace { order, .. } | Details::MaximumLikelihood { order, .. } => {
                Some(order)
            }
        }
    }

    /// Orders that the gaps left open, and that were compared by their likelihoods; from the likelihood alone.
    #[must_use]
    pub fn compared_orders(&self) -> &[ComparedOrder] {
        match &self.details {
            Details::MaximumLikelihood { compared_orders, .. } => compared_orders,
            Details::Paper(_) | Details::Subspace { .. } => &[],
        }
    }

    /// A, C and b_j; none from the paper's method.
    #[must_use]
    pub fn model(&self) -> Option<&SharedModel> {
        self.fit()
            .map(|fit| &fit.model)
            .or_else(|| self.intersection().map(|intersection| &intersection.model))
    }

    /// Standard deviation of each sensor's noise in its unit. Without a standard error of their own (0) where they were given or come from
    /// the subspaces; none from the paper's method or where the noise has a spectrum.
    #[must_use]
    pub fn noise_levels(&self) -> Option<Vec<Estimate>> {
        if let Some(fit) = self.fit() {
            return fit.noise_levels.clone();
        }
        let noise = &self.intersection()?.noise;
        let white = !matches!(noise.origin, NoiseOrigin::Quiet { .. });
        let levels = noise.deviations.iter().map(|&value| Estimate { value, deviation: 0.0 });
        white.then(|| levels.collect())
    }

    /// Whether the residuals of each record are white; from the likelihood alone.
    #[must_use]
    pub fn whiteness(&self) -> &[Whiteness] {
        self.fit().map_or(&[], |fit| &fit.whiteness)
    }

    /// How many independent excitations each record shows; empty for the paper's method.
    #[must_use]
    pub fn excitations(&self) -> Vec<&ExcitationRank> {
        self.intersection()
            .into_iter()
            .flat_map(|intersection| &intersection.records)
            .map(|record| &record.excitation)
            .collect()
    }
}

/// Reconstructs the modes of a system from records of its sensors, each under an excitation that nobody measured.
///
/// | method | needs | gives |
/// |---|---|---|
/// | [`Method::MaximumLikelihood`] | two records of three sensors or three of two | modes with deviations and intervals, tests of fit |
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
/// assert!((slow.value.re - 0.9).abs() < 3.0 * slow.real_deviation());
/// assert!(slow.real_deviation() < 1e-3);
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
        Method::Subspace => by_subspace(starts::first_stage(records, options)?),
        Method::MaximumLikelihood => by_likelihood(records, options),
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

fn by_likelihood(
    records: &[Record],
    options: &Options,
) -> Result<Reconstruction, ReconstructError> {
    let (Fitted { stage, fit, doubts, compared }, second) = orders::fitted(records, options)?;
    let FirstStage { intersection, order, .. } = stage;
    let intervals = if options.profile {
        profile_intervals(records, &fit, &second)?
    } else {
        vec![None; fit.modes.len()]
    };
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
