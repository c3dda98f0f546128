use num_complex::Complex;

use super::*;
use crate::Offsets;
use crate::likelihood::cost::parameters::Layout;
use crate::likelihood::fixtures::{Disturbance, Normal, fly, system};
use crate::likelihood::search::levenberg_marquardt::SearchStatus;
use crate::likelihood::search::report::SearchReport;
use crate::likelihood::{Noise, identify};
use crate::model::Hold;

/// Starts with the slow mode decaying over a thirtieth of the record.
#[test]
fn slow_modes_are_found_on_the_other_side() {
    let samples = 600;
    let slow = (2.0 / 600.0_f64).exp();
    let eigenvalues = [Complex::new(0.95, 0.17), Complex::new(0.9, 0.0), Complex::new(slow, 0.0)];
    let disturbance = Disturbance { noise: 0.1, offset: 0.0, trend: 0.0, known: 0.0 };
    let (mut higher, mut told) = (0, 0);
    for seed in 1..=12 {
        let mut normal = Normal::new(seed);
        let truth = system(&eigenvalues, 3, 2, &mut normal);
        let flights = fly(&truth, &[samples, samples], &disturbance, &mut normal);
        let mut start = truth.clone();
        let moved = slow_mode_restarts::moved(&truth.a, 600.0);
        for elsewhere in &moved {
            if elsewhere.eigenvalue < 0.96 {
                start.a.clone_from(&elsewhere.a);
            }
        }
        let mut options =
            Options { noise: Noise::Given(flights.levels.clone()), ..Options::default() };
        options.measurement.offsets = Offsets::Zero;
        let moving = identify(&flights.records, std::slice::from_ref(&start), &options).unwrap();
        options.search.max_restarts = 0;
        let still = identify(&flights.records, &[start], &options).unwrap();
        assert_eq!(still.restarts, 0);
        let (with, without) = (moving.chi_squared.value, still.chi_squared.value);
        assert!(with <= without + SAME_OPTIMUM, "seed {seed}: {with} {without}");
        higher += usize::from(with < without - 1.0);
        told += usize::from(moving.restarts > 0);
        assert!(moving.rivals.iter().all(|rival| rival.above >= 0.0 && rival.above < RIVAL));
    }
    assert!(higher > 0 && told >= higher, "{higher} {told}");
}

#[test]
fn a_mode_that_alternates_has_to_be_far_more_likely() {
    let mut normal = Normal::new(3);
    let planted = |last: f64, normal: &mut Normal| {
        system(&[Complex::new(0.9, 0.2), Complex::new(last, 0.0)], 3, 2, normal)
    };
    let disturbance = Disturbance { noise: 0.1, offset: 0.0, trend: 0.0, known: 0.0 };
    let smooth = planted(0.8, &mut normal);
    let flights = fly(&smooth, &[80, 80], &disturbance, &mut normal);
    let layout =
        Layout { order: 3, sensors: 3, records: 2, feedthrough: Vec::new(), hold: Hold::ZeroOrder };
    let options = Options::default();
    let problem =
        Problem::new(layout.clone(), &flights.records, &flights.levels, &options).unwrap();
    let mut candidate = |last: f64, objective: f64| {
        let system = System::scaled(&planted(last, &mut normal), &flights.levels, &layout);
        let search = SearchReport {
            status: SearchStatus::Converged,
            steps: 1,
            evaluations: 1,
            level_updates: 0,
            levels_settled: true,
            remaining_step: 0.0,
        };
        let (evaluation, variances) = (problem.evaluate(system, &[1.0; 3]), vec![1.0; 3]);
        let direction_replaced = vec![false; 2];
        let optimum = LocalOptimum { evaluation, variances, objective, search, direction_replaced };
        Candidate { optimum, start: 0 }
    };
    for (gain, alternates_first) in [(5.0, false), (15.0, true)] {
        let mut optima = Optima::default();
        optima.add(candidate(-0.3, 100.0 - gain));
        optima.add(candidate(0.8, 100.0));
        assert_eq!(optima.0[0].optimum.objective < 99.0, alternates_first);
    }
}
