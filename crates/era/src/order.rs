//! How many states stand above rounding and noise, and why that many were kept.

use crate::EraError;

/// How the order of the realization is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum Order {
    /// This many states, fewer if the data hold fewer above the floor. This is how the paper sets `n_s` and `n_u`.
    Fixed(usize),
    /// As many states as there are singular values above this fraction of the largest one. Must lie in `[0, 1)`;
    /// zero keeps everything above the floor.
    Tolerance(f64),
    /// The order before the largest ratio of two neighbouring singular values. A singular value below the floor counts
    /// as the floor, and the last one has no neighbour, so that it is kept only if it is alone: give more parameters than
    /// twice the order. The default, since it needs no number.
    #[default]
    Gap,
}

/// Why the realization has the order that it has.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum OrderReason {
    /// The order asked for.
    Fixed,
    /// Fewer than asked for: the next singular value is not above the rounding floor.
    LimitedByRounding {
        /// The order asked for.
        requested: usize,
        /// The floor.
        floor: f64,
    },
    /// Fewer than asked for: the next singular value is not above the stated noise of the Markov parameters.
    LimitedByNoise {
        /// The order asked for.
        requested: usize,
        /// The floor.
        floor: f64,
    },
    /// Fewer than asked for: the Hankel matrix has no more singular values. A model of that order fits any data, so that a
    /// small residual says nothing.
    LimitedByData {
        /// The order asked for.
        requested: usize,
        /// Number of singular values.
        available: usize,
    },
    /// All singular values above the given fraction of the largest.
    Tolerance {
        /// The fraction.
        relative: f64,
    },
    /// The largest ratio of neighbouring singular values.
    Gap {
        /// That ratio, last kept to first left out; near 1 the order is arbitrary.
        ratio: f64,
    },
    /// No singular value stands above the floor: the model is its feedthrough.
    NothingAboveFloor {
        /// The floor.
        floor: f64,
    },
    /// There was nothing after the feedthrough to realize.
    NoParameters,
}

impl OrderReason {
    /// The same reason in another unit.
    pub(crate) fn map_floor(self, unit: impl Fn(f64) -> f64) -> Self {
        match self {
            Self::LimitedByRounding { requested, floor } => {
                Self::LimitedByRounding { requested, floor: unit(floor) }
            }
            Self::LimitedByNoise { requested, floor } => {
                Self::LimitedByNoise { requested, floor: unit(floor) }
            }
            Self::NothingAboveFloor { floor } => Self::NothingAboveFloor { floor: unit(floor) },
            other => other,
        }
    }
}

/// Where the floor of the singular values comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum FloorOrigin {
    /// Rounding of double-precision numbers.
    Rounding,
    /// The stated uncertainty of the Markov parameters.
    Noise,
}

/// The level that a singular value must exceed to be realized.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Floor {
    /// The level, in units of the Markov parameters.
    pub value: f64,
    /// What sets it.
    pub origin: FloorOrigin,
}

impl Floor {
    /// The floor of an `rows` by `columns` Hankel matrix.
    ///
    /// Rounding: an error of `eps` relative to `sigma_1` in each of `max(rows, columns)` sums. The entries themselves are
    /// rounded too, to `eps * magnitude`, where `magnitude` is the largest number they were found together with; a matrix
    /// of errors of size `e` has a norm of at most `e sqrt(rows columns)`. The same bound turns the noise of one
    /// parameter into that of a singular value.
    pub(crate) fn new(
        rows: usize,
        columns: usize,
        largest_singular_value: f64,
        magnitude: f64,
        noise: Option<f64>,
    ) -> Self {
        let spread = (rows as f64).sqrt() * (columns as f64).sqrt();
        let sums = rows.max(columns) as f64 * f64::EPSILON * largest_singular_value;
        let rounding = sums.max(spread * f64::EPSILON * magnitude);
        let noise = noise.map_or(0.0, |level| spread * level);
        if noise > rounding {
            Self { value: noise, origin: FloorOrigin::Noise }
        } else {
            Self { value: rounding, origin: FloorOrigin::Rounding }
        }
    }

    /// The uncertainty of one entry that makes this floor.
    pub(crate) fn of_one_entry(self, rows: usize, columns: usize) -> f64 {
        self.value / ((rows as f64).sqrt() * (columns as f64).sqrt())
    }

    fn limited(self, requested: usize) -> OrderReason {
        match self.origin {
            FloorOrigin::Rounding => {
                OrderReason::LimitedByRounding { requested, floor: self.value }
            }
            FloorOrigin::Noise => OrderReason::LimitedByNoise { requested, floor: self.value },
        }
    }
}

impl Order {
    pub(crate) fn check(self) -> Result<(), EraError> {
        match self {
            Self::Tolerance(value) if !(0.0..1.0).contains(&value) => {
                Err(EraError::InvalidTolerance { value })
            }
            _ => Ok(()),
        }
    }

    /// The order and its reason, from singular values in descending order.
    pub(crate) fn select(self, singular_values: &[f64], floor: Floor) -> (usize, OrderReason) {
        let significant = singular_values.iter().take_while(|&&value| value > floor.value).count();
        if let Self::Fixed(requested) = self {
            return if requested <= significant {
                (requested, OrderReason::Fixed)
            } else if significant == singular_values.len() {
                (significant, OrderReason::LimitedByData { requested, available: significant })
            } else {
                (significant, floor.limited(requested))
            };
        }
        if significant == 0 {
            return (0, OrderReason::NothingAboveFloor { floor: floor.value });
        }
        if let Self::Tolerance(relative) = self {
            let level = relative * singular_values[0];
            let requested = singular_values.iter().take_while(|&&value| value > level).count();
            let reason = if requested > significant && relative > 0.0 {
                floor.limited(requested)
            } else {
                OrderReason::Tolerance { relative }
            };
            return (requested.min(significant), reason);
        }
        // A gap needs a neighbour: the last singular value can only be chosen when it is the only one.
        let last = significant.min(singular_values.len().saturating_sub(1)).max(1);
        let ratio = |order: usize| {
            let next = singular_values.get(order).copied().unwrap_or(0.0).max(floor.value);
            singular_values[order - 1] / next
        };
        let mut best = 1;
        for order in 2..=last {
            if ratio(order) > ratio(best) {
                best = order;
            }
        }
        (best, OrderReason::Gap { ratio: ratio(best) })
    }
}

#[cfg(test)]
mod tests;
