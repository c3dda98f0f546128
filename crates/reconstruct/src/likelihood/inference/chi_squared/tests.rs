use super::*;

#[test]
fn agrees_with_scipy() {
    // scipy 1.16: scipy.stats.chi2.sf(x, dof)
    for (x, dof, expected) in CASES {
        let found = chi_squared_survival(x, dof);
        assert!((found / expected - 1.0).abs() < 1e-9, "{x}, {dof}: {found} for {expected}");
    }
}

#[test]
fn two_degrees_are_an_exponential() {
    for x in [0.1_f64, 1.0, 5.0, 60.0] {
        let (found, expected) = (chi_squared_survival(x, 2.0), (-0.5 * x).exp());
        assert!((found / expected - 1.0).abs() < 1e-13, "{x}: {found} for {expected}");
    }
}

#[test]
fn ends_are_probabilities() {
    assert!((chi_squared_survival(0.0, 3.0) - 1.0).abs() < f64::EPSILON);
    assert!((chi_squared_survival(f64::INFINITY, 3.0)).abs() < f64::EPSILON);
    assert!((chi_squared_survival(1e6, 3.0)).abs() < f64::EPSILON);
    assert!((chi_squared_survival(1.0, 0.0) - 1.0).abs() < f64::EPSILON);
}

const CASES: [(f64, f64, f64); 11] = [
    (0.5, 1.0, 0.47950012218695337),
    (3.84, 1.0, 0.05004352124870519),
    (7.0, 3.0, 0.07189777249646509),
    (0.2, 5.0, 0.9991138612111875),
    (20.0, 20.0, 0.4579297144718523),
    (45.0, 20.0, 0.0011034692430283482),
    (7986.5, 7976.0, 0.4647889296053704),
    (8300.0, 7976.0, 0.005596397004649802),
    (7700.0, 7976.0, 0.986296986223574),
    (3990000.0, 3999976.0, 0.999792031530574),
    (4010000.0, 3999976.0, 0.00019907325335065152),
];
