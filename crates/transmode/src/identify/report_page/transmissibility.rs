//! How large one sensor's reading is beside another's, as the fitted system has it.

use std::f64::consts::{PI, TAU};

use reconstruct::likelihood::{ComplexEstimate, FittedTransmissibility, fitted_transmissibilities};
use report::{Axis, Band, Block, Figure, Line, Panel};

use super::style::{LARGEST_RECORDS, channel_name, drawn, look, ratio};
use crate::CommandError;
use crate::identify::outcome::Outcome;

pub(super) const ID: &str = "transmissibilities";

/// Points of a curve.
const POINTS: u32 = 160;

/// As many pairs of sensors are drawn.
const LARGEST_PAIRS: usize = 9;

pub(super) fn blocks(input: &Outcome<'_>) -> Result<Vec<Block>, CommandError> {
    let mut blocks = vec![Block::section("Transmissibilities")];
    let Some(fit) = input.result.fit() else {
        blocks.push(Block::paragraph(
            "Transmissibilities with their confidence come from maximum likelihood alone.",
        ));
        return Ok(blocks);
    };
    let frequencies = frequencies(input);
    let found = match fitted_transmissibilities(fit, &frequencies) {
        Ok(found) => found,
        Err(error) => {
            blocks.push(Block::paragraph(format!("They cannot be drawn: {error}.")));
            return Ok(blocks);
        }
    };
    let mut pairs: Vec<(usize, usize)> = found.iter().map(|each| (each.from, each.to)).collect();
    pairs.sort_unstable();
    pairs.dedup();
    let caption = format!(
        "Magnitude of the ratio of two sensors in each record, with 95 % bands. The unknown excitation cancels; records with other excitations have \
         other ratios, and agree at the eigenvalues only.{}{}",
        drawn(pairs.len(), LARGEST_PAIRS, "pairs of sensors"),
        drawn(input.records.len(), LARGEST_RECORDS, "records")
    );
    let columns = pairs.len().clamp(1, 3);
    let mut figure =
        Figure::new(ID, "Transmissibilities of the fitted system", caption).columns(columns);
    for (from, to) in pairs.into_iter().take(LARGEST_PAIRS) {
        let title = format!("{} to {}", channel_name(input, from), channel_name(input, to));
        let y = Axis::log(ratio(input, to, from));
        let mut panel = Panel::new(title, Axis::log("frequency (rad/s)"), y);
        let own = found.iter().filter(|each| (each.from, each.to) == (from, to));
        for each in own.filter(|each| each.record < LARGEST_RECORDS) {
            panel = with_curve(panel, input, each, &frequencies);
        }
        if !panel.series.is_empty() {
            figure = figure.with(panel);
        }
    }
    if !figure.panels.is_empty() {
        blocks.push(figure.into());
    }
    Ok(blocks)
}

/// From one turn in the longest record up to half the sampling frequency, evenly spaced on a logarithmic axis.
fn frequencies(input: &Outcome<'_>) -> Vec<f64> {
    let period = input.records.first().map_or(1.0, |record| record.period().seconds());
    let samples = input.records.iter().map(reconstruct::Record::samples).max().unwrap_or(1);
    let (low, high) = (TAU / (period * samples.max(4) as f64), PI / period);
    let at = |k: u32| low * (high / low).powf(f64::from(k) / f64::from(POINTS));
    (0..=POINTS).map(at).collect()
}

fn with_curve(
    panel: Panel,
    input: &Outcome<'_>,
    each: &FittedTransmissibility,
    frequencies: &[f64],
) -> Panel {
    let (ink, dash) = look(each.record);
    let bands = frequencies.iter().zip(&each.response).filter_map(|(x, response)| {
        magnitude_95(response).map(|(middle, factor)| (*x, middle, factor))
    });
    let bands: Vec<(f64, f64, f64)> = bands.collect();
    if bands.is_empty() {
        return panel;
    }
    let name = input.records.get(each.record).map_or("", |record| record.name());
    let line = bands.iter().map(|(x, middle, _)| (*x, *middle));
    let band = bands.iter().map(|(x, middle, factor)| (*x, middle / factor, middle * factor));
    panel.with(Band::new("", band).ink(ink)).with(Line::new(name, dash, line).ink(ink))
}

/// The modulus, and the factor by which it may be larger or smaller with 95 %; `None` where it is zero or nothing is known.
fn magnitude_95(response: &ComplexEstimate) -> Option<(f64, f64)> {
    /// Beyond this a band says no more than that nothing is known.
    const LARGEST: f64 = 100.0;
    let modulus = response.value.norm();
    let (re, im) = (response.value.re / modulus, response.value.im / modulus);
    let covariance = &response.covariance;
    let variance = re * re * covariance[(0, 0)]
        + 2.0 * re * im * covariance[(0, 1)]
        + im * im * covariance[(1, 1)];
    let factor = (1.96 * variance.max(0.0).sqrt() / modulus).exp().min(LARGEST);
    (modulus.is_finite() && modulus > 0.0 && factor.is_finite()).then_some((modulus, factor))
}
