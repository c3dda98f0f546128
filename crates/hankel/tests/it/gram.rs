//! Entries against exact sums.

use hankel::{Accumulator, Column, Layout, Options, Seam, gram};
use proptest::prelude::*;

use crate::exact::{layouts, products, samples, worst};

fn record(channels: &[Vec<f64>]) -> Vec<&[f64]> {
    channels.iter().map(Vec::as_slice).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn entries_are_exact_to_twice_the_digits(
        (layout, channels) in layouts().prop_flat_map(|layout| {
            let lengths = layout.span() + 1..layout.span() + 60;
            (Just(layout.clone()), lengths.prop_flat_map(move |n| samples(layout.channels(), n)))
        })
    ) {
        let found = gram(&layout, &record(&channels), &Options::default()).unwrap();
        let exact = products(&layout, &[channels]);
        let error = worst(&found, &exact);
        prop_assert!(error < 4.0 * found.rounding(), "{error:e} {:e}", found.rounding());
    }

    #[test]
    fn segments_add_up(
        (layout, first, second) in layouts().prop_flat_map(|layout| {
            let channels = layout.channels();
            let lengths = 0..layout.span() + 30;
            let samples = move |n| samples(channels, n);
            (Just(layout), lengths.clone().prop_flat_map(samples), lengths.prop_flat_map(samples))
        })
    ) {
        let rows = layout.rows(first[0].len()) + layout.rows(second[0].len());
        let mut accumulator = Accumulator::new(&layout, &Options::default()).unwrap();
        accumulator.push(&record(&first)).unwrap();
        accumulator.gap();
        accumulator.push(&record(&second)).unwrap();
        prop_assert_eq!(accumulator.rows(), rows);
        prop_assume!(rows > 0);
        let exact = products(&layout, &[first, second]);
        let found = accumulator.gram().unwrap();
        prop_assert!(worst(&found, &exact) < 4.0 * found.rounding());
    }

    #[test]
    fn parts_of_one_record_merge_as_if_read_in_one_go(
        (layout, channels, cuts) in layouts().prop_flat_map(|layout| {
            let lengths = layout.span() + 1..3 * layout.span() + 60;
            let cuts = prop::collection::vec(0.0..1.0_f64, 1..4);
            (Just(layout.clone()), lengths.prop_flat_map(move |n| samples(layout.channels(), n)), cuts)
        })
    ) {
        let length = channels[0].len();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss,
            reason = "a place in a short record")]
        let mut cuts: Vec<usize> = cuts.iter().map(|c| (c * length as f64) as usize).collect();
        cuts.sort_unstable();
        cuts.push(length);
        let mut from = 0;
        let mut parts = Vec::new();
        for to in cuts {
            let mut part = Accumulator::new(&layout, &Options::default()).unwrap();
            let piece: Vec<&[f64]> = channels.iter().map(|c| &c[from..to]).collect();
            part.push(&piece).unwrap();
            parts.push(part);
            from = to;
        }
        // From the left and from the right.
        let mut left = parts[0].clone();
        for part in &parts[1..] {
            left.merge(part, Seam::Continuous).unwrap();
        }
        let mut right = parts.pop().unwrap();
        while let Some(mut part) = parts.pop() {
            part.merge(&right, Seam::Continuous).unwrap();
            right = part;
        }
        let exact = products(&layout, &[channels]);
        for merged in [left, right] {
            prop_assert_eq!(merged.rows(), layout.rows(length));
            let found = merged.gram().unwrap();
            prop_assert!(worst(&found, &exact) < 4.0 * found.rounding());
        }
    }
}

