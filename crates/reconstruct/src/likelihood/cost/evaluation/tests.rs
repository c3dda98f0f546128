use num_complex::Complex;

use super::*;
use crate::likelihood::fixtures::{Disturbance, Normal, fly, system};
use crate::likelihood::options::{Noise, Options};
use crate::model::NoiseSpectrum;
use crate::{Measurement, Offsets, Trend};

fn pair(re: f64, im: f64) -> Complex<f64> {
    Complex::new(re, im)
}

/// A problem with everything that can be in one, at a system that is not the true one.
fn problem(feedthrough: bool, spectra: bool, everything: bool) -> (Problem, System) {
    let mut normal = Normal::new(5);
    // One pole at exactly z = 1, one outside the unit circle.
    let eigenvalues = [pair(0.8, 0.4), pair(1.0, 0.0), pair(1.02, 0.0)];
    let mut model = system(&eigenvalues, 3, 2, &mut normal);
    if feedthrough {
        model.feedthrough = Some(
            (0..2)
                .map(|_| DVector::from_column_slice(&[normal.next(), 0.0, normal.next()]))
                .collect(),
        );
    }
    let known = if everything { 1.0 } else { 0.0 };
    let disturbance = Disturbance { noise: 0.05, offset: 0.3, trend: 0.5, known };
    let samples = [64, 75];
    let flights = fly(&model, &samples, &disturbance, &mut normal);
    let mut options = Options {
        measurement: Measurement {
            known_inputs: flights.known.clone(),
            feedthrough_sensors: if feedthrough { vec![0, 2] } else { Vec::new() },
            ..Measurement::default()
        },
        ..Options::default()
    };
    if everything {
        options.measurement.trend = Trend::Linear;
        options.measurement.offsets = Offsets::PriorDeviation(vec![0.3, 0.2, 0.1]);
    }
    if spectra {
        let spectrum = |samples: usize| {
            let covariances = (0..=samples / 2).map(|_| {
                let root =
                    DMatrix::from_fn(3, 3, |_, _| Complex::new(normal.next(), normal.next()));
                &root * root.adjoint() + DMatrix::identity(3, 3)
            });
            NoiseSpectrum::new(samples, covariances.collect()).unwrap()
        };
        options.noise = Noise::Spectra(samples.map(spectrum).to_vec());
    }
    let layout = Layout {
        order: 4,
        sensors: 3,
        records: 2,
        feedthrough: options.measurement.feedthrough_sensors.clone(),
        hold: Hold::ZeroOrder,
    };
    // The pole at 1 stays where it is: the first frequency hits it.
    let system = System::scaled(&model, &flights.levels, &layout);
    let problem = Problem::new(layout, &flights.records, &flights.levels, &options).unwrap();
    let mut off = |x: f64| x * (1.0 + 0.02 * normal.next());
    let b = system.b.iter().map(|b| b.map(&mut off)).collect();
    let c = system.c.map(&mut off);
    (problem, System { b, c, ..system })
}

fn settle(problem: &Problem, system: System, variances: &[f64]) -> Evaluation {
    let mut found = problem.evaluate_around(system.clone(), problem.no_coefficients(), variances);
    for _ in 0..2 {
        let still = DVector::zeros(problem.layout.parameters());
        let coefficients = found.coefficients_after(&still, &problem.layout);
        found = problem.evaluate_around(system.clone(), coefficients, variances);
    }
    found
}

#[test]
fn the_gradient_is_that_of_the_cost() {
    const STEP: f64 = 1e-5;
    let kinds =
        [(false, false, false), (true, false, false), (false, true, true), (true, false, true)];
    let holds = [Hold::ZeroOrder, Hold::FirstOrder];
    for ((feedthrough, spectra, everything), hold) in
        kinds.into_iter().flat_map(|kind| holds.map(|hold| (kind, hold)))
    {
        let (mut problem, system) = problem(feedthrough, spectra, everything);
        problem.layout.hold = hold;
        let variances = [0.7, 1.0, 1.3];
        let here = settle(&problem, system.clone(), &variances);
        let size = here.descent.norm();
        assert!(size > 1.0);
        for k in 0..problem.layout.parameters() {
            let cost = |sign: f64| {
                let mut step = DVector::zeros(problem.layout.parameters());
                step[k] = sign * STEP;
                settle(&problem, system.moved(&step, &problem.layout), &variances).cost
            };
            let slope = (cost(1.0) - cost(-1.0)) / (2.0 * STEP);
            let error = (slope + 2.0 * here.descent[k]).abs();
            let limit = 1e-5 * here.gram[(k, k)].max(size);
            assert!(
                error < limit,
                "{feedthrough} {spectra} {everything}: parameter {k}: {slope} for {}",
                -2.0 * here.descent[k]
            );
        }
    }
}

