//! Fits of records that come in pieces and are not kept.

use hankel::{Options, Seam};

use crate::{
    Engine, Fit, FitError, FitOptions, Structure,
    error::Signal,
    gram::{from_hankel, solution},
    regressors::{Counts, layout},
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
    input: Variation,
}

/// Whether the pseudo input has varied.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Variation {
    NoSample,
    Constant(f64),
    Varies,
}

impl Accumulator {
    /// An accumulator without samples.
    ///
    /// # Errors
    ///
    /// [`FitError::BadValue`] for options out of range, and for [`Engine::Qr`], which needs the record as a whole.
    pub fn new(structure: &Structure, options: &FitOptions) -> Result<Self, FitError> {
        options.check()?;
        if options.engine != Engine::Gram {
            let what = "the engine, of which reflections are the second,";
            return Err(FitError::BadValue { what, value: 2.0, needed: "the first: lag products" });
        }
        let summing = Options { threads: options.threads, ..Options::default() };
        Ok(Self {
            structure: *structure,
            options: options.clone(),
            sums: hankel::Accumulator::new(&layout(structure), &summing).map_err(from_hankel)?,
            counts: Counts::default(),
            open: 0,
            input: Variation::NoSample,
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
            Err(hankel::HankelError::NotFinite { .. }) => {
                check_finite(input, Signal::Input)?;
                check_finite(output, Signal::Output)?;
            }
            Err(other) => return Err(from_hankel(other)),
        }
        self.open += input.len();
        if self.input != Variation::Varies
            && let Some(first) = input.first()
        {
            let before = match self.input {
                Variation::Constant(value) => value,
                _ => *first,
            };
            let same = input.iter().all(|x| x.total_cmp(&before).is_eq());
            self.input = if same { Variation::Constant(before) } else { Variation::Varies };
        }
        Ok(())
    }

    /// Ends the segment: what is pushed next does not follow the last sample.
    pub fn gap(&mut self) {
        self.sums.gap();
        if self.open > 0 {
            self.counts.add(&self.structure, self.open);
            self.open = 0;
        }
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
        self.counts.equations += other.counts.equations;
        self.counts.samples_used += other.counts.samples_used;
        self.counts.samples += other.counts.samples;
        self.counts.segments += other.counts.segments;
        self.counts.segments_without_equation += other.counts.segments_without_equation;
        self.open = other.open;
        self.input = match (self.input, other.input) {
            (Variation::NoSample, seen) | (seen, Variation::NoSample) => seen,
            (Variation::Constant(a), Variation::Constant(b)) if a.total_cmp(&b).is_eq() => {
                self.input
            }
            _ => Variation::Varies,
        };
        Ok(())
    }

    /// The fit of everything so far. More may be pushed afterwards.
    ///
    /// # Errors
    ///
    /// [`FitError::NoSegment`], [`FitError::TooFewSamples`], [`FitError::ConstantInput`], [`FitError::Overflow`].
    pub fn fit(&self) -> Result<Fit, FitError> {
        let mut counts = self.counts;
        if self.open > 0 {
            counts.add(&self.structure, self.open);
        }
        counts.suffice(&self.structure, self.structure.parameter_count())?;
        if let Variation::Constant(value) = self.input {
            return Err(FitError::ConstantInput { value });
        }
        let gram = self.sums.gram().map_err(from_hankel)?;
        let found = gram
            .least_squares(self.structure.parameter_count(), self.options.rank_tolerance)
            .map_err(from_hankel)?;
        Fit::new(&self.structure, counts, &solution(&found, &self.structure))
    }
}
