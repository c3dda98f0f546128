//! Figures 1 and 2: poles and Markov parameters of the composite FIR/IIR models.

use cfi_ident::{ConstantTerm, Structure};
use num_complex::Complex;
use reconstruct::paper;
use reconstruct::paper::{Identification, IdentificationOptions};
use report::{Axis, Figure, Panel, Points, Stems};

use super::check::{Check, Print, multiset_distance};
use super::{AircraftExample, Part};
use crate::TaskError;
use crate::shared::reference;

const PART: &str = "composite models";

pub(crate) fn build(example: &AircraftExample) -> Result<Part, TaskError> {
    let found = &example.result.identifications;
    let constant_term = ranks_with_constant_term(example)?;
    let parameters = found[0].fit.model.structure().parameter_count();
    let mut checks = vec![
        Check::exact(
            "cfi-parameters",
            Print::Slip,
            "l + r + d - 1 = 53",
            &format!("l + r + d = {parameters}"),
            "l + r + d = 54",
            "entries of theta; (42)-(44) have it right",
        ),
        Check::stated(
            "cfi-rank-omitted",
            &all_equal(found.iter().map(|found| format!("{} of {parameters}", found.fit.rank))),
            "54 of 54",
            "rank of the regressors of all four fits, D without constant term as (35) has it",
        ),
        Check::stated(
            "cfi-rank-included",
            &all_equal(constant_term.into_iter()),
            "54 of 55",
            "the same with a constant term: one direction stays undetermined",
        ),
        Check::exact(
            "cfi-poles-off-circle",
            Print::Slip,
            "all on the unit circle",
            &format!("{} on the unit circle", poles_on_circle(found)),
            "0 on the unit circle",
            "poles kept in the IIR factor of the four models",
        ),
    ];
    for (record, (id, surface)) in
        [("cfi-poles-aileron", "aileron"), ("cfi-poles-rudder", "rudder")].into_iter().enumerate()
    {
        let zeros = reference::roots(&format!("/aircraft/as_printed/zeros_sideslip_{surface}"))?;
        // D(q) has a root at 0, and those of the sideslip's numerator, for both pseudo outputs.
        let expected: Vec<_> = std::iter::once(Complex::new(0.0, 0.0)).chain(zeros).collect();
        let [roll, yaw] = of_record(example, record) else {
            return Err(TaskError::Computation {
                part: PART,
                message: "two pseudo outputs are needed".to_owned(),
            });
        };
        let distance = |found| multiset_distance(&composite_poles(found), &expected);
        let worse = if distance(roll) > distance(yaw) { roll } else { yaw };
        checks.push(Check::computed_roots(
            id,
            &composite_poles(worse),
            &expected,
            1e-10,
            "roots of D: 0 and the zeros of the sideslip's transfer function",
        ));
        for (found, (id, output)) in of_record(example, record).iter().zip(MARKOV_CHECKS[record]) {
            checks.push(markov_check(id, found, surface, output)?);
        }
    }
    Ok(Part {
        title: "Figures 1 and 2: composite models",
        introduction: "Least squares with l = 4, r = d = 25 on 2000 noise-free samples, sampled every 0.1 s, white excitation of unit variance. D holds three poles and \
                       a root at 0; the FIR factor is left with four nonzero Markov parameters.",
        checks,
        blocks: vec![
            figure(example, 0, "figure-1", "Composite models, aileron moving").into(),
            figure(example, 1, "figure-2", "Composite models, rudder moving").into(),
        ],
    })
}

/// By record: the check's id and the pseudo output's name in reference.json.
const MARKOV_CHECKS: [[(&str, &str); 2]; 2] = [
    [("cfi-markov-p-aileron", "roll_rate"), ("cfi-markov-r-aileron", "yaw_rate")],
    [("cfi-markov-p-rudder", "roll_rate"), ("cfi-markov-r-rudder", "yaw_rate")],
];

