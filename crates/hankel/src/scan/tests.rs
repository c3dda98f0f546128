use pulp::Arch;

use super::*;

#[test]
fn the_largest_modulus_is_found_wherever_it_stands() {
    for length in [0, 1, 7, 8, 31, 32, 33, 100] {
        for place in 0..length {
            let mut samples: Vec<f64> = (0..length).map(|k| k as f64 * 1e-3).collect();
            samples[place] = -2.5;
            assert_eq!(Arch::new().dispatch(Largest(&samples)), 2.5, "{place} of {length}");
        }
    }
    assert_eq!(Arch::new().dispatch(Largest(&[])), 0.0);
}

#[test]
fn one_sample_that_is_not_finite_is_seen() {
    for length in [1, 7, 8, 33, 100] {
        let samples: Vec<f64> = (0..length).map(|k| k as f64 * 1e306).collect();
        assert!(Arch::new().dispatch(AllFinite(&samples)), "{length}");
        for place in 0..length {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut samples = samples.clone();
                samples[place] = bad;
                assert!(!Arch::new().dispatch(AllFinite(&samples)), "{place} of {length}");
            }
        }
    }
}

#[test]
fn scaling_leaves_the_rest_alone() {
    let samples: Vec<f64> = (0..21).map(f64::from).collect();
    let mut into = vec![-1.0; 30];
    Arch::new().dispatch(Multiply { samples: &samples, factor: 0.5, into: &mut into });
    assert!(into[..21].iter().zip(0..).all(|(x, k)| *x == 0.5 * f64::from(k)));
    assert!(into[21..].iter().all(|x| *x == -1.0));
}
