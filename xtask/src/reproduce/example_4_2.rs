//! Example 4.2, in exact rationals.

use lti::{ResolventNumerators, Transmissibility, resolvent_numerators};
use nalgebra::DMatrix;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use poly::{MrootsOptions, Poly, Rational, mroots};
use reconstruct::paper::{TransmissibilityPair, containment};

use super::check::{Check, Print};
use super::{AircraftExample, Part};
use crate::TaskError;
use crate::shared::reference;

const PART: &str = "Example 4.2";

type Exact = BigRational;

/// The matrices of paper eq. (26) and paper eq. (27), numerators over 10 000.
fn system() -> [DMatrix<Exact>; 3] {
    let over = |denominator: i64, rows: usize, columns: usize, entries: &[i64]| {
        let entry = |&numerator: &i64| Exact::new(numerator.into(), denominator.into());
        DMatrix::from_row_iterator(rows, columns, entries.iter().map(entry))
    };
    let one = 10_000;
    [
        over(one, 4, 4, &[-7000, 2300, 2390, 546, one, 0, 0, 0, 0, one, 0, 0, 0, 0, one, 0]),
        over(1, 4, 2, &[1, 0, 1, 0, 4, 1, 0, 1]),
        over(1, 3, 4, &[1, 2, 3, 0, 8, 1, 1, 0, 1, 3, 1, 6]),
    ]
}

