//! Tests of `doubled_product.rs`.

use nalgebra::dmatrix;
use num_complex::Complex;

use super::row_product;

#[test]
fn nothing_is_lost_where_terms_cancel() {
    let matrix = dmatrix![0.0, 0.0, 0.0; 1.0, 2.0, -1e20];
    let vector = [Complex::new(3.0, -1.0), Complex::new(0.5e20, 0.5e20), Complex::new(1.0, 1.0)];
    assert_eq!(row_product(&matrix, 1, &vector).value(), Complex::new(3.0, -1.0));
    assert_eq!(row_product(&matrix, 0, &vector).value(), Complex::new(0.0, 0.0));
}
