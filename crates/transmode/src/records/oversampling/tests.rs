use super::*;

/// White noise of variance 1.
fn noise(samples: usize, seed: u64) -> Vec<f64> {
    let mut random = flight::Stream::new(seed, 0);
    flight::normal(1, samples, &mut random).iter().copied().collect()
}

/// Noise behind so many first-order filters with that corner, as a part of the Nyquist frequency, and white noise of that level beside it.
fn low_passed(filters: usize, corner: f64, level: f64, samples: usize, seed: u64) -> Vec<f64> {
    let pole = (-std::f64::consts::PI * corner).exp();
    let mut values = noise(samples, seed);
    for _ in 0..filters {
        let mut state = 0.0;
        for value in &mut values {
            state = pole * state + (1.0 - pole) * *value;
            *value = state;
        }
    }
    let size = (values.iter().map(|value| value * value).sum::<f64>() / samples as f64).sqrt();
    for (value, noise) in values.iter_mut().zip(noise(samples, seed + 1000)) {
        *value = *value / size + level * noise;
    }
    values
}

#[test]
fn what_is_kept_ends_where_a_steep_spectrum_falls_below_the_noise() {
    // The power falls with the eighth power of the frequency, and stands at twice the noise there.
    for (corner, level, end) in [(0.004, 0.01, 0.033), (0.004, 0.1, 0.018), (0.02, 0.01, 0.14)] {
        let found = needed(&low_passed(4, corner, level, 40_000, 1)).unwrap();
        assert!((0.6..1.7).contains(&(found / (2.0 * end))), "{corner} {level}: {found}");
    }
}

#[test]
fn of_a_slope_that_hardly_falls_the_power_says_what_is_kept() {
    // One filter: nine tenths lie below 6.3 times its corner.
    for seed in 0..5 {
        let found = needed(&low_passed(1, 0.0005, 0.003, 100_000, seed)).unwrap();
        let expected = 40.0 * 6.3 * 0.0005;
        assert!((0.6..1.5).contains(&(found / expected)), "{seed}: {found} for {expected}");
    }
}

#[test]
fn what_fills_the_band_is_kept() {
    for seed in 0..20 {
        let found = needed(&low_passed(2, 0.1, 0.001, 4000, seed)).unwrap();
        assert!(found > 0.9, "{seed}: {found}");
    }
    assert_eq!(needed(&[0.0; 4000]), None);
    assert_eq!(needed(&noise(1000, 1)), None);
}
