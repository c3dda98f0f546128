//! Sensor faults: from the residuals of transmissibilities to alarms with a stated false-alarm rate.
//!
//! A transmissibility that was identified with healthy sensors says how they go together, whatever drives the system through that input. Where new data do not
//! follow it, one of the sensors is faulty, or something else drives the system.
//!
//! # The statistics
//!
//! The residual of a transmissibility is coloured: it is sensor noise, filtered by the model. So
//!
//! 1. an autoregression of the residuals in the *training* record makes them nearly white ([`Whitening`]);
//! 2. the whitened residuals are cut into windows, and each gives two numbers for each transmissibility: the mean, and the cube root of the variance about it, which is
//!    nearly Gaussian too (Wilson and Hilferty);
//! 3. the windows of a *healthy* record, which took no part in the fit, say what mean and covariance these numbers have, between the transmissibilities as well: what
//!    whitening has left of the correlation is in them;
//! 4. a new window is compared with them by Hotelling's T^2, whose limits by the F distribution allow for the finite number of healthy windows:
//!
//! ```text
//! T^2 = n/(n + 1) (x - mean)' S^-1 (x - mean)  >  p (n - 1)/(n - p) F(p, n - p)
//! ```
//!
//! for n healthy windows and p transmissibilities. Two tests share the false-alarm rate of a window: [`TestKind::Level`] compares the means with those of the windows
//! before, so that what is slow in healthy residuals (a slow mode that the model does not quite explain) is followed rather than taken for a fault; it sees jumps, and drifts that are
//! faster than that. [`TestKind::Spread`] is on the variances.
//!
//! Samples may be missing: they are NaN in a [`Stretch`]. Each is one more unknown of the windows that it reaches, costs them one degree of freedom, and leaves the rate of
//! false alarms as it is; a window of which less than half is left is not judged. What was learnt of the windows before stays.
//!
//! The rate is that of one window of a healthy record that is excited as the reference was.
//!
//! | item | what it does |
//! |---|---|
//! | [`Stretch`], [`complete`] | channels, and the parts of them without missing samples |
//! | [`Link`] | a transmissibility between two channels |
//! | [`Detector::calibrate`] | limits from healthy records |
//! | [`Detector::watch`] | the tests of each window of new data |
//! | [`Detector::diagnose`] | which sensor, and what kind of change |

mod attribution;
mod detector;
mod diagnosis;
mod error;
mod features;
mod link;
mod missing;
mod statistics;
mod stretch;
mod whitening;
mod window;

pub use detector::{Detector, Options};
pub use diagnosis::{Change, Diagnosis};
pub use error::MonitorError;
pub use link::Link;
pub use stretch::{Stretch, complete};
pub use whitening::Whitening;
pub use window::{Test, TestKind, Window};
