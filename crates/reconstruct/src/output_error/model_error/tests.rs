use super::*;
use crate::likelihood::FrequencyBand;
use crate::likelihood::fixtures::Normal;
use crate::output_error::spectra::spectra;
use crate::output_error::tests::{BOTH, Flown, flights};

/// Residuals of white noise and a part of each sensor's power.
fn found(part: f64, noise: f64, seed: u64) -> Estimate {
    let (records, inputs) = flights(&[Flown { samples: 4000, ..BOTH }], seed);
    let band = FrequencyBand { lowest_rad_s: 0.0, highest_rad_s: 20.0 };
    let all = spectra(&records, &inputs, band, false).unwrap();
    let mut normal = Normal::new(seed);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let residuals: Vec<_> = all
        .iter()
        .map(|spectrum| {
            DMatrix::from_fn(3, spectrum.z.len(), |sensor, k| {
                let mean = spectrum.power.row(sensor).mean();
                let power = spectrum.power[(sensor, k)];
                let size = (noise * noise * mean + part * part * power).sqrt() * half;
                Complex::new(normal.next(), normal.next()) * size
            })
        })
        .collect();
    model_error(&residuals, &all).unwrap()
}

#[test]
fn a_planted_part_comes_back() {
    for (part, noise, seed) in [(0.02, 1e-3, 1), (0.02, 5e-3, 2), (0.3, 1e-3, 3)] {
        let estimate = found(part, noise, seed);
        let off = (estimate.value - part).abs();
        assert!(off < 4.0 * estimate.standard_error && off < 0.2 * part, "{part}: {estimate:?}");
    }
}

#[test]
fn noise_alone_is_no_model_error() {
    let estimate = found(0.0, 0.05, 4);
    assert!(estimate.value < 0.01, "{estimate:?}");
}
