//! Properties with planted answers: choose poles and zeros, build, recover.

use lti::{Continuous, Discrete, LtiError, SamplePeriod, StateSpace, ZerosOptions};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex;
use poly::Poly;
use proptest::prelude::*;

use crate::data::{distances, relative};

/// A real pole, or a pair.
fn pole(largest_im: f64) -> impl Strategy<Value = Complex<f64>> {
    prop_oneof![
        (-5.0..0.5_f64).prop_map(|re| Complex::new(re, 0.0)),
        ((-2.0..0.2_f64), (0.05..largest_im)).prop_map(|(re, im)| Complex::new(re, im)),
        // On the axis and next to it.
        (prop_oneof![Just(0.0), Just(-1e-7), Just(1e-9)], (0.1..largest_im))
            .prop_map(|(re, im)| Complex::new(re, im)),
    ]
}

/// Poles or zeros with their conjugates; some of them nearly repeated.
fn spectrum(
    count: core::ops::Range<usize>,
    largest_im: f64,
) -> impl Strategy<Value = Vec<Complex<f64>>> {
    (prop::collection::vec(pole(largest_im), count), prop::option::weighted(0.3, 1e-4..1e-2_f64))
        .prop_map(|(mut list, near)| {
            if let (Some(gap), Some(&first)) = (near, list.first()) {
                list.push(first - gap);
            }
            list
        })
}

fn with_conjugates(list: &[Complex<f64>]) -> Vec<Complex<f64>> {
    list.iter().flat_map(|&z| if z.im == 0.0 { vec![z] } else { vec![z, z.conj()] }).collect()
}

/// A block-diagonal matrix with the given spectrum, turned by an orthogonal matrix.
fn turned(list: &[Complex<f64>], angles: &[f64]) -> DMatrix<f64> {
    let n: usize = list.iter().map(|z| if z.im == 0.0 { 1 } else { 2 }).sum();
    let mut a = DMatrix::zeros(n, n);
    let mut k = 0;
    for z in list {
        a[(k, k)] = z.re;
        if z.im != 0.0 {
            a[(k, k + 1)] = z.im;
            a[(k + 1, k)] = -z.im;
            a[(k + 1, k + 1)] = z.re;
            k += 1;
        }
        k += 1;
    }
    let v = DVector::from_fn(n, |i, _| 0.3 + angles[i % angles.len()]);
    let reflection = DMatrix::identity(n, n) - &v * v.transpose() * (2.0 / v.norm_squared());
    &reflection * a * &reflection
}

