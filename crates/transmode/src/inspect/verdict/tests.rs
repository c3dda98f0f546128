use super::super::signal::Signal;
use super::*;

fn judged(columns: &[(&str, &[f64], Option<&'static str>)]) -> Vec<Option<Verdict>> {
    let mut channels: Vec<Channel> = columns
        .iter()
        .map(|(name, values, si)| Channel {
            name: (*name).to_owned(),
            unit: None,
            si: *si,
            signal: Signal::of(values),
            verdict: None,
        })
        .collect();
    let values: Vec<&[f64]> = columns.iter().map(|(_, values, _)| *values).collect();
    judge(&mut channels, &values, Some(0.1));
    channels.into_iter().map(|channel| channel.verdict).collect()
}

#[test]
fn each_column_is_called_what_it_is() {
    let mut random = flight::Stream::new(4, 0);
    let time: Vec<f64> = (0..800).map(|k| 0.1 * f64::from(k)).collect();
    let noise = |random: &mut flight::Stream| 0.002 * random.normal();
    let phi: Vec<f64> = time.iter().map(|t| (0.9 * t).sin() + noise(&mut random)).collect();
    let p: Vec<f64> = time.iter().map(|t| 0.9 * (0.9 * t).cos() + noise(&mut random)).collect();
    let r: Vec<f64> = time.iter().map(|t| (0.7 * t + 1.0).sin() + noise(&mut random)).collect();
    let degrees: Vec<f64> = r.iter().map(|r| r.to_degrees()).collect();
    let held: Vec<f64> = (0..800).map(|k| phi[k / 5 * 5] + r[k / 5 * 5]).collect();
    let heading: Vec<f64> = time.iter().map(|t| (12.0 * t).rem_euclid(360.0)).collect();
    let count: Vec<f64> = (0..800).map(|k| f64::from(k % 256)).collect();
    let found = judged(&[
        ("phi", &phi, Some("rad")),
        ("p", &p, Some("rad/s")),
        ("r", &r, None),
        ("r_deg", &degrees, None),
        ("held", &held, None),
        ("heading", &heading, None),
        ("count", &count, None),
        ("dead", &[7.0; 800], None),
    ]);
    assert_eq!(found[0], None);
    let Some(Verdict::Derivative { of, factor }) = &found[1] else { panic!("{:?}", found[1]) };
    assert!(of == "phi" && (factor - 1.0).abs() < 0.01, "{of} {factor}");
    assert_eq!(found[2], None);
    let Some(Verdict::Copy { of, factor }) = &found[3] else { panic!("{:?}", found[3]) };
    assert!(of == "r" && (factor - 57.29578).abs() < 1e-4, "{of} {factor}");
    assert_eq!(found[4], Some(Verdict::Held { rows: 5 }));
    // It goes up by equal steps, and jumps back by a turn.
    assert_eq!(found[5], Some(Verdict::Wraps { turn: 360.0 }));
    assert_eq!(found[6], Some(Verdict::Counter));
    assert_eq!(found[7], Some(Verdict::Constant));
}

#[test]
fn independent_signals_are_nothing_but_signals() {
    let mut random = flight::Stream::new(8, 0);
    let mut noise = || (0..500).map(|_| random.normal()).collect::<Vec<f64>>();
    let (a, b, c) = (noise(), noise(), noise());
    assert_eq!(judged(&[("a", &a, None), ("b", &b, None), ("c", &c, None)]), [None, None, None]);
}
