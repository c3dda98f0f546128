//! Figure 4: the differences of the transmissibilities, the zeros that they share, and the
//! eigenvalues.

use aircraft::{Eigenpair, ModeShape, name_modes};
use lti::StateSpace;
use num_complex::Complex;
use reconstruct::paper::{Difference, IdentificationOptions, containment, difference_zeros};
use reconstruct::{ReconstructError, Record, paper};
use report::{
    Block, Column, Figure, Notes, Panel, Points, Table, format_conjugate_pair, format_significant,
};

use super::check::{Check, Print};
use super::{AircraftExample, Part};
use crate::TaskError;
use crate::shared::reference;

const PART: &str = "reconstruction";

/// How far a reconstructed eigenvalue may be from the true one. The limit is what was asked for;
/// the note says what is reached.
const EIGENVALUE_TOLERANCE: f64 = 1e-6;

pub(crate) fn build(example: &AircraftExample) -> Result<Part, TaskError> {
    let shared = example.result.shared.values();
    let eigenvalues: Vec<_> = example.result.modes.iter().map(|mode| mode.eigenvalue).collect();
    let printed_zeros = [("0.9788", "0.1672"), ("0.9469", "0"), ("0.9998", "0")];
    let printed_eigenvalues = [("-0.0706", "1.6917"), ("-0.0016", "0"), ("-0.5456", "0")];
    let mut checks = vec![
        Check::roots(
            "shared-zeros",
            Print::Right,
            &printed_zeros,
            &shared,
            &reference::roots("/aircraft/as_printed/spec_Ad")?,
            EIGENVALUE_TOLERANCE,
            "zeros that both differences have",
        ),
        Check::roots(
            "eigenvalues",
            Print::Right,
            &printed_eigenvalues,
            &eigenvalues,
            &reference::roots("/aircraft/spec_A")?,
            EIGENVALUE_TOLERANCE,
            "log(z)/T of the shared zeros, against the eigenvalues of A",
        ),
        order_in_print(example)?,
        sideslip_needed(example)?,
    ];
    for (difference, (id, outputs)) in example
        .result
        .differences
        .iter()
        .zip([("extra-roots-p", [0, 1]), ("extra-roots-r", [0, 2])])
    {
        checks.push(extra_roots(example, difference, id, outputs)?);
    }
    Ok(Part {
        title: "Figure 4: differences, shared zeros, eigenvalues",
        introduction: "The transmissibilities of the aileron record minus those of the rudder record. Their common zeros are the eigenvalues of the sampled \
                       aircraft; the other zeros are invariant zeros of the system from the two surfaces to the two sensors.",
        checks,
        blocks: vec![figure(example)?, result_table(example)?],
    })
}

/// The paper lists four zeros, then four eigenvalues in another order.
fn order_in_print(example: &AircraftExample) -> Result<Check, TaskError> {
    let nearest = |printed: f64| {
        let real = example.result.modes.iter().filter(|mode| mode.eigenvalue.im.abs() <= 0.0);
        let distance =
            |mode: &&paper::Mode| (example.result.shared.zeros[mode.shared].value - printed).norm();
        real.min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .map_or(f64::NAN, |mode| mode.eigenvalue.re)
    };
    let spectrum = reference::roots("/aircraft/spec_A")?;
    let mut real: Vec<f64> = spectrum.iter().filter(|z| z.im.abs() <= 0.0).map(|z| z.re).collect();
    real.sort_by(f64::total_cmp);
    Ok(Check::numbers(
        "aircraft-order",
        Print::Slip,
        &["-0.0016", "-0.5456"],
        &[nearest(0.9469), nearest(0.9998)],
        &real,
        EIGENVALUE_TOLERANCE,
        "what 0.9469 and 0.9998 map to, in the order of the print",
    ))
}

/// The abstract names two sensors. With roll rate and yaw rate alone there is one difference, and
/// nothing to tell eigenvalues from its other zeros.
fn sideslip_needed(example: &AircraftExample) -> Result<Check, TaskError> {
    let fault = TaskError::computation::<ReconstructError>(PART);
    let (roll_rate, yaw_rate) = (1, 2);
    let identified = |record: &Record| {
        paper::identify_transmissibility(
            record,
            roll_rate,
            yaw_rate,
            &IdentificationOptions::default(),
        )
        .map_err(fault)
    };
    let [aileron, rudder] = &example.records;
    let zeros = difference_zeros(&identified(aileron)?, &identified(rudder)?).map_err(fault)?.len();
    let order = example.aircraft.continuous.order();
    let computed =
        if zeros == order { "roll rate, yaw rate" } else { "sideslip, roll rate, yaw rate" };
    Ok(Check::exact(
        "aircraft-sideslip-needed",
        Print::Slip,
        "roll rate, yaw rate",
        computed,
        "sideslip, roll rate, yaw rate",
        &format!(
            "with the two rates alone there is one difference, and nothing tells the {order} eigenvalues among its {zeros} zeros"
        ),
    ))
}

