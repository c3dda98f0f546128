//! The roots of a polynomial as a multiset, each with its condition number, residual and error estimate.

mod common_factor;
mod conjugate;
mod multiset;
mod options;
mod pejorative;
mod simple;
mod structure;
#[cfg(test)]
mod tests;

#[cfg(feature = "faer")]
pub(crate) use conjugate::symmetrize;
pub use multiset::{Mroots, MrootsMethod, Root};
pub use options::{MrootsOptions, Multiplicities};

use crate::aberth::ScaledPoly;
use crate::{Poly, PolyError, Ring};
use num_complex::Complex;
use pejorative::{Multiple, Target};

/// The roots of `p` with multiplicities.
///
/// Coefficients are real or complex. Real coefficients give exactly real roots and exactly conjugate pairs.
/// A constant has no roots.
///
/// Simple roots come as the float nearest to the exact root of the coefficients as given, or a neighbour of it, as long as
/// the condition number stays below about 1e16: zeros at 0 are taken off exactly, Ehrlich-Aberth iteration starts from the
/// Newton polygon under scaling by powers of two, and refinement is in doubled precision. How far the root moves with the
/// uncertainty of the coefficients is another matter: multiply that by [`Root::condition`].
///
/// Multiple roots, unless [`Multiplicities::AllSimple`] is asked for: a structure of multiplicities is taken when some
/// polynomial that has it agrees with the coefficients within [`MrootsOptions::coefficient_error`], and when either its
/// clusters stand well apart or it has at most half as many distinct roots as the degree. The fewest distinct roots win.
/// So two roots merge that are closer than the coefficients resolve: about `sqrt(coefficient_error)` for a pair far from
/// others. Nothing is merged if the coefficients spread over more than 255 decades after scaling the variable.
///
/// Meant for degrees up to a few hundred. The result is the same on every run.
///
/// Sources: Bini 1996 (Numer. Algorithms 13), Zeng 2005 (Math. Comp. 74).
///
/// # Errors
/// [`PolyError::ZeroPolynomial`], [`PolyError::NonFiniteCoefficient`], [`PolyError::InvalidTolerance`], and
/// [`PolyError::RootOutOfRange`] if a root's modulus is beyond 2^1020 or below 2^-1020.
///
/// # Example
/// ```
/// use poly::{Complex, MrootsOptions, Poly, mroots};
///
/// // x^5 - 2 x^4 + 5 x^3 = x^3 (x - 1 - 2j) (x - 1 + 2j)
/// let p = Poly::from_descending(&[1.0, -2.0, 5.0, 0.0, 0.0, 0.0]);
/// let roots = mroots(&p, &MrootsOptions::default())?;
/// assert_eq!(roots.roots.len(), 3);
/// assert_eq!(roots.roots[0].value, Complex::new(0.0, 0.0));
/// assert_eq!(roots.roots[0].multiplicity, 3);
/// assert_eq!(roots.roots[1].value, Complex::new(1.0, 2.0));
/// assert_eq!(roots.roots[2].value, Complex::new(1.0, -2.0));
/// # Ok::<(), poly::PolyError>(())
/// ```
pub fn mroots<T>(p: &Poly<T>, options: &MrootsOptions) -> Result<Mroots, PolyError>
where
    T: Ring + Into<Complex<f64>>,
{
    check_tolerance("coefficient_error", options.coefficient_error)?;
    check_tolerance("vanishing_leading", options.vanishing_leading)?;
    let given: Poly<Complex<f64>> = p.map(|c| c.clone().into());
    for (degree, &value) in given.coefficients().iter().enumerate() {
        if !(value.re.is_finite() && value.im.is_finite()) {
            return Err(PolyError::NonFiniteCoefficient { degree, value });
        }
    }
    let trimmed = if options.vanishing_leading > 0.0 {
        given.trimmed(options.vanishing_leading)
    } else {
        given.clone()
    };
    let vanished_leading = given.coefficients().len() - trimmed.coefficients().len();
    let coefficients = trimmed.into_coefficients();
    let at_zero = coefficients
        .iter()
        .position(|&c| c != Complex::new(0.0, 0.0))
        .ok_or(PolyError::ZeroPolynomial)?;
    let coefficients = coefficients[at_zero..].to_vec();
    let real = coefficients.iter().all(|c| c.im == 0.0);

    let mut scaled = ScaledPoly::new(coefficients);
    let mut found = simple::simple_roots(&mut scaled, real, options.maximum_iterations)?;
    refine_multiple(&mut scaled, real, options, &mut found);
    if at_zero > 0 {
        found.roots.push(Root {
            value: Complex::new(0.0, 0.0),
            multiplicity: at_zero,
            residual: 0.0,
            condition: 0.0,
            error_estimate: 0.0,
        });
    }
    found.roots.sort_by(|a, b| order(a.value, b.value));
    Ok(Mroots { vanished_leading, ..found })
}

/// Replaces simple roots by multiple ones where the coefficients allow it; fills in the backward error.
fn refine_multiple(p: &mut ScaledPoly, real: bool, options: &MrootsOptions, found: &mut Mroots) {
    let Some(target) = Target::new(p, real) else {
        found.backward_error = found.roots.iter().map(|root| root.residual).fold(0.0, f64::max);
        return;
    };
    let fit = match options.multiplicities {
        Multiplicities::Detect => structure::multiple_structure(p, &target, &found.roots, options),
        Multiplicities::AllSimple => None,
    };
    if let Some(fit) = fit {
        found.method = MrootsMethod::Pejorative;
        found.converged = true;
        found.iterations += fit.steps;
        found.roots = fit
            .roots
            .iter()
            .zip(&fit.conditions)
            .map(|(root, &condition)| {
                let simple = simple::describe(p, root.value);
                let modulus = root.value.norm();
                Root {
                    value: root.value,
                    multiplicity: root.multiplicity,
                    residual: simple.residual,
                    condition,
                    error_estimate: modulus * (condition * fit.largest_error + f64::EPSILON),
                }
            })
            .collect();
    }
    let roots: Vec<Multiple> = found
        .roots
        .iter()
        .map(|root| Multiple { value: root.value, multiplicity: root.multiplicity })
        .collect();
    found.backward_error = target.backward_error(&roots);
}

pub(crate) fn check_tolerance(name: &'static str, value: f64) -> Result<(), PolyError> {
    if value.is_finite() && value >= 0.0 {
        Ok(())
    } else {
        Err(PolyError::InvalidTolerance { name, value })
    }
}

/// By real part, then modulus of the imaginary part, then positive imaginary part first.
pub(crate) fn order(a: Complex<f64>, b: Complex<f64>) -> std::cmp::Ordering {
    a.re.total_cmp(&b.re).then(a.im.abs().total_cmp(&b.im.abs())).then(b.im.total_cmp(&a.im))
}
