//! What the paper's method says beside the modes.

use num_complex::Complex;
use reconstruct::paper;
use reconstruct::paper::Identification;
use serde::Serialize;

use crate::json::Number;

/// How one transmissibility was identified.
#[derive(Serialize)]
pub(super) struct TransmissibilityOutput<'a> {
    record: &'a str,
    input: &'a str,
    output: &'a str,
    rank: usize,
    parameters: usize,
    condition: f64,
    relative_residual: f64,
    realized_orders: [usize; 2],
    zeros: Vec<Number>,
    poles: Vec<Number>,
}

/// Those of all records and outputs, in the method's order.
pub(super) fn transmissibilities(result: &paper::Solution) -> Vec<TransmissibilityOutput<'_>> {
    result.identifications.iter().map(transmissibility).collect()
}

fn transmissibility(identified: &Identification) -> TransmissibilityOutput<'_> {
    let fit = &identified.fit;
    let numbers = |values: &[Complex<f64>]| values.iter().map(|&value| value.into()).collect();
    TransmissibilityOutput {
        record: &identified.record,
        input: &identified.input,
        output: &identified.output,
        rank: fit.rank,
        parameters: fit.model.structure().parameter_count(),
        condition: fit.condition,
        relative_residual: fit.relative_residual,
        realized_orders: [
            identified.realization.causal.order,
            identified.realization.anticausal.order,
        ],
        zeros: numbers(&identified.zeros),
        poles: numbers(&identified.poles),
    }
}
