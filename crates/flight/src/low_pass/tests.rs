use nalgebra::{DMatrix, dmatrix};

use super::*;

/// Gain of c (jw - A)^-1 b, by real arithmetic on twice the size.
fn gain(system: &StateSpace<Continuous>, frequency_rad_s: f64) -> f64 {
    let n = system.order();
    let mut both = DMatrix::zeros(2 * n, 2 * n);
    both.view_mut((0, 0), (n, n)).copy_from(&-system.a());
    both.view_mut((n, n), (n, n)).copy_from(&-system.a());
    for k in 0..n {
        both[(k, n + k)] = -frequency_rad_s;
        both[(n + k, k)] = frequency_rad_s;
    }
    let mut right = DMatrix::zeros(2 * n, 1);
    right.view_mut((0, 0), (n, 1)).copy_from(system.b());
    let state = both.lu().solve(&right).unwrap();
    let part = |first: usize| (system.c() * state.view((first, 0), (n, 1)))[(0, 0)];
    part(0).hypot(part(n))
}

#[test]
fn the_filter_is_butterworths() {
    // Behind a lag that is so fast that it does nothing.
    let fast =
        StateSpace::<Continuous>::new(dmatrix![-1e6], dmatrix![1e6], dmatrix![1.0], dmatrix![0.0])
            .unwrap();
    let corner = 6.0;
    let filtered = behind_low_pass(&fast, 0, corner).unwrap();
    for ratio in [0.0, 0.5, 1.0, 2.0, 4.0_f64] {
        let expected = 1.0 / (1.0 + ratio.powi(8)).sqrt();
        let found = gain(&filtered, ratio * corner);
        assert!((found - expected).abs() < 1e-4 * expected, "{ratio}: {found} {expected}");
    }
}