#[test]
fn long_sums_of_integers_are_exact() {
    // Products below 2^60 and sums below 2^75: an exact answer in 128-bit integers, and more than a double holds.
    let mut state = 1_u64;
    let mut integers = |n: usize| -> Vec<i64> {
        let mut next = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            i64::from(u32::try_from(state >> 34).unwrap()) - (1 << 29)
        };
        (0..n).map(|_| next()).collect()
    };
    let n = 30_000;
    let channels = [integers(n), integers(n)];
    let floats: Vec<Vec<f64>> =
        channels.iter().map(|c| c.iter().map(|x| *x as f64).collect()).collect();
    let lags = [0_isize, 1, 2, 9, 30, 31, 100];
    let columns: Vec<Column> =
        (0..2).flat_map(|c| lags.map(|lag| Column::new(c, lag - 50))).collect();
    let layout = Layout::new(2, columns.clone()).unwrap();
    let found = gram(&layout, &record(&floats), &Options::default()).unwrap();
    let rows = n - 100;
    assert_eq!(found.rows(), rows);
    let sample = |c: &Column, k: usize| {
        i128::from(channels[c.channel][k.checked_add_signed(c.lag + 50).unwrap()])
    };
    for (i, a) in columns.iter().enumerate() {
        for (j, b) in columns.iter().enumerate() {
            let exact: i128 = (0..rows).map(|k| sample(a, k) * sample(b, k)).sum();
            let entry = found.entry(i, j).unwrap();
            #[expect(clippy::cast_possible_truncation, reason = "integers below 2^80")]
            let value = entry.high() as i128 + entry.low().round() as i128;
            // The sums have 75 bits, and what is lost is below 2^-100 of them.
            assert_eq!(value, exact, "{a:?} {b:?}");
        }
    }
}

#[test]
fn signals_that_grow_or_decay_lose_little_and_say_so() {
    // By 1e7, 1e28 over the 80 samples of the lags, and by 1e140 over the record.
    for (base, most) in [(1.2_f64, 1e-21), (0.8, 1e-21), (2.25, f64::INFINITY)] {
        let signal: Vec<f64> =
            (0..400).map(|k| base.powi(k) * (1.0 + 0.1 * f64::from(k).sin())).collect();
        let lags = [0, 1, 7, 40, 80];
        let layout = Layout::new(1, lags.map(|lag| Column::new(0, lag)).to_vec()).unwrap();
        let found = gram(&layout, &[&signal], &Options::default()).unwrap();
        let error = worst(&found, &products(&layout, &[vec![signal]]));
        assert!(error < 4.0 * found.rounding(), "{base}: {error:e} {:e}", found.rounding());
        assert!(found.rounding() < most, "{base}: {:e}", found.rounding());
    }
}

#[test]
fn centring_subtracts_the_mean_of_each_row() {
    let signal: Vec<f64> = (0..500).map(|k| 1e6 + f64::from(k * k % 37)).collect();
    let small: Vec<f64> = (0..500).map(|k| f64::from(k * k % 37)).collect();
    let layout = Layout::block_hankel(1, 6).unwrap();
    let options = Options::default();
    let offset = gram(&layout, &[&signal], &options).unwrap();
    let found = offset.centred();
    let plain = gram(&layout, &[&small], &options).unwrap();
    let mean = |lag: usize| small[lag..lag + 495].iter().sum::<f64>() / 495.0;
    for i in 0..6 {
        assert!((offset.means()[i] - 1e6 - mean(i)).abs() < 1e-9);
        for j in 0..6 {
            let expected = plain.matrix().unwrap()[(i, j)] - 495.0 * mean(i) * mean(j);
            let value = found.matrix().unwrap()[(i, j)];
            assert!((value - expected).abs() < 1e-12 * expected.abs().max(495.0), "{i} {j}");
        }
    }
    assert!(found.rounding() > 1e6 * offset.rounding());
    assert!(found.means().iter().all(|mean| mean.abs() < 1e-300));
}

#[test]
fn the_estimate_of_the_rounding_is_neither_blind_nor_lazy() {
    // One large sample among small ones makes the biased sums coarse, and the estimate says so.
    let noise: Vec<f64> = (0..4000).map(|k| (f64::from(k) * 0.7).sin()).collect();
    let mut spike = noise.clone();
    spike[2000] = 1e3;
    let layout = Layout::block_hankel(1, 8).unwrap();
    for (signal, lowest, highest) in [(noise, 1e-32, 1e-29), (spike, 1e-32, 1e-27)] {
        let found = gram(&layout, &[&signal], &Options::default()).unwrap();
        let error = worst(&found, &products(&layout, &[vec![signal]]));
        assert!(error < 4.0 * found.rounding(), "{error:e} {:e}", found.rounding());
        assert!((lowest..highest).contains(&found.rounding()), "{:e}", found.rounding());
    }
}
