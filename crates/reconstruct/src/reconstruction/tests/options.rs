//! Options reach the stage that they are for.

use super::flights::{AILERON, RUDDER, inputs, levels, noisy, readings, two};
use super::*;
use crate::likelihood::fixtures::Normal;
use crate::likelihood::{FrequencyBand, Hold};
use crate::{Measurement, Offsets, Trend};

#[test]
fn offsets_and_trends_are_taken_out() {
    let clean = two([AILERON, RUDDER], 2000, 0.0, 100.0, 21);
    let shifted: Vec<Record> = clean
        .iter()
        .map(|record| {
            let each = record.channels().iter().enumerate().map(|(i, channel)| {
                let size = crate::model::record::rms(&channel.values);
                let drift = |k: usize| size * (0.5 + i as f64 + k as f64 / 1000.0);
                let values = channel.values.iter().enumerate().map(|(k, value)| value + drift(k));
                Channel::new(channel.name.clone(), values.collect())
            });
            Record::new(record.name(), record.period(), each.collect()).unwrap()
        })
        .collect();
    let order = OrderChoice::Fixed(4);
    let options = Options {
        order,
        measurement: Measurement {
            offsets: Offsets::Free,
            trend: Trend::Linear,
            ..Measurement::default()
        },
        ..Options::default()
    };
    let found = reconstruct(&shifted, &options).unwrap();
    // The roll and the Dutch roll; a drift hides the spiral.
    for (distance, deviations) in &misses(&found)[..2] {
        assert!(*distance < 0.05 && *deviations < 4.0, "{distance} {deviations}");
    }
    // By default they are found.
    let as_needed = reconstruct(&shifted, &Options { order, ..Options::default() }).unwrap();
    let used = &as_needed.fit().unwrap().options.measurement;
    assert_eq!((&used.offsets, used.trend), (&Offsets::Free, Trend::Linear));
    for (distance, deviations) in &misses(&as_needed)[..2] {
        assert!(*distance < 0.05 && *deviations < 4.0, "{distance} {deviations}");
    }
    let none = Options {
        order,
        measurement: Measurement {
            offsets: Offsets::Zero,
            trend: Trend::Absent,
            ..Measurement::default()
        },
        ..Options::default()
    };
    let ignored = reconstruct(&shifted, &none).unwrap();
    assert!(misses(&ignored)[0].0 > 0.05, "{:?}", misses(&ignored));
}

#[test]
fn a_known_input_is_no_second_excitation() {
    let mut normal = Normal::new(22);
    // As strong as the excitation that nobody measured.
    let moved = [[1.0, 1.0, 0.0], RUDDER].map(|moves| inputs(moves, 2000, 0.0, &mut normal));
    let flights = moved.clone().map(|inputs| readings(&inputs));
    let levels = levels(&flights, 100.0);
    let records: Vec<_> = flights
        .iter()
        .zip(["first", "second"])
        .map(|(flight, name)| noisy(name, flight, &levels, &mut normal))
        .collect();
    let options = Options { order: OrderChoice::Fixed(4), ..Options::default() };
    let unknown = reconstruct(&records, &options).unwrap();
    assert!(!unknown.doubts.is_empty());
    let rudder: Vec<f64> = moved[0].row(1).iter().copied().collect();
    let mut options = Options {
        measurement: Measurement {
            known_inputs: vec![vec![rudder], Vec::new()],
            ..options.measurement.clone()
        },
        ..options
    };
    let known = reconstruct(&records, &options).unwrap();
    for (distance, deviations) in misses(&known) {
        assert!(distance < 0.02 && deviations < 4.0, "{distance} {deviations}");
    }
    assert!(known.doubts.is_empty(), "{:?}", known.doubts);
    options.method = Method::Subspace;
    let known = reconstruct(&records, &options).unwrap();
    assert!(known.doubts.is_empty(), "{:?}", known.doubts);
    assert!(known.excitations().iter().all(|excitation| excitation.rank == 1));
    assert!(misses(&known).iter().all(|(distance, _)| *distance < 0.03), "{:?}", misses(&known));
}

