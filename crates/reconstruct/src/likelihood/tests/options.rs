//! Offsets, trends, known inputs, feedthrough, bands, quiet records.

use super::*;

#[test]
fn offsets_trends_known_inputs_and_feedthrough() {
    let eigenvalues = [Complex::new(0.9, 0.3), Complex::new(0.8, 0.0)];
    let mut normal = Normal::new(6);
    let mut truth = system(&eigenvalues, 4, 2, &mut normal);
    let d = |x: f64| DVector::from_column_slice(&[0.0, 0.0, 0.0, x]);
    truth.feedthrough = Some(vec![d(0.8), d(-0.5)]);
    let disturbance = Disturbance { noise: 0.01, offset: 0.2, trend: 0.5, known: 1.0 };
    let flights = fly(&truth, &[600, 500], &disturbance, &mut normal);
    let start = perturbed(&truth, 1e-3, &mut normal);
    let full = Options {
        measurement: Measurement {
            offsets: Offsets::Free,
            trend: Trend::Linear,
            feedthrough_sensors: vec![3],
            known_inputs: flights.known.clone(),
        },
        ..given(&flights.levels)
    };
    let fit = identify(&flights.records, from_ref(&start), &full).unwrap();
    assert_eq!(fit.search.status, SearchStatus::Converged);
    assert!((fit.chi_squared.per_degree_of_freedom() - 1.0).abs() < 0.1);
    assert!(fit.chi_squared.p_value.unwrap() > 0.01);
    assert!(misses(&fit, &eigenvalues).iter().all(|(_, deviations)| *deviations < 4.0));
    // A prior about as wide as the offsets are does as well.
    let prior = Options {
        measurement: Measurement {
            offsets: Offsets::PriorDeviation(vec![0.2; 4]),
            ..full.measurement.clone()
        },
        ..full.clone()
    };
    let with_prior = identify(&flights.records, from_ref(&start), &prior).unwrap();
    assert!(with_prior.chi_squared.p_value.unwrap() > 0.01);
    // Each of them is needed: without it the residuals are larger than the noise.
    let without = [
        Options {
            measurement: Measurement { offsets: Offsets::Zero, ..full.measurement.clone() },
            ..full.clone()
        },
        Options {
            measurement: Measurement { trend: Trend::Absent, ..full.measurement.clone() },
            ..full.clone()
        },
        Options {
            measurement: Measurement {
                feedthrough_sensors: Vec::new(),
                ..full.measurement.clone()
            },
            ..full.clone()
        },
        Options {
            measurement: Measurement { known_inputs: Vec::new(), ..full.measurement.clone() },
            ..full.clone()
        },
    ];
    for options in without {
        let fit = identify(&flights.records, from_ref(&start), &options).unwrap();
        assert!(fit.chi_squared.p_value.unwrap() < 1e-6, "{:?}", fit.chi_squared);
    }
}

#[test]
fn a_band_leaves_the_rest_out() {
    let eigenvalues = [Complex::new(0.95, 0.2), Complex::new(0.9, 0.0)];
    let mut normal = Normal::new(8);
    let truth = system(&eigenvalues, 3, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.01, ..QUIET };
    let mut flights = fly(&truth, &[500, 500], &disturbance, &mut normal);
    // A hum at 25 rad/s in the first sensor, which no excitation explains.
    let hum = |k: usize| (2.5 * k as f64).sin();
    flights.records = flights
        .records
        .into_iter()
        .map(|record| {
            let mut channels = record.channels().to_vec();
            channels[0].values.iter_mut().enumerate().for_each(|(k, value)| *value += hum(k));
            Record::new(record.name(), record.period(), channels).unwrap()
        })
        .collect();
    let all = given(&flights.levels);
    let band = FrequencyBand { lowest_rad_s: 0.0, highest_rad_s: 15.0 };
    // The hum leaks into the band, but less than the noise.
    let low = Options { band: Some(band), ..all.clone() };
    let whole = identify(&flights.records, from_ref(&truth), &all).unwrap();
    let part = identify(&flights.records, &[truth], &low).unwrap();
    assert!(whole.chi_squared.per_degree_of_freedom() > 2.0);
    assert!(part.chi_squared.per_degree_of_freedom() < 1.5);
    // 15 rad/s of 10 pi rad/s.
    let share = part.chi_squared.degrees_of_freedom / whole.chi_squared.degrees_of_freedom;
    assert!((share - 15.0 / 31.4).abs() < 0.02, "{share}");
}

#[test]
fn a_quiet_record_whitens_coloured_noise() {
    let eigenvalues = [Complex::new(0.95, 0.2), Complex::new(0.7, 0.0)];
    let mut normal = Normal::new(12);
    let truth = system(&eigenvalues, 3, 2, &mut normal);
    let mix = normal.matrix(3, 3) * 0.1;
    let mut coloured = |samples: usize| {
        let mut state = DVector::zeros(3);
        let columns: Vec<_> = (0..samples)
            .map(|_| {
                state = &state * 0.8 + &mix * normal.vector(3);
                state.clone()
            })
            .collect();
        DMatrix::from_columns(&columns)
    };
    let noises = [coloured(1500), coloured(1500), coloured(3000)];
    let flights = fly(&truth, &[1500, 1500], &QUIET, &mut Normal::new(13));
    let noisy = |record: &Record, noise: &DMatrix<f64>| {
        let mut channels = record.channels().to_vec();
        for (channel, row) in channels.iter_mut().zip(noise.row_iter()) {
            channel.values.iter_mut().zip(row.iter()).for_each(|(value, noise)| *value += noise);
        }
        Record::new(record.name(), record.period(), channels).unwrap()
    };
    let records: Vec<_> =
        flights.records.iter().zip(&noises).map(|(record, noise)| noisy(record, noise)).collect();
    let still = (0..3).map(|s| Channel::new(format!("y{s}"), vec![0.0; 3000])).collect();
    let quiet = noisy(&Record::new("quiet", truth.period, still).unwrap(), &noises[2]);
    let order = AutoregressionOrder::Akaike { largest: 6 };
    let spectrum = VectorAutoregression::fit(&quiet, order).unwrap().spectrum(1500).unwrap();
    let options =
        Options { noise: Noise::Spectra(vec![spectrum.clone(), spectrum]), ..Options::default() };
    let start = perturbed(&truth, 1e-3, &mut normal);
    let fit = identify(&records, from_ref(&start), &options).unwrap();
    assert_eq!(fit.search.status, SearchStatus::Converged);
    assert!((fit.chi_squared.per_degree_of_freedom() - 1.0).abs() < 0.1, "{:?}", fit.chi_squared);
    assert!(misses(&fit, &eigenvalues).iter().all(|(_, deviations)| *deviations < 4.0));
    assert!(fit.whiteness.iter().all(|test| test.p_value > 1e-3));
    assert_eq!(fit.noise_levels, None);
    // Taken for white, the residuals show that they are not.
    let white = identify(&records, &[start], &Options::default()).unwrap();
    assert!(white.whiteness.iter().all(|test| test.p_value < 1e-6));
}
