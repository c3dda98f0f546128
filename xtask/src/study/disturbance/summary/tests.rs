use super::*;
use crate::study::disturbance::Excitation;
use crate::study::fit::JudgedFit;

const SIZES: PerMode = [0.001, 0.5, 2.0];

fn fit(roll: f64, doubts: &[&str]) -> Likelihood {
    Likelihood {
        fit: JudgedFit {
            errors: [1.0, roll, 0.1],
            scores: [1.0, -2.0, 3.0, -3.0],
            covered: [true, roll < 0.05, false],
            chi_squared: 1.0 + roll,
            converged: roll < 0.05,
        },
        doubts: doubts.iter().map(|doubt| (*doubt).to_owned()).collect(),
    }
}

fn outcome(quiet: Option<Likelihood>, missed: f64) -> Outcome {
    let none = Both { subspace: None, likelihood: None };
    Outcome {
        alone: none.clone(),
        quiet: Both { likelihood: quiet, ..none },
        true_start: Some(fit(0.01, &[])),
        true_spectrum: None,
        inputs_known: Some([1.0, 2.0, 3.0]),
        bound: [1.0, 4.0, 9.0],
        lags: 3,
        missed: Some(missed),
    }
}

fn gathered() -> Summary {
    let runs = [
        outcome(Some(fit(0.04, &["WeakOrder"])), 0.0),
        outcome(Some(fit(0.06, &["WeakOrder", "PoorFit"])), 7.0),
        outcome(Some(fit(0.07, &[])), 0.2),
        outcome(None, -3.0),
    ];
    Summary::of(Kind { excitation: Excitation::Multisteps, gust_percent: 30 }, &runs, SIZES)
}

#[test]
fn results_that_are_wrong_are_told_from_those_that_say_so() {
    let found = gathered();
    let [_, alone, _, quiet] = &found.trust;
    assert_eq!(alone.results, 0);
    // A tenth of 0.5 is 0.05; that of the Dutch roll, 0.2, is never reached, and the spiral does
    // not count.
    assert_eq!((quiet.results, quiet.doubted), (3, 2));
    assert_eq!((quiet.wrong, quiet.wrong_and_not_doubted), (2, 1));
    let doubts: Vec<_> = quiet.doubts.iter().map(|(doubt, runs)| (doubt.as_str(), *runs)).collect();
    assert_eq!(doubts, [("PoorFit", 1), ("WeakOrder", 2)]);
    assert_eq!(found.missed, 2);
}

#[test]
fn a_kind_is_summed_up() {
    let found = gathered();
    let close = |x: f64, y: f64| assert!((x - y).abs() < 1e-12, "{x} {y}");
    assert_eq!((found.kind.gust_percent, found.runs), (30, 4));
    assert_eq!((found.errors[0].failed, found.errors[3].failed), (4, 1));
    close(found.errors[3].median.unwrap()[1], 0.06);
    close(found.errors[6].rms.unwrap()[2], 3.0);
    close(found.bound[2], 3.0);
    let quiet = &found.fits[1];
    close(median(&quiet.chi_squared), 1.06);
    close(quiet.coverage[1], 1.0 / 3.0);
    close(quiet.score_deviation()[2], 3.0);
    assert_eq!(quiet.unconverged, 2);
    close(found.fits[2].coverage[1], 1.0);
}
