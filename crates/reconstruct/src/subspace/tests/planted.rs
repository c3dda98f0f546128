//! Systems with planted answers: recovered without noise, whatever their poles, sensors and records.

use super::*;
use proptest::prelude::*;

/// What the poles of a system are like.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Real,
    Complex,
    Integrator,
    LightlyDamped,
    Unstable,
    /// One Jordan block of size 2.
    Defective,
    /// Twice the same pole with two vectors.
    Repeated,
}

#[derive(Debug)]
struct Plant {
    a: DMatrix<f64>,
    c: DMatrix<f64>,
    b: Vec<DVector<f64>>,
}

/// Real poles and pairs that keep some distance, with the odd ones of the kind first.
fn plant(kind: Kind, order: usize, sensors: usize, records: usize, seed: u64) -> Plant {
    let mut rng = generator(seed);
    let mut a = DMatrix::zeros(order, order);
    let mut real = [0.9, -0.5, 0.6, -0.8, 0.3, 0.75, -0.2, 0.1, 0.45, -0.65].into_iter();
    let mut pairs = [(0.95, 0.3), (0.9, 1.1), (0.85, 2.0), (0.97, 0.7), (0.8, 2.6)].into_iter();
    let mut at = 0;
    let pair = |a: &mut DMatrix<f64>, at: usize, (radius, angle): (f64, f64)| {
        let (s, c) = angle.sin_cos();
        let block = [[radius * c, radius * s], [-radius * s, radius * c]];
        (0..2).for_each(|i| (0..2).for_each(|k| a[(at + i, at + k)] = block[i][k]));
    };
    match kind {
        Kind::Integrator => a[(0, 0)] = 1.0,
        Kind::Unstable => a[(0, 0)] = 1.02,
        Kind::LightlyDamped => pair(&mut a, 0, (0.9995, 0.5)),
        Kind::Defective | Kind::Repeated => {
            a[(0, 0)] = 0.7;
            a[(1, 1)] = 0.7;
            a[(0, 1)] = if kind == Kind::Defective { 1.0 } else { 0.0 };
        }
        Kind::Real | Kind::Complex => {}
    }
    at += match kind {
        Kind::Integrator | Kind::Unstable => 1,
        Kind::LightlyDamped | Kind::Defective | Kind::Repeated => 2,
        Kind::Real | Kind::Complex => 0,
    };
    while at < order {
        if kind != Kind::Real && at + 2 <= order && (kind == Kind::Complex || at % 3 == 0) {
            pair(&mut a, at, pairs.next().unwrap());
            at += 2;
        } else {
            a[(at, at)] = real.next().unwrap();
            at += 1;
        }
    }
    // Another basis, so that nothing is zero.
    let basis = normal(&mut rng, order, order).qr().q();
    let a = &basis * a * basis.transpose();
    let c = normal(&mut rng, sensors, order);
    let b = (0..records).map(|_| normal(&mut rng, order, 1).column(0).into_owned()).collect();
    Plant { a, c, b }
}

/// Records of white excitation from random initial states, each 37 samples longer than the one before.
fn simulate(plant: &Plant, samples: usize, d: Option<&[DVector<f64>]>, seed: u64) -> Vec<Record> {
    let mut rng = generator(seed);
    let each = plant.b.iter().enumerate().map(|(j, b)| {
        let samples = samples + 37 * j;
        let mut x = normal(&mut rng, plant.a.nrows(), 1).column(0).into_owned();
        let mut y = DMatrix::zeros(plant.c.nrows(), samples);
        for k in 0..samples {
            let u: f64 = StandardNormal.sample(&mut rng);
            let direct = d.map_or(DVector::zeros(plant.c.nrows()), |d| &d[j] * u);
            y.set_column(k, &(&plant.c * &x + direct));
            x = &plant.a * x + b * u;
        }
        from_rows(&format!("record {j}"), &y)
    });
    each.collect()
}