/// D(q) T(q) is a polynomial of degree four: h_-4 .. h_-1 are the coefficients of the pseudo
/// output's numerator over the leading one of the sideslip's, and all other Markov parameters are
/// zero. Compared relative to the largest.
fn markov_check(
    id: &'static str,
    found: &Identification,
    surface: &str,
    output: &str,
) -> Result<Check, TaskError> {
    let numerator = reference::numbers(&format!("/aircraft/as_printed/gamma_{output}_{surface}"))?;
    let leading = reference::numbers(&format!("/aircraft/as_printed/gamma_sideslip_{surface}"))?[0];
    let computed: Vec<f64> = found.fit.model.markov_parameters();
    let first = found.fit.model.structure().orders.anticausal() - 4;
    let mut expected = vec![0.0; computed.len()];
    for (place, coefficient) in expected[first..].iter_mut().zip(numerator) {
        *place = coefficient / leading;
    }
    let largest = expected.iter().fold(0.0_f64, |largest, h| largest.max(h.abs()));
    let relative = |values: Vec<f64>| values.into_iter().map(|h| h / largest).collect::<Vec<_>>();
    let note = "Markov parameters over the largest: four, and zeros to rounding";
    Ok(Check::computed(id, &relative(computed), &relative(expected), 1e-11, note))
}

/// The identifications of one record: to the roll rate, to the yaw rate.
pub(super) fn of_record(example: &AircraftExample, record: usize) -> &[Identification] {
    let outputs = example.records[record].channels().len() - 1;
    &example.result.identifications[record * outputs..(record + 1) * outputs]
}

fn composite_poles(found: &Identification) -> Vec<Complex<f64>> {
    found
        .composite_poles
        .iter()
        .flat_map(|root| std::iter::repeat_n(root.value, root.multiplicity))
        .collect()
}

fn ranks_with_constant_term(example: &AircraftExample) -> Result<Vec<String>, TaskError> {
    let mut options = IdentificationOptions::default();
    options.structure = Structure::new(options.structure.orders, ConstantTerm::Included);
    let parameters = options.structure.parameter_count();
    let pairs = example.records.iter().flat_map(|record| [(record, 1), (record, 2)]);
    pairs
        .map(|(record, output)| {
            let found = paper::identify_transmissibility(record, 0, output, &options)
                .map_err(TaskError::computation(PART))?;
            Ok(format!("{} of {parameters}", found.fit.rank))
        })
        .collect()
}

/// The common text, or all of them.
fn all_equal(texts: impl Iterator<Item = String>) -> String {
    let mut texts: Vec<String> = texts.collect();
    texts.dedup();
    texts.join(", ")
}

fn poles_on_circle(found: &[Identification]) -> usize {
    // The pole closest to the circle, 1.00110, is a thousand times farther away.
    const ON_CIRCLE: f64 = 1e-6;
    let poles = found.iter().flat_map(composite_poles);
    poles.filter(|pole| (pole.norm() - 1.0).abs() < ON_CIRCLE).count()
}

fn figure(example: &AircraftExample, record: usize, id: &str, title: &str) -> Figure {
    let caption = "Left: roots of D. Middle: the same near z = 1. Right: Markov parameters h_i of the FIR factor; all but four \
                   are zero to rounding.";
    let mut figure = Figure::new(id, title, caption).columns(3);
    for found in of_record(example, record) {
        let name = format!("{} to {}", found.input, found.output);
        let poles = || {
            Points::poles(
                "pole of the composite model",
                composite_poles(found).into_iter().map(|z| (z.re, z.im)),
            )
        };
        let unit = if found.input == found.output { "" } else { " [1/s]" };
        let markov = Panel::new(
            format!("{name}: Markov parameters"),
            Axis::linear("index i").range(-26.0, 26.0),
            Axis::linear(format!("h_i{unit}")),
        );
        figure = figure
            .with(
                Panel::z_plane(format!("{name}: poles"))
                    .zoom((-1.35, 1.35), (-1.35, 1.35))
                    .with(poles()),
            )
            .with(
                Panel::z_plane(format!("{name}: near z = 1"))
                    .zoom((0.93, 1.03), (-0.05, 0.05))
                    .with(poles()),
            )
            .with(markov.with(Stems::new("Markov parameter", markov_parameters(found))));
    }
    figure
}

fn markov_parameters(found: &Identification) -> Vec<(f64, f64)> {
    let model = &found.fit.model;
    let orders = model.structure().orders;
    let (first, last) = (-(orders.anticausal() as isize), orders.causal() as isize);
    (first..=last).map(|index| (index as f64, model.markov_parameter(index))).collect()
}
