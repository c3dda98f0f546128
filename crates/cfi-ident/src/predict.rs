//! What a model says the pseudo output is, and how far the record is from it.

use crate::{CfiModel, FitError, Segment, error::Signal, segment::check_finite};

/// Which values of the pseudo output a prediction may use.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Prediction {
    /// Every value is predicted from measured values of both signals: what least squares minimises.
    OneStep,
    /// Only the first values are measured, the rest feeds on its own predictions. Roots of D outside the unit circle make it diverge.
    Simulated,
}

/// Consecutive values of the pseudo output.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Predicted {
    /// Index in the record of the first value: r + l.
    pub first: usize,
    /// The values, one for each equation that lies in the record.
    pub values: Vec<f64>,
}

impl CfiModel {
    /// Predicts the pseudo output.
    ///
    /// ```text
    /// y_o(k + l) = - sum over i of c_i y_o(k + i) + sum over i = -d .. r of h_i y_i(k - i),     k = r .. N - 1 - max(l, d)
    /// ```
    ///
    /// # Errors
    ///
    /// [`FitError::UnequalLengths`], [`FitError::NotFinite`], [`FitError::TooShort`] if no equation fits in the record,
    /// [`FitError::Overflow`] if a simulation leaves the range of numbers.
    ///
    /// # Example
    ///
    /// The running sum y_o(k+1) = y_o(k) + y_i(k) on a record with one wrong value:
    ///
    /// ```
    /// use cfi_ident::{CfiModel, ConstantTerm, Orders, Prediction, Structure};
    ///
    /// let structure = Structure::new(Orders::new(1, 0, 0)?, ConstantTerm::Included);
    /// let sum = CfiModel::new(structure, &[-1.0], &[1.0])?;
    /// let (input, output) = ([1.0, 2.0, 3.0, 0.0], [0.0, 1.0, 7.0, 6.0]);
    ///
    /// let one_step = sum.predict(&input, &output, Prediction::OneStep)?;
    /// assert_eq!((one_step.first, one_step.values), (1, vec![1.0, 3.0, 10.0]));
    /// let simulated = sum.predict(&input, &output, Prediction::Simulated)?;
    /// assert_eq!(simulated.values, [1.0, 3.0, 6.0]);
    /// assert_eq!(sum.residuals(&input, &output)?.values, [0.0, 4.0, -4.0]);
    /// # Ok::<(), cfi_ident::FitError>(())
    /// ```
    pub fn predict(
        &self,
        input: &[f64],
        output: &[f64],
        prediction: Prediction,
    ) -> Result<Predicted, FitError> {
        Segment::new(input, output)?;
        let first = self.first_predicted(input.len())?;
        let measured = &output[first - self.known_outputs()..first];
        match prediction {
            Prediction::Simulated => self.pseudo_output(input, measured),
            Prediction::OneStep => {
                let values = self
                    .fir(input)
                    .enumerate()
                    .map(|(n, forced)| forced - self.feedback(&output[..first + n]));
                finite(first, values.collect())
            }
        }
    }

    /// Measured minus predicted pseudo output, one step ahead: the residual that the least-squares fit (45) minimises.
    ///
    /// # Errors
    ///
    /// As [`CfiModel::predict`].
    pub fn residuals(&self, input: &[f64], output: &[f64]) -> Result<Predicted, FitError> {
        let mut predicted = self.predict(input, output, Prediction::OneStep)?;
        predicted
            .values
            .iter_mut()
            .zip(&output[predicted.first..])
            .for_each(|(x, measured)| *x = measured - *x);
        Ok(predicted)
    }

    /// The pseudo output that follows from a pseudo input and the values just before the first one predicted.
    ///
    /// `initial` holds y_o(r + 1) .. y_o(r + l - 1) without the constant term, and y_o(r) .. y_o(r + l - 1) with it: as many as D(q) has
    /// unknown coefficients.
    ///
    /// # Errors
    ///
    /// [`FitError::NotFinite`], [`FitError::CoefficientCount`] for another number of initial values, [`FitError::TooShort`],
    /// [`FitError::Overflow`].
    ///
    /// # Example
    ///
    /// ```
    /// # use cfi_ident::{CfiModel, ConstantTerm, Orders, Structure};
    /// // y_o(k+1) = y_o(k) / 2 + y_i(k), from y_o(0) = 8.
    /// let structure = Structure::new(Orders::new(1, 0, 0)?, ConstantTerm::Included);
    /// let decay = CfiModel::new(structure, &[-0.5], &[1.0])?;
    /// assert_eq!(decay.pseudo_output(&[0.0, 0.0, 5.0, 0.0], &[8.0])?.values, [4.0, 2.0, 6.0]);
    /// # Ok::<(), cfi_ident::FitError>(())
    /// ```
    pub fn pseudo_output(&self, input: &[f64], initial: &[f64]) -> Result<Predicted, FitError> {
        check_finite(input, Signal::Input)?;
        check_finite(initial, Signal::Output)?;
        let needed = self.known_outputs();
        if initial.len() != needed {
            return Err(FitError::CoefficientCount {
                what: "initial values",
                found: initial.len(),
                needed,
            });
        }
        let first = self.first_predicted(input.len())?;
        let mut values = initial.to_vec();
        for forced in self.fir(input) {
            values.push(forced - self.feedback(&values));
        }
        finite(first, values.split_off(needed))
    }

    /// How many earlier values of the pseudo output an equation uses.
    fn known_outputs(&self) -> usize {
        self.structure().denominator_count()
    }

    fn first_predicted(&self, samples: usize) -> Result<usize, FitError> {
        let orders = self.structure().orders;
        if orders.equations(samples) == 0 {
            return Err(FitError::TooShort { samples, orders, needed: orders.samples_needed(1) });
        }
        Ok(orders.causal() + orders.iir())
    }

    /// Sum of h_i y_i(k - i) for every step k with an equation.
    fn fir(&self, input: &[f64]) -> impl Iterator<Item = f64> {
        let orders = self.structure().orders;
        let markov = self.markov_parameters();
        // The window input[n ..] runs from y_i(k - r) to y_i(k + d), which is h_r to h_-d.
        (0..orders.equations(input.len()))
            .map(move |n| input[n..].iter().zip(markov.iter().rev()).map(|(y, h)| h * y).sum())
    }

    /// Sum of c_i y_o(k + i), where `past` ends at y_o(k + l - 1).
    fn feedback(&self, past: &[f64]) -> f64 {
        let known = &past[past.len() - self.known_outputs()..];
        known.iter().zip(self.unknown_denominator()).map(|(y, c)| c * y).sum()
    }
}

fn finite(first: usize, values: Vec<f64>) -> Result<Predicted, FitError> {
    if values.iter().all(|x| x.is_finite()) {
        Ok(Predicted { first, values })
    } else {
        Err(FitError::Overflow { what: "a predicted pseudo output" })
    }
}

#[cfg(test)]
mod tests;