/// The observability matrix of so many block rows.
fn observability(a: &DMatrix<f64>, c: &DMatrix<f64>, rows: usize) -> DMatrix<f64> {
    let (m, n) = c.shape();
    let mut o = DMatrix::zeros(m * rows, n);
    let mut block = c.clone();
    for i in 0..rows {
        o.view_mut((i * m, 0), (m, n)).copy_from(&block);
        block *= a;
    }
    o
}

/// The largest relative error of A, C and the directions of b and d, after a change to the planted basis.
fn model_error(plant: &Plant, d: Option<&[DVector<f64>]>, found: &SharedModel) -> f64 {
    let n = plant.a.nrows();
    let planted = observability(&plant.a, &plant.c, n + 1);
    let other = observability(&found.a, &found.c, n + 1);
    let (basis, _) = dense::least_squares(&other, &planted, 1e-14).unwrap();
    let inverse = basis.clone().try_inverse().unwrap();
    let a = (&inverse * &found.a * &basis - &plant.a).norm() / plant.a.norm();
    let c = (&found.c * &basis - &plant.c).norm() / plant.c.norm();
    let mut worst = a.max(c);
    for (j, (b, planted)) in found.b.iter().zip(&plant.b).enumerate() {
        let (mut b, mut planted) = (&inverse * b, planted.clone());
        if let (Some(d), Some(found)) = (d, &found.feedthrough) {
            b = DVector::from_iterator(b.len() + d[j].len(), b.iter().chain(&found[j]).copied());
            planted = DVector::from_iterator(b.len(), planted.iter().chain(&d[j]).copied());
        }
        let factor = b.dot(&planted) / b.norm_squared();
        worst = worst.max((b * factor - &planted).norm() / planted.norm());
    }
    worst
}

const KINDS: [Kind; 7] = [
    Kind::Real,
    Kind::Complex,
    Kind::Integrator,
    Kind::LightlyDamped,
    Kind::Unstable,
    Kind::Defective,
    Kind::Repeated,
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, rng_seed: proptest::test_runner::RngSeed::Fixed(7), ..ProptestConfig::default() })]

    #[test]
    fn planted_systems_are_recovered_without_noise(
        kind in proptest::sample::select(KINDS.to_vec()),
        order in 2..=10_usize,
        sensors in 3..=6_usize,
        records in 2..=5_usize,
        offsets in proptest::sample::select(vec![Offsets::Free, Offsets::Zero]),
        seed in 0..1000_u64,
    ) {
        let plant = plant(kind, order, sensors, records, seed);
        let data = simulate(&plant, 400, None, seed + 1);
        let mut options = fixed(order);
        options.measurement.offsets = offsets;
        let found = identify(&data, &options).unwrap();
        let error = model_error(&plant, None, &found.model);
        prop_assert!(error < 1e-7, "{error:e}");
        prop_assert_eq!(found.doubts, []);

        options.order = OrderChoice::Gap { largest: 12 };
        let found = identify(&data, &options).unwrap();
        prop_assert_eq!(found.order.order, order, "{:?}", found.order.gaps);
        prop_assert!(found.records.iter().all(|record| record.excitation.rank == 1));
    }
}

#[test]
fn two_sensors_and_three_records_are_enough() {
    for order in 2..=8 {
        let plant = plant(Kind::Complex, order, 2, 3, 40 + order as u64);
        let found = identify(&simulate(&plant, 500, None, 3), &fixed(order)).unwrap();
        let error = model_error(&plant, None, &found.model);
        assert!(error < 1e-7, "{order}: {error:e}");
    }
}

#[test]
fn a_direct_path_is_recovered() {
    for seed in 0..5 {
        let plant = plant(Kind::Complex, 4, 3, 3, seed);
        let mut rng = generator(seed + 100);
        let d: Vec<_> = (0..3).map(|_| normal(&mut rng, 3, 1).column(0).into_owned()).collect();
        let mut options = fixed(4);
        options.measurement.feedthrough_sensors = vec![0];
        let found = identify(&simulate(&plant, 500, Some(&d), seed), &options).unwrap();
        let error = model_error(&plant, Some(&d), &found.model);
        assert!(error < 1e-7, "{error:e}");
        assert_eq!(found.doubts, []);
    }
}
