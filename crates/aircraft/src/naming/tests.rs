use lti::{Continuous, StateSpace};
use nalgebra::DMatrix;
use num_complex::Complex;
use proptest::prelude::*;

use super::{
    Eigenpair, Evidence, NamedMode, name_eigenvalues, name_modes, name_neutrally, name_system_modes,
};
use crate::{
    AircraftClass, AircraftError, FlightPhaseCategory, FlyingQualityLevel, Inertia,
    LateralDerivatives, LateralModel, LateralState, ModeName, ModeShape, SideForceScaling, Surface,
    WhyUnnamed, catalog, level,
};

use ModeName::{
    CoupledRollSpiral, DutchRoll, DutchRollRealRoot, Integrator, Oscillatory, Real, RollSubsidence,
    Spiral, Unnamed,
};

fn complex(re: f64, im: f64) -> Complex<f64> {
    Complex::new(re, im)
}

/// Names of the paper's aircraft with changed derivatives, sorted by real and imaginary part.
fn modes_of(change: impl Fn(&mut LateralDerivatives)) -> Vec<NamedMode> {
    let mut derivatives = catalog::PAPER_AIRCRAFT.derivatives;
    change(&mut derivatives);
    let model = LateralModel::new(derivatives, catalog::PAPER_AIRCRAFT.inertia).unwrap();
    let system =
        model.state_space(&Surface::ALL, SideForceScaling::AsPrinted, &LateralState::ALL).unwrap();
    let mut modes = name_system_modes(&system).unwrap();
    modes.sort_by(|a, b| a.eigenvalue.re.total_cmp(&b.eigenvalue.re));
    modes
}

fn find(modes: &[NamedMode], name: ModeName) -> NamedMode {
    let found: Vec<&NamedMode> = modes.iter().filter(|mode| mode.name == name).collect();
    assert_eq!(found.len(), 1, "{name} in {modes:?}");
    *found[0]
}

fn agreement(mode: &NamedMode) -> f64 {
    match mode.evidence {
        Evidence::Shape { agreement, .. } => agreement,
        _ => panic!("no shape: {mode:?}"),
    }
}

#[test]
fn the_paper_s_aircraft_has_its_three_modes() {
    let modes = modes_of(|_| ());
    let roll = find(&modes, RollSubsidence);
    let spiral = find(&modes, Spiral);
    let dutch_roll = find(&modes, DutchRoll);
    assert!((roll.eigenvalue - complex(-0.5455628456192483, 0.0)).norm() < 1e-12);
    assert!((spiral.eigenvalue - complex(-0.0015636382192560033, 0.0)).norm() < 1e-12);
    assert!(
        (dutch_roll.eigenvalue - complex(-0.07059406770370226, 1.6916783619584712)).norm() < 1e-12
    );
    for mode in &modes {
        assert!(agreement(mode) > 0.75, "{mode:?}");
    }
    // |phi/beta| of the roll equation: (lambda^2 - L_p lambda) phi = L_beta beta + L_r r.
    let Evidence::Shape { bank_to_sideslip: Some(ratio), .. } = dutch_roll.evidence else {
        panic!("{dutch_roll:?}")
    };
    assert!((1.0..2.0).contains(&ratio), "{ratio}");
}

#[test]
fn an_unstable_spiral_and_an_unstable_dutch_roll_keep_their_names() {
    let modes = modes_of(|d| d.l_r_per_s = 0.6);
    assert!(find(&modes, Spiral).eigenvalue.re > 0.02);
    assert!(find(&modes, RollSubsidence).eigenvalue.re < -0.3);

    let modes = modes_of(|d| d.n_r_per_s = 0.2);
    assert!(find(&modes, DutchRoll).eigenvalue.re > 0.0);
}

