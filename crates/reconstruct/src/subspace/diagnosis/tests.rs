use num_complex::Complex;

use super::*;

#[test]
fn doubts_say_their_numbers() {
    let pole = Complex::new(0.9, -0.25);
    let record = || "climb".to_owned();
    let doubts = [
        (
            Doubt::WeakOrder { order: 4, gap: 1.26 },
            "the order 4 is weakly supported: the next eigenvalue is 1.3 times larger, at least 6 would be evidence",
        ),
        (
            Doubt::SeveralExcitations { record: record(), rank: 2, growth: 1.75 },
            "record climb: the signal's rank grows by 1.75 for each block row, so that at least 2 independent excitations act; one is assumed",
        ),
        (
            Doubt::HardlyExcited { pole, record: record(), excitation_snr: 1.5 },
            "record climb shows next to nothing of the mode at z = 0.9000 - 0.2500i: 1.50 of the noise's variance",
        ),
        (
            Doubt::UncertainDirection { record: record(), ambiguity: 0.84 },
            "record climb: the direction of its excitation is hardly determined, another one fits 84 % as well",
        ),
    ];
    for (doubt, expected) in doubts {
        assert_eq!(doubt.to_string(), expected);
    }
}
