use super::*;
use crate::SharedModel;
use crate::likelihood::fixtures::{Disturbance, Normal, QUIET, fly, given, system};
use crate::likelihood::identify;
use crate::model::{AutoregressionOrder, VectorAutoregression};

const EIGENVALUES: [Complex<f64>; 2] = [Complex::new(0.9, 0.0), Complex::new(0.7, 0.4)];

fn planted(seed: u64) -> (SharedModel, Vec<Record>, Vec<f64>) {
    let mut normal = Normal::new(seed);
    let model = system(&EIGENVALUES, 3, 2, &mut normal);
    let flights = fly(&model, &[301, 300], &Disturbance { noise: 0.03, ..QUIET }, &mut normal);
    (model, flights.records, flights.levels)
}

/// The ratio of deviations, bootstrap over first order, of real and imaginary parts.
fn ratios(fit: &Fit, found: &Bootstrap) -> Vec<f64> {
    let pairs = fit.modes.iter().zip(&found.modes);
    let each = pairs.flat_map(|(mode, repeated)| {
        let (first, again) = (&mode.continuous, &repeated.continuous);
        let imaginary = again.imaginary_standard_error() / first.imaginary_standard_error();
        let complex = mode.continuous.value.im > 0.0;
        [
            Some(again.real_standard_error() / first.real_standard_error()),
            complex.then_some(imaginary),
        ]
    });
    each.flatten().collect()
}

#[test]
fn scatter_is_what_the_covariance_says() {
    const REPETITIONS: usize = 120;
    // Three deviations of a deviation from so many values, and what is not of first order.
    let tolerance = 3.0 / (2.0 * REPETITIONS as f64).sqrt() + 0.05;
    for estimated in [false, true] {
        let (model, records, levels) = planted(1);
        let options = if estimated { Options::default() } else { given(&levels) };
        let fit = identify(&records, &[model], &options).unwrap();
        let mut normal = Normal::new(5);
        let found = bootstrap(&records, &fit, REPETITIONS, &mut || normal.next()).unwrap();
        assert_eq!(found.lost, 0);
        for ratio in ratios(&fit, &found) {
            assert!((ratio - 1.0).abs() < tolerance, "{estimated}: {ratio}");
        }
        for (mode, repeated) in fit.modes.iter().zip(&found.modes) {
            assert_eq!(repeated.values.len(), REPETITIONS);
            let shift = (repeated.continuous.value - mode.continuous.value).norm();
            let deviation = mode.continuous.covariance.trace().sqrt();
            assert!(shift < 0.5 * deviation, "{shift} {deviation}");
        }
    }
}

#[test]
fn coloured_noise_is_repeated_in_its_colour() {
    let (model, records, levels) = planted(2);
    // White noise of other levels, as a spectrum: an autoregression of order zero.
    let mut normal = Normal::new(9);
    let channels = levels.iter().enumerate().map(|(s, level)| {
        Channel::new(format!("y{s}"), (0..4000).map(|_| level * normal.next()).collect())
    });
    let quiet = Record::new("quiet", records[0].period(), channels.collect()).unwrap();
    let fitted = VectorAutoregression::fit(&quiet, AutoregressionOrder::Fixed(0)).unwrap();
    let spectra = records.iter().map(|record| fitted.spectrum(record.samples()).unwrap());
    let noise = Noise::Spectra(spectra.collect());
    let coloured = Options { noise, ..Options::default() };
    let spread = |options: &Options| {
        let fit = identify(&records, std::slice::from_ref(&model), options).unwrap();
        let mut normal = Normal::new(6);
        let found = bootstrap(&records, &fit, 20, &mut || normal.next()).unwrap();
        found.modes.iter().map(|mode| mode.continuous.real_standard_error()).collect::<Vec<_>>()
    };
    for (x, y) in spread(&coloured).iter().zip(spread(&given(&levels))) {
        assert!((x / y - 1.0).abs() < 0.1, "{x} {y}");
    }
}

#[test]
fn the_same_numbers_give_the_same_result_and_one_repetition_is_refused() {
    let (model, records, levels) = planted(3);
    let options = given(&levels);
    let fit = identify(&records, &[model], &options).unwrap();
    let run = |repetitions| {
        let mut normal = Normal::new(7);
        bootstrap(&records, &fit, repetitions, &mut || normal.next())
    };
    assert_eq!(run(3).unwrap(), run(3).unwrap());
    assert!(matches!(run(1), Err(ReconstructError::Option { name: "repetitions", .. })));
}
