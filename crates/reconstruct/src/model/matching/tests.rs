use super::*;

#[test]
fn closest_pairs_come_first_and_serve_once() {
    let z = |re| Complex::new(re, 0.0);
    let check = |left: &[f64], right: &[f64], expected: &[(usize, usize)]| {
        let [left, right] =
            [left, right].map(|list| list.iter().map(|&re| z(re)).collect::<Vec<_>>());
        let found: Vec<_> =
            closest_pairs(&left, &right).iter().map(|pair| (pair.left, pair.right)).collect();
        assert_eq!(found, expected);
    };
    check(&[0.0, 1.0], &[1.1, 0.3], &[(1, 0), (0, 1)]);
    // Both are closest to 1.0, but it can serve only once.
    check(&[0.9, 0.99], &[1.0, 5.0], &[(1, 0), (0, 1)]);
    check(&[0.0], &[], &[]);
    check(&[2.0, 2.0], &[2.0, 2.0], &[(0, 0), (1, 1)]);
}
