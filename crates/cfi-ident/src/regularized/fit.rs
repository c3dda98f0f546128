//! The penalised fit.

use super::{
    Lambda, Regularization, RegularizedFit, Settings, hold_out::choose, penalised::Penalised,
};
use crate::{FitError, Segment, Structure};

/// Fits a model with a penalty on its Markov parameters; the [module](super) states the objective.
///
/// Unlike the plain fit it may have fewer equations than parameters, as long as there is at least one more than D(q) has unknown
/// coefficients.
///
/// # Errors
///
/// As the plain fit, and [`FitError::Unsolved`] if the solver did not reach its reduced tolerance, [`FitError::BadValue`] for a lambda, a
/// hold-out fraction or a setting out of range.
///
/// # Example
///
/// A gain of 2, seen through an alternating input of root mean square 1, so that s_i = 1 and s_o = 2. Then g = h/2 minimises
/// (1 - g)^2 / 2 + lambda g^2 / 2, which is g = 1 / (1 + lambda):
///
/// ```
/// use cfi_ident::{ConstantTerm, Orders, Segment, Structure, regularized};
/// use regularized::{Lambda, Regularization, Settings};
///
/// let input = [1.0, -1.0, 1.0, -1.0];
/// let output = [2.0, -2.0, 2.0, -2.0];
/// let structure = Structure::new(Orders::new(0, 0, 0)?, ConstantTerm::Omitted);
/// let segments = [Segment::new(&input, &output)?];
/// let (ridge, lambda) = (Regularization::Ridge, Lambda::Given(0.25));
/// let fit = regularized::fit(&segments, &structure, &ridge, &lambda, &Settings::default())?;
/// assert!((fit.model.markov_parameter(0) - 1.6).abs() < 1e-6);
/// # Ok::<(), cfi_ident::FitError>(())
/// ```
pub fn fit(
    segments: &[Segment<'_>],
    structure: &Structure,
    regularization: &Regularization,
    lambda: &Lambda,
    settings: &Settings,
) -> Result<RegularizedFit, FitError> {
    settings.check()?;
    lambda.check()?;
    let orders = structure.orders;
    regularization.check(orders.causal().max(orders.anticausal()))?;
    let (lambda, hold_out) = match lambda {
        Lambda::Given(lambda) => (*lambda, Vec::new()),
        Lambda::HoldOut { candidates, fraction } => {
            choose(segments, structure, *regularization, candidates, *fraction, settings)?
        }
    };
    let mut fit = Penalised::new(segments, structure)?.solve(*regularization, lambda, settings)?;
    fit.hold_out = hold_out;
    Ok(fit)
}
