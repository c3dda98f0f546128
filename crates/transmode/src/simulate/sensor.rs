//! The sensors that a simulated aircraft has.

use aircraft::LateralState;

/// A sensor that reads one state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Sensor(LateralState);

impl Sensor {
    /// Reads the name of a column.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        let all = LateralState::ALL.map(Self);
        all.into_iter()
            .find(|sensor| sensor.name() == text.trim())
            .ok_or_else(|| "the sensors are beta, p, r and phi".to_owned())
    }

    pub(super) fn state(self) -> LateralState {
        self.0
    }

    /// The name of its column.
    pub(super) fn name(self) -> &'static str {
        match self.0 {
            LateralState::Sideslip => "beta",
            LateralState::RollRate => "p",
            LateralState::YawRate => "r",
            LateralState::BankAngle => "phi",
        }
    }
}
