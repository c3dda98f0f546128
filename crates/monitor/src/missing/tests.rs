use cfi_ident::{CfiModel, ConstantTerm, Orders, Structure};

use super::*;

fn link() -> Link {
    let structure = Structure::new(Orders::new(2, 2, 3).unwrap(), ConstantTerm::Included);
    let model = CfiModel::new(structure, &[0.3, -0.6], &[0.1, -0.4, 1.0, 0.7, 0.2, -0.1]).unwrap();
    Link { model, input: 0, output: 1 }
}

fn signal(seed: u32, samples: u32) -> Vec<f64> {
    (0..samples).map(|k| (f64::from(k * k % 97 + seed * k) * 0.618_033_988_75).fract()).collect()
}

/// A window's numbers where these samples of the two channels read so much more than they should, and are missing.
fn with_errors(error: f64) -> Moments {
    let (link, whitening) = (link(), Whitening::fit(&[&signal(3, 300)]));
    let mut channels = [signal(1, 200), signal(2, 200)];
    let missing: [&[usize]; 2] = [&[61, 90], &[70, 71]];
    for (channel, samples) in channels.iter_mut().zip(missing) {
        samples.iter().for_each(|&sample| channel[sample] += error);
    }
    let residual = link.model.residuals(&channels[0], &channels[1]).unwrap();
    let first = residual.first + whitening.order();
    let values = &whitening.apply(&residual.values)[60 - first..100 - first];
    Missing::of(&link, &whitening, missing).unwrap().moments(values, 60).unwrap()
}

#[test]
fn what_stands_in_for_missing_samples_does_not_matter() {
    let (expected, found) = (with_errors(0.0), with_errors(5.0));
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-9 * b.abs(), "{found:?} {expected:?}");
    close(found.level, expected.level);
    close(found.variance, expected.variance);
    // 40 samples, four unknowns and the mean.
    assert!((found.freedom - 35.0).abs() < 1e-12);
}

#[test]
fn a_window_without_missing_samples_has_its_mean_and_variance() {
    let whitening = Whitening::fit(&[&signal(3, 300)]);
    let missing = Missing::of(&link(), &whitening, [&[], &[]]).unwrap();
    let found = missing.moments(&[1.0, 2.0, 6.0], 50).unwrap();
    assert_eq!(found, Moments { level: 3.0, variance: 7.0, freedom: 2.0 });
}

#[test]
fn too_many_missing_samples_leave_nothing() {
    let whitening = Whitening::fit(&[&signal(3, 300)]);
    let lost: Vec<usize> = (50..80).collect();
    let missing = Missing::of(&link(), &whitening, [&lost, &[]]).unwrap();
    assert_eq!(missing.moments(&signal(1, 40), 50), None);
}

#[test]
fn interpolated_values_lie_on_straight_lines() {
    let gap = f64::NAN;
    let check = |channel: &[f64], expected: &[f64], missing: &[usize]| {
        let filled = fill(channel);
        assert_eq!(filled.missing, missing);
        for (value, expected) in filled.values.iter().zip(expected) {
            assert!((value - expected).abs() < 1e-12, "{:?}", filled.values);
        }
    };
    check(&[gap, 1.0, gap, gap, 4.0, gap], &[1.0, 1.0, 2.0, 3.0, 4.0, 4.0], &[0, 2, 3, 5]);
    check(&[gap, gap], &[0.0, 0.0], &[0, 1]);
}
