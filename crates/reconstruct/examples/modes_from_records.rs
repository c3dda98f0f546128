//! Two simulated flights of the paper's aircraft, and the eigenvalues found in their records alone.
//!
//! `cargo run -p reconstruct --example modes_from_records`

use std::error::Error;
use std::io::Write;

use aircraft::{LateralModel, LateralState, SideForceScaling, Surface, catalog};
use flight::Stream;
use lti::{Discrete, SamplePeriod, StateSpace};
use reconstruct::paper::{Options, identify};
use reconstruct::{Channel, Record};

const SENSORS: [LateralState; 3] =
    [LateralState::Sideslip, LateralState::RollRate, LateralState::YawRate];

fn main() -> Result<(), Box<dyn Error>> {
    let model =
        LateralModel::new(catalog::PAPER_AIRCRAFT.derivatives, catalog::PAPER_AIRCRAFT.inertia)?;
    let system = model
        .state_space(&Surface::ALL, SideForceScaling::AsPrinted, &SENSORS)?
        .zoh(SamplePeriod::new(0.1)?)?;
    let records = [fly("aileron", 0, &system)?, fly("rudder", 1, &system)?];
    // From here on nobody knows the system or what moved.
    let result = identify(&records, &Options::default())?;
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

/// 100 s with one surface moved by white noise.
fn fly(
    name: &str,
    surface: usize,
    system: &StateSpace<Discrete>,
) -> Result<Record, Box<dyn Error>> {
    let excitation = flight::normal(1, 1000, &mut Stream::new(1, u64::try_from(surface)?));
    let outputs = system.subsystem(&[0, 1, 2], &[surface])?.simulate(&excitation, None)?.outputs;
    let channel =
        |(row, name): (usize, &str)| Channel::new(name, outputs.row(row).iter().copied().collect());
    let channels = ["beta", "p", "r"].into_iter().enumerate().map(channel).collect();
    Ok(Record::new(name, system.period(), channels)?)
}
