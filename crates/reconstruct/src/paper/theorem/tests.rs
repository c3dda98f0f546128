use lti::Transmissibility;

use super::*;

fn p(descending: &[i64]) -> Poly<i64> {
    Poly::from_descending(descending)
}

fn pair(first: (&[i64], &[i64]), second: (&[i64], &[i64])) -> TransmissibilityPair<i64> {
    let [first, second] =
        [first, second].map(|(o, i)| Transmissibility::from_polynomials(p(o), p(i)).unwrap());
    TransmissibilityPair::new(first, second)
}

/// Example 4.1 of the paper, with the two polynomials that it exchanges put right.
fn example() -> TransmissibilityPair<i64> {
    pair((&[3, -9, 5], &[2, -4, 3]), (&[5, -11, 3], &[3, -6, 6]))
}

#[test]
fn the_determinant_is_exact_over_the_integers() {
    let determinant = p(&[1, 3, -22, 39, -21]);
    assert_eq!(example().determinant(), determinant);
    assert_eq!(example().delta().determinant().unwrap(), determinant);
    assert_eq!(*example().difference().unwrap().numerator(), -determinant);
    let theorem = example().theorem(3).unwrap();
    assert_eq!(theorem.statement, Statement::DegreeAtLeastOrder { degree: 4, order: 3 });
}

#[test]
fn equal_transmissibilities_are_statement_one() {
    // Both columns of Delta are multiples of (p + 1, p + 2).
    let equal = pair((&[1, 2], &[1, 1]), (&[3, 6], &[3, 3]));
    assert_eq!(equal.theorem(2).unwrap().statement, Statement::DeterminantIsZero);
}

#[test]
fn a_degree_below_the_order_is_no_statement() {
    let result = example().theorem(5);
    assert_eq!(result, Err(ReconstructError::NotOneSystem { degree: 4, order: 5 }));
}

#[test]
fn rounding_errors_do_not_make_a_degree() {
    let float = |descending: &[f64]| Poly::from_descending(descending);
    let transmissibility =
        |o: &[f64], i: &[f64]| Transmissibility::from_polynomials(float(o), float(i)).unwrap();
    // 0.1 * 3 is not 0.3 in binary: the leading coefficients cancel up to 5.6e-17.
    let pair = TransmissibilityPair::new(
        transmissibility(&[0.1, 1.0], &[0.3, 2.0]),
        transmissibility(&[1.0, 1.0], &[3.0, 5.0]),
    );
    assert_eq!(pair.determinant().degree(), Some(2));
    assert_eq!(pair.theorem_rounded(1, 1e-14).unwrap().determinant.degree(), Some(1));
    let equal = TransmissibilityPair::new(
        transmissibility(&[0.1], &[0.3]),
        transmissibility(&[1.0], &[3.0]),
    );
    assert_eq!(equal.theorem_rounded(2, 1e-14).unwrap().statement, Statement::DeterminantIsZero);
    assert!(matches!(
        equal.theorem_rounded(2, f64::NAN),
        Err(ReconstructError::InvalidTolerance { .. })
    ));
}

#[test]
fn containment_counts_multiplicities() {
    let z = |re: f64| Complex::new(re, 0.0);
    let twice = containment(&[z(1.0), z(1.0)], &[z(1.0), z(1.0 + 1e-9), z(-7.0)]);
    assert!(twice.largest_distance() < 2e-9);
    assert_eq!(twice.extra, [z(-7.0)]);
    // A double eigenvalue needs two roots.
    assert!(containment(&[z(1.0), z(1.0)], &[z(1.0), z(-7.0)]).largest_distance() > 7.0);
    assert!(containment(&[z(f64::NAN)], &[z(1.0)]).largest_distance().is_infinite());
    assert!(containment(&[z(1.0), z(2.0)], &[z(1.0)]).largest_distance().is_infinite());
}
