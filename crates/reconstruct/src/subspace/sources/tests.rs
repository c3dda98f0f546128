use super::*;
use crate::subspace::options::Options;
use crate::subspace::tests::{from_rows, generator, normal};

#[test]
fn covariances_are_those_of_the_block_hankel_matrix() {
    let mut rng = generator(7);
    let data: Vec<_> = (0..2)
        .map(|j| {
            let rows = normal(&mut rng, 3, 60 + 10 * j) * 1e3;
            (rows.clone(), from_rows(&format!("{j}"), &rows.add_scalar(5e3)))
        })
        .collect();
    let records: Vec<_> = data.iter().map(|(_, record)| record.clone()).collect();
    let options = Options::default();
    let setting = Setting::new(&records, &options).unwrap();
    let sources = Sources::new(setting, 4, 3).unwrap();
    assert_eq!(sources.columns, [57, 67]);
    for ((rows, _), (source, weight)) in data.iter().zip(&sources.records) {
        let columns = rows.ncols() - 3;
        let mut h =
            DMatrix::from_fn(12, columns, |i, t| rows[(i % 3, t + i / 3)] / sources.units[i % 3]);
        for mut row in h.row_iter_mut() {
            let mean = row.mean();
            row.add_scalar_mut(-mean);
        }
        let expected = &h * h.transpose() / columns as f64;
        let Source::Covariance(found) = source else { panic!("there is noise") };
        assert!((found - &expected).amax() < 1e-14 * expected.amax());
        assert!((weight - columns as f64).abs() < 1e-12);
    }
}

#[test]
fn only_large_offsets_are_taken_away_before() {
    let mut small = vec![1.0, -1.0, 0.5];
    remove_large_offset(&mut small);
    assert_eq!(small, [1.0, -1.0, 0.5]);
    let mut large = vec![1e6 + 1.0, 1e6 - 1.0, 1e6];
    remove_large_offset(&mut large);
    assert_eq!(large, [1.0, -1.0, 0.0]);
}

#[test]
fn a_triangle_where_there_is_no_noise() {
    let mut rng = generator(8);
    let one = normal(&mut rng, 1, 80);
    let rows = DMatrix::from_fn(3, 79, |i, k| one[k + usize::from(i == 2)] * (i as f64 + 1.0));
    let records = [from_rows("a", &rows), from_rows("b", &normal(&mut rng, 3, 79))];
    let options = Options::default();
    // The first two channels are proportional in one record: no error, but next to nothing there.
    let setting = Setting::new(&records, &options).unwrap();
    let sources = Sources::new(setting, 4, 4).unwrap();
    assert!(sources.records.iter().all(|(source, _)| matches!(source, Source::Triangle(_))));
}
