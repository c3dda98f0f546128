use super::*;

#[test]
fn a_larger_exponent_scales_what_is_there() {
    let owners = Owners { products: &[(0, 1), (1, 1)], plain: &[0, 1], pairs: &[(0, 1), (1, 1)] };
    let mut sums = Sums::new(2, owners);
    sums.raise(&[Some(3), Some(-2)], owners);
    sums.products = vec![DoubleDouble::sum(1.0, 2.0_f64.powi(-70)); 2];
    sums.plain = vec![DoubleDouble::ONE; 2];
    sums.variances = vec![1.0; 2];
    sums.raise(&[Some(1), Some(2)], owners);
    assert_eq!(sums.exponents, [3, 2]);
    let expected = |power: i32| DoubleDouble::sum(2.0_f64.powi(power), 2.0_f64.powi(power - 70));
    assert_eq!(sums.products, [expected(-4), expected(-8)]);
    assert_eq!(sums.plain[1].value(), 0.0625);
    assert_eq!(sums.variances, [2.0_f64.powi(-8), 2.0_f64.powi(-16)]);
}

#[test]
fn a_channel_of_zeros_has_no_exponent() {
    let owners = Owners { products: &[(0, 0)], plain: &[0], pairs: &[(0, 0)] };
    let mut sums = Sums::new(1, owners);
    sums.raise(&[None], owners);
    assert!(!sums.seen[0]);
    // The first sample that is not zero sets it, however small.
    sums.raise(&[Some(-900)], owners);
    assert_eq!((sums.seen[0], sums.exponents[0]), (true, -900));
}
