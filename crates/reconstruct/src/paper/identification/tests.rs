use lti::SamplePeriod;
use proptest::prelude::*;

use super::*;
use crate::Channel;

/// White noise, the same every time.
fn noise(seed: u64, samples: usize) -> Vec<f64> {
    let mut random = flight::Stream::new(seed, 0);
    (0..samples).map(|_| random.normal()).collect()
}

/// y(k) = sum of h_i x(k - i), for i = -2 .. 2 and samples far from the ends.
fn record(h: [f64; 5], samples: usize) -> Record {
    let x = noise(7, samples + 4);
    let y =
        (0..samples).map(|k| h.iter().enumerate().map(|(i, h)| h * x[k + 4 - i]).sum()).collect();
    let x = x[2..samples + 2].to_vec();
    let period = SamplePeriod::new(0.1).unwrap();
    Record::new("planted", period, vec![Channel::new("x", x), Channel::new("y", y)]).unwrap()
}

#[test]
fn a_noncausal_filter_comes_back() {
    let h = [0.5, -1.0, 2.0, 0.25, -0.125];
    let found = identify_transmissibility(&record(h, 400), 0, 1, &IdentificationOptions::default())
        .unwrap();
    // Compare responses: the model may hold common factors.
    for angle in [0.1, 1.0, 2.5] {
        let z = Complex::from_polar(1.0, angle);
        let expected: Complex<f64> =
            h.iter().zip([2, 1, 0, -1, -2]).map(|(h, power)| z.powi(power) * *h).sum();
        let response = found.transmissibility.to_rational().eval_complex(z);
        assert!((response - expected).norm() < 1e-9, "{response} for {expected}");
    }
}

#[test]
fn what_is_wrong_is_said_with_the_place() {
    let options = IdentificationOptions::default();
    let check = |record: &Record, channels: (usize, usize), expected: &str| {
        let message = identify_transmissibility(record, channels.0, channels.1, &options)
            .unwrap_err()
            .to_string();
        assert!(message.contains(expected), "{message}");
    };
    let good = record([0.0, 0.0, 1.0, 0.0, 0.0], 400);
    check(&good, (0, 2), "2 channel(s), so that there is none of index 2");
    check(
        &record([1.0; 5], 30),
        (0, 1),
        "record \"planted\", transmissibility from \"x\" to \"y\": 30 samples",
    );
    let constant = Record::new(
        "flat",
        good.period(),
        vec![Channel::new("x", vec![3.0; 400]), Channel::new("y", noise(1, 400))],
    );
    check(&constant.unwrap(), (0, 1), "constant");
}

#[test]
fn nothing_is_realised_of_a_zero_output() {
    let record = record([0.0; 5], 400);
    let found =
        identify_transmissibility(&record, 0, 1, &IdentificationOptions::default()).unwrap();
    assert_eq!((found.realization.causal.order, found.realization.anticausal.order), (0, 0));
    assert!(found.transmissibility.numerator().is_zero());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]
    #[test]
    fn finite_values_never_panic(scale in -150i32..150, samples in 1usize..200, seed in any::<u64>()) {
        let factor = 10f64.powi(scale);
        let channel = |name: &str, seed| Channel::new(name, noise(seed, samples).iter().map(|x| x * factor).collect());
        let period = SamplePeriod::new(0.1).unwrap();
        let record = Record::new("any", period, vec![channel("x", seed), channel("y", !seed)]).unwrap();
        let _ = identify_transmissibility(&record, 0, 1, &IdentificationOptions::default());
    }
}
