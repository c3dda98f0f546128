//! Least squares with a penalty on the Markov parameters.
//!
//! ```text
//! minimise over theta    1/(2 n s_o^2) || Psi - theta Phi ||^2  +  lambda P(g),      g_i = h_i s_i / s_o
//! ```
//!
//! n is the number of equations, s_i and s_o the root mean squares of the pseudo input (over the middle column, y_i(k)) and of the
//! pseudo output (the right-hand side). So the first term is half the squared relative residual, `lambda` has no unit, and one value means
//! the same for short and long records in any units. Only the Markov parameters are penalised: the coefficients of D(q), whose
//! roots should lie near the unit circle, are left free.
//!
//! | penalty | P(g) |
//! |---|---|
//! | [`Regularization::Ridge`] | 1/2 sum g_i^2 |
//! | [`Regularization::Lasso`] | sum abs(g_i) |
//! | [`Regularization::ExponentiallyWeighted`] | 1/2 sum rho^(-abs(i)) g_i^2 |
//! | [`Regularization::NuclearNorm`] | sum of the singular values of the Hankel matrices of g_1 .. g_r and of g_-1 .. g_-d |
//!
//! Squares are a least-squares problem of their own and are solved directly, and so is any penalty with `lambda` = 0. The lasso and the nuclear
//! norm are conic programs, solved by an interior-point method. Only the folded triangle of the equations enters, so the size of the problem does
//! not depend on the number of samples.
//!
//! The solution is not refined in doubled precision as that of the plain fit is: a penalty moves it by far more.
//! This module needs the feature `regularized` and a system OpenBLAS.

mod fit;
mod hold_out;
mod lambda;
mod penalised;
mod penalty;
mod program;
mod settings;
mod solver;

pub use fit::fit;
pub use lambda::{HoldOutScore, Lambda};
pub use penalised::RegularizedFit;
pub use penalty::Regularization;
pub use settings::Settings;
pub use solver::Status;

#[cfg(test)]
mod tests;
