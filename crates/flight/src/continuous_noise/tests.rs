use nalgebra::dmatrix;

use super::*;
use crate::{behind_low_pass, in_side_gust};

fn lag() -> StateSpace<Continuous> {
    StateSpace::<Continuous>::new(dmatrix![-1.0], dmatrix![1.0], dmatrix![1.0], dmatrix![0.0])
        .unwrap()
}

fn period() -> SamplePeriod {
    SamplePeriod::new(0.1).unwrap()
}

#[test]
fn blocks_do_not_show() {
    let motion = ContinuousNoise::new(&lag(), period()).unwrap();
    let (run_in, samples) = (130, 1_234);
    let found = motion.sampled(run_in, samples, &mut Stream::new(3, 1)).unwrap();
    let input = normal(1, (run_in + samples) * SUBSTEPS, &mut Stream::new(3, 1));
    let whole = motion.fine.simulate(&input, None).unwrap().outputs;
    for k in 0..samples {
        assert_eq!(found[k], whole[(run_in + k) * SUBSTEPS]);
    }
}

#[test]
fn the_variance_is_that_of_the_filter() {
    // x(k+1) = e x(k) + (1 - e) n(k), e = exp(-0.005): variance (1 - e) / (1 + e).
    let motion = ContinuousNoise::new(&lag(), period()).unwrap();
    let y = motion.sampled(100, 40_000, &mut Stream::new(11, 0)).unwrap();
    let e = (-0.005_f64).exp();
    let expected = (1.0 - e) / (1.0 + e);
    // 40 000 samples of memory ten: the variance is known to 3 %.
    assert!((y.variance() / expected - 1.0).abs() < 0.1);
}

#[test]
fn what_cannot_be_simulated_is_refused() {
    let two = StateSpace::<Continuous>::new(
        dmatrix![-1.0],
        dmatrix![1.0, 1.0],
        dmatrix![1.0],
        dmatrix![0.0, 0.0],
    )
    .unwrap();
    assert!(ContinuousNoise::new(&two, period()).is_err());
    assert!(behind_low_pass(&two, 2, 1.0).is_err());
    for corner in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(behind_low_pass(&two, 0, corner).is_err());
        assert!(in_side_gust(&lag(), corner).is_err());
    }
}
