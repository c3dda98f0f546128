use lti::SamplePeriod;
use nalgebra::DMatrix;
use num_complex::Complex;
use poly::{MrootsOptions, Poly, mroots};

use super::{CompositeOptions, CompositeRealization, realize_composite};
use crate::fixtures::matrix;
use crate::{EraError, EraOptions, NoncausalMarkov, Order, OrderReason};

fn period() -> SamplePeriod {
    SamplePeriod::new(0.1).unwrap()
}

fn roots(p: &Poly<f64>) -> Vec<Complex<f64>> {
    mroots(p, &MrootsOptions::default()).unwrap().values()
}

/// Distance of every expected root from the nearest one found, and of every found one from the nearest expected one.
fn distance(found: &[Complex<f64>], expected: &[Complex<f64>]) -> f64 {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    let one_way = |from: &[Complex<f64>], to: &[Complex<f64>]| {
        from.iter()
            .map(|a| to.iter().map(|b| (a - b).norm()).fold(f64::INFINITY, f64::min))
            .fold(0.0, f64::max)
    };
    one_way(found, expected).max(one_way(expected, found))
}

/// Numerators of the paper's aircraft, sampled at 0.1 s, from sideslip and to each rate, per surface; highest power first.
/// Origin: `tests/data/reference.json` of the workspace, `aircraft.as_printed.gamma_*` and `zeros_*`, 60-digit arithmetic.
struct Channel {
    name: &'static str,
    sideslip: [f64; 4],
    rate: [f64; 4],
    zeros: [(f64, f64); 3],
}

const AILERON: [f64; 4] =
    [0.0016846301431633517, -0.0012792818546213062, -0.0018293608429004304, 0.0014295684155943402];
const RUDDER: [f64; 4] =
    [1.0435255518964366, -3.0577891805323882, 2.9862515503840714, -0.9719893917407894];

const CHANNELS: [Channel; 4] = [
    Channel {
        name: "roll rate, aileron",
        sideslip: AILERON,
        rate: [0.6615911761644987, -1.9516212022944015, 1.9356664372154835, -0.6456364110855805],
        zeros: [
            (1.0, 0.0),
            (0.9749450057728314, 0.15926860719208163),
            (0.9749450057728314, -0.15926860719208163),
        ],
    },
    Channel {
        name: "yaw rate, aileron",
        sideslip: AILERON,
        rate: [-0.0319701879950968, 0.09421356115504473, -0.09232748180565993, 0.03022193275054792],
        zeros: [
            (1.1577200425328456, 0.0),
            (0.8945995838115028, -0.1273739279476982),
            (0.8945995838115028, 0.1273739279476982),
        ],
    },
    Channel {
        name: "roll rate, rudder",
        sideslip: RUDDER,
        rate: [-0.15242147920806573, 0.033046535695851344, 0.3858587615793369, -0.2664838180671225],
        zeros: [(-1.7706096168496268, 0.0), (0.9874198450901004, 0.0), (1.0, 0.0)],
    },
    Channel {
        name: "yaw rate, rudder",
        sideslip: RUDDER,
        rate: [-0.01980204807524471, 0.3476956168835465, -0.6237128342003169, 0.29577912896093445],
        zeros: [(0.954512251019331, 0.0), (1.0030517676359492, 0.0), (15.60100444670533, 0.0)],
    },
];

/// `D(q) T(q)` with `D(q) = q * (monic sideslip numerator)`: `h_-4 .. h_-1` are the rate's coefficients over the leading one of
/// the sideslip, all others are zero but for `error`, which is added with alternating pseudo-random signs.
fn window(channel: &Channel, error: f64) -> NoncausalMarkov {
    let mut window = vec![0.0; 51];
    for (k, coefficient) in channel.rate.iter().enumerate() {
        window[21 + k] = coefficient / channel.sideslip[0];
    }
    for (k, value) in window.iter_mut().enumerate() {
        let k = f64::from(u8::try_from(k).unwrap());
        *value += error * (3.0 * k * k + k).sin();
    }
    NoncausalMarkov::from_window(&window, 25).unwrap()
}

fn as_printed(markov: &NoncausalMarkov, noise_floor: Option<f64>) -> CompositeRealization {
    let mut options = EraOptions::with_order(Order::Fixed(6));
    options.noise_floor = noise_floor;
    realize_composite(markov, period(), &CompositeOptions::both(options)).unwrap()
}

