use super::*;

fn stamps(count: u32, period_s: f64, stamp: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..count).map(|k| stamp(3.2 + f64::from(k) * period_s)).collect()
}

fn rounded(scale: f64) -> impl Fn(f64) -> f64 {
    move |time| (time * scale).round() / scale
}

fn found(time_s: &[f64]) -> ClockFit {
    fit(time_s).expect("even rows")
}

#[test]
fn rounded_stamps_give_the_rate_behind_them() {
    for (rate, scale) in [(60.0, 1e3), (30.0, 1e4), (128.0, 1e3), (700.0, 1e3), (10.0, 1.0)] {
        let fit = found(&stamps(1200, 1.0 / rate, rounded(scale)));
        assert_eq!(fit.period_s.to_bits(), (1.0_f64 / rate).to_bits(), "{rate} Hz: {fit:?}");
        assert_eq!(fit.assumed, Assumed::Rounded { resolution_s: 1.0 / scale });
        assert!(fit.largest_deviation_s <= 0.6 / scale, "{fit:?}");
        assert!(fit.after_gaps.is_empty());
    }
    // Cut off instead of rounded.
    let fit = found(&stamps(700, 0.1, f64::floor));
    assert_eq!(fit.period_s.to_bits(), 0.1_f64.to_bits());
}

#[test]
fn stamps_that_scatter_are_no_gaps() {
    let mut random = flight::Stream::new(5, 0);
    let scattered: Vec<f64> =
        (0..2000).map(|k| 0.02 * f64::from(k) + 0.002 * random.normal()).collect();
    let fit = found(&scattered);
    assert!((fit.period_s / 0.02 - 1.0).abs() < 1e-5, "{fit:?}");
    assert_eq!((fit.assumed, fit.after_gaps.len()), (Assumed::Scattered, 0));
    assert!((0.005..0.01).contains(&fit.largest_deviation_s));
}

#[test]
fn missing_rows_are_counted() {
    let mut coarse = stamps(1200, 1.0 / 60.0, rounded(1e3));
    coarse.drain(500..540);
    coarse.remove(100);
    let fit = found(&coarse);
    assert_eq!(fit.after_gaps, [100, 499]);
    assert!((fit.period_s * 60.0 - 1.0).abs() < 1e-6, "{fit:?}");
}

#[test]
fn a_clock_that_drifts_is_followed() {
    // A tenth of a per mille faster at the end than at the start: ten periods over the record.
    let drifting: Vec<f64> = (0..20_000)
        .map(f64::from)
        .map(|k| ((0.01 * k + 2.5e-10 * k * k) * 1e3).round() / 1e3)
        .collect();
    let fit = found(&drifting);
    assert!((fit.period_s / 0.01 - 1.0).abs() < 1e-3, "{fit:?}");
    assert!(fit.after_gaps.is_empty());
}

#[test]
fn uneven_rows_are_refused() {
    let mut random = flight::Stream::new(9, 0);
    let mut time = 0.0;
    // Steps of 0.5 to 1.5 periods, one after another.
    let wandering: Vec<f64> = (0..1000)
        .map(|_| {
            time += 0.02 * (1.0 + 0.28 * random.normal()).clamp(0.5, 1.5);
            time
        })
        .collect();
    assert_eq!(fit(&wandering), None);
    // One row repeated, where no rounding explains it.
    let mut repeated = stamps(200, 0.1, |time| time);
    repeated[90] = repeated[89];
    assert_eq!(fit(&repeated), None);
    repeated.swap(20, 21);
    assert_eq!(fit(&repeated), None);
    assert_eq!(fit(&[1.0; 100]), None);
    assert_eq!(fit(&[0.0, 1.0]), None);
}
