//! How sure are we? Covariances and intervals of the modes, tests of fit, and what the fitted system makes of each frequency.
//!
//! | file | what it does |
//! |---|---|
//! | `conclusion.rs`, `fit.rs` | from the best local optimum to the result |
//! | `doubt.rs` | reasons to doubt it |
//! | `uncertainty.rs` | covariances of parameters and modes |
//! | `derivatives.rs` | derivatives of the lateral equations with standard errors and correlations |
//! | `near_double.rs` | eigenvalues that are hardly told apart |
//! | `profile_likelihood.rs` | intervals of real modes from the likelihood itself |
//! | `offset_estimates.rs` | offsets that were left free |
//! | `goodness_of_fit.rs`, `offset_test.rs`, `model_error_test.rs`, `chi_squared.rs` | chi-squared, whiteness, offsets, residuals that follow the signal |
//! | `refit.rs` | the problem of a finished fit, for what is asked of it afterwards |
//! | `spectral_fit.rs`, `fitted_transmissibility.rs` | response, noise and residuals at each frequency; transmissibilities as fitted |

pub(crate) mod chi_squared;
pub(crate) mod conclusion;
pub(crate) mod derivatives;
pub(crate) mod doubt;
pub(crate) mod fit;
pub(crate) mod fitted_transmissibility;
pub(crate) mod goodness_of_fit;
pub(crate) mod model_error_test;
pub(crate) mod near_double;
pub(crate) mod offset_estimates;
pub(crate) mod offset_test;
pub(crate) mod profile_likelihood;
pub(crate) mod refit;
pub(crate) mod spectral_fit;
pub(crate) mod uncertainty;
