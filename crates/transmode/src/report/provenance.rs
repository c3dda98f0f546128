//! Where the numbers come from: program, files, noise.

use reconstruct::{NoiseModel, Record};
use report::{Block, Column, Table, format_significant};

use super::Input;
use super::style::{channel_name, with_unit};
use crate::CommandError;

pub(super) fn blocks(input: &Input<'_>) -> Result<Vec<Block>, CommandError> {
    let fault = |error: report::ReportError| CommandError::Report(error.to_string());
    let mut blocks = vec![Block::section("Where this comes from")];
    blocks.push(Block::paragraph(format!(
        "Computed by transmode {} with the command at the top, from these records:",
        env!("CARGO_PKG_VERSION")
    )));
    let mut table = Table::new(
        "Records",
        [
            Column::left("record"),
            Column::left("file"),
            Column::right("samples"),
            Column::right("period (s)"),
            Column::right("from (s)"),
            Column::right("to (s)"),
            Column::left("sensors"),
        ],
    );
    for (index, record) in input.records.iter().enumerate() {
        table.push(row(input, index, record)).map_err(fault)?;
    }
    blocks.push(table.into());
    if let NoiseModel::Quiet(quiet) = &input.options.noise {
        blocks.push(Block::paragraph(format!(
            "The noise is that of the quiet record {} with {} samples.",
            quiet.name(),
            quiet.samples()
        )));
    }
    if let Some(levels) = &input.result.noise_levels {
        let mut table = Table::new(
            "Noise of the sensors",
            [
                Column::left("sensor"),
                Column::right("standard deviation"),
                Column::right("± of that"),
            ],
        );
        for (sensor, level) in levels.iter().enumerate() {
            let deviation = if level.deviation > 0.0 {
                format_significant(level.deviation, 2)
            } else {
                "-".to_owned()
            };
            let name = with_unit(input, 0, sensor);
            table.push([name, format_significant(level.value, 4), deviation]).map_err(fault)?;
        }
        blocks.push(table.into());
    }
    Ok(blocks)
}

fn row(input: &Input<'_>, index: usize, record: &Record) -> [String; 7] {
    let source = input.sources.get(index);
    let time = |end: usize| {
        source.map_or_else(|| "-".to_owned(), |source| format_significant(source.span_s[end], 9))
    };
    let sensors: Vec<String> = (0..record.channels().len())
        .map(|sensor| {
            if source.is_some() {
                with_unit(input, index, sensor)
            } else {
                channel_name(input, sensor).to_owned()
            }
        })
        .collect();
    [
        record.name().to_owned(),
        source.map_or_else(|| "-".to_owned(), |source| source.file.display().to_string()),
        record.samples().to_string(),
        format_significant(record.period().seconds(), 9),
        time(0),
        time(1),
        sensors.join(", "),
    ]
}
