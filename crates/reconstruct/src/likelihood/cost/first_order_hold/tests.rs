use nalgebra::DVector;

use super::*;
use crate::likelihood::fixtures::{Normal, system};
use num_complex::Complex;

fn layout(feedthrough: Vec<usize>) -> Layout {
    Layout { order: 4, sensors: 3, records: 2, feedthrough, hold: Hold::FirstOrder }
}

fn planted(eigenvalues: &[Complex<f64>]) -> System {
    let mut normal = Normal::new(8);
    let model = system(eigenvalues, 3, 2, &mut normal);
    let d = (0..2).map(|_| normal.vector(3)).collect();
    System { a: model.a, c: model.c, b: model.b, d, derivatives: None }
}

/// A Dutch roll, a mode that decays quickly, an integrator.
const EIGENVALUES: [Complex<f64>; 3] =
    [Complex::new(0.9, 0.3), Complex::new(0.3, 0.0), Complex::new(1.0, 0.0)];

/// What goes straight from sample to sample, simulated in steps so small that each of them may hold it, agrees with (A, b, C, d).
#[test]
fn it_is_the_response_to_straight_lines() {
    const SUBSTEPS: usize = 400;
    let (decay, turn) = (-0.5_f64, 1.3_f64);
    let growth = Complex::new(decay, turn).exp();
    let a = DMatrix::from_row_slice(2, 2, &[growth.re, growth.im, -growth.im, growth.re]);
    let fine = (Complex::new(decay, turn) / SUBSTEPS as f64).exp();
    let fine_a = DMatrix::from_row_slice(2, 2, &[fine.re, fine.im, -fine.im, fine.re]);
    let rate = DMatrix::from_row_slice(2, 2, &[decay, turn, -turn, decay]);
    let input = DVector::from_column_slice(&[1.0, -0.4]);
    // The input held over one fine step.
    let inverse = rate.clone().try_inverse().unwrap();
    let fine_b = &inverse * (&fine_a - DMatrix::identity(2, 2)) * &input;
    let corners = [0.0, 1.0, -2.0, 0.5, 0.5, 3.0, -1.0, 0.0, 0.0];
    let c = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.3, 1.0]);
    let mut x = DVector::zeros(2);
    let mut read = Vec::new();
    for ends in corners.windows(2) {
        read.push(&c * &x);
        for step in 0..SUBSTEPS {
            let middle = (step as f64 + 0.5) / SUBSTEPS as f64;
            x = &fine_a * x + &fine_b * (ends[0] + middle * (ends[1] - ends[0]));
        }
    }
    // b = T phi_1^2 b_c with T = 1.
    let first = &inverse * (&a - DMatrix::identity(2, 2));
    let b = &first * &first * &input;
    let layout =
        Layout { order: 2, sensors: 2, records: 1, feedthrough: vec![], hold: Hold::FirstOrder };
    let mut system = System { a, c, b: vec![b], d: vec![DVector::zeros(2)], derivatives: None };
    FirstOrder::new(&system.a).unwrap().tie(&mut system, &layout);
    let mut w = DVector::zeros(2);
    for (read, &u) in read.iter().zip(&corners) {
        let y = &system.c * &w + &system.d[0] * u;
        assert!((&y - read).norm() < 1e-5, "{y} for {read}");
        w = &system.a * w + &system.b[0] * u;
    }
}

#[test]
fn the_tangent_is_that_of_what_it_sets() {
    const STEP: f64 = 1e-6;
    for feedthrough in [vec![], vec![1]] {
        let layout = layout(feedthrough.clone());
        let mut here = planted(&EIGENVALUES);
        let hold = FirstOrder::new(&here.a).unwrap();
        hold.tie(&mut here, &layout);
        let tangent = hold.tangent(&here, 1, &layout);
        let locals = layout.shared() + layout.per_record();
        assert_eq!(tangent.shape(), (layout.shared() + 4 + 3, locals));
        for local in 0..locals {
            let moved = |sign: f64| {
                let mut step = DVector::zeros(layout.parameters());
                step[layout.global(local, 1)] = sign * STEP;
                let mut moved = here.moved(&step, &layout);
                FirstOrder::new(&moved.a).unwrap().tie(&mut moved, &layout);
                moved.d[1].clone()
            };
            let slope = (moved(1.0) - moved(-1.0)) / (2.0 * STEP);
            let column = tangent.view((layout.shared() + 4, local), (3, 1)).into_owned();
            assert!((slope - column).norm() < 1e-7, "{feedthrough:?}: parameter {local}");
        }
    }
}

#[test]
fn free_entries_stay() {
    let layout = layout(vec![1]);
    let mut here = planted(&EIGENVALUES);
    let before = here.d.clone();
    FirstOrder::new(&here.a).unwrap().tie(&mut here, &layout);
    for (now, before) in here.d.iter().zip(&before) {
        let moved = (now - before).abs();
        assert!(moved[1] == 0.0 && moved[0] > 0.0 && moved[2] > 0.0, "{moved}");
    }
}
