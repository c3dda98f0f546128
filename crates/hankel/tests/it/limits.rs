//! Bad input, and the ends of the range of doubles.

use hankel::{Accumulator, Column, HankelError, Layout, Missing, Options, Seam, gram};

use crate::exact::{products, worst};

fn pair() -> Layout {
    Layout::new(2, vec![Column::new(0, 0), Column::new(1, -3)]).unwrap()
}

fn message(result: Result<impl Sized, HankelError>) -> String {
    result.err().unwrap().to_string()
}

#[test]
fn layouts_that_mean_nothing_are_refused() {
    let layout = |channels, columns: &[(usize, isize)]| {
        message(Layout::new(
            channels,
            columns.iter().map(|(c, lag)| Column::new(*c, *lag)).collect(),
        ))
    };
    assert!(layout(1, &[]).contains("no columns"));
    assert!(layout(2, &[(0, 1), (2, 0)]).contains("column 1 names channel 2, but there are 2"));
    assert!(
        layout(1, &[(0, 5), (0, 1), (0, 5)])
            .contains("columns 0 and 2 are both channel 0 at lag 5")
    );
    assert!(layout(1, &[(0, 0), (0, isize::MAX)]).contains("the lags span"));
    assert!(layout(1, &[(0, isize::MIN), (0, isize::MAX)]).contains("the lags span"));
    assert!(message(Layout::block_hankel(1, 0)).contains("no columns"));
    assert!(message(Layout::block_hankel(1, usize::MAX)).contains("the lags span"));
    assert!(message(Layout::cross(1, vec![Column::new(0, 0)], vec![])).contains("no columns"));
    // Far from zero, but close together.
    let far =
        Layout::new(1, vec![Column::new(0, isize::MAX), Column::new(0, isize::MAX - 1)]).unwrap();
    let found = gram(&far, &[&[1.0, 2.0, 3.0]], &Options::default()).unwrap();
    assert_eq!(found.matrix().unwrap().as_slice(), [13.0, 8.0, 8.0, 5.0]);
}

#[test]
fn records_that_do_not_fit_are_refused() {
    let options = Options::default();
    let of = |record: &[&[f64]]| message(gram(&pair(), record, &options));
    assert!(of(&[&[1.0]]).contains("1 channels were given, and the layout has 2"));
    assert!(of(&[&[1.0; 9], &[1.0; 8]]).contains("channel 1 has 8 samples, and channel 0 has 9"));
    assert!(
        of(&[&[], &[]])
            .contains("no row: the longest of 0 segments has 0 samples, and one row takes 4")
    );
    assert!(
        of(&[&[1.0; 3], &[1.0; 3]])
            .contains("longest of 1 segments has 3 samples, and one row takes 4")
    );
    assert!(of(&[&[1.0; 4], &[1.0, f64::NAN, 1.0, 1.0]]).contains("sample 1 of channel 1 is NaN"));
    assert!(of(&[&[1.0, 1.0, f64::INFINITY], &[1.0; 3]]).contains("sample 2 of channel 0 is inf"));
    let gaps = Options { missing: Missing::Gap, ..options };
    let infinite = gram(&pair(), &[&[1.0, f64::NEG_INFINITY], &[f64::NAN, 1.0]], &gaps);
    assert!(message(infinite).contains("sample 1 of channel 0 is -inf"));
    let nothing_left = [f64::NAN; 20];
    assert!(message(gram(&pair(), &[&nothing_left, &nothing_left], &gaps)).contains("no row"));
    assert!(
        message(Accumulator::new(&pair(), &Options { threads: 0, ..options })).contains("threads")
    );
}

#[test]
fn a_refused_piece_leaves_nothing_behind() {
    let mut accumulator = Accumulator::new(&pair(), &Options::default()).unwrap();
    accumulator.push(&[&[1.0, 2.0, 3.0, 4.0], &[1.0; 4]]).unwrap();
    let before = accumulator.clone();
    accumulator.push(&[&[1.0, 2.0], &[1.0, f64::NAN]]).unwrap_err();
    accumulator.push(&[&[1.0, 2.0], &[1.0]]).unwrap_err();
    let other =
        Accumulator::new(&Layout::block_hankel(2, 1).unwrap(), &Options::default()).unwrap();
    let refused = accumulator.merge(&other, Seam::Gap);
    assert_eq!(refused, Err(HankelError::DifferentLayouts));
    assert!(accumulator == before);
}

#[test]
fn options_of_the_factor_are_checked() {
    let found =
        gram(&pair(), &[&[1.0, 2.0, 4.0, 3.0, 1.0], &[1.0; 5]], &Options::default()).unwrap();
    for tolerance in [-1.0, 1.0, f64::NAN] {
        assert!(message(found.cholesky(Some(tolerance))).contains("rank tolerance"));
    }
    assert!(message(found.least_squares(2, None)).contains("index of the target is 2"));
    assert!(message(found.select(&[0, 7])).contains("index of a column is 7"));
    assert_eq!(found.entry(2, 0), None);
    let one = Layout::cross(1, vec![Column::new(0, 0)], vec![Column::new(0, 1)]).unwrap();
    let crossed = gram(&one, &[&[1.0, 2.0, 3.0]], &Options::default()).unwrap();
    assert!(message(crossed.cholesky(None)).contains("1 x 1"));
    assert!(message(crossed.least_squares(0, None)).contains("same columns on both sides"));
}

