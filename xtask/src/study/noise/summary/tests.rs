use super::*;
use crate::shared::noisy_flights::Excitation;
use crate::study::fit::{JudgedFit, LOST};
use crate::study::noise::one_run::Likelihood;

const KIND: Kind = Kind { excitation: Excitation::White, signal_to_noise: 100 };

fn likelihood(error: f64, chi_squared: f64) -> Likelihood {
    Likelihood {
        fit: JudgedFit {
            errors: [error, 2.0 * error, 3.0 * error],
            scores: [1.0, -2.0, 3.0, -4.0],
            covered: [true, error < 2.0, false],
            chi_squared,
            converged: error < 2.0,
        },
        missed: error > 3.0,
    }
}

fn outcome(seed: u32, likelihood: Option<Likelihood>) -> Outcome {
    Outcome {
        as_printed: None,
        subspace: likelihood.as_ref().map(|found| found.fit.errors.map(|error| 10.0 * error)),
        order_found: Some(if seed == 2 { 5 } else { 4 }),
        likelihood,
        bound: [1.0, 4.0, f64::from(seed)],
    }
}

#[test]
fn a_kind_is_summed_up() {
    // One run is far off and one fails.
    let likelihoods = [Some(likelihood(7.0, 1.2)), None, Some(likelihood(1.0, 1.0))];
    let outcomes: Vec<Outcome> =
        (1..).zip(likelihoods).map(|(seed, found)| outcome(seed, found)).collect();
    let found = Summary::of(KIND, &outcomes);
    assert_eq!((found.kind, found.runs), (KIND, 3));
    assert_eq!(found.methods[0], MethodSummary { rms: None, median: None, failed: 3 });
    // Errors 7 and 1: their mean square is 25.
    let close = |found: PerMode, expected: PerMode| {
        found.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-12)
    };
    assert!(close(found.methods[2].rms.unwrap(), [5.0, 10.0, 15.0]));
    assert!(close(found.methods[2].median.unwrap(), [4.0, 8.0, 12.0]));
    assert!(close(found.methods[1].rms.unwrap(), [50.0, 100.0, 150.0]));
    assert_eq!(found.methods[2].failed, 1);
    // Seeds 1, 2, 3: the mean variance of the Dutch roll is 2.
    assert!(close(found.bound, [1.0, 2.0, 2.0_f64.sqrt()]));
    assert!(close(found.ratio().unwrap(), [5.0, 5.0, 15.0 / 2.0_f64.sqrt()]));
    assert!(close(found.fits.score_deviation(), [1.0, 2.0, 12.5_f64.sqrt()]));
    assert!(close(found.fits.coverage, [1.0, 0.5, 0.0]));
    assert_eq!((found.bad_fits, found.fits.unconverged, found.missed), (1, 1, 1));
    assert_eq!(found.right_order, 2);
}

#[test]
fn an_unknown_fit_is_a_bad_one() {
    let found = Summary::of(KIND, &[outcome(1, Some(likelihood(1.0, f64::NAN)))]);
    assert_eq!(found.bad_fits, 1);
}

#[test]
fn a_lost_mode_is_counted_apart() {
    let mut lost = likelihood(1.0, 1.0);
    lost.fit.scores[3] = LOST;
    let mut outcomes: Vec<Outcome> =
        (1..=17).map(|seed| outcome(seed, Some(likelihood(1.0, 1.0)))).collect();
    outcomes[5] = outcome(6, Some(lost));
    let found = Summary::of(KIND, &outcomes);
    assert_eq!((found.runs, found.fits.lost, found.fits.scores[2].len()), (17, 1, 33));
    assert!(found.fits.score_deviation()[2] < 4.0);
}
