use super::*;

#[test]
fn each_lane_computes_for_itself() {
    let at = |k: usize| Complex::new(1.0 + k as f64, 0.5 - k as f64);
    let other = |k: usize| Complex::new(-2.0 * k as f64, 3.0);
    let first: Vec<_> = (0..WIDTH).map(at).collect();
    let second: Vec<_> = (0..WIDTH).map(other).collect();
    let (x, y) = (Lanes::gather(&first, 0, 1, WIDTH - 1), Lanes::gather(&second, 0, 1, WIDTH - 1));
    let get = |lanes: Lanes, k: usize| Complex::new(lanes.re.0[k], lanes.im.0[k]);
    for k in 0..WIDTH {
        let (a, b) = (at(k), other(k));
        assert_eq!(get(x + y, k), a + b);
        assert_eq!(get(x - y, k), a - b);
        assert_eq!(get(x * y, k), a * b);
        assert_eq!(get(x.conj_mul(y), k), a.conj() * b);
        assert_eq!(get(x.conj(), k), a.conj());
        assert!((x.dot(y).0[k] - (a.conj() * b).re).abs() < 1e-15);
        assert!((x.norm_sqr().0[k] - a.norm_sqr()).abs() < 1e-15);
    }
}

#[test]
fn a_gather_beyond_the_end_repeats_the_last() {
    let values: Vec<_> = (0..6).map(|k| Complex::new(f64::from(k), 0.0)).collect();
    let lanes = Lanes::gather(&values, 1, 2, 5);
    for (found, expected) in lanes.re.0.into_iter().zip([1, 3, 5, 5, 5, 5, 5, 5]) {
        assert!((found - f64::from(expected)).abs() < f64::EPSILON);
    }
}