#[test]
fn a_divergent_spiral_as_fast_as_the_roll_keeps_its_name() {
    // No dihedral, little roll damping, a strong roll due to yaw: both real modes roll more than they turn, 0.71 and 0.68.
    let modes = modes_of(|d| {
        d.l_beta_per_s2 = -0.1;
        d.l_p_per_s = -0.02;
        d.l_r_per_s = 0.4;
        d.n_p_per_s = -0.1;
    });
    let (spiral, roll) = (find(&modes, Spiral), find(&modes, RollSubsidence));
    assert!(
        (spiral.eigenvalue.re - 0.1623).abs() < 1e-3 && (roll.eigenvalue.re + 0.1911).abs() < 1e-3
    );
}

#[test]
fn roll_and_spiral_can_merge() {
    // Weak roll damping, adverse yaw due to roll: two pairs.
    let modes = modes_of(|d| {
        d.l_p_per_s = -0.05;
        d.l_beta_per_s2 = -8.0;
        d.n_r_per_s = -0.4;
    });
    assert_eq!(modes.len(), 2, "{modes:?}");
    let slow = find(&modes, CoupledRollSpiral);
    let fast = find(&modes, DutchRoll);
    assert!(slow.eigenvalue.norm() < fast.eigenvalue.norm());
    assert!(agreement(&slow) > 0.5 && agreement(&fast) > 0.5, "{modes:?}");
}

#[test]
fn without_weathercock_stability_the_dutch_roll_is_two_real_roots() {
    let modes = modes_of(|d| {
        d.n_beta_per_s2 = -2.0;
        d.l_beta_per_s2 = 0.0;
        d.l_p_per_s = -2.0;
    });
    assert_eq!(modes.len(), 4, "{modes:?}");
    let real_roots: Vec<&NamedMode> =
        modes.iter().filter(|mode| mode.name == DutchRollRealRoot).collect();
    assert_eq!(real_roots.len(), 2, "{modes:?}");
    assert!(real_roots.iter().any(|mode| mode.eigenvalue.re > 0.5));
    assert!((find(&modes, RollSubsidence).eigenvalue.re + 2.0).abs() < 0.1);
    assert!(find(&modes, Spiral).eigenvalue.norm() < 0.2);
}

#[test]
fn sensors_and_any_scale_of_the_vector_give_the_same_names() {
    let model =
        LateralModel::new(catalog::PAPER_AIRCRAFT.derivatives, catalog::PAPER_AIRCRAFT.inertia)
            .unwrap();
    let system =
        model.state_space(&Surface::ALL, SideForceScaling::AsPrinted, &LateralState::ALL).unwrap();
    let pairs: Vec<Eigenpair> = system
        .modes()
        .unwrap()
        .iter()
        .map(|mode| {
            let v = mode.eigenvector.as_ref().unwrap() * complex(-3.0, 40.0);
            Eigenpair {
                eigenvalue: mode.eigenvalue,
                shape: Some(ModeShape::from_sensors(v[0], v[1], v[2])),
            }
        })
        .collect();
    let by_state = name_system_modes(&system).unwrap();
    for (ours, expected) in name_modes(&pairs).unwrap().iter().zip(&by_state) {
        assert_eq!(ours.name, expected.name);
        assert!((agreement(ours) - agreement(expected)).abs() < 1e-12);
    }
}