fn companion(poles: &[Complex<f64>], zeros: &[Complex<f64>]) -> StateSpace<Continuous> {
    let denominator = Poly::real_from_roots(poles).expect("closed under conjugation");
    let numerator = Poly::real_from_roots(zeros).expect("closed under conjugation");
    let n = poles.len();
    let a = DMatrix::from_fn(n, n, |i, j| {
        if i + 1 == n {
            -denominator.coefficient(j)
        } else if j == i + 1 {
            1.0
        } else {
            0.0
        }
    });
    let b = DMatrix::from_fn(n, 1, |i, _| if i + 1 == n { 1.0 } else { 0.0 });
    let c = DMatrix::from_fn(1, n, |_, j| numerator.coefficient(j));
    StateSpace::<Continuous>::new(a, b, c, DMatrix::zeros(1, 1)).expect("a system")
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn planted_poles_come_back(list in spectrum(1..6, 8.0), angles in prop::collection::vec(-1.0..1.0_f64, 4)) {
        let a = turned(&list, &angles);
        let n = a.nrows();
        let system = StateSpace::<Continuous>::new(
            a.clone(), DMatrix::zeros(n, 0), DMatrix::zeros(0, n), DMatrix::zeros(0, 0)).expect("a system");
        let poles = system.poles_with_condition().expect("poles");
        let values: Vec<_> = poles.iter().map(|pole| pole.value).collect();
        // The matrix is normal, but building it rounds: a few units in the last place of its norm.
        let worst = distances(&values, &with_conjugates(&list)).into_iter().fold(0.0, f64::max);
        prop_assert!(worst < 20.0 * f64::EPSILON * a.norm(), "{worst:e}");
        for pole in &poles {
            prop_assert!(pole.condition < 1.0 + 1e-6, "normal: {}", pole.condition);
        }
    }

    #[test]
    fn sampling_and_back(
        list in spectrum(1..5, 8.0),
        angles in prop::collection::vec(-1.0..1.0_f64, 4),
        seconds in 0.01..0.35_f64,
        size in prop_oneof![Just(1e-150), Just(1.0), Just(1e150)],
    ) {
        // |im| T < 2.8 < pi: nothing is folded.
        let a = turned(&list, &angles);
        let n = a.nrows();
        let b = DMatrix::from_fn(n, 2, |i, j| ((i + 2 * j) as f64).cos() * if j == 0 { size } else { 1.0 });
        let system = StateSpace::<Continuous>::new(
            a, b, DMatrix::identity(n, n), DMatrix::zeros(n, 2)).expect("a system");
        let sampled = system.zoh(SamplePeriod::new(seconds).expect("positive")).expect("samples");
        let z: Vec<_> = with_conjugates(&list).iter().map(|s| (s * seconds).exp()).collect();
        let worst = distances(&sampled.poles().expect("poles"), &z).into_iter().fold(0.0, f64::max);
        prop_assert!(worst < 1e-14, "poles {worst:e}");
        let back = sampled.inverse_zoh_with_residual().expect("a logarithm");
        let error = relative(back.system.a(), system.a());
        prop_assert!(error < 1e-12, "A {error:e}");
        for j in 0..2 {
            let error = (back.system.b().column(j) - system.b().column(j)).norm() / system.b().column(j).norm();
            prop_assert!(error < 1e-12, "column {j} of B {error:e}");
        }
        prop_assert!(back.residual < 1e-13);
    }

    #[test]
    fn planted_zeros_come_back(poles in spectrum(2..5, 3.0), zeros in spectrum(0..3, 3.0)) {
        let (mut poles, zeros) = (with_conjugates(&poles), with_conjugates(&zeros));
        while poles.len() <= zeros.len() {
            poles.push(Complex::new(-6.0 - f64::from(u32::try_from(poles.len()).expect("few")), 0.0));
        }
        let system = companion(&poles, &zeros);
        let found = system.invariant_zeros().expect("zeros");
        prop_assert_eq!(found.normal_rank, 1);
        prop_assert_eq!(found.zeros.len(), zeros.len());
        // The coefficients of C are rounded; compare with what the polynomial root finder makes of them, too.
        let limit = found.zeros.iter().map(|zero| zero.condition).fold(1.0, f64::max);
        let worst = distances(&found.values(), &zeros).into_iter().fold(0.0, f64::max);
        let tolerance = 100.0 * f64::EPSILON * limit * (1.0 + system.a().amax());
        prop_assert!(worst < tolerance.max(1e-13) || limit > 1e8, "{:e} {:e}", worst, limit);
        let g = system.transfer_function(0, 0).expect("a transfer function");
        prop_assert_eq!(g.numerator().degree(), Some(zeros.len()));
        prop_assert_eq!(g.denominator().degree(), Some(poles.len()));
    }

    #[test]
    fn values_of_the_transfer_function_agree(
        list in spectrum(1..5, 5.0), angles in prop::collection::vec(-1.0..1.0_f64, 4), omega in 0.01..20.0_f64,
    ) {
        let a = turned(&list, &angles);
        let n = a.nrows();
        let system = StateSpace::<Continuous>::new(
            a,
            DMatrix::from_fn(n, 1, |i, _| 1.0 + angles[i % 4]),
            DMatrix::from_fn(1, n, |_, j| 0.7 - angles[(j + 1) % 4]),
            DMatrix::from_element(1, 1, angles[0]),
        ).expect("a system");
        // Away from the poles, where the polynomials are well conditioned.
        let x = Complex::new(1.5, omega);
        let g = system.transfer_function(0, 0).expect("a transfer function");
        let size = g.numerator().coefficients().iter().enumerate()
            .map(|(k, c)| c.abs() * x.norm().powi(i32::try_from(k).expect("small"))).sum::<f64>();
        let denominator = g.denominator().eval_complex(x);
        let (direct, rational) = (system.evaluate(x).expect("no pole")[0], g.eval_complex(x));
        let scale = size / denominator.norm();
        let conditioning = g.denominator().coefficients().iter().enumerate()
            .map(|(k, c)| c.abs() * x.norm().powi(i32::try_from(k).expect("small"))).sum::<f64>() / denominator.norm();
        prop_assert!((direct - rational).norm() < 1e-14 * scale * conditioning, "{} {}", direct, rational);
    }

    #[test]
    fn simulation_is_convolution(
        list in spectrum(1..4, 5.0), angles in prop::collection::vec(-1.0..1.0_f64, 4),
        input in prop::collection::vec(-1.0..1.0_f64, 0..30),
    ) {
        let a = turned(&list, &angles);
        let n = a.nrows();
        let sampled = StateSpace::<Continuous>::new(
            a, DMatrix::from_element(n, 1, 1.0), DMatrix::from_fn(1, n, |_, j| angles[j % 4]),
            DMatrix::from_element(1, 1, 0.3),
        ).expect("a system").zoh(SamplePeriod::new(0.1).expect("positive")).expect("samples");
        let response = sampled.simulate(&DMatrix::from_row_slice(1, input.len(), &input), None).expect("fits");
        let h: Vec<f64> = sampled.markov_parameters(input.len()).iter().map(|h| h[0]).collect();
        for k in 0..input.len() {
            let wanted: f64 = (0..=k).map(|i| h[i] * input[k - i]).sum();
            prop_assert!((response.outputs[k] - wanted).abs() < 1e-12);
        }
    }

    #[test]
    fn nothing_panics(
        shape in (0..5_usize, 0..4_usize, 0..4_usize),
        entries in prop::collection::vec(
            prop_oneof![
                4 => Just(0.0), 4 => -3.0..3.0_f64, 1 => Just(1.0), 1 => Just(1e150), 1 => Just(-1e-150),
                1 => Just(1e300), 1 => Just(5e-324), 1 => Just(-1e-300),
            ],
            60,
        ),
        seconds in prop_oneof![Just(0.1), Just(1e-300), Just(1e300)],
    ) {
        let (n, m, p) = shape;
        let mut next = entries.iter().copied().cycle();
        let mut fill = |rows, columns| DMatrix::from_fn(rows, columns, |_, _| next.next().expect("a cycle"));
        let (a, b, c, d) = (fill(n, n), fill(n, m), fill(p, n), fill(p, m));
        let period = SamplePeriod::new(seconds).expect("positive");
        let continuous = StateSpace::<Continuous>::new(a.clone(), b.clone(), c.clone(), d.clone()).expect("fits");
        let discrete = StateSpace::<Discrete>::new(a, b, c, d, period).expect("fits");
        let finite = |values: &[Complex<f64>]| values.iter().all(|z| z.re.is_finite() && z.im.is_finite());
        if let Ok(poles) = continuous.poles() {
            prop_assert_eq!(poles.len(), n);
            prop_assert!(finite(&poles));
        }
        let _ = continuous.modes();
        let _ = discrete.modes();
        for found in [continuous.invariant_zeros(), discrete.invariant_zeros()].into_iter().flatten() {
            prop_assert!(found.zeros.len() <= n && found.normal_rank <= m.min(p));
        }
        let _ = continuous.invariant_zeros_with(&ZerosOptions::default());
        if let Ok(sampled) = continuous.zoh(period) {
            let _ = sampled.inverse_zoh();
        }
        let _ = discrete.inverse_zoh();
        let _ = continuous.frequency_response(&[0.0, 1.0, 1e300]);
        let _ = discrete.frequency_response(&[0.0, 1.0, 1e300]);
        let _ = continuous.markov_parameters(4);
        let _ = discrete.simulate(&DMatrix::from_element(m, 3, 1.0), None);
        let _ = continuous.parallel(&continuous);
        match continuous.resolvent_numerators() {
            Ok(found) => prop_assert!(found.delta.coefficients().iter().all(|x| x.is_finite())),
            Err(error) => {
                let overflow = matches!(error, LtiError::Overflow { .. });
                prop_assert!(overflow, "{error}");
            }
        }
    }
}
