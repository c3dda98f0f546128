//! Tests of `zoh.rs`.

use nalgebra::dmatrix;

use super::*;

fn scalar(a: f64, b: f64) -> StateSpace<Continuous> {
    StateSpace::<Continuous>::new(dmatrix![a], dmatrix![b], dmatrix![1.0], dmatrix![0.5])
        .expect("a system")
}

fn period(seconds: f64) -> SamplePeriod {
    SamplePeriod::new(seconds).expect("positive")
}

#[test]
fn first_order() {
    for (a, b, t) in [
        (-2.0, 3.0, 0.1),
        (0.5, 1e150, 1.0),
        (-1e-9, 1e-150, 1e-3),
        (-800.0, 7.0, 0.05),
        (0.0, 2.0, 3.0),
    ] {
        let sampled = scalar(a, b).zoh(period(t)).expect("samples");
        let ad = (a * t).exp();
        // At t = 40 time constants Ad is e^-40 and still relatively accurate.
        assert!((sampled.a()[0] - ad).abs() <= 1e-13 * ad, "{a}: {}", sampled.a()[0]);
        let bd = if a == 0.0 { b * t } else { b * (a * t).exp_m1() / a };
        assert!((sampled.b()[0] - bd).abs() <= 1e-15 * bd.abs(), "{a}: {} {bd}", sampled.b()[0]);
        assert_eq!((sampled.c()[0], sampled.d()[0], sampled.period()), (1.0, 0.5, period(t)));
    }
}

#[test]
fn columns_of_b_do_not_disturb_each_other() {
    let a = dmatrix![-0.3, 1.0; -2.0, -0.1];
    let b = dmatrix![1.0, 1e200, 1e-200; 2.0, 3e200, -1e-200];
    let c = DMatrix::identity(2, 2);
    let all = StateSpace::<Continuous>::new(a, b, c, DMatrix::zeros(2, 3)).expect("a system");
    let together = all.zoh(period(0.4)).expect("samples");
    for j in 0..3 {
        let alone = all.subsystem(&[0, 1], &[j]).and_then(|s| s.zoh(period(0.4))).expect("samples");
        let error = (together.b().column(j) - alone.b()).amax() / alone.b().amax();
        assert!(error < 1e-15, "column {j}: {error:e}");
    }
}

#[test]
fn empty_parts() {
    for (n, m) in [(0, 0), (0, 2), (2, 0)] {
        let system = StateSpace::<Continuous>::new(
            DMatrix::zeros(n, n),
            DMatrix::zeros(n, m),
            DMatrix::zeros(1, n),
            DMatrix::zeros(1, m),
        )
        .expect("a system");
        let sampled = system.zoh(period(0.1)).expect("samples");
        assert_eq!(sampled.a(), &DMatrix::identity(n, n));
        assert_eq!(sampled.b().shape(), (n, m));
    }
}

#[test]
fn overflow_is_an_error() {
    assert!(matches!(scalar(1e3, 1.0).zoh(period(1.0)), Err(LtiError::Overflow { .. })));
    assert!(matches!(scalar(1e300, 1.0).zoh(period(1e300)), Err(LtiError::Overflow { .. })));
    assert!(matches!(scalar(0.0, 1e300).zoh(period(1e300)), Err(LtiError::Overflow { .. })));
}
