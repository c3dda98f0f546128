use super::*;
use crate::shared::noisy_flights::Excitation;

#[test]
fn one_run_reaches_what_the_records_allow() {
    let simulator = Simulator::new().unwrap();
    let kind = Kind { excitation: Excitation::White, signal_to_noise: 100 };
    let found = run(&simulator, kind, 1).unwrap();
    let fit = found.likelihood.clone().unwrap().fit;
    assert_eq!(found.order_found, Some(4));
    assert!(fit.converged);
    // 8000 residuals: the deviation of chi-squared per degree of freedom is 0.016.
    assert!((fit.chi_squared - 1.0).abs() < 0.08, "{}", fit.chi_squared);
    for mode in 0..3 {
        let deviation = found.bound[mode].sqrt();
        assert!(fit.errors[mode] < 5.0 * deviation, "{found:?}");
        assert!(found.as_printed.unwrap()[mode] > fit.errors[mode], "{found:?}");
        assert!(found.subspace.unwrap()[mode] < 20.0 * deviation, "{found:?}");
    }
    assert!(fit.scores.iter().all(|z| z.abs() < 5.0));
    // The same records again give the same.
    assert_eq!(run(&simulator, kind, 1).unwrap(), found);
}

#[test]
fn the_bound_is_what_another_program_says() {
    // Deviations of spiral, roll and Dutch roll that a numpy version of the likelihood states for
    // its own noise, at its own estimate: a few per cent off the true system (multistep_snr100 in
    // tests/data/records has the records).
    let simulator = Simulator::new().unwrap();
    let pair = simulator.fly(Excitation::Multistep, 100.0, 1).unwrap();
    let bound = bound(&simulator, &pair).unwrap();
    for (variance, expected) in bound.iter().zip([8.05e-3, 6.36e-3, 3.20e-3]) {
        let ratio = variance.sqrt() / expected;
        assert!((ratio - 1.0).abs() < 0.5, "{bound:?}");
    }
    // Ten times the noise is ten times the deviation as long as it is small.
    let pair = simulator.fly(Excitation::Multistep, 1000.0, 1).unwrap();
    let smaller = super::bound(&simulator, &pair).unwrap();
    for (large, small) in bound.iter().zip(smaller) {
        assert!(((large / small).sqrt() / 10.0 - 1.0).abs() < 0.1, "{bound:?} {smaller:?}");
    }
}

#[test]
fn without_noise_the_printed_method_finds_everything() {
    let simulator = Simulator::new().unwrap();
    let pair = simulator.fly(Excitation::White, f64::INFINITY, 1).unwrap();
    let errors = paper_errors(&pair.records, &simulator.aircraft.modes).unwrap();
    assert!(errors.iter().all(|error| *error < 1e-6), "{errors:?}");
}

#[test]
fn an_input_that_is_not_held_is_found_to_move_on() {
    let simulator = Simulator::new().unwrap();
    let pair = simulator.fly(Excitation::BandLimited, 1000.0, 1).unwrap();
    let (fit, _) = most_likely(&pair.records, &simulator.aircraft.modes).unwrap();
    assert_eq!(fit.hold, Hold::FirstOrder);
    let chi_squared = evaluated(&pair, &fit.model, fit.hold).unwrap().chi_squared;
    let per_degree = chi_squared.per_degree_of_freedom();
    assert!((per_degree - 1.0).abs() < 0.08, "{per_degree}");

    let mut options = Options::default();
    options.order = ORDER;
    options.hold = Some(Hold::ZeroOrder);
    let held = reconstruct::reconstruct(&pair.records, &options).unwrap().fit().unwrap().clone();
    let chi_squared = evaluated(&pair, &held.model, held.hold).unwrap().chi_squared;
    assert!(chi_squared.per_degree_of_freedom() > 1.5, "{chi_squared:?}");
}
