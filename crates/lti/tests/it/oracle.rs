//! Seven systems against 60-digit values (`tests/data/oracle.json`).

use lti::{Continuous, Discrete, Mode, SamplePeriod, StateSpace, Transmissibility};
use nalgebra::DMatrix;
use poly::MrootsOptions;
use serde_json::Value;

use crate::data::{
    complex, complexes, distances, entrywise, matrix, number, numbers, oracle, relative,
    worst_relative,
};

/// Two units in the last place: what "correct but for the last rounding" allows.
const LAST_DIGIT: f64 = 4.5e-16;

struct Case {
    name: String,
    expected: Value,
    system: StateSpace<Continuous>,
    period: SamplePeriod,
}

fn cases() -> Vec<Case> {
    let file = oracle();
    let systems = file.as_object().expect("an object of systems");
    assert_eq!(systems.len(), 7);
    let case = |(name, v): (&String, &Value)| Case {
        name: name.clone(),
        expected: v.clone(),
        system: StateSpace::<Continuous>::new(
            matrix(&v["A"]),
            matrix(&v["B"]),
            matrix(&v["C"]),
            matrix(&v["D"]),
        )
        .expect("a system"),
        period: SamplePeriod::new(number(&v["period_s"])).expect("a period"),
    };
    systems.iter().map(case).collect()
}

/// Without the zeros at the end that stand for vanishing leading coefficients.
fn coefficients(value: &Value) -> Vec<f64> {
    let mut list = numbers(value);
    while list.last() == Some(&0.0) {
        list.pop();
    }
    list
}

#[test]
fn zero_order_hold() {
    for Case { name, expected, system, period } in cases() {
        let sampled = system.zoh(period).expect("samples");
        let (ad, bd) = (matrix(&expected["Ad"]), matrix(&expected["Bd"]));
        let error = relative(sampled.a(), &ad).max(relative(sampled.b(), &bd));
        // Measured: at most 3.6e-16, but for 1.1e-15 in odd units.
        assert!(error < 2e-15, "{name}: {error:e}");
        // Small entries too; the limit is set by entries that are small by cancellation. Measured: 5.9e-14.
        let small = entrywise(sampled.a().as_slice(), ad.as_slice());
        assert!(small < 2e-13, "{name}: {small:e} entry by entry");
    }
}

#[test]
fn inverse_zero_order_hold() {
    for Case { name, expected, system, period } in cases() {
        let sampled = StateSpace::<Discrete>::new(
            matrix(&expected["Ad"]),
            matrix(&expected["Bd"]),
            system.c().clone(),
            system.d().clone(),
            period,
        )
        .expect("a system");
        let back = sampled.inverse_zoh_with_residual().expect("a logarithm");
        // The rounding of Ad moves its fast pole, exp(-20) in `stiff`, by 1e-16 / 2e-9; the B of `nonnormal` is a
        // difference of terms a million times larger.
        let limit = match name.as_str() {
            "stiff" => 1e-7,
            "nonnormal" => 1e-9,
            _ => 1e-14,
        };
        let error =
            relative(back.system.a(), system.a()).max(relative(back.system.b(), system.b()));
        assert!(error < limit, "{name}: {error:e}");
        assert!(back.residual < limit, "{name}: residual {:e}", back.residual);
    }
}

#[test]
fn poles_are_correct_to_the_last_digit() {
    for Case { name, expected, system, .. } in cases() {
        let poles = system.poles().expect("poles");
        let error = worst_relative(&poles, &complexes(&expected["poles"]));
        assert!(error <= LAST_DIGIT, "{name}: {error:e}");
    }
}

#[test]
fn poles_of_the_sampled_system_are_as_good_as_its_entries() {
    for Case { name, expected, system, period } in cases() {
        let sampled = system.zoh(period).expect("samples");
        let error = distances(&sampled.poles().expect("poles"), &complexes(&expected["poles_z"]));
        let worst = error.iter().copied().fold(0.0, f64::max);
        // Absolute, the largest poles being about 1. In odd units and for large couplings the condition number
        // in the given coordinates is large, and yet the error is small.
        assert!(worst < 1e-15, "{name}: {worst:e}");
    }
}

#[test]
fn polynomials_are_correct_to_the_last_digit() {
    for Case { name, expected, system, .. } in cases() {
        let found = system.resolvent_numerators().expect("polynomials");
        let error = entrywise(found.delta.coefficients(), &numbers(&expected["delta"]));
        assert!(error <= LAST_DIGIT, "{name}: delta {error:e}");
        for i in 0..system.outputs() {
            for j in 0..system.inputs() {
                // Lengths have to agree: leading and trailing zeros of the numerators are found exactly.
                let error = entrywise(
                    found.numerators[i][j].coefficients(),
                    &coefficients(&expected["gamma"][i][j]),
                );
                assert!(error <= LAST_DIGIT, "{name}: numerator {i} {j} {error:e}");
            }
        }
    }
}

