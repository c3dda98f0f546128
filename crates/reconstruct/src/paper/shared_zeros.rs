//! Zeros that several differences of transmissibilities have in common: the candidates for eigenvalues.

use num_complex::Complex;

use super::difference::Zero;
use crate::ReconstructError;
use crate::error::check_tolerance;
use crate::model::matching::closest_pairs;

/// A zero that every difference has, up to the tolerance.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SharedZero {
    /// The mean of the members, each weighted by the inverse square of its condition number: an ill-conditioned copy does not spoil
    /// a good one.
    pub value: Complex<f64>,
    /// One zero of each difference, in the order of the differences.
    pub members: Vec<Zero>,
    /// The largest distance of two members.
    pub spread: f64,
}

/// What several lists of zeros have in common.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SharedZeros {
    /// The shared zeros, by decreasing real part, each conjugate after its partner with the positive imaginary part.
    pub zeros: Vec<SharedZero>,
    /// The tolerance that was used.
    pub tolerance: f64,
    /// The smallest spread of a group that was refused, as a hint at how far the tolerance is from changing the answer; `None` if
    /// none was refused.
    pub closest_refused: Option<f64>,
}

impl SharedZeros {
    /// The values alone.
    #[must_use]
    pub fn values(&self) -> Vec<Complex<f64>> {
        self.zeros.iter().map(|zero| zero.value).collect()
    }

    /// The largest spread of a shared zero; 0 if there is none.
    #[must_use]
    pub fn largest_spread(&self) -> f64 {
        self.zeros.iter().fold(0.0, |worst, zero| worst.max(zero.spread))
    }
}

/// Finds the zeros that all lists share.
///
/// Each zero of the first list is grouped with its closest partner in each other list, every zero serving once and closest pairs first. A
/// group is shared where its members lie within `tolerance` of each other. Lists must be closed under conjugation: only the upper
/// half plane is searched, and the lower one is its mirror image, so that conjugates come out as exact conjugates.
///
/// # Errors
///
/// [`ReconstructError::InvalidTolerance`]; [`ReconstructError::ZeroNotFinite`].
pub fn shared_zeros(
    differences: &[Vec<Zero>],
    tolerance: f64,
) -> Result<SharedZeros, ReconstructError> {
    check_tolerance("the tolerance of shared zeros", tolerance)?;
    for (difference, list) in differences.iter().enumerate() {
        if let Some(index) = list.iter().position(|zero| !zero.value.is_finite()) {
            return Err(ReconstructError::ZeroNotFinite { difference, index });
        }
    }
    let upper: Vec<Vec<Zero>> = differences.iter().map(|list| upper_half(list)).collect();
    let Some((first, others)) = upper.split_first() else {
        return Ok(SharedZeros { zeros: Vec::new(), tolerance, closest_refused: None });
    };
    let mut groups: Vec<Vec<Zero>> = first.iter().map(|zero| vec![*zero]).collect();
    for list in others {
        extend_groups(&mut groups, list);
    }
    let (shared, refused): (Vec<_>, Vec<_>) = groups
        .into_iter()
        .filter(|members| members.len() == upper.len())
        .map(|members| SharedZero {
            value: weighted_mean(&members),
            spread: spread(&members),
            members,
        })
        .partition(|zero| zero.spread <= tolerance);
    let closest_refused = refused.iter().map(|zero| zero.spread).min_by(f64::total_cmp);
    Ok(SharedZeros { zeros: with_conjugates(shared), tolerance, closest_refused })
}

/// Real zeros and those with a positive imaginary part.
fn upper_half(list: &[Zero]) -> Vec<Zero> {
    list.iter().filter(|zero| zero.value.im >= 0.0).copied().collect()
}

/// Adds to each group the zero of the list that is closest to the group's mean. A group that finds none stays shorter and is lost.
fn extend_groups(groups: &mut [Vec<Zero>], list: &[Zero]) {
    let length = groups.iter().map(Vec::len).max().unwrap_or(0);
    let whole: Vec<usize> =
        (0..groups.len()).filter(|&index| groups[index].len() == length).collect();
    let means: Vec<_> = whole.iter().map(|&index| weighted_mean(&groups[index])).collect();
    let values: Vec<_> = list.iter().map(|zero| zero.value).collect();
    for pair in closest_pairs(&means, &values) {
        groups[whole[pair.left]].push(list[pair.right]);
    }
}

fn weighted_mean(members: &[Zero]) -> Complex<f64> {
    // Conditions are scaled by the smallest, so that their squares neither overflow nor vanish together.
    let smallest = members.iter().map(|zero| zero.condition).fold(f64::INFINITY, f64::min);
    let weight = |zero: &Zero| {
        let ratio = smallest / zero.condition;
        if ratio.is_finite() { ratio * ratio } else { 1.0 }
    };
    let total: f64 = members.iter().map(weight).sum();
    members.iter().map(|zero| zero.value * (weight(zero) / total)).sum()
}

fn spread(members: &[Zero]) -> f64 {
    let distance = |a: &Zero, b: &Zero| (a.value - b.value).norm();
    members
        .iter()
        .enumerate()
        .flat_map(|(k, a)| members[..k].iter().map(move |b| distance(a, b)))
        .fold(0.0, f64::max)
}

fn with_conjugates(mut upper: Vec<SharedZero>) -> Vec<SharedZero> {
    upper.sort_by(|a, b| b.value.re.total_cmp(&a.value.re).then(b.value.im.total_cmp(&a.value.im)));
    let mirrored = |zero: &SharedZero| {
        let mut mirrored = zero.clone();
        mirrored.value = zero.value.conj();
        mirrored.members.iter_mut().for_each(|zero| zero.value = zero.value.conj());
        mirrored
    };
    upper
        .into_iter()
        .flat_map(|zero| {
            let conjugate = (zero.value.im > 0.0).then(|| mirrored(&zero));
            std::iter::once(zero).chain(conjugate)
        })
        .collect()
}

#[cfg(test)]
mod tests;
