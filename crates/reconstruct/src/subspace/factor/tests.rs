use super::*;
use crate::subspace::dense::eigen_of_square;
use crate::subspace::tests::{generator, normal};
use hankel::{Layout, Options, gram};

fn block_hankel(channels: &DMatrix<f64>, block_rows: usize) -> Gram {
    let rows: Vec<Vec<f64>> =
        channels.row_iter().map(|row| row.iter().copied().collect()).collect();
    let rows: Vec<&[f64]> = rows.iter().map(Vec::as_slice).collect();
    let layout = Layout::block_hankel(rows.len(), block_rows).unwrap();
    gram(&layout, &rows, &Options::default()).unwrap()
}

#[test]
fn the_triangle_squared_is_the_covariance() {
    let channels = normal(&mut generator(1), 2, 100);
    let gram = block_hankel(&channels, 5);
    let r = triangle(&gram);
    let expected = gram.matrix().unwrap() / gram.rows() as f64;
    assert!((r.transpose() * &r - &expected).amax() < 1e-15 * 10.0);
}

#[test]
fn noise_of_1e_minus_13_stands_above_rounding() {
    // Two channels that differ by noise of 1e-13: in double, their covariance would be singular.
    let mut rng = generator(2);
    let signal = normal(&mut rng, 1, 500);
    let noise = normal(&mut rng, 1, 500);
    let channels =
        DMatrix::from_fn(2, 500, |i, k| signal[k] + if i == 1 { 1e-13 * noise[k] } else { 0.0 });
    let values = eigen_of_square(&triangle(&block_hankel(&channels, 1))).unwrap().values;
    // Half of the noise is in the difference; the sum of 1 and 1e-13 rounds to one part in a thousand of the latter.
    let expected = 1e-13 * (noise.norm_squared() / 500.0 / 2.0).sqrt();
    assert!(
        (values[0].sqrt() / expected - 1.0).abs() < 0.05,
        "{:e} {expected:e}",
        values[0].sqrt()
    );
}

#[test]
fn rows_that_depend_on_others_leave_none_and_weak_sensors_do_no_harm() {
    // One state seen by three sensors, the first of them a thousandth as strong: each block row holds one new direction.
    let mut rng = generator(3);
    let mut x = 0.0;
    let mut channels = DMatrix::zeros(3, 400);
    for k in 0..400 {
        channels.set_column(k, &nalgebra::dvector![1e-3 * x, x, -2.0 * x]);
        x = 0.99 * x + normal(&mut rng, 1, 1)[0];
    }
    let gram = block_hankel(&channels, 30);
    let r = triangle(&gram);
    let rank = r.row_iter().filter(|row| row.amax() > 0.0).count();
    assert_eq!(rank, 30);
    let expected = gram.matrix().unwrap() / gram.rows() as f64;
    assert!((r.transpose() * &r - &expected).amax() < 1e-14 * expected.amax());
}