#[test]
fn the_gram_matrix_is_that_of_the_prediction() {
    // Brute force: the sensors' prediction C (zI - A)^-1 (b U + z t) + d U with U and t held, differentiated by differences, without feedback.
    const STEP: f64 = 1e-6;
    let (problem, mut system) = problem(true, false, false);
    // No pole on a frequency, so that plain inverses exist.
    system.a *= 0.97;
    let variances = [1.0, 1.0, 1.0];
    let here = settle(&problem, system.clone(), &variances);
    let (record, layout) = (1, &problem.layout);
    let spectrum = &problem.spectra[record];
    let complex = |m: &DMatrix<f64>| m.map(|x| Complex::new(x, 0.0));
    let column = |v: &DVector<f64>| v.map(|x| Complex::new(x, 0.0));
    let t = DVector::from_column_slice(&here.coefficients[record][0][..4]);
    let h = |s: &System, z: Complex<f64>| {
        let pencil = DMatrix::identity(4, 4) * z - complex(&s.a);
        complex(&s.c) * pencil.try_inverse().unwrap()
    };
    let cells = layout.local_cells();
    let mut expected = DMatrix::<f64>::zeros(cells.len(), cells.len());
    let mut cost = 0.0;
    for (k, &z) in spectrum.z.iter().enumerate() {
        let y = DVector::from_column_slice(&spectrum.y[3 * k..3 * k + 3]);
        let g = h(&system, z) * column(&system.b[record]) + column(&system.d[record]);
        let e = y - h(&system, z) * column(&t) * z;
        let u = g.dotc(&e) / g.norm_squared();
        let phi = DMatrix::identity(3, 3) - &g * g.adjoint() / Complex::new(g.norm_squared(), 0.0);
        cost += spectrum.weight[k] * (&phi * &e).norm_squared();
        let predict = |s: &System| {
            h(s, z) * (column(&s.b[record]) * u + column(&t) * z) + column(&s.d[record]) * u
        };
        let columns: Vec<_> = (0..cells.len())
            .map(|local| {
                let mut step = DVector::zeros(layout.parameters());
                step[layout.global(local, record)] = STEP;
                let (up, down) = (system.moved(&step, layout), system.moved(&-step, layout));
                (predict(&up) - predict(&down)) / Complex::new(2.0 * STEP, 0.0)
            })
            .collect();
        for (i, first) in columns.iter().enumerate() {
            for (l, second) in columns.iter().enumerate() {
                expected[(i, l)] += spectrum.weight[k] * first.dotc(&(&phi * second)).re;
            }
        }
    }
    let sums = problem.record_sums(
        record,
        &system,
        &here.coefficients,
        &variances,
        Scalars::Estimated,
        false,
    );
    assert!((sums.cost / cost - 1.0).abs() < 1e-9, "{} for {cost}", sums.cost);
    for i in 0..cells.len() {
        for l in 0..cells.len() {
            let size = (expected[(i, i)] * expected[(l, l)]).sqrt();
            let error = (sums.gram(cells[i], cells[l]) - expected[(i, l)]).abs();
            assert!(error < 1e-7 * size, "{:?} {:?}: {error:e} of {size:e}", cells[i], cells[l]);
        }
    }
}

