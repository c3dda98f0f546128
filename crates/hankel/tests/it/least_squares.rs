//! Solutions against exact ones.

use hankel::{Column, Layout, LeastSquares, Options, gram};
use num_rational::BigRational;
use proptest::prelude::*;

use crate::exact::{products, rational};

/// Gauss elimination in rational numbers: the exact least-squares solution.
fn exact_solution(layout: &Layout, record: &[Vec<f64>], target: usize) -> Vec<BigRational> {
    let gram = products(layout, &[record.to_vec()]);
    let others: Vec<usize> = (0..gram.len()).filter(|i| *i != target).collect();
    let mut system: Vec<Vec<BigRational>> = others
        .iter()
        .map(|i| {
            let mut row: Vec<_> = others.iter().map(|j| gram[*i][*j].clone()).collect();
            row.push(gram[*i][target].clone());
            row
        })
        .collect();
    let size = others.len();
    for k in 0..size {
        let pivot_row = system[k].clone();
        assert_ne!(pivot_row[k], rational(0.0), "the example is not of full rank");
        for (i, row) in system.iter_mut().enumerate() {
            if i != k {
                let factor = &row[k] / &pivot_row[k];
                for (x, p) in row.iter_mut().zip(&pivot_row) {
                    *x -= &factor * p;
                }
            }
        }
    }
    (0..size).map(|k| &system[k][size] / &system[k][k]).collect()
}

fn as_float(x: &BigRational) -> f64 {
    // 60 digits of it are more than enough, and the parser rounds correctly.
    let scale = num_bigint::BigInt::from(10).pow(60);
    let digits = (x * BigRational::from(scale)).to_integer().to_string();
    format!("{digits}e-60").parse().unwrap()
}

fn solve(layout: &Layout, record: &[&[f64]], target: usize) -> LeastSquares {
    gram(layout, record, &Options::default()).unwrap().least_squares(target, None).unwrap()
}

/// A signal of slow sines: its shifted copies are nearly dependent, the more of them the worse.
fn slow(n: i32, amplitudes: &[f64]) -> Vec<f64> {
    let value = |k: i32| {
        let terms = amplitudes.iter().zip(1..);
        terms.map(|(a, i)| a * (0.03 * f64::from(i) * f64::from(k)).sin()).sum::<f64>()
    };
    (0..n).map(value).collect()
}

#[test]
fn ill_conditioned_fits_have_every_digit() {
    let signal = slow(120, &[1.0, -0.7, 0.4, 0.3, 0.2]);
    let mut target: Vec<f64> = slow(120, &[0.2, 0.9, -0.3, 0.1, 0.6]);
    target.iter_mut().enumerate().for_each(|(k, x)| *x += if k % 7 == 3 { 1e-3 } else { 0.0 });
    let mut conditions = Vec::new();
    for copies in [2, 4, 6, 8] {
        let mut columns: Vec<Column> = (0..copies).map(|lag| Column::new(0, lag)).collect();
        columns.push(Column::new(1, 0));
        let layout = Layout::new(2, columns).unwrap();
        let record = [signal.clone(), target.clone()];
        let size = layout.columns().len() - 1;
        let exact = exact_solution(&layout, &record, size);
        let found = solve(&layout, &[&signal, &target], size);
        let norm = exact.iter().map(|x| as_float(x).powi(2)).sum::<f64>().sqrt();
        let error = |coefficients: &[f64]| {
            let each = coefficients.iter().zip(&exact).map(|(b, x)| as_float(&(rational(*b) - x)));
            each.map(|e| e * e).sum::<f64>().sqrt() / norm
        };
        // From the Gram matrix alone: what its rounding and the square of the condition number allow.
        let allowed = 50.0 * found.expected_error + 4e-16;
        assert!(
            error(&found.coefficients) < allowed,
            "{copies}: {:e} {allowed:e}",
            error(&found.coefficients)
        );
        // With the data: to the last bits.
        let refined = found.refined(&layout, &[&signal, &target], &Options::default(), 5).unwrap();
        assert!(refined.refinement.converged, "{copies}: {:?}", refined.refinement);
        assert!(
            error(&refined.coefficients) < 4e-16,
            "{copies}: {:e}",
            error(&refined.coefficients)
        );
        conditions.push(found.factor.condition());
    }
    assert!(conditions[0] < 1e2 && conditions[3] > 1e10, "{conditions:?}");
}

