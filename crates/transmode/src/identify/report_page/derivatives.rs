//! The form of the equations, and the derivatives where it is the lateral ones.

use nalgebra::DMatrix;
use reconstruct::likelihood::Derivative;
use reconstruct::output_error::Fit;
use report::{Block, Column, Table, format_significant};

use crate::CommandError;
use crate::identify::outcome::Outcome;

/// Correlations above this are worth a word.
const CLOSE: f64 = 0.9;

/// Where nobody gave the excitation; nothing where the lateral equations were not fitted.
pub(super) fn blocks(input: &Outcome<'_>) -> Result<Vec<Block>, CommandError> {
    let (Some(form), Some(fit)) = (input.form(), input.result.fit()) else {
        return Ok(Vec::new());
    };
    let mut blocks = vec![
        Block::section("Form of the equations"),
        Block::paragraph(format!("The form used: {form}.")),
    ];
    if !fit.derivatives.is_empty() {
        blocks.extend(dimensional(&fit.derivatives, &fit.correlations)?);
    }
    Ok(blocks)
}

/// Where all inputs were recorded.
pub(super) fn with_controls(input: &Outcome<'_>, fit: &Fit) -> Result<Vec<Block>, CommandError> {
    if fit.derivatives.is_empty() {
        return Ok(Vec::new());
    }
    let mut blocks = vec![Block::section("Derivatives")];
    blocks.extend(dimensional(&fit.derivatives, &fit.correlations)?);
    if !input.coefficients.is_empty() {
        let rows = input.coefficients.iter();
        let rows = rows.map(|own| (&own.name, own.value, own.standard_error));
        blocks.push(table("Nondimensional coefficients", "coefficient", rows)?);
    }
    Ok(blocks)
}

fn dimensional(
    derivatives: &[Derivative],
    correlations: &DMatrix<f64>,
) -> Result<[Block; 3], CommandError> {
    let rows = derivatives.iter();
    let rows = rows.map(|own| (&own.name, own.estimate.value, own.estimate.standard_error));
    Ok([
        Block::paragraph(
            "States are beta, p, r and phi in rad and rad/s. Moments are accelerations, with products of inertia within L and N. `Y_r` stands for what is usually \
             written Y_r - 1. `Y_p`, `Y_r`, `g/U` and `tan(theta)` hardly matter to what sensors read and are held near what they are in flight.",
        ),
        table("Dimensional derivatives", "derivative", rows)?,
        Block::paragraph(correlated(derivatives, correlations)),
    ])
}

fn table<'a>(
    title: &str,
    what: &str,
    rows: impl Iterator<Item = (&'a String, f64, f64)>,
) -> Result<Block, CommandError> {
    let fault = |error: report::ReportError| CommandError::Report(error.to_string());
    let columns = [Column::left(what), Column::right("estimate"), Column::right("standard error")];
    let mut table = Table::new(title, columns);
    for (name, value, standard_error) in rows {
        let error = format_significant(standard_error, 2);
        table.push([name.clone(), format_significant(value, 5), error]).map_err(fault)?;
    }
    Ok(table.into())
}

/// The pairs that the records can hardly tell apart.
fn correlated(names: &[Derivative], correlations: &DMatrix<f64>) -> String {
    let pairs = (0..names.len()).flat_map(|i| (0..i).map(move |k| (k, i)));
    let close: Vec<String> = pairs
        .filter(|&(k, i)| correlations[(i, k)].abs() > CLOSE)
        .map(|(k, i)| {
            format!("{} and {} ({:.2})", names[k].name, names[i].name, correlations[(i, k)])
        })
        .collect();
    if close.is_empty() {
        return "No two estimates are correlated by more than 0.9.".to_owned();
    }
    format!("Estimates that are correlated by more than 0.9: {}.", close.join(", "))
}
