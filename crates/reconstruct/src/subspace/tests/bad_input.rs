//! Records and options that cannot work are refused, with the numbers that say why.

use super::*;

/// Two states seen by `sensors` sensors, excited in the direction (1, j).
fn records(count: usize, sensors: usize, samples: usize) -> Vec<Record> {
    let mut rng = generator(5);
    let c = normal(&mut rng, sensors, 2);
    (0..count)
        .map(|j| {
            let mut x = DVector::from_element(2, 1.0);
            let mut y = DMatrix::zeros(sensors, samples);
            for k in 0..samples {
                y.set_column(k, &(&c * &x + 1e-3 * normal(&mut rng, sensors, 1)));
                let u: f64 = StandardNormal.sample(&mut rng);
                x = DVector::from_row_slice(&[0.9 * x[0] + u, 0.5 * x[1] + j as f64 * u]);
            }
            from_rows(&format!("record {j}"), &y)
        })
        .collect()
}

fn changed(record: &Record, sensor: usize, change: impl Fn(usize, f64) -> f64) -> Record {
    let channels = record.channels().iter().enumerate().map(|(i, channel)| {
        let values = channel.values.iter().enumerate();
        let values = values.map(|(k, value)| if i == sensor { change(k, *value) } else { *value });
        Channel::new(channel.name.clone(), values.collect())
    });
    Record::new(record.name(), record.period(), channels.collect()).unwrap()
}

#[track_caller]
fn check(records: &[Record], options: &Options, message: &str) {
    let error = identify(records, options).unwrap_err();
    assert_eq!(error.to_string(), message);
}

#[test]
fn too_few_records_or_sensors() {
    let options = Options::default();
    check(
        &[],
        &options,
        "0 record(s) of 0 sensor(s): J (m - 1) = 0 must exceed m = 0, which no number of records of one sensor does: \
         two sensors and three records, or three sensors and two records are needed",
    );
    check(
        &records(1, 3, 300),
        &options,
        "1 record(s) of 3 sensor(s): J (m - 1) = 2 must exceed m = 3, which takes 2 records of these sensors",
    );
    check(
        &records(2, 2, 300),
        &options,
        "2 record(s) of 2 sensor(s): J (m - 1) = 2 must exceed m = 2, which takes 3 records of these sensors",
    );
    let error = identify(&records(5, 1, 300), &options).unwrap_err();
    assert_eq!(error, ReconstructError::NotIdentifiable { records: 5, sensors: 1 });
    assert!(identify(&records(3, 2, 300), &options).is_ok());
}

#[test]
fn too_short_for_the_block_rows_or_the_order() {
    let mut options = fixed(2);
    options.block_rows = Some(20);
    let mut data = records(2, 3, 300);
    data[1] = records(2, 3, 79).remove(1);
    check(
        &data,
        &options,
        "record \"record 1\" has 79 samples, but 20 block rows of 3 sensors need 80",
    );
    data[1] = records(2, 3, 80).remove(1);
    assert!(identify(&data, &options).is_ok());

    options.block_rows = Some(4);
    options.order = OrderChoice::Fixed(6);
    check(
        &data,
        &options,
        "6 states from 2 record(s) of 3 sensors need 7 block rows (L >= (J - 1) n / (J (m - 1) - m) and L > n), not 4",
    );
    let mut two_sensors = records(3, 2, 300);
    check(
        &two_sensors,
        &options,
        "6 states from 3 record(s) of 2 sensors need 12 block rows (L >= (J - 1) n / (J (m - 1) - m) and L > n), not 4",
    );
    two_sensors.truncate(3);
    check(
        &data,
        &fixed(30),
        "an order of 30 needs 124 samples with 3 sensors, but record \"record 1\" has 80: it can tell 19 state(s)",
    );
    check(
        &records(2, 3, 6),
        &Options::default(),
        "record \"record 0\" has 6 samples, but 2 block rows of 3 sensors need 8",
    );
    check(&data, &fixed(0), "an order of 0 was asked for, but a system has at least one state");
}

#[test]
fn dead_doubled_and_silent_channels() {
    let options = Options::default();
    let mut data = records(2, 3, 300);
    let constant = changed(&data[1], 2, |_, _| 0.25);
    check(
        &[data[0].clone(), constant],
        &options,
        "record \"record 1\": channel \"y2\" is constant, 0.25 throughout: a sensor that reads the excitation is needed",
    );
    let zero = (0..3).fold(data[1].clone(), |record, sensor| changed(&record, sensor, |_, _| 0.0));
    check(
        &[data[0].clone(), zero],
        &options,
        "record \"record 1\" is zero throughout: nothing excited the system, or nothing was recorded",
    );
    for record in &mut data {
        let original = record.channels()[0].values.clone();
        *record = changed(record, 2, |k, _| -2.0 * original[k] + 7.0);
    }
    check(
        &data,
        &options,
        "channels \"y0\" and \"y2\" are the same signal up to the factor -2.000e0 in all records: leave one of them out",
    );
}

#[test]
fn records_that_do_not_fit_together() {
    let data = records(2, 3, 300);
    let options = Options::default();
    let slower =
        Record::new("slow", SamplePeriod::new(0.2).unwrap(), data[1].channels().to_vec()).unwrap();
    let error = identify(&[data[0].clone(), slower], &options).unwrap_err();
    assert!(matches!(error, ReconstructError::DifferentSampling { .. }), "{error}");
    let fewer = Record::new("fewer", data[1].period(), data[1].channels()[..2].to_vec()).unwrap();
    let error = identify(&[data[0].clone(), fewer], &options).unwrap_err();
    assert!(matches!(error, ReconstructError::DifferentChannels { .. }), "{error}");
}

