use super::*;

fn curve(points: &[(f64, f64)]) -> Curve {
    Curve { who: Who::Fit, points: points.to_vec() }
}

#[test]
fn counts_are_shown_as_powers() {
    assert_eq!(power(100_000_000), "1e8");
    assert_eq!(power(25_000), "2.5e4");
    assert_eq!([show_place(404), show_place(10_000)], ["404", "1e4"]);
}

#[test]
fn memory_that_grows_is_seen() {
    let text = |peaks: &[(usize, u64)]| format!("{:?}", memory_row(peaks));
    assert!(text(&[(1_000_000, 10_000_000), (100_000_000, 10_500_000)]).contains("\"yes\""));
    assert!(text(&[(1_000_000, 10_000_000), (100_000_000, 1_600_000_000)]).contains("**no**"));
    assert!(text(&[(1_000_000, 10_000_000)]).contains("not measured"));
}

#[test]
fn places_without_a_time_stay_empty() {
    let curves = [curve(&[(10.0, 1.0), (100.0, 2.0)]), curve(&[(10.0, 3.0)]), curve(&[])];
    let Block::Table(table) = curve_table("t", "N", &curves).unwrap() else {
        panic!("a table");
    };
    assert_eq!(table.columns().len(), 3);
    assert_eq!(table.rows(), [["10", "1.00 s", "3.00 s"], ["100", "2.00 s", "-"]]);
}

#[test]
fn both_figures_can_be_drawn() {
    let curves = [curve(&[(1e4, 1e-4), (1e8, 1.0)]), curve(&[])];
    let drawn = report::svg::render(&figure("benchmarks-length", "t", "c", "samples N", &curves));
    assert!(drawn.unwrap().contains("time (s)"));
}

#[test]
fn powers_are_found() {
    for power in [-1.0, 0.0, 0.5, 1.0, 2.0] {
        let points: Vec<_> =
            [1e1, 1e2, 3e2, 1e5].iter().map(|x: &f64| (*x, 7e-9 * x.powf(power))).collect();
        assert!((log_log_slope(&points).unwrap() - power).abs() < 1e-12, "{power}");
    }
}

#[test]
fn scatter_is_averaged() {
    // log10 y = 0, 2, 1 over log10 x = 0, 1, 2: by hand the slope is 1/2.
    let slope = log_log_slope(&[(1.0, 1.0), (10.0, 100.0), (100.0, 10.0)]).unwrap();
    assert!((slope - 0.5).abs() < 1e-14);
}

#[test]
fn there_is_no_slope_without_two_places() {
    for points in [
        &[][..],
        &[(1.0, 1.0)],
        &[(2.0, 1.0), (2.0, 3.0)],
        &[(1.0, 1.0), (2.0, 0.0)],
        &[(-1.0, 1.0), (2.0, 1.0)],
        &[(1.0, f64::NAN), (2.0, 1.0)],
    ] {
        assert_eq!(log_log_slope(points), None, "{points:?}");
    }
}
