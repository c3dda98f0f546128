//! Flying-quality levels of the lateral modes after MIL-F-8785C.

mod classification;
mod limits;

use crate::{Evidence, ModeName, NamedMode};

pub use classification::{AircraftClass, FlightPhaseCategory, FlyingQualityLevel, UnknownWord};

/// The levels with limits, the best first.
const LEVELS: [FlyingQualityLevel; 3] =
    [FlyingQualityLevel::One, FlyingQualityLevel::Two, FlyingQualityLevel::Three];

/// The best level whose limits a lateral mode meets, after MIL-F-8785C (5 November 1980).
///
/// | mode | what counts | paragraph, table |
/// |---|---|---|
/// | Dutch roll | damping ratio, damping ratio times natural frequency, natural frequency, each above a minimum | 3.3.1.1, Table VI |
/// | roll subsidence | time constant, at most | 3.3.1.2, Table VII |
/// | spiral | time to double amplitude, above a minimum; Level 1 where it is stable | 3.3.1.3, Table VIII |
/// | coupled roll-spiral | damping ratio times natural frequency, above 0.5, 0.3 and 0.15 rad/s; not permitted in Category A | 3.3.1.4 |
///
/// Where `w^2 |phi/beta|` of the Dutch roll exceeds 20 (rad/s)^2, the minimum of damping ratio times frequency grows, as the notes of Table VI
/// say; that needs the mode's shape, and is left out where the name rests on the eigenvalues alone. No more than a damping ratio of 0.7 is asked
/// of Class III. Its exemption from the minimum frequency, which an authority may grant, is not applied. The standard permits the coupled mode
/// in Categories B and C only, so in all of Category A it is [`FlyingQualityLevel::Worse`].
///
/// `None` for a mode without a name or with a neutral one, and for a stable real root of the Dutch roll, of which the standard says nothing. A divergent one is
/// [`FlyingQualityLevel::Worse`]. The standard is for piloted aircraft of full size.
///
/// # Example
///
/// A Dutch roll at 1.7 rad/s with a damping ratio of 0.04 misses the 0.08 of Level 1 and keeps the 0.02 of Level 2.
///
/// ```
/// use aircraft::{AircraftClass, FlightPhaseCategory, FlyingQualityLevel, level, name_eigenvalues};
/// use num_complex::Complex;
///
/// let found = [Complex::new(-0.068, 1.7), Complex::new(-0.0016, 0.0), Complex::new(-0.546, 0.0)];
/// let levels: Vec<_> = name_eigenvalues(&found)?
///     .iter()
///     .map(|mode| level(mode, AircraftClass::III, FlightPhaseCategory::B))
///     .collect();
/// // A stable spiral is always of Level 1; a roll mode of 1.8 s is slower than the 1.4 s of Level 1.
/// assert_eq!(levels, [Some(FlyingQualityLevel::Two), Some(FlyingQualityLevel::One), Some(FlyingQualityLevel::Two)]);
/// # Ok::<(), aircraft::AircraftError>(())
/// ```
#[doc(alias("handling qualities", "MIL-F-8785C"))]
#[must_use]
pub fn level(
    mode: &NamedMode,
    class: AircraftClass,
    category: FlightPhaseCategory,
) -> Option<FlyingQualityLevel> {
    let (rate, frequency_rad_s) = (mode.eigenvalue.re, mode.eigenvalue.norm());
    let best = |meets: &dyn Fn(FlyingQualityLevel) -> bool| {
        LEVELS.into_iter().find(|&level| meets(level)).or(Some(FlyingQualityLevel::Worse))
    };
    match mode.name {
        ModeName::DutchRoll => {
            let bank_to_sideslip = match mode.evidence {
                Evidence::Shape { bank_to_sideslip, .. } => bank_to_sideslip,
                _ => None,
            };
            best(&|level| {
                let limit = limits::dutch_roll(level, class, category);
                -rate / frequency_rad_s
                    > limit.damping_ratio(level, class, frequency_rad_s, bank_to_sideslip)
                    && frequency_rad_s > limit.frequency_rad_s
            })
        }
        ModeName::RollSubsidence => {
            // Written without a division, so that a neutral or divergent mode meets no limit.
            best(&|level| -rate * limits::roll_time_constant_s(level, class, category) >= 1.0)
        }
        ModeName::Spiral => {
            let ln_2 = std::f64::consts::LN_2;
            best(&|level| rate * limits::spiral_time_to_double_s(level, category) < ln_2)
        }
        ModeName::CoupledRollSpiral => {
            best(&|level| limits::coupled_rad_s(level, category).is_some_and(|least| -rate > least))
        }
        ModeName::DutchRollRealRoot => (rate > 0.0).then_some(FlyingQualityLevel::Worse),
        ModeName::Oscillatory | ModeName::Real | ModeName::Integrator | ModeName::Unnamed(_) => {
            None
        }
    }
}

#[cfg(test)]
mod tests;
