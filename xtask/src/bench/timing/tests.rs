use super::*;

fn timing(seconds: &[f64]) -> Timing {
    Timing::new(seconds.to_vec()).unwrap()
}

#[test]
fn the_median_is_the_middle() {
    for (seconds, median) in [
        (vec![3.0], 3.0),
        (vec![4.0, 1.0], 2.5),
        (vec![9.0, 1.0, 2.0], 2.0),
        (vec![8.0, 1.0, 2.0, 4.0], 3.0),
    ] {
        assert!((timing(&seconds).median() - median).abs() < 1e-15, "{seconds:?}");
    }
}

#[test]
fn outliers_do_not_widen_the_spread() {
    let (low, high) = timing(&[1.0, 2.0, 3.0, 4.0, 100.0]).quartiles();
    assert!((low - 2.0).abs() < 1e-15 && (high - 4.0).abs() < 1e-15);
    let (low, high) = timing(&[5.0]).quartiles();
    assert!((low - 5.0).abs() < 1e-15 && (high - 5.0).abs() < 1e-15);
}

#[test]
fn what_is_no_time_is_left_out() {
    assert_eq!(Timing::new(vec![]), None);
    assert_eq!(Timing::new(vec![f64::NAN, 0.0, -1.0, f64::INFINITY]), None);
    assert_eq!(timing(&[f64::NAN, 2.0]), timing(&[2.0]));
}

#[test]
fn work_runs_once_more_than_it_is_counted() {
    let mut calls = 0;
    let runs = Runs { count: 3, patience: Duration::from_secs(60) };
    let timing = measure(runs, || {
        calls += 1;
        Ok(())
    });
    assert_eq!((timing.unwrap().runs(), calls), (3, 4));

    let impatient = Runs { count: 3, patience: Duration::ZERO };
    assert_eq!(measure(impatient, || Ok(())).unwrap().runs(), 1);
}

#[test]
fn units_suit_the_size() {
    for (seconds, text) in
        [(2.4, "2.40 s"), (0.056, "56.0 ms"), (1e-3, "1.00 ms"), (1.25e-5, "12.5 us")]
    {
        assert_eq!(show_seconds(seconds), text);
    }
}
