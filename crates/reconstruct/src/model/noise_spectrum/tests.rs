use super::*;

fn complex(entries: &[(f64, f64)]) -> DMatrix<Complex<f64>> {
    DMatrix::from_row_iterator(2, 2, entries.iter().map(|&(re, im)| Complex::new(re, im)))
}

#[test]
fn what_is_no_covariance_is_refused() {
    let good = complex(&[(2.0, 0.0), (0.5, 0.5), (0.5, -0.5), (1.0, 0.0)]);
    assert!(NoiseSpectrum::new(3, vec![good.clone(); 2]).is_ok());
    let refused = |samples: usize, covariances: Vec<DMatrix<Complex<f64>>>| {
        assert!(matches!(
            NoiseSpectrum::new(samples, covariances),
            Err(ReconstructError::Noise { .. })
        ));
    };
    refused(3, vec![good.clone(); 3]);
    refused(0, Vec::new());
    refused(2, vec![good.clone(), DMatrix::identity(3, 3)]);
    // Not Hermitian, not definite, not finite.
    refused(2, vec![good.clone(), complex(&[(2.0, 0.0), (0.5, 0.5), (0.5, 0.5), (1.0, 0.0)])]);
    refused(2, vec![good.clone(), complex(&[(1.0, 0.0), (0.0, 2.0), (0.0, -2.0), (1.0, 0.0)])]);
    refused(2, vec![good, complex(&[(f64::NAN, 0.0), (0.0, 0.0), (0.0, 0.0), (1.0, 0.0)])]);
}

#[test]
fn the_inverse_does_not_mind_units() {
    let unit = [1e-150, 1e150];
    let plain = complex(&[(2.0, 0.0), (0.5, 0.5), (0.5, -0.5), (1.0, 0.0)]);
    let scaled = DMatrix::from_fn(2, 2, |i, k| plain[(i, k)] * unit[i] * unit[k]);
    let (plain, scaled) =
        (inverse_of_hermitian(&plain).unwrap(), inverse_of_hermitian(&scaled).unwrap());
    for i in 0..2 {
        for k in 0..2 {
            let expected = plain[(i, k)];
            let found = scaled[(i, k)] * unit[i] * unit[k];
            assert!((found - expected).norm() < 1e-14);
        }
    }
}