#[test]
fn invariant_tangents_carry_no_information() {
    let kinds = [
        (false, Hold::ZeroOrder),
        (true, Hold::ZeroOrder),
        (false, Hold::FirstOrder),
        (true, Hold::FirstOrder),
    ];
    for (all, hold) in kinds {
        let (mut problem, system) = problem(all, all, all);
        problem.layout.hold = hold;
        let here = settle(&problem, system, &[1.0; 3]);
        let tangents = here.system.invariant_tangents(&problem.layout);
        for tangent in tangents.column_iter() {
            let information = tangent.dot(&(&here.gram * tangent));
            let size: f64 =
                tangent.iter().zip(here.gram.diagonal().iter()).map(|(t, g)| t * t * g).sum();
            assert!(information.abs() < 1e-9 * size, "{information:e} of {size:e}");
            let slope = tangent.dot(&here.descent).abs();
            assert!(slope < 1e-7 * (size * here.cost).sqrt(), "{slope:e}");
        }
        assert_eq!(problem.layout.identifiable(), if all { 22 } else { 18 });
    }
}

#[test]
fn coefficients_follow_a_step_to_first_order() {
    let (problem, system) = problem(false, false, true);
    let here = settle(&problem, system.clone(), &[1.0; 3]);
    let mut normal = Normal::new(9);
    let direction = normal.vector(problem.layout.parameters());
    let miss = |size: f64| {
        let step = &direction * size;
        let guess = here.coefficients_after(&step, &problem.layout);
        let there = system.moved(&step, &problem.layout);
        let before = problem.evaluate_around(there.clone(), guess, &[1.0; 3]);
        let after = settle(&problem, there, &[1.0; 3]);
        // The cost is stated for the best coefficients, whatever the guess was.
        assert!((before.cost / after.cost - 1.0).abs() < 1e-9);
        let still = DVector::zeros(problem.layout.parameters());
        let best = before.coefficients_after(&still, &problem.layout);
        let distance: f64 =
            best[0][0].iter().zip(&before.coefficients[0][0]).map(|(x, y)| (x - y).powi(2)).sum();
        distance.sqrt()
    };
    let (far, near) = (miss(1e-4), miss(1e-5));
    // What held the residual's part of the derivative out is of first order, too, but small: see the module of the search.
    assert!(near < 0.5 * far, "{near:e} after {far:e}");
}

#[test]
fn a_complement_is_orthonormal() {
    for vector in [vec![1.0, 0.0, 0.0], vec![-2.0, 1.0, 3.0], vec![0.0, 0.0, -1.0]] {
        let vector = DVector::from_vec(vector);
        let basis = complement(&vector);
        assert!((basis.transpose() * &vector).norm() < 1e-14);
        assert!((basis.transpose() * &basis - DMatrix::identity(2, 2)).norm() < 1e-14);
    }
    assert_eq!(complement(&DVector::from_element(1, 3.0)).shape(), (1, 0));
}

#[test]
fn score_and_information_are_those_of_the_restricted_likelihood() {
    const STEP: f64 = 1e-5;
    let (mut problem, system) = problem(false, false, false);
    for spectrum in &mut problem.spectra {
        // Any power serves; this one differs between sensors and frequencies.
        let power = spectrum.y.iter().map(|y| 0.3 + y.norm_sqr());
        spectrum.power = Some(power.collect());
    }
    let variances = [0.8, 1.3, 2.0, 1e-3];
    let objective = |variances: &[f64]| {
        let at = settle(&problem, system.clone(), variances);
        at.cost + at.log_determinant
    };
    let here = settle(&problem, system.clone(), &variances);
    for k in 0..variances.len() {
        let mut moved = [variances; 2];
        moved[0][k] *= 1.0 - STEP;
        moved[1][k] *= 1.0 + STEP;
        let slope = (objective(&moved[1]) - objective(&moved[0])) / (2.0 * STEP * variances[k]);
        let error = (slope + here.score[k]).abs();
        assert!(
            error < 1e-5 * slope.abs().max(here.information[(k, k)] * variances[k]),
            "{k}: {slope} {}",
            here.score[k]
        );
        for l in 0..k {
            assert!(
                (here.information[(k, l)] - here.information[(l, k)]).abs()
                    < 1e-12 * here.information[(k, k)].max(here.information[(l, l)])
            );
        }
    }
    assert!(here.information.clone().cholesky().is_some());
}

#[test]
fn a_system_without_a_first_order_hold_has_no_cost() {
    let (mut problem, system) = problem(false, false, false);
    problem.layout.hold = Hold::FirstOrder;
    let a = DMatrix::from_element(4, 4, f64::NAN);
    let found = problem.evaluate(System { a, ..system }, &[1.0; 3]);
    assert!(found.cost.is_nan());
}
