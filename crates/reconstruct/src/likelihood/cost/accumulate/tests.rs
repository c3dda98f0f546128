use num_complex::Complex;

use super::super::evaluation::Problem;
use super::super::parameters::{Layout, System};
use nalgebra::DVector;

use super::*;
use crate::likelihood::fixtures::{Normal, QUIET, fly, system};
use crate::likelihood::options::Options;
use crate::model::Hold;
use crate::{Channel, Record};

/// The sums of one record at the true system, in sensors of unit noise.
fn at_truth(record: &Record, model: &crate::SharedModel, scalars: Scalars) -> Sums {
    on_threads(1, record, model, scalars)
}

fn on_threads(
    threads: usize,
    record: &Record,
    model: &crate::SharedModel,
    scalars: Scalars,
) -> Sums {
    let layout =
        Layout { order: 3, sensors: 3, records: 1, feedthrough: Vec::new(), hold: Hold::ZeroOrder };
    let options = Options { threads, ..Options::default() };
    let problem = Problem::new(layout, std::slice::from_ref(record), &[1.0; 3], &options).unwrap();
    let system = System {
        a: model.a.clone(),
        c: model.c.clone(),
        b: model.b.clone(),
        d: vec![DVector::zeros(3)],
        derivatives: None,
    };
    problem.record_sums(0, &system, &problem.no_coefficients(), &[1.0; 3], scalars, true)
}

#[test]
fn noise_adds_to_the_gram_matrix_what_it_is_said_to_add() {
    let mut normal = Normal::new(1);
    let eigenvalues = [Complex::new(0.7, 0.5), Complex::new(0.6, 0.0)];
    let mut model = system(&eigenvalues, 3, 1, &mut normal);
    model.c *= 0.3;
    let clean = fly(&model, &[40], &QUIET, &mut normal).records.remove(0);
    let cells: Vec<_> = (0..6).flat_map(|row| (0..4).map(move |scalar| (row, scalar))).collect();
    let gram = |sums: &Sums| -> Vec<f64> {
        cells.iter().flat_map(|&x| cells.iter().map(move |&y| sums.gram(x, y))).collect()
    };
    let exact = gram(&at_truth(&clean, &model, Scalars::Estimated));
    let said = gram(&at_truth(&clean, &model, Scalars::NoisePart));
    const DRAWS: usize = 4000;
    let mut mean = vec![0.0; said.len()];
    for _ in 0..DRAWS {
        let mut channels: Vec<Channel> = clean.channels().to_vec();
        for channel in &mut channels {
            channel.values.iter_mut().for_each(|value| *value += normal.next());
        }
        let noisy = Record::new("noisy", clean.period(), channels).unwrap();
        for (mean, entry) in
            mean.iter_mut().zip(gram(&at_truth(&noisy, &model, Scalars::Estimated)))
        {
            *mean += entry / DRAWS as f64;
        }
    }
    let scale: Vec<f64> = (0..cells.len()).map(|k| exact[k * cells.len() + k].sqrt()).collect();
    let mut largest = 0.0_f64;
    for i in 0..cells.len() {
        for k in 0..cells.len() {
            let at = i * cells.len() + k;
            let (added, size) = (mean[at] - exact[at], scale[i] * scale[k]);
            assert!((added - said[at]).abs() < 0.02 * size, "{:?} {:?}", cells[i], cells[k]);
            largest = largest.max(said[at] / size);
        }
    }
    // The test would pass with nothing said if nothing were added.
    assert!(largest > 0.2, "{largest}");
}

#[test]
fn the_spectrum_of_costs_adds_up() {
    let mut normal = Normal::new(3);
    let model = system(&[Complex::new(0.7, 0.5), Complex::new(0.6, 0.0)], 3, 1, &mut normal);
    // 21 frequencies: two whole groups of lanes and a part of one.
    let record = fly(&model, &[41], &QUIET, &mut normal).records.remove(0);
    let sums = at_truth(&record, &model, Scalars::Estimated);
    let costs = sums.spectrum.clone().unwrap();
    assert_eq!(costs.len(), 21);
    assert!((costs.iter().sum::<f64>() / sums.cost - 1.0).abs() < 1e-12);
}

#[test]
fn a_long_record_has_the_same_sums_on_any_number_of_threads() {
    let mut normal = Normal::new(4);
    let model = system(&[Complex::new(0.7, 0.5), Complex::new(0.6, 0.0)], 3, 1, &mut normal);
    // Two whole shares and a part of one.
    let samples = 5 * SHARE + 7;
    let record = fly(&model, &[samples], &QUIET, &mut normal).records.remove(0);
    let [one, two, three] =
        [1, 2, 3].map(|threads| on_threads(threads, &record, &model, Scalars::Estimated));
    for other in [&two, &three] {
        assert_eq!((&one.real, &one.imaginary), (&other.real, &other.imaginary));
        assert_eq!((&one.descent, &one.score), (&other.descent, &other.score));
        assert_eq!(one.cost.to_bits(), other.cost.to_bits());
        assert_eq!(one.spectrum, other.spectrum);
    }
    let costs = one.spectrum.unwrap();
    assert_eq!(costs.len(), samples.div_ceil(2));
    assert!((costs.iter().sum::<f64>() / one.cost - 1.0).abs() < 1e-12);
}
