use super::*;
use crate::likelihood::fixtures::{Normal, system};

#[test]
fn deviations_are_those_of_perturbed_matrices() {
    // A moves along one random direction with unit variance: deviations are the sizes of the derivatives, taken by differences.
    const STEP: f64 = 1e-6;
    let mut normal = Normal::new(1);
    let a = system(&[Complex::new(0.9, 0.3), Complex::new(0.7, 0.0)], 1, 1, &mut normal).a;
    let direction = normal.matrix(3, 3);
    let vector = DVector::from_column_slice(direction.as_slice());
    let covariance = &vector * vector.transpose();
    let period = SamplePeriod::new(0.1).unwrap();
    let here = modes(&a, period, &covariance, ModelBias::default()).unwrap();
    let still = DMatrix::zeros(9, 9);
    let there =
        |step: f64| modes(&(&a + &direction * step), period, &still, ModelBias::default()).unwrap();
    let (up, down) = (there(STEP), there(-STEP));
    for ((mode, up), down) in here.iter().zip(&up).zip(&down) {
        let check = |deviation: f64, up: f64, down: f64| {
            let slope = ((up - down) / (2.0 * STEP)).abs();
            assert!((deviation - slope).abs() < 1e-6 * (1.0 + slope), "{deviation} for {slope}");
        };
        check(mode.discrete.real_standard_error(), up.discrete.value.re, down.discrete.value.re);
        check(
            mode.discrete.imaginary_standard_error(),
            up.discrete.value.im,
            down.discrete.value.im,
        );
        check(
            mode.continuous.real_standard_error(),
            up.continuous.value.re,
            down.continuous.value.re,
        );
        check(
            mode.continuous.imaginary_standard_error(),
            up.continuous.value.im,
            down.continuous.value.im,
        );
        let (x, y, z) = (mode, up, down);
        let parts =
            |mode: &Mode| [mode.natural_frequency_rad_s, mode.damping_ratio, mode.time_constant_s];
        for ((x, y), z) in parts(x).into_iter().zip(parts(y)).zip(parts(z)) {
            check(x.standard_error, y.value, z.value);
        }
    }
}

#[test]
fn an_ellipse_by_hand() {
    // Variances 4 and 1 along axes turned by 30 degrees.
    let turn = nalgebra::Rotation2::new(std::f64::consts::FRAC_PI_6);
    let covariance = turn.matrix() * Matrix2::new(4.0, 0.0, 0.0, 1.0) * turn.matrix().transpose();
    let estimate = ComplexEstimate { value: Complex::new(0.0, 0.0), covariance };
    let ellipse = estimate.ellipse_95();
    // sqrt(-2 ln 0.05) = 2.4477
    assert!((ellipse.major - 2.0 * 2.447_746_830_680_816).abs() < 1e-12);
    assert!((ellipse.minor - 2.447_746_830_680_816).abs() < 1e-12);
    assert!((ellipse.angle_rad - std::f64::consts::FRAC_PI_6).abs() < 1e-12);
}

#[test]
fn a_time_constant_has_an_interval_unless_it_may_be_infinite() {
    let period = SamplePeriod::new(1.0).unwrap();
    let a = DMatrix::from_element(1, 1, (-0.5_f64).exp());
    let with = |deviation: f64| {
        let variance = (deviation * a[(0, 0)]).powi(2);
        modes(&a, period, &DMatrix::from_element(1, 1, variance), ModelBias::default())
            .unwrap()
            .remove(0)
    };
    let [low, high] = with(0.1).time_constant_interval_95.unwrap();
    assert!((low - 1.0 / (0.5 + 0.195_996_398_454_005_4)).abs() < 1e-12);
    assert!((high - 1.0 / (0.5 - 0.195_996_398_454_005_4)).abs() < 1e-12);
    assert_eq!(with(0.3).time_constant_interval_95, None);
    let [low, high] = with(0.1).time_constant_s.interval_95();
    assert!(low < 2.0 && high > 2.0);
}

#[test]
fn what_is_defective_has_no_deviation() {
    let a = DMatrix::from_row_slice(2, 2, &[0.5, 1.0, 0.0, 0.5]);
    let found =
        modes(&a, SamplePeriod::new(1.0).unwrap(), &DMatrix::identity(4, 4), ModelBias::default())
            .unwrap();
    // Either exactly defective, or two eigenvalues that hardly are two.
    assert!(found.iter().all(|mode| mode.continuous.real_standard_error() > 1e5));
}