#[test]
fn the_residual_is_known_however_small() {
    // The target is a combination of the columns but for one sample in the last bit but one.
    let signal = slow(300, &[1.0, 0.5]);
    let mut target: Vec<f64> = signal.iter().map(|x| 2.0 * x).collect();
    target[100] += 2.0_f64.powi(-50);
    let layout = Layout::new(2, vec![Column::new(0, 0), Column::new(1, 0)]).unwrap();
    let record = [&signal[..], &target];
    let found = solve(&layout, &record, 1);
    let refined = found.refined(&layout, &record, &Options::default(), 3).unwrap();
    let ratio = refined.residual_norm / 2.0_f64.powi(-50);
    assert!((0.9..=1.0).contains(&ratio), "{ratio}");
}

#[test]
fn dependent_columns_share_the_load() {
    // The same signal in two units: the solution of smallest norm, columns scaled to norm one, takes half from each.
    let signal = slow(50, &[1.0, 2.0]);
    let thousandfold: Vec<f64> = signal.iter().map(|x| 1024.0 * x).collect();
    let target: Vec<f64> = signal.iter().map(|x| 3.0 * x).collect();
    let columns = (0..3).map(|channel| Column::new(channel, 0)).collect();
    let layout = Layout::new(3, columns).unwrap();
    let found = solve(&layout, &[&signal, &thousandfold, &target], 2);
    assert_eq!(found.factor.rank(), 1);
    assert!((found.coefficients[0] - 1.5).abs() < 1e-15);
    assert!((found.coefficients[1] - 1.5 / 1024.0).abs() < 1e-18);
    let null = found.factor.null_directions();
    assert_eq!(null.shape(), (2, 1));
    assert!((null[(0, 0)] + null[(1, 0)]).abs() < 1e-15 && (null.norm() - 1.0).abs() < 1e-15);
}

#[test]
fn the_inverse_is_that_of_the_scaled_matrix() {
    let rough: Vec<f64> = (0..80).map(|k| f64::from(k * k % 23) - 8.0).collect();
    let layout = Layout::block_hankel(1, 5).unwrap();
    let factor = gram(&layout, &[&rough], &Options::default()).unwrap().cholesky(None).unwrap();
    assert_eq!(factor.rank(), 5);
    let triangle = factor.triangle();
    let identity = factor.inverse() * triangle.tr_mul(&triangle);
    let off = (identity - nalgebra::DMatrix::identity(5, 5)).amax();
    assert!(off < 1e-14 * factor.condition().powi(2), "{off:e}");
    // Three sines obey a recurrence of order six: the seventh copy is dependent, and the pseudo-inverse obeys Penrose's conditions.
    let signal: Vec<f64> = (0..80)
        .map(|k| [0.5, 1.2, 2.3].map(|w: f64| (w * f64::from(k) + w).sin()).iter().sum())
        .collect();
    let layout = Layout::block_hankel(1, 7).unwrap();
    let factor =
        gram(&layout, &[&signal], &Options::default()).unwrap().cholesky(Some(1e-9)).unwrap();
    assert_eq!(factor.rank(), 6);
    let (matrix, inverse) = (factor.triangle().tr_mul(&factor.triangle()), factor.inverse());
    let again = &matrix * &inverse * &matrix - &matrix;
    assert!(again.amax() < 1e-12, "{:e}", again.amax());
    assert!((&inverse * factor.null_directions()).amax() < 1e-12 * inverse.amax());
}

proptest! {
    #[test]
    fn units_do_not_matter(power in -480..480_i32, other in -480..480_i32) {
        let (u, y) = (slow(60, &[1.0, 0.2]), slow(60, &[0.3, 1.0, 0.1]));
        let scale = |signal: &[f64], power: i32| -> Vec<f64> {
            signal.iter().map(|x| x * 2.0_f64.powi(power)).collect()
        };
        let columns = vec![Column::new(0, 0), Column::new(0, 1), Column::new(1, 0)];
        let layout = Layout::new(2, columns).unwrap();
        let plain = solve(&layout, &[&u, &y], 2);
        let scaled = solve(&layout, &[&scale(&u, power), &scale(&y, other)], 2);
        for (a, b) in plain.coefficients.iter().zip(&scaled.coefficients) {
            let back = b * 2.0_f64.powi(power / 2) * 2.0_f64.powi(power - power / 2 - other);
            prop_assert!((a - back).abs() <= 1e-15 * a.abs());
        }
        prop_assert_eq!(plain.relative_residual, scaled.relative_residual);
    }
}
