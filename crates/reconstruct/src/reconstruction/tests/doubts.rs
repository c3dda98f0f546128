//! What can be wrong with records shows as a doubt, and good records raise none.

use super::flights::{AILERON, BOTH, RUDDER, two};
use super::*;
use crate::likelihood::Doubt as OfFit;
use crate::{Channel, Measurement, Offsets, likelihood::SearchOptions};

fn says(found: &Reconstruction, doubt: impl Fn(&Doubt) -> bool) -> bool {
    found.doubts.iter().any(doubt)
}

#[test]
fn good_records_are_not_doubted() {
    for (pole, ratio) in
        [(0.0, 1000.0), (0.0, 100.0), (0.0, 30.0), (0.0, 10.0), (0.9, 1000.0), (0.9, 100.0)]
    {
        for seed in 0..3 {
            let records = two([AILERON, RUDDER], 2000, pole, ratio, seed);
            let found = reconstruct(&records, &Options::default()).unwrap();
            assert!(found.doubts.is_empty(), "{pole} {ratio} {seed}: {:?}", found.doubts);
        }
    }
}

/// Pole of the excitation's filter and ratio of signal to noise, where one record of two has a second excitation.
const SECOND_EXCITATION: [(f64, f64); 7] = [
    (0.0, 1000.0),
    (0.0, 100.0),
    (0.0, 30.0),
    (0.0, 10.0),
    (0.9, 1000.0),
    (0.9, 100.0),
    (0.9, 30.0),
];

#[test]
fn a_second_excitation_in_a_record_is_doubted() {
    for (pole, ratio) in SECOND_EXCITATION {
        for moves in [[AILERON, BOTH], [BOTH, RUDDER]] {
            let records = two(moves, 1000, pole, ratio, 7);
            let options = Options { order: OrderChoice::Fixed(4), ..Options::default() };
            let found = reconstruct(&records, &options).unwrap();
            // A large part is left over, or far more noise than the signal subspaces show.
            assert!(
                says(&found, |doubt| matches!(
                    doubt,
                    Doubt::Likelihood(OfFit::LargeModelError { .. }) | Doubt::LevelsDisagree { .. }
                )),
                "{pole} {ratio}: {:?}",
                found.doubts
            );
        }
    }
}

#[test]
fn white_noise_alone_names_the_record_with_a_second_excitation() {
    for (pole, ratio) in SECOND_EXCITATION {
        for (moves, name) in [([AILERON, BOTH], "second"), ([BOTH, RUDDER], "first")] {
            let records = two(moves, 1000, pole, ratio, 7);
            let order = OrderChoice::Fixed(4);
            let options = Options { order, noise: NoiseModel::White, ..Options::default() };
            let found = reconstruct(&records, &options).unwrap();
            // Its residuals are not white, whatever else shows; and its rank or its share of the residuals names it.
            let not_white = says(
                &found,
                |doubt| matches!(doubt, Doubt::Likelihood(OfFit::ResidualsNotWhite { record, .. }) if record == name),
            );
            let named = says(&found, |doubt| match doubt {
                Doubt::Likelihood(OfFit::UnequalFit { record, .. })
                | Doubt::Subspace(subspace::Doubt::SeveralExcitations { record, .. }) => {
                    record == name
                }
                _ => false,
            });
            assert!(not_white && named, "{pole} {ratio}: {:?}", found.doubts);
        }
    }
}

#[test]
fn an_offset_is_estimated_unless_it_was_ruled_out() {
    for (size, ratio) in [(0.1, 100.0), (0.3, 100.0), (1.0, 100.0), (1.0, 10.0)] {
        let records: Vec<Record> = two([AILERON, RUDDER], 2000, 0.0, ratio, 31)
            .iter()
            .map(|record| {
                let each = record.channels().iter().map(|channel| {
                    let offset = size * crate::model::record::rms(&channel.values);
                    let values = channel.values.iter().map(|value| value + offset);
                    Channel::new(channel.name.clone(), values.collect())
                });
                Record::new(record.name(), record.period(), each.collect()).unwrap()
            })
            .collect();
        let offset = |doubt: &Doubt| matches!(doubt, Doubt::Likelihood(OfFit::Offset { .. }));
        let order = OrderChoice::Fixed(4);
        let with = |offsets| Options {
            order,
            noise: NoiseModel::White,
            measurement: Measurement { offsets, ..Measurement::default() },
            ..Options::default()
        };
        let found = reconstruct(&records, &with(Offsets::Zero)).unwrap();
        assert!(says(&found, offset), "{size} {ratio}: {:?}", found.doubts);
        for offsets in [Offsets::Free, Offsets::AsNeeded] {
            let found = reconstruct(&records, &with(offsets)).unwrap();
            assert!(!says(&found, offset), "{size} {ratio}: {:?}", found.doubts);
            assert_eq!(found.fit().unwrap().options.measurement.offsets, Offsets::Free);
        }
    }
}

