use super::*;
use crate::subspace::options::Options;
use crate::subspace::tests::{from_rows, generator, normal};
use nalgebra::DMatrix;

/// The rank that a covariance of so many block rows of three sensors, with signal in the first `k (L - 1) + n` directions, is given.
fn rank(signal: impl Fn(usize) -> usize, order: usize) -> ExcitationRank {
    let mut rng = generator(9);
    let records =
        [from_rows("a", &normal(&mut rng, 3, 900)), from_rows("b", &normal(&mut rng, 3, 900))];
    let options = Options::default();
    let setting = Setting::new(&records, &options).unwrap();
    let (rows, half) = (signal(20), signal(10));
    // Strong are as many of the first 30 rows as half the block rows show, and the rest further down.
    let strong = |i: usize| i < half || (30..30 + rows - half).contains(&i);
    let covariance =
        DMatrix::from_fn(
            60,
            60,
            |i, k| {
                if i == k { if strong(i) { 100.0 } else { 1.0 } } else { 0.0 }
            },
        );
    let whitening = Whitening::Levels(vec![1.0; 3]);
    let source = Source::Covariance(covariance);
    let values = whitening.values(&source, 60).unwrap();
    excitation_rank(setting, &whitening, &source, (&values, 20), 881, order).unwrap()
}

#[test]
fn the_growth_of_the_rank_is_the_number_of_excitations() {
    let one = rank(|rows| rows - 1 + 4, 4);
    assert_eq!((one.rank, one.growth, &one.ranks[..]), (1, 1.0, &[(10, 13), (20, 23)][..]));
    assert!((one.largest_noise - 1.0).abs() < 1e-12 && one.noise_edge > 1.0);
    assert_eq!(rank(|rows| 2 * (rows - 1) + 4, 4).rank, 2);
    assert_eq!(rank(|_| 4, 4).rank, 0);
    assert_eq!(rank(|rows| 9 + rows / 20, 4).rank, 1);
    // Little power at high frequencies.
    assert_eq!(rank(|rows| rows / 4 + 4, 4).rank, 1);
    assert_eq!(rank(|rows| 5 * rows / 4 + 4, 4).rank, 2);
    assert!(rank(|rows| 5 * rows / 4 + 4, 4).largest_noise > 99.0);
}
