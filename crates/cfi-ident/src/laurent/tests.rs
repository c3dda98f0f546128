use super::*;
use crate::Orders;

fn c(re: f64, im: f64) -> Complex<f64> {
    Complex::new(re, im)
}

/// Zeros and poles with every complex one's conjugate added.
fn with_conjugates(zeros: &[Complex<f64>], poles: &[Complex<f64>], gain: f64) -> ZerosAndPoles {
    let close = |roots: &[Complex<f64>]| -> Vec<Complex<f64>> {
        roots.iter().flat_map(|z| if z.im == 0.0 { vec![*z] } else { vec![*z, z.conj()] }).collect()
    };
    ZerosAndPoles::new(&close(zeros), &close(poles), gain).unwrap()
}

#[test]
fn coefficients_are_the_contour_integral_on_the_unit_circle() {
    let check = |t: &ZerosAndPoles| {
        const POINTS: u32 = 4096;
        let h = t.laurent(12, 9).unwrap();
        for (h, i) in h.iter().zip(-9..) {
            let integral: Complex<f64> = (0..POINTS)
                .map(|k| {
                    Complex::from_polar(
                        1.0,
                        std::f64::consts::TAU * f64::from(k) / f64::from(POINTS),
                    )
                })
                .map(|z| t.response(z) * z.powi(i))
                .sum::<Complex<f64>>()
                / f64::from(POINTS);
            assert!((integral - h).norm() < 1e-12, "h_{i} = {h}, integral {integral} of {t:?}");
        }
    };
    check(&with_conjugates(&[c(0.3, 0.4)], &[c(0.5, 0.6), c(1.2, 0.9)], 2.0));
    check(&with_conjugates(&[c(0.3, 0.4), c(-2.0, 0.0), c(0.1, 0.0)], &[c(0.9, 0.0)], -1.5));
    check(&with_conjugates(&[], &[c(-1.1, 0.0), c(0.0, 0.0)], 1.0));
    check(&with_conjugates(&[c(0.2, 0.0)], &[c(0.7, 0.1), c(0.7, 0.1), c(1.3, 0.0)], 1.0));
    check(&with_conjugates(&[c(0.2, 0.0)], &[], 3.0));
    check(&with_conjugates(&[], &[], 3.0));
}

#[test]
fn split_takes_the_largest_poles_and_keeps_pairs_together() {
    let t = with_conjugates(&[], &[c(0.5, 0.0), c(0.6, 0.8), c(-1.5, 0.0)], 1.0);
    let split = t.split(3).unwrap();
    // (q + 1.5)(q^2 - 1.2 q + 1)
    let expected = [1.5, -0.8, 0.3, 1.0];
    assert!(
        split.denominator.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15),
        "{:?}",
        split.denominator
    );
    assert_eq!(split.remaining.poles(), [c(0.5, 0.0)]);
    assert_eq!(
        t.split(2).unwrap_err(),
        FitError::Unpaired { what: "the pole", value: c(0.6, 0.8) }
    );
    assert_eq!(t.split(5).unwrap_err(), FitError::TooFewPoles { found: 4, needed: 5 });
}

#[test]
fn a_model_with_room_for_everything_has_the_same_response() {
    let t = with_conjugates(
        &[c(1.1, 0.2), c(0.4, 0.0)],
        &[c(0.2, 0.0), c(1.05, 0.3), c(-0.1, 0.1)],
        0.7,
    );
    for (l, constant_term) in [(2, ConstantTerm::Included), (3, ConstantTerm::Omitted)] {
        let model = t.cfi(Structure::new(Orders::new(l, 40, 3).unwrap(), constant_term)).unwrap();
        for angle in [0.0, 0.7, 2.0, 3.0] {
            let z = Complex::from_polar(1.0, angle);
            assert!((model.response(z) - t.response(z)).norm() < 1e-14, "{l} {angle}");
        }
    }
}

#[test]
fn what_has_no_expansion_is_refused() {
    let on_circle = with_conjugates(&[], &[c(0.6, 0.8)], 1.0);
    assert!(matches!(on_circle.laurent(3, 3), Err(FitError::BadValue { .. })));
    assert!(matches!(ZerosAndPoles::new(&[], &[c(0.5, 0.1)], 1.0), Err(FitError::Unpaired { .. })));
    assert!(matches!(
        ZerosAndPoles::new(&[c(0.5, -0.1)], &[], 1.0),
        Err(FitError::Unpaired { .. })
    ));
    assert!(matches!(ZerosAndPoles::new(&[], &[], f64::NAN), Err(FitError::BadValue { .. })));
}
