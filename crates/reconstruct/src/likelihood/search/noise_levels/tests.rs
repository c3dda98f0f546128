use crate::likelihood::fixtures::{Normal, fly, system};
use crate::likelihood::{Options, identify};
use num_complex::Complex;

#[test]
fn noise_free_records_send_the_levels_down_without_breaking() {
    let mut normal = Normal::new(2);
    let model = system(&[Complex::new(0.5, 0.3)], 3, 2, &mut normal);
    let flights = fly(&model, &[80, 80], &crate::likelihood::fixtures::QUIET, &mut normal);
    let fit =
        identify(&flights.records, std::slice::from_ref(&model), &Options::default()).unwrap();
    for level in fit.noise_levels.unwrap() {
        assert!(level.value.is_finite() && level.value < 1e-9, "{}", level.value);
    }
    assert!((fit.modes[0].discrete.value - Complex::new(0.5, 0.3)).norm() < 1e-9);
}
