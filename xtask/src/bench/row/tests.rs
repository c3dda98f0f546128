use super::*;

#[test]
fn a_verdict_follows_from_the_figure() {
    for (asked, reached, verdict) in [
        (Asked::AtLeast(40.0), 40.0, "yes"),
        (Asked::AtLeast(40.0), 39.9, "**no**"),
        (Asked::AtMost(1e-9), 1e-10, "yes"),
        (Asked::AtMost(1e-9), 2e-9, "**no**"),
        (Asked::Within(0.95, 1.05), 1.0, "yes"),
        (Asked::Within(0.95, 1.05), 1.06, "**no**"),
        // What is no number reaches nothing.
        (Asked::AtLeast(0.0), f64::NAN, "**no**"),
        (Asked::AtMost(1.0), f64::NAN, "**no**"),
    ] {
        assert_eq!(Row::new("x", asked, reached, small).verdict, verdict, "{asked:?} {reached}");
    }
}

#[test]
fn a_speedup_is_their_time_over_ours() {
    let timing = |seconds| Timing::new(vec![seconds]).unwrap();
    let peer = Answer::Measured { timing: timing(2.4), theta: vec![], warning: 0 };
    let row = Row::speedup("x", 40.0, &peer, &timing(0.05));
    assert_eq!(
        (row.asked.as_str(), row.reached.as_str(), row.verdict),
        ("at least 40.0 x", "48.0 x", "yes")
    );

    let none = Answer::Unavailable("no numpy".to_owned());
    let row = Row::speedup("x", 40.0, &none, &timing(0.05));
    assert_eq!((row.reached.as_str(), row.verdict), ("no numpy", "not measured"));
}
