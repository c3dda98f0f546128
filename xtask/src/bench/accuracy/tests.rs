use super::*;

#[test]
fn the_condition_is_about_what_is_planted() {
    for power in [2, 6, 10] {
        let condition = 10.0_f64.powi(power);
        let [input, output] = planted_record(condition, 0.0);
        let found = ours::fit(&input, &output, PLANTED, How::Qr).unwrap().condition;
        assert!((0.2..5.0).contains(&(found / condition)), "1e{power}: {found:e}");
    }
}

#[test]
fn the_exact_solution_is_that_of_the_fit() {
    // Well conditioned and with a residual: the fit is right to a few units, if both mean the same
    // equations.
    let [input, output] = planted_record(1e2, 1e-3);
    let truth = exact_solution(&input, &output).unwrap();
    let fit = ours::fit(&input, &output, PLANTED, How::Qr).unwrap();
    assert!(distance(&fit.model.theta(), &truth) < 1e-12);
    // The control: the planted coefficients themselves are farther away, by the residual.
    let [input, output] = planted_record(1e2, 0.0);
    assert!(distance(&exact_solution(&input, &output).unwrap(), &truth) > 1e-6);
}

#[test]
fn roots_are_compared_one_by_one() {
    // q (q - 2)(q + 4)
    let truth = [Complex::new(2.0, 0.0), Complex::new(-4.0, 0.0)];
    assert!(roots_error(&[0.0, -8.0, 2.0, 1.0], &truth).unwrap() < 1e-14);
    let off = [Complex::new(2.0, 0.0), Complex::new(-5.0, 0.0)];
    assert!((roots_error(&[0.0, -8.0, 2.0, 1.0], &off).unwrap() - 0.2).abs() < 1e-14);
}

#[test]
fn the_worst_case_counts() {
    let mut worst = Worst::default();
    worst.add(1e-12, 1e-11);
    worst.add(3e-13, 1e-13);
    assert!((worst.error - 1e-12).abs() < 1e-25 && (worst.ratio - 3.0).abs() < 1e-12);
    // Both exact: nothing to choose between them.
    let mut exact = Worst::default();
    exact.add(0.0, 0.0);
    assert!((exact.ratio - 1.0).abs() < 1e-15);
    worst.add(f64::NAN, 1e-11);
    assert!(worst.error.is_infinite() && worst.ratio.is_infinite());
}
