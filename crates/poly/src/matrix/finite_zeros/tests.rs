//! Tests of finite zeros with planted answers.

use crate::{Complex, Poly, PolyError, PolyMatrix};

type C = Complex<f64>;

fn p(descending: &[f64]) -> Poly<f64> {
    Poly::from_descending(descending)
}

/// Expects the given zeros, each to a relative error, and residuals at rounding level.
fn check(matrix: &PolyMatrix<f64>, expected: &[C], infinite: usize, tolerance: f64) {
    let found = matrix.finite_zeros().unwrap();
    assert!(found.converged && !found.singular, "{found:#?}");
    assert_eq!(found.infinite, infinite);
    assert_eq!(found.zeros.len(), expected.len(), "{found:#?}");
    let mut rest = found.zeros;
    for z in expected {
        let k = (0..rest.len())
            .min_by(|&i, &j| (rest[i].value - z).norm().total_cmp(&(rest[j].value - z).norm()))
            .unwrap();
        let zero = rest.swap_remove(k);
        let error = (zero.value - z).norm() / z.norm().max(f64::MIN_POSITIVE);
        assert!(error <= tolerance || zero.value == *z, "{z}: {zero:?}, error {error:e}");
        assert!(zero.residual < 1e-15, "{zero:?}");
        assert!(zero.condition.is_finite());
    }
}

fn real(list: &[f64]) -> Vec<C> {
    list.iter().map(|&re| C::new(re, 0.0)).collect()
}

#[test]
fn scalars() {
    check(&PolyMatrix::new(1, 1, vec![p(&[2.0, -6.0])]).unwrap(), &real(&[3.0]), 0, 1e-15);
    let pair = [C::new(1.0, 2.0), C::new(1.0, -2.0)];
    check(&PolyMatrix::new(1, 1, vec![p(&[1.0, -2.0, 5.0])]).unwrap(), &pair, 0, 1e-15);
    let cubic = PolyMatrix::new(1, 1, vec![p(&[1.0, -6.0, 11.0, -6.0])]).unwrap();
    check(&cubic, &real(&[1.0, 2.0, 3.0]), 0, 1e-14);
}

#[test]
fn constants_have_no_zeros() {
    let identity = PolyMatrix::<f64>::identity(3);
    check(&identity, &[], 0, 0.0);
    let empty = PolyMatrix::<f64>::new(0, 0, vec![]).unwrap();
    assert!(empty.finite_zeros().unwrap().zeros.is_empty());
}

#[test]
fn real_pencils_with_complex_eigenvalues() {
    // pI - [0 1; -5 2]: 1 +- 2j. A real 2 x 2 pencil with complex eigenvalues.
    let m = PolyMatrix::linear(2, 2, &[1.0, 0.0, 0.0, 1.0], &[0.0, 1.0, -5.0, 2.0]).unwrap();
    check(&m, &[C::new(1.0, 2.0), C::new(1.0, -2.0)], 0, 1e-15);
}

#[test]
fn zeros_of_the_aircraft_model() {
    // Numerators with sideslip and roll rate; the determinant has six roots within 0.2 of 1.
    let m = PolyMatrix::new(
        2,
        2,
        vec![
            p(&[
                0.0016846301431633517,
                -0.0012792818546213062,
                -0.0018293608429004304,
                0.0014295684155943402,
            ]),
            p(&[1.0435255518964366, -3.0577891805323882, 2.9862515503840714, -0.9719893917407894]),
            p(&[0.6615911761644987, -1.9516212022944015, 1.9356664372154835, -0.6456364110855805]),
            p(&[
                -0.15242147920806573,
                0.033046535695851344,
                0.3858587615793369,
                -0.2664838180671225,
            ]),
        ],
    )
    .unwrap();
    let found = m.finite_zeros().unwrap();
    assert!(found.converged);
    let expected = [
        C::new(0.9469052112129244, 0.0),
        C::new(0.9739842532952001, 0.0),
        C::new(0.9787910820433616, 0.16717777123296856),
        C::new(0.9787910820433616, -0.16717777123296856),
        C::new(0.9998436484022597, 0.0),
        C::new(1.0, 0.0),
    ];
    assert_eq!(found.zeros.len(), 6);
    for (zero, expected) in found.zeros.iter().zip(expected) {
        // The coefficients are rounded, so only condition times rounding can be had.
        let error = (zero.value - expected).norm();
        assert!(error <= 2.0 * f64::EPSILON * zero.condition, "{expected}: {error:e}, {zero:?}");
    }
}

