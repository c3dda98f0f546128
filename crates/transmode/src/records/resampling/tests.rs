use super::*;

/// Slow motion, with an offset.
fn signal(time: f64) -> f64 {
    3.0 + (1.3 * time).sin() + 0.5 * (0.4 * time + 1.0).cos()
}

fn uneven(count: usize) -> Vec<f64> {
    let mut random = flight::Stream::new(11, 0);
    let mut time = 7.0;
    (0..count)
        .map(|_| {
            time += 0.1 * (1.0 + 0.3 * random.normal()).clamp(0.3, 2.0);
            time
        })
        .collect()
}

/// The largest error but for the ends.
fn error(found: &Resampled, channel: usize, period_s: f64) -> f64 {
    let values = &found.values[channel];
    let inside = 20..values.len() - 20;
    let at = |k: usize| found.start_s + k as f64 * period_s;
    inside.map(|k| (values[k] - signal(at(k))).abs()).fold(0.0, f64::max)
}

#[test]
fn uneven_samples_of_slow_motion_come_out_exact() {
    let time = uneven(1000);
    let values: Vec<f64> = time.iter().map(|time| signal(*time)).collect();
    for period_s in [0.05, 0.1, 0.2] {
        let found = resample(&time, &[&values], period_s).expect("long enough");
        assert!(error(&found, 0, period_s) < 1e-4, "{period_s}: {}", error(&found, 0, period_s));
    }
}

#[test]
fn channels_of_other_rates_are_joined() {
    let time: Vec<f64> = (0..2000).map(|k| 0.02 * f64::from(k)).collect();
    let fast: Vec<f64> = time.iter().map(|time| signal(*time)).collect();
    // Every fifth row, empty cells or the value held in between.
    let empty: Vec<f64> =
        fast.iter().enumerate().map(|(k, x)| if k % 5 == 2 { *x } else { f64::NAN }).collect();
    let held: Vec<f64> = (0..2000).map(|k| fast[k / 5 * 5]).collect();
    let found = resample(&time, &[&fast, &empty, &held], 0.04).expect("long enough");
    for channel in 0..3 {
        assert!(error(&found, channel, 0.04) < 1e-3, "{channel}: {}", error(&found, channel, 0.04));
    }
    assert!((found.start_s - 0.04).abs() < 1e-12);
}

#[test]
fn fast_content_does_not_fold_back() {
    let time: Vec<f64> = (0..4000).map(|k| 0.01 * f64::from(k)).collect();
    // 9 Hz is beyond half of 10 Hz, and would come back as 1 Hz.
    let values: Vec<f64> = time.iter().map(|time| (2.0 * PI * 9.0 * time).sin()).collect();
    let found = resample(&time, &[&values], 0.1).expect("long enough");
    let inside = &found.values[0][20..found.values[0].len() - 20];
    assert!(inside.iter().all(|value| value.abs() < 1e-3));
}

#[test]
fn holes_stay_holes() {
    let time: Vec<f64> =
        (0..1000).map(|k| 0.1 * f64::from(k)).filter(|time| !(30.0..40.0).contains(time)).collect();
    let values: Vec<f64> = time.iter().map(|time| signal(*time)).collect();
    let found = resample(&time, &[&values], 0.1).expect("long enough");
    let missing = found.values[0].iter().filter(|value| value.is_nan()).count();
    assert!((98..=101).contains(&missing), "{missing}");
    assert!(resample(&time, &[&values], 1e3).is_none());
    assert!(resample(&time, &[&[f64::NAN; 900]], 0.1).is_none());
}
