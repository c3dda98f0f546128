//! The lateral model of part VI: its matrices and its eigenvalues.

use aircraft::LateralState;
use aircraft::{ModeName, SideForceScaling, Surface, name_system_modes};
use num_complex::Complex;
use report::{Block, Column, Table, format_conjugate_pair, format_significant};

use super::check::{Check, Print};
use super::{AircraftExample, Part};
use crate::TaskError;
use crate::shared::reference;

const PART: &str = "aircraft";

pub(crate) fn build(example: &AircraftExample) -> Result<Part, TaskError> {
    let fault = TaskError::computation::<String>(PART);
    let row_major =
        |matrix: &nalgebra::DMatrix<f64>| matrix.transpose().iter().copied().collect::<Vec<_>>();
    let rudder = |scaling| {
        example
            .aircraft
            .model
            .control_matrix(Surface::Rudder, scaling)
            .iter()
            .copied()
            .collect::<Vec<_>>()
    };
    let column = |pointer: &str, index: usize| -> Result<Vec<f64>, TaskError> {
        Ok(reference::matrix(pointer)?.into_iter().skip(index).step_by(2).collect())
    };
    let full = example
        .aircraft
        .model
        .state_space(&Surface::ALL, SideForceScaling::AsPrinted, &LateralState::ALL)
        .map_err(|error| fault(error.to_string()))?;
    let named = name_system_modes(&full).map_err(|error| fault(error.to_string()))?;
    let eigenvalue = |name: ModeName| -> Vec<Complex<f64>> {
        let found = named.iter().filter(|mode| mode.name == name).map(|mode| mode.eigenvalue);
        found
            .flat_map(|value| if value.im > 0.0 { vec![value, value.conj()] } else { vec![value] })
            .collect()
    };
    let spectrum = reference::roots("/aircraft/spec_A")?;
    let reference_mode = |belongs: fn(&Complex<f64>) -> bool| {
        spectrum.iter().copied().filter(belongs).collect::<Vec<_>>()
    };
    let checks = vec![
        Check::computed(
            "aircraft-a",
            &row_major(&example.aircraft.model.a()),
            &reference::matrix("/aircraft/as_printed/A")?,
            1e-15,
            "A of (46), row by row",
        ),
        Check::computed(
            "aircraft-b-aileron",
            example
                .aircraft
                .model
                .control_matrix(Surface::Aileron, SideForceScaling::AsPrinted)
                .as_slice(),
            &column("/aircraft/as_printed/B", 0)?,
            4e-15,
            "B of the aileron",
        ),
        Check::computed(
            "aircraft-b-rudder-printed",
            &rudder(SideForceScaling::AsPrinted),
            &column("/aircraft/as_printed/B", 1)?,
            4e-15,
            "B of the rudder with Y undivided, as printed and as used below",
        ),
        Check::numbers(
            "aircraft-b-rudder",
            Print::Slip,
            &["10.4733"],
            &rudder(SideForceScaling::Dimensional)[..1],
            &column("/aircraft/dimensional/B", 1)?[..1],
            1e-16,
            "first entry of B of the rudder: Y over U_0 is an angular rate, Y alone is an acceleration",
        ),
        Check::computed(
            "aircraft-sampled-a",
            &row_major(example.aircraft.discrete.a()),
            &reference::matrix("/aircraft/as_printed/Ad")?,
            1e-15,
            "A of the system sampled every 0.1 s",
        ),
        Check::roots(
            "aircraft-dutch-roll",
            Print::Right,
            &[("-0.0706", "1.6917")],
            &eigenvalue(ModeName::DutchRoll),
            &reference_mode(|z| z.im.abs() > 0.0),
            1e-12,
            "named from the eigenvector",
        ),
        Check::roots(
            "aircraft-spiral",
            Print::Right,
            &[("-0.0016", "0")],
            &eigenvalue(ModeName::Spiral),
            &reference_mode(|z| z.im.abs() <= 0.0 && z.re > -0.1),
            1e-12,
            "named from the eigenvector",
        ),
        Check::roots(
            "aircraft-roll",
            Print::Slip,
            &[("-0.5455", "0")],
            &eigenvalue(ModeName::RollSubsidence),
            &reference_mode(|z| z.im.abs() <= 0.0 && z.re < -0.1),
            1e-12,
            "-0.545563 rounds to -0.5456; the print is truncated",
        ),
    ];
    Ok(Part {
        title: "The aircraft of part VI",
        introduction: "The lateral dynamics (46) with the derivatives that the paper prints. Entries are compared with 60-digit arithmetic.",
        checks,
        blocks: vec![mode_table(example)?],
    })
}

/// The modes of the true system, for the reader.
fn mode_table(example: &AircraftExample) -> Result<Block, TaskError> {
    let fault = TaskError::computation(PART);
    let full = example
        .aircraft
        .model
        .state_space(&Surface::ALL, SideForceScaling::AsPrinted, &LateralState::ALL)
        .map_err(|error| fault(error.to_string()))?;
    let named = name_system_modes(&full).map_err(|error| fault(error.to_string()))?;
    let modes = full.modes().map_err(|error| fault(error.to_string()))?;
    let header =
        ["mode", "eigenvalue [rad/s]", "frequency [rad/s]", "damping ratio", "time to half [s]"];
    let mut table = Table::new("Modes of the aircraft", header.map(Column::left));
    for (named, mode) in named.iter().zip(&modes) {
        let number = |value: f64| format_significant(value, 5);
        table
            .push([
                named.name.to_string(),
                format_conjugate_pair(mode.eigenvalue.re, mode.eigenvalue.im, 6),
                number(mode.natural_frequency_rad_s),
                number(mode.damping_ratio),
                number(mode.time_to_half_or_double_s),
            ])
            .map_err(|error| fault(error.to_string()))?;
    }
    Ok(table.into())
}