#[test]
fn eigenvalues_alone_name_complete_sets_only() {
    fn check(eigenvalues: &[(f64, f64)], expected: &[ModeName]) {
        let eigenvalues: Vec<Complex<f64>> =
            eigenvalues.iter().map(|&(re, im)| complex(re, im)).collect();
        let modes = name_eigenvalues(&eigenvalues).unwrap();
        assert_eq!(
            modes.iter().map(|mode| mode.name).collect::<Vec<_>>(),
            expected,
            "{eigenvalues:?}"
        );
        for mode in modes {
            let named = !matches!(mode.name, Unnamed(_));
            assert_eq!(mode.evidence == Evidence::EigenvaluePattern, named);
        }
    }
    let missing = |real, pairs| Unnamed(WhyUnnamed::IncompleteSet { real, pairs });
    check(
        &[(-0.5, 0.0), (-0.1, 1.7), (-0.1, -1.7), (-0.001, 0.0)],
        &[RollSubsidence, DutchRoll, Spiral],
    );
    check(&[(0.02, 0.0), (-0.5, 0.0), (0.1, -1.7)], &[Spiral, RollSubsidence, DutchRoll]);
    check(&[(-0.1, 0.2), (-0.1, 1.7), (-0.1, -1.7), (-0.1, -0.2)], &[CoupledRollSpiral, DutchRoll]);
    check(&[(-0.1, 1.7), (-0.1, -1.7), (-0.5, 0.0)], &[missing(1, 1), missing(1, 1)]);
    check(&[(-0.1, 1.7)], &[missing(0, 1)]);
    check(&[(-2.0, 0.0), (1.0, 0.0), (-0.5, 0.0), (0.0, 0.0)], &[missing(4, 0); 4]);
    let equal = Unnamed(WhyUnnamed::EqualEigenvalues);
    check(&[(-0.5, 0.0), (-0.1, 1.7), (-0.5, 0.0)], &[equal, DutchRoll, equal]);
    check(&[(0.0, 0.0), (-0.1, 1.7), (0.0, 0.0)], &[equal, DutchRoll, equal]);
    check(&[], &[]);
}

#[test]
fn a_system_that_is_no_aircraft_has_neutral_names() {
    let found = [(-0.5, 0.0), (-0.1, 1.7), (-0.1, -1.7), (1.01e-4, 0.0), (9.9e-5, 0.0), (0.0, 0.0)];
    let eigenvalues: Vec<Complex<f64>> = found.iter().map(|&(re, im)| complex(re, im)).collect();
    let modes = name_neutrally(&eigenvalues, 100.0).unwrap();
    let names: Vec<ModeName> = modes.iter().map(|mode| mode.name).collect();
    assert_eq!(names, [Real, Oscillatory, Real, Integrator, Integrator]);
    for mode in &modes {
        assert_eq!(mode.evidence, Evidence::EigenvaluePattern);
        assert_eq!(level(mode, AircraftClass::I, FlightPhaseCategory::A), None);
    }
    for length_s in [0.0, -1.0, f64::NAN] {
        assert!(name_neutrally(&eigenvalues, length_s).is_err());
    }
}

#[test]
fn a_pair_counts_once_however_it_is_given() {
    let found = name_eigenvalues(&[complex(-0.1, -1.7), complex(-0.1, 1.7)]).unwrap();
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].eigenvalue, complex(-0.1, 1.7));
    let lower = name_eigenvalues(&[complex(-0.1, -1.7)]).unwrap();
    assert_eq!(lower[0].eigenvalue, complex(-0.1, 1.7));
    // Two equal pairs are two modes.
    let twice = [complex(-0.1, 1.7), complex(-0.1, -1.7), complex(-0.1, 1.7), complex(-0.1, -1.7)];
    assert_eq!(name_eigenvalues(&twice).unwrap().len(), 2);
    // The lower member's vector is conjugated with it: r = -lambda beta is pure slip for either member.
    for eigenvalue in [complex(-0.1, 1.7), complex(-0.1, -1.7)] {
        let shape =
            Some(ModeShape::from_sensors(complex(1.0, 0.0), complex(0.0, 0.0), -eigenvalue));
        let named = name_modes(&[Eigenpair { eigenvalue, shape }]).unwrap();
        assert_eq!((named[0].name, agreement(&named[0])), (DutchRoll, 1.0));
    }
}

