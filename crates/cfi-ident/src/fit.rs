//! The least-squares fit, and what is known about its answer.

use nalgebra::DMatrix;

use crate::{
    CfiModel, Engine, FitError, FitOptions, Parameter, Refinement, Segment, Structure, gram,
    householder,
    regressors::{Counts, check, scale},
    solution::Solution,
};

/// An identified model, and how far to trust it.
///
/// The covariance is that of linear regression with independent equation errors of equal variance. Sensor noise enters the regressors
/// themselves: then the parameters are biased as well, and the covariance says nothing about the bias.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Fit {
    /// The model.
    pub model: CfiModel,
    /// 2-norm of the residual Psi - theta Phi, in the unit of the pseudo output.
    pub residual_norm: f64,
    /// Root of the mean square of the residual.
    pub residual_rms: f64,
    /// Residual norm over the norm of Psi; 0 if Psi is zero.
    pub relative_residual: f64,
    /// Numerical rank of the regressors.
    pub rank: usize,
    /// Ratio of the largest to the smallest singular value kept, of the regressors scaled to norm one.
    pub condition: f64,
    /// All singular values of the regressors scaled to norm one, descending.
    pub singular_values: Vec<f64>,
    /// Covariance of the parameters, in the order of [`Structure::parameters`]: p x p.
    ///
    /// It is the noise variance times (Phi Phi')^-1. In a rank-deficient fit it covers the identifiable directions only, and
    /// [`Fit::unidentifiable`] lists the parameters for which it means nothing. It is zero without degrees of freedom.
    pub parameter_covariance: DMatrix<f64>,
    /// Equations minus rank.
    pub degrees_of_freedom: usize,
    /// Sum of the squared residuals over the degrees of freedom; `None` without degrees of freedom.
    pub noise_variance: Option<f64>,
    /// What the data do not determine; `None` if the rank is full.
    pub unidentifiable: Option<Unidentifiable>,
    /// Equations, that is columns of Phi.
    pub equations: usize,
    /// Samples of the segments that gave equations.
    pub samples_used: usize,
    /// Segments too short to give a single equation; they were left out.
    pub segments_without_equation: usize,
    /// How far the parameters may be off the exact least-squares solution by rounding, relative to their norm in units in which each regressor has norm one.
    ///
    /// The rounding unit after a refinement that converged; otherwise what the sums' rounding and the condition number squared allow (for reflections, the
    /// rounding unit times the condition number).
    pub expected_error: f64,
    /// How the refinement went.
    pub refinement: Refinement,
}

/// Directions in the space of parameters along which the prediction does not change.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Unidentifiable {
    /// One direction a column, p x (p - rank), each of norm one in the given units.
    pub directions: DMatrix<f64>,
    /// The parameters that take part in any of them. The others are determined in spite of the deficiency.
    pub parameters: Vec<Parameter>,
}

/// A parameter takes part in an unidentifiable direction if its share of the scaled direction exceeds this: half the digits of a
/// double, well above the rounding in the null space of a well separated singular value.
const PARTICIPATION: f64 = 1.5e-8;

