//! What the sensors read, against time.

use report::{Axis, Block, Dash, Figure, Ink, Legend, Line, Panel};

use super::style;
use super::style::{LARGEST_RECORDS, LARGEST_SENSORS, channel_name, drawn, with_unit};
use super::thinning::extremes;
use crate::CommandError;
use crate::identify::outcome::Outcome;

pub(super) const ID: &str = "records";

/// Stretches of a signal of which the smallest and the largest sample are drawn: about one for each pixel.
const COLUMNS: usize = 300;

pub(super) fn blocks(input: &Outcome<'_>) -> Result<Vec<Block>, CommandError> {
    let sensors = input.records.first().map_or(0, |record| record.channels().len());
    let shown = sensors.min(LARGEST_SENSORS);
    let thinned = input.records.iter().any(|record| record.samples() > 2 * COLUMNS);
    let note = if thinned {
        " Of long records the smallest and the largest sample of each of 300 stretches are drawn, so that no peak is lost."
    } else {
        ""
    };
    let caption = format!(
        "What the sensors read, after conversion of units and decimation.{note}{}{}",
        drawn(input.records.len(), LARGEST_RECORDS, "records"),
        drawn(sensors, LARGEST_SENSORS, "sensors")
    );
    let columns = if shown > 3 { shown.div_ceil(2) } else { shown };
    let mut figure = Figure::new(ID, "Records", caption).columns(columns).legend(Legend::Hidden);
    for (index, record) in input.records.iter().take(LARGEST_RECORDS).enumerate() {
        let start_s = input.sources.get(index).map_or(0.0, |source| source.span_s[0]);
        for sensor in 0..shown {
            let Ok(channel) = record.get(sensor) else { continue };
            let time = |k: usize| start_s + k as f64 * record.period().seconds();
            let xy: Vec<(f64, f64)> = extremes(&channel.values, COLUMNS)
                .into_iter()
                .map(|k| (time(k), channel.values[k]))
                .collect();
            let (first, last) = (time(0), time(record.samples().saturating_sub(1)));
            let title = format!("{}, {}", channel_name(input, sensor), record.name());
            let x =
                Axis::linear("time (s)").range(first, last.max(first + record.period().seconds()));
            let (ink, _) = style::look(index);
            let ink = if ink == Ink::Black { Ink::Grey } else { ink };
            let panel = Panel::new(title, x, Axis::linear(with_unit(input, index, sensor)));
            figure = figure.with(panel.with(Line::new("", Dash::Solid, xy).ink(ink).width(0.9)));
        }
    }
    Ok(vec![Block::section("Records"), figure.into()])
}