#[test]
fn a_mode_of_an_incomplete_set_is_named_by_its_own_shape() {
    let real = |value: f64| complex(value, 0.0);
    let banking = |rate: f64, yaw_rate: f64| Eigenpair {
        eigenvalue: real(rate),
        shape: Some(ModeShape::from_sensors(real(0.0), real(rate), real(yaw_rate))),
    };
    let names = |pairs: &[Eigenpair]| -> Vec<ModeName> {
        name_modes(pairs).unwrap().iter().map(|mode| mode.name).collect()
    };
    assert_eq!(names(&[banking(-0.7, 0.05)]), [RollSubsidence]);
    assert_eq!(names(&[banking(-0.01, 0.05)]), [Spiral]);
    assert_eq!(names(&[banking(-0.01, 0.05), banking(-0.7, 0.05)]), [Spiral, RollSubsidence]);
    let third = names(&[banking(-0.01, 0.05), banking(-0.7, 0.05), banking(-30.0, 0.05)]);
    assert_eq!(third, [Spiral, RollSubsidence, Unnamed(WhyUnnamed::BetterClaim)]);

    let still = Some(ModeShape::from_sensors(real(0.0), real(0.0), real(0.0)));
    let named = name_modes(&[Eigenpair { eigenvalue: real(0.0), shape: still }]).unwrap();
    assert_eq!(
        (named[0].name, named[0].evidence),
        (Unnamed(WhyUnnamed::NoLateralMotion), Evidence::None)
    );
}

#[test]
fn one_missing_shape_leaves_the_eigenvalues() {
    let slip = ModeShape::from_sensors(complex(1.0, 0.0), complex(0.0, 0.0), complex(0.5, 0.0));
    let pair = Eigenpair { eigenvalue: complex(-0.1, 1.7), shape: None };
    let real = |re: f64| Eigenpair { eigenvalue: complex(re, 0.0), shape: Some(slip) };
    let names: Vec<ModeName> = name_modes(&[real(-0.5), pair, real(-0.01)])
        .unwrap()
        .iter()
        .map(|mode| mode.name)
        .collect();
    assert_eq!(names, [RollSubsidence, DutchRoll, Spiral]);
}

#[test]
fn what_is_not_finite_or_not_lateral_is_refused() {
    let infinite = name_eigenvalues(&[complex(f64::INFINITY, 0.0)]);
    assert_eq!(
        infinite,
        Err(AircraftError::NotFinite { name: "eigenvalue", value: f64::INFINITY })
    );
    let shape =
        Some(ModeShape::from_sensors(complex(f64::NAN, 0.0), complex(0.0, 0.0), complex(0.0, 0.0)));
    assert!(name_modes(&[Eigenpair { eigenvalue: complex(-1.0, 0.0), shape }]).is_err());

    let a = DMatrix::identity(3, 3);
    let system = StateSpace::<Continuous>::new(
        a,
        DMatrix::zeros(3, 1),
        DMatrix::zeros(1, 3),
        DMatrix::zeros(1, 1),
    );
    assert_eq!(name_system_modes(&system.unwrap()), Err(AircraftError::WrongOrder { found: 3 }));
}

proptest! {
    /// A decoupled aircraft: roll at `L_p`, spiral at 0 without gravity's help, Dutch roll from sideslip and yaw alone.
    #[test]
    fn planted_modes_are_named(
        roll in -6.0..-0.05_f64,
        weathercock in 0.5..9.0_f64,
        yaw_damping in -0.3..0.1_f64,
        speed in 150.0..900.0_f64,
    ) {
        let derivatives = LateralDerivatives {
            trim_speed_ft_s: speed,
            y_beta_ft_s2: 0.0,
            y_r_ft_s: 0.0,
            l_beta_per_s2: 0.0,
            l_p_per_s: roll,
            l_r_per_s: 0.0,
            n_beta_per_s2: weathercock,
            n_p_per_s: 0.0,
            n_r_per_s: yaw_damping,
            ..catalog::PAPER_AIRCRAFT.derivatives
        };
        let inertia = Inertia { ixz_slug_ft2: 0.0, ..catalog::PAPER_AIRCRAFT.inertia };
        let model = LateralModel::new(derivatives, inertia).unwrap();
        let system = model.state_space(&Surface::ALL, SideForceScaling::Dimensional, &LateralState::ALL).unwrap();
        let modes = name_system_modes(&system).unwrap();
        prop_assert!((find(&modes, RollSubsidence).eigenvalue - roll).norm() < 1e-9);
        prop_assert!(find(&modes, Spiral).eigenvalue.norm() < 1e-9);
        // lambda^2 - N_r lambda + N_beta = 0.
        let expected = complex(yaw_damping / 2.0, (weathercock - yaw_damping * yaw_damping / 4.0).sqrt());
        prop_assert!((find(&modes, DutchRoll).eigenvalue - expected).norm() < 1e-9);
    }
}

