use super::*;
use crate::{ConstantTerm, Orders};

fn structure(l: usize, r: usize, d: usize) -> Structure {
    Structure::new(Orders::new(l, r, d).unwrap(), ConstantTerm::Omitted)
}

#[test]
fn columns_of_a_small_model_by_hand() {
    // l = 3, r = 1, d = 2: y_o(k+3) = -c_1 y_o(k+1) - c_2 y_o(k+2) + h_-2 y_i(k+2) + .. + h_1 y_i(k-1).
    let found: Vec<(Channel, isize, f64)> =
        columns(&structure(3, 1, 2)).iter().map(|c| (c.channel, c.lag, c.sign)).collect();
    let (i, o) = (Channel::Input, Channel::Output);
    let expected = [
        (o, 1, -1.0),
        (o, 2, -1.0),
        (i, 2, 1.0),
        (i, 1, 1.0),
        (i, 0, 1.0),
        (i, -1, 1.0),
        (o, 3, 1.0),
    ];
    assert_eq!(found, expected);
}

#[test]
fn scaling_by_powers_of_two_is_exact_at_every_magnitude() {
    for value in [1.0, 1.9, 3e-5, 1e150, 1e-150, 1e300, 1e-300, f64::MAX, f64::MIN_POSITIVE] {
        let e = exponent(value);
        let scaled = scale(value, -e);
        assert!((1.0..2.0).contains(&scaled), "{value} became {scaled}");
        assert_eq!(scale(scaled, e).to_bits(), value.to_bits());
    }
    assert_eq!(exponent(0.0), 0);
    assert!(scale(1e-310, -exponent(1e-310)) < 1.0);
}

#[test]
fn what_cannot_be_fitted_is_refused_with_numbers() {
    let orders = structure(4, 25, 25);
    let ramp: Vec<f64> = (0..103).map(f64::from).collect();
    assert_eq!(check(&[], &orders, 54).unwrap_err(), FitError::NoSegment);
    let short = Segment::new(&ramp, &ramp).unwrap();
    match check(&[short], &orders, 54).unwrap_err() {
        FitError::TooFewSamples {
            samples: 103,
            equations: 53,
            parameters: 54,
            needed: 104,
            ..
        } => {}
        other => panic!("{other:?}"),
    }
    let flat = vec![2.5; 200];
    let output: Vec<f64> = (0..200).map(f64::from).collect();
    let constant = Segment::new(&flat, &output).unwrap();
    assert_eq!(
        check(&[constant, constant], &orders, 54).unwrap_err(),
        FitError::ConstantInput { value: 2.5 }
    );
}

#[test]
fn segments_too_short_for_an_equation_are_counted() {
    let ramp: Vec<f64> = (0..40).map(|i| f64::from(i * i % 7)).collect();
    let long = Segment::new(&ramp, &ramp).unwrap();
    let short = Segment::new(&ramp[..5], &ramp[..5]).unwrap();
    let counts = check(&[short, long, short], &structure(3, 2, 4), 9).unwrap();
    assert_eq!(
        (counts.segments_without_equation, counts.samples_used, counts.equations),
        (2, 40, 34)
    );
}
