//! Records that are not quite linear: the default finds order, modes and the size of what is left.

use super::flights::{AILERON, RUDDER, inputs, levels, noisy, readings};
use super::*;
use crate::likelihood::fixtures::{Normal, with_model_error};
use crate::{Channel, Offsets, Trend};

/// Two flights, each frequency of each sensor off by a random part of what it is, of this size.
fn flown(size: f64, ratio: f64, seed: u64) -> Vec<Record> {
    let mut normal = Normal::new(seed);
    let flights = [AILERON, RUDDER].map(|moves| readings(&inputs(moves, 2000, 0.5, &mut normal)));
    let levels = levels(&flights, ratio);
    let names = ["first", "second"];
    let records = flights.iter().zip(names).map(|(flight, name)| {
        let exact = noisy(name, flight, &[0.0; 3], &mut normal);
        let off = with_model_error(&exact, size, &mut normal);
        with_noise(&off, &levels, &mut normal)
    });
    records.collect()
}

fn with_noise(record: &Record, levels: &[f64], normal: &mut Normal) -> Record {
    let channels = record.channels().iter().zip(levels).map(|(channel, level)| {
        let values = channel.values.iter().map(|value| value + level * normal.next());
        Channel::new(channel.name.clone(), values.collect())
    });
    Record::new(record.name(), record.period(), channels.collect()).unwrap()
}

#[test]
fn a_small_model_error_is_no_reason_to_distrust_the_modes() {
    for (ratio, seed) in [(1e4, 41), (300.0, 42)] {
        let records = flown(0.01, ratio, seed);
        let found = reconstruct(&records, &Options::default()).unwrap();
        assert_eq!(found.order().unwrap().order, 4, "{ratio}");
        assert!(found.doubts.is_empty(), "{ratio}: {:?}", found.doubts);
        let fit = found.fit().unwrap();
        let error = fit.model_error.unwrap().value;
        assert!((1e-3..3e-2).contains(&error), "{ratio}: {error}");
        assert!(fit.options.band.is_some() && fit.options.measurement.offsets == Offsets::Free);
        assert_eq!(fit.options.measurement.trend, Trend::Absent);
        // Roll and Dutch roll; the standard errors know of the model error.
        for (distance, deviations) in &misses(&found)[..2] {
            assert!(*distance < 0.03 && *deviations < 3.0, "{ratio}: {distance} {deviations}");
        }
        // Other orders were fitted, the next lower one far less likely.
        let lower = found.compared_orders().iter().find(|other| other.order == 3).unwrap();
        assert!(lower.above > 1000.0, "{lower:?}");
    }
}

#[test]
fn linear_records_have_no_model_error() {
    for seed in 51..54 {
        let records = flown(0.0, 300.0, seed);
        let found = reconstruct(&records, &Options::default()).unwrap();
        let fit = found.fit().unwrap();
        assert_eq!(fit.model_error, None, "{seed}");
        // The same as with white noise asked for.
        let white = Options { noise: NoiseModel::White, ..Options::default() };
        let white = reconstruct(&records, &white).unwrap();
        assert_eq!(white.fit().unwrap().model, fit.model);
    }
}

#[test]
fn the_result_does_not_depend_on_the_number_of_threads() {
    let records = flown(0.02, 1000.0, 61);
    let with = |threads| {
        let options = Options { threads, profile: true, ..Options::default() };
        reconstruct(&records, &options).unwrap()
    };
    let (one, three) = (with(1), with(3));
    assert!(one.fit().unwrap().model_error.is_some());
    assert_eq!(one.modes, three.modes);
    assert_eq!(one.fit().unwrap().covariance, three.fit().unwrap().covariance);
}
