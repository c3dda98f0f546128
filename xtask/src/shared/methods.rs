//! The methods, applied to a pair of records, and how they look in all figures.

use lti::{Transmissibility, z_to_s};
use poly::Poly;
use reconstruct::paper::{Identification, difference_zeros};
use reconstruct::subspace::OrderChoice;
use reconstruct::{Method, NoiseModel, Options, Reconstruction, Record, likelihood, reconstruct};
use report::{Dash, Ink, Marker};

use super::matching::{named, nearest};
use super::modes::{PerMode, TrueModes};

/// A name and its look in all figures.
pub(crate) type Look = (&'static str, Ink, Dash, Marker);

/// The paper's method, the intersection of signal subspaces, maximum likelihood.
pub(crate) const METHODS: [Look; 3] = [
    ("as printed", Ink::Vermillion, Dash::Dotted, Marker::Cross),
    ("subspace", Ink::Sky, Dash::Dashed, Marker::Triangle),
    ("maximum likelihood", Ink::Blue, Dash::Solid, Marker::Circle),
];

/// What figures and tables call the signal to noise ratio.
pub(crate) const RATIO_AXIS: &str = "signal to noise ratio";

/// The aircraft has four states. They are given, so that errors of all runs can be compared.
pub(crate) const ORDER: OrderChoice = OrderChoice::Fixed(4);

/// What a method makes of records; `None` where it gives nothing.
pub(crate) fn apply(
    records: &[Record],
    method: Method,
    noise: NoiseModel,
    order: OrderChoice,
) -> Option<Reconstruction> {
    let mut options = Options::default();
    options.method = method;
    options.noise = noise;
    options.order = order;
    reconstruct(records, &options).ok()
}

/// Errors of the paper's method: for each mode the closest of all zeros of all differences, of the
/// composite models as they are fitted and of what their realization keeps above the noise of the
/// fit. With noise the differences share no zero; this gives the method what it cannot know, which
/// of the zeros is the right one.
pub(crate) fn paper_errors(records: &[Record], truth: &TrueModes) -> Option<PerMode> {
    let found = apply(records, Method::Paper, NoiseModel::Estimated, ORDER)?;
    let solution = found.paper()?;
    let realised = solution.differences.iter().flat_map(|difference| difference.zeros.clone());
    let (first, second) = solution.identifications.split_at(solution.identifications.len() / 2);
    let fitted = first.iter().zip(second).filter_map(|(first, second)| {
        difference_zeros(&unrealised(first)?, &unrealised(second)?).ok()
    });
    let found: Vec<_> = realised
        .chain(fitted.flatten())
        .filter_map(|zero| z_to_s(zero.value, solution.period).ok())
        .collect();
    nearest(&found, truth)
}

/// The transmissibility as the composite model has it, without a realization of its FIR factor: sum
/// of H_i z^(d + r - i) over D, where the power of z that all records share is left out.
fn unrealised(found: &Identification) -> Option<Identification> {
    let numerator = Poly::from_descending(&found.fit.model.markov_parameters());
    let denominator = Poly::new(found.fit.model.denominator());
    let mut unrealised = found.clone();
    unrealised.transmissibility =
        Transmissibility::from_polynomials(numerator, denominator).ok()?;
    Some(unrealised)
}

/// The modes of maximum likelihood with four states: spiral, roll, Dutch roll.
pub(crate) fn most_likely(
    records: &[Record],
    truth: &TrueModes,
) -> Option<(likelihood::Fit, [likelihood::Mode; 3])> {
    let found = apply(records, Method::MaximumLikelihood, NoiseModel::Estimated, ORDER)?;
    let fit = found.fit()?.clone();
    let modes = named(&fit, truth)?;
    Some((fit, modes))
}
