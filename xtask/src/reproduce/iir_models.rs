//! Figure 3: the transmissibilities as rational functions.

use num_complex::Complex;
use reconstruct::paper::Identification;
use report::{Figure, Panel, Points};

use super::check::{Check, Print};
use super::composite_models::of_record;
use super::{AircraftExample, Part};
use crate::TaskError;
use crate::shared::reference;

/// Names of sensors and surfaces in reference.json, by the records' and channels' order.
const SURFACES: [&str; 2] = ["aileron", "rudder"];
const OUTPUTS: [&str; 2] = ["roll_rate", "yaw_rate"];

const ZERO_CHECKS: [[&str; 2]; 2] =
    [["iir-zeros-p-aileron", "iir-zeros-r-aileron"], ["iir-zeros-p-rudder", "iir-zeros-r-rudder"]];
const POLE_CHECKS: [[&str; 2]; 2] =
    [["iir-poles-p-aileron", "iir-poles-r-aileron"], ["iir-poles-p-rudder", "iir-poles-r-rudder"]];

pub(crate) fn build(example: &AircraftExample) -> Result<Part, TaskError> {
    let mut checks = vec![multiplied(example)?, rudder_differs(example)];
    for (record, surface) in SURFACES.into_iter().enumerate() {
        for ((found, output), index) in of_record(example, record).iter().zip(OUTPUTS).zip(0..) {
            let zeros =
                reference::roots(&format!("/aircraft/as_printed/zeros_{output}_{surface}"))?;
            let poles =
                reference::roots(&format!("/aircraft/as_printed/zeros_sideslip_{surface}"))?;
            checks.push(Check::computed_roots(
                ZERO_CHECKS[record][index],
                &found.zeros,
                &zeros,
                1e-9,
                "zeros",
            ));
            checks.push(Check::computed_roots(
                POLE_CHECKS[record][index],
                &found.poles,
                &poles,
                1e-9,
                "poles",
            ));
        }
    }
    let orders: Vec<_> = example
        .result
        .identifications
        .iter()
        .map(|found| {
            format!("({}, {})", found.realization.causal.order, found.realization.anticausal.order)
        })
        .collect();
    checks.push(Check::stated(
        "era-orders",
        &orders.join(", "),
        "(0, 4), (0, 4), (0, 4), (0, 4)",
        "states realised of the causal and the time-reversed half, of n_s = n_u = 6 asked for: nothing else stands above rounding level",
    ));
    Ok(Part {
        title: "Figure 3: rational transmissibilities",
        introduction: "ERA with n_s = n_u = 6 on both halves of the FIR factor, multiplied by 1/D, zeros and poles within 1e-6 of each other cancelled. \
                       The paper shows these as pole-zero maps; the numbers here are held against 60-digit arithmetic.",
        checks,
        blocks: vec![figure(example).into()],
    })
}

/// Part V.C says that the IIR part is added, part VI that it is multiplied. The records decide.
fn multiplied(example: &AircraftExample) -> Result<Check, TaskError> {
    let found = &example.result.identifications[0];
    let numerator = reference::numbers("/aircraft/as_printed/gamma_roll_rate_aileron")?;
    let denominator = reference::numbers("/aircraft/as_printed/gamma_sideslip_aileron")?;
    // Any place will do where neither is near a pole.
    let z = Complex::from_polar(1.0, 1.0);
    let horner =
        |descending: &[f64]| descending.iter().fold(Complex::new(0.0, 0.0), |sum, c| sum * z + c);
    let truth = horner(&numerator) / horner(&denominator);
    let factor = found.factor.rational.eval_complex(z);
    let iir = found
        .fit
        .model
        .denominator()
        .iter()
        .rev()
        .fold(Complex::new(0.0, 0.0), |sum, c| sum * z + c)
        .inv();
    let added = (factor + iir - truth).norm();
    let product = (factor * iir - truth).norm();
    let word = match (product < 1e-9 * truth.norm(), added < 1e-9 * truth.norm()) {
        (true, false) => "multiplied",
        (false, true) => "added",
        _ => "undecided",
    };
    Ok(Check::exact(
        "iir-multiplied",
        Print::Slip,
        "added",
        word,
        "multiplied",
        "how 1/D and the FIR factor make T, judged by the true T at exp(j)",
    ))
}

/// The paper writes .|delta a for the transmissibilities of both records.
fn rudder_differs(example: &AircraftExample) -> Check {
    let z = Complex::from_polar(1.0, 1.0);
    let value =
        |record| of_record(example, record)[0].transmissibility.to_rational().eval_complex(z);
    let (aileron, rudder) = (value(0), value(1));
    let word =
        if (aileron - rudder).norm() > 1e-3 * aileron.norm() { "different" } else { "the same" };
    Check::exact(
        "rudder-differs",
        Print::Slip,
        "the same",
        word,
        "different",
        "transmissibilities to the roll rate of the two records",
    )
}

fn figure(example: &AircraftExample) -> Figure {
    let caption = "One row for each record; beside each whole map the neighbourhood of z = 1. The yaw rate of the rudder record has one more zero \
                   outside the map, at 15.6.";
    let mut figure =
        Figure::new("figure-3", "Rational models of the four transmissibilities", caption)
            .columns(4);
    for (record, surface) in SURFACES.into_iter().enumerate() {
        for found in of_record(example, record) {
            let name = format!("{} to {}, {surface} moving", found.input, found.output);
            figure = figure
                .with(with_points(Panel::z_plane(name), found).zoom((-2.0, 2.0), (-1.3, 1.3)))
                .with(
                    with_points(Panel::z_plane("near z = 1"), found)
                        .zoom((0.86, 1.18), (-0.2, 0.2)),
                );
        }
    }
    figure
}

fn with_points(panel: Panel, found: &Identification) -> Panel {
    let xy = |values: &[Complex<f64>]| values.iter().map(|z| (z.re, z.im)).collect::<Vec<_>>();
    panel
        .with(Points::poles("pole", xy(&found.poles)))
        .with(Points::zeros("zero", xy(&found.zeros)))
}
