//! A start for the lateral equations: regression of derivatives on states and inputs, in the frequency domain (Klein & Morelli, Aircraft System
//! Identification, 2006, chapter 7).
//!
//! The transform of x' is j w X plus a constant, that of phi is (P + tan(theta) R) / j w plus one over j w, so that each equation is linear in its derivatives.
//! Noise biases them the less, the lower the frequencies.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

use super::spectra::Spectrum;

/// The parameters of the equations, from the frequencies up to `highest` in rad/s; `None` where they do not determine them.
pub(super) fn lateral_start(
    spectra: &[Spectrum],
    equations: &LateralEquations,
    highest: f64,
) -> Option<DVector<f64>> {
    const RANGE_OF_G_OVER_U: (f64, f64) = (0.02, 0.3);
    const LARGEST_TAN: f64 = 0.3;
    let sensor = |state: usize| equations.reads.iter().position(|&read| read == state);
    let (beta, p, r) = (sensor(0)?, sensor(1)?, sensor(2)?);
    let inputs = equations.inputs;
    let mut equation = [Rows::default(), Rows::default(), Rows::default()];
    for (record, spectrum) in spectra.iter().enumerate() {
        let mut ends = vec![Complex::ZERO; 2 * spectra.len()];
        for (k, &frequency) in spectrum.frequencies.iter().enumerate() {
            if frequency > highest {
                break;
            }
            let s = Complex::new(0.0, frequency);
            let y = spectrum.y.column(k);
            // An input that is held is late by half a period.
            let lag = Complex::new(0.0, -frequency * equations.period);
            let held = (Complex::from(1.0) - lag.exp()) / -lag;
            let moved: Vec<_> = spectrum.u.column(k).iter().map(|u| u * held).collect();
            ends[2 * record] = Complex::ONE;
            ends[2 * record + 1] = s.inv();
            let states = [y[beta], y[p], y[r]];
            let mut side = states.to_vec();
            side.extend([y[p] / s, y[r] / s]);
            side.extend(&moved);
            side.extend(&ends);
            equation[0].push(side, s * y[beta]);
            for (place, rate) in [(1, y[p]), (2, y[r])] {
                let mut moment = states.to_vec();
                moment.extend(&moved);
                moment.extend(ends.iter().step_by(2));
                equation[place].push(moment, s * rate);
            }
        }
    }
    let [side, roll, yaw] = equation.map(Rows::solve);
    let (side, roll, yaw) = (side?, roll?, yaw?);
    let mut parameters = DVector::zeros(equations.parameters());
    parameters.rows_mut(0, 3).copy_from(&side.rows(0, 3));
    let ratio = side[3].clamp(RANGE_OF_G_OVER_U.0, RANGE_OF_G_OVER_U.1);
    parameters[G_OVER_U] = ratio;
    parameters[10] = (side[4] / ratio).clamp(-LARGEST_TAN, LARGEST_TAN);
    for (found, first) in [(&roll, 4), (&yaw, 7)] {
        parameters.rows_mut(first, 3).copy_from(&found.rows(0, 3));
    }
    for input in 0..inputs {
        parameters[LateralEquations::control(0, input)] = side[5 + input];
        parameters[LateralEquations::control(1, input)] = roll[3 + input];
        parameters[LateralEquations::control(2, input)] = yaw[3 + input];
    }
    parameters.iter().all(|value| value.is_finite()).then_some(parameters)
}

/// Rows of a regression.
#[derive(Default)]
struct Rows {
    left: Vec<Vec<Complex<f64>>>,
    right: Vec<Complex<f64>>,
}

impl Rows {
    fn push(&mut self, left: Vec<Complex<f64>>, right: Complex<f64>) {
        self.left.push(left);
        self.right.push(right);
    }

    /// Real coefficients.
    fn solve(self) -> Option<DVector<f64>> {
        const RANK: f64 = 1e-10;
        let (count, columns) = (self.left.len(), self.left.first()?.len());
        let part = |row: usize, value: Complex<f64>| if row < count { value.re } else { value.im };
        let mut left = DMatrix::from_fn(2 * count, columns, |row, column| {
            part(row, self.left[row % count][column])
        });
        let right = DVector::from_fn(2 * count, |row, _| part(row, self.right[row % count]));
        let sizes: Vec<f64> = left.column_iter().map(|column| column.norm()).collect();
        for (mut column, size) in left.column_iter_mut().zip(&sizes) {
            if *size > 0.0 {
                column /= *size;
            }
        }
        if !left.iter().chain(right.iter()).all(|entry| entry.is_finite()) {
            return None;
        }
        let gram = left.tr_mul(&left);
        let found = gram.svd(true, true).solve(&left.tr_mul(&right), RANK * RANK).ok()?;
        let unscaled = |k: usize, _| if sizes[k] > 0.0 { found[k] / sizes[k] } else { 0.0 };
        Some(DVector::from_fn(columns, unscaled))
    }
}
use crate::model::lateral_equations::{G_OVER_U, LateralEquations};
