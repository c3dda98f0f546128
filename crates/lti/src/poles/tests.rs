//! Tests of `poles.rs`.

use nalgebra::{DMatrix, dmatrix};

use super::*;
use crate::Continuous;

#[test]
fn values_and_conditions_go_together() {
    let a = dmatrix![-1.0, 100.0, 0.0; 0.0, -1.5, 0.0; 0.0, 0.0, 2.0];
    let system = StateSpace::<Continuous>::new(
        a,
        DMatrix::zeros(3, 0),
        DMatrix::zeros(0, 3),
        DMatrix::zeros(0, 0),
    )
    .expect("a system");
    let poles = system.poles_with_condition().expect("poles");
    let values: Vec<f64> = poles.iter().map(|pole| pole.value.re).collect();
    assert_eq!(values, [-1.5, -1.0, 2.0]);
    assert_eq!(
        poles.iter().map(|pole| pole.value).collect::<Vec<_>>(),
        system.poles().expect("poles")
    );
    let coupled = (1.0_f64 + 200.0 * 200.0).sqrt();
    for (pole, wanted) in poles.iter().zip([coupled, coupled, 1.0]) {
        assert!((pole.condition / wanted - 1.0).abs() < 1e-12);
    }
    // No coupling from below: entry by entry only the diagonal counts.
    for (pole, wanted) in poles.iter().zip([1.5 + 200.0, 1.0 + 200.0, 2.0]) {
        assert!(
            pole.entrywise_condition <= wanted * (1.0 + 1e-12)
                && pole.entrywise_condition >= pole.value.re.abs()
        );
    }
}
