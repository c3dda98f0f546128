use num_complex::Complex;

use super::*;
use crate::likelihood::fixtures::Normal;

/// A record's frequencies alone.
fn frequencies(samples: usize) -> RecordSpectrum {
    let number = samples / 2 + 1;
    let root =
        |k: usize| Complex::from_polar(1.0, std::f64::consts::TAU * k as f64 / samples as f64);
    let end = |k: usize| if k == 0 || 2 * k == samples { 1.0 } else { 2.0 };
    RecordSpectrum {
        z: (0..number).map(root).collect(),
        weight: (0..number).map(end).collect(),
        y: Vec::new(),
        entries: Vec::new(),
        factors: Vec::new(),
        precision: None,
        power: None,
        offset_variance: Vec::new(),
        starts_at_zero: true,
        missing: None,
    }
}

/// Costs of white residuals of m = 3 sensors: chi-squared with 2 w degrees of freedom, times 1 + a cos(theta).
fn costs(spectrum: &RecordSpectrum, a: f64, normal: &mut Normal) -> Vec<f64> {
    let at = |(z, weight): (&Complex<f64>, &f64)| {
        let number = if *weight > 1.5 { 4 } else { 2 };
        (0..number).map(|_| normal.next().powi(2)).sum::<f64>() * (1.0 + a * z.re)
    };
    spectrum.z.iter().zip(&spectrum.weight).map(at).collect()
}

#[test]
fn white_residuals_pass_as_often_as_they_should() {
    let mut normal = Normal::new(1);
    let whole = frequencies(400);
    let mut band = whole.clone();
    band.z = band.z[20..120].to_vec();
    band.weight = band.weight[20..120].to_vec();
    for spectrum in [whole, band] {
        let rejected = (0..400)
            .filter(|_| {
                whiteness("r", &spectrum, &costs(&spectrum, 0.0, &mut normal), 3).p_value < 0.05
            })
            .count();
        // 20 of 400, with a deviation of 4.4.
        assert!((7..=36).contains(&rejected), "{rejected}");
    }
}

#[test]
fn coloured_residuals_do_not() {
    let spectrum = frequencies(400);
    let test = whiteness("r", &spectrum, &costs(&spectrum, 0.5, &mut Normal::new(2)), 3);
    assert!(test.p_value < 1e-6);
    // 1 + a cos(theta) has the autocorrelation a/2 at lag 1.
    assert!((test.autocorrelations[0] - 0.25).abs() < 0.1, "{}", test.autocorrelations[0]);
    assert_eq!((test.autocorrelations.len(), test.degrees_of_freedom), (20, 20));
}

#[test]
fn nothing_is_white() {
    let spectrum = frequencies(100);
    let test = whiteness("r", &spectrum, &vec![0.0; 51], 3);
    assert!((test.p_value - 1.0).abs() < f64::EPSILON && test.statistic.abs() < f64::EPSILON);
}

#[test]
fn probabilities_only_where_levels_are_known() {
    let known = ChiSquared::new(20.0, 20.0, false);
    // scipy.stats.chi2.sf(20, 20)
    assert!((known.p_value.unwrap() - 0.457_929_714_471_853).abs() < 1e-12);
    assert_eq!(ChiSquared::new(20.0, 20.0, true).p_value, None);
}
