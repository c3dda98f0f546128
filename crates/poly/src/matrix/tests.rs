//! Tests of polynomial matrices: exact examples, identities, floating-point determinants.

use super::PolyMatrix;
use crate::{Complex, MrootsOptions, Poly, PolyError, Ring, characteristic_polynomial, mroots};
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;

/// `c adj(pI - A) b`, the numerator of the transfer function.
fn numerator<T: Ring>(a: &[T], b: &[T], c: &[T]) -> Poly<T> {
    let n = b.len();
    let identity: Vec<T> =
        (0..n * n).map(|k| if k / n == k % n { T::one() } else { T::zero() }).collect();
    let adjugate = PolyMatrix::linear(n, n, &identity, a).unwrap().adjugate().unwrap();
    let row = PolyMatrix::from_constant(1, n, c).unwrap();
    let column = PolyMatrix::from_constant(n, 1, b).unwrap();
    row.product(&adjugate).unwrap().product(&column).unwrap()[(0, 0)].clone()
}

fn big(list: &[i64]) -> Vec<BigInt> {
    list.iter().map(|&c| BigInt::from(c)).collect()
}

/// The paper's Example 4.1, over the integers.
#[test]
fn example_4_1() {
    let a = big(&[1, 1, 1, 0, 2, -1, 0, 1, 1]);
    let (c_i, c_o) = (big(&[1, 2, -1]), big(&[-1, 3, -2]));
    let (b_1, b_2) = (big(&[0, 1, 0]), big(&[0, 1, -1]));
    let p = |descending: &[i64]| Poly::from_descending(&big(descending));
    let gamma = [
        numerator(&a, &b_1, &c_i),
        numerator(&a, &b_2, &c_i),
        numerator(&a, &b_1, &c_o),
        numerator(&a, &b_2, &c_o),
    ];
    // The paper prints the second and third exchanged.
    assert_eq!(gamma, [p(&[2, -4, 3]), p(&[3, -6, 6]), p(&[3, -9, 5]), p(&[5, -11, 3])]);
    let determinant = PolyMatrix::new(2, 2, gamma.to_vec()).unwrap().determinant().unwrap();
    assert_eq!(determinant, p(&[1, 3, -22, 39, -21]));
    let delta = characteristic_polynomial(&a, 3).unwrap();
    assert_eq!(delta, p(&[1, -4, 6, -3]));
    assert_eq!(determinant, delta * p(&[1, 7]));

    let float = determinant.map(|c| f64::from(i32::try_from(c).unwrap()));
    let roots = mroots(&float, &MrootsOptions::default()).unwrap().values();
    let imaginary = 0.75_f64.sqrt();
    let expected = [
        Complex::new(-7.0, 0.0),
        Complex::new(1.0, 0.0),
        Complex::new(1.5, imaginary),
        Complex::new(1.5, -imaginary),
    ];
    for (root, expected) in roots.iter().zip(expected) {
        assert!((root - expected).norm() < 3e-16, "{root} {expected}");
    }
}

fn rational(list: &[(i64, i64)]) -> Vec<BigRational> {
    list.iter().map(|&(n, d)| BigRational::new(BigInt::from(n), BigInt::from(d))).collect()
}

/// The paper's Example 4.2, over the rationals: numerators, the difference of two transmissibilities, its roots.
#[test]
fn example_4_2() {
    let a = rational(&[
        (-7, 10),
        (23, 100),
        (239, 1000),
        (546, 10000),
        (1, 1),
        (0, 1),
        (0, 1),
        (0, 1),
        (0, 1),
        (1, 1),
        (0, 1),
        (0, 1),
        (0, 1),
        (0, 1),
        (1, 1),
        (0, 1),
    ]);
    let column = |list: [i64; 4]| rational(&list.map(|c| (c, 1)));
    let (b_1, b_2) = (column([1, 1, 4, 0]), column([0, 0, 1, 1]));
    let (c_1, c_2) = (column([1, 2, 3, 0]), column([8, 1, 1, 0]));
    let p = |list: &[(i64, i64)]| Poly::from_descending(&rational(list));
    let gamma_i1 = numerator(&a, &b_1, &c_1);
    let gamma_i2 = numerator(&a, &b_2, &c_1);
    let gamma_o1 = numerator(&a, &b_1, &c_2);
    let gamma_o2 = numerator(&a, &b_2, &c_2);
    assert_eq!(gamma_i1, p(&[(15, 1), (7993, 500), (23547, 5000), (2457, 5000)]));
    assert_eq!(gamma_i2, p(&[(3, 1), (1496, 625), (-241, 5000), (273, 1000)]));
    assert_eq!(gamma_o1, p(&[(13, 1), (3747, 250), (3372, 625), (819, 1250)]));
    assert_eq!(gamma_o2, p(&[(1, 1), (3811, 1250), (1251, 2500), (273, 2500)]));

    // T_1 - T_2 = (o1 i2 - o2 i1) / (i1 i2)
    let difference = &gamma_o1 * &gamma_i2 - &gamma_o2 * &gamma_i1;
    let expected = p(&[
        (24, 1),
        (35907, 2500),
        (-237_981, 25000),
        (-1_695_171, 250_000),
        (-501_183, 2_500_000),
        (2_128_581, 3_125_000),
        (1_565_109, 12_500_000),
    ]);
    assert_eq!(difference, expected);
    // The characteristic polynomial divides it: 0.6, -0.7, -0.3 +- 0.2 j are roots.
    let delta = characteristic_polynomial(&a, 4).unwrap();
    assert!(difference.exact_div(&delta).is_ok());
    assert!(delta.eval(&rational(&[(3, 5)])[0]) == rational(&[(0, 1)])[0]);
}

