use super::*;

fn decimator(factor: usize) -> Decimator {
    Decimator::new(NonZero::new(factor).unwrap())
}

/// The gain of the filter at a part of the new Nyquist frequency.
fn gain(decimator: &Decimator, part: f64) -> f64 {
    let omega = part * PI / f64::from(u32::try_from(decimator.factor).unwrap());
    let side = |(k, weight): (usize, &f64)| {
        2.0 * weight * (omega * f64::from(u32::try_from(k).unwrap())).cos()
    };
    decimator.weights[0] + decimator.weights.iter().enumerate().skip(1).map(side).sum::<f64>()
}

#[test]
fn passes_what_is_kept_and_stops_what_would_fold() {
    for factor in [2, 3, 5, 20] {
        let decimator = decimator(factor);
        for part in [0.0, 0.1, 0.5, 0.79] {
            assert!((gain(&decimator, part) - 1.0).abs() < 2e-4, "{factor} {part}");
        }
        assert!((gain(&decimator, 1.0) - 0.5).abs() < 1e-3);
        for part in [1.21, 1.5, 1.9] {
            assert!(
                gain(&decimator, part).abs() < 2e-4,
                "{factor} {part} {}",
                gain(&decimator, part)
            );
        }
        assert!(
            (12 * factor..=13 * factor).contains(&decimator.margin()),
            "{factor} {}",
            decimator.margin()
        );
    }
}

#[test]
fn keeps_slow_signals_and_their_times() {
    let decimator = decimator(4);
    let slow = |k: usize| (0.05 * f64::from(u32::try_from(k).unwrap())).sin() + 3.0;
    let signal: Vec<f64> = (0..1000).map(slow).collect();
    let found = decimator.decimate(&signal);
    assert_eq!(found.len(), (1000 - length(NonZero::new(4).unwrap())) / 4 + 1);
    for (index, value) in found.iter().enumerate() {
        let expected = slow(decimator.margin() + 4 * index);
        assert!((value - expected).abs() < 1e-3, "{index} {value} {expected}");
    }
}

#[test]
fn a_factor_of_one_changes_nothing() {
    let signal = [1.0, -2.0, 3.5];
    assert_eq!(decimator(1).decimate(&signal), signal);
    assert!(decimator(2).decimate(&signal).is_empty());
}

#[test]
fn a_filter_that_fits_no_record_is_not_made() {
    assert_eq!(length(NonZero::<usize>::MAX), usize::MAX);
    assert_eq!(length(NonZero::<usize>::MIN), 1);
}

#[test]
fn the_bessel_function_has_its_tabled_values() {
    // Abramowitz and Stegun, table 9.8 times e^x: I0(1), I0(5).
    assert!((bessel_i0(1.0) - 1.266_065_877_752_008_4).abs() < 1e-14);
    assert!((bessel_i0(5.0) - 27.239_871_823_604_442).abs() < 1e-12);
}
