use super::*;

fn z(re: f64, im: f64) -> Complex<f64> {
    Complex::new(re, im)
}

fn difference(
    minuend: (f64, &[Complex<f64>]),
    subtrahend: (f64, &[Complex<f64>]),
) -> FactoredDifference {
    FactoredDifference {
        minuend: Product::new(minuend.0, minuend.1, &[]),
        subtrahend: Product::new(subtrahend.0, subtrahend.1, &[]),
    }
}

#[test]
fn value_and_derivative_hold_at_a_root_too() {
    // 2 (z - 1) (z - 3): value 0 and derivative -4 at 1.
    let product = Product::new(2.0, &[z(1.0, 0.0)], &[z(3.0, 0.0)]);
    assert_eq!(product.at(z(1.0, 0.0)), (z(0.0, 0.0), z(-4.0, 0.0)));
    assert_eq!(product.at(z(0.0, 0.0)), (z(6.0, 0.0), z(-8.0, 0.0)));
}

#[test]
fn rough_starts_are_polished_to_rounding_level() {
    // (z - 1)(z - 1.0001) - 0.75 (z - 1)(z - 1.0003) = 0.25 (z - 1)(z - 0.9995), by hand.
    let planted =
        difference((1.0, &[z(1.0, 0.0), z(1.0001, 0.0)]), (0.75, &[z(1.0, 0.0), z(1.0003, 0.0)]));
    let found = planted.polish(&[z(0.999_49, 0.0), z(1.000_01, 0.0)]);
    assert!((found[0] - 0.9995).norm() < 1e-15, "{}", found[0]);
    assert!((found[1] - 1.0).norm() < 1e-15, "{}", found[1]);
}

#[test]
fn conjugates_stay_conjugates_and_real_zeros_real() {
    // z^3 - (-8): roots -2 and 1 +- j sqrt 3.
    let zero = z(0.0, 0.0);
    let planted = difference((1.0, &[zero, zero, zero]), (-8.0, &[]));
    let found = planted.polish(&[z(-2.01, 0.0), z(1.01, 1.7), z(1.01, -1.7)]);
    assert_eq!(found[0].im.to_bits() << 1, 0);
    assert_eq!(found[1], found[2].conj());
    assert!(
        (found[0] + 2.0).norm() < 1e-14 && (found[1] - z(1.0, 3f64.sqrt())).norm() < 1e-14,
        "{found:?}"
    );
}

#[test]
fn a_double_zero_is_not_torn_apart() {
    let half = z(0.5, 0.0);
    let planted = difference((1.0, &[half, half]), (0.0, &[]));
    assert_eq!(planted.polish(&[half, half]), [half, half]);
}

#[test]
fn condition_is_the_shift_per_relative_change() {
    // z - 2 = 0: changing P = z by a relative 1e-6 moves the zero by 2e-6, and so does changing Q = 2.
    let planted = difference((1.0, &[z(0.0, 0.0)]), (2.0, &[]));
    let zero = planted.judge(z(2.0, 0.0));
    assert!((zero.condition - 4.0).abs() < 1e-15 && zero.residual < 1e-15);
}
