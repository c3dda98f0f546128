//! A model that `transmode identify --inputs .. --json` wrote, under the inputs of another flight.

use std::io::Write;
use std::path::Path;

use lti::{Discrete, SamplePeriod, StateSpace};
use nalgebra::DMatrix;
use reconstruct::Record;
use reconstruct::output_error::{InputModel, RecordedInputs, Simulation, simulate};
use serde::Deserialize;

use crate::args::SimulateArgs;
use crate::numbers::without_rounding;
use crate::records::{LoadOptions, Loaded, Progress, load};
use crate::{CommandError, Exit, output};

/// What is needed of the file.
#[derive(Deserialize)]
struct Written {
    sample_period_s: f64,
    channels: Vec<String>,
    drift: Option<bool>,
    recorded_inputs: Option<WrittenModel>,
}

#[derive(Deserialize)]
struct WrittenModel {
    inputs: Vec<String>,
    lags: Vec<WrittenLag>,
    a: Vec<Vec<f64>>,
    b: Vec<Vec<f64>>,
    c: Vec<Vec<f64>>,
    d: Vec<Vec<f64>>,
}

#[derive(Deserialize)]
struct WrittenLag {
    value_s: f64,
}

/// What the sensors read and what the model says, in the folder that was asked for.
const FILE: &str = "simulated.csv";

/// Simulates the flight, writes it and says how well it fits.
pub(super) fn run(
    args: &SimulateArgs,
    flight: &Path,
    out: &mut dyn Write,
) -> Result<Exit, CommandError> {
    let (model, names, inputs) = read(Path::new(&args.aircraft))?;
    let files = [FILE.to_owned()];
    let overwrite =
        if args.force { output::Overwrite::Allowed } else { output::Overwrite::Refused };
    output::check_folder(&args.output, &files, overwrite)?;
    let mut options = LoadOptions::default();
    options.selection.outputs = names;
    options.known_inputs.clone_from(&inputs);
    options.inputs_may_be_missing = true;
    let Loaded { records, known_inputs, warnings, .. } =
        load(&[flight.to_owned()], &options, Progress::Hidden)?;
    let recorded = RecordedInputs { names: inputs, signals: known_inputs };
    let all = simulate(&records, &recorded, &model).map_err(|error| CommandError::InFile {
        file: flight.to_owned(),
        message: format!(
            "{error}; give a flight with the sensors and the sample period of the model"
        ),
    })?;
    let (Some(record), Some(found)) = (records.first(), all.first()) else {
        let message = "it holds no samples".to_owned();
        return Err(CommandError::InFile { file: flight.to_owned(), message });
    };
    if records.len() > 1 {
        let message =
            "gaps split it, and each part would start anew; cut it, or join it with --resample"
                .to_owned();
        return Err(CommandError::InFile { file: flight.to_owned(), message });
    }
    output::write_folder(&args.output, &[(FILE.to_owned(), table(record, found))], overwrite)?;
    let mut text = String::new();
    for warning in warnings {
        text += &format!("warning: {warning}\n");
    }
    for (channel, fit) in record.channels().iter().zip(&found.fit) {
        text += &format!("{}: {:.1} % predicted\n", channel.name, 100.0 * fit);
    }
    text += &format!("{}\n", args.output.join(FILE).display());
    output::write_whole(Path::new("-"), text.as_bytes(), out)?;
    Ok(Exit::Fine)
}

/// The model of a file, with the names of its sensors and of its inputs.
fn read(file: &Path) -> Result<(InputModel, Vec<String>, Vec<String>), CommandError> {
    let bytes = std::fs::read(file)
        .map_err(|source| CommandError::Read { file: file.to_owned(), source })?;
    let fault = |message: String| CommandError::InFile { file: file.to_owned(), message };
    let no_result = |why: String| {
        fault(format!("this is no result of transmode identify --json ({why}); write it again"))
    };
    let written: Written =
        serde_json::from_slice(&bytes).map_err(|error| no_result(error.to_string()))?;
    let Some(model) = written.recorded_inputs else {
        let message = "this result has no model with inputs; identify the flight with --inputs";
        return Err(fault(message.to_owned()));
    };
    let matrix = |rows: &[Vec<f64>], columns: usize| {
        let whole = rows.iter().all(|row| row.len() == columns);
        whole.then(|| DMatrix::from_fn(rows.len(), columns, |i, k| rows[i][k]))
    };
    let (order, inputs) = (model.a.len(), model.inputs.len());
    let parts = (
        matrix(&model.a, order),
        matrix(&model.b, inputs),
        matrix(&model.c, order),
        matrix(&model.d, inputs),
    );
    let (Some(a), Some(b), Some(c), Some(d)) = parts else {
        return Err(no_result("matrices of unequal rows".to_owned()));
    };
    let period = SamplePeriod::new(written.sample_period_s);
    let system = period.and_then(|period| StateSpace::<Discrete>::new(a, b, c, d, period));
    let system = system.map_err(|error| no_result(error.to_string()))?;
    let sensors = written.channels.len();
    if model.lags.len() != sensors + inputs {
        return Err(no_result("not one lag for each sensor and input".to_owned()));
    }
    let lags: Vec<f64> = model.lags.iter().map(|lag| lag.value_s).collect();
    let (sensor_lags, input_lags) = lags.split_at(sensors);
    let model_of = InputModel {
        system,
        sensor_lags: sensor_lags.to_vec(),
        input_lags: input_lags.to_vec(),
        drift: written.drift == Some(true),
    };
    Ok((model_of, written.channels, model.inputs))
}

/// Time, and each sensor as it was read and as it was simulated.
fn table(record: &Record, found: &Simulation) -> Vec<u8> {
    let mut text = b"time [s]".to_vec();
    for channel in record.channels() {
        // Writing to memory does not fail.
        let _ = write!(text, ",{0},{0}_simulated", channel.name);
    }
    for k in 0..record.samples() {
        let _ = write!(text, "\n{}", without_rounding(k as f64 * record.period().seconds()));
        for (channel, simulated) in record.channels().iter().zip(&found.sensors) {
            let _ = write!(text, ",{},{}", channel.values[k], simulated[k]);
        }
    }
    text.push(b'\n');
    text
}