#[test]
fn shapes_are_checked() {
    let wide = PolyMatrix::from_constant(1, 2, &[1, 2]).unwrap();
    assert_eq!(wide.determinant(), Err(PolyError::NotSquare { rows: 1, columns: 2 }));
    assert_eq!(wide.adjugate(), Err(PolyError::NotSquare { rows: 1, columns: 2 }));
    assert!(matches!(
        wide.product(&wide),
        Err(PolyError::ShapeMismatch { operation: "product", .. })
    ));
    assert!(matches!(wide.sum(&wide.transpose()), Err(PolyError::ShapeMismatch { .. })));
    assert_eq!(
        PolyMatrix::<i32>::new(2, 2, vec![Poly::one(); 3]),
        Err(PolyError::EntryCount { rows: 2, columns: 2, found: 3 })
    );
    assert!(PolyMatrix::<i32>::new(usize::MAX, 2, vec![]).is_err());
    assert!(characteristic_polynomial(&[1, 2, 3], 2).is_err());
    let square = PolyMatrix::<i32>::identity(2);
    assert_eq!(square.minor(2, 0), Err(PolyError::IndexOutOfRange { index: 2, length: 2 }));
    assert_eq!((square.get(0, 2), square.get(2, 0)), (None, None));
}

#[test]
fn small_and_empty() {
    let empty = PolyMatrix::<i64>::new(0, 0, vec![]).unwrap();
    assert_eq!(empty.determinant(), Ok(Poly::one()));
    assert_eq!(empty.adjugate(), Ok(empty.clone()));
    assert_eq!(characteristic_polynomial::<i64>(&[], 0), Ok(Poly::one()));
    let one = PolyMatrix::new(1, 1, vec![Poly::new(vec![3, 4])]).unwrap();
    assert_eq!(one.determinant(), Ok(Poly::new(vec![3, 4])));
    assert_eq!(one.adjugate().unwrap()[(0, 0)], Poly::one());
    let product = one.sum(&one).unwrap().difference(&one).unwrap();
    assert_eq!(product, one);
    assert_eq!(one.eval(&2), [11]);
    let wide = PolyMatrix::from_constant(2, 3, &[1, 2, 3, 4, 5, 6]).unwrap();
    assert_eq!(wide.transpose()[(2, 1)], wide[(1, 2)]);
    assert_eq!(wide.without(0, 1).unwrap().entries(), [Poly::constant(4), Poly::constant(6)]);
}

/// Both methods for determinant and adjugate meet at size 9, where Berkowitz takes over.
#[test]
fn large_matrices() {
    let n = 9;
    let entries: Vec<Poly<BigInt>> = (0..n * n)
        .map(|k| {
            let k = k as i64;
            Poly::new(big(&[(k * k * 31 + k * 17) % 11 - 5, (k * k * 7 + k * 3) % 13 - 6]))
        })
        .collect();
    let m = PolyMatrix::new(n, n, entries).unwrap();
    let determinant = m.determinant().unwrap();
    assert!(!determinant.is_zero());
    // Laplace along the first row, each minor expanded at size 8.
    let expanded: Poly<BigInt> = (0..n)
        .map(|j| {
            let term = &m[(0, j)] * &m.minor(0, j).unwrap();
            if j % 2 == 0 { term } else { -term }
        })
        .sum();
    assert_eq!(determinant, expanded);
    let adjugate = m.adjugate().unwrap();
    assert_eq!(m.product(&adjugate).unwrap(), PolyMatrix::identity(n).scale(&determinant));
    assert_eq!(adjugate[(3, 4)], -m.minor(4, 3).unwrap());
}

