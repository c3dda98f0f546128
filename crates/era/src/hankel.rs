//! Block-Hankel matrices of Markov parameters, and their shapes.

use nalgebra::DMatrix;

use crate::EraError;

/// Number of block rows and block columns of a Hankel matrix.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Blocks {
    pub(crate) rows: usize,
    pub(crate) columns: usize,
}

impl Blocks {
    /// Chooses what was not asked for.
    ///
    /// `H` and its shift together use `rows + columns` parameters. By default all `available` are used, split so that
    /// the scalar matrix is as square as it can be: its smaller side bounds the order.
    pub(crate) fn choose(
        rows: Option<usize>,
        columns: Option<usize>,
        available: usize,
        outputs: usize,
        inputs: usize,
    ) -> Result<Self, EraError> {
        if available < 2 {
            return Err(EraError::TooFewMarkovParameters { found: available, needed: 2 });
        }
        let (rows, columns) = match (rows, columns) {
            (Some(rows), Some(columns)) => (rows, columns),
            (Some(rows), None) => (rows, available.saturating_sub(rows).max(1)),
            (None, Some(columns)) => (available.saturating_sub(columns).max(1), columns),
            (None, None) => {
                // The largest min(rows * outputs, columns * inputs) with rows + columns = available. The smaller side
                // grows with `rows` up to this point and shrinks after it, so one of the two neighbours is the best.
                let below = available * inputs / (outputs + inputs);
                let side = |rows: usize| (rows * outputs).min((available - rows) * inputs);
                let low = below.clamp(1, available - 1);
                let high = (below + 1).clamp(1, available - 1);
                let rows = if side(high) > side(low) { high } else { low };
                (rows, available - rows)
            }
        };
        if rows == 0 || columns == 0 {
            return Err(EraError::EmptyHankel { rows, columns });
        }
        let needed = rows.saturating_add(columns);
        if needed > available {
            return Err(EraError::TooFewMarkovParameters { found: available, needed });
        }
        Ok(Self { rows, columns })
    }
}

/// The block-Hankel matrix whose block `(i, j)` is `sequence[i + j + shift]`.
///
/// The caller has checked that the sequence reaches to `rows + columns - 2 + shift` and that all blocks have one shape.
pub(crate) fn block_hankel(
    sequence: &[DMatrix<f64>],
    blocks: Blocks,
    shift: usize,
) -> DMatrix<f64> {
    let (outputs, inputs) = sequence[0].shape();
    DMatrix::from_fn(blocks.rows * outputs, blocks.columns * inputs, |row, column| {
        let block = &sequence[row / outputs + column / inputs + shift];
        block[(row % outputs, column % inputs)]
    })
}

#[cfg(test)]
mod tests;