#[test]
fn noise_models_that_do_not_fit() {
    let data = records(2, 3, 300);
    let with = |noise| Options { noise, ..fixed(2) };
    check(&data, &with(NoiseModel::Levels(vec![0.1; 2])), "2 noise level(s) for 3 sensor(s)");
    check(
        &data,
        &with(NoiseModel::Levels(vec![0.1, 0.0, 0.1])),
        "the noise level of sensor \"y1\" is 0, but must be positive and finite",
    );
    let error = identify(&data, &with(NoiseModel::Levels(vec![0.1, 0.1, f64::NAN]))).unwrap_err();
    assert!(matches!(error, ReconstructError::InvalidNoiseLevel { .. }), "{error}");

    // A quiet record that shows the motion of one state and no noise.
    let silent = DMatrix::from_fn(3, 300, |i, k| (i as f64 + 1.0) * 0.99_f64.powf(k as f64));
    let silent =
        changed(&from_rows("quiet", &silent), 0, |k, value| value + 1e-3 * (k as f64).sin());
    let error = identify(&data, &with(NoiseModel::Quiet(silent))).unwrap_err();
    assert!(
        matches!(error, ReconstructError::SilentRecord { rank, rows, .. } if rank < rows),
        "{error}"
    );
    let short = from_rows("quiet", &normal(&mut generator(1), 3, 20));
    let mut options = with(NoiseModel::Quiet(short));
    options.block_rows = Some(10);
    check(
        &data,
        &options,
        "record \"quiet\" has 20 samples, but 10 block rows of 3 sensors need 40",
    );
}

#[test]
fn units_of_any_size_give_the_same() {
    let data = records(2, 3, 300);
    let expected = identify(&data, &fixed(2)).unwrap();
    for (first, second) in [(1e200, 1e-200), (1e-290, 1e290), (3e4, 1.0)] {
        let scaled: Vec<_> = data
            .iter()
            .map(|record| changed(record, 0, |_, value| first * value))
            .map(|record| changed(&record, 1, |_, value| second * value))
            .collect();
        let found = identify(&scaled, &fixed(2)).unwrap();
        for (found, expected) in found.modes.iter().zip(&expected.modes) {
            assert!((found.pole - expected.pole).norm() < 1e-9, "{} {}", found.pole, expected.pole);
        }
        let ratio = found.noise.deviations[0] / expected.noise.deviations[0] / first;
        assert!((ratio - 1.0).abs() < 1e-6, "{ratio}");
    }
}

#[test]
fn offsets_do_not_matter_where_rows_are_centred() {
    let data = records(2, 3, 300);
    let expected = identify(&data, &fixed(2)).unwrap();
    let shifted: Vec<_> = data.iter().map(|r| changed(r, 1, |_, value| value + 1e6)).collect();
    let found = identify(&shifted, &fixed(2)).unwrap();
    for (found, expected) in found.modes.iter().zip(&expected.modes) {
        // 1e6 costs six of the digits of samples of 1.
        assert!((found.pole - expected.pole).norm() < 1e-7, "{} {}", found.pole, expected.pole);
    }
}

#[test]
fn nothing_in_a_result_is_undefined() {
    // Noise alone, one sample too many for the shortest, a step, a spike: poor records, but records.
    let noise: Vec<_> = (0..2)
        .map(|j| from_rows(&format!("noise {j}"), &normal(&mut generator(j), 3, 200)))
        .collect();
    let shape = |f: &dyn Fn(usize, usize) -> f64, j: usize| {
        from_rows(&format!("shape {j}"), &DMatrix::from_fn(3, 200, f))
    };
    let steps = vec![
        shape(&|i, k| f64::from(u8::from(k > 50 + 10 * i)), 0),
        shape(&|i, k| f64::from(u8::from(k > 90 + 7 * i)), 1),
    ];
    let spikes = vec![
        shape(&|i, k| f64::from(u8::from(k == 50 + 10 * i)), 0),
        shape(&|i, k| f64::from(u8::from(k == 60 + 3 * i)), 1),
    ];
    let tones = vec![
        shape(&|i, k| (0.3 * k as f64 + i as f64).sin(), 0),
        shape(&|i, k| (0.7 * k as f64 - (i * i) as f64).sin(), 1),
    ];
    for data in [noise, steps, spikes, tones] {
        for options in [Options::default(), fixed(4), fixed(1)] {
            let found = match identify(&data, &options) {
                Ok(found) => found,
                Err(error) => {
                    assert!(matches!(error, ReconstructError::Step { .. }), "{error}");
                    continue;
                }
            };
            let model = &found.model;
            let all = model.a.iter().chain(model.c.iter()).chain(model.b.iter().flatten());
            assert!(all.copied().all(f64::is_finite), "{found:?}");
            assert!(
                found.modes.iter().flat_map(|mode| &mode.excitation_snr).all(|s| s.is_finite())
            );
            assert!(found.noise.deviations.iter().all(|level| *level > 0.0));
            assert!(!found.doubts.is_empty(), "{} {:?}", data[0].name(), options.order);
        }
    }
}