#[test]
fn the_same_excitation_twice_is_doubted() {
    let found =
        reconstruct(&two([RUDDER, RUDDER], 1000, 0.0, 100.0, 3), &Options::default()).unwrap();
    for expected in ["same-excitation", "same-direction"] {
        assert!(says(&found, |doubt| doubt.code() == expected), "{:?}", found.doubts);
    }
}

#[test]
fn short_records_are_doubted() {
    let short = |samples| {
        let records = two([AILERON, RUDDER], samples, 0.0, 1000.0, 4);
        let options = Options { order: OrderChoice::Fixed(4), ..Options::default() };
        let found = reconstruct(&records, &options).unwrap();
        says(&found, |doubt| matches!(doubt, Doubt::Likelihood(OfFit::TooShort { .. })))
    };
    assert!(short(40));
    assert!(!short(120));
}

#[test]
fn orders_that_do_not_fit_are_doubted() {
    let records = two([AILERON, RUDDER], 1000, 0.0, 100.0, 5);
    let doubted = |order| {
        let options = Options { order: OrderChoice::Fixed(order), ..Options::default() };
        reconstruct(&records, &options).unwrap()
    };
    // Too low an order leaves much unexplained, too high a one has no gap behind it.
    let low = doubted(3);
    assert!(
        says(&low, |doubt| matches!(doubt, Doubt::Likelihood(OfFit::LargeModelError { .. }))),
        "{:?}",
        low.doubts
    );
    let high = doubted(6);
    assert!(
        says(&high, |doubt| matches!(doubt, Doubt::Subspace(subspace::Doubt::WeakOrder { .. }))),
        "{:?}",
        high.doubts
    );
}

#[test]
fn a_search_that_was_stopped_is_doubted() {
    let records = two([AILERON, RUDDER], 1000, 0.0, 10.0, 6);
    let stopped = Options {
        search: SearchOptions { max_steps: 1, ..SearchOptions::default() },
        ..Options::default()
    };
    let found = reconstruct(&records, &stopped).unwrap();
    assert!(
        says(&found, |doubt| matches!(doubt, Doubt::Likelihood(OfFit::OptimumNotReached { .. }))),
        "{:?}",
        found.doubts
    );
}

#[test]
fn wrong_noise_levels_are_doubted() {
    let records = two([AILERON, RUDDER], 1000, 0.0, 100.0, 8);
    let found = reconstruct(&records, &Options::default()).unwrap();
    let levels: Vec<f64> = found.noise_levels().unwrap().iter().map(|level| level.value).collect();
    for (factor, doubted) in [(0.8, true), (1.0, false), (1.25, true)] {
        let noise = NoiseModel::Levels(levels.iter().map(|level| level * factor).collect());
        let found = reconstruct(&records, &Options { noise, ..Options::default() }).unwrap();
        let poor = says(&found, |doubt| matches!(doubt, Doubt::Likelihood(OfFit::PoorFit { .. })));
        assert_eq!(poor, doubted, "{factor}: {:?}", found.doubts);
    }
}

#[test]
fn doubts_read_as_sentences() {
    let records = two([AILERON, BOTH], 1000, 0.0, 100.0, 9);
    let found =
        reconstruct(&records, &Options { order: OrderChoice::Fixed(4), ..Options::default() })
            .unwrap();
    let said: Vec<String> = found.doubts.iter().map(ToString::to_string).collect();
    assert!(
        said.iter().any(|text| text.contains("second") && text.contains("excitation")),
        "{said:?}"
    );
}