/// What is left of a difference's zeros once the eigenvalues are taken, against the invariant zeros
/// of the two-input system.
fn extra_roots(
    example: &AircraftExample,
    difference: &Difference,
    id: &'static str,
    outputs: [usize; 2],
) -> Result<Check, TaskError> {
    let fault = TaskError::computation::<String>(PART);
    let zeros: Vec<_> = difference.zeros.iter().map(|zero| zero.value).collect();
    let extra = containment(&example.result.shared.values(), &zeros).extra;
    let square: StateSpace<_> = example
        .aircraft
        .discrete
        .subsystem(&outputs, &[0, 1])
        .map_err(|error| fault(error.to_string()))?;
    let invariant = square.invariant_zeros().map_err(|error| fault(error.to_string()))?;
    let invariant: Vec<_> = invariant.zeros.iter().map(|zero| zero.value).collect();
    let sensor = ["sideslip", "roll rate", "yaw rate"][outputs[1]];
    let note = format!(
        "zeros of the difference for the {sensor} that are no eigenvalues, against the invariant zeros of the 2 x 2 system"
    );
    Ok(Check::computed_roots(id, &extra, &invariant, 1e-8, &note))
}

/// The names of the reconstructed modes beside their shared zeros, told by what each mode looks
/// like in the sensors.
fn names(example: &AircraftExample) -> Result<Vec<(f64, f64, String)>, TaskError> {
    let modes: Vec<_> =
        example.result.modes.iter().filter(|mode| mode.eigenvalue.im >= 0.0).collect();
    let shape = |shape: &[Complex<f64>]| match shape {
        [sideslip, roll_rate, yaw_rate] => {
            Some(ModeShape::from_sensors(*sideslip, *roll_rate, *yaw_rate))
        }
        _ => None,
    };
    let pairs: Vec<_> = modes
        .iter()
        .map(|mode| Eigenpair { eigenvalue: mode.eigenvalue, shape: shape(&mode.shape) })
        .collect();
    let named = name_modes(&pairs).map_err(TaskError::computation(PART))?;
    let place = |mode: &paper::Mode| example.result.shared.zeros[mode.shared].value;
    Ok(named
        .iter()
        .zip(modes)
        .map(|(named, mode)| (place(mode).re, place(mode).im, named.name.to_string()))
        .collect())
}

fn figure(example: &AircraftExample) -> Result<Block, TaskError> {
    // 0.99984 is the spiral, 1 a zero of the difference for the roll rate alone.
    const CLOSEST: (f64, f64) = (0.9985, 1.0015);
    let caption = "One row for each pseudo output: the whole map, the neighbourhood of z = 1, and that of the spiral. Every true eigenvalue lies on a zero of both differences.";
    let mut figure = Figure::new(
        "figure-4",
        "Differences of the transmissibilities, aileron minus rudder",
        caption,
    )
    .columns(3);
    let truth = example.aircraft.discrete.poles().map_err(TaskError::computation(PART))?;
    let eigenvalues: Vec<_> = truth.into_iter().map(|z| (z.re, z.im)).collect();
    let names = names(example)?;
    for difference in &example.result.differences {
        let input = &example.records[0].channels()[0].name;
        let output = &example.records[0].channels()[difference.output].name;
        let with_points = |panel: Panel| {
            panel
                .with(Points::poles("pole", difference.poles.iter().map(|z| (z.re, z.im))))
                .with(Points::zeros(
                    "zero",
                    difference.zeros.iter().map(|zero| (zero.value.re, zero.value.im)),
                ))
                .with(Points::eigenvalues("true eigenvalue", eigenvalues.clone()))
        };
        figure = figure
            .with(
                with_points(Panel::z_plane(format!("{input} to {output}")))
                    .zoom((-1.35, 1.35), (-1.35, 1.35)),
            )
            .with(
                with_points(Panel::z_plane("near z = 1"))
                    .zoom((0.86, 1.1), (-0.2, 0.2))
                    .with(Notes::new(names.clone())),
            )
            .with(with_points(Panel::z_plane("near the spiral")).zoom(CLOSEST, (-0.0015, 0.0015)));
    }
    Ok(figure.into())
}

fn result_table(example: &AircraftExample) -> Result<Block, TaskError> {
    let fault = TaskError::computation(PART);
    let header =
        ["shared zero", "eigenvalue [rad/s]", "true eigenvalue [rad/s]", "frequency [rad/s]"];
    let mut table = Table::new("Reconstructed eigenvalues", header.map(Column::left));
    let truth = example.aircraft.continuous.poles().map_err(|error| fault(error.to_string()))?;
    for mode in example.result.modes.iter().filter(|mode| mode.eigenvalue.im >= 0.0) {
        let text = |z: Complex<f64>| format_conjugate_pair(z.re, z.im, 7);
        let distance = |z: &&Complex<f64>| (*z - mode.eigenvalue).norm();
        let nearest = truth
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .copied()
            .unwrap_or_default();
        table
            .push([
                text(example.result.shared.zeros[mode.shared].value),
                text(mode.eigenvalue),
                text(nearest),
                format_significant(mode.eigenvalue.norm(), 5),
            ])
            .map_err(|error| fault(error.to_string()))?;
    }
    Ok(table.into())
}
