//! The paper's aircraft without noise: full rank, and parameters as good as the record.

use cfi_ident::{
    CfiModel, ConstantTerm, Engine, Fit, FitOptions, Orders, Prediction, Segment, Structure,
    ZerosAndPoles, fit,
};
use nalgebra::Complex;

use crate::records::{Oracle, aircraft, complex_numbers, noise_free, numbers};

const CASES: [(&str, &str, &str); 4] = [
    ("aileron", "p", "roll_rate"),
    ("aileron", "r", "yaw_rate"),
    ("rudder", "p", "roll_rate"),
    ("rudder", "r", "yaw_rate"),
];

fn structure(constant_term: ConstantTerm) -> Structure {
    Structure::new(Orders::new(4, 25, 25).unwrap(), constant_term)
}

fn fitted(surface: &str, channel: &str, constant_term: ConstantTerm, options: &FitOptions) -> Fit {
    let (input, output) = noise_free(surface, channel);
    fit(&[Segment::new(&input, &output).unwrap()], &structure(constant_term), options).unwrap()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    let norm = |values: &mut dyn Iterator<Item = f64>| values.map(|x| x * x).sum::<f64>().sqrt();
    norm(&mut a.iter().zip(b).map(|(x, y)| x - y)) / norm(&mut b.iter().copied())
}

/// An estimate of the distance from `z` to the nearest root of D, by one Newton step.
fn newton_step(model: &CfiModel, z: Complex<f64>) -> f64 {
    let (value, slope) = model
        .denominator()
        .iter()
        .rev()
        .fold((Complex::new(0.0, 0.0), Complex::new(0.0, 0.0)), |(value, slope), c| {
            (value * z + c, slope * z + value)
        });
    (value / slope).norm()
}

#[test]
fn parameters_are_the_exact_least_squares_solution() {
    let oracle = Oracle::load();
    for (surface, channel, _) in CASES {
        let fit = fitted(surface, channel, ConstantTerm::Omitted, &FitOptions::default());
        let exact = oracle.theta(surface, channel, "exact");
        // Every parameter that does not vanish is the exact solution, correctly rounded or one unit beside it.
        assert!(distance(&fit.model.theta(), &exact) < 2e-16, "{surface} {channel}");
        // Those that vanish, 1e-13 or 1e-17, are right as well.
        for (found, exact) in fit.model.theta().iter().zip(&exact) {
            assert!(
                (found - exact).abs() < 1e-6 * exact.abs(),
                "{surface} {channel}: {found} {exact}"
            );
        }
        assert!(fit.refinement.converged && fit.refinement.steps <= 3, "{:?}", fit.refinement);
    }
}

#[test]
fn sums_in_doubled_precision_are_what_makes_them_exact() {
    let oracle = Oracle::load();
    let reflections = FitOptions { engine: Engine::Qr, ..FitOptions::default() };
    let sums_alone = FitOptions { refinement_steps: 0, ..FitOptions::default() };
    for (surface, channel, _) in CASES {
        let exact = oracle.theta(surface, channel, "exact");
        let found = |options| fitted(surface, channel, ConstantTerm::Omitted, options);
        let error = |options| distance(&found(options).model.theta(), &exact);
        let (in_doubles, doubled) = (error(&reflections), error(&sums_alone));
        assert!((1e-14..1e-10).contains(&in_doubles), "off by the condition: {in_doubles}");
        assert!(doubled < 2e-16, "{doubled}");
        // Each says how far it may be off, and is not.
        let expected = [found(&reflections).expected_error, found(&sums_alone).expected_error];
        assert!(in_doubles < expected[0] && expected[0] < 1e-9, "{in_doubles} {expected:?}");
        assert!(doubled < expected[1] && expected[1] < 1e-14, "{doubled} {expected:?}");
    }
}

#[test]
fn parameters_are_those_of_the_system_to_the_limit_of_the_record() {
    // The record is rounded to 53 bits, so the exact solution for it is off by about 1e-13.
    let oracle = Oracle::load();
    for (surface, channel, _) in CASES {
        let fit = fitted(surface, channel, ConstantTerm::Omitted, &FitOptions::default());
        let error = distance(&fit.model.theta(), &oracle.theta(surface, channel, "true"));
        assert!(error < 1e-12, "{surface} {channel}: {error}");
        assert!(fit.relative_residual < 1e-13, "{surface} {channel}: {}", fit.relative_residual);
    }
}

#[test]
fn rank_is_full_without_the_constant_term() {
    for (surface, channel, _) in CASES {
        let fit = fitted(surface, channel, ConstantTerm::Omitted, &FitOptions::default());
        assert_eq!(
            (fit.rank, fit.singular_values.len(), fit.equations),
            (54, 54, 1950),
            "{surface} {channel}"
        );
        assert!(fit.unidentifiable.is_none());
        assert!((1e5..1e7).contains(&fit.condition), "{}", fit.condition);
        assert_eq!(fit.degrees_of_freedom, 1950 - 54);
    }
}

