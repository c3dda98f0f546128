use super::*;

#[test]
fn split_halves_multiply_exactly() {
    for x in [1.0 / 3.0, std::f64::consts::PI, 1e150, -7.25e-100] {
        let (high, low) = split(x);
        assert_eq!((high + low).to_bits(), x.to_bits());
        assert_eq!(high.to_bits().trailing_zeros().min(26), 26, "{x}");
    }
}

#[test]
fn multiples_cancel_to_the_last_bit() {
    // 3 * (1/3 rounded) - 1 = -2^-54 exactly; plain arithmetic gives 0.
    let third = [1.0 / 3.0];
    let halves = Halves::new(&third);
    let (mut high, mut low) = (vec![-1.0], vec![0.0]);
    add_multiple(&mut high, &mut low, 3.0, &third, &halves, 0);
    assert_eq!((high[0] + low[0]).to_bits(), (-(2.0_f64.powi(-54))).to_bits());
}

#[test]
fn dot_product_of_condition_1e24() {
    // 1e16 * 1e8 + 1 * 1 - 1e16 * 1e8 + .. : everything but the ones cancels, and every lane gets some of it.
    let mut weights = Vec::new();
    let mut signal = Vec::new();
    for i in 0..101 {
        weights.extend([1e16, 1.0, -1e16]);
        signal.extend([1e8 + f64::from(i), 1.0, 1e8 + f64::from(i)]);
    }
    let mut sums = [Sum::default(); LANES];
    add_dot(&mut sums, &weights, &Halves::new(&weights), &signal, &Halves::new(&signal), 0);
    let total = Sum::merge(&sums);
    assert!((total.value() - 101.0).abs() < 1e-3, "{}", total.value());
}
