//! The derivatives of the lateral equations with their standard errors and correlations.

use nalgebra::{DMatrix, DVector};

use super::uncertainty::Estimate;

/// A derivative of the lateral equations.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Derivative {
    /// Its name: L_beta, or L_aileron for a control.
    pub name: String,
    /// L and N: 1/s^2 by an angle, 1/s by a rate. Y and g/U: 1/s by an angle, 1 by a rate. tan(theta): 1.
    pub estimate: Estimate,
}

/// The named parameters, and the correlations of their estimates. The standard errors hold scatter, and what a relative model error adds.
pub(crate) fn derivatives(
    names: Vec<String>,
    parameters: &DVector<f64>,
    covariance: &DMatrix<f64>,
    model_error: f64,
) -> (Vec<Derivative>, DMatrix<f64>) {
    /// A model that is wrong by eps has derivatives that are wrong by a few eps of their size.
    const TIMES: f64 = 2.0;
    let scatter = |k: usize| covariance[(k, k)].max(0.0).sqrt();
    let count = names.len();
    let estimate = |(k, name): (usize, String)| {
        let value = parameters[k];
        let standard_error = scatter(k).hypot(TIMES * model_error * value.abs());
        Derivative { name, estimate: Estimate { value, standard_error } }
    };
    let all = names.into_iter().enumerate().map(estimate).collect();
    let correlation = |i: usize, k: usize| {
        let product = scatter(i) * scatter(k);
        if product > 0.0 { covariance[(i, k)] / product } else { 0.0 }
    };
    (all, DMatrix::from_fn(count, count, correlation))
}