#[test]
fn constant_term_costs_one_rank_and_names_the_parameters() {
    let reference = aircraft();
    for (surface, channel, name) in CASES {
        let fit = fitted(surface, channel, ConstantTerm::Included, &FitOptions::default());
        assert_eq!((fit.rank, fit.singular_values.len()), (54, 55), "{surface} {channel}");
        let open = fit.unidentifiable.unwrap();
        let names: Vec<String> = open.parameters.iter().map(ToString::to_string).collect();
        assert_eq!(
            names,
            ["c_0", "c_1", "c_2", "c_3", "h_-3", "h_-2", "h_-1", "h_0"],
            "{surface} {channel}"
        );
        // The free direction is a multiple of (gamma_i, gamma_o): D and the FIR factor times one and the same constant.
        let gamma_i = numbers(&reference[format!("gamma_sideslip_{surface}")]);
        let gamma_o = numbers(&reference[format!("gamma_{name}_{surface}")]);
        let mut expected = vec![0.0; 55];
        expected[..4].copy_from_slice(&gamma_i);
        expected[..4].reverse();
        expected[4 + 22..4 + 26].copy_from_slice(&gamma_o);
        let direction = open.directions.column(0);
        let scale = direction[3] / expected[3];
        let expected: Vec<f64> = expected.iter().map(|x| x * scale).collect();
        assert!(distance(direction.as_slice(), &expected) < 1e-8, "{surface} {channel}");
        // Three poles are those of the system all the same, and the fourth is arbitrary.
        for z in complex_numbers(&reference[format!("zeros_sideslip_{surface}")]) {
            assert!(newton_step(&fit.model, z) < 1e-9, "{surface} {channel}: {z}");
        }
    }
}

#[test]
fn poles_are_the_zeros_of_the_sideslip_numerator() {
    let reference = aircraft();
    for (surface, channel, _) in CASES {
        let fit = fitted(surface, channel, ConstantTerm::Omitted, &FitOptions::default());
        for z in complex_numbers(&reference[format!("zeros_sideslip_{surface}")]) {
            let error = newton_step(&fit.model, z);
            assert!(error < 1e-11, "{surface} {channel}: {z} is off by {error}");
        }
    }
}

#[test]
fn four_anticausal_markov_parameters_and_nothing_else() {
    for (surface, channel, _) in CASES {
        let fit = fitted(surface, channel, ConstantTerm::Omitted, &FitOptions::default());
        let largest = fit.model.markov_parameters().iter().fold(0.0, |m: f64, h| m.max(h.abs()));
        assert!(
            fit.model.anticausal()[..4].iter().all(|h| h.abs() > 1e-3 * largest),
            "{surface} {channel}"
        );
        assert!(
            fit.model.anticausal()[4..].iter().all(|h| h.abs() < 1e-12 * largest),
            "{surface} {channel}"
        );
        assert!(
            fit.model.causal().iter().all(|h| h.abs() < 1e-12 * largest),
            "{surface} {channel}"
        );
    }
}

#[test]
fn expansion_of_the_known_transmissibility_is_the_fitted_model() {
    let reference = aircraft();
    for (surface, channel, name) in CASES {
        let fit = fitted(surface, channel, ConstantTerm::Omitted, &FitOptions::default());
        let gain = numbers(&reference[format!("gamma_{name}_{surface}")])[0]
            / numbers(&reference[format!("gamma_sideslip_{surface}")])[0];
        let zeros = complex_numbers(&reference[format!("zeros_{name}_{surface}")]);
        let poles = complex_numbers(&reference[format!("zeros_sideslip_{surface}")]);
        let known = ZerosAndPoles::new(&zeros, &poles, gain).unwrap();
        let expanded = known.cfi(structure(ConstantTerm::Omitted)).unwrap();
        let error = distance(&fit.model.theta(), &expanded.theta());
        assert!(error < 1e-12, "{surface} {channel}: {error}");
    }
}

#[test]
fn prediction_reproduces_the_record() {
    for (surface, channel, _) in CASES {
        let (input, output) = noise_free(surface, channel);
        let fit = fitted(surface, channel, ConstantTerm::Omitted, &FitOptions::default());
        let predicted = fit.model.predict(&input, &output, Prediction::OneStep).unwrap();
        let error = distance(
            &predicted.values,
            &output[predicted.first..predicted.first + predicted.values.len()],
        );
        assert!(error < 1e-12, "{surface} {channel}: {error}");
        let residuals = fit.model.residuals(&input, &output).unwrap();
        let norm = residuals.values.iter().map(|x| x * x).sum::<f64>().sqrt();
        // The fit's norm is computed in doubled precision, this one not: they agree to the rounding of the prediction.
        assert!(
            (norm - fit.residual_norm).abs()
                < 1e-12 * output.iter().map(|x| x * x).sum::<f64>().sqrt()
        );
    }
}

#[test]
fn segments_of_one_record_give_the_same_model() {
    let oracle = Oracle::load();
    let (input, output) = noise_free("rudder", "p");
    let cut = |from: usize, to: usize| Segment::new(&input[from..to], &output[from..to]).unwrap();
    let segments = [cut(0, 700), cut(700, 730), cut(730, 2000)];
    let fit = fit(&segments, &structure(ConstantTerm::Omitted), &FitOptions::default()).unwrap();
    assert_eq!(
        (fit.equations, fit.samples_used, fit.segments_without_equation),
        (650 + 1220, 1970, 1)
    );
    assert!(distance(&fit.model.theta(), &oracle.theta("rudder", "p", "true")) < 1e-12);
}
