//! What can be chosen about the intersection of signal subspaces.

use crate::{Measurement, NoiseModel, Offsets};

/// How the number of states is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum OrderChoice {
    /// This many states.
    Fixed(usize),
    /// From the gaps in the eigenvalues, among orders from 1 to `largest`.
    Gap {
        /// The largest order looked at; fewer if the records cannot tell so many.
        largest: usize,
    },
}

/// What [`identify`](super::identify) may be told.
///
/// # Example
///
/// ```
/// use reconstruct::Offsets;
/// use reconstruct::subspace::{Options, OrderChoice};
///
/// let mut options = Options::default();
/// options.order = OrderChoice::Fixed(4);
/// options.measurement.offsets = Offsets::Zero;
/// assert_eq!(options.block_rows, None);
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// The number of states. By default found from the gap among orders up to 10: the aircraft of the paper has 4, and with three sensors
    /// of two records each further order wants another block row.
    pub order: OrderChoice,
    /// The number of block rows L. `None`: about 96 rows in all, which is where more rows no longer bring
    /// accuracy at 2000 samples; at most a third of the columns, since fewer columns cannot tell noise from signal; and not fewer than
    /// the order needs.
    pub block_rows: Option<usize>,
    /// The noise of the sensors. By default estimated.
    pub noise: NoiseModel,
    /// Offsets, drift and feedthrough of the sensors, recorded inputs.
    ///
    /// By default sensors may be offset by a constant that differs from record to record, since an offset that is not removed counts as a state:
    /// rows of the block-Hankel matrices are centred, which removes it exactly. Slow modes of short records suffer. Rows are not centred where
    /// offsets are zero and drift is absent; of a drift nothing more is known here. Sensors with feedthrough cost one noise direction for each
    /// record. What L samples of recorded inputs explain is taken out of the block-Hankel matrices, so that they are no further excitations;
    /// eigenvalues of records without noise then come out to about 1e-8 only.
    pub measurement: Measurement,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            order: OrderChoice::Gap { largest: 10 },
            block_rows: None,
            noise: NoiseModel::default(),
            measurement: Measurement { offsets: Offsets::Free, ..Measurement::default() },
        }
    }
}