/// Cases of `tests/data/lateral.json` in which another mode is taken for the roll subsidence or the spiral: it rolls or
/// turns with even less sideslip than theirs, at a speed that fits better.
const CONFUSED: [&str; 5] = [
    // A Cub rolls faster than these actuators.
    "J3Cub, aileron actuator of 5 rad/s",
    "J3Cub, aileron actuator of 10 rad/s",
    // The roll subsidence of the A-4 slips, 0.2 rad of sideslip per radian of bank, the filter's mode does not.
    "A4, yaw damper with a washout of 1 s",
    // Its spiral, at -0.3 1/s, is faster than the filter and the slow state, which turn alike.
    "A4, yaw damper with a washout of 4 s",
    "A4, slow coupling",
];

/// The aircraft of `tests/data/lateral.json`, each with what brings a fifth mode. A merged roll subsidence has no name.
#[test]
fn every_aircraft_has_its_modes_whatever_is_added() {
    let cases = cases();
    let is_confused = |case: &&Case| {
        [Bank::Measured, Bank::FromRollRate].into_iter().any(|bank| {
            !has_names(&name_modes(&eigenpairs(&case.a, bank)).unwrap(), &case.expected)
        })
    };
    let confused: Vec<&str> =
        cases.iter().filter(is_confused).map(|case| case.name.as_str()).collect();
    assert_eq!(cases.len(), 128);
    assert_eq!(confused, CONFUSED);
}

/// A matrix of `tests/data/lateral.json` and the eigenvalues that the names belong to.
#[derive(Clone, Debug)]
struct Case {
    name: String,
    a: DMatrix<f64>,
    expected: [(ModeName, Option<Complex<f64>>); 3],
}

fn cases() -> Vec<Case> {
    let file: serde_json::Value =
        serde_json::from_str(include_str!("../../tests/data/lateral.json")).unwrap();
    let mut cases = Vec::new();
    for aircraft in file["aircraft"].as_array().unwrap() {
        for variant in aircraft["variants"].as_array().unwrap() {
            let what = |key: &serde_json::Value| key.as_str().unwrap().to_owned();
            let real = |key: &str| variant[key].as_f64().map(|rate| complex(rate, 0.0));
            let part = |index: usize| variant["dutch_roll"][index].as_f64().unwrap();
            cases.push(Case {
                name: format!("{}, {}", what(&aircraft["name"]), what(&variant["what"])),
                a: matrix(&variant["A"]),
                expected: [
                    (DutchRoll, Some(complex(part(0), part(1)))),
                    (RollSubsidence, real("roll")),
                    (Spiral, real("spiral")),
                ],
            });
        }
    }
    cases
}

/// Whether these are all the names that are given, each to this eigenvalue.
fn has_names(modes: &[NamedMode], expected: &[(ModeName, Option<Complex<f64>>)]) -> bool {
    let named = modes.iter().filter(|mode| !matches!(mode.name, Unnamed(_))).count();
    let wanted: Vec<(ModeName, Complex<f64>)> =
        expected.iter().filter_map(|&(name, z)| z.map(|z| (name, z))).collect();
    let is_there = |&(name, z): &(ModeName, Complex<f64>)| {
        modes.iter().any(|mode| mode.name == name && (mode.eigenvalue - z).norm() < 1e-7)
    };
    named == wanted.len() && wanted.iter().all(is_there)
}

