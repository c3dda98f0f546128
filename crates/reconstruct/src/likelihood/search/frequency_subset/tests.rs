use num_complex::Complex;

use super::*;
use crate::likelihood::cost::parameters::{Layout, System};
use crate::likelihood::fixtures::{Disturbance, Normal, fly, system};
use crate::likelihood::options::Options;
use crate::model::Hold;

fn problem(samples: usize) -> (Problem, System) {
    let mut normal = Normal::new(3);
    let eigenvalues = [Complex::new(0.9, 0.3), Complex::new(0.999, 0.0)];
    let model = system(&eigenvalues, 3, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.05, offset: 0.0, trend: 0.0, known: 0.0 };
    let flights = fly(&model, &[samples, samples], &disturbance, &mut normal);
    let layout =
        Layout { order: 3, sensors: 3, records: 2, feedthrough: Vec::new(), hold: Hold::ZeroOrder };
    let truth = System::scaled(&model, &flights.levels, &layout).normalised();
    let problem =
        Problem::new(layout, &flights.records, &flights.levels, &Options::default()).unwrap();
    (problem, truth)
}

#[test]
fn short_records_keep_all_frequencies() {
    assert!(frequency_subset(&problem(800).0).is_none());
}

#[test]
fn the_lowest_frequencies_stay_and_the_sum_of_weights_too() {
    let (full, _) = problem(20_000);
    let thin = frequency_subset(&full).unwrap();
    for (thin, full) in thin.problem.spectra.iter().zip(&full.spectra) {
        assert_eq!(thin.frequencies(), 800);
        assert_eq!((&thin.z[..200], &thin.weight[..200]), (&full.z[..200], &full.weight[..200]));
        assert_eq!(&thin.y[..600], &full.y[..600]);
        let (less, all): (f64, f64) = (thin.weight.iter().sum(), full.weight.iter().sum());
        assert!((less - all).abs() < 10.0, "{less} {all}");
        assert!(thin.z.windows(2).all(|pair| pair[0].arg() < pair[1].arg()));
    }
    assert!((thin.largest_weight - 9801.0 / 600.0).abs() < 1e-12);
}

#[test]
fn the_cost_keeps_its_scale() {
    let (full, truth) = problem(4000);
    let thin = frequency_subset(&full).unwrap();
    let cost = |problem: &Problem| {
        let at = problem.evaluate_around(truth.clone(), problem.no_coefficients(), &[1.0; 3]);
        problem
            .evaluate_around(
                truth.clone(),
                at.coefficients_after(
                    &nalgebra::DVector::zeros(problem.layout.parameters()),
                    &problem.layout,
                ),
                &[1.0; 3],
            )
            .cost
    };
    let (less, all) = (cost(&thin.problem), cost(&full));
    // At the true system both are chi-squared of 8000 degrees of freedom, the thin one with a larger variance.
    assert!((less / all - 1.0).abs() < 0.15, "{less} {all}");
}
