//! What is true of simulated records, as JSON.

use std::collections::BTreeMap;

use aircraft::Surface;
use nalgebra::DMatrix;
use serde::Serialize;

use super::flights::{Flown, GUST_RAD_S, LOW_PASS_RAD_S, Simulator, plans};
use crate::CommandError;
use crate::args::ExcitationKind;
use crate::json::{self, Number};

#[derive(Serialize)]
struct Truth<'a> {
    schema: u32,
    aircraft: Aircraft<'a>,
    modes: Vec<ModeOutput>,
    /// In continuous time, states sideslip, roll rate, yaw rate and bank angle.
    states: [&'static str; 4],
    a: Vec<Vec<f64>>,
    sensors: Vec<&'static str>,
    c: Vec<Vec<f64>>,
    b: BTreeMap<String, Vec<f64>>,
    sample_period_s: f64,
    samples: usize,
    excitation: Excitation,
    gust: Gust,
    /// Standard deviation of each sensor's white noise, in its unit.
    noise_levels: BTreeMap<&'static str, f64>,
    seed: u64,
    records: Vec<RecordOutput>,
}

#[derive(Serialize)]
struct Aircraft<'a> {
    name: &'a str,
    source: &'a str,
}

/// A mode; a complex pair appears once, with a positive imaginary part.
#[derive(Serialize)]
struct ModeOutput {
    name: String,
    eigenvalue: Number,
}

#[derive(Serialize)]
struct Excitation {
    kind: &'static str,
    amplitude_rad: f64,
    /// Of the low-pass filter; `null` without one.
    corner_rad_s: Option<f64>,
}

#[derive(Serialize)]
struct Gust {
    deviation_rad: f64,
    corner_rad_s: f64,
}

#[derive(Serialize)]
struct RecordOutput {
    file: String,
    surfaces: Vec<String>,
}

/// The JSON text, indented, with a line feed at its end.
pub(super) fn render(simulator: &Simulator<'_>, flown: &Flown) -> Result<Vec<u8>, CommandError> {
    let args = simulator.args;
    let system = &simulator.continuous;
    let b = Surface::ALL.into_iter().enumerate();
    let sensors: Vec<&'static str> = args.outputs.iter().map(|sensor| sensor.name()).collect();
    let is_low_pass = args.excitation == ExcitationKind::Lowpass;
    let truth = Truth {
        schema: 1,
        aircraft: Aircraft { name: &simulator.aircraft.name, source: &simulator.aircraft.source },
        modes: simulator
            .modes()?
            .iter()
            .map(|mode| ModeOutput {
                name: mode.name.to_string(),
                eigenvalue: mode.eigenvalue.into(),
            })
            .collect(),
        states: ["beta", "p", "r", "phi"],
        a: rows(system.a()),
        c: rows(system.c()),
        b: b.map(|(j, surface)| {
            (surface.to_string(), system.b().column(j).iter().copied().collect())
        })
        .collect(),
        sample_period_s: simulator.period.seconds(),
        samples: simulator.samples(),
        excitation: Excitation {
            kind: args.excitation.name(),
            amplitude_rad: if args.excitation == ExcitationKind::None {
                0.0
            } else {
                args.amplitude
            },
            corner_rad_s: is_low_pass.then_some(LOW_PASS_RAD_S),
        },
        gust: Gust { deviation_rad: args.gust, corner_rad_s: GUST_RAD_S },
        noise_levels: sensors.iter().copied().zip(flown.levels.iter().copied()).collect(),
        sensors,
        seed: args.seed,
        records: plans(args)
            .iter()
            .map(|plan| RecordOutput {
                file: format!("{}.csv", plan.name),
                surfaces: plan.surfaces.iter().map(ToString::to_string).collect(),
            })
            .collect(),
    };
    json::text(&truth)
}

fn rows(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}
