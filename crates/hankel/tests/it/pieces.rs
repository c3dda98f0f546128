//! The same bits, however the work is cut.

use hankel::{Accumulator, Column, Gram, Layout, Missing, Options, Seam, gram};
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use rand_distr::{Distribution, StandardNormal};

fn noise(n: usize, seed: u64) -> Vec<f64> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    StandardNormal.sample_iter(&mut random).take(n).collect()
}

fn cfi() -> Layout {
    let mut columns: Vec<Column> = (1..4).map(|lag| Column::new(1, lag)).collect();
    columns.extend((-25..=25).map(|lag| Column::new(0, lag)));
    columns.push(Column::new(1, 4));
    Layout::new(2, columns).unwrap()
}

fn bits(gram: &Gram) -> Vec<(u64, u64)> {
    let (height, width) = gram.shape();
    let each = (0..width).flat_map(|j| (0..height).map(move |i| (i, j)));
    each.map(|(i, j)| gram.entry(i, j).unwrap())
        .map(|x| (x.high().to_bits(), x.low().to_bits()))
        .collect()
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let (u, y) = (noise(300_000, 1), noise(300_000, 2));
    for layout in [cfi(), Layout::block_hankel(2, 7).unwrap()] {
        let with = |threads| {
            let options = Options { threads, ..Options::default() };
            let gram = gram(&layout, &[&u, &y], &options).unwrap();
            let solved = gram.least_squares(0, None).unwrap();
            let refined = solved.refined(&layout, &[&u, &y], &options, 3).unwrap();
            (bits(&gram), refined.coefficients, refined.residual_norm.to_bits())
        };
        let one = with(1);
        for threads in [2, 3, 8] {
            assert!(with(threads) == one, "{threads} threads");
        }
    }
}

#[test]
fn any_cutting_into_pieces_gives_the_same_bits() {
    let (u, y) = (noise(20_000, 3), noise(20_000, 4));
    let layout = cfi();
    let whole = gram(&layout, &[&u, &y], &Options::default()).unwrap();
    for piece in [1, 54, 1983, 1984, 1985, 7000] {
        let mut accumulator = Accumulator::new(&layout, &Options::default()).unwrap();
        for (u, y) in u.chunks(piece).zip(y.chunks(piece)) {
            accumulator.push(&[u, y]).unwrap();
        }
        assert_eq!(bits(&accumulator.gram().unwrap()), bits(&whole), "pieces of {piece}");
    }
}

#[test]
fn missing_samples_are_gaps() {
    let (mut u, y) = (noise(9000, 5), noise(9000, 6));
    let layout = cfi();
    let mut accumulator = Accumulator::new(&layout, &Options::default()).unwrap();
    for (from, to) in [(0, 10), (11, 5000), (5002, 9000)] {
        accumulator.push(&[&u[from..to], &y[from..to]]).unwrap();
        accumulator.gap();
    }
    let cut = accumulator.gram().unwrap();
    for missing in [10, 5000, 5001] {
        u[missing] = f64::NAN;
    }
    let options = Options { missing: Missing::Gap, ..Options::default() };
    let found = gram(&layout, &[&u, &y], &options).unwrap();
    assert_eq!(found.rows(), cut.rows());
    assert_eq!(bits(&found), bits(&cut));
    // A piece at a time, with the gap at the end of one piece and at the start of another.
    let mut pushed = Accumulator::new(&layout, &options).unwrap();
    for (from, to) in [(0, 11), (11, 5001), (5001, 9000)] {
        pushed.push(&[&u[from..to], &y[from..to]]).unwrap();
    }
    assert_eq!(bits(&pushed.gram().unwrap()), bits(&cut));
}

#[test]
fn parts_meet_as_in_one_reading_wherever_the_gaps_are() {
    let options = Options { missing: Missing::Gap, ..Options::default() };
    let layout = Layout::new(1, vec![Column::new(0, 0), Column::new(0, 2)]).unwrap();
    for gaps in 0..1 << 7 {
        let record: Vec<f64> =
            (0..7).map(|k| if gaps >> k & 1 == 1 { f64::NAN } else { f64::from(k + 1) }).collect();
        let mut whole = Accumulator::new(&layout, &options).unwrap();
        whole.push(&[&record]).unwrap();
        for (a, b) in (0..=7).flat_map(|a| (a..=7).map(move |b| (a, b))) {
            let part = |from: usize, to: usize| {
                let mut part = Accumulator::new(&layout, &options).unwrap();
                part.push(&[&record[from..to]]).unwrap();
                part
            };
            let (first, second, third) = (part(0, a), part(a, b), part(b, 7));
            let mut left = first.clone();
            left.merge(&second, Seam::Continuous).unwrap();
            left.merge(&third, Seam::Continuous).unwrap();
            let mut right = second;
            right.merge(&third, Seam::Continuous).unwrap();
            let mut joined = first;
            joined.merge(&right, Seam::Continuous).unwrap();
            for merged in [left, joined] {
                assert_eq!(merged.rows(), whole.rows(), "{record:?} cut at {a} and {b}");
                if whole.rows() > 0 {
                    // Small integers: every sum is exact.
                    assert_eq!(bits(&merged.gram().unwrap()), bits(&whole.gram().unwrap()));
                }
            }
        }
    }
}

#[test]
fn memory_does_not_grow_with_the_record() {
    let layout = cfi();
    let (u, y) = (noise(5000, 7), noise(5000, 8));
    let mut accumulator = Accumulator::new(&layout, &Options::default()).unwrap();
    let mut sizes = Vec::new();
    for _ in 0..20 {
        accumulator.push(&[&u, &y]).unwrap();
        sizes.push(format!("{accumulator:?}").len());
    }
    // What is printed holds every number that is kept.
    let (early, late) = (sizes[2..6].iter().max().unwrap(), sizes[16..].iter().max().unwrap());
    assert!(late < &(early + early / 2), "{sizes:?}");
}
