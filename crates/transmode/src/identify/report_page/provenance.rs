//! Where the numbers come from: program, files, noise.

use reconstruct::{NoiseModel, Record};
use report::{Block, Column, Table, format_significant};

use super::style::with_unit;
use crate::CommandError;
use crate::identify::outcome::Outcome;

pub(super) fn blocks(input: &Outcome<'_>) -> Result<Vec<Block>, CommandError> {
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
            Column::right("samples"),
            Column::right("period (s)"),
            Column::right("from (s)"),
            Column::right("to (s)"),
        ],
    );
    for (index, record) in input.records.iter().enumerate() {
        table.push(row(input, index, record)).map_err(fault)?;
    }
    blocks.push(table.into());
    let mut files: Vec<String> = Vec::new();
    for source in input.sources {
        let file = format!("`{}`", source.file.display());
        if !files.contains(&file) {
            files.push(file);
        }
    }
    blocks.push(Block::paragraph("Files:"));
    blocks.push(Block::bullets(files));
    if let NoiseModel::Quiet(quiet) = &input.options.noise {
        blocks.push(Block::paragraph(format!(
            "The noise is that of the quiet record {} with {} samples.",
            quiet.name(),
            quiet.samples()
        )));
    }
    if let Some(levels) = input.result.noise_levels() {
        let mut table = Table::new(
            "Noise of the sensors",
            [
                Column::left("sensor"),
                Column::right("standard deviation"),
                Column::right("± of that"),
            ],
        );
        for (sensor, level) in levels.iter().enumerate() {
            let deviation = if level.standard_error > 0.0 {
                format_significant(level.standard_error, 2)
            } else {
                "-".to_owned()
            };
            let name = with_unit(input, 0, sensor);
            table.push([name, format_significant(level.value, 4), deviation]).map_err(fault)?;
        }
        blocks.push(table.into());
    }
    if let Some(error) = input.result.fit().and_then(|fit| fit.model_error) {
        blocks.push(Block::paragraph(format!(
            "Beside the noise a relative model error of {} ± {} % of what the sensors read: nonlinearity, coupling, whatever no linear system explains. It is part of the \
             standard errors.",
            format_significant(100.0 * error.value, 2),
            format_significant(100.0 * error.standard_error, 2)
        )));
    }
    let offsets = input.result.offsets();
    if !offsets.is_empty() {
        let columns =
            [Column::left("sensor"), Column::right("offset"), Column::right("standard error")];
        let mut table = Table::new("Offsets of the sensors, common to all records", columns);
        for (sensor, offset) in offsets.iter().enumerate() {
            let error = format_significant(offset.standard_error, 2);
            let name = with_unit(input, 0, sensor);
            table.push([name, format_significant(offset.value, 4), error]).map_err(fault)?;
        }
        blocks.push(table.into());
    }
    Ok(blocks)
}

fn row(input: &Outcome<'_>, index: usize, record: &Record) -> [String; 5] {
    let source = input.sources.get(index);
    let time =
        |end: usize| source.map_or_else(|| "-".to_owned(), |source| short(source.span_s[end]));
    [
        record.name().to_owned(),
        record.samples().to_string(),
        short(record.period().seconds()),
        time(0),
        time(1),
    ]
}

/// At most nine digits, without zeros at the end.
fn short(value: f64) -> String {
    let text = format_significant(value, 9);
    if !text.contains('.') || text.contains('e') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
