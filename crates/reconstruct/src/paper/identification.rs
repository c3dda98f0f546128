//! One rational transmissibility from one record: composite FIR/IIR fit, realization of its two halves, product with 1/D, cancellation.

use cfi_ident::{ConstantTerm, Fit, FitOptions, Orders, Parameter, Segment, Structure};
use era::{
    CompositeOptions, CompositeRealization, CompositeTransfer, EraOptions, NoncausalMarkov, Order,
    realize_composite,
};
use lti::Transmissibility;
use num_complex::Complex;
use poly::{Cancellation, CancelledPair, MrootsOptions, Poly, Rational, Root, mroots};

use crate::{ReconstructError, Record};

/// How to identify one transmissibility.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct IdentificationOptions {
    /// The composite model; by default the paper's l = 4, r = d = 25, no constant term.
    pub structure: Structure,
    /// Realization of the causal half; by default order n_s = 6 at most, as the paper has it.
    pub causal: EraOptions,
    /// Realization of the time-reversed half; by default order n_u = 6 at most.
    pub anticausal: EraOptions,
    /// Zeros and poles closer than this cancel; by default 1e-6, as the paper has it.
    pub cancellation: f64,
}

/// A transmissibility identified from one record, with everything that was found on the way.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Identification {
    /// The record's name.
    pub record: String,
    /// The pseudo input's name.
    pub input: String,
    /// The pseudo output's name.
    pub output: String,
    /// The composite FIR/IIR model, its residual, rank and condition.
    pub fit: Fit,
    /// The poles of the composite model: the roots of D(q).
    pub composite_poles: Vec<Root>,
    /// The realizations of the two halves of the FIR factor, their singular values and orders.
    pub realization: CompositeRealization,
    /// The FIR factor as a rational function, and which coefficients counted as zero.
    pub factor: CompositeTransfer,
    /// The transmissibility: FIR factor over D, after cancellation.
    pub transmissibility: Transmissibility<f64>,
    /// Its zeros.
    pub zeros: Vec<Complex<f64>>,
    /// Its poles.
    pub poles: Vec<Complex<f64>>,
    /// Its gain: the ratio of the leading coefficients of numerator and denominator.
    pub gain: f64,
    /// The zeros and poles that were cancelled.
    pub cancelled: Vec<CancelledPair>,
    /// The closest zero and pole that were kept: how far the cancellation is from taking more.
    pub closest_kept: Option<CancelledPair>,
}

impl Default for IdentificationOptions {
    fn default() -> Self {
        let orders = Orders::new(4, 25, 25).expect("54 parameters are far below the limit");
        let half = EraOptions::with_order(Order::Fixed(6));
        Self {
            structure: Structure::new(orders, ConstantTerm::Omitted),
            causal: half,
            anticausal: half,
            cancellation: 1e-6,
        }
    }
}

/// Identifies the transmissibility from channel `input` to channel `output` of a record.
///
/// | step | paper |
/// |---|---|
/// | least squares on the composite FIR/IIR model | V.A, V.B |
/// | realization of the causal and of the time-reversed half of the FIR factor | V.C |
/// | FIR factor times 1/D, cancellation of close zeros and poles | V.C as corrected by VI |
///
/// The realization is told how uncertain the Markov parameters are: singular values below the standard deviations that the fit states
/// are not realised, whatever order is asked for.
///
/// # Errors
///
/// [`ReconstructError::NoSuchChannel`]; [`ReconstructError::Identification`] with the fit's reason, for example too few samples or a constant
/// pseudo input; [`ReconstructError::Step`] where the realization or the cancellation has no answer.
///
/// # Example
///
/// One sensor is the running difference of the other, p(k) = beta(k + 1) - beta(k): the transmissibility is q - 1.
///
/// ```
/// use lti::SamplePeriod;
/// use reconstruct::paper::{IdentificationOptions, identify_transmissibility};
/// use reconstruct::{Channel, Record};
///
/// let beta: Vec<f64> = (0..300).map(|k| f64::from(k * k % 101) - 50.0).collect();
/// let p: Vec<f64> = (0..300).map(|k| f64::from((k + 1) * (k + 1) % 101 - k * k % 101)).collect();
/// let record = Record::new("r", SamplePeriod::new(0.1)?, vec![Channel::new("beta", beta), Channel::new("p", p)])?;
/// let found = identify_transmissibility(&record, 0, 1, &IdentificationOptions::default())?;
/// assert_eq!((found.zeros.len(), found.poles.len()), (1, 0));
/// assert!((found.zeros[0] - 1.0).norm() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn identify_transmissibility(
    record: &Record,
    input: usize,
    output: usize,
    options: &IdentificationOptions,
) -> Result<Identification, ReconstructError> {
    let (input, output) = (record.get(input)?, record.get(output)?);
    let fault = |message: String| ReconstructError::Identification {
        record: record.name().to_owned(),
        input: input.name.clone(),
        output: output.name.clone(),
        message,
    };
    let segment =
        Segment::new(&input.values, &output.values).map_err(|error| fault(error.to_string()))?;
    let fit = cfi_ident::fit(&[segment], &options.structure, &FitOptions::default())
        .map_err(|error| fault(error.to_string()))?;

    let realization =
        realize_factor(&fit, record, options).map_err(|error| fault(error.to_string()))?;
    let factor = realization.transfer_function().map_err(|error| fault(error.to_string()))?;
    let denominator = Poly::new(fit.model.denominator());
    let composite_poles = mroots(&denominator, &MrootsOptions::default())
        .map_err(|error| fault(error.to_string()))?
        .roots;
    let whole = Rational::new(
        factor.rational.numerator().clone(),
        factor.rational.denominator() * &denominator,
    )
    .map_err(|error| fault(error.to_string()))?;
    let cancelled = whole
        .cancel(&Cancellation::within(options.cancellation))
        .map_err(|error| fault(error.to_string()))?;
    let transmissibility = Transmissibility::from_polynomials(
        cancelled.rational.numerator().clone(),
        cancelled.rational.denominator().clone(),
    )
    .map_err(|error| fault(error.to_string()))?;
    Ok(Identification {
        record: record.name().to_owned(),
        input: input.name.clone(),
        output: output.name.clone(),
        fit,
        composite_poles,
        realization,
        factor,
        transmissibility,
        zeros: cancelled.zeros,
        poles: cancelled.poles,
        gain: cancelled.gain,
        cancelled: cancelled.pairs,
        closest_kept: cancelled.closest_left,
    })
}

/// Both halves of the FIR factor, with the fit's own standard deviations as the level below which nothing is realised.
fn realize_factor(
    fit: &Fit,
    record: &Record,
    options: &IdentificationOptions,
) -> Result<CompositeRealization, era::EraError> {
    let structure = fit.model.structure();
    let anticausal = structure.orders.anticausal();
    let markov = NoncausalMarkov::from_window(&fit.model.markov_parameters(), anticausal)?;
    let deviation = largest_markov_deviation(fit, &structure);
    let floored =
        |half: EraOptions| half.noise_floor(half.noise_floor.unwrap_or(0.0).max(deviation));
    let both = CompositeOptions::new(floored(options.causal), floored(options.anticausal));
    realize_composite(&markov, record.period(), &both)
}

/// The largest standard deviation of a Markov parameter, by the covariance of the fit.
fn largest_markov_deviation(fit: &Fit, structure: &Structure) -> f64 {
    structure
        .parameters()
        .enumerate()
        .filter(|(_, parameter)| matches!(parameter, Parameter::Markov(_)))
        .map(|(index, _)| fit.parameter_covariance[(index, index)].max(0.0).sqrt())
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests;
