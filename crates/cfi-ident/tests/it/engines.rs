//! Two engines, any number of threads and any pieces: one answer.

use cfi_ident::{
    Accumulator, CfiModel, ConstantTerm, Engine, Fit, FitError, FitOptions, Orders, Segment,
    Structure, fit,
};
use proptest::prelude::*;

use crate::planted::record;

fn planted() -> CfiModel {
    let structure = Structure::new(Orders::new(3, 2, 2).unwrap(), ConstantTerm::Included);
    CfiModel::new(structure, &[0.3, -0.2, -0.9], &[0.4, 1.0, -2.0, 0.5, 0.25]).unwrap()
}

/// Largest difference of a parameter in units of its deviation.
fn apart(a: &Fit, b: &Fit) -> f64 {
    let parameters = a.model.theta().into_iter().zip(b.model.theta()).enumerate();
    parameters
        .map(|(i, (a_i, b_i))| (a_i - b_i).abs() / a.parameter_covariance[(i, i)].sqrt())
        .fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn sums_and_reflections_agree(seed in 0..1_000_000_u64, samples in 60..3000_usize, noise in 1e-3..1.0_f64) {
        let model = planted();
        let (input, output) = record(&model, samples, noise, seed);
        let segments = [Segment::new(&input, &output).unwrap()];
        let with = |engine| {
            fit(&segments, &model.structure(), &FitOptions { engine, ..FitOptions::default() }).unwrap()
        };
        let (sums, reflections) = (with(Engine::Gram), with(Engine::Qr));
        prop_assert!(apart(&sums, &reflections) < 1e-9);
        prop_assert_eq!(sums.rank, reflections.rank);
        let close = |a: f64, b: f64| (a - b).abs() < 1e-11 * a.abs();
        prop_assert!(close(sums.residual_norm, reflections.residual_norm));
        prop_assert!(close(sums.condition, reflections.condition));
        for (a, b) in sums.parameter_covariance.iter().zip(&reflections.parameter_covariance) {
            let scale = sums.parameter_covariance.amax();
            prop_assert!((a - b).abs() < 1e-10 * scale);
        }
    }
}

#[test]
fn threads_make_no_difference() {
    let model = planted();
    let (input, output) = record(&model, 60_000, 0.1, 5);
    let segments = [Segment::new(&input, &output).unwrap()];
    let with = |threads| {
        let options = FitOptions { threads, ..FitOptions::default() };
        fit(&segments, &model.structure(), &options).unwrap()
    };
    let one = with(1);
    assert_eq!(with(2), one);
    assert_eq!(with(8), one);
}

#[test]
fn pieces_make_no_difference() {
    let model = planted();
    let structure = model.structure();
    let (input, output) = record(&model, 20_000, 0.1, 6);
    let options = FitOptions { refinement_steps: 0, ..FitOptions::default() };
    let whole = fit(&[Segment::new(&input, &output).unwrap()], &structure, &options).unwrap();
    for piece in [7, 4096, 19_999] {
        let mut sums = Accumulator::new(&structure, &options).unwrap();
        for (u, y) in input.chunks(piece).zip(output.chunks(piece)) {
            sums.push(u, y).unwrap();
        }
        assert_eq!(sums.fit().unwrap(), whole, "pieces of {piece}");
    }
    // Two files, one of them with a gap.
    let cut = |from: usize, to: usize| (&input[from..to], &output[from..to]);
    let segments = [cut(0, 6000), cut(6000, 6003), cut(7000, 20_000)]
        .map(|(u, y)| Segment::new(u, y).unwrap());
    let together = fit(&segments, &structure, &options).unwrap();
    let mut first = Accumulator::new(&structure, &options).unwrap();
    first.push(cut(0, 6000).0, cut(0, 6000).1).unwrap();
    first.gap();
    first.push(cut(6000, 6003).0, cut(6000, 6003).1).unwrap();
    let mut second = Accumulator::new(&structure, &options).unwrap();
    second.push(cut(7000, 20_000).0, cut(7000, 20_000).1).unwrap();
    first.merge(&second).unwrap();
    let merged = first.fit().unwrap();
    assert_eq!(merged.equations, together.equations);
    assert_eq!(merged.samples_used, 19_000);
    assert_eq!(merged.segments_without_equation, 1);
    assert!(apart(&merged, &together) < 1e-12);
}

#[test]
fn an_input_that_varies_only_from_segment_to_segment_is_constant() {
    let structure = Structure::new(Orders::new(1, 2, 2).unwrap(), ConstantTerm::Omitted);
    let output: Vec<f64> = (0..40).map(|k| f64::from(k * k % 7)).collect();
    let (first, second, short) = ([0.1; 40], [0.3; 40], [1.0, 2.0, 0.0]);
    let signed: Vec<f64> = (0..40).map(|k| if k % 2 == 0 { 0.0 } else { -0.0 }).collect();
    for (inputs, value) in
        [(vec![&short[..], &first, &second], 0.1), (vec![&signed[..], &second], 0.0)]
    {
        let segments: Vec<Segment<'_>> =
            inputs.iter().map(|u| Segment::new(u, &output[..u.len()]).unwrap()).collect();
        let expected = FitError::ConstantInput { value };
        assert_eq!(fit(&segments, &structure, &FitOptions::default()).unwrap_err(), expected);
        let mut sums = Accumulator::new(&structure, &FitOptions::default()).unwrap();
        for u in &inputs {
            for (u, y) in u.chunks(7).zip(output.chunks(7)) {
                sums.push(u, &y[..u.len()]).unwrap();
            }
            sums.gap();
        }
        assert_eq!(sums.fit().unwrap_err(), expected);
    }
}

#[test]
fn bad_pieces_are_refused_and_leave_nothing_behind() {
    let structure = planted().structure();
    let options = FitOptions::default();
    let mut sums = Accumulator::new(&structure, &options).unwrap();
    assert_eq!(sums.fit().unwrap_err(), FitError::NoSegment);
    sums.push(&[1.0; 50], &[2.0; 50]).unwrap();
    assert_eq!(sums.fit().unwrap_err(), FitError::ConstantInput { value: 1.0 });
    let before = sums.clone();
    assert!(matches!(sums.push(&[1.0], &[]), Err(FitError::UnequalLengths { .. })));
    let text = sums.push(&[1.0, 2.0], &[0.0, f64::NAN]).unwrap_err().to_string();
    assert_eq!(text, "sample 1 of the pseudo output is NaN: all samples must be finite");
    let other = Structure::new(Orders::new(1, 1, 1).unwrap(), ConstantTerm::Omitted);
    let other = Accumulator::new(&other, &options).unwrap();
    assert_eq!(sums.merge(&other).unwrap_err(), FitError::DifferentStructures);
    assert_eq!(sums, before);
    let few = Structure::new(Orders::new(4, 25, 25).unwrap(), ConstantTerm::Omitted);
    let mut few = Accumulator::new(&few, &options).unwrap();
    few.push(&[1.0; 60], &[2.0; 60]).unwrap();
    assert!(matches!(few.fit(), Err(FitError::TooFewSamples { samples: 60, equations: 10, .. })));
    let reflections = FitOptions { engine: Engine::Qr, ..options.clone() };
    let refused = Accumulator::new(&structure, &reflections).unwrap_err();
    assert_eq!(refused, FitError::EngineNeedsRecord);
    let none = FitOptions { threads: 0, ..options };
    assert!(matches!(Accumulator::new(&structure, &none), Err(FitError::BadValue { .. })));
}
