//! Healthy sensors: as many false alarms as stated.

use monitor::{Options, TestKind};

use crate::flights::{ALL_PAIRS, Excitation, Simulator, channels, detector, part};

/// References, each with a new flight of its own.
const FLIGHTS: u64 = 40;
/// The stated rate.
const RATE: f64 = 0.01;

/// How many of all windows raise an alarm, in total and by each test.
fn false_alarms(
    excitation: Excitation,
    pairs: &[(usize, usize)],
    samples: [usize; 2],
) -> (f64, [f64; 2], f64) {
    let options = Options { window: 50, false_alarms: RATE };
    let simulator = Simulator::new(excitation, 30.0);
    let (mut alarms, mut by_test, mut windows) = (0.0, [0.0; 2], 0.0);
    for seed in 0..FLIGHTS {
        let reference = channels(&simulator.fly(samples[0], 2 * seed));
        let detector = detector(&reference, pairs, options);
        let new = channels(&simulator.fly(samples[1], 2 * seed + 1));
        for window in detector.watch(&[part(&new, 0..samples[1])]).unwrap() {
            windows += 1.0;
            alarms += f64::from(window.alarm().is_some());
            for (test, times) in window.tests.iter().zip(&mut by_test) {
                *times += f64::from(test.is_alarm());
            }
        }
    }
    (alarms, by_test, windows)
}

/// Whether a number of successes lies in the middle 99.9 % of the binomial distribution, whose normal approximation is good from a dozen expected ones on.
fn is_binomial(successes: f64, trials: f64, chance: f64) -> bool {
    let (expected, deviation) = (trials * chance, (trials * chance * (1.0 - chance)).sqrt());
    (successes - expected).abs() < 3.29 * deviation
}

fn check(excitation: Excitation, pairs: &[(usize, usize)], samples: [usize; 2]) {
    let (alarms, by_test, windows) = false_alarms(excitation, pairs, samples);
    assert!(windows > 7_000.0);
    assert!(is_binomial(alarms, windows, RATE), "{excitation:?}: {alarms} of {windows}");
    // The two tests share the rate evenly.
    let each = 1.0 - (1.0 - RATE).sqrt();
    for (kind, times) in TestKind::ALL.iter().zip(by_test) {
        assert!(is_binomial(times, windows, each), "{excitation:?} {kind}: {times} of {windows}");
    }
}

#[test]
fn as_many_as_stated_with_one_pair_and_a_short_reference() {
    // 39 healthy windows.
    check(Excitation::White, &ALL_PAIRS[..1], [4_000, 10_000]);
}

#[test]
fn as_many_as_stated_with_two_pairs() {
    check(Excitation::White, &ALL_PAIRS, [20_000, 10_000]);
}

#[test]
fn as_many_as_stated_whatever_the_colour_of_the_excitation() {
    check(Excitation::Autoregressive, &ALL_PAIRS, [4_000, 10_000]);
    check(Excitation::LowPass, &ALL_PAIRS, [20_000, 10_000]);
}

/// Without one row in fifty of all channels.
fn with_losses(channels: &mut [Vec<f64>], seed: u64) {
    let mut state = seed;
    for k in 1..channels[0].len() - 1 {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        if (state >> 33).is_multiple_of(50) {
            channels.iter_mut().for_each(|channel| channel[k] = f64::NAN);
        }
    }
}

#[test]
fn as_many_as_stated_where_rows_are_missing_and_hardly_a_window_less() {
    let options = Options { window: 50, false_alarms: RATE };
    let simulator = Simulator::new(Excitation::White, 30.0);
    let (mut alarms, mut by_test, mut windows, mut whole) = (0.0, [0; 2], 0.0, 0.0);
    for seed in 0..FLIGHTS {
        let reference = channels(&simulator.fly(20_000, 2 * seed));
        let detector = detector(&reference, &ALL_PAIRS, options);
        let mut new = channels(&simulator.fly(10_000, 2 * seed + 1));
        whole += detector.watch(&[part(&new, 0..10_000)]).unwrap().len() as f64;
        with_losses(&mut new, seed);
        let found = detector.watch(&[part(&new, 0..10_000)]).unwrap();
        windows += found.len() as f64;
        alarms += found.iter().filter(|window| window.alarm().is_some()).count() as f64;
        for (kind, times) in by_test.iter_mut().enumerate() {
            *times += found.iter().filter(|window| window.tests[kind].is_alarm()).count();
        }
    }
    assert!(is_binomial(alarms, windows, RATE), "{alarms} {by_test:?} of {windows}");
    assert!(windows > 0.98 * whole, "{windows} of {whole}");
}
