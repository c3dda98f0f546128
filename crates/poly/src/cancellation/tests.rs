//! Tests of cancellation with planted common roots.
#![expect(clippy::float_cmp, reason = "exact values are promised where they are compared")]

use super::*;

fn c(re: f64, im: f64) -> Complex<f64> {
    Complex::new(re, im)
}

fn real(list: &[f64]) -> Vec<Complex<f64>> {
    list.iter().map(|&re| c(re, 0.0)).collect()
}

#[test]
fn closest_pairs_go_first() {
    // The pole 1 lies between the zeros 1 - 3e-7 and 1 + 1e-7: the nearer one cancels, the other is left.
    let (zeros, poles) = (real(&[1.0 - 3e-7, 1.0 + 1e-7]), real(&[1.0, 5.0]));
    let found = cancelled(&zeros, &poles, 2.0, &Cancellation::default()).unwrap();
    assert_eq!(found.pairs.len(), 1);
    assert_eq!(found.pairs[0].zero, c(1.0 + 1e-7, 0.0));
    assert_eq!((found.zeros, found.poles, found.gain), (real(&[1.0 - 3e-7]), real(&[5.0]), 2.0));
    let left = found.closest_left.unwrap();
    assert_eq!(left.distance, 5.0 - (1.0 - 3e-7));
    assert_eq!(found.rational.denominator().descending(), [1.0, -5.0]);
}

#[test]
fn conjugates_go_together() {
    let z = c(0.97, 0.17);
    let near = z + c(3e-8, -4e-8);
    let (zeros, poles) = ([c(0.2, 0.0), z, z.conj()], [near, near.conj()]);
    let found = cancelled(&zeros, &poles, 1.0, &Cancellation::within(1e-7)).unwrap();
    assert_eq!(found.pairs.len(), 2);
    assert!((found.pairs[0].distance - 5e-8).abs() < 1e-15);
    assert_eq!(found.pairs[0].zero, found.pairs[1].zero.conj());
    assert!(found.poles.is_empty() && found.closest_left.is_none());
    assert_eq!(found.rational.denominator(), &Poly::one());
    // A real zero never takes half of a pair away.
    let pair = [c(1.0, 1e-7), c(1.0, -1e-7)];
    let found = cancelled(&real(&[1.0]), &pair, 1.0, &Cancellation::default()).unwrap();
    assert!(found.pairs.is_empty());
}

#[test]
fn distances_decide() {
    let pairs = |zeros: &[f64], poles: &[f64], options: &Cancellation| {
        cancelled(&real(zeros), &real(poles), 1.0, options).map(|found| found.pairs.len())
    };
    assert_eq!(pairs(&[100.0], &[100.001], &Cancellation::default()), Ok(0));
    let relative = Cancellation { relative: 1e-4, ..Cancellation::within(0.0) };
    assert_eq!(pairs(&[100.0], &[100.001], &relative), Ok(1));
    // Exactly at the distance counts; nothing but exact agreement at zero.
    let check = |distance| pairs(&[0.5, 2.0], &[0.75, 2.0], &Cancellation::within(distance));
    assert_eq!(check(0.25), Ok(2));
    assert_eq!(check(0.0), Ok(1));
    assert!(matches!(check(-1.0), Err(PolyError::InvalidTolerance { name: "absolute", .. })));
    assert!(check(f64::NAN).is_err());
}

#[test]
fn what_leaves_the_range_of_floats_is_refused() {
    let options = Cancellation::default();
    let infinite = cancelled(&[], &[], f64::INFINITY, &options);
    assert!(matches!(infinite, Err(PolyError::NonFiniteValue { what: "gain", .. })));
    let huge = cancelled(&real(&[1e200, 1e200]), &[], 1.0, &options);
    assert_eq!(huge, Err(PolyError::Overflow { degree: 0 }));
    let large = cancelled(&real(&[1e200]), &[], 1e200, &options);
    assert_eq!(large, Err(PolyError::Overflow { degree: 0 }));
}

#[test]
fn rational_functions() {
    // A triple common root and what is left of it: (x-1)^3 (x+2) / ((x-1)^2 (x+3)).
    let numerator = Poly::from_roots(&[1.0, 1.0, 1.0, -2.0]).scale(&4.0);
    let r = Rational::new(numerator, Poly::from_roots(&[1.0, 1.0, -3.0]).scale(&2.0)).unwrap();
    let cancelled = r.cancel(&Cancellation::default()).unwrap();
    assert_eq!(cancelled.pairs.len(), 2);
    assert_eq!(cancelled.gain, 2.0);
    for (found, expected) in
        cancelled.rational.numerator().descending().iter().zip([2.0, 2.0, -4.0])
    {
        assert!((found - expected).abs() < 1e-14);
    }
    // Nothing cancels: the function comes back as it was.
    let r = Rational::new(Poly::new(vec![0.1, 0.7]), Poly::new(vec![0.3, 0.9])).unwrap();
    let cancelled = r.cancel(&Cancellation::default()).unwrap();
    assert_eq!(cancelled.rational, r);
    assert!((cancelled.closest_left.unwrap().distance - (1.0 / 3.0 - 1.0 / 7.0)).abs() < 1e-15);
    // Zero over anything.
    let zero = Rational::new(Poly::zero(), Poly::new(vec![1.0, 1.0])).unwrap();
    let cancelled = zero.cancel(&Cancellation::default()).unwrap();
    assert_eq!((cancelled.gain, cancelled.poles.len()), (0.0, 1));
    assert!(cancelled.rational.is_zero());
}
