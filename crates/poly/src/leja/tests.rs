//! Tests of Leja's order.

use super::leja_order;
use crate::{Complex, Poly};

#[test]
fn greedy_choice() {
    let real = |list: &[f64]| list.iter().map(|&x| Complex::new(x, 0.0)).collect::<Vec<_>>();
    // 4 first, then the farthest 1, then 2.2 with 1.8 * 1.2 before 3 with 1 * 2.
    assert_eq!(leja_order(&real(&[1.0, 2.2, 3.0, 4.0])), [3, 0, 1, 2]);
    // A copy comes after everything else.
    assert_eq!(leja_order(&real(&[4.0, 4.0, 1.0])), [0, 2, 1]);
    assert_eq!(leja_order(&[]), [0_usize; 0]);
}

/// Two hundred roots on a circle, given in order around it: the product is x^200 - 1 to rounding.
#[test]
fn many_roots_on_a_circle() {
    let mut roots = vec![Complex::new(1.0, 0.0), Complex::new(-1.0, 0.0)];
    for k in 1..100 {
        let z = Complex::from_polar(1.0, std::f64::consts::PI * f64::from(k) / 100.0);
        roots.extend([z, z.conj()]);
    }
    let p = Poly::real_from_roots(&roots).unwrap();
    for (k, c) in p.coefficients().iter().enumerate() {
        let expected = match k {
            0 => -1.0,
            200 => 1.0,
            _ => 0.0,
        };
        assert!((c - expected).abs() < 1e-14, "{k}: {c:e}");
    }
}
