use super::*;
use crate::likelihood::fixtures::Normal;

#[test]
fn the_tangent_is_that_of_differences() {
    const STEP: f64 = 1e-6;
    for hold in [Hold::ZeroOrder, Hold::FirstOrder] {
        let sizes = Sizes { states: 3, sensors: 2, inputs: 2 };
        let form = BlackBox { sizes, hold, feedthrough: vec![1] };
        let mut parameters = Normal::new(4).vector(form.parameters()) * 0.3;
        // Eigenvalues in z far from the negative axis.
        for k in [0, 4, 8] {
            parameters[k] += 0.7;
        }
        let tangent = form.tangent(&parameters).unwrap();
        for k in 0..form.parameters() {
            let at = |step: f64| {
                let mut moved = parameters.clone();
                moved[k] += step;
                DVector::from_vec(form.matrices(&moved).unwrap().entries())
            };
            let difference = (at(STEP) - at(-STEP)) / (2.0 * STEP);
            let off = (difference - tangent.column(k)).amax();
            assert!(off < 1e-7, "{hold:?} {k}: {off}");
        }
        let back = form.of(&form.matrices(&parameters).unwrap());
        assert!((back - parameters).amax() < 1e-15);
    }
}
