use cfi_ident::{ConstantTerm, Orders};

use super::*;

fn signal(k: u32) -> f64 {
    f64::from(k * k % 97) - 48.0
}

/// 500 samples of a pair of signals with four gaps; one is two samples wide.
fn pair() -> [Vec<f64>; 2] {
    let output = |k: u32| 2.0 * signal(k) - signal(k + 3) + f64::from(k % 3);
    let mut pair = [(0..500).map(signal).collect::<Vec<_>>(), (0..500).map(output).collect()];
    for (channel, sample) in [(0, 0), (1, 100), (0, 101), (1, 250), (0, 499)] {
        pair[channel][sample] = f64::NAN;
    }
    pair
}

fn sums(pair: &[Vec<f64>; 2], piece: usize) -> Sums {
    let orders = Orders::new(1, 2, 3).unwrap();
    let structure = Structure::new(orders, ConstantTerm::Included);
    let mut sums = Sums::new(&structure, &FitOptions::default()).unwrap();
    for (index, (input, output)) in pair[0].chunks(piece).zip(pair[1].chunks(piece)).enumerate() {
        let first = (index * piece) as u64;
        sums.push(&Block { first, input, output }).unwrap();
    }
    sums
}

#[test]
fn blocks_leave_no_trace() {
    let pair = pair();
    let whole = sums(&pair, 500);
    assert_eq!((whole.segments, whole.missing), (3, 5));
    let fit = whole.fit().unwrap();
    // 99, 148 and 248 samples, each less r = 2 and d = 3.
    assert_eq!(fit.equations, 94 + 143 + 243);
    for piece in [1, 2, 50, 100, 101, 102, 250, 499] {
        let cut = sums(&pair, piece);
        assert_eq!((cut.segments, cut.missing), (3, 5), "{piece}");
        assert_eq!(cut.fit().unwrap(), fit, "{piece}");
    }
}

#[test]
fn the_place_of_an_infinite_sample_counts_from_the_start_of_the_file() {
    let [input, mut output] = pair();
    output[321] = f64::INFINITY;
    let mut sums = sums(&pair(), 500);
    let block = Block { first: 300, input: &input[300..400], output: &output[300..400] };
    match sums.push(&block) {
        Err(StreamError::Infinite { sample: 321, side: Side::Output, .. }) => {}
        other => panic!("{other:?}"),
    }
}
