//! Values on either side of each limit of MIL-F-8785C.

use num_complex::Complex;

use super::{AircraftClass, FlightPhaseCategory, FlyingQualityLevel, level};
use crate::{Evidence, ModeName, NamedMode, WhyUnnamed};

use AircraftClass::{I, IICarrier, III, IILand, IV};
use FlightPhaseCategory::{A, ACombat, B, C};
use FlyingQualityLevel::{One, Three, Two, Worse};

/// A relative step across a limit.
const STEP: f64 = 1e-9;

fn mode(name: ModeName, eigenvalue: Complex<f64>) -> NamedMode {
    NamedMode { name, eigenvalue, evidence: Evidence::EigenvaluePattern }
}

fn oscillation(name: ModeName, damping_ratio: f64, frequency_rad_s: f64) -> NamedMode {
    let re = -damping_ratio * frequency_rad_s;
    let im = (frequency_rad_s.powi(2) - re.powi(2)).max(0.0).sqrt();
    mode(name, Complex::new(re, im))
}

fn real(name: ModeName, rate: f64) -> NamedMode {
    mode(name, Complex::new(rate, 0.0))
}

/// Just above the limits a Dutch roll has the level, below any of the three it has not.
#[test]
fn dutch_roll_table_vi() {
    // Level, category, class, damping ratio, product, frequency: the rows as printed.
    let rows: [(_, _, _, f64, f64, f64); 17] = [
        (One, ACombat, IV, 0.4, 0.0, 1.0),
        (One, ACombat, I, 0.19, 0.35, 1.0),
        (One, A, I, 0.19, 0.35, 1.0),
        (One, A, IV, 0.19, 0.35, 1.0),
        (One, A, IILand, 0.19, 0.35, 0.4),
        (One, A, IICarrier, 0.19, 0.35, 0.4),
        (One, A, III, 0.19, 0.35, 0.4),
        (One, B, I, 0.08, 0.15, 0.4),
        (One, B, IV, 0.08, 0.15, 0.4),
        (One, C, I, 0.08, 0.15, 1.0),
        (One, C, IICarrier, 0.08, 0.15, 1.0),
        (One, C, IV, 0.08, 0.15, 1.0),
        (One, C, IILand, 0.08, 0.10, 0.4),
        (One, C, III, 0.08, 0.10, 0.4),
        (Two, A, IV, 0.02, 0.05, 0.4),
        (Two, B, IILand, 0.02, 0.05, 0.4),
        (Two, C, III, 0.02, 0.05, 0.4),
    ];
    for (wanted, category, class, zeta, product, frequency) in rows {
        let at = |zeta: f64, frequency: f64| {
            level(&oscillation(ModeName::DutchRoll, zeta, frequency), class, category)
        };
        let row = format!("{wanted:?} {category:?} {class:?}");
        // Fast enough that the damping ratio governs.
        let fast = 2.0 * (product / zeta).max(frequency);
        assert_eq!(at(zeta * (1.0 + STEP), fast), Some(wanted), "{row}: damping ratio");
        assert!(at(zeta * (1.0 - STEP), fast) > Some(wanted), "{row}: damping ratio");
        // Damped so well that the frequency governs; a better level may ask no more of it.
        let damped = 0.95;
        assert!(at(damped, frequency * (1.0 + STEP)) <= Some(wanted), "{row}: frequency");
        assert!(at(damped, frequency * (1.0 - STEP)) > Some(wanted), "{row}: frequency");
        // Slow enough that the product governs, with less damping than the most that is asked of Class III.
        let slow = (product / 0.6).max(frequency * 1.001);
        if product / slow > zeta {
            assert_eq!(at(product / slow * (1.0 + STEP), slow), Some(wanted), "{row}: product");
            assert!(at(product / slow * (1.0 - STEP), slow) > Some(wanted), "{row}: product");
        }
    }
}

/// Level 3 asks for any damping at all, and for 0.4 rad/s.
#[test]
fn dutch_roll_level_3() {
    let at = |zeta: f64, frequency: f64| {
        level(&oscillation(ModeName::DutchRoll, zeta, frequency), III, B)
    };
    assert_eq!(at(1e-6, 1.0), Some(Three));
    assert_eq!(at(-1e-6, 1.0), Some(Worse));
    assert_eq!(at(0.5, 0.4 * (1.0 - STEP)), Some(Worse));
}

/// At 3 rad/s with |phi/beta| = 4 the product has to exceed 0.15 + 0.014 (36 - 20) = 0.374 rad/s, a damping ratio of 0.12467.
#[test]
fn dutch_roll_that_rolls_needs_more_damping() {
    let with_ratio = |zeta: f64, frequency: f64, bank_to_sideslip: Option<f64>, class| {
        let evidence = Evidence::Shape {
            slip_fraction: 1.0,
            roll_fraction: 0.5,
            bank_to_sideslip,
            agreement: 1.0,
        };
        let named = NamedMode { evidence, ..oscillation(ModeName::DutchRoll, zeta, frequency) };
        level(&named, class, B)
    };
    let needed = 0.374 / 3.0;
    assert_eq!(with_ratio(needed * (1.0 + STEP), 3.0, Some(4.0), I), Some(One));
    assert_eq!(with_ratio(needed * (1.0 - STEP), 3.0, Some(4.0), I), Some(Two));
    assert_eq!(
        with_ratio(needed * (1.0 - STEP), 3.0, Some(2.0), I),
        Some(One),
        "w^2 |phi/beta| = 18"
    );
    assert_eq!(with_ratio(needed * (1.0 - STEP), 3.0, None, I), Some(One), "not known");
    // Levels 2 and 3: 0.05 + 0.009 x 16 = 0.194 and 0.005 x 16 = 0.08.
    assert_eq!(with_ratio(0.194 / 3.0 * (1.0 - STEP), 3.0, Some(4.0), I), Some(Three));
    assert_eq!(with_ratio(0.08 / 3.0 * (1.0 - STEP), 3.0, Some(4.0), I), Some(Worse));
    // 0.15 + 0.014 x 300 = 4.35 rad/s at 4 rad/s asks Level 1 for more than critical damping, of Class III for 0.7;
    // Level 2 asks for (0.05 + 0.009 x 300) / 4 = 0.6875.
    assert_eq!(with_ratio(0.71, 4.0, Some(20.0), III), Some(One));
    assert_eq!(with_ratio(0.71, 4.0, Some(20.0), IILand), Some(Two));
}

