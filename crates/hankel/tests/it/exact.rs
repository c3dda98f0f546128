//! The same matrices by the definition, in rational numbers.

use hankel::{Column, Gram, Layout};
use num_rational::BigRational;
use proptest::prelude::*;

/// A double as the number that it is.
pub(crate) fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

/// The entries of `L' R`, row by row of the result, over all segments.
pub(crate) fn products(layout: &Layout, segments: &[Vec<Vec<f64>>]) -> Vec<Vec<BigRational>> {
    let earliest =
        layout.columns().iter().chain(layout.right_columns()).map(|c| c.lag).min().unwrap();
    let zero = || rational(0.0);
    let mut result: Vec<Vec<BigRational>> = layout
        .columns()
        .iter()
        .map(|_| layout.right_columns().iter().map(|_| zero()).collect())
        .collect();
    for segment in segments {
        let exact: Vec<Vec<BigRational>> =
            segment.iter().map(|channel| channel.iter().map(|x| rational(*x)).collect()).collect();
        let rows = layout.rows(segment[0].len());
        let sample = |c: &Column, k: usize| &exact[c.channel][k + c.lag.abs_diff(earliest)];
        for (row, left) in result.iter_mut().zip(layout.columns()) {
            for (entry, right) in row.iter_mut().zip(layout.right_columns()) {
                for k in 0..rows {
                    *entry += sample(left, k) * sample(right, k);
                }
            }
        }
    }
    result
}

/// Largest error of an entry, relative to the norms of its two columns (for a cross product, to the entry of largest modulus).
pub(crate) fn worst(gram: &Gram, exact: &[Vec<BigRational>]) -> f64 {
    let to_float = |x: &BigRational| num_traits_to_f64(x);
    let largest = exact.iter().flatten().map(|x| to_float(x).abs()).fold(0.0, f64::max);
    let mut worst: f64 = 0.0;
    for (i, row) in exact.iter().enumerate() {
        for (j, value) in row.iter().enumerate() {
            let found = gram.entry(i, j).unwrap();
            let error = to_float(&(rational(found.high()) + rational(found.low()) - value)).abs();
            let size = if gram.is_symmetric() {
                (to_float(&exact[i][i]) * to_float(&exact[j][j])).sqrt()
            } else {
                largest
            };
            if error > 0.0 {
                worst = worst.max(error / size);
            }
        }
    }
    worst
}

fn num_traits_to_f64(x: &BigRational) -> f64 {
    use num_rational::Ratio;
    // Through parts: BigRational's own conversion loses range for large denominators.
    let (numerator, denominator) = (x.numer(), x.denom());
    let shift =
        i64::try_from(numerator.bits()).unwrap() - i64::try_from(denominator.bits()).unwrap();
    let one = num_bigint::BigInt::from(1);
    let scaled = if shift > 0 {
        Ratio::new(numerator.clone(), denominator * (one << shift))
    } else {
        Ratio::new(numerator * (one << -shift), denominator.clone())
    };
    let digits = (scaled * Ratio::from(num_bigint::BigInt::from(1_u64 << 60))).to_integer();
    let digits: f64 = digits.to_string().parse().unwrap();
    digits * 2.0_f64.powi(-60) * 2.0_f64.powi(i32::try_from(shift).unwrap())
}

/// Up to three channels, any lags, and a few samples more than they need.
pub(crate) fn layouts() -> impl Strategy<Value = Layout> {
    (1..=3_usize).prop_flat_map(|channels| {
        let column = (0..channels, -12_isize..=12).prop_map(|(c, lag)| Column::new(c, lag));
        let side = || prop::collection::btree_set(column.clone(), 1..=7);
        (side(), side(), any::<bool>()).prop_map(move |(left, right, cross)| {
            let left: Vec<Column> = left.into_iter().rev().collect();
            let right = right.into_iter().collect();
            if cross {
                Layout::cross(channels, left, right).unwrap()
            } else {
                Layout::new(channels, left).unwrap()
            }
        })
    })
}

/// Samples of very different size, with zeros among them.
pub(crate) fn samples(channels: usize, length: usize) -> impl Strategy<Value = Vec<Vec<f64>>> {
    let sample = prop_oneof![
        4 => -1.0..1.0_f64,
        2 => (-1.0..1.0_f64, -40..40_i32).prop_map(|(x, e)| x * 2.0_f64.powi(e)),
        1 => Just(0.0),
    ];
    prop::collection::vec(prop::collection::vec(sample, length), channels)
}
