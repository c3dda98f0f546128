//! What a reconstruction says: modes, doubts, and the details of each method.

use lti::Mode;
use nalgebra::DMatrix;

use super::doubt::Doubt;
use super::options::Method;
use crate::likelihood::{Estimate, Fit, Whiteness};
use crate::subspace::{ExcitationRank, Intersection, NoiseOrigin, OrderEvidence};
use crate::{SharedModel, likelihood, output_error, paper};

/// A mode of the reconstructed system.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FoundMode {
    /// Eigenvalue in z and s, frequency, damping, time constant.
    pub mode: Mode,
    /// The same with standard errors, 95 % intervals and ellipse; from the likelihood alone.
    pub estimate: Option<likelihood::Mode>,
    /// The 95 % interval of a real mode's eigenvalue s in rad/s from the likelihood itself, see [`profile_intervals`](crate::likelihood::profile_intervals); where
    /// [`Options::profile`](crate::Options::profile) asks for it.
    pub interval_95: Option<[f64; 2]>,
    /// For each record the variance along the mode that nothing else explains, in units of the noise's variance: 1 is noise. Empty for the
    /// paper's method.
    pub excitation_snr: Vec<f64>,
}

/// Another order that was fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ComparedOrder {
    /// The number of states.
    pub order: usize,
    /// What its criterion lies above that of the order used: [`Fit::criterion`], or [`Fit::bayesian_criterion`] with a model error. Below zero where more states are
    /// more likely, but leave the modes where they are.
    pub above: f64,
}

/// The form of the equations that was not used: the lateral equations, or a system in which all entries of the matrices are free.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ComparedForm {
    /// The number of its states.
    pub order: usize,
    /// Whether it is the lateral equations.
    pub is_lateral: bool,
    /// What its [`Fit::bayesian_criterion`] lies above that of the form used.
    pub above: f64,
    /// The probability that records which obey the lateral equations gain as much where all entries are free, see [`lateral_test`](crate::likelihood::lateral_test).
    pub p_value: f64,
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
        /// The other form of the equations, where both were fitted.
        compared_form: Option<ComparedForm>,
        /// The constant that each sensor adds to its readings, in its unit, see [`offset_estimates`](likelihood::offset_estimates); empty where offsets are not
        /// free.
        offsets: Vec<Estimate>,
    },
    /// From records whose inputs were all recorded.
    OutputError(Box<output_error::Fit>),
}

impl Reconstruction {
    /// The method that led here.
    #[must_use]
    pub fn method(&self) -> Method {
        match self.details {
            Details::Paper(_) => Method::Paper,
            Details::Subspace { .. } => Method::Subspace,
            Details::MaximumLikelihood { .. } => Method::MaximumLikelihood,
            Details::OutputError(_) => Method::OutputError,
        }
    }

    /// The paper's method in its own terms, where it led here.
    #[must_use]
    pub fn paper(&self) -> Option<&paper::Solution> {
        match &self.details {
            Details::Paper(solution) => Some(solution),
            _ => None,
        }
    }

    /// The intersection of signal subspaces, with the block rows by rule; none from the paper's method.
    #[must_use]
    pub fn intersection(&self) -> Option<&Intersection> {
        match &self.details {
            Details::Paper(_) | Details::OutputError(_) => None,
            Details::Subspace { intersection, .. }
            | Details::MaximumLikelihood { intersection, .. } => Some(intersection),
        }
    }

    /// The likelihood's own result, where it led here.
    #[must_use]
    pub fn fit(&self) -> Option<&Fit> {
        match &self.details {
            Details::MaximumLikelihood { fit, .. } => Some(fit),
            _ => None,
        }
    }

    /// What output error says, where all inputs were recorded.
    #[must_use]
    pub fn output_error(&self) -> Option<&output_error::Fit> {
        match &self.details {
            Details::OutputError(fit) => Some(fit),
            _ => None,
        }
    }

    /// The number of states, with the evidence for it; none from the paper's method.
    #[must_use]
    pub fn order(&self) -> Option<&OrderEvidence> {
        match &self.details {
            Details::Paper(_) | Details::OutputError(_) => None,
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
            _ => &[],
        }
    }

    /// The form of the equations that was not used, where both were fitted; from the likelihood alone.
    #[must_use]
    pub fn compared_form(&self) -> Option<ComparedForm> {
        match self.details {
            Details::MaximumLikelihood { compared_form, .. } => compared_form,
            _ => None,
        }
    }

    /// The constant that each sensor adds to its readings, in its unit; empty where the likelihood did not estimate any.
    #[must_use]
    pub fn offsets(&self) -> &[Estimate] {
        match &self.details {
            Details::MaximumLikelihood { offsets, .. } => offsets,
            _ => &[],
        }
    }

    /// C of the system, sensors x states, in the basis of the modes' eigenvectors; none from the paper's method.
    #[must_use]
    pub fn readings(&self) -> Option<&DMatrix<f64>> {
        let shared = self.model().map(|model| &model.c);
        shared.or_else(|| self.output_error().map(|fit| fit.model.c()))
    }

    /// A, C and b_j; none from the paper's method, or where all inputs were recorded.
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
        let levels = noise.deviations.iter().map(|&value| Estimate { value, standard_error: 0.0 });
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