#[derive(Clone, Copy, Debug)]
enum Bank {
    Measured,
    FromRollRate,
}

fn matrix(rows: &serde_json::Value) -> DMatrix<f64> {
    let rows: Vec<Vec<f64>> = serde_json::from_value(rows.clone()).unwrap();
    DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i][j])
}

/// Eigenvalues and the first four components of the eigenvectors, without what is rounding beside the fifth.
fn eigenpairs(a: &DMatrix<f64>, bank: Bank) -> Vec<Eigenpair> {
    let order = a.nrows();
    let empty = || DMatrix::zeros(order, 1);
    let system = StateSpace::<Continuous>::new(
        a.clone(),
        empty(),
        empty().transpose(),
        DMatrix::zeros(1, 1),
    );
    let shape = |v: &nalgebra::DVector<Complex<f64>>| {
        let rounding = 1e-12 * v.camax();
        let part = |i: usize| if v[i].norm() > rounding { v[i] } else { complex(0.0, 0.0) };
        match bank {
            Bank::Measured => ModeShape::from_state([0, 1, 2, 3].map(part)),
            Bank::FromRollRate => ModeShape::from_sensors(part(0), part(1), part(2)),
        }
    };
    system
        .unwrap()
        .modes()
        .unwrap()
        .iter()
        .map(|mode| Eigenpair {
            eigenvalue: mode.eigenvalue,
            shape: mode.eigenvector.as_ref().map(shape),
        })
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Each reading of each mode is wrong by up to a third, as those of an estimate are.
    #[test]
    fn names_hold_where_shapes_are_known_roughly(
        case in prop::sample::select(robust_cases()),
        errors in prop::collection::vec((0.75..1.333_f64, 0.75..1.333_f64, 0.75..1.333_f64), 5),
    ) {
        let mut pairs = eigenpairs(&case.a, Bank::FromRollRate);
        pairs.retain(|pair| pair.eigenvalue.im >= 0.0);
        for (pair, error) in pairs.iter_mut().zip(&errors) {
            if let Some(shape) = &mut pair.shape {
                shape.sideslip *= error.0;
                shape.roll_rate *= error.1;
                shape.yaw_rate *= error.2;
            }
        }
        let modes = name_modes(&pairs).unwrap();
        prop_assert!(has_names(&modes, &case.expected), "{} {modes:#?}", case.name);
    }
}

/// The airframes, with a yaw damper, and with the heading.
fn robust_cases() -> Vec<Case> {
    let kinds = ["airframe", "yaw damper", "yaw damper of 0.6 s", "heading"];
    let is_of_them =
        |case: &Case| kinds.iter().any(|kind| case.name.ends_with(&format!(", {kind}")));
    cases().into_iter().filter(is_of_them).collect()
}

/// A closed damper in both records, as a user had it: a Boeing 747 with 0.6 s from yaw rate to rudder.
#[test]
fn levels_of_a_damped_transport() {
    let cases = cases();
    let damped = cases.iter().find(|case| case.name == "747, yaw damper of 0.6 s").unwrap();
    let modes = name_modes(&eigenpairs(&damped.a, Bank::FromRollRate)).unwrap();
    let wanted = [
        (DutchRoll, complex(-0.1323, 0.9238), FlyingQualityLevel::Two),
        (RollSubsidence, complex(-0.5823, 0.0), FlyingQualityLevel::Two),
        (Spiral, complex(-0.0739, 0.0), FlyingQualityLevel::One),
    ];
    for (name, eigenvalue, expected) in wanted {
        let mode = find(&modes, name);
        assert!((mode.eigenvalue - eigenvalue).norm() < 1e-4, "{mode:?}");
        let found = level(&mode, AircraftClass::III, FlightPhaseCategory::B);
        assert_eq!(found, Some(expected), "{mode:?}");
    }
}
