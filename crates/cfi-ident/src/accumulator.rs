//! Fits of records that come in pieces and are not kept.

use hankel::{Options, Seam};

use crate::{
    Engine, Fit, FitError, FitOptions, Structure,
    error::Signal,
    gram::{from_hankel, solution},
    regressors::{Constancy, Counts, constant_value, equal, layout},
    segment::check_finite,
};

/// A fit in the making: samples are pushed in pieces of any size, in memory that does not grow with their number.
///
/// The result is the one of [`crate::fit`] without refinement on the data, which are gone: [`Fit::expected_error`] says what that costs. It
/// matters only for condition numbers above about 1e7, and a relative residual is known down to about 1e-14.
///
/// # Example
///
/// ```
/// use cfi_ident::{Accumulator, ConstantTerm, FitOptions, Orders, Structure};
///
/// // y_o(k) = y_i(k) - 3 y_i(k - 1), 1000 samples at a time.
/// let structure = Structure::new(Orders::new(0, 1, 0)?, ConstantTerm::Omitted);
/// let mut sums = Accumulator::new(&structure, &FitOptions::default())?;
/// let input = |k: u32| f64::from(k * k % 101);
/// for piece in 0..20_u32 {
///     let steps = 1000 * piece + 1..1000 * (piece + 1) + 1;
///     let u: Vec<f64> = steps.clone().map(input).collect();
///     let y: Vec<f64> = steps.map(|k| input(k) - 3.0 * input(k - 1)).collect();
///     sums.push(&u, &y)?;
/// }
/// let fit = sums.fit()?;
/// assert_eq!(fit.equations, 19_999);
/// assert!((fit.model.markov_parameter(1) + 3.0).abs() < 1e-14);
/// # Ok::<(), cfi_ident::FitError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Accumulator {
    structure: Structure,
    options: FitOptions,
    sums: hankel::Accumulator,
    /// Of the segments that are complete.
    counts: Counts,
    /// Samples of the one that is not.
    open: usize,
    /// The first value of the pseudo input in that segment, and whether it has varied since.
    open_input: Option<(f64, bool)>,
    constancy: Constancy,
}

impl Accumulator {
    /// An accumulator without samples.
    ///
    /// # Errors
    ///
    /// [`FitError::BadValue`] for options out of range, [`FitError::EngineNeedsRecord`] for [`Engine::Qr`].
    pub fn new(structure: &Structure, options: &FitOptions) -> Result<Self, FitError> {
        options.check()?;
        if options.engine != Engine::Gram {
            return Err(FitError::EngineNeedsRecord);
        }
        let summing = Options { threads: options.threads, ..Options::default() };
        Ok(Self {
            structure: *structure,
            options: options.clone(),
            sums: hankel::Accumulator::new(&layout(structure), &summing).map_err(from_hankel)?,
            counts: Counts::default(),
            open: 0,
            open_input: None,
            constancy: Constancy::default(),
        })
    }

    /// Adds further samples of both signals.
    ///
    /// # Errors
    ///
    /// [`FitError::UnequalLengths`], [`FitError::NotFinite`]. Nothing has been added then.
    pub fn push(&mut self, input: &[f64], output: &[f64]) -> Result<(), FitError> {
        if input.len() != output.len() {
            return Err(FitError::UnequalLengths { input: input.len(), output: output.len() });
        }
        match self.sums.push(&[input, output]) {
            Ok(()) => {}
            Err(error) => {
                check_finite(input, Signal::Input)?;
                check_finite(output, Signal::Output)?;
                return Err(from_hankel(error));
            }
        }
        self.open += input.len();
        if let Some(first) = input.first() {
            let (before, varied) = self.open_input.unwrap_or((*first, false));
            let varies = varied || constant_value(input).is_none_or(|value| !equal(value, before));
            self.open_input = Some((before, varies));
        }
        Ok(())
    }

    /// Ends the segment: what is pushed next does not follow the last sample.
    pub fn gap(&mut self) {
        self.sums.gap();
        if self.open > 0 {
            (self.counts, self.constancy) = self.with_open();
            (self.open, self.open_input) = (0, None);
        }
    }

    /// Counts and constancy with the segment that is not complete.
    fn with_open(&self) -> (Counts, Constancy) {
        let (mut counts, mut constancy) = (self.counts, self.constancy);
        if self.open > 0 {
            counts.add(&self.structure, self.open);
            if let Some((first, varies)) = self.open_input
                && self.structure.orders.equations(self.open) > 0
            {
                constancy.add_segment((!varies).then_some(first), first);
            }
        }
        (counts, constancy)
    }

    /// Adds what another accumulator has seen, as other segments: the sums of several files or threads become one.
    ///
    /// # Errors
    ///
    /// [`FitError::DifferentStructures`]. Nothing has been added then.
    pub fn merge(&mut self, other: &Self) -> Result<(), FitError> {
        if self.structure != other.structure {
            return Err(FitError::DifferentStructures);
        }
        self.gap();
        self.sums.merge(&other.sums, Seam::Gap).map_err(from_hankel)?;
        self.counts.merge(&other.counts);
        self.constancy.merge(other.constancy);
        (self.open, self.open_input) = (other.open, other.open_input);
        Ok(())
    }

    /// The fit of everything so far. More may be pushed afterwards.
    ///
    /// # Errors
    ///
    /// [`FitError::NoSegment`], [`FitError::TooFewSamples`], [`FitError::ConstantInput`], [`FitError::Overflow`].
    pub fn fit(&self) -> Result<Fit, FitError> {
        let (counts, constancy) = self.with_open();
        counts.suffice(&self.structure, self.structure.parameter_count())?;
        constancy.check()?;
        let gram = self.sums.gram().map_err(from_hankel)?;
        let found = gram
            .least_squares(self.structure.parameter_count(), self.options.rank_tolerance)
            .map_err(from_hankel)?;
        Fit::new(&self.structure, counts, &solution(&found, &self.structure))
    }
}
