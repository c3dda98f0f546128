//! Which eigenvalue of a reconstruction stands for which mode, and how far off it is.

use nalgebra::Vector2;
use num_complex::Complex;
use reconstruct::likelihood::ComplexEstimate;
use reconstruct::{Reconstruction, likelihood};

use super::modes::{PerMode, TrueModes};

/// Errors of a reconstruction of any method; `None` where it has too few eigenvalues.
pub(crate) fn reconstruction_errors(found: &Reconstruction, truth: &TrueModes) -> Option<PerMode> {
    let values: Vec<Complex<f64>> = found.modes.iter().map(|found| found.mode.eigenvalue).collect();
    eigenvalue_errors(&values, truth)
}

/// Errors of eigenvalues, of which a complex pair may be given once or as both.
pub(crate) fn eigenvalue_errors(values: &[Complex<f64>], truth: &TrueModes) -> Option<PerMode> {
    let upper: Vec<_> = values.iter().copied().filter(|s| s.im >= 0.0).collect();
    let places = by_mode(&upper, truth)?;
    Some(errors(&places, truth))
}

/// The eigenvalues for spiral, roll, Dutch roll. A pair may stand for two real modes that the
/// method could not tell apart.
fn by_mode(values: &[Complex<f64>], truth: &TrueModes) -> Option<[Complex<f64>; 3]> {
    let all: Vec<_> = values.iter().flat_map(|s| with_conjugate(*s)).collect();
    assigned(&all, truth).map(|places| places.map(|place| all[place]))
}

/// An eigenvalue and, where it is not real, its conjugate.
pub(crate) fn with_conjugate(s: Complex<f64>) -> Vec<Complex<f64>> {
    if s.im.abs() > 0.0 { vec![s, s.conj()] } else { vec![s] }
}

/// Distances |s - true s| in 1/s, of s for spiral, roll, Dutch roll.
pub(crate) fn errors(found: &[Complex<f64>; 3], truth: &TrueModes) -> PerMode {
    let truth = truth.list();
    [0, 1, 2].map(|mode| apart(found[mode], truth[mode]))
}

/// The estimates for spiral, roll, Dutch roll.
pub(crate) fn named(fit: &likelihood::Fit, truth: &TrueModes) -> Option<[likelihood::Mode; 3]> {
    let (mut values, mut owners) = (Vec::new(), Vec::new());
    for mode in &fit.modes {
        for s in with_conjugate(mode.continuous.value) {
            values.push(s);
            owners.push(mode);
        }
    }
    assigned(&values, truth).map(|places| places.map(|place| owners[place].clone()))
}

/// Whether the 95 % ellipse of an estimate holds the truth.
pub(crate) fn holds_in_ellipse(estimate: &ComplexEstimate, truth: Complex<f64>) -> bool {
    // -2 ln 0.05: chi-squared with two degrees of freedom.
    const CHI_SQUARED_95: f64 = 5.991_464_547_107_98;
    let off = Vector2::new(estimate.value.re - truth.re, estimate.value.im - truth.im);
    let inverse = estimate.covariance.try_inverse();
    inverse.is_some_and(|inverse| off.dot(&(inverse * off)) <= CHI_SQUARED_95)
}

/// For spiral, roll and Dutch roll the index of the eigenvalue that stands for it: each another
/// one, the sum of the distances as small as possible. `None` where there are not three. A complex
/// pair may be given once or as both.
fn assigned(found: &[Complex<f64>], truth: &TrueModes) -> Option<[usize; 3]> {
    let distance: Vec<[f64; 3]> =
        found.iter().map(|s| truth.list().map(|true_s| apart(*s, true_s))).collect();
    let mut best: Option<(f64, [usize; 3])> = None;
    for spiral in 0..found.len() {
        for roll in (0..found.len()).filter(|roll| *roll != spiral) {
            for dutch_roll in (0..found.len()).filter(|other| ![spiral, roll].contains(other)) {
                let sum = distance[spiral][0] + distance[roll][1] + distance[dutch_roll][2];
                if best.is_none_or(|(least, _)| sum < least) {
                    best = Some((sum, [spiral, roll, dutch_roll]));
                }
            }
        }
    }
    best.map(|(_, places)| places)
}

/// For each mode the distance of the eigenvalue closest to it, whatever it stands for; `None` where
/// there is none.
pub(crate) fn nearest(found: &[Complex<f64>], truth: &TrueModes) -> Option<[f64; 3]> {
    let closest = |true_s: Complex<f64>| {
        found.iter().map(|s| apart(*s, true_s)).filter(|d| d.is_finite()).min_by(f64::total_cmp)
    };
    let [spiral, roll, dutch_roll] = truth.list().map(closest);
    Some([spiral?, roll?, dutch_roll?])
}

/// The distance between two eigenvalues, where one that is not real stands for its conjugate as
/// well.
fn apart(s: Complex<f64>, true_s: Complex<f64>) -> f64 {
    (s - true_s).norm().min((s.conj() - true_s).norm())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUTH: TrueModes = TrueModes {
        spiral: Complex::new(-0.0016, 0.0),
        roll: Complex::new(-0.5, 0.0),
        dutch_roll: Complex::new(-0.07, 1.7),
    };

    #[test]
    fn modes_do_not_share_an_eigenvalue() {
        // Both real ones are closest to the spiral.
        let found = [
            Complex::new(-0.1, -1.5),
            Complex::new(-0.2, 0.0),
            Complex::new(0.1, 0.0),
            Complex::new(9.0, 0.0),
        ];
        assert_eq!(assigned(&found, &TRUTH), Some([2, 1, 0]));
        assert_eq!(assigned(&found[..2], &TRUTH), None);
        let [spiral, roll, dutch_roll] = nearest(&found, &TRUTH).unwrap();
        assert!((spiral - 0.1016).abs() < 1e-12);
        assert!((roll - 0.3).abs() < 1e-12);
        assert!((dutch_roll - 0.03_f64.hypot(0.2)).abs() < 1e-12);
        assert_eq!(nearest(&[Complex::new(f64::NAN, 0.0)], &TRUTH), None);
    }

    #[test]
    fn a_pair_stands_for_two_real_modes() {
        let truth = TrueModes {
            spiral: Complex::new(0.0, 0.0),
            roll: Complex::new(-0.5, 0.0),
            dutch_roll: Complex::new(-0.1, 1.7),
        };
        let values = [Complex::new(-0.25, 0.1), Complex::new(-0.1, 1.6)];
        let found = by_mode(&values, &truth).unwrap();
        let [spiral, roll, dutch_roll] = errors(&found, &truth);
        assert!((spiral - 0.25_f64.hypot(0.1)).abs() < 1e-12);
        assert!((roll - 0.25_f64.hypot(0.1)).abs() < 1e-12);
        assert!((dutch_roll - 0.1).abs() < 1e-12);
        assert!(by_mode(&values[..1], &truth).is_none());
    }
}
