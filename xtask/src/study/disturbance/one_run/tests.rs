use super::*;
use crate::study::disturbance::Excitation;

fn outcome(gust_percent: u32) -> Outcome {
    let simulator = Simulator::new().unwrap();
    run(&simulator, Kind { excitation: Excitation::Autoregressive, gust_percent }, 1).unwrap()
}

#[test]
fn in_still_air_a_quiet_record_changes_little() {
    let found = outcome(0);
    for fit in [found.alone.likelihood, found.quiet.likelihood, found.true_spectrum] {
        let fit = fit.unwrap().fit;
        // 7200 residuals: the deviation of chi-squared per degree of freedom is 0.017.
        assert!((fit.chi_squared - 1.0).abs() < 0.1, "{}", fit.chi_squared);
        for mode in 0..3 {
            assert!(fit.errors[mode] < 5.0 * found.bound[mode].sqrt(), "{fit:?}");
        }
    }
}

#[test]
fn in_rough_air_it_is_what_makes_the_fit_good() {
    let found = outcome(30);
    let (alone, quiet) = (found.alone.likelihood.unwrap(), found.quiet.likelihood.unwrap());
    assert!(alone.fit.chi_squared > 10.0, "{}", alone.fit.chi_squared);
    assert!((0.8..1.5).contains(&quiet.fit.chi_squared), "{}", quiet.fit.chi_squared);
    assert!(alone.doubts.iter().any(|doubt| doubt == "LargeModelError"), "{:?}", alone.doubts);
    assert!(found.true_spectrum.unwrap().fit.chi_squared < 1.3);
    assert!(quiet.fit.errors[2] < alone.fit.errors[2], "{quiet:?} {alone:?}");
}

#[test]
fn doubts_go_by_their_names() {
    let doubts = [
        Doubt::Likelihood(likelihood::Doubt::LevelsNotSettled { updates: 3 }),
        Doubt::Subspace(reconstruct::subspace::Doubt::NoExcitation { record: "a".to_owned() }),
        Doubt::Likelihood(likelihood::Doubt::LevelsNotSettled { updates: 4 }),
    ];
    assert_eq!(doubt_names(&doubts), ["LevelsNotSettled", "NoExcitation"]);
}
