use super::*;
use crate::study::noise::case::{Case, cases};
use crate::study::noise::outcome::Likelihood;
use crate::study::runs::Kept;

fn fit(error: f64, chi_squared: f64) -> Likelihood {
    Likelihood {
        errors: [error, 2.0 * error, 3.0 * error],
        scores: [1.0, -2.0, 3.0, -4.0],
        covered: [true, error < 2.0, false],
        chi_squared,
        converged: error < 2.0,
        missed: error > 3.0,
    }
}

fn outcome(case: Case, likelihood: Option<Likelihood>) -> Outcome {
    Outcome {
        edition: Outcome::EDITION,
        case,
        as_printed: None,
        subspace: likelihood.as_ref().map(|fit| fit.errors.map(|error| 10.0 * error)),
        order_found: Some(if case.seed == 2 { 5 } else { 4 }),
        likelihood,
        bound: [1.0, 4.0, case.seed as f64],
    }
}

#[test]
fn a_kind_is_summed_up() {
    let kind = |case: &Case| case.excitation == Excitation::White && case.signal_to_noise > 10;
    let mut chosen: Vec<Case> = cases(3).into_iter().filter(kind).collect();
    chosen.sort();
    let mut outcomes: Vec<Outcome> =
        chosen.iter().map(|case| outcome(*case, Some(fit(1.0, 1.0)))).collect();
    // Of the second kind one run is far off and one fails.
    outcomes[3] = outcome(chosen[3], Some(fit(7.0, 1.2)));
    outcomes[4] = outcome(chosen[4], None);
    let found = summaries(&outcomes);
    assert_eq!(found.len(), 3);
    let second = &found[1];
    assert_eq!((second.kind, second.runs), ((Excitation::White, 100), 3));
    assert_eq!(second.methods[0], MethodSummary { rms: None, median: None, failed: 3 });
    // Errors 7 and 1: their mean square is 25.
    let close = |found: PerMode, expected: PerMode| {
        found.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-12)
    };
    assert!(close(second.methods[2].rms.unwrap(), [5.0, 10.0, 15.0]));
    assert!(close(second.methods[2].median.unwrap(), [4.0, 8.0, 12.0]));
    assert!(close(second.methods[1].rms.unwrap(), [50.0, 100.0, 150.0]));
    assert_eq!(second.methods[2].failed, 1);
    // Seeds 1, 2, 3: the mean variance of the Dutch roll is 2.
    assert!(close(second.bound, [1.0, 2.0, 2.0_f64.sqrt()]));
    assert!(close(second.ratio().unwrap(), [5.0, 5.0, 15.0 / 2.0_f64.sqrt()]));
    assert!(close(second.score_deviation(), [1.0, 2.0, 12.5_f64.sqrt()]));
    assert!(close(second.coverage, [1.0, 0.5, 0.0]));
    assert_eq!((second.bad_fits, second.unconverged, second.missed), (1, 1, 1));
    assert_eq!(second.right_order, 2);
    assert_eq!((found[0].bad_fits, found[0].right_order), (0, 2));
}

#[test]
fn an_unknown_fit_is_a_bad_one() {
    let case = cases(1)[0];
    let found = summaries(&[outcome(case, Some(fit(1.0, f64::NAN)))]);
    assert_eq!(found[0].bad_fits, 1);
}

#[test]
fn a_lost_mode_is_counted_apart() {
    let mut lost = fit(1.0, 1.0);
    lost.scores[3] = LOST;
    let chosen = &cases(17)[..];
    let kind = |case: &&Case| case.excitation == Excitation::White && case.signal_to_noise == 10;
    let mut outcomes: Vec<Outcome> =
        chosen.iter().filter(kind).map(|case| outcome(*case, Some(fit(1.0, 1.0)))).collect();
    outcomes[5] = outcome(outcomes[5].case, Some(lost));
    let found = &summaries(&outcomes)[0];
    assert_eq!((found.runs, found.lost, found.scores[2].len()), (17, 1, 33));
    assert!(found.score_deviation()[2] < 4.0);
}