#[test]
fn a_quiet_record_serves_both_stages() {
    let mut normal = Normal::new(23);
    let gust = [0.0, 0.0, 1.0];
    let flights = [AILERON, RUDDER].map(|moves| readings(&inputs(moves, 1800, 0.5, &mut normal)));
    let gusts = [(); 3].map(|()| readings(&inputs(gust, 1800, 0.8, &mut normal)));
    let factor = 0.3 * flights[1].norm() / gusts[1].norm();
    let levels = levels(&flights, 300.0);
    let records: Vec<_> = ["first", "second"]
        .iter()
        .enumerate()
        .map(|(j, name)| noisy(name, &(&flights[j] + &gusts[j] * factor), &levels, &mut normal))
        .collect();
    let quiet = noisy("quiet", &(&gusts[2] * factor), &levels, &mut normal);
    let order = OrderChoice::Fixed(4);
    let plain = reconstruct(&records, &Options { order, ..Options::default() }).unwrap();
    let noise = NoiseModel::Quiet(quiet);
    let found = reconstruct(&records, &Options { order, noise, ..Options::default() }).unwrap();
    let fit = found.fit().unwrap().chi_squared;
    assert!(!plain.doubts.is_empty());
    assert!(found.noise_levels().is_none() && fit.p_value.is_some());
    assert!((fit.per_degree_of_freedom() - 1.0).abs() < 0.3, "{fit:?}");
    assert!(misses(&found)[1].0 < 0.05 * 1.69, "{:?}", misses(&found));
}

#[test]
fn band_and_feedthrough_reach_the_likelihood() {
    let records = two([AILERON, RUDDER], 1000, 0.0, 100.0, 24);
    let all = reconstruct(&records, &Options::default()).unwrap();
    let band = Some(FrequencyBand { lowest_rad_s: 0.0, highest_rad_s: 15.0 });
    let part = reconstruct(&records, &Options { band, ..Options::default() }).unwrap();
    let freedom = |found: &Reconstruction| found.fit().unwrap().chi_squared.degrees_of_freedom;
    assert!(freedom(&part) < 0.5 * freedom(&all));
    let feedthrough_sensors = vec![1];
    let direct = reconstruct(
        &records,
        &Options {
            measurement: Measurement { feedthrough_sensors, ..Measurement::default() },
            ..Options::default()
        },
    )
    .unwrap();
    let fit = direct.fit().unwrap();
    assert_eq!(fit.identifiable, all.fit().unwrap().identifiable + 2);
    assert!(direct.model().unwrap().feedthrough.is_some());
}

#[test]
fn intervals_of_real_modes_come_where_they_are_asked_for() {
    let records = two([AILERON, RUDDER], 1000, 0.0, 30.0, 23);
    let order = OrderChoice::Fixed(4);
    let plain = reconstruct(&records, &Options { order, ..Options::default() }).unwrap();
    assert!(plain.modes.iter().all(|found| found.interval_95.is_none()));
    let found =
        reconstruct(&records, &Options { order, profile: true, ..Options::default() }).unwrap();
    for mode in &found.modes {
        let s = mode.mode.eigenvalue;
        assert_eq!(mode.interval_95.is_some(), s.im == 0.0);
        if let Some([low, high]) = mode.interval_95 {
            assert!(low < s.re && s.re < high);
        }
    }
}

#[test]
fn the_hold_reaches_the_likelihood() {
    let records = two([AILERON, RUDDER], 1000, 0.0, 100.0, 24);
    let order = OrderChoice::Fixed(4);
    for hold in [Hold::ZeroOrder, Hold::FirstOrder] {
        let options = Options { order, hold: Some(hold), ..Options::default() };
        assert_eq!(reconstruct(&records, &options).unwrap().fit().unwrap().hold, hold);
    }
    let free = reconstruct(&records, &Options { order, ..Options::default() }).unwrap();
    assert_eq!(free.fit().unwrap().hold, Hold::ZeroOrder);
}
