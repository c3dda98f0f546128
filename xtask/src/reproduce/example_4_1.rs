//! Example 4.1, in exact integers.

use lti::{Transmissibility, resolvent_numerators};
use nalgebra::DMatrix;
use num_bigint::BigInt;
use num_complex::Complex;
use num_traits::ToPrimitive;
use poly::{MrootsOptions, Poly, mroots};
use reconstruct::paper::{Statement, TransmissibilityPair, containment};

use super::check::{Check, Print};
use super::{AircraftExample, Part};
use crate::TaskError;
use crate::shared::reference;

const PART: &str = "Example 4.1";

/// The system of paper eq. (19), the outputs of paper eq. (20) and the inputs of paper eq. (21).
fn system() -> [DMatrix<BigInt>; 3] {
    let whole = |rows: usize, columns: usize, entries: &[i32]| {
        DMatrix::from_row_iterator(rows, columns, entries.iter().map(|&entry| BigInt::from(entry)))
    };
    [
        whole(3, 3, &[1, 1, 1, 0, 2, -1, 0, 1, 1]),
        whole(3, 2, &[0, 0, 1, 1, 0, -1]),
        whole(2, 3, &[1, 2, -1, -1, 3, -2]),
    ]
}

/// Computes and checks the numerators of paper eq. (22) and paper eq. (23), the determinant of
/// paper eq. (24) and its roots, paper eq. (25).
pub(crate) fn build(_: &AircraftExample) -> Result<Part, TaskError> {
    let fault = TaskError::computation(PART);
    let [a, b, c] = system();
    let found = resolvent_numerators(&a, &b, &c, &DMatrix::from_element(2, 2, BigInt::ZERO))
        .map_err(|error| fault(error.to_string()))?;
    let gamma = |output: usize, input: usize| found.numerators[output][input].clone();
    let transmissibility = |input| {
        Transmissibility::from_polynomials(gamma(1, input), gamma(0, input))
            .map_err(|error| fault(error.to_string()))
    };
    let pair = TransmissibilityPair::new(transmissibility(0)?, transmissibility(1)?);
    let theorem = pair.theorem(3).map_err(|error| fault(error.to_string()))?;
    let (factor, remainder) = theorem
        .determinant
        .pseudo_div_rem(&found.delta)
        .map_err(|error| fault(error.to_string()))?;

    let spectrum = roots(&found.delta)?;
    let determinant_roots = roots(&theorem.determinant)?;
    let contained = containment(&spectrum, &determinant_roots);
    let exact = |id,
                 print,
                 paper: &str,
                 computed: &Poly<BigInt>,
                 name: &str,
                 note: &str|
     -> Result<Check, TaskError> {
        let reference = polynomial(&format!("/example_4_1/{name}"))?;
        Ok(Check::exact(id, print, paper, &show(computed), &show(&reference), note))
    };
    let exchanged = "the print exchanges the two";
    let half = "1/2 is printed for 3/2; the trace is 4";
    let statement = match theorem.statement {
        Statement::DeterminantIsZero => "i) det Delta = 0".to_owned(),
        Statement::DegreeAtLeastOrder { degree, order } => {
            format!("ii) degree {degree} >= n = {order}")
        }
    };
    let checks = vec![
        exact("ex41-delta", Print::Right, "p^3 - 4p^2 + 6p - 3", &found.delta, "delta", "")?,
        Check::roots(
            "ex41-spec",
            Print::Slip,
            &[("1", "0"), ("0.5", "0.866")],
            &spectrum,
            &reference::roots("/example_4_1/spec_A")?,
            1e-14,
            half,
        ),
        exact("ex41-gamma-i1", Print::Right, "2p^2 - 4p + 3", &gamma(0, 0), "gamma_i1", "(22)")?,
        exact("ex41-gamma-o1", Print::Slip, "3p^2 - 6p + 6", &gamma(1, 0), "gamma_o1", exchanged)?,
        exact("ex41-gamma-i2", Print::Slip, "3p^2 - 9p + 5", &gamma(0, 1), "gamma_i2", exchanged)?,
        exact("ex41-gamma-o2", Print::Right, "5p^2 - 11p + 3", &gamma(1, 1), "gamma_o2", "(23)")?,
        exact(
            "ex41-determinant",
            Print::Right,
            "p^4 + 3p^3 - 22p^2 + 39p - 21",
            &theorem.determinant,
            "det_Delta",
            "(24); the exchange leaves it alone",
        )?,
        Check::exact(
            "ex41-factor",
            Print::Right,
            "delta(p) (p + 7)",
            &if remainder.is_zero() {
                format!("delta(p) ({})", show(&factor))
            } else {
                "no multiple of delta(p)".to_owned()
            },
            "delta(p) (p + 7)",
            "det Delta divided by delta",
        ),
        Check::roots(
            "ex41-mroots",
            Print::Slip,
            &[("1", "0"), ("-7", "0"), ("0.5", "0.866")],
            &determinant_roots,
            &reference::roots("/example_4_1/mroots_det_Delta")?,
            1e-14,
            &format!("(25); {half}"),
        ),
        Check::stated(
            "ex41-theorem",
            &statement,
            "ii) degree 4 >= n = 3",
            "which statement of Theorem 3.1 holds",
        ),
        Check::computed(
            "ex41-containment",
            &[contained.largest_distance()],
            &[0.0],
            1e-14,
            "largest distance of an eigenvalue of A from a root of det Delta, (18)",
        ),
    ];
    Ok(Part {
        title: "Example 4.1",
        introduction: "Three states, two inputs, two outputs, all of them whole numbers: computed in exact integers. Only the roots are floating-point numbers.",
        checks,
        blocks: Vec::new(),
    })
}

fn polynomial(pointer: &str) -> Result<Poly<BigInt>, TaskError> {
    let parse = |text: String| text.parse::<BigInt>().map_err(TaskError::computation(PART));
    let descending =
        reference::exact(pointer)?.into_iter().map(parse).collect::<Result<Vec<_>, _>>()?;
    Ok(Poly::from_descending(&descending))
}

fn show(p: &Poly<BigInt>) -> String {
    p.display("p").to_string()
}

fn roots(p: &Poly<BigInt>) -> Result<Vec<Complex<f64>>, TaskError> {
    // The coefficients are far below 2^53, so this is exact.
    let float = p.map(|coefficient| coefficient.to_f64().unwrap_or(f64::NAN));
    Ok(mroots(&float, &MrootsOptions::default()).map_err(TaskError::computation(PART))?.values())
}
