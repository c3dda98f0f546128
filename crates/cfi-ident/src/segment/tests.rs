use super::*;

#[test]
fn the_first_sample_that_is_not_finite_is_named() {
    for bad in [f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in [0, 1, 1023, 1024, 2500] {
            let mut values = vec![-f64::MAX; 2501];
            values[0] = f64::MIN_POSITIVE / 4.0;
            assert_eq!(check_finite(&values, Signal::Input), Ok(()));
            values[place] = bad;
            values[2500] = bad;
            match check_finite(&values, Signal::Output) {
                Err(FitError::NotFinite { signal: Signal::Output, index, .. }) => {
                    assert_eq!(index, place);
                }
                other => panic!("{other:?}"),
            }
        }
    }
}