/// Floating-point determinants against exact ones, below and above the size at which interpolation takes over.
#[test]
fn floating_determinants() {
    for n in [1_usize, 2, 5, 8, 9, 12, 16] {
        let numerator = |k: usize| ((k * k * 31 + k * 17 + n * 5) % 41) as i64 - 20;
        let exact: Vec<Poly<BigRational>> = (0..n * n)
            .map(|k| {
                Poly::new(rational(&[
                    (numerator(3 * k), 16),
                    (numerator(3 * k + 1), 16),
                    (numerator(3 * k + 2), 16),
                ]))
            })
            .collect();
        let exact = PolyMatrix::new(n, n, exact).unwrap();
        let to_float = |p: &Poly<BigRational>| {
            use num_traits::ToPrimitive;
            p.map(|c| c.to_f64().unwrap())
        };
        let truth = to_float(&exact.determinant().unwrap());
        let found = exact.map(to_float).determinant_f64().unwrap();
        let scale = truth.coefficients().iter().fold(0.0_f64, |m, c| m.max(c.abs()));
        for (k, error) in found.coefficient_errors.iter().enumerate() {
            let difference = (found.polynomial.coefficient(k) - truth.coefficient(k)).abs();
            assert!(
                difference <= error + f64::EPSILON * truth.coefficient(k).abs(),
                "n = {n}, degree {k}: {difference:e} {error:e}"
            );
            assert!(*error <= 1e-10 * scale, "n = {n}: a useless estimate {error:e} of {scale:e}");
        }
        assert_eq!(found.polynomial.degree(), truth.degree(), "n = {n}");
    }
}

#[test]
fn floating_determinants_at_the_limits() {
    let p = |c: &[f64]| Poly::from_descending(c);
    // Rank 1 but for rounding: nothing is left.
    let m =
        PolyMatrix::new(2, 2, vec![p(&[0.1, 0.2]), p(&[0.3, 0.6]), p(&[0.7, 1.4]), p(&[2.1, 4.2])])
            .unwrap();
    let found = m.determinant_f64().unwrap();
    assert!(found.polynomial.is_zero());
    assert_eq!(found.vanished_leading, 3);
    let bad = PolyMatrix::new(1, 1, vec![p(&[f64::NAN, 1.0])]).unwrap();
    assert!(matches!(
        bad.determinant_f64(),
        Err(PolyError::NonFiniteCoefficient { degree: 1, .. })
    ));
    let huge = PolyMatrix::from_constant(2, 2, &[1e200, 0.0, 0.0, 1e200]).unwrap();
    assert_eq!(huge.determinant_f64(), Err(PolyError::Overflow { degree: 0 }));
    // Twelve rows of very different scales, above the limit of expansion.
    let n = 12;
    let entries: Vec<Poly<f64>> = (0..n * n)
        .map(|k| {
            let row = 10f64.powf(20.0 * (k / n) as f64 - 110.0);
            if k / n == k % n { p(&[row, 2.0 * row]) } else { Poly::constant(row * 1e-3) }
        })
        .collect();
    let found = PolyMatrix::new(n, n, entries).unwrap().determinant_f64().unwrap();
    assert_eq!(found.polynomial.degree(), Some(n));
    assert!((found.polynomial.coefficient(n) - 1.0).abs() < 1e-12);
}

fn matrix(n: usize) -> impl Strategy<Value = PolyMatrix<BigInt>> {
    proptest::collection::vec(proptest::collection::vec(-5..5_i64, 0..3), n * n).prop_map(
        move |entries| {
            PolyMatrix::new(n, n, entries.iter().map(|c| Poly::new(big(c))).collect()).unwrap()
        },
    )
}

proptest! {
    #[test]
    fn determinants_multiply(a in matrix(3), b in matrix(3)) {
        let product = a.product(&b).unwrap().determinant().unwrap();
        prop_assert_eq!(product, a.determinant().unwrap() * b.determinant().unwrap());
        prop_assert_eq!(a.transpose().determinant(), a.determinant());
    }

    #[test]
    fn adjugate_inverts(a in matrix(4)) {
        let scaled = PolyMatrix::identity(4).scale(&a.determinant().unwrap());
        prop_assert_eq!(a.adjugate().unwrap().product(&a).unwrap(), scaled);
    }

    /// Cayley and Hamilton: the matrix annihilates its characteristic polynomial.
    #[test]
    fn characteristic(a in proptest::collection::vec(-9..9_i64, 16)) {
        let a = big(&a);
        let p = characteristic_polynomial(&a, 4).unwrap();
        let m = PolyMatrix::from_constant(4, 4, &a).unwrap();
        let mut sum = PolyMatrix::identity(4).scale(&Poly::zero());
        for c in p.descending() {
            sum = sum.product(&m).unwrap().sum(&PolyMatrix::identity(4).scale(&Poly::constant(c))).unwrap();
        }
        prop_assert!(sum.entries().iter().all(Poly::is_zero));
        prop_assert_eq!(p.degree(), Some(4));
    }
}
