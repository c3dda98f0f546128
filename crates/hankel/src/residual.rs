//! What a solution leaves of the target, computed from the data themselves, and the step that it asks for.
//!
//! The Gram matrix forgets what is below [`Gram::rounding`] of it; where the condition number squared is larger than its inverse,
//! a pass over the data brings the rest:
//!
//! ```text
//! r = t - X b,    b <- b + (X' X)^-1 X' r
//! ```
//!
//! with each element of r and of X' r computed in doubled precision and rounded once. A step shrinks the error by about
//! `condition^2 * rounding`, so one or two suffice (Björck, *Numerical Methods for Least Squares Problems*, SIAM 1996: corrected seminormal
//! equations).

mod pass;

use crate::{HankelError, Layout, LeastSquares, Missing, Options, gaps::pieces};
use pass::{Pass, Residual};

/// A correction relative to the solution that is rounding.
const ROUNDING: f64 = f64::EPSILON;

impl LeastSquares {
    /// Repeats the correction from the data until it is at rounding level, does not shrink any more, or `steps` are done.
    ///
    /// `layout`, `record` and `options` are those of the Gram matrix. The residual norm becomes that of the data as well, exact to the digits of
    /// a double however small it is. A step costs about as much as the Gram matrix.
    ///
    /// # Errors
    ///
    /// As [`crate::gram`]; [`HankelError::DifferentLayouts`] if the layout has another number of columns than the solution,
    /// [`HankelError::BadSize`] if the record gives another number of rows.
    ///
    /// # Example
    ///
    /// ```
    /// use hankel::{Column, Layout, Options, gram};
    ///
    /// let record: [&[f64]; 2] = [&[1.0, 2.0, 4.0, 8.5], &[1.0, 1.0, 3.0, 2.0]];
    /// let layout = Layout::new(2, vec![Column::new(1, 0), Column::new(0, 0)])?;
    /// let options = Options::default();
    /// let found = gram(&layout, &record, &options)?.least_squares(1, None)?;
    /// let refined = found.refined(&layout, &record, &options, 3)?;
    /// assert!(refined.refinement.converged);
    /// assert!((refined.coefficients[0] - 32.0 / 15.0).abs() < 1e-15);
    /// # Ok::<(), hankel::HankelError>(())
    /// ```
    pub fn refined(
        &self,
        layout: &Layout,
        record: &[&[f64]],
        options: &Options,
        steps: usize,
    ) -> Result<Self, HankelError> {
        self.refined_on(layout, &[record], options, steps)
    }

    /// The same with several segments, between which there are gaps.
    ///
    /// # Errors
    ///
    /// As [`LeastSquares::refined`].
    pub fn refined_on(
        &self,
        layout: &Layout,
        segments: &[&[&[f64]]],
        options: &Options,
        steps: usize,
    ) -> Result<Self, HankelError> {
        let size = self.coefficients.len() + 1;
        if !layout.is_symmetric() || layout.columns().len() != size {
            return Err(HankelError::DifferentLayouts);
        }
        let mut all: Vec<Vec<&[f64]>> = Vec::new();
        for segment in segments {
            // Without gaps they have been found finite when they were summed; that is checked again only if something is not.
            let whole = layout.samples(segment)?;
            let stretches = match options.missing {
                Missing::Refuse => vec![(0, whole)],
                Missing::Gap => pieces(layout, segment, options.missing)?,
            };
            for (from, to) in stretches {
                all.push(segment.iter().map(|channel| &channel[from..to]).collect());
            }
        }
        let length = |channels: &Vec<&[f64]>| channels.first().map_or(0, |channel| channel.len());
        let rows: usize = all.iter().map(|channels| layout.rows(length(channels))).sum();
        if rows != self.rows {
            let what = "the number of rows of the record to refine on";
            let needed = format!("that of the Gram matrix, {}", self.rows);
            return Err(HankelError::BadSize { what, found: rows, needed });
        }
        let mut pass = Pass {
            fit: self,
            layout,
            segments: &all,
            threads: options.threads.max(1),
            residual: Residual::Rounded,
        };
        let mut best = self.clone();
        let mut state = pass.run(&best.scaled);
        if !state.squares.is_finite() {
            segments.iter().try_for_each(|s| pieces(layout, s, options.missing).map(|_| ()))?;
        }
        // Rounding r to doubles moves the solution by its norm times the rounding unit over the smallest singular value.
        let moved = state.squares.sqrt() * self.factor.condition();
        if moved > self.factor.scaled_norm(&best.scaled) {
            pass.residual = Residual::InTwoParts;
            state = pass.run(&best.scaled);
        }
        let mut previous = f64::INFINITY;
        for _ in 0..steps {
            let correction = self.correction(&state.gradient);
            let size = self.factor.scaled_norm(&correction);
            let norm = self.factor.scaled_norm(&best.scaled);
            let relative = if size > 0.0 { size / norm } else { 0.0 };
            // A correction that does not shrink means that the condition number is beyond what refinement can mend.
            if !(relative < 0.5 * previous || relative <= ROUNDING) {
                break;
            }
            for (b, step) in best.scaled.iter_mut().zip(&correction) {
                *b += step;
            }
            best.refinement.steps += 1;
            best.refinement.last_correction = relative;
            best.refinement.converged = relative <= ROUNDING;
            // What a correction at rounding level changes in the residual is rounding too.
            if best.refinement.converged {
                break;
            }
            previous = relative;
            state = pass.run(&best.scaled);
        }
        best.describe(state.squares.sqrt())?;
        Ok(best)
    }
}
