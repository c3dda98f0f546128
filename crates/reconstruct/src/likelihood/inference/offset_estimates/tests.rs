use num_complex::Complex;

use super::*;
use crate::Channel;
use crate::likelihood::fixtures::{Disturbance, Normal, QUIET, fly, system};
use crate::likelihood::{Noise, identify};

const EIGENVALUES: [Complex<f64>; 2] = [Complex::new(0.95, 0.25), Complex::new(0.98, 0.0)];
const OFFSETS: [f64; 3] = [0.3, -0.5, 0.1];

fn shifted(record: &Record) -> Record {
    let channels = record.channels().iter().zip(OFFSETS).map(|(channel, offset)| {
        let values = channel.values.iter().map(|value| value + offset);
        Channel::new(channel.name.clone(), values.collect())
    });
    Record::new(record.name(), record.period(), channels.collect()).unwrap()
}

#[test]
fn planted_offsets_come_out_within_their_standard_errors() {
    let mut scores = Vec::new();
    for seed in 1..=12 {
        let mut normal = Normal::new(seed);
        let truth = system(&EIGENVALUES, 3, 2, &mut normal);
        let disturbance = Disturbance { noise: 0.05, ..QUIET };
        let flights = fly(&truth, &[700, 600], &disturbance, &mut normal);
        let records: Vec<_> = flights.records.iter().map(shifted).collect();
        let noise = if seed % 2 == 0 {
            Noise::ModelError { first_guess: None }
        } else {
            Noise::Estimated { first_guess: None }
        };
        let fit = identify(&records, &[truth], &Options { noise, ..Options::default() }).unwrap();
        assert_eq!(fit.options.measurement.offsets, Offsets::Free, "{seed}");
        let found = offset_estimates(&records, &fit).unwrap();
        for (estimate, offset) in found.iter().zip(OFFSETS) {
            scores.push((estimate.value - offset) / estimate.standard_error);
        }
    }
    assert_eq!(scores.len(), 36);
    let within = scores.iter().filter(|score| score.abs() < 2.0).count();
    assert!(within >= 30, "{scores:?}");
    assert!(scores.iter().all(|score| score.abs() < 5.0), "{scores:?}");
}

#[test]
fn offsets_that_are_zero_are_none() {
    let mut normal = Normal::new(3);
    let truth = system(&EIGENVALUES, 3, 2, &mut normal);
    let disturbance = Disturbance { noise: 0.05, ..QUIET };
    let flights = fly(&truth, &[300, 300], &disturbance, &mut normal);
    let fit = identify(&flights.records, &[truth], &Options::default()).unwrap();
    assert_eq!(fit.options.measurement.offsets, Offsets::Zero);
    assert!(offset_estimates(&flights.records, &fit).unwrap().is_empty());
}
