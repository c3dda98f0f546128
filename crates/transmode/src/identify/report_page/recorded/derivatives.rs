//! Stability and control derivatives, where the lateral equations were fitted.

use reconstruct::output_error::Fit;
use report::{Block, Column, Table, format_significant};

use crate::CommandError;

/// Correlations above this are worth a word.
const CLOSE: f64 = 0.9;

pub(super) fn blocks(fit: &Fit) -> Result<Vec<Block>, CommandError> {
    if fit.derivatives.is_empty() {
        return Ok(Vec::new());
    }
    let fault = |error: report::ReportError| CommandError::Report(error.to_string());
    let mut table = Table::new(
        "Dimensional derivatives",
        [Column::left("derivative"), Column::right("estimate"), Column::right("standard error")],
    );
    for derivative in &fit.derivatives {
        let number = |value: f64, digits| format_significant(value, digits);
        table
            .push([
                derivative.name.clone(),
                number(derivative.estimate.value, 5),
                number(derivative.estimate.standard_error, 2),
            ])
            .map_err(fault)?;
    }
    Ok(vec![
        Block::section("Derivatives"),
        Block::paragraph(
            "States are beta, p, r and phi in rad and rad/s. Moments are accelerations, with products of inertia within L and N. `Y_r` stands for what is usually \
             written Y_r - 1. `Y_p`, `Y_r`, `g/U` and `tan(theta)` hardly matter to what sensors read and are held near what they are in flight.",
        ),
        table.into(),
        Block::paragraph(correlated(fit)),
    ])
}

/// The pairs that the records can hardly tell apart.
fn correlated(fit: &Fit) -> String {
    let names = &fit.derivatives;
    let pairs = (0..names.len()).flat_map(|i| (0..i).map(move |k| (k, i)));
    let close: Vec<String> = pairs
        .filter(|&(k, i)| fit.correlations[(i, k)].abs() > CLOSE)
        .map(|(k, i)| {
            format!("{} and {} ({:.2})", names[k].name, names[i].name, fit.correlations[(i, k)])
        })
        .collect();
    if close.is_empty() {
        return "No two estimates are correlated by more than 0.9.".to_owned();
    }
    format!("Estimates that are correlated by more than 0.9: {}.", close.join(", "))
}
