//! Group 6: from raw records with noise to modes with confidence.

use reconstruct::{Method, Options, Reconstruction, reconstruct};

use super::times::{TimeRow, times_table};
use super::timing::{Runs, measure as time, show_seconds};
use super::{Bench, Group};
use crate::TaskError;
use crate::shared::asked::{Asked, Row, asked_and_reached};
use crate::shared::noisy_flights::{Excitation, Pair, Simulator};

const SEED: u64 = 1;
/// Samples of the long records.
const MANY: usize = 1_000_000;

pub(crate) fn measure(bench: &Bench) -> Result<Group, TaskError> {
    let simulator = Simulator::new()?;
    let short = |ratio| simulator.fly(Excitation::White, ratio, SEED);
    let (clear, noisy) = (short(100.0)?, short(10.0)?);
    bench.say("noise: records of 2000 samples");
    let modes = |pair: &Pair, method| time(Runs::MANY, || modes(pair, method));
    let subspace = modes(&clear, Method::Subspace)?;
    let likelihood = modes(&clear, Method::MaximumLikelihood)?;
    let at_ten = modes(&noisy, Method::MaximumLikelihood)?;
    bench.say("noise: records of 1e6 samples");
    let long = simulator.fly_samples(Excitation::White, 100.0, SEED, MANY)?;
    let million = time(Runs::FEW, || self::modes(&long, Method::MaximumLikelihood))?;
    let rows = [
        Row::new(
            "2000 samples, ratio 100: modes with confidence",
            Asked::AtMost(50e-3),
            likelihood.median(),
            show_seconds,
        ),
        Row::new(
            "1e6 samples, ratio 100: modes with confidence",
            Asked::AtMost(15.0),
            million.median(),
            show_seconds,
        ),
    ];
    let times = [
        TimeRow::ours("2000 samples, ratio 100, subspaces", &subspace, "modes without deviations"),
        TimeRow::ours("2000 samples, ratio 100", &likelihood, "modes with deviations"),
        TimeRow::ours("2000 samples, ratio 10", &at_ten, "three numbers of block rows start"),
        TimeRow::ours("1e6 samples, ratio 100", &million, "modes with deviations"),
    ];
    Ok(Group {
        title: "Records with noise",
        introduction: "Two records of the paper's aircraft, white excitation, three sensors, signal to noise ratio as given; order and noise levels \
             are found. From the samples to modes, deviations, tests of fit and doubts, on one thread."
            .to_owned(),
        blocks: vec![
            asked_and_reached("Records with noise: asked and reached", &rows)?,
            times_table("Records with noise: times", &times)?,
        ],
    })
}

fn modes(pair: &Pair, method: Method) -> Result<Reconstruction, TaskError> {
    let mut options = Options::default();
    options.method = method;
    reconstruct(&pair.records, &options).map_err(TaskError::computation("reconstruction"))
}
