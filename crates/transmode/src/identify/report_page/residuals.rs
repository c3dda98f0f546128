//! Is what is left over noise? Its spectrum, and whether it is white.

use reconstruct::likelihood::SpectralFit;
use report::{Axis, Band, Block, Figure, Guide, Ink, Line, Marker, Panel, Points};

use super::style::{LARGEST_RECORDS, drawn, look};
use super::thinning::logarithmic;
use crate::identify::outcome::Outcome;

pub(super) const ID: &str = "residuals";
pub(super) const WHITENESS_ID: &str = "whiteness";

/// Points of a spectrum: few, so that each is a mean of many frequencies.
const BINS: usize = 40;

/// The normal distribution holds 95 % within this many deviations.
const NORMAL_95: f64 = 1.959_963_984_540_054;

/// The statistic of Kolmogorov and Smirnov stays below this over the root of the number with 95 %.
const KOLMOGOROV_95: f64 = 1.358;

pub(super) fn blocks(input: &Outcome<'_>, fits: &[SpectralFit]) -> Vec<Block> {
    let mut blocks = vec![Block::section("Residuals")];
    let shown = &fits[..fits.len().min(LARGEST_RECORDS)];
    let left_out = drawn(fits.len(), LARGEST_RECORDS, "records");
    blocks.extend(spectrum(shown, &left_out));
    blocks.extend(whiteness(input, shown, &left_out));
    if let Some(goodness) = input.result.fit().map(|fit| fit.chi_squared) {
        let chance = goodness.p_value.map_or_else(
            || "; it is 1 by construction where noise levels are estimated".to_owned(),
            |p| format!(", larger with probability {}", report::format_significant(p, 2)),
        );
        blocks.push(Block::paragraph(format!(
            "Chi-squared per degree of freedom is {} with {} degrees of freedom{chance}.",
            report::format_significant(goodness.per_degree_of_freedom(), 4),
            format_args!("{:.0}", goodness.degrees_of_freedom),
        )));
    }
    blocks
}

/// The residuals of each record, a panel each, with the range of white noise.
fn spectrum(fits: &[SpectralFit], left_out: &str) -> Option<Block> {
    let caption = format!(
        "What no excitation explains, in units of the noise, averaged over steps of the logarithmic axis. Where the model holds, 19 of 20 points lie within \
         the band. A peak is a mode, a second excitation or a disturbance that the model does not have.{left_out}"
    );
    let columns = fits.len().clamp(1, 3);
    let mut figure = Figure::new(ID, "Spectra of the residuals", caption).columns(columns);
    for (index, fit) in fits.iter().enumerate() {
        let bins = logarithmic(&fit.frequencies_rad_s, BINS);
        let (mut band, mut points) = (Vec::new(), Vec::new());
        for bin in &bins {
            let degrees = 2.0 * (bin.places.len() * (fit.sensors.len() - 1)) as f64;
            let (low, high) = range_95(degrees);
            band.push((bin.frequency_rad_s, low, high));
            points.push((bin.frequency_rad_s, bin.mean(&fit.residuals)));
        }
        points.retain(|(_, y)| y.is_finite() && *y > 0.0);
        if points.is_empty() {
            continue;
        }
        let (ink, dash) = look(index);
        let panel = Panel::new(
            fit.record.clone(),
            Axis::log("frequency (rad/s)"),
            Axis::log("residual over noise"),
        );
        let line = Line::new("", dash, points).ink(ink).width(1.2).marker(Marker::Circle);
        figure = figure.with(
            panel
                .guide(Guide::Horizontal(1.0))
                .with(Band::new("95 % range of noise", band).ink(Ink::Grey))
                .with(line),
        );
    }
    (!figure.panels.is_empty()).then(|| figure.into())
}

/// Where 95 % of chi-squared over its degrees of freedom lie (Wilson & Hilferty 1931: its cube root is nearly normal).
fn range_95(degrees: f64) -> (f64, f64) {
    let variance = 2.0 / (9.0 * degrees);
    let at = |deviations: f64| (1.0 - variance + deviations * variance.sqrt()).max(0.0).powi(3);
    (at(-NORMAL_95).max(1e-3), at(NORMAL_95))
}