#[test]
fn the_aircraft_gives_a_polynomial_with_the_true_zeros() {
    for channel in &CHANNELS {
        // Zero, and rubbish at the rounding level of the largest parameter, as a least-squares fit leaves it.
        let largest =
            channel.rate.iter().fold(0.0_f64, |m, c| m.max((c / channel.sideslip[0]).abs()));
        for error in [0.0, 0.2 * f64::EPSILON * largest] {
            let realization = as_printed(&window(channel, error), None);
            assert_eq!(
                (realization.causal.order, realization.anticausal.order),
                (0, 4),
                "{}",
                channel.name
            );
            let floor = realization.anticausal.floor.value;
            assert_eq!(
                realization.anticausal.reason,
                OrderReason::LimitedByRounding { requested: 6, floor }
            );

            let transfer = realization.transfer_function().unwrap();
            assert_eq!(transfer.anticausal.denominator, [1.0]);
            assert_eq!(transfer.anticausal.dropped.denominator, 4);
            assert!(transfer.anticausal.dropped.largest_denominator < 1e-11);
            assert_eq!(transfer.rational.denominator(), &Poly::constant(1.0));
            let numerator = transfer.rational.numerator();
            assert_eq!(numerator.degree(), Some(4));

            let mut expected: Vec<Complex<f64>> =
                channel.zeros.iter().map(|&(re, im)| Complex::new(re, im)).collect();
            expected.push(Complex::new(0.0, 0.0));
            let error = distance(&roots(numerator), &expected);
            assert!(error < 1e-10, "{}: {error:e}", channel.name);
        }
    }
}

#[test]
fn without_dropping_the_far_poles_would_be_real_and_wrong() {
    // The control of the test above: the eigenvalues of the nilpotent block are not zero.
    let realization = as_printed(&window(&CHANNELS[0], 0.0), None);
    let eigenvalues = realization.anticausal.system.a().complex_eigenvalues();
    let largest = eigenvalues.iter().map(|z| z.norm()).fold(0.0, f64::max);
    assert!(largest > 1e-8, "{largest:e}");
}

#[test]
fn a_stated_noise_keeps_the_errors_of_a_fit_out() {
    for channel in &CHANNELS {
        let markov = window(channel, 1e-9);
        let realization = as_printed(&markov, Some(1e-9));
        assert_eq!(
            (realization.causal.order, realization.anticausal.order),
            (0, 4),
            "{}",
            channel.name
        );
        let transfer = realization.transfer_function().unwrap();
        assert_eq!(transfer.rational.denominator().degree(), Some(0));
        let expected: Vec<Complex<f64>> =
            channel.zeros.iter().map(|&(re, im)| Complex::new(re, im)).collect();
        let found = roots(transfer.rational.numerator());
        for zero in &expected {
            let nearest = found.iter().map(|z| (z - zero).norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-5, "{}: {nearest:e}", channel.name);
        }
        // Without it both halves realize the errors.
        let trusting = as_printed(&markov, None);
        assert_eq!((trusting.causal.order, trusting.anticausal.order), (6, 6));
    }
}

/// The Laurent coefficients of `sum_p 1/(q - p)`, planted pole by pole, but for `h_0`, which is 0.5.
fn two_sided(stable: &[f64], outside: &[f64], count: i32) -> NoncausalMarkov {
    let causal: Vec<f64> = (0..=count)
        .map(|k| if k == 0 { 0.5 } else { stable.iter().map(|p| p.powi(k - 1)).sum() })
        .collect();
    let anticausal: Vec<f64> =
        (1..=count).map(|k| outside.iter().map(|p| -p.powi(-k - 1)).sum()).collect();
    NoncausalMarkov::siso(&anticausal, &causal).unwrap()
}

#[test]
fn poles_on_both_sides_of_the_circle_are_recovered() {
    // 1/(q - p) = -sum_(k>=0) p^(-k-1) q^k outside; its constant term -1/p belongs to h_0.
    let (stable, outside) = ([0.5, -0.8], [2.0, -1.25, 10.0]);
    let markov = two_sided(&stable, &outside, 25);
    let realization = realize_composite(&markov, period(), &CompositeOptions::default()).unwrap();
    assert_eq!((realization.causal.order, realization.anticausal.order), (2, 3));
    let transfer = realization.transfer_function().unwrap();
    let expected: Vec<Complex<f64>> =
        stable.iter().chain(&outside).map(|&p| Complex::new(p, 0.0)).collect();
    let error = distance(&roots(transfer.rational.denominator()), &expected);
    assert!(error < 1e-10, "{error:e}");
    // The value at a point of the unit circle, summed pole by pole.
    let z = Complex::from_polar(1.0, 0.7);
    let constants: f64 = outside.iter().map(|p| 1.0 / p).sum();
    let value: Complex<f64> =
        stable.iter().chain(&outside).map(|p| (z - p).inv()).sum::<Complex<f64>>()
            + 0.5
            + constants;
    assert!((transfer.rational.eval_complex(z) - value).norm() < 1e-11);
}

#[test]
fn a_causal_finite_sequence_has_its_poles_at_zero() {
    // 1 + 2/q + 3/q^2 = (q^2 + 2 q + 3) / q^2.
    let mut causal = vec![1.0, 2.0, 3.0];
    causal.resize(12, 0.0);
    let markov = NoncausalMarkov::siso(&[], &causal).unwrap();
    let realization = realize_composite(&markov, period(), &CompositeOptions::default()).unwrap();
    assert_eq!(realization.anticausal.reason, OrderReason::NoParameters);
    let transfer = realization.transfer_function().unwrap();
    assert_eq!(transfer.causal.dropped.denominator, 2);
    assert_eq!(transfer.rational.denominator(), &Poly::monomial(1.0, 2));
    for (ours, expected) in transfer.rational.numerator().descending().iter().zip([1.0, 2.0, 3.0]) {
        assert!((ours - expected).abs() < 1e-13);
    }
}

