//! One-to-one matching of points in the complex plane, closest pairs first.

use num_complex::Complex;

/// One match: indices into the two lists, and the distance of the two points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Match {
    pub(crate) left: usize,
    pub(crate) right: usize,
    pub(crate) distance: f64,
}

/// Pairs up the two lists until one is used up. Ties go to the lower indices, so the result does not depend on anything but the input.
pub(crate) fn closest_pairs(left: &[Complex<f64>], right: &[Complex<f64>]) -> Vec<Match> {
    let mut candidates: Vec<Match> = (0..left.len())
        .flat_map(|l| (0..right.len()).map(move |r| (l, r)))
        .map(|(l, r)| Match { left: l, right: r, distance: (left[l] - right[r]).norm() })
        .collect();
    candidates.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    let (mut used_left, mut used_right) = (vec![false; left.len()], vec![false; right.len()]);
    candidates.retain(|candidate| {
        let free = !used_left[candidate.left] && !used_right[candidate.right];
        if free {
            used_left[candidate.left] = true;
            used_right[candidate.right] = true;
        }
        free
    });
    candidates
}

#[cfg(test)]
mod tests;
