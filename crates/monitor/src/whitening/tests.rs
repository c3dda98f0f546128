use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

use super::*;

#[test]
fn a_coloured_signal_becomes_white() {
    // e(k) = 1.2 e(k-1) - 0.6 e(k-2) + w(k).
    let mut random = ChaCha8Rng::seed_from_u64(4);
    let (mut e, mut w) = (vec![0.0, 0.0], vec![0.0, 0.0]);
    for k in 2..20_000 {
        w.push(StandardNormal.sample(&mut random));
        e.push(1.2 * e[k - 1] - 0.6 * e[k - 2] + w[k]);
    }
    let (early, late) = e.split_at(5_000);
    let whitening = Whitening::fit(&[early, late]);
    assert!((2..5).contains(&whitening.order()), "{whitening:?}");
    for (found, expected) in whitening.coefficients().iter().zip([-1.2, 0.6]) {
        assert!((found - expected).abs() < 0.03, "{whitening:?}");
    }
    let white = whitening.apply(&e);
    assert_eq!(white.len(), e.len() - whitening.order());
    for (found, expected) in white.iter().zip(&w[whitening.order()..]) {
        assert!((found - expected).abs() < 0.3);
    }
}

#[test]
fn what_is_white_or_nothing_stays_as_it_is() {
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let w: Vec<f64> = (0..5_000).map(|_| StandardNormal.sample(&mut random)).collect();
    assert_eq!(Whitening::fit(&[&w]).order(), 0);
    assert_eq!(Whitening::fit(&[&[0.0; 100]]).order(), 0);
    assert_eq!(Whitening::fit(&[]).order(), 0);
    assert_eq!(Whitening::fit(&[]).apply(&w), w);
}
