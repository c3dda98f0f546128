use super::*;
use crate::shared::paper_aircraft::PaperAircraft;

fn turbulence() -> Turbulence {
    let aircraft = PaperAircraft::new().unwrap();
    Turbulence::new(&aircraft.continuous, aircraft.period()).unwrap()
}

#[test]
fn the_spectrum_is_that_of_the_motion() {
    // Power of each sensor between 0.5 and 3 rad/s, where leakage from the slow spiral mode is
    // small: mean of 40 periodograms.
    const SAMPLES: usize = 1800;
    let turbulence = turbulence();
    let spectrum = turbulence.spectrum(SAMPLES, 1.0, &[0.0; 3].map(|_| 1e-6)).unwrap();
    let frequencies: Vec<usize> = (15..86).collect();
    for sensor in 0..3 {
        let expected: f64 =
            frequencies.iter().map(|k| spectrum.covariances()[*k][(sensor, sensor)].re).sum();
        let mut found = 0.0;
        for seed in 0..40 {
            let y = turbulence.motion(SAMPLES, &mut Stream::new(seed, 0)).unwrap();
            for k in &frequencies {
                let step = std::f64::consts::TAU * *k as f64 / SAMPLES as f64;
                let sum: Complex<f64> = (0..SAMPLES)
                    .map(|i| Complex::from_polar(y[(sensor, i)], -step * i as f64))
                    .sum();
                found += sum.norm_sqr() / SAMPLES as f64 / 40.0;
            }
        }
        // 2840 periodogram values, most of the power in a tenth of them.
        assert!((found / expected - 1.0).abs() < 0.2, "{sensor}: {found} {expected}");
    }
}

#[test]
fn the_vane_reads_the_air() {
    // At once a gust shows in the vane alone, with its sign changed; the air then turns the
    // aircraft as sideslip would.
    let turbulence = turbulence();
    let gust = 4;
    assert!((turbulence.noise.fine().c()[(0, gust)] + 1.0).abs() < 1e-15);
    assert!(turbulence.noise.fine().c()[(1, gust)].abs() < 1e-15);
    let a = turbulence.noise.fine().a();
    for rate in 1..3 {
        let (sideslip, air) = (a[(rate, 0)], a[(rate, gust)]);
        assert!((sideslip + air).abs() < 0.01 * sideslip.abs(), "{sideslip} {air}");
    }
}

#[test]
fn levels_and_strength_add_up() {
    let turbulence = turbulence();
    let levels = [0.1, 0.2, 0.3];
    let still = turbulence.spectrum(100, 0.0, &levels).unwrap();
    for (k, covariance) in still.covariances().iter().enumerate() {
        for (sensor, level) in levels.iter().enumerate() {
            let off = (covariance[(sensor, sensor)].re - level * level).abs();
            assert!(off < 1e-12, "{k} {sensor}");
        }
    }
    let [one, two] =
        [1.0, 2.0].map(|strength| turbulence.spectrum(100, strength, &levels).unwrap());
    for ((still, one), two) in
        still.covariances().iter().zip(one.covariances()).zip(two.covariances())
    {
        let (of_one, of_two) = (one - still, two - still);
        assert!((of_two - &of_one * Complex::new(4.0, 0.0)).norm() < 1e-9 * of_one.norm());
    }
}
