//! Tests of `modes.rs`.
#![expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")]

use nalgebra::{DMatrix, dmatrix};

use super::*;

fn c(re: f64, im: f64) -> Complex<f64> {
    Complex::new(re, im)
}

#[test]
fn what_an_eigenvalue_means() {
    let check = |s,
                 kind,
                 frequency: f64,
                 damping: f64,
                 period: Option<f64>,
                 constant: Option<f64>,
                 half: f64| {
        let mode = Mode::from_eigenvalue(s).expect("finite");
        assert_eq!(mode.kind, kind, "{s}");
        assert_eq!(mode.eigenvalue.im, s.im.abs());
        assert_eq!((mode.natural_frequency_rad_s, mode.damping_ratio), (frequency, damping), "{s}");
        assert_eq!((mode.period_s, mode.time_constant_s), (period, constant), "{s}");
        assert_eq!(mode.time_to_half_or_double_s, half, "{s}");
    };
    use ModeKind::{Oscillatory, Real};
    check(c(-0.5, 0.0), Real, 0.5, 1.0, None, Some(2.0), LN_2 / 0.5);
    check(c(0.25, 0.0), Real, 0.25, -1.0, None, Some(-4.0), LN_2 / 0.25);
    check(c(0.0, 0.0), Real, 0.0, 0.0, None, Some(f64::INFINITY), f64::INFINITY);
    check(c(-3.0, 4.0), Oscillatory, 5.0, 0.6, Some(TAU / 4.0), None, LN_2 / 3.0);
    check(c(3.0, -4.0), Oscillatory, 5.0, -0.6, Some(TAU / 4.0), None, LN_2 / 3.0);
    check(c(0.0, 2.0), Oscillatory, 2.0, 0.0, Some(TAU / 2.0), None, f64::INFINITY);
    let huge = 2.0_f64.powi(660);
    let half = LN_2 / (3.0 * huge);
    check(c(-3.0, 4.0) * huge, Oscillatory, 5.0 * huge, 0.6, Some(TAU / (4.0 * huge)), None, half);
    assert!(Mode::from_eigenvalue(c(f64::NAN, 0.0)).is_err());
    assert!(Mode::from_eigenvalue(c(0.0, f64::INFINITY)).is_err());
}

#[test]
fn discrete_eigenvalues() {
    let period = SamplePeriod::new(0.5).expect("positive");
    let mode = |z| Mode::from_discrete_eigenvalue(z, period).expect("finite");
    let sampled = mode((c(-0.2, -3.0) * 0.5).exp());
    assert!((sampled.eigenvalue - c(-0.2, 3.0)).norm() < 1e-14);
    let alternating = mode(c(-1.0, 0.0));
    assert_eq!(alternating.kind, ModeKind::Oscillatory);
    assert_eq!(alternating.period_s, Some(1.0));
    let deadbeat = mode(c(0.0, 0.0));
    assert_eq!((deadbeat.kind, deadbeat.time_constant_s), (ModeKind::Deadbeat, Some(0.0)));
    assert!(Mode::from_discrete_eigenvalue(c(f64::NAN, 0.0), period).is_err());
}

#[test]
fn modes_of_a_sampled_system_are_those_of_the_system() {
    let a = dmatrix![-0.5, 0.0, 0.0; 0.3, -0.1, 2.0; 0.0, -2.0, -0.1];
    let system = StateSpace::<Continuous>::new(
        a,
        DMatrix::zeros(3, 1),
        DMatrix::zeros(1, 3),
        DMatrix::zeros(1, 1),
    )
    .expect("a system");
    let sampled = system.zoh(SamplePeriod::new(0.1).expect("positive")).expect("samples");
    let (direct, back) = (system.modes().expect("modes"), sampled.modes().expect("modes"));
    assert_eq!((direct.len(), back.len()), (2, 2));
    for (x, y) in direct.iter().zip(&back) {
        assert!((x.eigenvalue - y.eigenvalue).norm() < 1e-14);
        let (v, w) = (x.eigenvector.as_ref().expect("v"), y.eigenvector.as_ref().expect("v"));
        assert!((v - w).norm() < 1e-13, "{v} {w}");
    }
    assert_eq!(direct[0].kind, ModeKind::Real);
    assert_eq!(direct[1].kind, ModeKind::Oscillatory);
}

#[test]
fn a_shift_register_is_deadbeat() {
    let register = StateSpace::<Discrete>::new(
        dmatrix![0.0, 0.0; 1.0, 0.0],
        DMatrix::zeros(2, 0),
        DMatrix::zeros(0, 2),
        DMatrix::zeros(0, 0),
        SamplePeriod::new(1.0).expect("positive"),
    )
    .expect("a system");
    let modes = register.modes().expect("modes");
    assert_eq!(modes.len(), 2);
    assert!(
        modes.iter().all(|mode| mode.kind == ModeKind::Deadbeat && mode.condition > Some(1e14))
    );
}

#[test]
fn eigenvalues_beyond_the_range_are_an_error() {
    let a = DMatrix::from_element(2, 2, f64::MAX);
    let (b, c, d) = (DMatrix::zeros(2, 0), DMatrix::zeros(0, 2), DMatrix::zeros(0, 0));
    let system = StateSpace::<Continuous>::new(a.clone(), b.clone(), c.clone(), d.clone())
        .expect("a system");
    assert!(matches!(system.modes(), Err(LtiError::Overflow { .. })));
    assert!(matches!(system.poles(), Err(LtiError::Overflow { .. })));
    let period = SamplePeriod::new(1.0).expect("a period");
    let sampled = StateSpace::<Discrete>::new(a, b, c, d, period).expect("a system");
    assert!(matches!(sampled.modes(), Err(LtiError::Overflow { .. })));
}
