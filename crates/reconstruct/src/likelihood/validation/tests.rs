use nalgebra::DMatrix;
use num_complex::Complex;

use super::super::fixtures::{Normal, QUIET, fly, given, system};
use super::*;
use crate::likelihood::identify;

#[test]
fn bad_input_is_named() {
    let eigenvalues = [Complex::new(0.9, 0.2), Complex::new(0.5, 0.0)];
    let mut normal = Normal::new(61);
    let truth = system(&eigenvalues, 3, 2, &mut normal);
    let flights = fly(&truth, &[100, 100], &QUIET, &mut normal);
    let refuse = |records: &[Record], starts: &[SharedModel], options: &Options| {
        identify(records, starts, options).map(|fit| fit.chi_squared).unwrap_err()
    };
    let (records, good) = (&flights.records, given(&flights.levels));
    let starts = [truth.clone()];
    assert!(matches!(
        refuse(&records[..1], &starts, &good),
        ReconstructError::TooFewRecords { found: 1, needed: 2 }
    ));
    assert!(matches!(refuse(records, &[], &good), ReconstructError::Option { .. }));
    let option = |change: &dyn Fn(&mut Options)| {
        let mut options = good.clone();
        change(&mut options);
        refuse(records, &starts, &options)
    };
    assert!(matches!(
        option(&|o| o.noise = Noise::Given(vec![1.0; 2])),
        ReconstructError::Option { name: "noise levels", .. }
    ));
    assert!(matches!(
        option(&|o| o.noise = Noise::Given(vec![1.0, 0.0, 1.0])),
        ReconstructError::InvalidTolerance { .. }
    ));
    assert!(matches!(
        option(&|o| o.noise = Noise::Spectra(Vec::new())),
        ReconstructError::Noise { .. }
    ));
    assert!(matches!(
        option(&|o| o.measurement.known_inputs = vec![vec![vec![1.0; 99]], vec![]]),
        ReconstructError::Option { name: "known inputs", .. }
    ));
    assert!(matches!(
        option(&|o| o.measurement.feedthrough_sensors = vec![3]),
        ReconstructError::Option { .. }
    ));
    assert!(matches!(
        option(&|o| o.band = Some(FrequencyBand { lowest_rad_s: 2.0, highest_rad_s: 1.0 })),
        ReconstructError::Option { name: "band", .. }
    ));
    assert!(matches!(
        option(&|o| o.band = Some(FrequencyBand { lowest_rad_s: 1.0, highest_rad_s: 1.7 })),
        ReconstructError::TooFewSamples { .. }
    ));
    let start = |change: &dyn Fn(&mut SharedModel)| {
        let mut start = truth.clone();
        change(&mut start);
        refuse(records, &[truth.clone(), start], &good)
    };
    let second =
        |error: ReconstructError| matches!(error, ReconstructError::Start { start: 1, .. });
    assert!(second(start(&|s| s.a = DMatrix::zeros(2, 2))));
    assert!(second(start(&|s| s.c[(0, 0)] = f64::NAN)));
    assert!(second(start(&|s| s.b.truncate(1))));
}
