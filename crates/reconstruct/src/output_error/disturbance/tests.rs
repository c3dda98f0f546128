use super::*;
use crate::likelihood::FrequencyBand;
use crate::likelihood::fixtures::Normal;
use crate::output_error::spectra::spectra;
use crate::output_error::tests::{BOTH, Flown, flights};

#[test]
fn the_kernel_adds_up_to_one() {
    for count in [1, 5, 30, 1000] {
        let kernel = kernel(count);
        let sum = kernel[0] + 2.0 * kernel[1..].iter().sum::<f64>();
        assert!((sum - 1.0).abs() < 1e-12, "{count}");
        assert!(kernel.windows(2).all(|pair| pair[0] > pair[1]));
    }
    assert_eq!(
        [reflected(-2, 9), reflected(3, 9), reflected(9, 9), reflected(11, 9)],
        [2, 3, 7, 5]
    );
}

/// Correlated noise of a known covariance comes back, and its inverse weighs the residuals.
#[test]
fn correlated_noise_comes_back() {
    let (records, inputs) = flights(&[Flown { samples: 8000, ..BOTH }], 1);
    let band = FrequencyBand { lowest_rad_s: 0.0, highest_rad_s: 60.0 };
    let mut spectrum = spectra(&records, &inputs, band, false).unwrap().remove(0);
    // No part of the sensors' power counts.
    spectrum.power.fill(0.0);
    let mut normal = Normal::new(2);
    let mix = DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 0.0, 0.8, 0.5, 0.0, -0.3, 0.1, 2.0]);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let mut draw = || {
        let part = |normal: &mut Normal| &mix * normal.vector(3) * half;
        let (re, im) = (part(&mut normal), part(&mut normal));
        re.zip_map(&im, Complex::new)
    };
    let columns: Vec<_> = spectrum.z.iter().map(|_| draw()).collect();
    let residuals = DMatrix::from_columns(&columns);
    let found = from_residuals(&residuals, &spectrum, &[]).unwrap();
    let truth = &mix * mix.transpose();
    // The mean of the inverses, less what averaging so few products adds.
    let count = spectrum.z.len();
    let mut mean = DMatrix::zeros(3, 3);
    for precision in found.precision.chunks(9) {
        mean += DMatrix::from_row_slice(3, 3, precision).map(|entry| entry.re) / count as f64;
    }
    let shrunk = mean * ((found.averaged - 3.0) / found.averaged);
    let off = (shrunk * truth - DMatrix::identity(3, 3)).amax();
    assert!(off < 0.15, "{off}");
    let logs = found.log_determinant / spectrum.weight.iter().sum::<f64>();
    let determinant = (mix.determinant().powi(2)).ln();
    assert!((logs - determinant).abs() < 0.4, "{logs} {determinant}");
}

#[test]
fn residuals_that_are_zero_leave_the_least_model_error() {
    let (records, inputs) = flights(&[BOTH], 3);
    let band = FrequencyBand { lowest_rad_s: 0.0, highest_rad_s: 10.0 };
    let spectrum = &spectra(&records, &inputs, band, false).unwrap()[0];
    let nothing = DMatrix::zeros(3, spectrum.z.len());
    let found = from_residuals(&nothing, spectrum, &[]).unwrap();
    let least = 1e-6 * spectrum.power[(1, 4)];
    assert!((found.precision[9 * 4 + 4].re * least - 1.0).abs() < 1e-9);
}