#[test]
fn roll_mode_table_vii() {
    let rows = [
        (ACombat, IV, [1.0, 1.4, 10.0]),
        (A, I, [1.0, 1.4, 10.0]),
        (A, IV, [1.0, 1.4, 10.0]),
        (A, IILand, [1.4, 3.0, 10.0]),
        (A, IICarrier, [1.4, 3.0, 10.0]),
        (A, III, [1.4, 3.0, 10.0]),
        (B, I, [1.4, 3.0, 10.0]),
        (B, IV, [1.4, 3.0, 10.0]),
        (C, I, [1.0, 1.4, 10.0]),
        (C, IICarrier, [1.0, 1.4, 10.0]),
        (C, IV, [1.0, 1.4, 10.0]),
        (C, IILand, [1.4, 3.0, 10.0]),
        (C, III, [1.4, 3.0, 10.0]),
    ];
    for (category, class, limits) in rows {
        let at =
            |time_s: f64| level(&real(ModeName::RollSubsidence, -1.0 / time_s), class, category);
        for (limit, [met, missed]) in
            limits.into_iter().zip([[One, Two], [Two, Three], [Three, Worse]])
        {
            assert_eq!(at(limit * (1.0 - STEP)), Some(met), "{category} {class} {limit} s");
            assert_eq!(at(limit * (1.0 + STEP)), Some(missed), "{category} {class} {limit} s");
        }
    }
    assert_eq!(level(&real(ModeName::RollSubsidence, -1.0), I, A), Some(One), "at most 1 s");
    for rate in [0.0, 0.1] {
        assert_eq!(level(&real(ModeName::RollSubsidence, rate), I, A), Some(Worse), "{rate}");
    }
}

#[test]
fn spiral_table_viii() {
    let rows = [
        (ACombat, [12.0, 8.0, 4.0]),
        (A, [12.0, 8.0, 4.0]),
        (B, [20.0, 8.0, 4.0]),
        (C, [12.0, 8.0, 4.0]),
    ];
    for (category, limits) in rows {
        for class in AircraftClass::ALL {
            let at = |time_s: f64| {
                level(&real(ModeName::Spiral, std::f64::consts::LN_2 / time_s), class, category)
            };
            for (limit, [met, missed]) in
                limits.into_iter().zip([[One, Two], [Two, Three], [Three, Worse]])
            {
                assert_eq!(at(limit * (1.0 + STEP)), Some(met), "{category} {class} {limit} s");
                assert_eq!(at(limit * (1.0 - STEP)), Some(missed), "{category} {class} {limit} s");
            }
            for rate in [0.0, -0.001, -3.0] {
                assert_eq!(level(&real(ModeName::Spiral, rate), class, category), Some(One));
            }
        }
    }
}

#[test]
fn coupled_roll_spiral_is_for_gentle_flight() {
    let at = |product: f64, category| {
        level(&oscillation(ModeName::CoupledRollSpiral, 0.6, product / 0.6), I, category)
    };
    for category in [B, C] {
        for (limit, [met, missed]) in
            [(0.5, [One, Two]), (0.3, [Two, Three]), (0.15, [Three, Worse])]
        {
            assert_eq!(at(limit * (1.0 + STEP), category), Some(met), "{category} {limit}");
            assert_eq!(at(limit * (1.0 - STEP), category), Some(missed), "{category} {limit}");
        }
    }
    assert_eq!(at(5.0, A), Some(Worse));
    assert_eq!(at(5.0, ACombat), Some(Worse));
}

#[test]
fn what_the_standard_does_not_speak_of_has_no_level() {
    let unnamed = ModeName::Unnamed(WhyUnnamed::BetterClaim);
    assert_eq!(level(&real(unnamed, -1.0), I, A), None);
    assert_eq!(level(&real(ModeName::DutchRollRealRoot, -1.0), I, A), None);
    assert_eq!(level(&real(ModeName::DutchRollRealRoot, 0.1), I, A), Some(Worse));
}

#[test]
fn words_are_read_as_they_are_shown() {
    for class in AircraftClass::ALL {
        assert_eq!(class.to_string().to_lowercase().parse(), Ok(class));
    }
    for category in FlightPhaseCategory::ALL {
        assert_eq!(category.to_string().parse(), Ok(category));
    }
    let error = "II".parse::<AircraftClass>().expect_err("Class II is two classes");
    assert_eq!(
        error.to_string(),
        "\"II\" is no class of aircraft; there are I, II-L, II-C, III and IV"
    );
    assert!("D".parse::<FlightPhaseCategory>().is_err());
}