#[test]
fn zeros_of_single_channels() {
    for Case { name, expected, system, .. } in cases() {
        for i in 0..system.outputs() {
            for j in 0..system.inputs() {
                let found = system
                    .subsystem(&[i], &[j])
                    .and_then(|part| part.invariant_zeros())
                    .expect("zeros");
                let wanted = complexes(&expected["zeros"][i][j]);
                assert_eq!(found.normal_rank, 1);
                assert!(found.largest_dropped < 1e-15 && found.smallest_kept > 1e-3, "{name}");
                let error = distances(&found.values(), &wanted).into_iter().fold(0.0, f64::max);
                // The pendulum's angle has a double zero at 0, which splits by the root of the rounding error.
                let double = name == "cart_and_pendulum" && i == 1;
                assert!(error < if double { 1e-6 } else { 1e-13 }, "{name} {i} {j}: {error:e}");
                let condition = found.zeros.iter().map(|zero| zero.condition).fold(0.0, f64::max);
                assert_eq!(condition > 1e6, double, "{name} {i} {j}: condition {condition:e}");
                for zero in &found.zeros {
                    assert!(zero.residual < 1e-15, "{name}: residual {:e}", zero.residual);
                }
                if !double {
                    let relative = worst_relative(&found.values(), &wanted);
                    assert!(relative <= LAST_DIGIT, "{name} {i} {j}: {relative:e}");
                }
            }
        }
    }
}

#[test]
fn zeros_of_square_parts() {
    for Case { name, expected, system, .. } in cases() {
        let channels: Vec<usize> =
            (0..usize::try_from(expected["square"].as_u64().expect("a count")).expect("small"))
                .collect();
        let part = system.subsystem(&channels, &channels).expect("a part");
        let found = part.invariant_zeros().expect("zeros");
        assert_eq!(found.normal_rank, channels.len());
        let error = worst_relative(&found.values(), &complexes(&expected["square_zeros"]));
        assert!(error <= LAST_DIGIT, "{name}: {error:e}");
    }
}

#[test]
fn zeros_from_the_transfer_function_agree() {
    for Case { name, expected, system, .. } in cases() {
        let g = system.transfer_function(0, 0).expect("a transfer function");
        let zeros = poly::mroots(g.numerator(), &MrootsOptions::default()).expect("roots").values();
        let error = worst_relative(&zeros, &complexes(&expected["zeros"][0][0]));
        assert!(error < 1e-12, "{name}: {error:e}");
    }
}

#[test]
fn frequency_response_is_correct_to_the_last_digit() {
    for Case { name, expected, system, .. } in cases() {
        let frequencies = numbers(&expected["frequencies_rad_s"]);
        let found = system.frequency_response(&frequencies).expect("a response");
        for (k, g) in found.iter().enumerate() {
            for i in 0..system.outputs() {
                for j in 0..system.inputs() {
                    let wanted = complex(&expected["response"][k][i][j]);
                    let error = (g[(i, j)] - wanted).norm() / wanted.norm();
                    assert!(error <= LAST_DIGIT, "{name} at {} rad/s: {error:e}", frequencies[k]);
                }
            }
        }
    }
}

#[test]
fn modes_belong_to_their_vectors() {
    for Case { name, system, period, .. } in cases() {
        let sampled = system.zoh(period).expect("samples");
        let check = |a: &DMatrix<f64>, mode: &Mode, value: num_complex::Complex<f64>| {
            let a = a.map(|x| num_complex::Complex::new(x, 0.0));
            let v = mode.eigenvector.as_ref().expect("a vector");
            let w = mode.left_eigenvector.as_ref().expect("a vector");
            assert!((v.norm() - 1.0).abs() < 1e-14);
            let residual = (&a * v - v * value).norm() / a.norm();
            assert!(residual < 1e-14, "{name}: {residual:e}");
            let residual = (a.adjoint() * w - w * value.conj()).norm() / (a.norm() * w.norm());
            assert!(residual < 1e-14, "{name}: {residual:e}");
            let condition = mode.condition.expect("a condition number");
            if condition < 1e10 {
                assert!(
                    (w.dotc(v) - 1.0).norm() < 1e-5 && (w.norm() / condition - 1.0).abs() < 1e-5
                );
            }
        };
        for mode in system.modes().expect("modes") {
            check(system.a(), &mode, mode.eigenvalue);
        }
        for mode in sampled.modes().expect("modes") {
            check(sampled.a(), &mode, mode.discrete_eigenvalue.expect("z"));
        }
    }
}

#[test]
fn records_obey_the_transmissibility_whatever_the_excitation() {
    for Case { name, system, period, .. } in cases() {
        if system.outputs() < 2 || name == "aircraft_in_odd_units" {
            continue;
        }
        let sampled = system.zoh(period).expect("samples");
        let n = system.order();
        let input = DMatrix::from_fn(system.inputs(), 60, |i, k| {
            if i == 0 { ((k * k) as f64).sin() } else { 0.0 }
        });
        let initial = nalgebra::DVector::from_fn(n, |i, _| 0.3 * (i as f64 + 1.0));
        let response = sampled.simulate(&input, Some(&initial)).expect("a response").outputs;
        let records: Vec<Vec<f64>> =
            response.row_iter().map(|row| row.iter().copied().collect()).collect();
        let channels = lti::Channels { excitation: 0, from_output: 0, to_output: 1 };
        let t = Transmissibility::between(&sampled, channels).expect("a transmissibility");
        let residual = t.relation_residual(&records[0], &records[1]);
        assert_eq!(
            residual.len(),
            60 - t.denominator().degree().max(t.numerator().degree()).expect("not zero")
        );
        let size = |p: &poly::Poly<f64>| p.coefficients().iter().map(|c| c.abs()).sum::<f64>();
        let largest = |y: &[f64]| y.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let scale = size(t.denominator()) * largest(&records[1])
            + size(t.numerator()) * largest(&records[0]);
        let worst = largest(&residual) / scale;
        assert!(worst < 1e-14, "{name}: {worst:e}");
        // The other direction of excitation gives another relation.
        let swapped = t.relation_residual(&records[1], &records[0]);
        assert!(largest(&swapped) / scale > 1e-8, "{name}");
    }
}