/// Fits a model to one or more segments by linear least squares.
///
/// ```text
/// theta = arg min over theta of || Psi - theta Phi ||_F
///
/// y_o(k + l) = - sum over i of c_i y_o(k + i) + sum over i = -d .. r of h_i y_i(k - i),     k = r .. N - 1 - max(l, d)
/// ```
///
/// Samples count from 0 to N - 1 in each segment, and every equation that lies inside it is used. Written literally, the
/// paper's windows end at y_i(N) and y_o(N - d + l); read with samples 0 .. N - 1 the last equation is one step earlier, and earlier still
/// where l > d.
///
/// The products of the equations are summed in doubled precision, factorised, the columns scaled to norm one and the rank taken from the singular
/// values; where it matters the solution is then corrected on the data, which makes it exact to the last bits. A rank-deficient problem gets the solution
/// of smallest norm in the scaled parameters, and [`Fit::unidentifiable`] says which parameters it leaves open.
///
/// For records that come in pieces, or that are too long to keep, see [`crate::Accumulator`].
///
/// Source: paper eq. (45).
///
/// # Errors
///
/// [`FitError::NoSegment`], [`FitError::TooFewSamples`], [`FitError::ConstantInput`], [`FitError::BadValue`] for a rank tolerance outside
/// 0 .. 1 or no thread, [`FitError::Overflow`] if the two signals differ too much in magnitude.
///
/// # Example
///
/// A running sum of the input, `y_o(k+1) = y_o(k) + y_i(k)`, is D(q) = q - 1 with h_0 = 1:
///
/// ```
/// use cfi_ident::{ConstantTerm, FitOptions, Orders, Segment, Structure, fit};
///
/// let input = [1.0, 0.0, 2.0, -1.0, 3.0, 1.0];
/// let output = [0.0, 1.0, 1.0, 3.0, 2.0, 5.0];
/// let structure = Structure::new(Orders::new(1, 0, 0)?, ConstantTerm::Included);
/// let fit = fit(&[Segment::new(&input, &output)?], &structure, &FitOptions::default())?;
///
/// assert_eq!(fit.rank, 2);
/// assert!((fit.model.denominator()[0] + 1.0).abs() < 1e-15);
/// assert!((fit.model.markov_parameter(0) - 1.0).abs() < 1e-15);
/// # Ok::<(), cfi_ident::FitError>(())
/// ```
pub fn fit(
    segments: &[Segment<'_>],
    structure: &Structure,
    options: &FitOptions,
) -> Result<Fit, FitError> {
    options.check()?;
    let counts = check(segments, structure, structure.parameter_count())?;
    let solution = match options.engine {
        Engine::Gram => gram::solve(segments, structure, options)?,
        Engine::Qr => householder::solve(segments, structure, options)?,
    };
    Fit::new(structure, counts, &solution)
}

impl Fit {
    /// The solution in terms of the model.
    pub(crate) fn new(
        structure: &Structure,
        counts: Counts,
        solution: &Solution,
    ) -> Result<Self, FitError> {
        let degrees_of_freedom = counts.equations - solution.rank;
        let free = (degrees_of_freedom > 0).then_some(degrees_of_freedom as f64);
        let deviation = free.map_or(0.0, |free| solution.residual_norm / free.sqrt());
        // Deviation over norm first: each alone may be near the end of the range.
        let unit = |(factor, exponent): &(f64, i32)| {
            if *factor > 0.0 { scale(deviation / factor, -exponent) } else { deviation }
        };
        let units: Vec<f64> = solution.norms.iter().map(unit).collect();
        Ok(Self {
            model: CfiModel::from_theta(*structure, &solution.theta)?,
            residual_norm: solution.residual_norm,
            residual_rms: solution.residual_norm / (counts.equations as f64).sqrt(),
            relative_residual: solution.relative_residual,
            rank: solution.rank,
            condition: solution.condition,
            singular_values: solution.singular_values.clone(),
            parameter_covariance: DMatrix::from_fn(units.len(), units.len(), |i, j| {
                solution.inverse[(i, j)] * units[i] * units[j]
            }),
            degrees_of_freedom,
            noise_variance: free.map(|_| deviation * deviation),
            unidentifiable: unidentifiable(structure, solution),
            equations: counts.equations,
            samples_used: counts.samples_used,
            segments_without_equation: counts.segments_without_equation,
            expected_error: solution.expected_error,
            refinement: solution.refinement,
        })
    }
}

fn unidentifiable(structure: &Structure, solution: &Solution) -> Option<Unidentifiable> {
    if solution.rank == solution.norms.len() {
        return None;
    }
    let mut directions = solution.null_directions.clone();
    let takes_part: Vec<bool> =
        directions.row_iter().map(|row| row.norm() > PARTICIPATION).collect();
    for (mut row, (factor, exponent)) in directions.row_iter_mut().zip(&solution.norms) {
        let norm = if *factor > 0.0 { *factor } else { 1.0 };
        row.iter_mut().for_each(|x| *x = scale(*x / norm, -exponent));
    }
    for mut column in directions.column_iter_mut() {
        let largest = column.amax();
        column /= largest;
        column.normalize_mut();
    }
    let named = structure.parameters().zip(takes_part);
    Some(Unidentifiable {
        directions,
        parameters: named.filter_map(|(name, part)| part.then_some(name)).collect(),
    })
}
