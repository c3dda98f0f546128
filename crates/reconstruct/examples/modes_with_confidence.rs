//! Two simulated flights of the paper's aircraft with sensor noise of 1 %, and their modes with deviations, knowing neither inputs nor noise.
//!
//! `cargo run --release -p reconstruct --example modes_with_confidence [samples]`

use std::error::Error;
use std::io::Write;
use std::time::Instant;

use aircraft::{LateralModel, LateralState, SideForceScaling, Surface, catalog};
use flight::Stream;
use lti::{Discrete, SamplePeriod, StateSpace};
use nalgebra::DMatrix;
use reconstruct::{Channel, Method, Options, Record, reconstruct};

const SENSORS: [LateralState; 3] =
    [LateralState::Sideslip, LateralState::RollRate, LateralState::YawRate];

fn main() -> Result<(), Box<dyn Error>> {
    let samples = std::env::args().nth(1).map_or(Ok(2000), |text| text.parse())?;
    let model =
        LateralModel::new(catalog::PAPER_AIRCRAFT.derivatives, catalog::PAPER_AIRCRAFT.inertia)?;
    let system = model
        .state_space(&Surface::ALL, SideForceScaling::AsPrinted, &SENSORS)?
        .zoh(SamplePeriod::new(0.1)?)?;
    let mut random = Stream::new(1, 0);
    let levels = [0.03, 0.076, 0.059];
    let records = [
        fly("aileron", 0, &system, samples, &levels, &mut random)?,
        fly("rudder", 1, &system, samples, &levels, &mut random)?,
    ];
    // From here on nobody knows what moved.
    let mut out = std::io::stdout().lock();
    let mut options = Options::default();
    options.method = Method::Subspace;
    let clock = Instant::now();
    reconstruct(&records, &options)?;
    writeln!(out, "subspaces {:.1?}", clock.elapsed())?;
    options.method = Method::MaximumLikelihood;
    let clock = Instant::now();
    let found = reconstruct(&records, &options)?;
    writeln!(out, "everything {:.1?}", clock.elapsed())?;
    for estimate in found.modes.iter().filter_map(|found| found.estimate.as_ref()) {
        let (s, re, im) = (
            estimate.continuous.value,
            estimate.continuous.real_standard_error(),
            estimate.continuous.imaginary_standard_error(),
        );
        writeln!(out, "{:.5} +- {re:.5}  {:+.5}j +- {im:.5} 1/s", s.re, s.im)?;
    }
    for level in found.noise_levels().iter().flatten() {
        writeln!(out, "noise level {:.5} +- {:.5}", level.value, level.standard_error)?;
    }
    for test in found.fit().map_or(&[][..], |fit| &fit.whiteness) {
        writeln!(out, "residuals of {} white? p = {:.2}", test.record, test.p_value)?;
    }
    for doubt in &found.doubts {
        writeln!(out, "doubt: {doubt}")?;
    }
    Ok(())
}

/// One surface moves at random, each sensor with noise.
fn fly(
    name: &str,
    input: usize,
    system: &StateSpace<Discrete>,
    samples: usize,
    levels: &[f64],
    random: &mut Stream,
) -> Result<Record, Box<dyn Error>> {
    let mut inputs = DMatrix::zeros(2, samples);
    for entry in inputs.row_mut(input).iter_mut() {
        *entry = random.normal();
    }
    let outputs = system.simulate(&inputs, None)?.outputs;
    let channels =
        SENSORS.iter().zip(levels).zip(outputs.row_iter()).map(|((sensor, level), row)| {
            let noisy = row.into_iter().map(|value| value + level * random.normal());
            Channel::new(format!("{sensor:?}"), noisy.collect())
        });
    let channels = channels.collect();
    Ok(Record::new(name, system.period(), channels)?)
}
