use super::*;

const GAP: f64 = f64::NAN;

#[test]
fn a_gap_in_either_signal_splits_both() {
    let check = |input: &[f64], output: &[f64], expected: &[Range<usize>]| {
        assert_eq!(runs(input, output).unwrap(), expected);
    };
    check(&[1.0, 2.0, 3.0], &[1.0, 2.0, 3.0], std::slice::from_ref(&(0..3)));
    check(&[1.0, GAP, 3.0, 4.0, 5.0], &[1.0, 2.0, 3.0, GAP, 5.0], &[0..1, 2..3, 4..5]);
    check(&[GAP, 2.0, 3.0, GAP], &[1.0, 2.0, 3.0, 4.0], std::slice::from_ref(&(1..3)));
    check(&[1.0, GAP, GAP, 4.0], &[1.0, GAP, 3.0, 4.0], &[0..1, 3..4]);
    check(&[GAP, GAP], &[1.0, GAP], &[]);
    check(&[], &[], &[]);
}

#[test]
fn an_infinite_sample_has_a_place() {
    let infinite = f64::NEG_INFINITY;
    let found = runs(&[1.0, GAP, 3.0], &[1.0, infinite, 3.0]).unwrap_err();
    assert_eq!(found, Infinite { index: 1, side: Side::Output, value: infinite });
    let found = runs(&[1.0, 2.0, f64::INFINITY], &[1.0, 1.0, infinite]).unwrap_err();
    assert_eq!((found.index, found.side), (2, Side::Input));
}