#[test]
fn huge_and_tiny_signals_are_summed_without_overflow() {
    let shape: Vec<f64> = (0..3000).map(|k| (0.3 * f64::from(k)).sin() + 0.1).collect();
    let scaled = |factor: f64| -> Vec<f64> { shape.iter().map(|x| x * factor).collect() };
    let layout = pair();
    let plain = gram(&layout, &[&shape, &shape], &Options::default()).unwrap().matrix().unwrap();
    let (huge, tiny) = (2.0_f64.powi(660), 2.0_f64.powi(-660));
    let found = gram(&layout, &[&scaled(huge), &scaled(tiny)], &Options::default()).unwrap();
    assert!(message(found.matrix()).contains("too large for a double"));
    assert_eq!(found.entry(0, 1).unwrap().value(), plain[(0, 1)]);
    let factor = found.cholesky(None).unwrap();
    assert_eq!(factor.rank(), 2);
    assert!(factor.condition() < 10.0);
    // Changing size within a record: the first and the last part fade beside the middle.
    let mut changing = scaled(tiny);
    changing[1000..2000].copy_from_slice(&scaled(huge)[1000..2000]);
    let found = gram(&layout, &[&changing, &shape], &Options::default()).unwrap();
    assert!(found.entry(0, 1).unwrap().value().is_finite());
    let subnormal = scaled(2.0_f64.powi(-1060));
    let found = gram(&layout, &[&subnormal, &shape], &Options::default()).unwrap();
    assert_eq!(found.cholesky(None).unwrap().rank(), 2);
    let largest = [f64::MAX; 10];
    let found = gram(&layout, &[&largest, &[1.0; 10]], &Options::default()).unwrap();
    assert!(message(found.matrix()).contains("too large"));
    assert_eq!(found.cholesky(None).unwrap().rank(), 1);
}

#[test]
fn zeros_are_fine() {
    let zeros = vec![0.0; 5000];
    let layout = pair();
    let found = gram(&layout, &[&zeros, &zeros], &Options::default()).unwrap();
    assert!(found.matrix().unwrap().iter().all(|x| *x == 0.0));
    let factor = found.cholesky(None).unwrap();
    assert_eq!((factor.rank(), factor.condition()), (0, 1.0));
    let solved = found.least_squares(1, None).unwrap();
    assert_eq!((solved.coefficients, solved.residual_norm), (vec![0.0], 0.0));
    let mut late = zeros.clone();
    late[4999] = 3.0;
    let found = gram(&layout, &[&late, &zeros], &Options::default()).unwrap();
    assert_eq!(found.matrix().unwrap()[(0, 0)], 9.0);
    let refined = found.least_squares(1, None).unwrap();
    let again = refined.refined(&layout, &[&late, &zeros], &Options::default(), 2).unwrap();
    assert_eq!(again.coefficients, [0.0]);
    late[7] = f64::NAN;
    let bad = refined.refined(&layout, &[&late, &zeros], &Options::default(), 2);
    assert!(message(bad).contains("sample 7 of channel 0 is NaN"));
    let other = refined.refined(
        &Layout::block_hankel(2, 3).unwrap(),
        &[&zeros, &zeros],
        &Options::default(),
        2,
    );
    assert_eq!(message(other), HankelError::DifferentLayouts.to_string());
}

#[test]
fn a_constant_has_no_rank_once_it_is_centred() {
    for value in [0.1, 7.0, 1.0 / 3.0, -1e5] {
        let constant = vec![value; 5000];
        let other: Vec<f64> = (0..5000).map(|k| f64::from(k).sin()).collect();
        let columns = vec![Column::new(0, 0), Column::new(0, -1), Column::new(1, 0)];
        let layout = Layout::new(2, columns).unwrap();
        let found = gram(&layout, &[&constant, &other], &Options::default()).unwrap().centred();
        let solved = found.least_squares(2, None).unwrap();
        assert_eq!(solved.factor.rank(), 0, "{value}");
        assert_eq!(solved.coefficients, [0.0, 0.0], "{value}");
    }
}

#[test]
fn lags_far_apart_are_taken_one_by_one() {
    let signal: Vec<f64> = (0..5000).map(|k| f64::from(k * k % 101) - 50.0).collect();
    let layout = Layout::new(1, [0, 3, 700, 2900].map(|lag| Column::new(0, lag)).to_vec()).unwrap();
    let found = gram(&layout, &[&signal], &Options::default()).unwrap();
    assert!(worst(&found, &products(&layout, &[vec![signal]])) < 1e-30);
}
