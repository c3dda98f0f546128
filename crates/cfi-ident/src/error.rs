//! What can go wrong in an identification, with the numbers that explain it.

use crate::Orders;

/// Which of the two signals of a segment an error speaks of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Signal {
    /// The pseudo input `y_i`.
    Input,
    /// The pseudo output `y_o`.
    Output,
}

impl std::fmt::Display for Signal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Input => "pseudo input",
            Self::Output => "pseudo output",
        })
    }
}

/// Why a model could not be identified, built or used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FitError {
    /// The orders ask for more parameters than this crate accepts.
    #[error(
        "orders l = {iir}, r = {causal}, d = {anticausal} ask for more than the {limit} parameters allowed"
    )]
    OrdersTooLarge {
        /// Order l of the IIR factor.
        iir: usize,
        /// Causal length r.
        causal: usize,
        /// Anticausal length d.
        anticausal: usize,
        /// The largest number of parameters accepted.
        limit: usize,
    },
    /// The two signals of a segment differ in length.
    #[error(
        "the pseudo input has {input} samples and the pseudo output {output}: they must have the same number"
    )]
    UnequalLengths {
        /// Samples of the pseudo input.
        input: usize,
        /// Samples of the pseudo output.
        output: usize,
    },
    /// A sample is NaN or infinite.
    #[error("sample {index} of the {signal} is {value}: all samples must be finite")]
    NotFinite {
        /// Which signal.
        signal: Signal,
        /// Index of the sample, from zero.
        index: usize,
        /// What was found.
        value: f64,
    },
    /// No segment was given.
    #[error("no segment was given: at least one is needed")]
    NoSegment,
    /// The segments give fewer equations than there are parameters.
    #[error(
        "{samples} samples in {segments} segment(s) give {equations} equations for {parameters} parameters \
         ({orders}): at least {needed} samples in one segment are needed"
    )]
    TooFewSamples {
        /// Samples in all segments together.
        samples: usize,
        /// Number of segments.
        segments: usize,
        /// Equations (columns of the regressor matrix) that they give.
        equations: usize,
        /// Number of parameters to be found.
        parameters: usize,
        /// The orders asked for.
        orders: Orders,
        /// Samples that a single segment needs for as many equations as parameters.
        needed: usize,
    },
    /// A record is too short for a single equation of the model.
    #[error(
        "{samples} samples are too few for one equation with {orders}: at least {needed} are needed"
    )]
    TooShort {
        /// Samples given.
        samples: usize,
        /// The model's orders.
        orders: Orders,
        /// Samples needed.
        needed: usize,
    },
    /// The pseudo input does not vary within any segment, so its shifted copies are all the same.
    #[error(
        "the pseudo input is constant (its first value is {value}): it must vary to tell h_i from one another"
    )]
    ConstantInput {
        /// The first value of the first segment.
        value: f64,
    },
    /// A number that must be finite is not, because it overflowed.
    #[error("{what} overflowed: bring the two signals closer to one in magnitude")]
    Overflow {
        /// What overflowed.
        what: &'static str,
    },
    /// A list of coefficients has the wrong length for the structure.
    #[error("{found} {what} were given where the structure needs {needed}")]
    CoefficientCount {
        /// Which coefficients.
        what: &'static str,
        /// How many were given.
        found: usize,
        /// How many the structure needs.
        needed: usize,
    },
    /// A coefficient, zero, pole or option is NaN, infinite or out of its range.
    #[error("{what} is {value}: it must be {needed}")]
    BadValue {
        /// What the value is for.
        what: &'static str,
        /// What was found.
        value: f64,
        /// What is allowed.
        needed: &'static str,
    },
    /// Zeros or poles do not come in conjugate pairs, or the factor of degree l would split one.
    #[error(
        "{what} {value} stands without its conjugate: real coefficients need both in the same factor"
    )]
    Unpaired {
        /// Zero or pole.
        what: &'static str,
        /// The one that stands alone.
        value: nalgebra::Complex<f64>,
    },
    /// Fewer poles than the IIR factor is to hold.
    #[error("the IIR factor is to hold {needed} poles where there are {found}")]
    TooFewPoles {
        /// Poles of the transmissibility.
        found: usize,
        /// Poles the factor is to hold.
        needed: usize,
    },
    /// The conic solver found no solution.
    #[cfg(feature = "regularized")]
    #[error("the regularised problem was not solved: {status}")]
    Unsolved {
        /// How the solver ended.
        status: crate::regularized::Status,
    },
    /// The lag products could not be summed.
    #[error("the lag products of the two signals could not be summed: {reason}")]
    Sums {
        /// Why.
        reason: String,
    },
    /// Reflections, asked for where the record comes in pieces.
    #[error("reflections need the record as a whole: fit pieces with `Engine::Gram`")]
    EngineNeedsRecord,
    /// Two partial sums of different structures.
    #[error(
        "the two partial results have different structures: both need the same orders and constant term"
    )]
    DifferentStructures,
    /// A matrix decomposition did not converge.
    #[error("the singular value decomposition of a {size} x {size} triangle did not converge")]
    Decomposition {
        /// Rows and columns of the matrix.
        size: usize,
    },
}
