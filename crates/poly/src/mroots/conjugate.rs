//! Approximate roots of a real polynomial, made exactly real or exactly conjugate.

use num_complex::Complex;

/// Replaces the list by real roots and exact conjugate pairs; the pairs stand together.
///
/// Roots are taken by descending imaginary part relative to their modulus, each matched with the root nearest
/// to its conjugate. A root that is nearer to its own conjugate than any other root is real.
pub(crate) fn symmetrize(roots: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let mut upper: Vec<Complex<f64>> = roots.iter().copied().filter(|z| z.im > 0.0).collect();
    let mut lower: Vec<Complex<f64>> = roots.iter().copied().filter(|z| z.im < 0.0).collect();
    let mut result: Vec<Complex<f64>> =
        roots.iter().filter(|z| z.im == 0.0).map(|z| Complex::new(z.re, 0.0)).collect();
    let tilt = |z: &Complex<f64>| (z.im / z.norm()).abs();
    upper.sort_by(|a, b| tilt(b).total_cmp(&tilt(a)));
    for z in upper {
        let nearest = (0..lower.len()).min_by(|&i, &j| {
            let distance = |k: usize| (lower[k].conj() - z).norm();
            distance(i).total_cmp(&distance(j))
        });
        match nearest {
            Some(k) if (lower[k].conj() - z).norm() <= z.im.max(-lower[k].im) => {
                let other = lower.swap_remove(k).conj();
                let mean =
                    Complex::new(z.re + 0.5 * (other.re - z.re), z.im + 0.5 * (other.im - z.im));
                result.push(mean);
                result.push(mean.conj());
            }
            _ => result.push(Complex::new(z.re, 0.0)),
        }
    }
    result.extend(lower.into_iter().map(|z| Complex::new(z.re, 0.0)));
    result
}
