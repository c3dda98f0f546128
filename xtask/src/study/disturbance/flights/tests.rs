use super::*;
use crate::study::disturbance::GUST_PERCENT;

fn fly(excitation: Excitation, gust_percent: u32, seed: u64) -> Flight {
    Simulator::new().unwrap().fly(Kind { excitation, gust_percent }, seed).unwrap()
}

fn readings(record: &Record) -> DMatrix<f64> {
    let channels = record.channels();
    DMatrix::from_fn(channels.len(), record.samples(), |i, k| channels[i].values[k])
}

#[test]
fn the_gusts_have_the_size_that_was_asked_for() {
    for excitation in Excitation::ALL {
        let still = fly(excitation, 0, 3);
        for percent in &GUST_PERCENT[1..] {
            let rough = fly(excitation, *percent, 3);
            // Noise and controls are the same, so that what is left are the gusts.
            let gusts: Vec<_> = [0, 1]
                .map(|index| readings(&rough.records[index]) - readings(&still.records[index]))
                .into_iter()
                .chain([readings(&rough.quiet) - readings(&still.quiet)])
                .collect();
            for record in &still.records {
                // The noise adds 1e-4 to the square.
                let response = deviations(&[readings(record)]);
                let ratio = size_ratio(&deviations(&gusts), &response);
                assert!((100.0 * ratio / f64::from(*percent) - 1.0).abs() < 1e-3, "{ratio}");
            }
            assert_eq!(rough.levels, still.levels);
        }
    }
}

#[test]
fn flights_of_one_seed_are_the_same_again() {
    let (first, again) = (fly(Excitation::Multisteps, 30, 5), fly(Excitation::Multisteps, 30, 5));
    assert_eq!(first.records, again.records);
    assert_eq!(first.quiet, again.quiet);
    assert_ne!(fly(Excitation::Multisteps, 30, 6).records, first.records);
}

#[test]
fn each_record_has_gusts_and_noise_of_its_own() {
    let correlation = |x: &DMatrix<f64>, y: &DMatrix<f64>| x.dot(y) / (x.norm() * y.norm());
    let noise = fly(Excitation::Autoregressive, 0, 8).quiet;
    let rough = fly(Excitation::Autoregressive, 100, 8);
    let still = fly(Excitation::Autoregressive, 0, 8);
    let gusts =
        [0, 1].map(|index| readings(&rough.records[index]) - readings(&still.records[index]));
    let third = readings(&rough.quiet) - readings(&noise);
    for (x, y) in [(&gusts[0], &gusts[1]), (&gusts[0], &third), (&gusts[1], &third)] {
        // Of the vane alone, whose gusts are forgotten after seconds.
        let (x, y) = (x.rows(0, 1).into_owned(), y.rows(0, 1).into_owned());
        assert!(correlation(&x, &y).abs() < 0.4, "{}", correlation(&x, &y));
    }
    let level = |record: &Record| deviations(&[readings(record)]);
    for (found, expected) in level(&noise).iter().zip(&still.levels) {
        assert!((found / expected - 1.0).abs() < 0.06, "{found} {expected}");
    }
}

#[test]
fn the_noise_is_a_hundredth_of_the_response() {
    let still = fly(Excitation::Autoregressive, 0, 2);
    for sensor in 0..3 {
        let both: f64 = still.records.iter().map(|r| deviations(&[readings(r)])[sensor]).sum();
        let ratio = both / 2.0 / still.levels[sensor];
        assert!((ratio / SIGNAL_TO_NOISE - 1.0).abs() < 1e-3, "{ratio}");
    }
}