#[test]
fn a_finite_part_times_a_pole_keeps_the_pole() {
    // Anticausal (q + q^2) / (1 - q/4): h_-1 = 1, h_-2 = 5/4, then a quarter each. Order 2, one eigenvalue w = 0.
    let mut anticausal = vec![1.0, 1.25];
    for _ in 0..18 {
        anticausal.push(anticausal.last().unwrap() / 4.0);
    }
    let markov = NoncausalMarkov::siso(&anticausal, &[0.0]).unwrap();
    let realization = realize_composite(&markov, period(), &CompositeOptions::default()).unwrap();
    assert_eq!(realization.anticausal.order, 2);
    let transfer = realization.transfer_function().unwrap();
    assert_eq!(transfer.anticausal.dropped.denominator, 1);
    assert!(distance(&roots(transfer.rational.denominator()), &[Complex::new(4.0, 0.0)]) < 1e-12);
    let zeros = [Complex::new(0.0, 0.0), Complex::new(-1.0, 0.0)];
    assert!(distance(&roots(transfer.rational.numerator()), &zeros) < 1e-12);
}

#[test]
fn a_gain_alone_and_nothing_at_all() {
    let gain = NoncausalMarkov::siso(&[], &[2.5]).unwrap();
    let transfer = realize_composite(&gain, period(), &CompositeOptions::default())
        .unwrap()
        .transfer_function()
        .unwrap();
    assert_eq!(transfer.rational.numerator(), &Poly::constant(2.5));

    let zero = NoncausalMarkov::siso(&[0.0; 4], &[0.0; 4]).unwrap();
    let transfer = realize_composite(&zero, period(), &CompositeOptions::default())
        .unwrap()
        .transfer_function()
        .unwrap();
    assert!(transfer.rational.is_zero());
}

#[test]
fn several_channels_realize_but_have_no_scalar_transfer_function() {
    let shape = |k: i32| matrix(&[[0.5_f64.powi(k), 0.25_f64.powi(k)]]);
    let causal: Vec<DMatrix<f64>> = (0..12).map(shape).collect();
    let anticausal: Vec<DMatrix<f64>> = (1..12).map(shape).collect();
    let markov = NoncausalMarkov::new(anticausal, causal).unwrap();
    let realization = realize_composite(&markov, period(), &CompositeOptions::default()).unwrap();
    assert_eq!((realization.causal.order, realization.anticausal.order), (2, 2));
    assert_eq!(
        realization.transfer_function().err(),
        Some(EraError::NotScalar { outputs: 1, inputs: 2 })
    );
}

#[test]
fn one_anticausal_parameter_is_too_few() {
    let markov = NoncausalMarkov::siso(&[1.0], &[1.0]).unwrap();
    let refused = realize_composite(&markov, period(), &CompositeOptions::default()).err();
    assert_eq!(refused, Some(EraError::TooFewMarkovParameters { found: 1, needed: 2 }));
}

#[test]
fn the_difference_of_two_transmissibilities_has_the_aircraft_s_eigenvalues() {
    // T_a - T_r for each rate; the zeros are the eigenvalues of A after sampling and the invariant zeros.
    // Origin as above, `mroots_det_Delta_*` and `spec_Ad`. The tolerance is what one rounding of every coefficient does to the
    // root near 1, eps sum |c_k| / |p'|: the roll rate has a zero at 1 exactly, 1.6e-4 from it.
    let eigenvalues = [
        (0.9469052112129244, 0.0),
        (0.9998436484022597, 0.0),
        (0.9787910820433616, -0.16717777123296856),
        (0.9787910820433616, 0.16717777123296856),
    ];
    for (aileron, rudder, tolerance) in
        [(&CHANNELS[0], &CHANNELS[2], 2e-6), (&CHANNELS[1], &CHANNELS[3], 4e-9)]
    {
        let over = |channel: &Channel| Poly::from_descending(&channel.sideslip);
        let realized = |channel: &Channel| {
            let transfer = as_printed(&window(channel, 0.0), None).transfer_function().unwrap();
            transfer.rational.numerator().scale(&channel.sideslip[0])
        };
        let difference = realized(aileron) * over(rudder) - realized(rudder) * over(aileron);
        let found = roots(&difference);
        for (re, im) in eigenvalues {
            let nearest = found
                .iter()
                .map(|z| (z - Complex::new(re, im)).norm())
                .fold(f64::INFINITY, f64::min);
            assert!(nearest < tolerance, "{re} {im}: {nearest:e}");
        }
    }
}
