//! The order in which to multiply factors `x - z`: Leja's.
//!
//! Each next root is the one whose distances to those before have the largest product, so that no partial product is
//! much larger than the whole. In a bad order, as from left to right, partial products of n roots grow like 2^n
//! and their rounding errors with them (Calvetti & Reichel 2003, Numer. Algorithms 33).

#[cfg(test)]
mod tests;

use num_complex::Complex;

/// Repeated roots count as this far apart, relative to the largest modulus: late, but not in a heap at the end.
const NEAREST: f64 = 1e-3;

/// Indices of the roots in Leja's order, from the largest modulus.
pub(crate) fn leja_order(roots: &[Complex<f64>]) -> Vec<usize> {
    let largest = roots.iter().map(|z| z.norm()).fold(0.0, f64::max);
    let mut rest: Vec<usize> = (0..roots.len()).collect();
    let mut order = Vec::with_capacity(roots.len());
    // Logarithm of the product of distances to the roots chosen so far.
    let mut heights: Vec<f64> = roots.iter().map(|z| z.norm()).collect();
    let mut first = true;
    while !rest.is_empty() {
        let best = (0..rest.len())
            .rev()
            .max_by(|&i, &j| heights[rest[i]].total_cmp(&heights[rest[j]]))
            .unwrap_or(0);
        let chosen = rest.swap_remove(best);
        order.push(chosen);
        for &k in &rest {
            let distance = (roots[k] - roots[chosen]).norm().max(NEAREST * largest);
            heights[k] = if first { distance.ln() } else { heights[k] + distance.ln() };
        }
        first = false;
    }
    order
}
