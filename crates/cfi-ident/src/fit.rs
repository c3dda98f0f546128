//! The least-squares fit: equations, triangle, factor, refinement, and what they say about the answer.

use nalgebra::DMatrix;

use crate::{
    CfiModel, FitError, Parameter, Refinement, Segment, Structure,
    factor::Factor,
    refine::{Refined, refine},
    regressors::{Equations, scale},
};

/// How to fit.
///
/// # Example
///
/// ```
/// use cfi_ident::FitOptions;
///
/// let plain = FitOptions { refinement_steps: 0, ..FitOptions::default() };
/// assert_eq!(plain.rank_tolerance, None);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FitOptions {
    /// Singular values at or below this fraction of the largest count as zero. The regressors are first scaled to norm one.
    ///
    /// `None` (the default) takes max(equations, parameters) times the rounding unit 2^-52, the level to which the
    /// triangle itself is known.
    pub rank_tolerance: Option<f64>,
    /// The largest number of refinement steps; 0 keeps the plain QR solution.
    ///
    /// The default is 4. A step costs about as much as the triangle. One brings nearly everything, the second confirms it.
    pub refinement_steps: usize,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self { rank_tolerance: None, refinement_steps: 4 }
    }
}

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
/// The equations are folded into a triangle by Householder reflections, the columns scaled to norm one, the rank taken from the singular
/// values, and the solution refined against the data with the residual in doubled precision. A rank-deficient problem gets the solution
/// of smallest norm in the scaled parameters, and [`Fit::unidentifiable`] says which parameters it leaves open.
///
/// Source: paper eq. (45).
///
/// # Errors
///
/// [`FitError::NoSegment`], [`FitError::TooFewSamples`], [`FitError::ConstantInput`], [`FitError::BadValue`] for a rank tolerance outside
/// 0 .. 1, [`FitError::Overflow`] if the two signals differ too much in magnitude.
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
    if let Some(value) = options.rank_tolerance
        && !(0.0..1.0).contains(&value)
    {
        return Err(FitError::BadValue {
            what: "the rank tolerance",
            value,
            needed: "at least 0 and less than 1",
        });
    }
    let equations = Equations::new(segments, structure, structure.parameter_count())?;
    let triangle = equations.triangle();
    let parameters = triangle.columns();
    let rounding = f64::EPSILON * count(triangle.rows().max(parameters));
    let factor = Factor::new(&triangle, options.rank_tolerance.unwrap_or(rounding))?;
    let theta = factor.solve(&triangle.right_hand_side());
    let refined = refine(&equations, &factor, theta, options.refinement_steps);
    summarise(&equations, &factor, &refined, triangle.target_norm())
}

/// Brings the answer back to the given units.
fn summarise(
    equations: &Equations,
    factor: &Factor,
    refined: &Refined,
    target: f64,
) -> Result<Fit, FitError> {
    let exponents: Vec<i32> = equations
        .columns
        .iter()
        .take(refined.theta.len())
        .map(|c| equations.parameter_exponent(*c))
        .collect();
    let theta: Vec<f64> =
        refined.theta.iter().zip(&exponents).map(|(x, e)| scale(*x, *e)).collect();
    if theta.iter().any(|x| !x.is_finite()) {
        return Err(FitError::Overflow { what: "a parameter" });
    }
    let degrees_of_freedom = equations.rows - factor.rank;
    let scaled_variance =
        (degrees_of_freedom > 0).then(|| refined.residual_norm.powi(2) / count(degrees_of_freedom));
    let unit = factor.unit_covariance();
    let variance = scaled_variance.unwrap_or(0.0);
    let parameter_covariance = DMatrix::from_fn(unit.nrows(), unit.ncols(), |i, j| {
        scale(scale(unit[(i, j)] * variance, exponents[i]), exponents[j])
    });
    let residual_norm = scale(refined.residual_norm, equations.output_exponent);
    Ok(Fit {
        model: CfiModel::from_theta(equations.structure, &theta)?,
        residual_norm,
        residual_rms: residual_norm / count(equations.rows).sqrt(),
        relative_residual: if target > 0.0 { refined.residual_norm / target } else { 0.0 },
        rank: factor.rank,
        condition: factor.condition(),
        singular_values: factor.singular_values.clone(),
        parameter_covariance,
        degrees_of_freedom,
        noise_variance: scaled_variance
            .map(|x| scale(scale(x, equations.output_exponent), equations.output_exponent)),
        unidentifiable: unidentifiable(equations, factor, &exponents),
        equations: equations.rows,
        samples_used: equations.samples_used,
        segments_without_equation: equations.segments_without_equation,
        refinement: refined.refinement,
    })
}

fn unidentifiable(
    equations: &Equations,
    factor: &Factor,
    exponents: &[i32],
) -> Option<Unidentifiable> {
    if factor.rank == exponents.len() {
        return None;
    }
    let mut directions = factor.null_directions();
    let takes_part: Vec<bool> =
        directions.row_iter().map(|row| row.norm() > PARTICIPATION).collect();
    for ((mut row, factor), exponent) in
        directions.row_iter_mut().zip(factor.scaling()).zip(exponents)
    {
        row.iter_mut().for_each(|x| *x = scale(*x * factor, *exponent));
    }
    for mut column in directions.column_iter_mut() {
        let largest = column.amax();
        column /= largest;
        column.normalize_mut();
    }
    let named = equations.structure.parameters().zip(takes_part);
    Some(Unidentifiable {
        directions,
        parameters: named.filter_map(|(name, part)| part.then_some(name)).collect(),
    })
}

/// A count as a number.
#[expect(clippy::cast_precision_loss, reason = "counts of samples stay far below 2^53")]
pub(crate) fn count(n: usize) -> f64 {
    n as f64
}
