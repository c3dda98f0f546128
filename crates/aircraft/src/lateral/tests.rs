use nalgebra::DMatrix;
use serde_json::Value;

use super::{LateralModel, LateralState, SideForceScaling, Surface};
use crate::{AircraftError, Inertia, LateralDerivatives, catalog};

/// Values in 60-digit arithmetic; see the README beside the file.
fn reference() -> Value {
    serde_json::from_str(include_str!("../../tests/data/aircraft.json")).unwrap()
}

fn matrix(value: &Value) -> DMatrix<f64> {
    let rows: Vec<Vec<f64>> = serde_json::from_value(value.clone()).unwrap();
    DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j])
}

fn paper() -> LateralModel {
    LateralModel::new(catalog::PAPER_AIRCRAFT.derivatives, catalog::PAPER_AIRCRAFT.inertia).unwrap()
}

/// Largest absolute difference of two matrices of one shape.
fn distance(ours: &DMatrix<f64>, expected: &DMatrix<f64>) -> f64 {
    assert_eq!(ours.shape(), expected.shape());
    (ours - expected).amax()
}

#[test]
fn the_matrices_agree_with_the_reference() {
    let reference = reference();
    for (scaling, key) in [
        (SideForceScaling::AsPrinted, "as_printed"),
        (SideForceScaling::Dimensional, "dimensional"),
    ] {
        let system = paper().state_space(&Surface::ALL, scaling, &LateralState::ALL).unwrap();
        assert!(distance(system.a(), &matrix(&reference[key]["A"])) < 1e-15, "{key}");
        assert!(distance(system.b(), &matrix(&reference[key]["B"])) < 2e-15, "{key}");
        assert_eq!(system.c(), &DMatrix::identity(4, 4));
        assert_eq!(system.d(), &DMatrix::zeros(4, 2));
    }
}

#[test]
fn the_eigenvalues_agree_with_the_reference() {
    let expected: Vec<[f64; 2]> = serde_json::from_value(reference()["spec_A"].clone()).unwrap();
    let found = paper().a().complex_eigenvalues();
    for [re, im] in expected {
        let nearest =
            found.iter().map(|s| (s.re - re).hypot(s.im - im)).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-13, "{re} {im}: {nearest:e}");
    }
}

#[test]
fn gamma_solves_the_coupled_moment_equations() {
    // Ixx p' - Ixz r' = Ixx L and Izz r' - Ixz p' = Izz N, for a body with strong coupling.
    let inertia = Inertia { ixx_slug_ft2: 2.0, izz_slug_ft2: 3.0, ixz_slug_ft2: 1.5 };
    let gamma = LateralModel::new(catalog::PAPER_AIRCRAFT.derivatives, inertia).unwrap().gamma();
    let (roll, yaw) = (5.0, -7.0);
    let accelerations = &gamma * DMatrix::from_column_slice(4, 1, &[11.0, roll, yaw, 13.0]);
    let (p, r) = (accelerations[1], accelerations[2]);
    assert!((2.0 * p - 1.5 * r - 2.0 * roll).abs() < 1e-13);
    assert!((3.0 * r - 1.5 * p - 3.0 * yaw).abs() < 1e-13);
    assert_eq!((accelerations[0], accelerations[3]), (11.0, 13.0));
}

/// Every derivative another number, so that an exchanged pair shows.
fn distinct() -> LateralDerivatives {
    LateralDerivatives {
        trim_speed_ft_s: 10.0,
        gravity_ft_s2: 30.0,
        y_beta_ft_s2: 1.0,
        y_p_ft_s: 2.0,
        y_r_ft_s: 3.0,
        l_beta_per_s2: 4.0,
        l_t_beta_per_s2: 0.5,
        l_p_per_s: 5.0,
        l_r_per_s: 6.0,
        n_beta_per_s2: 7.0,
        n_t_beta_per_s2: 0.25,
        n_p_per_s: 8.0,
        n_r_per_s: 9.0,
        y_aileron_ft_s2: 40.0,
        l_aileron_per_s2: 41.0,
        n_aileron_per_s2: 42.0,
        y_rudder_ft_s2: 50.0,
        l_rudder_per_s2: 51.0,
        n_rudder_per_s2: 52.0,
    }
}

const UNCOUPLED: Inertia = Inertia { ixx_slug_ft2: 2.0, izz_slug_ft2: 3.0, ixz_slug_ft2: 0.0 };

