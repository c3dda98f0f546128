//! What there is to say against a fit.

use std::fmt;

use report::format_significant;

use super::outcome::{FitOutcome, Passes};

/// Parameters that rounding may move by more than this are doubtful: ten digits are more than any sensor has, and fewer would hide that the
/// record barely determines them.
const LARGEST_ERROR: f64 = 1e-10;

/// A relative residual below this may be rounding of the sums: they are exact to about 1e-30 of squares, and the margin is a thousand.
const RESIDUAL_FLOOR: f64 = 1e-12;

/// How many parameters a message names.
const NAMED: usize = 5;

/// One reason for care.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Warning {
    /// The record leaves parameters open.
    RankDeficient { rank: usize, parameters: usize, open: Vec<String> },
    /// The parameters are off by rounding.
    Rounding { expected_error: f64, passes: Passes },
    /// The residual of the sums is rounding.
    ResidualFloor { relative_residual: f64 },
    /// Stretches between gaps that gave no equation.
    ShortSegments { count: usize, segments: usize, needed: usize },
    /// No equation is left to judge the parameters by.
    NoFreedom { equations: usize },
    /// The poles are not known.
    NoPoles { reason: String },
}

impl Warning {
    /// Whether the parameters cannot be trusted.
    pub(super) fn is_doubt(&self) -> bool {
        matches!(self, Self::RankDeficient { .. } | Self::Rounding { .. })
    }

    /// A short name for other programs.
    pub(super) fn code(&self) -> &'static str {
        match self {
            Self::RankDeficient { .. } => "rank-deficient",
            Self::Rounding { .. } => "rounding",
            Self::ResidualFloor { .. } => "residual-floor",
            Self::ShortSegments { .. } => "short-segments",
            Self::NoFreedom { .. } => "no-degrees-of-freedom",
            Self::NoPoles { .. } => "no-poles",
        }
    }
}

/// All that holds, the gravest first.
pub(super) fn warnings(outcome: &FitOutcome) -> Vec<Warning> {
    let fit = &outcome.fit;
    let structure = fit.model.structure();
    let parameters = structure.parameter_count();
    let passes = outcome.passes;
    let mut warnings = Vec::new();
    if let Some(open) = &fit.unidentifiable {
        let open = open.parameters.iter().map(ToString::to_string).collect();
        warnings.push(Warning::RankDeficient { rank: fit.rank, parameters, open });
    }
    if fit.expected_error > LARGEST_ERROR {
        warnings.push(Warning::Rounding { expected_error: fit.expected_error, passes });
    }
    if passes == Passes::One && fit.relative_residual < RESIDUAL_FLOOR {
        warnings.push(Warning::ResidualFloor { relative_residual: fit.relative_residual });
    }
    if fit.segments_without_equation > 0 {
        let orders = structure.orders;
        let needed = orders.samples_needed(1);
        let (count, segments) = (fit.segments_without_equation, outcome.segments);
        warnings.push(Warning::ShortSegments { count, segments, needed });
    }
    if fit.degrees_of_freedom == 0 {
        warnings.push(Warning::NoFreedom { equations: fit.equations });
    }
    if let Err(reason) = &outcome.poles {
        warnings.push(Warning::NoPoles { reason: reason.clone() });
    }
    warnings
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::RankDeficient { rank, parameters, open } => {
                write!(
                    f,
                    "rank {rank} of {parameters}: the record does not determine {}",
                    open.iter().take(NAMED).map(String::as_str).collect::<Vec<_>>().join(", ")
                )?;
                if open.len() > NAMED {
                    write!(f, " and {} more", open.len() - NAMED)?;
                }
                f.write_str("; the smallest solution is given, lower orders may be determined")
            }
            Self::Rounding { expected_error, passes } => {
                let error = format_significant(*expected_error, 2);
                write!(f, "rounding may have moved the parameters by {error} of their size; ")?;
                f.write_str(match passes {
                    Passes::One => {
                        "a second pass over the data, which would correct it, is not made for NPY and raw files: \
                         lower the orders, or fit the record as CSV if it fits into memory"
                    }
                    Passes::Several => "correcting it on the data did not converge: lower the orders",
                })
            }
            Self::ResidualFloor { relative_residual } => {
                let residual = format_significant(*relative_residual, 2);
                write!(
                    f,
                    "the relative residual {residual} is at the floor of what one pass can tell: residual and deviations may be \
                     rounding, the parameters are not affected; a second pass, which would tell, is not made for NPY and raw files"
                )
            }
            Self::ShortSegments { count, segments, needed } => write!(
                f,
                "{count} of {segments} stretches between gaps are shorter than the {needed} samples of one equation and were \
                 left out"
            ),
            Self::NoFreedom { equations } => write!(
                f,
                "{equations} equations are met exactly: there is no residual left that would tell how exact the parameters are"
            ),
            Self::NoPoles { reason } => write!(f, "the poles are not known: {reason}"),
        }
    }
}
