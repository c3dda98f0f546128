//! What a page shows where all inputs were recorded: measured against simulated, what is left over, in which band the answer lives, derivatives.

mod left_over;
mod time_histories;

use report::Block;

use super::derivatives;
use crate::CommandError;
use crate::identify::outcome::Outcome;

pub(super) const TIME_HISTORIES_ID: &str = "time-histories";
pub(super) const LEFT_OVER_ID: &str = "left-over";
pub(super) const COHERENCE_ID: &str = "coherence";

/// Nothing where no model has inputs.
pub(super) fn blocks(input: &Outcome<'_>) -> Result<Vec<Block>, CommandError> {
    let Some(fit) = input.result.output_error() else { return Ok(Vec::new()) };
    let mut blocks = time_histories::blocks(input, fit)?;
    blocks.extend(derivatives::with_controls(input, fit)?);
    blocks.extend(left_over::blocks(input, fit));
    Ok(blocks)
}
