//! Tests of `transfer_function.rs`.
#![expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")]

use nalgebra::dmatrix;

use super::*;
use crate::Continuous;

fn siso(a: DMatrix<f64>, b: &[f64], c: &[f64], d: f64) -> StateSpace<Continuous> {
    let n = a.nrows();
    StateSpace::<Continuous>::new(
        a,
        DMatrix::from_column_slice(n, 1, b),
        DMatrix::from_row_slice(1, n, c),
        DMatrix::from_element(1, 1, d),
    )
    .expect("a system")
}

#[test]
fn vanishing_leading_coefficients_are_dropped() {
    // c b = 0.1 + 0.2 - 0.3 = 5.6e-17 in doubles: the rounding of 0.1, 0.2, 0.3 explains it.
    let a = dmatrix![-1.0, 0.0, 0.0; 0.0, -2.0, 0.0; 0.0, 0.0, -3.0];
    let system = siso(a.clone(), &[0.1, 0.2, -0.3], &[1.0, 1.0, 1.0], 0.0);
    let g = system.transfer_function(0, 0).expect("a transfer function");
    assert_eq!(g.numerator().degree(), Some(1));
    // 1e-10 it does not explain.
    let system = siso(a, &[0.1, 0.2, -0.3 + 1e-10], &[1.0, 1.0, 1.0], 0.0);
    assert_eq!(
        system.transfer_function(0, 0).expect("a transfer function").numerator().degree(),
        Some(2)
    );
}

#[test]
fn a_feedthrough_is_kept_however_small() {
    let g = siso(dmatrix![-1.0], &[1.0], &[1.0], 1e-30)
        .transfer_function(0, 0)
        .expect("a transfer function");
    assert_eq!(g.numerator().coefficients(), [1.0, 1e-30]);
}

#[test]
fn hard_cancellation_is_exact() {
    // det [x+1e8, 1; 1, x+1e-8] = x^2 + (1e8 + 1e-8) x + (1e8 * 1e-8 - 1): the last term is the rounding of 1e-8.
    let system = siso(dmatrix![-1e8, 1.0; 1.0, -1e-8], &[0.0, 1.0], &[0.0, 1.0], 0.0);
    let delta = system.resolvent_numerators().expect("polynomials").delta;
    let exact = 1e8_f64.mul_add(1e-8, -1.0);
    assert!(exact != 0.0);
    assert_eq!(delta.coefficients(), [exact, 1e8 + 1e-8, 1.0]);
}

#[test]
fn scales() {
    for size in [1e-150, 1e-40, 1e40, 1e150] {
        // (p + 3 s)/(p^2 + 3 s p + 2 s^2)
        let system = siso(dmatrix![0.0, 1.0; -2.0, -3.0] * size, &[1.0, 0.0], &[1.0, 0.0], 0.0);
        let g = system.transfer_function(0, 0).expect("in range");
        for (x, y) in g.numerator().coefficients().iter().zip([3.0 * size, 1.0]) {
            assert!((x / y - 1.0).abs() < 1e-15);
        }
        for (x, y) in
            g.denominator().coefficients().iter().zip([2.0 * size * size, 3.0 * size, 1.0])
        {
            assert!((x / y - 1.0).abs() < 1e-15);
        }
    }
    for size in [1e-200, 1e200] {
        let system = siso(dmatrix![0.0, 1.0; -2.0, -3.0] * size, &[1.0, 0.0], &[1.0, 0.0], 0.0);
        assert!(
            matches!(system.transfer_function(0, 0), Err(LtiError::Overflow { .. })),
            "{size:e}"
        );
    }
}

#[test]
fn a_long_chain_of_lags() {
    // 1/(p + 1)^20: binomial coefficients, exactly.
    let n = 20;
    let a = DMatrix::from_fn(n, n, |i, j| {
        if i == j {
            -1.0
        } else if i == j + 1 {
            1.0
        } else {
            0.0
        }
    });
    let mut b = vec![0.0; n];
    b[0] = 1.0;
    let mut c = vec![0.0; n];
    c[n - 1] = 1.0;
    let g = siso(a, &b, &c, 0.0).transfer_function(0, 0).expect("a transfer function");
    assert_eq!(g.numerator().coefficients(), [1.0]);
    let mut binomial = 1.0;
    for (k, x) in g.denominator().coefficients().iter().enumerate() {
        assert_eq!(*x, binomial);
        binomial = binomial * (n - k) as f64 / (k + 1) as f64;
    }
}

#[test]
fn channels_out_of_range() {
    let system = siso(dmatrix![-1.0], &[1.0], &[1.0], 0.0);
    assert!(matches!(
        system.transfer_function(1, 0),
        Err(LtiError::NoSuchChannel { kind: "output", .. })
    ));
    assert!(matches!(
        system.transfer_function(0, 2),
        Err(LtiError::NoSuchChannel { kind: "input", .. })
    ));
}
