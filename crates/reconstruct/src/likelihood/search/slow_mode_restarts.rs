//! Restarts with a slow mode moved across z = 1. The likelihood has several local optima where a mode decays or grows over the length of a record: only
//! a few frequencies see it, and a real eigenvalue does not pass z = 1 downhill, where it would explain too much at frequency zero. Subspace starts can
//! land in the wrong basin; moving the slow eigenvalue to the other side escapes it.

use lti::{Discrete, SamplePeriod, StateSpace};
use nalgebra::DMatrix;

/// Exponents s N T to which the slowest real mode is moved: grows or decays by e^5, e^1, e^-3, e^-30 over a record of N samples.
const FOR_THE_SLOWEST: [f64; 4] = [5.0, 1.0, -3.0, -30.0];
/// The same for the next one, which may have taken its place.
const FOR_THE_NEXT: [f64; 1] = [5.0];
/// A target this close to where the mode is, relative to it, is left out.
const SAME_PLACE: f64 = 0.5;

/// Eigenvectors closer to dependent than this are no basis: a move would throw everything else off.
const WORST_CONDITION: f64 = 1e6;

/// A matrix with one eigenvalue moved.
pub(crate) struct Moved {
    pub(crate) a: DMatrix<f64>,
    /// Where it is now.
    pub(crate) eigenvalue: f64,
}

/// The matrices with one of the two slowest real modes moved, every other eigenvalue and all directions as they are. Two modes that met and
/// became an overdamped pair count as two real ones. None where A has no basis of eigenvectors.
pub(crate) fn moved(a: &DMatrix<f64>, samples: f64) -> Vec<Moved> {
    let Some(form) = RealForm::new(a) else {
        return Vec::new();
    };
    let mut slow: Vec<(f64, usize)> = (0..a.nrows())
        .filter_map(|place| form.exponent(place).map(|exponent| (exponent * samples, place)))
        .collect();
    slow.sort_by(|x, y| x.0.abs().total_cmp(&y.0.abs()));
    let targets = [&FOR_THE_SLOWEST[..], &FOR_THE_NEXT[..]];
    let mut all = Vec::new();
    for (&(now, place), targets) in slow.iter().zip(targets) {
        for &target in targets {
            let elsewhere = (now - target).abs() > SAME_PLACE * target.abs().max(1.0);
            if elsewhere || form.is_pair(place) {
                let eigenvalue = (target / samples).exp();
                all.push(Moved { a: form.with(place, eigenvalue), eigenvalue });
            }
        }
    }
    all
}

/// A = P B P^-1 with B block diagonal: real eigenvalues, and 2 x 2 blocks [re im; -im re].
struct RealForm {
    p: DMatrix<f64>,
    inverse: DMatrix<f64>,
    blocks: DMatrix<f64>,
}

impl RealForm {
    fn new(a: &DMatrix<f64>) -> Option<Self> {
        let n = a.nrows();
        let (none, empty) = (DMatrix::zeros(n, 0), DMatrix::zeros(0, n));
        let period = SamplePeriod::new(1.0).ok()?;
        let system =
            StateSpace::<Discrete>::new(a.clone(), none, empty, DMatrix::zeros(0, 0), period)
                .ok()?;
        let (mut p, mut blocks) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
        let mut k = 0;
        for mode in system.modes().ok()? {
            let (z, vector) = (mode.discrete_eigenvalue?, mode.eigenvector?);
            p.set_column(k, &vector.map(|entry| entry.re));
            blocks[(k, k)] = z.re;
            if z.im > 0.0 {
                p.set_column(k + 1, &vector.map(|entry| entry.im));
                blocks[(k + 1, k + 1)] = z.re;
                blocks[(k, k + 1)] = z.im;
                blocks[(k + 1, k)] = -z.im;
                k += 1;
            }
            k += 1;
        }
        let inverse = p.clone().try_inverse()?;
        let condition = p.norm() * inverse.norm();
        let usable = condition < WORST_CONDITION;
        usable.then_some(Self { p, inverse, blocks })
    }

    /// log z of the real or overdamped eigenvalue in this place; `None` for others and for the second of a pair.
    fn exponent(&self, place: usize) -> Option<f64> {
        let second = place > 0 && self.blocks[(place - 1, place)] > 0.0;
        let re = self.blocks[(place, place)];
        let im = if self.is_pair(place) { self.blocks[(place, place + 1)] } else { 0.0 };
        let overdamped = re > 0.0 && im <= (1.0 - re).abs();
        (!second && overdamped).then(|| re.hypot(im).ln())
    }

    fn is_pair(&self, place: usize) -> bool {
        place + 1 < self.blocks.nrows() && self.blocks[(place, place + 1)] > 0.0
    }

    /// The matrix with another eigenvalue in this place; of a pair the other one stays, as a real one.
    fn with(&self, place: usize, z: f64) -> DMatrix<f64> {
        let mut blocks = self.blocks.clone();
        if self.is_pair(place) {
            blocks[(place, place + 1)] = 0.0;
            blocks[(place + 1, place)] = 0.0;
        }
        blocks[(place, place)] = z;
        &self.p * blocks * &self.inverse
    }
}

#[cfg(test)]
mod tests;
