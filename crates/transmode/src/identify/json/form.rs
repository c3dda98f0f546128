//! The part of the JSON on the form of the equations, where the lateral ones were fitted to records of unknown excitation.

use serde::Serialize;

use super::recorded::{DerivativeOutput, rows, word};
use crate::identify::outcome::Outcome;

#[derive(Serialize)]
pub(super) struct FormOutput<'a> {
    structure: &'static str,
    compared: ComparedOutput,
    derivatives: Vec<DerivativeOutput<'a>>,
    correlations: Vec<Vec<f64>>,
}

#[derive(Serialize)]
struct ComparedOutput {
    structure: &'static str,
    order: usize,
    above: f64,
    /// Of the lateral equations against the other form.
    p_value: f64,
}

pub(super) fn form<'a>(outcome: &Outcome<'a>) -> Option<FormOutput<'a>> {
    let other = outcome.result.compared_form()?;
    let fit = outcome.result.fit()?;
    Some(FormOutput {
        structure: word(!other.is_lateral),
        compared: ComparedOutput {
            structure: word(other.is_lateral),
            order: other.order,
            above: other.above,
            p_value: other.p_value,
        },
        derivatives: fit.derivatives.iter().map(DerivativeOutput::from).collect(),
        correlations: rows(&fit.correlations),
    })
}
