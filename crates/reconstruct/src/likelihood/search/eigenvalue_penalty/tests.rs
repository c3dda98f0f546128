use super::*;

#[test]
fn the_slope_is_the_derivative_of_the_eigenvalue() {
    let a = DMatrix::from_row_slice(3, 3, &[0.9, 0.2, 0.1, -0.3, 0.8, 0.05, 0.1, -0.2, 0.99]);
    let penalty = EigenvaluePenalty { eigenvalue: 1.0, weight: 1.0 };
    let (z, slope) = penalty.closest(&a).unwrap();
    let step = 1e-6;
    for i in 0..3 {
        for k in 0..3 {
            let mut moved = a.clone();
            moved[(i, k)] += step;
            let (next, _) = penalty.closest(&moved).unwrap();
            assert!(((next - z) / step - slope[(i, k)]).abs() < 1e-5);
        }
    }
}

#[test]
fn a_pair_close_to_the_place_cannot_be_held() {
    let pair = DMatrix::from_row_slice(2, 2, &[0.99, 0.1, -0.1, 0.99]);
    assert!(EigenvaluePenalty { eigenvalue: 1.0, weight: 1.0 }.closest(&pair).is_none());
}
