use super::fill;

const N: f64 = f64::NAN;

fn check(values: &[f64], filled: &[f64], missing: &[usize]) {
    let mut found = values.to_vec();
    assert_eq!(fill(&mut found), missing);
    for (found, expected) in found.iter().zip(filled) {
        assert!((found - expected).abs() < 1e-14, "{found} is not {expected}");
    }
}

#[test]
fn straight_lines_go_on() {
    check(&[1.0, 2.0, 3.0], &[1.0, 2.0, 3.0], &[]);
    check(&[0.0, 1.0, N, 3.0, 4.0], &[0.0, 1.0, 2.0, 3.0, 4.0], &[2]);
    check(&[0.0, N, N, 3.0], &[0.0, 1.0, 2.0, 3.0], &[1, 2]);
    check(&[N, 0.0, 1.0, N, 3.0, N, 5.0], &[0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0], &[0, 3, 5]);
}

#[test]
fn parabolas_go_on() {
    let whole: Vec<f64> = (0..9).map(|k| (f64::from(k) - 2.5).powi(2)).collect();
    let mut gaps = whole.clone();
    for missing in [2, 4, 5] {
        gaps[missing] = N;
    }
    check(&gaps, &whole, &[2, 4, 5]);
}

#[test]
fn edges_are_held() {
    check(&[N, N, 4.0, 5.0, N], &[4.0, 4.0, 4.0, 5.0, 5.0], &[0, 1, 4]);
}

#[test]
fn nothing_stays_nothing() {
    let mut values = [N, N];
    assert_eq!(fill(&mut values), [0, 1]);
    assert!(values.iter().all(|value| value.is_nan()));
}
