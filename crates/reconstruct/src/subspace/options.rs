//! What can be chosen about the intersection of signal subspaces.

use crate::NoiseModel;

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

/// Whether sensors are taken to read zero in equilibrium.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Centring {
    /// Sensors may be offset by a constant that differs from record to record: rows of the block-Hankel matrices are centred, which removes
    /// it exactly. Slow modes of short records suffer. The default, since an offset that is not removed counts as a state.
    #[default]
    Rows,
    /// Sensors read zero in equilibrium.
    None,
}

/// Whether sensors read the excitation directly.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum DirectPath {
    /// No sensor does, as of positions, angles and rates. The default.
    #[default]
    Absent,
    /// Some do, as accelerometers: `d_j` is estimated. It costs one noise direction for each record.
    Present,
}

/// What [`identify`](super::identify) may be told.
///
/// # Example
///
/// ```
/// use reconstruct::subspace::{Centring, Options, OrderChoice};
///
/// let mut options = Options::default();
/// options.order = OrderChoice::Fixed(4);
/// options.centring = Centring::None;
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
    /// Whether sensors may be offset. By default they may.
    pub centring: Centring,
    /// Whether sensors read the excitation directly. By default they don't.
    pub direct_path: DirectPath,
    /// Inputs that were recorded: for each record a list of signals as long as the record; empty where nothing was recorded. What L samples of
    /// them explain is taken out of the block-Hankel matrices, so that they are no further excitations. Eigenvalues of records without noise then
    /// come out to about 1e-8 only.
    pub known_inputs: Vec<Vec<Vec<f64>>>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            order: OrderChoice::Gap { largest: 10 },
            block_rows: None,
            noise: NoiseModel::default(),
            centring: Centring::default(),
            direct_path: DirectPath::default(),
            known_inputs: Vec::new(),
        }
    }
}
