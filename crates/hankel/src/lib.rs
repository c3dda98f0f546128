//! Gram matrices of shifted copies of signals, in one pass and in doubled precision: structured least squares at any length.
//!
//! The regressors of time-series models are shifted copies of a few channels, so that their Gram matrix holds only lag products, and
//! entries of one lag differ only at the ends of their windows. With N samples, p columns and c channels that is O(N p c) operations instead
//! of O(N p^2), one pass, and memory that does not depend on N. What a Gram matrix costs, the square of the condition number, is
//! paid for with sums in twice the working precision: the answer is as accurate as that of a QR factorisation, and with one more pass over the
//! data it is exact to the last bits.
//!
//! | to | use |
//! |---|---|
//! | say which columns the regressors have | [`Column`], [`Layout`] |
//! | sum a record in memory | [`gram`] |
//! | sum pieces as they come, with gaps; join files | [`Accumulator`], [`Missing`], [`Seam`] |
//! | remove offsets | [`Gram::centred`] |
//! | factorise; rank, condition, covariance | [`Gram::cholesky`], [`Cholesky`] |
//! | explain one column by the others | [`Gram::least_squares`], [`LeastSquares`] |
//! | remove what the Gram matrix cannot see | [`LeastSquares::refined`] |
//! | share other sums between threads, with the same bits for any number of them | [`in_order()`], [`Sharing`] |
//!
//! # Numerics
//!
//! Tiles of about 2000 samples are scaled by powers of two and summed by a vector kernel, whose width is chosen at run time; one lane
//! holds one lag, so that the result is the same to the last bit whatever the machine, the number of threads and the pieces in which the samples came. Entries
//! are about 1e-30 of the norms of their columns off ([`Gram::rounding`]); condition numbers up to about 1e14 can be told from rank deficiency.
//! Channels may be of any size, 1e-300 to 1e300.
//!
//! # Example
//!
//! A resonance found from its own free motion, x(k+2) = a x(k+1) + b x(k):
//!
//! ```
//! use hankel::{Layout, Options, gram};
//!
//! let record: Vec<f64> = (0..5000).map(|k| (-0.001 * f64::from(k)).exp() * (0.2 * f64::from(k)).cos()).collect();
//! let layout = Layout::block_hankel(1, 3)?;
//! let found = gram(&layout, &[&record], &Options::default())?.least_squares(2, None)?;
//!
//! let [b, a] = found.coefficients[..] else { unreachable!() };
//! assert!((a - 2.0 * (-0.001_f64).exp() * 0.2_f64.cos()).abs() < 1e-12);
//! assert!((b + (-0.002_f64).exp()).abs() < 1e-12);
//! # Ok::<(), hankel::HankelError>(())
//! ```
#![cfg_attr(
    test,
    expect(clippy::float_cmp, reason = "exact comparisons are with values that have to be exact")
)]

mod accumulator;
mod cholesky;
mod column;
mod combination;
mod error;
mod gaps;
mod gram;
mod in_order;
mod kernel;
mod layout;
mod least_squares;
mod plan;
mod residual;
mod scan;
mod segment;
mod sums;
mod tile;

pub use accumulator::{Accumulator, Options, Seam, gram};
pub use cholesky::Cholesky;
pub use column::Column;
pub use error::HankelError;
pub use gaps::Missing;
pub use gram::Gram;
pub use in_order::{Sharing, in_order};
pub use layout::Layout;
pub use least_squares::{LeastSquares, Refinement};
