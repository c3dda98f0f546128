//! The paper's aircraft: against the oracle, and what noise levels, orders and excitations come out as.

use super::*;
use lti::z_to_s;
use num_complex::Complex;

fn oracle() -> serde_json::Value {
    let file = format!("{}/../../tests/data/records/subspace.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap()
}

fn numbers(value: &serde_json::Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

fn eigenvalues(found: &Intersection) -> Vec<Complex<f64>> {
    found.modes.iter().map(|mode| z_to_s(mode.pole, found.model.period).unwrap()).collect()
}

/// The largest distance of an eigenvalue from the closest one found, relative to it.
fn error(expected: &[Complex<f64>], found: &[Complex<f64>]) -> f64 {
    let distance = |e: &Complex<f64>| {
        found.iter().map(|f| (f - e).norm()).fold(f64::INFINITY, f64::min) / e.norm()
    };
    expected.iter().map(distance).fold(0.0, f64::max)
}

/// tests/data/reference.json /aircraft/spec_A.
fn truth() -> Vec<Complex<f64>> {
    [
        (-0.545_562_845_619_248_3, 0.0),
        (-0.070_594_067_703_702_26, -1.691_678_361_958_471_2),
        (-0.070_594_067_703_702_26, 1.691_678_361_958_471_2),
        (-0.001_563_638_219_256_003_3, 0.0),
    ]
    .map(|(re, im)| Complex::new(re, im))
    .to_vec()
}

#[test]
fn poles_are_those_of_the_oracle() {
    let oracle = oracle();
    for name in ["white_snr100", "white_snr10", "multistep_snr100"] {
        for (offsets, key) in [(Offsets::Free, "rows"), (Offsets::Zero, "none")] {
            let expected = &oracle[name][key];
            let mut options = fixed(4);
            options.block_rows =
                Some(usize::try_from(oracle[name]["block_rows"].as_u64().unwrap()).unwrap());
            options.noise = NoiseModel::Levels(numbers(&oracle[name]["noise_levels"]));
            options.measurement.offsets = offsets;
            // The oracle leaves room for a direct path.
            options.measurement.feedthrough_sensors = vec![0];
            let found = identify(&pair(name), &options).unwrap();
            let poles: Vec<_> =
                expected["eigenvalues"].as_array().unwrap().iter().map(numbers).collect();
            let poles: Vec<_> = poles.iter().map(|pole| Complex::new(pole[0], pole[1])).collect();
            let error = error(&poles, &eigenvalues(&found));
            assert!(error < 1e-6, "{name} {key}: {error:e}");
            let values = numbers(&expected["order_eigenvalues"]);
            for (found, expected) in found.order.eigenvalues.iter().zip(values) {
                assert!((found - expected).abs() < 1e-6 * expected + 1e-14, "{found} {expected}");
            }
        }
    }
}

#[test]
fn noise_free_records_give_the_eigenvalues() {
    for (offsets, block_rows, order) in [
        (Offsets::Free, None, OrderChoice::Fixed(4)),
        (Offsets::Zero, None, OrderChoice::Gap { largest: 10 }),
        (Offsets::Free, Some(40), OrderChoice::Gap { largest: 10 }),
    ] {
        let measurement = Measurement { offsets, ..Measurement::default() };
        let options = Options { order, measurement, block_rows, ..Options::default() };
        let found = identify(&pair("noise_free"), &options).unwrap();
        assert_eq!(found.order.order, 4);
        // Distances in 1/s; the slowest eigenvalue is 0.0016.
        let found_there = eigenvalues(&found);
        let distance = crate::paper::containment(&truth(), &found_there).largest_distance();
        assert!(distance < 1e-12, "{distance:e}");
        assert_eq!(found.noise.origin, NoiseOrigin::Rounding);
        assert_eq!(found.doubts, []);
    }
}

#[test]
fn noise_levels_come_out_within_some_per_cent() {
    for (name, level, tolerance) in [
        ("white_snr100", [0.029_733, 0.075_875, 0.059_235], 0.04),
        ("white_snr10", [0.297_33, 0.758_75, 0.592_35], 0.05),
        ("multistep_snr100", [0.031_953, 0.081_879, 0.053_620], 0.12),
    ] {
        let found = identify(&pair(name), &fixed(4)).unwrap();
        for (found, expected) in found.noise.deviations.iter().zip(level) {
            assert!((found / expected - 1.0).abs() < tolerance, "{name}: {found} {expected}");
        }
    }
}

#[test]
fn the_gap_tells_four_states() {
    for name in ["white_snr100", "white_snr10", "multistep_snr100"] {
        for offsets in [Offsets::Free, Offsets::Zero] {
            let measurement = Measurement { offsets, ..Measurement::default() };
            let options = Options { measurement, ..Options::default() };
            let found = identify(&pair(name), &options).unwrap();
            assert_eq!(found.order.order, 4);
        }
    }
}
