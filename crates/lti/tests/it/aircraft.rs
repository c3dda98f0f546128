//! The paper's aircraft against `tests/data/aircraft.json`.
//!
//! The file's A and B are rounded; its results come from the unrounded ones. So the limits allow for the condition.

use lti::{
    Channels, Continuous, Discrete, ExcitationPair, PairChannels, SamplePeriod, StateSpace,
    Transmissibility, z_to_s,
};
use nalgebra::DMatrix;
use serde_json::Value;

use crate::data::{aircraft, complexes, entrywise, matrix, numbers, relative, worst_relative};

const SENSORS: [&str; 3] = ["sideslip", "roll_rate", "yaw_rate"];
const CONTROLS: [&str; 2] = ["aileron", "rudder"];

fn continuous(values: &Value) -> StateSpace<Continuous> {
    let c = DMatrix::identity(3, 4);
    StateSpace::<Continuous>::new(
        matrix(&values["A"]),
        matrix(&values["B"]),
        c,
        DMatrix::zeros(3, 2),
    )
    .expect("the aircraft")
}

fn period() -> SamplePeriod {
    SamplePeriod::new(0.1).expect("positive")
}

fn both() -> [Value; 2] {
    let file = aircraft();
    [file["as_printed"].clone(), file["dimensional"].clone()]
}

#[test]
fn sampled_matrices() {
    for values in both() {
        let sampled = continuous(&values).zoh(period()).expect("samples");
        assert!(relative(sampled.a(), &matrix(&values["Ad"])) < 3e-16);
        assert!(relative(sampled.b(), &matrix(&values["Bd"])) < 3e-16);
        assert!(entrywise(sampled.b().as_slice(), matrix(&values["Bd"]).as_slice()) < 5e-15);
    }
}

#[test]
fn the_way_back_from_the_sampled_matrices() {
    for values in both() {
        let system = continuous(&values);
        let (ad, bd) = (matrix(&values["Ad"]), matrix(&values["Bd"]));
        let sampled =
            StateSpace::<Discrete>::new(ad, bd, system.c().clone(), system.d().clone(), period())
                .expect("the sampled aircraft");
        let back = sampled.inverse_zoh().expect("a logarithm");
        assert!(relative(back.a(), system.a()) < 1e-14);
        assert!(relative(back.b(), system.b()) < 1e-14);
    }
}

#[test]
fn spectrum() {
    let file = aircraft();
    for values in both() {
        let system = continuous(&values);
        assert!(
            worst_relative(&system.poles().expect("poles"), &complexes(&file["spec_A"])) < 1e-13
        );
        let sampled = system.zoh(period()).expect("samples");
        let z = sampled.poles().expect("poles");
        assert!(worst_relative(&z, &complexes(&values["spec_Ad"])) < 1e-15);
        // The spiral at -0.00156 1/s comes back from z = 0.99984 with the digits that z has left.
        let s: Vec<_> = z.iter().map(|&z| z_to_s(z, period()).expect("not 0")).collect();
        assert!(worst_relative(&s, &complexes(&file["spec_A"])) < 1e-11);
    }
}

#[test]
fn numerators_and_their_zeros() {
    for values in both() {
        let sampled = continuous(&values).zoh(period()).expect("samples");
        let found = sampled.resolvent_numerators().expect("polynomials");
        let mut delta = numbers(&values["delta"]);
        delta.reverse();
        assert!(entrywise(found.delta.coefficients(), &delta) < 1e-15);
        for (i, sensor) in SENSORS.iter().enumerate() {
            for (j, control) in CONTROLS.iter().enumerate() {
                let mut gamma = numbers(&values[format!("gamma_{sensor}_{control}")]);
                gamma.reverse();
                let size = gamma.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
                let got = found.numerators[i][j].coefficients();
                assert_eq!(got.len(), gamma.len());
                let error =
                    got.iter().zip(&gamma).map(|(x, y)| (x - y).abs() / size).fold(0.0, f64::max);
                assert!(error < 1e-14, "{sensor} {control}: {error:e}");

                let wanted = complexes(&values[format!("zeros_{sensor}_{control}")]);
                let part = sampled.subsystem(&[i], &[j]).expect("a channel");
                let zeros = part.invariant_zeros().expect("zeros").values();
                let error = worst_relative(&zeros, &wanted);
                // Two zeros of sideslip to rudder are 0.009 apart; that multiplies the rounding of A and B.
                assert!(error < 1e-11, "{sensor} {control}: {error:e}");
            }
        }
    }
}

#[test]
fn zeros_of_a_transmissibility_are_zeros_of_channels() {
    for values in both() {
        let sampled = continuous(&values).zoh(period()).expect("samples");
        let channels = Channels { excitation: 0, from_output: 0, to_output: 2 };
        let t = Transmissibility::between(&sampled, channels).expect("a transmissibility");
        let zeros = t.zeros().expect("roots").values();
        let poles = t.poles().expect("roots").values();
        assert!(worst_relative(&zeros, &complexes(&values["zeros_yaw_rate_aileron"])) < 1e-12);
        assert!(worst_relative(&poles, &complexes(&values["zeros_sideslip_aileron"])) < 1e-12);
    }
}

#[test]
fn extra_roots_of_the_determinant_are_invariant_zeros() {
    for values in both() {
        let sampled = continuous(&values).zoh(period()).expect("samples");
        for (other, sensor) in [(1, "roll_rate"), (2, "yaw_rate")] {
            let all = complexes(&values[format!("mroots_det_Delta_sideslip_{sensor}")]);
            let poles = sampled.poles().expect("poles");
            let part = sampled.subsystem(&[0, other], &[0, 1]).expect("a part");
            let zeros = part.invariant_zeros().expect("zeros");
            assert_eq!((zeros.zeros.len(), zeros.normal_rank), (2, 2));
            let together: Vec<_> = poles.into_iter().chain(zeros.values()).collect();
            let error = worst_relative(&together, &all);
            assert!(error < 1e-12, "{sensor}: {error:e}");
        }
    }
}

#[test]
fn a_pair_of_excitations() {
    let [values, _] = both();
    let sampled = continuous(&values).zoh(period()).expect("samples");
    let channels = PairChannels { excitations: [0, 1], from_output: 0, to_output: 1 };
    let pair = ExcitationPair::between(&sampled, channels).expect("a pair");
    let found = sampled.resolvent_numerators().expect("polynomials").numerators;
    assert_eq!(pair.gamma_i1, found[0][0]);
    assert_eq!(pair.gamma_o1, found[1][0]);
    assert_eq!(pair.gamma_i2, found[0][1]);
    assert_eq!(pair.gamma_o2, found[1][1]);
    let [first, second] = pair.transmissibilities().expect("two transmissibilities");
    assert_eq!(first.denominator(), &found[0][0]);
    assert_eq!(second.numerator(), &found[1][1]);
}
