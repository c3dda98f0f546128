//! A state feedback that moves the poles of zI - A off the unit circle without changing the likelihood.
//!
//! The excitation u is free at every frequency, so that u + k x is as free as u: with A + b k' in place of A and C + d k' in place of C, each
//! record says the same. That makes (zI - A)^-1 harmless at poles on the unit circle: integrators, undamped modes, and those that
//! happen to lie at a frequency of the transform.

use nalgebra::{DMatrix, DVector};

/// The gain k that minimises the sum of |x|^2 + |b|^2 u^2 over all time, u = k' x. Zero where there is none or where it would be so
/// large that it costs more digits than it saves.
pub(crate) fn feedback(a: &DMatrix<f64>, b: &DVector<f64>) -> DVector<f64> {
    const LARGEST_GAIN: f64 = 1e3;
    let n = a.nrows();
    let none = DVector::zeros(n);
    let length = b.norm();
    if length == 0.0 || !length.is_finite() {
        return none;
    }
    let unit = b / length;
    let Some(cost) = riccati(a, &unit) else {
        return none;
    };
    let weighted = &cost * &unit;
    let gain = -(a.transpose() * &weighted) / (1.0 + unit.dot(&weighted));
    let bound = LARGEST_GAIN * a.norm().max(1.0);
    if gain.iter().all(|entry| entry.is_finite()) && gain.norm() <= bound {
        gain / length
    } else {
        none
    }
}

/// The solution of X = A' X (I + b b' X)^-1 A + I by the structure-preserving doubling algorithm (Chu, Fan & Lin 2005), which squares
/// its error each time.
fn riccati(a: &DMatrix<f64>, b: &DVector<f64>) -> Option<DMatrix<f64>> {
    const ITERATIONS: usize = 60;
    const CONVERGED: f64 = 1e-8;
    let n = a.nrows();
    let identity = DMatrix::<f64>::identity(n, n);
    let (mut a, mut g, mut h) = (a.clone(), b * b.transpose(), identity.clone());
    for _ in 0..ITERATIONS {
        let inverse = (&identity + &g * &h).try_inverse()?;
        let change = a.transpose() * &h * &inverse * &a;
        let next_g = &g + &a * &inverse * &g * a.transpose();
        a = &a * &inverse * &a;
        g = 0.5 * (&next_g + next_g.transpose());
        let next_h = &h + &change;
        h = 0.5 * (&next_h + next_h.transpose());
        if !h.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        if change.amax() <= CONVERGED * h.amax() {
            return Some(h);
        }
    }
    None
}

#[cfg(test)]
mod tests;