#[test]
fn infinite_zeros_are_counted() {
    // diag(1, p - 2) with a unimodular factor: degree 1 out of a pencil of size 2 * 2.
    let left =
        PolyMatrix::new(2, 2, vec![p(&[1.0]), p(&[1.0, 0.0, 3.0]), p(&[]), p(&[1.0])]).unwrap();
    let middle = PolyMatrix::new(2, 2, vec![p(&[1.0]), p(&[]), p(&[]), p(&[1.0, -2.0])]).unwrap();
    let m = left.product(&middle).unwrap();
    assert_eq!(m.degree(), Some(3));
    check(&m, &real(&[2.0]), 5, 1e-14);
    // Rosenbrock's matrix of 1/(p + 1): no finite zeros, one infinite pair.
    let r = PolyMatrix::linear(2, 2, &[1.0, 0.0, 0.0, 0.0], &[-1.0, 1.0, -1.0, 0.0]).unwrap();
    check(&r, &[], 2, 0.0);
}

#[test]
fn singular_matrices_are_reported() {
    let rank_one =
        PolyMatrix::new(2, 2, vec![p(&[1.0, 2.0]), p(&[2.0, 4.0]), p(&[3.0]), p(&[6.0])]).unwrap();
    let found = rank_one.finite_zeros().unwrap();
    assert!(found.singular && found.zeros.is_empty());
    assert_eq!(found.normal_rank, 1);
    let zero = PolyMatrix::new(2, 2, vec![Poly::zero(); 4]).unwrap().finite_zeros().unwrap();
    assert!(zero.singular);
    assert_eq!(zero.normal_rank, 0);
    let wide = PolyMatrix::from_constant(1, 2, &[1.0, 2.0]).unwrap();
    assert_eq!(wide.finite_zeros(), Err(PolyError::NotSquare { rows: 1, columns: 2 }));
}

#[test]
fn scales_do_not_matter() {
    // Quadratic 3 x 3 with zeros 1..6 planted as a product, at scales of 2^+-300.
    let line = |a: f64, b: f64, c: f64| {
        PolyMatrix::linear(
            3,
            3,
            &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
            &[a, 1.0, 0.5, 0.0, b, 2.0, 0.0, 0.0, c],
        )
        .unwrap()
    };
    let m = line(1.0, 2.0, 3.0).product(&line(4.0, 5.0, 6.0).transpose()).unwrap();
    check(&m, &real(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]), 0, 1e-12);
    for exponent in [-300, 300] {
        let scale = 2f64.powi(exponent);
        let scaled = m.map(|entry| entry.scale(&scale));
        assert_eq!(scaled.finite_zeros().unwrap().zeros, m.finite_zeros().unwrap().zeros);
        let small = 2f64.powi(exponent / 3);
        let stretched = m.map(|entry| {
            Poly::new((0..3).map(|k| entry.coefficient(k as usize) * small.powi(-k)).collect())
        });
        let zeros: Vec<C> = (1..=6).map(|k| C::new(f64::from(k) * small, 0.0)).collect();
        check(&stretched, &zeros, 0, 1e-12);
    }
}

#[test]
fn more_zeros_than_a_polynomial_would_bear() {
    // diag(p - 1, ..., p - 20) hidden by constant transformations: expanded, this is Wilkinson's polynomial.
    let n = 20;
    let mut left = vec![0.0; n * n];
    let mut right = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..n {
            let angle = (2 * i + 1) as f64 * j as f64 * std::f64::consts::PI / (2 * n) as f64;
            let weight = if j == 0 { (1.0 / n as f64).sqrt() } else { (2.0 / n as f64).sqrt() };
            left[i * n + j] = weight * angle.cos();
            right[j * n + i] = weight * angle.cos();
        }
    }
    let diagonal: Vec<Poly<f64>> = (0..n * n)
        .map(|k| if k / n == k % n { p(&[1.0, -((k / n + 1) as f64)]) } else { Poly::zero() })
        .collect();
    let left = PolyMatrix::from_constant(n, n, &left).unwrap();
    let right = PolyMatrix::from_constant(n, n, &right).unwrap();
    let m =
        left.product(&PolyMatrix::new(n, n, diagonal).unwrap()).unwrap().product(&right).unwrap();
    let expected: Vec<C> = (1..=20).map(|k| C::new(f64::from(k), 0.0)).collect();
    check(&m, &expected, 0, 1e-13);
}
