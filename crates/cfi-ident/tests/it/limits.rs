//! The edges: extreme magnitudes, lost rank, hardly enough samples, and what must be refused.

use cfi_ident::{
    CfiModel, ConstantTerm, FitError, FitOptions, Orders, Parameter, Segment, Structure, fit,
};

use crate::planted::{noise, record};

fn structure(l: usize, r: usize, d: usize) -> Structure {
    Structure::new(Orders::new(l, r, d).unwrap(), ConstantTerm::Omitted)
}

fn planted() -> (CfiModel, Vec<f64>, Vec<f64>) {
    let model = CfiModel::new(structure(3, 1, 2), &[0.5, -1.1], &[1.0, -2.0, 0.5, 0.25]).unwrap();
    let (input, output) = record(&model, 120, 0.0, 3);
    (model, input, output)
}

#[test]
fn magnitudes_do_not_matter() {
    let (model, input, output) = planted();
    let check = |input_scale: f64, output_scale: f64| {
        let u: Vec<f64> = input.iter().map(|x| x * input_scale).collect();
        let y: Vec<f64> = output.iter().map(|x| x * output_scale).collect();
        let found =
            fit(&[Segment::new(&u, &y).unwrap()], &model.structure(), &FitOptions::default())
                .unwrap();
        assert_eq!(found.rank, 6, "{input_scale} {output_scale}");
        assert!(found.relative_residual < 1e-14);
        for ((name, planted), found) in
            model.structure().parameters().zip(model.theta()).zip(found.model.theta())
        {
            let unit =
                if matches!(name, Parameter::Markov(_)) { output_scale / input_scale } else { 1.0 };
            assert!(
                (found / unit - planted).abs() < 1e-12,
                "{name}: {found} at {input_scale} {output_scale}"
            );
        }
    };
    for (input_scale, output_scale) in [
        (1e150, 1e150),
        (1e-150, 1e-150),
        (1e-150, 1e150),
        (1e150, 1e-150),
        (1e300, 1e300),
        (1e-290, 1e-290),
    ] {
        check(input_scale, output_scale);
    }
}

#[test]
fn a_parameter_beyond_the_range_of_numbers_is_an_error() {
    let (model, input, output) = planted();
    let u: Vec<f64> = input.iter().map(|x| x * 1e-200).collect();
    let y: Vec<f64> = output.iter().map(|x| x * 1e200).collect();
    let error = fit(&[Segment::new(&u, &y).unwrap()], &model.structure(), &FitOptions::default())
        .unwrap_err();
    assert_eq!(error, FitError::Overflow { what: "a parameter" });
}

#[test]
fn a_sine_determines_two_markov_parameters_only() {
    // y_i(k+1) + y_i(k-1) = 2 cos(w) y_i(k): of three shifted copies two are independent.
    let input: Vec<f64> = (0..60).map(|k| f64::from(k).sin()).collect();
    let output: Vec<f64> = (0..60).map(|k| 2.0 * (f64::from(k) + 0.3).sin()).collect();
    let found =
        fit(&[Segment::new(&input, &output).unwrap()], &structure(0, 1, 1), &FitOptions::default())
            .unwrap();
    assert_eq!((found.rank, found.singular_values.len(), found.degrees_of_freedom), (2, 3, 56));
    assert!(found.relative_residual < 1e-14);
    let open = found.unidentifiable.unwrap();
    assert_eq!(
        open.parameters,
        [Parameter::Markov(-1), Parameter::Markov(0), Parameter::Markov(1)]
    );
    let direction = open.directions.column(0) / open.directions[(0, 0)];
    assert!(
        (direction[1] + 2.0 * 1.0_f64.cos()).abs() < 1e-12 && (direction[2] - 1.0).abs() < 1e-12,
        "{direction}"
    );
    // Of all solutions it is the shortest in scaled units, and the columns have nearly the same norm: no part along the free direction.
    let theta = found.model.theta();
    let along: f64 = theta.iter().zip(direction.iter()).map(|(a, b)| a * b).sum();
    assert!(along.abs() < 0.05, "{along}");
}

#[test]
fn a_zero_channel_leaves_its_parameters_open() {
    let input = noise(50, 1);
    let zero = vec![0.0; 50];
    let quiet =
        fit(&[Segment::new(&input, &zero).unwrap()], &structure(3, 1, 1), &FitOptions::default())
            .unwrap();
    assert_eq!(quiet.rank, 3, "y_o = 0 says nothing about D");
    assert_eq!(
        quiet.unidentifiable.unwrap().parameters,
        [Parameter::Denominator(1), Parameter::Denominator(2)]
    );
    assert!(quiet.model.theta().iter().all(|x| *x == 0.0));
    assert!(quiet.relative_residual == 0.0 && quiet.noise_variance == Some(0.0));
    let error =
        fit(&[Segment::new(&zero, &input).unwrap()], &structure(3, 1, 1), &FitOptions::default())
            .unwrap_err();
    assert_eq!(error, FitError::ConstantInput { value: 0.0 });
}

