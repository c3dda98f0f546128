use super::*;
use crate::{ConstantTerm, Orders};

#[test]
fn equations_use_every_sample_and_none_beyond() {
    // 8 samples, l = 3, r = 1, d = 2: steps k = 1 .. 4, so y_o runs to 7 and y_i from 0 to 6.
    let input: Vec<f64> = (0..8).map(f64::from).collect();
    let output: Vec<f64> = (0..8).map(|i| f64::from(10 * i)).collect();
    let segment = Segment::new(&input, &output).unwrap();
    let structure = Structure::new(Orders::new(3, 1, 2).unwrap(), ConstantTerm::Omitted);
    let rows = Rows::new(&[segment], &structure);
    assert_eq!((rows.input_exponent, rows.output_exponent), (2, 6));
    let block = rows.block(&rows.segments[0], 1, 4);
    for i in 0..4 {
        let k = (i + 1) as f64;
        let expected = [
            -10.0 * (k + 1.0) / 64.0,
            -10.0 * (k + 2.0) / 64.0,
            (k + 2.0) / 4.0,
            (k + 1.0) / 4.0,
            k / 4.0,
            (k - 1.0) / 4.0,
            10.0 * (k + 3.0) / 64.0,
        ];
        for (found, expected) in block.row(i).iter().zip(expected) {
            assert_eq!(found.to_bits(), expected.to_bits());
        }
    }
    assert_eq!(rows.triangle().rows(), 4);
}
