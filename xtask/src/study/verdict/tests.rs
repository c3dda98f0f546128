use super::*;

#[test]
fn a_pair_stands_for_two_real_modes() {
    let truth = TrueModes {
        spiral: Complex::new(0.0, 0.0),
        roll: Complex::new(-0.5, 0.0),
        dutch_roll: Complex::new(-0.1, 1.7),
    };
    let values = [Complex::new(-0.25, 0.1), Complex::new(-0.1, 1.6)];
    let found = with_conjugates(&values, &truth).unwrap();
    let [spiral, roll, dutch_roll] = errors(&found, &truth);
    assert!((spiral - 0.25_f64.hypot(0.1)).abs() < 1e-12);
    assert!((roll - 0.25_f64.hypot(0.1)).abs() < 1e-12);
    assert!((dutch_roll - 0.1).abs() < 1e-12);
    assert!(with_conjugates(&values[..1], &truth).is_none());
}
