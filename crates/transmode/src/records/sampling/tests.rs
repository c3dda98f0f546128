use super::*;

fn even(count: u32, period_s: f64) -> Vec<f64> {
    (0..count).map(|k| 100.0 + f64::from(k) * period_s).collect()
}

fn period(stamps: &[f64]) -> f64 {
    match sampling(stamps) {
        Some(Sampling::Even(even)) => even.period_s,
        other => panic!("{other:?}"),
    }
}

#[test]
fn even_stamps_give_the_decimal_period() {
    assert_eq!(period(&even(2000, 0.1)).to_bits(), 0.1_f64.to_bits());
    assert!(period(&even(2, 1e-9 + 1e-10)) > 0.0);
    assert_eq!(sampling(&[1.0]), None);
    assert_eq!(sampling(&[]), None);
}

#[test]
fn jitter_is_forgiven_and_uneven_steps_are_named() {
    let mut stamps = even(50, 0.1);
    stamps[20] += 0.0004;
    let Some(Sampling::Even(found)) = sampling(&stamps) else { panic!("taken for uneven") };
    assert_eq!((found.period_s.to_bits(), found.after_gaps.len()), (0.1_f64.to_bits(), 0));
    assert!((found.jitter - 0.004).abs() < 1e-9, "{}", found.jitter);

    let check = |change: fn(&mut Vec<f64>), expected: &[usize]| {
        let mut stamps = even(50, 0.1);
        change(&mut stamps);
        let Some(Sampling::Uneven(fault) | Sampling::Backward(fault)) = sampling(&stamps) else {
            panic!("taken for even");
        };
        let mut found = vec![fault.index];
        found.extend(&fault.others);
        assert_eq!(found, expected);
        assert!(fault.other_count >= fault.others.len());
    };
    check(|stamps| stamps[20] += 0.002, &[20, 21]);
    check(|stamps| stamps.swap(10, 11), &[11]);
    check(|stamps| stamps[7] = stamps[6], &[7]);
    check(|stamps| stamps.reverse(), &[1, 2, 3, 4, 5]);
    check(|stamps| stamps.iter_mut().for_each(|t| *t = 3.0), &[1, 2, 3, 4, 5]);
    // One and a half periods are no gap but a late sample; so are two and a half.
    for late in [0.05, 0.15] {
        let mut stamps = even(50, 0.1);
        stamps[30..].iter_mut().for_each(|t| *t += late);
        assert!(matches!(
            sampling(&stamps),
            Some(Sampling::Uneven(Fault { index: 30, other_count: 0, .. }))
        ));
    }
}

#[test]
fn gaps_are_found_and_do_not_count_for_the_period() {
    let mut stamps = even(200, 0.1);
    stamps.retain(|t| (t - 103.0).abs() > 0.05 && !(106.0..109.0).contains(t));
    let Some(Sampling::Even(found)) = sampling(&stamps) else { panic!("taken for uneven") };
    assert_eq!(found.after_gaps, [30, 59]);
    assert_eq!(found.period_s.to_bits(), 0.1_f64.to_bits());
    assert!(found.jitter < 1e-9);
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
        assert!(matches!(sampling(&stamps(step)), Some(Sampling::Even(_))), "{step}");
    }
    // The difference overflows.
    let infinite = sampling(&[-1e308, 1e308]);
    assert_eq!(infinite, Some(Sampling::OutOfRange { period_s: f64::INFINITY }));
    for (second, step) in [(0.1, -0.1_f64), (0.2, 0.0)] {
        let Some(Sampling::Backward(fault)) = sampling(&[0.2, second]) else { panic!("{second}") };
        assert_eq!((fault.index, fault.step_s.to_bits()), (1, step.to_bits()));
    }
}
