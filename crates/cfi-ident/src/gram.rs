//! The engine that sums lag products: one pass over the data, whatever the number of parameters.

use hankel::{Layout, LeastSquares, Options};
#[cfg(feature = "regularized")]
use nalgebra::{DMatrix, DVector};

use crate::{
    FitError, FitOptions, Refinement, Segment, Structure,
    regressors::{layout, sign},
    solution::Solution,
};

/// Off by less than this, relative, a parameter is as good as rounded.
const ROUNDED: f64 = f64::EPSILON / 8.0;

/// A relative residual below this many times the root of the sums' rounding is taken from the data: it may be rounding of the sums.
const RESIDUAL_MARGIN: f64 = 1e3;

/// Sums, solves, and corrects on the data where the sums leave something to correct.
pub(crate) fn solve(
    segments: &[Segment<'_>],
    structure: &Structure,
    options: &FitOptions,
) -> Result<Solution, FitError> {
    let layout = layout(structure);
    let summing = Options { threads: options.threads, ..Options::default() };
    let gram = sums(segments, &layout, &summing)?;
    let target = structure.parameter_count();
    let found = gram.least_squares(target, options.rank_tolerance).map_err(from_hankel)?;
    let hidden = found.relative_residual < RESIDUAL_MARGIN * gram.rounding().sqrt();
    if options.refinement_steps == 0 || (found.expected_error < ROUNDED && !hidden) {
        return Ok(solution(&found, structure));
    }
    let channels: Vec<[&[f64]; 2]> = segments.iter().map(|s| [s.input(), s.output()]).collect();
    let records: Vec<&[&[f64]]> = channels.iter().map(|pair| &pair[..]).collect();
    let refined = found
        .refined_on(&layout, &records, &summing, options.refinement_steps)
        .map_err(from_hankel)?;
    Ok(solution(&refined, structure))
}

/// The Gram matrix of [Phi' Psi'] without the signs.
pub(crate) fn sums(
    segments: &[Segment<'_>],
    layout: &Layout,
    options: &Options,
) -> Result<hankel::Gram, FitError> {
    let mut sums = hankel::Accumulator::new(layout, options).map_err(from_hankel)?;
    for segment in segments {
        sums.push(&[segment.input(), segment.output()]).map_err(from_hankel)?;
        sums.gap();
    }
    sums.gram().map_err(from_hankel)
}

/// In the paper's signs and the crate's terms.
pub(crate) fn solution(found: &LeastSquares, structure: &Structure) -> Solution {
    let signs: Vec<f64> = (0..structure.parameter_count()).map(|i| sign(structure, i)).collect();
    let factor = &found.factor;
    let mut inverse = factor.inverse();
    let mut null_directions = factor.null_directions();
    for (i, sign) in signs.iter().enumerate() {
        inverse.row_mut(i).scale_mut(*sign);
        inverse.column_mut(i).scale_mut(*sign);
        null_directions.row_mut(i).scale_mut(*sign);
    }
    let expected_error =
        if found.refinement.converged { f64::EPSILON } else { found.expected_error };
    Solution {
        theta: found.coefficients.iter().zip(&signs).map(|(b, sign)| b * sign).collect(),
        residual_norm: found.residual_norm,
        relative_residual: found.relative_residual,
        rank: factor.rank(),
        condition: factor.condition(),
        singular_values: factor.singular_values().to_vec(),
        inverse,
        norms: factor.norms(),
        null_directions,
        expected_error: expected_error.max(f64::EPSILON),
        refinement: Refinement {
            steps: found.refinement.steps,
            last_correction: found.refinement.last_correction,
            converged: found.refinement.converged || found.expected_error < ROUNDED,
        },
    }
}

/// The problem in the size of its parameters: `|| Psi - theta Phi ||^2` is `|| b - a theta ||^2` and the square of what nothing explains.
#[cfg(feature = "regularized")]
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Reduced {
    /// For the pseudo input in units of 2^input_exponent and the pseudo output in units of 2^output_exponent, as everything else here.
    pub(crate) a: DMatrix<f64>,
    pub(crate) b: DVector<f64>,
    pub(crate) target_norm: f64,
    pub(crate) unexplained_norm: f64,
    pub(crate) input_exponent: i32,
    pub(crate) output_exponent: i32,
}

/// Sums and reduces.
#[cfg(feature = "regularized")]
pub(crate) fn reduce(segments: &[Segment<'_>], structure: &Structure) -> Result<Reduced, FitError> {
    use crate::regressors::{exponent, scale};
    let target = structure.parameter_count();
    let gram = sums(segments, &layout(structure), &Options::default())?;
    let found = gram.least_squares(target, None).map_err(from_hankel)?;
    let norms = found.factor.norms();
    let output_exponent = exponent(found.target_norm);
    // h_0: the pseudo input at the step itself.
    let (_, input_exponent) = norms[structure.denominator_count() + structure.orders.anticausal()];
    let mut a = found.factor.triangle();
    for (i, (mut column, (factor, exponent))) in a.column_iter_mut().zip(norms).enumerate() {
        let unit = if i < structure.denominator_count() { output_exponent } else { input_exponent };
        column *= sign(structure, i) * scale(factor, exponent - unit);
    }
    let in_unit = |x: &f64| scale(*x, -output_exponent);
    Ok(Reduced {
        a,
        b: DVector::from_iterator(found.projected.len(), found.projected.iter().map(in_unit)),
        target_norm: in_unit(&found.target_norm),
        unexplained_norm: in_unit(&found.unexplained_norm),
        input_exponent,
        output_exponent,
    })
}

/// What is left to go wrong once segments and structure have been checked.
pub(crate) fn from_hankel(error: hankel::HankelError) -> FitError {
    match error {
        hankel::HankelError::Overflow { .. } => FitError::Overflow { what: "a parameter" },
        hankel::HankelError::BadValue { what, value, needed } => {
            FitError::BadValue { what, value, needed }
        }
        other => FitError::Sums { reason: other.to_string() },
    }
}
