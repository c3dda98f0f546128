use lti::SamplePeriod;
use reconstruct::Channel as Sensor;

use super::*;

/// A signal that nothing is wrong with.
fn sensor(k: usize, phase: f64) -> f64 {
    let t = k as f64;
    (0.37 * t + phase).sin()
        + 0.4 * (0.113 * t * (1.0 + phase)).cos()
        + 1e-3 * ((t * t * 0.618_033_988_75 + phase).fract() - 0.5)
}

/// What is said of one column beside one that is in order, in a record of 400 samples every 0.1 s that starts at 100 s.
fn said(values: impl Fn(usize) -> f64) -> Vec<(&'static str, String)> {
    let good = Sensor::new("beta", (0..400).map(|k| sensor(k, 0.0)).collect());
    let other = Sensor::new("p", (0..400).map(values).collect());
    let period = SamplePeriod::new(0.1).unwrap();
    let record = Record::with_missing("a.csv", period, vec![good, other]).unwrap();
    let found = causes(&record, &[Some("rad"), Some("rad")], 100.0);
    assert!(found.iter().all(|cause| cause.column == "p" && cause.record == "a.csv"), "{found:?}");
    found.into_iter().map(|cause| (cause.code, cause.text)).collect()
}

#[test]
fn each_oddity_has_its_sentence() {
    assert_eq!(said(|k| sensor(k, 1.0)), []);
    let check = |values: &dyn Fn(usize) -> f64, code: &str, text: &str| {
        let found = said(values);
        assert!(found.iter().any(|(own, said)| *own == code && said == text), "{found:?}");
    };
    check(&|_| 3.0, "dead", "p is constant in a.csv");
    check(&|k| k as f64, "counter", "p counts up evenly, as no sensor does, in a.csv");
    check(
        &|k| sensor(k / 5 * 5, 1.0),
        "held",
        "p holds each value for 5 rows, as a sensor of a lower rate does (--resample), in a.csv",
    );
    check(&|k| 57.3 * sensor(k, 0.0), "duplicate", "p is 57.3 times beta in a.csv");
    let turn = std::f64::consts::TAU;
    check(
        &|k| (0.2 * k as f64).rem_euclid(turn) + 1e-3 * sensor(k, 1.0),
        "wraps",
        "p jumps by a turn of 6.283 (--unwrap) in a.csv",
    );
    check(
        &|k| if (120..160).contains(&k) { 0.25 } else { sensor(k, 1.0) },
        "stuck",
        "p stands still for 40 samples from 112 s on in a.csv",
    );
    check(
        &|k| sensor(k, 1.0) + if k == 200 { 50.0 } else { 0.0 },
        "outliers",
        "p has 1 outlier in a.csv",
    );
    let cut = said(|k| sensor(k, 1.0).clamp(-0.7, 0.9));
    let (_, text) = cut.iter().find(|(code, _)| *code == "saturated").unwrap();
    assert!(text.starts_with("p is cut off at 0.9 and -0.7 in "), "{text}");
    assert!(text.ends_with(" % of its samples in a.csv"), "{text}");
    // The rate of change of beta by central differences.
    let rate = said(|k| (sensor(k + 1, 0.0) - sensor(k.max(1) - 1, 0.0)) / 0.2);
    assert_eq!(rate[0].0, "derivative");
}
