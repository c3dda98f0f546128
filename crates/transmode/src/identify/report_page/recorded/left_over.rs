//! What the model leaves of each sensor, and in which band the inputs tell what it reads.

use reconstruct::output_error::{Fit, RecordFit};
use report::{Axis, Block, Dash, Figure, Ink, Line, Panel};

use super::{COHERENCE_ID, LEFT_OVER_ID};
use crate::identify::outcome::Outcome;
use crate::identify::report_page::style::{
    LARGEST_RECORDS, LARGEST_SENSORS, channel_name, density, drawn, look,
};
use crate::identify::report_page::thinning::{Bin, logarithmic};

/// Points of a spectrum.
const BINS: usize = 60;

pub(super) fn blocks(input: &Outcome<'_>, fit: &Fit) -> Vec<Block> {
    let sensors = input.records.first().map_or(0, |record| record.channels().len());
    let shown = sensors.min(LARGEST_SENSORS);
    let columns = if shown > 3 { shown.div_ceil(2) } else { shown };
    let left_out = format!(
        "{}{}",
        drawn(fit.records.len(), LARGEST_RECORDS, "records"),
        drawn(sensors, LARGEST_SENSORS, "sensors")
    );
    let caption = format!(
        "One-sided power density of each sensor, and of what the model leaves of it, averaged over steps of the logarithmic axis. The residual is noise, gusts, and what \
         no linear model explains; its spectrum weighs the fit.{left_out}"
    );
    let mut spectra =
        Figure::new(LEFT_OVER_ID, "Spectra of sensors and residuals", caption).columns(columns);
    for (index, own) in fit.records.iter().take(LARGEST_RECORDS).enumerate() {
        let bins = logarithmic(&own.frequencies_rad_s, BINS);
        for sensor in 0..shown {
            let panel = spectrum(input, index, own, sensor, &bins);
            spectra.panels.extend(panel);
        }
    }
    let caption = format!(
        "Coherence of each sensor with all recorded inputs together. Near 1 the inputs tell what the sensor reads; where it is small, the sensor says little about the \
         response.{left_out}"
    );
    let mut coherence =
        Figure::new(COHERENCE_ID, "Coherence with the inputs", caption).columns(columns);
    for sensor in 0..shown {
        coherence = coherence.with(coherences(input, fit, sensor));
    }
    vec![
        Block::section("What is left over"),
        spectra.into(),
        Block::section("Coherence"),
        coherence.into(),
    ]
}

fn spectrum(
    input: &Outcome<'_>,
    index: usize,
    own: &RecordFit,
    sensor: usize,
    bins: &[Bin],
) -> Option<Panel> {
    let record = input.records.get(index)?;
    let density_of = 2.0 * record.period().seconds();
    let points = |of: &nalgebra::DMatrix<num_complex::Complex<f64>>| -> Vec<(f64, f64)> {
        let power: Vec<f64> = of.row(sensor).iter().map(num_complex::Complex::norm_sqr).collect();
        let at = |bin: &Bin| (bin.frequency_rad_s, density_of * bin.mean(&power));
        bins.iter().map(at).filter(|(_, y)| y.is_finite() && *y > 0.0).collect()
    };
    let (measured, left) = (points(&own.measured), points(&own.residuals));
    if measured.is_empty() || left.is_empty() {
        return None;
    }
    let title = format!("{}, {}", channel_name(input, sensor), record.name());
    let y = Axis::log(density(input, index, sensor));
    Some(
        Panel::new(title, Axis::log("frequency (rad/s)"), y)
            .with(Line::new("measured", Dash::Solid, measured).ink(Ink::Grey).width(2.2))
            .with(Line::new("residual", Dash::Dashed, left).ink(Ink::Vermillion).width(1.4)),
    )
}

fn coherences(input: &Outcome<'_>, fit: &Fit, sensor: usize) -> Panel {
    let x = Axis::log("frequency (rad/s)");
    let mut panel =
        Panel::new(channel_name(input, sensor), x, Axis::linear("coherence").range(0.0, 1.0));
    for (index, own) in fit.records.iter().take(LARGEST_RECORDS).enumerate() {
        let (ink, dash) = look(index);
        let values: Vec<f64> = own.coherence.row(sensor).iter().copied().collect();
        let bins = logarithmic(&own.frequencies_rad_s, BINS);
        let points = bins.iter().map(|bin| (bin.frequency_rad_s, bin.mean(&values)));
        let name = input.records.get(index).map_or("", |record| record.name());
        panel = panel.with(Line::new(name, dash, points).ink(ink).width(1.4));
    }
    panel
}
