//! The numbers of MIL-F-8785C for the lateral modes: Tables VI, VII, VIII and paragraph 3.3.1.4 (pages 22 and 23).

use super::classification::{AircraftClass, FlightPhaseCategory, FlyingQualityLevel};

use AircraftClass::{I, IICarrier, III, IILand, IV};
use FlightPhaseCategory::{A, ACombat, B, C};
use FlyingQualityLevel::{One, Three, Two, Worse};

/// A row of Table VI: what a Dutch roll has to exceed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DutchRollLimit {
    /// Damping ratio.
    pub(super) damping_ratio: f64,
    /// Damping ratio times natural frequency, rad/s; zero where the table has a dash.
    pub(super) product_rad_s: f64,
    /// Natural frequency, rad/s.
    pub(super) frequency_rad_s: f64,
}

/// Table VI, minimum Dutch-roll frequency and damping.
pub(super) fn dutch_roll(
    level: FlyingQualityLevel,
    class: AircraftClass,
    category: FlightPhaseCategory,
) -> DutchRollLimit {
    let (damping_ratio, product_rad_s, frequency_rad_s) = match (level, category, class) {
        (One, ACombat, IV) => (0.4, 0.0, 1.0),
        (One, ACombat | A, I | IV) => (0.19, 0.35, 1.0),
        (One, ACombat | A, IILand | IICarrier | III) => (0.19, 0.35, 0.4),
        (One, B, _) => (0.08, 0.15, 0.4),
        (One, C, I | IICarrier | IV) => (0.08, 0.15, 1.0),
        (One, C, IILand | III) => (0.08, 0.10, 0.4),
        (Two, ..) => (0.02, 0.05, 0.4),
        (Three | Worse, ..) => (0.0, 0.0, 0.4),
    };
    DutchRollLimit { damping_ratio, product_rad_s, frequency_rad_s }
}

impl DutchRollLimit {
    /// The damping ratio that governs: "that yielding the larger value", with the note of Table VI for strong rolling.
    ///
    /// The product grows by 0.014, 0.009 or 0.005 times `w^2 |phi/beta| - 20` where that is positive.
    pub(super) fn damping_ratio(
        self,
        level: FlyingQualityLevel,
        class: AircraftClass,
        frequency_rad_s: f64,
        bank_to_sideslip: Option<f64>,
    ) -> f64 {
        const ROLLING: f64 = 20.0;
        const LARGEST_FOR_CLASS_III: f64 = 0.7;
        let factor = match level {
            One => 0.014,
            Two => 0.009,
            Three | Worse => 0.005,
        };
        let rolling = frequency_rad_s.powi(2) * bank_to_sideslip.unwrap_or(0.0);
        let product_rad_s = self.product_rad_s + factor * (rolling - ROLLING).max(0.0);
        let governing = self.damping_ratio.max(product_rad_s / frequency_rad_s);
        if class == III { governing.min(LARGEST_FOR_CLASS_III) } else { governing }
    }
}

/// Table VII, maximum roll-mode time constant in seconds.
pub(super) fn roll_time_constant_s(
    level: FlyingQualityLevel,
    class: AircraftClass,
    category: FlightPhaseCategory,
) -> f64 {
    let quick = match category {
        ACombat | A => matches!(class, I | IV),
        B => false,
        C => matches!(class, I | IICarrier | IV),
    };
    match (level, quick) {
        (One, true) => 1.0,
        (One, false) | (Two, true) => 1.4,
        (Two, false) => 3.0,
        // One number for the whole column.
        (Three | Worse, _) => 10.0,
    }
}

/// Table VIII, minimum time to double amplitude of the spiral in seconds.
pub(super) fn spiral_time_to_double_s(
    level: FlyingQualityLevel,
    category: FlightPhaseCategory,
) -> f64 {
    match (level, category) {
        (One, ACombat | A | C) => 12.0,
        (One, B) => 20.0,
        (Two, _) => 8.0,
        (Three | Worse, _) => 4.0,
    }
}

/// Paragraph 3.3.1.4, minimum of damping ratio times frequency of the coupled roll-spiral, rad/s; `None` where it is not permitted.
pub(super) fn coupled_rad_s(
    level: FlyingQualityLevel,
    category: FlightPhaseCategory,
) -> Option<f64> {
    match (category, level) {
        (ACombat | A, _) => None,
        (B | C, One) => Some(0.5),
        (B | C, Two) => Some(0.3),
        (B | C, Three | Worse) => Some(0.15),
    }
}
