//! What is varied.

use serde::{Deserialize, Serialize};

use crate::shared::noisy_flights::Excitation;

/// A kind of record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Kind {
    pub(crate) excitation: Excitation,
    /// Root mean square of each sensor's signal over that of its noise, see
    /// [`Pair`](crate::shared::noisy_flights::Pair).
    pub(crate) signal_to_noise: u32,
}
