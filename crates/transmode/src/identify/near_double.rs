//! What is said of two eigenvalues that the records hardly tell apart.

use num_complex::Complex;
use reconstruct::likelihood::{ComplexEstimate, NearDouble};
use report::format_significant;

use super::outcome::Outcome;
use crate::modes::IdentifiedMode;

/// A sentence for each pair of modes, and for each mode that may be a double one.
pub(super) fn sentences(outcome: &Outcome<'_>) -> Vec<String> {
    let mut found = Vec::new();
    for (index, mode) in outcome.found.iter().enumerate() {
        let Some(double) = near_double(mode) else { continue };
        let partner = outcome.found.iter().position(|other| is_at(other, double.partner));
        // Said of the first of the two, if both say it of each other.
        let is_said = partner.is_some_and(|other| {
            other < index
                && near_double(&outcome.found[other]).is_some_and(|of| is_at(mode, of.partner))
        });
        if !is_said {
            found.push(sentence(mode, partner.map(|other| &outcome.found[other]), &double));
        }
    }
    found
}

fn near_double(mode: &IdentifiedMode) -> Option<NearDouble> {
    mode.mode.estimate.as_ref()?.near_double
}

fn is_at(mode: &IdentifiedMode, eigenvalue: Complex<f64>) -> bool {
    (mode.mode.mode.eigenvalue - eigenvalue).norm() <= 1e-9 * eigenvalue.norm()
}

fn sentence(
    mode: &IdentifiedMode,
    partner: Option<&IdentifiedMode>,
    double: &NearDouble,
) -> String {
    let name = mode.named.name.to_string();
    let who = match partner {
        Some(other) => {
            format!("{name} and {} are hardly told apart by the records", other.named.name)
        }
        None => format!("{name} may as well be two real modes"),
    };
    let note = match double.half_difference_squared.covariance[(1, 1)] > 0.0 {
        true => "",
        false => " (above zero both are real, below they are a conjugate pair)",
    };
    format!(
        "{who}: their mean is {} 1/s, the square of half their difference {} 1/s^2{note}; what is said of each alone allows for all that this leaves open",
        shown(&double.mean),
        shown(&double.half_difference_squared)
    )
}

/// A number with its standard error, or two where it is complex.
fn shown(estimate: &ComplexEstimate) -> String {
    let part = |value: f64, error: f64| {
        format!("{} +- {}", format_significant(value, 4), format_significant(error, 2))
    };
    let real = part(estimate.value.re, estimate.real_standard_error());
    let error = estimate.imaginary_standard_error();
    if error > 0.0 { format!("{real} and j({})", part(estimate.value.im, error)) } else { real }
}
