use super::*;
use crate::likelihood::fixtures::Normal;

const COUNT: usize = 400;

fn noise(rows: usize, normal: &mut Normal) -> DMatrix<Complex<f64>> {
    normal.matrix(rows, COUNT).zip_map(&normal.matrix(rows, COUNT), Complex::new)
}

#[test]
fn what_follows_the_inputs_is_coherent_and_what_does_not_is_not() {
    let mut normal = Normal::new(7);
    let inputs = noise(2, &mut normal);
    let followed = inputs.row(0) * Complex::new(0.0, 2.0) + inputs.row(1) * Complex::new(-1.0, 0.5);
    let alone = noise(1, &mut normal);
    let half = &followed * Complex::from(0.4) + alone.row(0);
    let signals = DMatrix::from_rows(&[followed, alone.row(0).into_owned(), half]);
    let (found, by_chance) = coherence(&signals, &inputs);
    let mean = |row: usize| found.row(row).mean();
    assert!((0.05..0.2).contains(&by_chance), "{by_chance}");
    assert!(mean(0) > 0.999_999);
    assert!((mean(1) - by_chance).abs() < 0.05, "{}", mean(1));
    assert!((0.3..0.7).contains(&mean(2)), "{}", mean(2));
    // All of the first, none of the second.
    let tied = tied_and_unexplained(&signals, &signals, &inputs);
    assert!(tied[0] > 0.8 && tied[1] < 0.06, "{tied:?}");
}

#[test]
fn an_input_that_rests_ties_nothing() {
    let mut normal = Normal::new(8);
    let signals = noise(1, &mut normal);
    let (found, by_chance) = coherence(&signals, &DMatrix::zeros(1, COUNT));
    assert!(found.amax() == 0.0 && by_chance == 0.0);
    // Two inputs that move alike are one.
    let one = noise(1, &mut normal);
    let twice = DMatrix::from_rows(&[one.row(0).into_owned(), one.row(0) * Complex::from(3.0)]);
    let (both, _) = coherence(&signals, &twice);
    let (single, _) = coherence(&signals, &one);
    assert!((both - single).amax() < 1e-3);
}
