//! Which system do noisy records make most likely, and how certain is it? Maximum likelihood for several records of one system, each
//! under one unknown excitation.
//!
//! # The problem
//!
//! Record j = 1..J has m sensors. At each frequency of its discrete Fourier transform, z = exp(2 pi j k / N),
//!
//! Y_j = G_j U_j + z C (zI - A)^-1 t_j + V_j, G_j = C (zI - A)^-1 b_j + d_j,
//!
//! exactly: U_j is the transform of the excitation, free at every frequency; t_j holds the initial and the final state, x(0) - x(N); V_j is noise with
//! covariance S. With U_j at its best, what is left is the part of Y_j - z C (zI - A)^-1 t_j that no excitation explains, and the fit minimises
//!
//! sum over j and k of w e^H (S^-1 - S^-1 g g^H S^-1 / (g^H S^-1 g)) e, e = Y_j - z C (zI - A)^-1 t_j, g = G_j,
//!
//! with w = 2 inside and 1 at frequency zero and half the sampling frequency. Of the n^2 + m n + J n parameters in (A, C, b_j), n J + m n - J can be
//! identified: a change of basis and the scale of each b_j change nothing. d_j is free for sensors with feedthrough; where the excitation moves on
//! straight between samples, the entries of d_j of the other sensors follow from A, C and b_j.
//!
//! | room | the question it answers |
//! |---|---|
//! | `cost` | what is minimised: records in the frequency domain, cost, gradient and Gram matrix |
//! | `search` | how it is searched: from starts to the best of the local optima |
//! | `inference` | how sure we are: covariances, intervals, tests of fit |
//! | `lateral` | the same with the derivatives of an aircraft's lateral equations as parameters |
//! | `identify.rs`, `bootstrap.rs` | from records and starts to the result; the same with the noise drawn anew |

mod bootstrap;
pub(crate) mod cost;
#[cfg(test)]
pub(crate) mod fixtures;
mod identify;
pub(crate) mod inference;
mod lateral;
mod options;
mod search;
mod validation;

pub use crate::model::{
    AutoregressionOrder, FrequencyBand, Hold, NoiseSpectrum, VectorAutoregression,
};
pub use bootstrap::{Bootstrap, BootstrapMode, bootstrap};
pub use identify::identify;
pub use inference::derivatives::Derivative;
pub use inference::doubt::Doubt;
pub use inference::fit::{Contrast, Fit, Rival};
pub use inference::fitted_transmissibility::{FittedTransmissibility, fitted_transmissibilities};
pub use inference::goodness_of_fit::{ChiSquared, Whiteness};
pub use inference::model_error_test::{ModelErrorTest, model_error_test};
pub use inference::near_double::NearDouble;
pub use inference::offset_estimates::offset_estimates;
pub use inference::offset_test::OffsetTest;
pub use inference::profile_likelihood::profile_intervals;
pub(crate) use inference::spectral_fit::spectral_fit;
pub use inference::spectral_fit::{SensorSpectrum, SpectralFit};
pub use inference::uncertainty::{ComplexEstimate, Ellipse, Estimate, Mode};
pub(crate) use lateral::identify_lateral_unless_rejected;
pub use lateral::{Condition, ConditionTest, condition_test, identify_lateral, lateral_test};
pub use options::{InputDirections, Noise, Options, SearchOptions};
pub use search::levenberg_marquardt::SearchStatus;
pub use search::report::{SearchReport, StartReport};

#[cfg(test)]
mod tests;
