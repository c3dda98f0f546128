//! What the sensors read and what the model makes of the inputs, against time.

use reconstruct::Record;
use reconstruct::output_error::{Fit, Simulation, simulate};
use report::{Axis, Block, Dash, Figure, Ink, Line, Panel};

use super::TIME_HISTORIES_ID;
use crate::CommandError;
use crate::identify::outcome::Outcome;
use crate::identify::report_page::style::{LARGEST_RECORDS, LARGEST_SENSORS, drawn, with_unit};
use crate::identify::report_page::thinning::extremes;

/// Stretches of a signal of which the smallest and the largest sample are drawn: about one for each pixel.
const COLUMNS: usize = 300;

pub(super) fn blocks(input: &Outcome<'_>, fit: &Fit) -> Result<Vec<Block>, CommandError> {
    let fault = |error: reconstruct::ReconstructError| CommandError::Report(error.to_string());
    let own = simulate(input.records, &input.options.inputs, &fit.into()).map_err(fault)?;
    let seen = input.records.iter().zip(&own).enumerate().map(|(index, (record, simulation))| {
        (record, simulation, input.sources.get(index).map_or(0.0, |source| source.span_s[0]), "")
    });
    let unseen = input
        .predictions
        .iter()
        .map(|own| (&own.record, &own.simulation, 0.0, " (not part of the fit)"));
    let all: Vec<_> = seen.chain(unseen).collect();
    let sensors = input.records.first().map_or(0, |record| record.channels().len());
    let shown = sensors.min(LARGEST_SENSORS);
    let caption = format!(
        "What the sensors read, and what the model makes of the recorded inputs. Initial state and offsets are those that come closest; nothing else is fitted here. The \
         percentage is 100 for a perfect simulation and 0 for one that is no better than the mean.{}{}",
        drawn(all.len(), LARGEST_RECORDS, "records"),
        drawn(sensors, LARGEST_SENSORS, "sensors")
    );
    let columns = if shown > 3 { shown.div_ceil(2) } else { shown };
    let mut figure =
        Figure::new(TIME_HISTORIES_ID, "Measured and simulated", caption).columns(columns);
    for (record, simulation, start_s, note) in all.into_iter().take(LARGEST_RECORDS) {
        for sensor in 0..shown {
            figure = figure.with(panel(input, (record, simulation), start_s, note, sensor));
        }
    }
    Ok(vec![Block::section("Measured and simulated"), figure.into()])
}

fn panel(
    input: &Outcome<'_>,
    (record, simulation): (&Record, &Simulation),
    start_s: f64,
    note: &str,
    sensor: usize,
) -> Panel {
    let channel = &record.channels()[sensor];
    let time = |k: usize| start_s + k as f64 * record.period().seconds();
    let points = |values: &[f64]| -> Vec<(f64, f64)> {
        extremes(values, COLUMNS).into_iter().map(|k| (time(k), values[k])).collect()
    };
    let percent = 100.0 * simulation.fit[sensor];
    let title = format!("{}, {}{note}: {percent:.1} %", channel.name, record.name());
    let end = time(record.samples().saturating_sub(1)).max(start_s + record.period().seconds());
    let x = Axis::linear("time (s)").range(start_s, end);
    let y = Axis::linear(with_unit(input, 0, sensor));
    Panel::new(title, x, y)
        .with(Line::new("measured", Dash::Solid, points(&channel.values)).ink(Ink::Grey).width(2.2))
        .with(
            Line::new("simulated", Dash::Solid, points(&simulation.sensors[sensor]))
                .ink(Ink::Vermillion)
                .width(1.0),
        )
}
