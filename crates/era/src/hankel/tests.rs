use nalgebra::DMatrix;

use super::{Blocks, block_hankel};
use crate::EraError;
use crate::fixtures::matrix;

fn scalars(values: &[f64]) -> Vec<DMatrix<f64>> {
    values.iter().map(|&value| DMatrix::from_element(1, 1, value)).collect()
}

#[test]
fn scalar_matrix_is_constant_along_antidiagonals() {
    let sequence = scalars(&[1.0, 2.0, 3.0, 4.0, 5.0]);
    let blocks = Blocks { rows: 2, columns: 3 };
    assert_eq!(block_hankel(&sequence, blocks, 0), matrix(&[[1.0, 2.0, 3.0], [2.0, 3.0, 4.0]]));
    assert_eq!(block_hankel(&sequence, blocks, 1), matrix(&[[2.0, 3.0, 4.0], [3.0, 4.0, 5.0]]));
}

#[test]
fn blocks_keep_their_layout() {
    // Two outputs, one input: a block is a column of two.
    let sequence =
        vec![matrix(&[[1.0], [10.0]]), matrix(&[[2.0], [20.0]]), matrix(&[[3.0], [30.0]])];
    let blocks = Blocks { rows: 2, columns: 2 };
    assert_eq!(
        block_hankel(&sequence, blocks, 0),
        matrix(&[[1.0, 2.0], [10.0, 20.0], [2.0, 3.0], [20.0, 30.0]])
    );
}

#[test]
fn default_shape_is_as_square_as_it_can_be() {
    fn check(available: usize, outputs: usize, inputs: usize, expected: (usize, usize)) {
        let blocks = Blocks::choose(None, None, available, outputs, inputs).unwrap();
        assert_eq!(
            (blocks.rows, blocks.columns),
            expected,
            "{available} parameters, {outputs} by {inputs}"
        );
        let side = |rows: usize| (rows * outputs).min((available - rows) * inputs);
        let best = (1..available).map(side).max().unwrap();
        assert_eq!(side(blocks.rows), best);
    }
    check(2, 1, 1, (1, 1));
    check(25, 1, 1, (12, 13));
    check(24, 1, 1, (12, 12));
    check(12, 2, 1, (4, 8));
    check(12, 1, 2, (8, 4));
    check(2, 5, 1, (1, 1));
    check(3, 1, 9, (2, 1));
}

#[test]
fn shapes_that_do_not_fit_are_refused() {
    fn check(rows: Option<usize>, columns: Option<usize>, available: usize, expected: EraError) {
        assert_eq!(Blocks::choose(rows, columns, available, 1, 1), Err(expected));
    }
    check(None, None, 1, EraError::TooFewMarkovParameters { found: 1, needed: 2 });
    check(Some(3), Some(4), 6, EraError::TooFewMarkovParameters { found: 6, needed: 7 });
    check(Some(6), None, 6, EraError::TooFewMarkovParameters { found: 6, needed: 7 });
    check(Some(0), Some(4), 6, EraError::EmptyHankel { rows: 0, columns: 4 });
    check(
        Some(usize::MAX),
        None,
        6,
        EraError::TooFewMarkovParameters { found: 6, needed: usize::MAX },
    );
}
