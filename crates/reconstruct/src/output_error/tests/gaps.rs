//! Samples that a recorder dropped.

use super::*;

/// The records without one row in fifty, and two neighbours now and then.
fn without_rows(records: &[Record]) -> Vec<Record> {
    let one = |record: &Record| {
        let mut channels = record.channels().to_vec();
        for channel in &mut channels {
            for row in (25..record.samples() - 25).step_by(100) {
                channel.values[row] = f64::NAN;
                channel.values[row + 1] = f64::NAN;
            }
        }
        Record::with_missing(record.name(), record.period(), channels).unwrap()
    };
    records.iter().map(one).collect()
}

/// What is missing is unknown, not what a line through its neighbours says: the modes are those of the complete record, as certain but for the rows that it lost.
#[test]
fn a_record_that_lost_rows_says_what_the_whole_one_does() {
    let (records, inputs) = flights(&[Flown { gust: 0.01, ..BOTH }], 21);
    let fit = |records: &[Record]| identify(records, &inputs, &Options::default()).unwrap();
    let whole = fit(&records);
    let gaps = fit(&without_rows(&records));
    assert_eq!(gaps.doubts, []);
    assert_eq!(whole.modes.len(), gaps.modes.len());
    for (own, other) in whole.modes.iter().zip(&gaps.modes) {
        let (own, other) = (own.continuous, other.continuous);
        let off = own.value - other.value;
        let real = off.re / own.real_standard_error();
        assert!(real.abs() < 2.0, "{}: {real}", own.value);
        if own.value.im > 0.0 {
            let imaginary = off.im / own.imaginary_standard_error();
            assert!(imaginary.abs() < 2.0, "{}: {imaginary}", own.value);
        }
        let ratio = other.real_standard_error() / own.real_standard_error();
        assert!((0.9..1.3).contains(&ratio), "{}: {ratio}", own.value);
    }
    // The report shows the most likely values, not interpolated ones.
    assert!(gaps.records[0].explained.iter().all(|part| *part > 0.5));
}
