//! What the crate promises, against sums in exact arithmetic.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail by panicking")]
#![expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")]

mod exact;
mod gram;
mod least_squares;
mod limits;
mod pieces;
