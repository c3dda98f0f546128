use super::*;

fn even(count: u32, period_s: f64) -> Vec<f64> {
    (0..count).map(|k| 100.0 + f64::from(k) * period_s).collect()
}

#[test]
fn even_stamps_give_the_decimal_period() {
    assert_eq!(sampling(&even(2000, 0.1)), Some(Sampling::Even { period_s: 0.1 }));
    assert_eq!(
        sampling(&even(2, 1e-9 + 1e-10)).map(|s| matches!(s, Sampling::Even { .. })),
        Some(true)
    );
    assert_eq!(sampling(&[1.0]), None);
    assert_eq!(sampling(&[]), None);
}

#[test]
fn jitter_is_forgiven_and_gaps_are_named() {
    let mut stamps = even(50, 0.1);
    stamps[20] += 0.0004;
    assert_eq!(sampling(&stamps), Some(Sampling::Even { period_s: 0.1 }));

    let check = |change: fn(&mut Vec<f64>), expected: usize| {
        let mut stamps = even(50, 0.1);
        change(&mut stamps);
        let Some(Sampling::Uneven { index, .. } | Sampling::Backward { index, .. }) =
            sampling(&stamps)
        else {
            panic!("taken for even");
        };
        assert_eq!(index, expected);
    };
    check(|stamps| stamps[20] += 0.002, 20);
    check(|stamps| stamps.retain(|t| (t - 103.0).abs() > 0.05), 30);
    check(|stamps| stamps.swap(10, 11), 10);
    check(|stamps| stamps[7] = stamps[6], 7);
    check(|stamps| stamps.reverse(), 1);
    check(|stamps| stamps.iter_mut().for_each(|t| *t = 3.0), 1);
}

#[test]
fn steps_that_are_no_sample_period_are_refused() {
    let stamps = |step: f64| (0..50).map(|k| f64::from(k) * step).collect::<Vec<_>>();
    for step in [1e-320, 1e-13, 1e13, 1e300] {
        let Some(Sampling::OutOfRange { period_s }) = sampling(&stamps(step)) else {
            panic!("{step} is taken for a period");
        };
        assert!((period_s / step - 1.0).abs() < 1e-3, "{period_s} {step}");
    }
    for step in [1e-11, 1e11] {
        assert!(matches!(sampling(&stamps(step)), Some(Sampling::Even { .. })), "{step}");
    }
    // The difference overflows.
    let infinite = sampling(&[-1e308, 1e308]);
    assert_eq!(infinite, Some(Sampling::OutOfRange { period_s: f64::INFINITY }));
    assert_eq!(sampling(&[0.2, 0.1]), Some(Sampling::Backward { index: 1, step_s: -0.1 }));
    assert_eq!(sampling(&[0.2, 0.2]), Some(Sampling::Backward { index: 1, step_s: 0.0 }));
}