/// The cumulated spectrum and the autocorrelations, all records together.
fn whiteness(input: &Outcome<'_>, fits: &[SpectralFit], left_out: &str) -> Option<Block> {
    let caption = format!(
        "Left: the residuals' power up to each frequency as a part of all, less the part that white noise would have; that of white noise stays within the band \
         with 95 %. Right: autocorrelations, each with 95 % \
         within the lines. Band and lines are those of the shortest record.{left_out}"
    );
    let residuals = |fit: &SpectralFit| (fit.residuals.len() * (fit.sensors.len() - 1)) as f64;
    let least = fits.iter().map(residuals).fold(f64::INFINITY, f64::min);
    let highest = fits
        .iter()
        .filter_map(|fit| fit.frequencies_rad_s.last())
        .fold(0.0, |a, b| f64::max(a, *b));
    if !(least.is_finite() && least > 0.0 && highest > 0.0) {
        return None;
    }
    let reach = KOLMOGOROV_95 / least.sqrt();
    let band = [0.0, highest].map(|x| (x, -reach, reach));
    let mut cumulated = Panel::new(
        "cumulated spectrum",
        Axis::linear("frequency (rad/s)").range(0.0, highest),
        Axis::linear("part of the power, less that of white noise"),
    )
    .guide(Guide::Horizontal(0.0))
    .with(Band::new("95 % range of white noise", band).ink(Ink::Grey));
    for (index, fit) in fits.iter().enumerate() {
        let (ink, dash) = look(index);
        cumulated = cumulated.with(Line::new(fit.record.clone(), dash, cumulate(fit)).ink(ink));
    }
    let mut figure =
        Figure::new(WHITENESS_ID, "Whiteness of the residuals", caption).columns(2).with(cumulated);
    figure.panels.extend(autocorrelations(input, fits));
    Some(figure.into())
}

/// The cumulated residuals as parts of their sum, less the parts of a flat spectrum; at most 300 points.
fn cumulate(fit: &SpectralFit) -> Vec<(f64, f64)> {
    const POINTS: usize = 300;
    let total: f64 = fit.residuals.iter().sum();
    let count = fit.residuals.len();
    let (every, mut sum) = (count.div_ceil(POINTS).max(1), 0.0);
    let mut points = Vec::new();
    for (k, (frequency, value)) in fit.frequencies_rad_s.iter().zip(&fit.residuals).enumerate() {
        sum += value;
        if (k + 1) % every == 0 || k + 1 == count {
            let part = if total > 0.0 { sum / total } else { 0.0 };
            points.push((*frequency, part - (k + 1) as f64 / count as f64));
        }
    }
    points
}

/// Real numbers in the residuals at the frequencies used: one for each sensor but one at zero and at the Nyquist frequency, two at others. One over it is the
/// variance of an autocorrelation of white noise.
fn numbers(fit: &SpectralFit, period_s: f64) -> f64 {
    let nyquist_rad_s = std::f64::consts::PI / period_s;
    let is_real = |w: f64| w < 1e-9 * nyquist_rad_s || w > (1.0 - 1e-9) * nyquist_rad_s;
    let weight = |w: &f64| if is_real(*w) { 1.0 } else { 2.0 };
    let weights: f64 = fit.frequencies_rad_s.iter().map(weight).sum();
    weights * (fit.sensors.len() - 1) as f64
}

fn autocorrelations(input: &Outcome<'_>, fits: &[SpectralFit]) -> Option<Panel> {
    let tests = input.result.whiteness();
    let tests = &tests[..tests.len().min(LARGEST_RECORDS)];
    let lags =
        tests.iter().map(|test| test.autocorrelations.len()).max().filter(|lags| *lags > 0)?;
    let sizes = fits.iter().zip(input.records).map(|(fit, of)| numbers(fit, of.period().seconds()));
    let least = sizes.fold(f64::INFINITY, f64::min).max(1.0);
    let bound = NORMAL_95 / least.sqrt();
    let all = tests.iter().flat_map(|test| &test.autocorrelations);
    let largest = all.fold(1.5 * bound, |largest, value| f64::max(largest, value.abs()));
    let mut panel = Panel::new(
        "autocorrelations",
        Axis::linear("lag (samples)").range(0.0, (lags + 1) as f64),
        Axis::linear("autocorrelation").range(-1.15 * largest, 1.15 * largest),
    )
    .guide(Guide::Horizontal(0.0))
    .guide(Guide::Horizontal(bound))
    .guide(Guide::Horizontal(-bound));
    const MARKERS: [Marker; 6] = [
        Marker::Circle,
        Marker::Square,
        Marker::Triangle,
        Marker::Diamond,
        Marker::TriangleDown,
        Marker::Plus,
    ];
    for (index, (test, marker)) in tests.iter().zip(MARKERS).enumerate() {
        let (ink, _) = look(index);
        let values = test.autocorrelations.iter().enumerate();
        let points = values.map(|(lag, value)| ((lag + 1) as f64, *value));
        panel = panel.with(Points::new(test.record.clone(), marker, points).ink(ink).radius(3.5));
    }
    Some(panel)
}

#[cfg(test)]
mod tests;
