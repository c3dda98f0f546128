//! Nothing that a reader would miss is lost.

use super::*;

#[test]
fn peaks_survive() {
    let mut values: Vec<f64> = (0..10_007).map(|k| (0.01 * k as f64).sin()).collect();
    values[5003] = 7.0;
    values[9999] = -4.0;
    let kept = extremes(&values, 100);
    assert!(kept.len() <= 200 && kept.is_sorted(), "{}", kept.len());
    assert!(kept.contains(&5003) && kept.contains(&9999));
}

#[test]
fn short_and_constant_signals() {
    assert_eq!(extremes(&[1.0, 2.0, 3.0], 2), [0, 1, 2]);
    assert_eq!(extremes(&[], 2), [0; 0]);
    assert_eq!(extremes(&[5.0; 9], 3), [0, 2, 3, 5, 6, 8]);
}

#[test]
fn every_frequency_but_zero_is_in_one_bin() {
    let frequencies: Vec<f64> = (0..50_001).map(|k| k as f64).collect();
    let bins = logarithmic(&frequencies, 150);
    assert!(bins.len() <= 151 && bins.len() > 80, "{}", bins.len());
    assert_eq!(bins[0], Bin { frequency_rad_s: 1.0, places: 1..2 });
    assert_eq!(bins.last().map(|bin| bin.places.end), Some(50_001));
    assert!(bins.windows(2).all(|pair| pair[0].places.end == pair[1].places.start));
    let mean = Bin { frequency_rad_s: 0.0, places: 1..3 }.mean(&[9.0, 1.0, 2.0]);
    assert!((mean - 1.5).abs() < 1e-15);
    assert_eq!(logarithmic(&[0.0], 9), []);
    assert_eq!(logarithmic(&[0.0, 2.0], 9).len(), 1);
}
