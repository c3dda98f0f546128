use std::f64::consts::PI;

use super::*;
use crate::likelihood::FrequencyBand;
use crate::likelihood::fixtures::Normal;
use crate::output_error::disturbance::flat;
use crate::output_error::spectra::spectra;
use crate::output_error::tests::{BOTH, flights};

/// All that sampling leaves, so that samples at the ends of a record can be told apart.
const BAND: FrequencyBand = FrequencyBand { lowest_rad_s: 0.0, highest_rad_s: 62.0 };

/// Matrices of three states for three sensors and two inputs, nothing in particular.
fn matrices(normal: &mut Normal) -> Matrices {
    let mut a = normal.matrix(3, 3) * 0.3;
    a[(0, 0)] += 0.4;
    Matrices {
        a,
        b: normal.matrix(3, 2),
        c: normal.matrix(3, 3) * 0.1,
        d: normal.matrix(3, 2) * 0.1,
        sensor_lags: vec![0.0; 3],
        input_lags: vec![0.0, 0.05],
    }
}

/// The matrices with one of their cells moved.
fn moved(matrices: &Matrices, cell: usize, step: f64) -> Matrices {
    let mut moved = matrices.clone();
    let sizes = moved.sizes();
    let matrices = [&mut moved.a, &mut moved.b, &mut moved.c, &mut moved.d];
    let entries = matrices.into_iter().flat_map(|matrix| matrix.iter_mut());
    let lags = moved.sensor_lags.iter_mut().chain(&mut moved.input_lags);
    assert!(cell < sizes.count());
    for (_, entry) in entries.chain(lags).enumerate().filter(|(place, _)| *place == cell) {
        *entry += step;
    }
    moved
}

#[test]
fn descent_is_the_derivative_of_the_cost() {
    const STEP: f64 = 1e-6;
    for drift in [false, true] {
        let (records, inputs) = flights(&[BOTH], 11);
        let spectrum = &spectra(&records, &inputs, BAND, drift).unwrap()[0];
        let weighting = flat(spectrum);
        let here = matrices(&mut Normal::new(5));
        let count = here.sizes().count();
        let free: Vec<usize> = (here.sizes().sensor_lag(0)..count).collect();
        let cost = |matrices: &Matrices| sums(matrices, spectrum, &weighting, &free).unwrap().cost;
        let found = sums(&here, spectrum, &weighting, &free).unwrap();
        for cell in 0..count {
            // The cost is minimised over t and delta at both ends.
            let difference = cost(&moved(&here, cell, STEP)) - cost(&moved(&here, cell, -STEP));
            let slope = -2.0 * found.descent[cell];
            let off = (difference / (2.0 * STEP) - slope).abs();
            let scale = found.cost.sqrt() * found.gram[(cell, cell)].sqrt();
            assert!(off < 1e-4 * scale, "{drift} {cell}: {off}, {slope}");
        }
        // Three states, three drifts, six samples at the ends of each sensor.
        assert_eq!(found.determined, if drift { 24 } else { 21 });
    }
}

#[test]
fn residuals_add_up_to_the_cost() {
    let (records, inputs) = flights(&[BOTH], 12);
    let spectrum = &spectra(&records, &inputs, BAND, true).unwrap()[0];
    let weighting = flat(spectrum);
    let mut here = matrices(&mut Normal::new(6));
    here.sensor_lags[1] = 0.04;
    let found = sums(&here, spectrum, &weighting, &[]).unwrap();
    let left = residuals(&here, spectrum, &found.nuisances);
    let cost: f64 = (0..left.ncols())
        .map(|k| {
            let at = |s: usize| left[(s, k)].norm_sqr() * weighting.precision[9 * k + 4 * s].re;
            spectrum.weight[k] * (at(0) + at(1) + at(2))
        })
        .sum();
    assert!((cost - found.cost).abs() < 1e-9 * cost, "{cost}, {}", found.cost);
    assert!(spectrum.frequencies.iter().all(|w| *w > 0.0 && *w <= 62.0 && *w < PI / 0.05));
}
