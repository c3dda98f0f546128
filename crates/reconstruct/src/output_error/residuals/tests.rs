use std::f64::consts::PI;

use super::*;
use crate::Record;
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

/// Sensor and sample: a row, neighbours, and one by itself.
const MISSING: [(usize, usize); 7] =
    [(0, 40), (1, 40), (2, 40), (1, 300), (1, 301), (0, 302), (2, 777)];

/// The record without those samples.
fn with_missing(record: &Record) -> Record {
    let mut channels = record.channels().to_vec();
    for (sensor, sample) in MISSING {
        channels[sensor].values[sample] = f64::NAN;
    }
    Record::with_missing(record.name(), record.period(), channels).unwrap()
}

/// Weights that couple the sensors, in another way at each frequency.
fn coupled(spectrum: &Spectrum, normal: &mut Normal) -> Weighting {
    let mut weighting = flat(spectrum);
    for at_one in weighting.precision.chunks_exact_mut(9) {
        let scale: Vec<f64> = (0..3).map(|s| at_one[4 * s].re.sqrt()).collect();
        let mix = normal.matrix(3, 3).zip_map(&normal.matrix(3, 3), Complex::new);
        let matrix = &mix * mix.adjoint() + DMatrix::identity(3, 3);
        for i in 0..3 {
            for l in 0..3 {
                at_one[3 * i + l] = matrix[(i, l)] * scale[i] * scale[l];
            }
        }
    }
    weighting
}

/// The cost is a parabola in the values of the missing samples; its least is what brute force finds. Lags turn the samples with their sensor.
#[test]
fn missing_samples_cost_what_the_best_values_do() {
    let (records, inputs) = flights(&[BOTH], 13);
    let here = |late: f64| {
        let mut here = matrices(&mut Normal::new(7));
        here.sensor_lags = vec![late, 0.0, -0.5 * late];
        here
    };
    let band = FrequencyBand { highest_rad_s: 40.0, ..BAND };
    let gaps = spectra(&[with_missing(&records[0])], &inputs, band, false).unwrap();
    let weighting = coupled(&gaps[0], &mut Normal::new(8));
    for (late, free) in [(0.0, false), (0.03, false), (0.03, true)] {
        let matrices = here(late);
        let sizes = matrices.sizes();
        let free: Vec<usize> = if free { vec![sizes.sensor_lag(0)] } else { Vec::new() };
        let unknowns = missing(&matrices, &gaps[0], &weighting, &free);
        assert_eq!(unknowns.is_some(), free.is_empty());
        let found = sums(&matrices, &gaps[0], &weighting, &free, unknowns.as_ref()).unwrap();
        let unit = 1e-2;
        let cost = |places: &[usize]| {
            let mut channels = with_missing(&records[0]).channels().to_vec();
            for &place in places {
                let (sensor, sample) = MISSING[place];
                channels[sensor].values[sample] += unit;
            }
            let record = Record::new("whole", records[0].period(), channels).unwrap();
            let spectrum = &spectra(&[record], &inputs, band, false).unwrap()[0];
            sums(&matrices, spectrum, &weighting, &free, None).unwrap().cost
        };
        let count = MISSING.len();
        let nothing = cost(&[]);
        let single: Vec<f64> = (0..count).map(|i| cost(&[i])).collect();
        let curvature = DMatrix::from_fn(count, count, |i, k| {
            (cost(&[i, k]) - single[i] - single[k] + nothing) / 2.0
        });
        let slope = DVector::from_fn(count, |i, _| single[i] - nothing - curvature[(i, i)]);
        let least = nothing - slope.dot(&curvature.lu().solve(&slope).unwrap()) / 4.0;
        assert!((found.cost - least).abs() < 1e-7 * least, "{late}: {} is not {least}", found.cost);
        assert!(nothing > 1.001 * least, "{late}: interpolated {nothing}, best {least}");
        // What is left belongs to the same values.
        let left = residuals(&matrices, &gaps[0], &found.nuisances);
        let at = |k: usize| {
            let own = left.column(k);
            let precision = DMatrix::from_row_slice(3, 3, &weighting.precision[9 * k..9 * (k + 1)]);
            gaps[0].weight[k] * own.dotc(&(precision * own)).re
        };
        let total: f64 = (0..left.ncols()).map(at).sum();
        assert!((total - found.cost).abs() < 1e-8 * total, "{late}: {total}, {}", found.cost);
    }
}

#[test]
fn descent_is_the_derivative_of_the_cost() {
    const STEP: f64 = 1e-6;
    for (drift, gaps) in [(false, false), (true, false), (false, true)] {
        let (mut records, inputs) = flights(&[BOTH], 11);
        if gaps {
            records[0] = with_missing(&records[0]);
        }
        let spectrum = &spectra(&records, &inputs, BAND, drift).unwrap()[0];
        let weighting = flat(spectrum);
        let here = matrices(&mut Normal::new(5));
        let count = here.sizes().count();
        let free: Vec<usize> = (here.sizes().sensor_lag(0)..count).collect();
        let cost =
            |matrices: &Matrices| sums(matrices, spectrum, &weighting, &free, None).unwrap().cost;
        let found = sums(&here, spectrum, &weighting, &free, None).unwrap();
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
    let found = sums(&here, spectrum, &weighting, &[], None).unwrap();
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
