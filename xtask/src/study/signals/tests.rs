use super::*;

#[test]
fn the_autoregression_remembers() {
    let mut random = stream(5, 0);
    let signal = autoregressive(normal(1, 20_000, &mut random));
    let sum = |lag: usize| (lag..20_000).map(|k| signal[k] * signal[k - lag]).sum::<f64>();
    assert!((sum(0) / 20_000.0 - 1.0).abs() < 0.1);
    assert!((sum(1) / sum(0) - 0.9).abs() < 0.02);
}

#[test]
fn the_multistep_is_three_two_one_one() {
    let mut signal = DMatrix::zeros(1, 300);
    multistep(&mut signal, 10, 1.0);
    let runs: Vec<(f64, usize)> = signal
        .as_slice()
        .chunk_by(|a, b| (a - b).abs() < 0.5)
        .map(|run| (run[0], run.len()))
        .collect();
    let expected = [(0.0, 10), (1.0, 21), (-1.0, 14), (1.0, 7), (-1.0, 7), (0.0, 241)];
    assert_eq!(runs, expected);
}
