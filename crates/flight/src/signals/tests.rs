use super::*;
use crate::{Stream, normal};

#[test]
fn the_autoregression_remembers() {
    let signal = autoregressive(normal(1, 20_000, &mut Stream::new(5, 0)));
    let sum = |lag: usize| (lag..20_000).map(|k| signal[k] * signal[k - lag]).sum::<f64>();
    assert!((sum(0) / 20_000.0 - 1.0).abs() < 0.1);
    assert!((sum(1) / sum(0) - 0.9).abs() < 0.02);
}

/// Values and lengths of the stretches in which a signal stands still.
fn runs(signal: &DMatrix<f64>) -> Vec<(f64, usize)> {
    let same = |a: &f64, b: &f64| (a - b).abs() < 0.5;
    signal.as_slice().chunk_by(same).map(|run| (run[0], run.len())).collect()
}

#[test]
fn the_multistep_is_three_two_one_one() {
    let mut signal = DMatrix::zeros(1, 300);
    add_multistep(&mut signal, 10, 7, 1.0);
    assert_eq!(runs(&signal), [(0.0, 10), (1.0, 21), (-1.0, 14), (1.0, 7), (-1.0, 7), (0.0, 241)]);
}

#[test]
fn a_doublet_goes_there_and_back_and_ends_with_the_signal() {
    let mut signal = DMatrix::zeros(1, 30);
    add_doublet(&mut signal, 5, 4, -2.0);
    add_doublet(&mut signal, 25, 4, 2.0);
    assert_eq!(runs(&signal), [(0.0, 5), (-2.0, 4), (2.0, 4), (0.0, 12), (2.0, 4), (-2.0, 1)]);
}
