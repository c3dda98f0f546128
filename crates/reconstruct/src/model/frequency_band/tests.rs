use std::f64::consts::PI;

use lti::SamplePeriod;

use super::*;
use crate::Channel;

const PERIOD: f64 = 0.05;

fn period() -> SamplePeriod {
    SamplePeriod::new(PERIOD).unwrap()
}

#[test]
fn the_first_band_is_a_quarter_of_the_nyquist_frequency() {
    let band = FrequencyBand::before_the_modes(period());
    assert!((band.highest_rad_s - 5.0 * PI).abs() < 1e-12);
    assert_eq!(band.lowest_rad_s.to_bits(), 0.0_f64.to_bits());
}

/// 10 |s|, no further than 0.7 of the Nyquist frequency, and nothing where that is nearly the band already.
#[test]
fn the_band_follows_the_fastest_mode() {
    let first = FrequencyBand::before_the_modes(period());
    let highest =
        |fastest: f64| first.reaching_beyond(fastest, period()).map(|band| band.highest_rad_s);
    assert!((highest(0.9).unwrap() - 9.0).abs() < 1e-12);
    assert!((highest(100.0).unwrap() - 0.7 * 20.0 * PI).abs() < 1e-12);
    // 5 pi is 15.7.
    for (fastest, same) in [(1.24, false), (1.27, true), (1.95, true), (1.97, false)] {
        assert_eq!(highest(fastest).is_none(), same, "{fastest}");
    }
}

/// A limit that is a frequency of the transform but for rounding is in the band.
#[test]
fn limits_are_in_the_band() {
    let values = (0..100).map(f64::from).collect();
    let record = Record::new("a", period(), vec![Channel::new("p", values)]).unwrap();
    let step = 2.0 * PI / (100.0 * PERIOD);
    for rounding in [-1e-9, 0.0, 1e-9] {
        let band = FrequencyBand {
            lowest_rad_s: step * (3.0 + rounding),
            highest_rad_s: step * (7.0 - rounding),
        };
        let kept: Vec<usize> = (0..50).filter(|&k| band.holds(k, &record)).collect();
        assert_eq!(kept, [3, 4, 5, 6, 7]);
    }
}
