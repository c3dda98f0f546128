//! Two simulated flights of the paper's aircraft, and the eigenvalues found in their records alone.
//!
//! `cargo run -p reconstruct --example modes_from_records`

use std::error::Error;
use std::io::Write;

use aircraft::{LateralModel, LateralState, SideForceScaling, Surface, catalog};
use lti::{Discrete, SamplePeriod, StateSpace};
use nalgebra::DMatrix;
use reconstruct::{AsPrintedOptions, Channel, Record, as_printed};

const SENSORS: [LateralState; 3] =
    [LateralState::Sideslip, LateralState::RollRate, LateralState::YawRate];

fn main() -> Result<(), Box<dyn Error>> {
    let model =
        LateralModel::new(catalog::PAPER_AIRCRAFT.derivatives, catalog::PAPER_AIRCRAFT.inertia)?;
    let system = model
        .state_space(&Surface::ALL, SideForceScaling::AsPrinted, &SENSORS)?
        .zoh(SamplePeriod::new(0.1)?)?;
    let records = [flight("aileron", 0, &system)?, flight("rudder", 1, &system)?];
    // From here on nobody knows the system or what moved.
    let result = as_printed(&records, &AsPrintedOptions::default())?;
    let mut out = std::io::stdout().lock();
    for (mode, zero) in result.modes.iter().zip(&result.shared.zeros) {
        writeln!(
            out,
            "{:.9} 1/s   (differences agree within {:.0e})",
            mode.eigenvalue, zero.spread
        )?;
    }
    for doubt in &result.doubts {
        writeln!(out, "{doubt}")?;
    }
    Ok(())
}

/// 100 s with one surface jerked about by a small pseudo-random generator.
fn flight(
    name: &str,
    surface: usize,
    system: &StateSpace<Discrete>,
) -> Result<Record, Box<dyn Error>> {
    let mut state = 1 + u32::try_from(surface)?;
    let excitation = DMatrix::from_fn(1, 1000, |_, _| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state) / f64::from(u32::MAX) - 0.5
    });
    let outputs = system.subsystem(&[0, 1, 2], &[surface])?.simulate(&excitation, None)?.outputs;
    let channel =
        |(row, name): (usize, &str)| Channel::new(name, outputs.row(row).iter().copied().collect());
    let channels = ["beta", "p", "r"].into_iter().enumerate().map(channel).collect();
    Ok(Record::new(name, system.period(), channels)?)
}