#[test]
fn exactly_as_many_equations_as_parameters() {
    let (model, input, output) = planted();
    // 6 parameters need 6 + r + max(l, d) = 10 samples.
    let attempt = |n: usize| {
        fit(
            &[Segment::new(&input[..n], &output[..n]).unwrap()],
            &model.structure(),
            &FitOptions::default(),
        )
    };
    let found = attempt(10).unwrap();
    assert_eq!((found.equations, found.rank, found.degrees_of_freedom), (6, 6, 0));
    assert_eq!(found.noise_variance, None);
    assert!(found.parameter_covariance.iter().all(|x| *x == 0.0));
    let worst = found
        .model
        .theta()
        .iter()
        .zip(model.theta())
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    assert!(worst < 1e-13 * found.condition, "{worst}");
    match attempt(9).unwrap_err() {
        FitError::TooFewSamples { samples: 9, equations: 5, parameters: 6, needed: 10, .. } => {}
        other => panic!("{other:?}"),
    }
    let text = attempt(9).unwrap_err().to_string();
    let expected = "9 samples in 1 segment(s) give 5 equations for 6 parameters (l = 3, r = 1, d = 2): \
                    at least 10 samples in one segment are needed";
    assert_eq!(text, expected);
    assert!(matches!(attempt(0), Err(FitError::TooFewSamples { samples: 0, equations: 0, .. })));
}

#[test]
fn no_denominator_is_a_pure_fir() {
    let input = noise(40, 2);
    let output: Vec<f64> =
        (0..40).map(|k| if k == 39 { 0.0 } else { 3.0 * input[k] - 2.0 * input[k + 1] }).collect();
    for constant_term in [ConstantTerm::Omitted, ConstantTerm::Included] {
        let s = Structure::new(Orders::new(0, 0, 1).unwrap(), constant_term);
        let found =
            fit(&[Segment::new(&input, &output).unwrap()], &s, &FitOptions::default()).unwrap();
        assert_eq!(found.model.denominator(), [1.0]);
        assert!((found.model.markov_parameter(0) - 3.0).abs() < 1e-14);
        assert!((found.model.markov_parameter(-1) + 2.0).abs() < 1e-14);
    }
    // l = 1 as printed is D(q) = q: the same with one more sample of delay.
    let s = structure(1, 0, 2);
    let found =
        fit(&[Segment::new(&input[..39], &output[..39]).unwrap()], &s, &FitOptions::default())
            .unwrap();
    let h: Vec<f64> = (-2..=0).map(|i| found.model.markov_parameter(i)).collect();
    assert!(
        (h[0] + 2.0).abs() < 1e-14 && (h[1] - 3.0).abs() < 1e-14 && h[2].abs() < 1e-14,
        "{h:?}"
    );
}

#[test]
fn rank_tolerance_is_an_option_with_limits() {
    let (model, input, output) = planted();
    let segment = Segment::new(&input, &output).unwrap();
    let with = |tolerance| {
        let options = FitOptions { rank_tolerance: Some(tolerance), ..FitOptions::default() };
        fit(&[segment], &model.structure(), &options)
    };
    assert_eq!(with(0.0).unwrap().rank, 6);
    assert!(with(0.5).unwrap().rank < 6);
    for bad in [-1e-3, 1.0, f64::NAN] {
        assert!(matches!(with(bad), Err(FitError::BadValue { .. })), "{bad}");
    }
}

#[test]
fn bad_segments_are_refused() {
    assert_eq!(
        Segment::new(&[1.0], &[]).unwrap_err(),
        FitError::UnequalLengths { input: 1, output: 0 }
    );
    let text = Segment::new(&[1.0, 2.0], &[0.0, f64::NEG_INFINITY]).unwrap_err().to_string();
    assert_eq!(text, "sample 1 of the pseudo output is -inf: all samples must be finite");
    assert_eq!(
        fit(&[], &structure(1, 1, 1), &FitOptions::default()).unwrap_err(),
        FitError::NoSegment
    );
}

#[test]
fn the_same_data_give_the_same_bits() {
    let (model, input, output) = planted();
    let segment = Segment::new(&input, &output).unwrap();
    let once = fit(&[segment], &model.structure(), &FitOptions::default()).unwrap();
    assert_eq!(once, fit(&[segment], &model.structure(), &FitOptions::default()).unwrap());
}
