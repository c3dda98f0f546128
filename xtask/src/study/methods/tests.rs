use super::*;
use crate::study::case::Excitation;

#[test]
fn a_pair_stands_for_two_real_modes() {
    let truth = TrueModes {
        spiral: Complex::new(0.0, 0.0),
        roll: Complex::new(-0.5, 0.0),
        dutch_roll: Complex::new(-0.1, 1.7),
    };
    let values = [Complex::new(-0.25, 0.1), Complex::new(-0.1, 1.6)];
    let found = with_conjugates(&values, &truth).unwrap();
    let [spiral, roll, dutch_roll] = errors(&found, &truth);
    assert!((spiral - 0.25_f64.hypot(0.1)).abs() < 1e-12);
    assert!((roll - 0.25_f64.hypot(0.1)).abs() < 1e-12);
    assert!((dutch_roll - 0.1).abs() < 1e-12);
    assert!(with_conjugates(&values[..1], &truth).is_none());
}

#[test]
fn one_run_reaches_what_the_records_allow() {
    let simulator = Simulator::new().unwrap();
    let case = Case { excitation: Excitation::White, signal_to_noise: 100, seed: 1 };
    let found = run(&simulator, &case).unwrap();
    let fit = found.likelihood.clone().unwrap();
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
    // The bound that the design states, as standard deviations.
    for (variance, expected) in found.bound.iter().zip([2.2e-4, 1.5e-3, 1.1e-3]) {
        assert!((variance.sqrt() / expected - 1.0).abs() < 0.3, "{found:?}");
    }
    assert!(fit.scores.iter().all(|z| z.abs() < 5.0));
    // The same records again give the same.
    assert_eq!(run(&simulator, &case).unwrap(), found);
}

#[test]
fn without_noise_the_printed_method_finds_everything() {
    let simulator = Simulator::new().unwrap();
    let pair = simulator.fly_at(Excitation::White, f64::INFINITY, 1).unwrap();
    let errors = printed_errors(&pair, &simulator.modes()).unwrap();
    assert!(errors.iter().all(|error| *error < 1e-6), "{errors:?}");
}