/// What the paper prints of one transmissibility: its name in reference.json and the checks' ids,
/// and its coefficients.
struct Printed {
    id: &'static str,
    output: usize,
    input: usize,
    numerator: [&'static str; 4],
    note: &'static str,
}

/// The numerators of paper eq. (28), paper eq. (29), paper eq. (30) and paper eq. (31).
const NUMERATORS: [Printed; 4] = [
    Printed {
        id: "ex42-T21-u1",
        output: 1,
        input: 0,
        numerator: ["13", "14.99", "5.395", "0.6552"],
        note: "numerator of (28)",
    },
    Printed {
        id: "ex42-T31-u1",
        output: 2,
        input: 0,
        numerator: ["8", "34.09", "26.91", "5.39"],
        note: "numerator of (29)",
    },
    Printed {
        id: "ex42-T21-u2",
        output: 1,
        input: 1,
        numerator: ["1", "3.049", "0.5004", "0.1092"],
        note: "numerator of (30)",
    },
    Printed {
        id: "ex42-T31-u2",
        output: 2,
        input: 1,
        numerator: ["7", "11.19", "3.525", "-2.596"],
        note: "numerator of (31)",
    },
];

const DENOMINATORS: [Printed; 2] = [
    Printed {
        id: "ex42-y1-u1",
        output: 0,
        input: 0,
        numerator: ["15", "15.99", "4.709", "0.4914"],
        note: "denominator of (28) and (29)",
    },
    Printed {
        id: "ex42-y1-u2",
        output: 0,
        input: 1,
        numerator: ["3", "2.394", "-0.0482", "0.273"],
        note: "denominator of (30) and (31)",
    },
];

pub(crate) fn build(_: &AircraftExample) -> Result<Part, TaskError> {
    let [a, b, c] = system();
    let found = resolvent_numerators(&a, &b, &c, &DMatrix::from_element(3, 2, Exact::zero()))
        .map_err(TaskError::computation(PART))?;
    let mut checks = Vec::new();
    for printed in NUMERATORS.iter().chain(&DENOMINATORS) {
        let Printed { id, output, input, numerator, note } = printed;
        let pointer = format!("/example_4_2/gamma/y{}_u{}", output + 1, input + 1);
        let computed = &found.numerators[*output][*input];
        checks.push(polynomial_check(id, numerator, computed, &exact_reference(&pointer)?, note)?);
    }

    let spectrum = roots(&found.delta)?;
    checks.push(Check::roots(
        "ex42-spec",
        Print::Right,
        &[("0.6", "0"), ("-0.7", "0"), ("-0.3", "0.2")],
        &spectrum,
        &reference::roots("/example_4_2/spec_A")?,
        1e-14,
        "eigenvalues of A",
    ));
    let first = difference(&found, 1)?;
    let second = difference(&found, 2)?;
    checks.extend(difference_checks(
        ["ex42-difference-21", "ex42-roots-21", "ex42-containment-21"],
        "T21",
        &first,
        &["24", "14.36", "-9.519", "-6.781", "-0.2005", "0.681", "0.125"],
        (
            Print::Right,
            &[("0.6", "0"), ("-0.7", "0"), ("0.364", "0"), ("-0.2625", "0"), ("-0.3", "0.2")],
        ),
        "",
        &spectrum,
    )?);
    checks.push(polynomial_check(
        "ex42-difference-denominator",
        &["45", "83.86", "51.67", "16.07", "5.313", "1.262", "0.1342"],
        first.denominator(),
        &(exact_reference("/example_4_2/gamma/y1_u1")?
            * exact_reference("/example_4_2/gamma/y1_u2")?),
        "denominator of (32) and (33)",
    )?);
    checks.extend(difference_checks(
        ["ex42-difference-31", "ex42-roots-31", "ex42-containment-31"],
        "T31",
        &second,
        &["-81", "-158.4", "-102.9", "7.533", "40.3", "17.58", "2.747"],
        (Print::Slip, &[("0.6", "0"), ("-0.7", "0"), ("-0.3", "0.2"), ("-0.628", "0.4761")]),
        "0.4761 is printed for 0.4765",
        &spectrum,
    )?);
    Ok(Part {
        title: "Example 4.2",
        introduction: "Four states, two inputs, three outputs, in exact rationals. The two differences share the eigenvalues of A and nothing else.",
        checks,
        blocks: Vec::new(),
    })
}

/// T_o,1|1 - T_o,1|2, nothing cancelled. For o = 2 paper eq. (32), for o = 3 paper eq. (33).
fn difference(
    found: &ResolventNumerators<Exact>,
    output: usize,
) -> Result<Rational<Exact>, TaskError> {
    let transmissibility = |input: usize| {
        let gamma = |output: usize| found.numerators[output][input].clone();
        Transmissibility::from_polynomials(gamma(output), gamma(0))
            .map_err(TaskError::computation(PART))
    };
    TransmissibilityPair::new(transmissibility(0)?, transmissibility(1)?)
        .difference()
        .map_err(TaskError::computation(PART))
}

fn difference_checks(
    [polynomial_id, roots_id, containment_id]: [&'static str; 3],
    name: &str,
    difference: &Rational<Exact>,
    numerator: &[&str],
    (print, printed_roots): (Print, &[(&str, &str)]),
    note: &str,
    spectrum: &[Complex<f64>],
) -> Result<[Check; 3], TaskError> {
    let reference = exact_reference(&format!("/example_4_2/numerator_{name}_difference"))?;
    let found = roots(difference.numerator())?;
    let reference_roots = reference::roots(&format!("/example_4_2/roots_{name}_difference"))?;
    let contained = containment(spectrum, &found);
    Ok([
        polynomial_check(
            polynomial_id,
            numerator,
            difference.numerator(),
            &reference,
            "numerator of the difference",
        )?,
        Check::roots(roots_id, print, printed_roots, &found, &reference_roots, 1e-12, note),
        Check::computed(
            containment_id,
            &[contained.largest_distance()],
            &[0.0],
            1e-12,
            "largest distance of an eigenvalue of A from a root",
        ),
    ])
}

/// The coefficients must be the reference's as fractions; the print must be their rounding.
fn polynomial_check(
    id: &'static str,
    printed: &[&str],
    computed: &Poly<Exact>,
    reference: &Poly<Exact>,
    note: &str,
) -> Result<Check, TaskError> {
    if computed != reference {
        let message =
            format!("{id}: {} where {} is right", computed.display("q"), reference.display("q"));
        return Err(TaskError::Computation { part: PART, message });
    }
    let [computed, reference] =
        [computed, reference].map(|p| p.descending().iter().map(float).collect::<Vec<_>>());
    Ok(Check::numbers(id, Print::Right, printed, &computed, &reference, 0.0, note))
}

fn exact_reference(pointer: &str) -> Result<Poly<Exact>, TaskError> {
    let parse = |text: String| text.parse::<Exact>().map_err(TaskError::computation(PART));
    let descending =
        reference::exact(pointer)?.into_iter().map(parse).collect::<Result<Vec<_>, _>>()?;
    Ok(Poly::from_descending(&descending))
}

fn float(value: &Exact) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}

fn roots(p: &Poly<Exact>) -> Result<Vec<Complex<f64>>, TaskError> {
    Ok(mroots(&p.map(float), &MrootsOptions::default())
        .map_err(TaskError::computation(PART))?
        .values())
}