#[test]
fn every_derivative_has_its_place() {
    let model = LateralModel::new(distinct(), UNCOUPLED).unwrap();
    #[rustfmt::skip]
    let expected = DMatrix::from_row_slice(4, 4, &[
        0.1, 0.2, -0.7, 3.0,
        4.5, 5.0, 6.0, 0.0,
        7.25, 8.0, 9.0, 0.0,
        0.0, 1.0, 0.0, 0.0,
    ]);
    assert!(distance(&model.a(), &expected) < 1e-15);
    let column = |values: &[f64]| DMatrix::from_column_slice(4, 1, values);
    let control = |surface, scaling| model.control_matrix(surface, scaling);
    assert_eq!(
        control(Surface::Aileron, SideForceScaling::AsPrinted),
        column(&[40.0, 41.0, 42.0, 0.0])
    );
    assert_eq!(
        control(Surface::Aileron, SideForceScaling::Dimensional),
        column(&[4.0, 41.0, 42.0, 0.0])
    );
    assert_eq!(
        control(Surface::Rudder, SideForceScaling::AsPrinted),
        column(&[50.0, 51.0, 52.0, 0.0])
    );
    assert_eq!(
        control(Surface::Rudder, SideForceScaling::Dimensional),
        column(&[5.0, 51.0, 52.0, 0.0])
    );
}

#[test]
fn surfaces_and_outputs_keep_the_order_asked_for() {
    let model = LateralModel::new(distinct(), UNCOUPLED).unwrap();
    let outputs = [LateralState::YawRate, LateralState::BankAngle, LateralState::Sideslip];
    let surfaces = [Surface::Rudder, Surface::Aileron];
    let system = model.state_space(&surfaces, SideForceScaling::default(), &outputs).unwrap();
    assert_eq!((system.b()[(0, 0)], system.b()[(0, 1)]), (50.0, 40.0));
    #[rustfmt::skip]
    let expected = DMatrix::from_row_slice(3, 4, &[
        0.0, 0.0, 1.0, 0.0,
        0.0, 0.0, 0.0, 1.0,
        1.0, 0.0, 0.0, 0.0,
    ]);
    assert_eq!(system.c(), &expected);
    assert_eq!(system.d().shape(), (3, 2));
    assert_eq!(LateralState::ALL.map(LateralState::index), [0, 1, 2, 3]);
}

#[test]
fn nothing_asked_for_is_refused() {
    let none = paper().state_space(&[], SideForceScaling::AsPrinted, &LateralState::ALL);
    assert_eq!(none.err(), Some(AircraftError::NoSurface));
    let none = paper().state_space(&Surface::ALL, SideForceScaling::AsPrinted, &[]);
    assert_eq!(none.err(), Some(AircraftError::NoOutput));
}

#[test]
fn impossible_numbers_are_refused_by_name() {
    fn check(change: impl Fn(&mut LateralDerivatives, &mut Inertia), expected: &str) {
        let (mut derivatives, mut inertia) = (distinct(), UNCOUPLED);
        change(&mut derivatives, &mut inertia);
        let error = LateralModel::new(derivatives, inertia).unwrap_err();
        assert_eq!(error.to_string(), expected);
    }
    check(|d, _| d.trim_speed_ft_s = 0.0, "trim_speed_ft_s is 0, a positive number is needed");
    check(|d, _| d.gravity_ft_s2 = -32.0, "gravity_ft_s2 is -32, a positive number is needed");
    check(|d, _| d.n_rudder_per_s2 = f64::NAN, "n_rudder_per_s2 is NaN, a finite number is needed");
    check(|d, _| d.y_p_ft_s = f64::INFINITY, "y_p_ft_s is inf, a finite number is needed");
    check(|_, i| i.ixx_slug_ft2 = -1.0, "ixx_slug_ft2 is -1, a positive number is needed");
    check(
        |_, i| i.ixz_slug_ft2 = 3.0,
        "Ixx Izz = 6 does not exceed Ixz^2 = 9, so that the inertia matrix is not positive definite",
    );
    let mut derivatives = distinct();
    derivatives.l_p_per_s = 1e308;
    let inertia = Inertia { ixz_slug_ft2: 2.4494, ..UNCOUPLED };
    let model = LateralModel::new(derivatives, inertia).unwrap();
    let overflow =
        model.state_space(&Surface::ALL, SideForceScaling::AsPrinted, &LateralState::ALL);
    assert!(matches!(overflow, Err(AircraftError::InvalidModel { .. })));
}
