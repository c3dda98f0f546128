//! Which reconstructed eigenvalue stands for which mode.

use num_complex::Complex;

use super::modes::TrueModes;

/// For spiral, roll and Dutch roll the index of the eigenvalue that stands for it: each another one, the sum of the distances as small as
/// possible. `None` where there are not three. A complex pair may be given once or as both.
pub(crate) fn assigned(found: &[Complex<f64>], truth: &TrueModes) -> Option<[usize; 3]> {
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

/// For each mode the distance of the eigenvalue closest to it, whatever it stands for; `None` where there is none.
pub(crate) fn nearest(found: &[Complex<f64>], truth: &TrueModes) -> Option<[f64; 3]> {
    let closest = |true_s: Complex<f64>| {
        found.iter().map(|s| apart(*s, true_s)).filter(|d| d.is_finite()).min_by(f64::total_cmp)
    };
    let [spiral, roll, dutch_roll] = truth.list().map(closest);
    Some([spiral?, roll?, dutch_roll?])
}

/// The distance between two eigenvalues, where one that is not real stands for its conjugate as well.
pub(crate) fn apart(s: Complex<f64>, true_s: Complex<f64>) -> f64 {
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
}
