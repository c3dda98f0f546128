use pulp::{Arch, Scalar, WithSimd};

use super::*;

#[test]
fn rows_are_exact_and_the_same_for_every_width() {
    let samples: Vec<f64> = (0..3 * ROWS).map(|k| ((k * k) % 89) as f64 / 128.0).collect();
    let weights = [0.75, -0.5, 2.0_f64.powi(-40)];
    let terms: Vec<Term<'_>> = weights
        .iter()
        .enumerate()
        .map(|(i, weight)| Term { weight: *weight, samples: &samples, start: 5 * i })
        .collect();
    let run = |arch: Option<Arch>| {
        let (mut rows, mut lost) = (vec![0.0; 2 * ROWS], vec![1.0; 2 * ROWS]);
        let combination =
            Combination { terms: &terms, bias: 4.0, rows: &mut rows, lost: &mut lost };
        match arch {
            Some(arch) => arch.dispatch(combination),
            None => combination.with_simd(Scalar),
        }
        assert!(lost.iter().all(|x| *x == 0.0));
        rows
    };
    let found = run(None);
    for (k, row) in found.iter().enumerate() {
        // Few bits each, so that the sum is exact in a double.
        let exact: f64 = weights.iter().enumerate().map(|(i, w)| w * samples[k + 5 * i]).sum();
        assert_eq!(*row, exact);
    }
    assert_eq!(run(Some(Arch::new())), found);
}
