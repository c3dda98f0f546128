//! The spectrum of each sensor beside what the model makes of it, and what is left over.

use reconstruct::Record;
use reconstruct::likelihood::SpectralFit;
use report::{Axis, Block, Dash, Figure, Ink, Line, Panel};

use super::residuals;
use super::style::{LARGEST_RECORDS, LARGEST_SENSORS, channel_name, density, drawn};
use super::thinning::{Bin, logarithmic};
use crate::CommandError;
use crate::identify::outcome::Outcome;

pub(super) const ID: &str = "spectra";

/// Points of a spectrum.
const BINS: usize = 120;

pub(super) fn blocks(input: &Outcome<'_>) -> Result<Vec<Block>, CommandError> {
    let mut blocks = vec![Block::section("Spectra")];
    let fits = match fits(input) {
        Ok(fits) => fits,
        Err(sentence) => {
            blocks.push(Block::paragraph(sentence));
            return Ok(blocks);
        }
    };
    let sensors = fits.first().map_or(0, |fit| fit.sensors.len());
    let shown = sensors.min(LARGEST_SENSORS);
    let columns = if shown > 3 { shown.div_ceil(2) } else { shown };
    let caption = format!(
        "One-sided power density, averaged over steps of the logarithmic axis. Measured: the sensors. Model: the response to the excitation that fits best \
         at each frequency, plus noise. Where both agree and stand above the noise, the sensor says something about the system.{}{}",
        drawn(fits.len(), LARGEST_RECORDS, "records"),
        drawn(sensors, LARGEST_SENSORS, "sensors")
    );
    let mut figure =
        Figure::new(ID, "Spectra of the sensors and the model", caption).columns(columns);
    for (index, (fit, record)) in fits.iter().zip(input.records).take(LARGEST_RECORDS).enumerate() {
        let bins = logarithmic(&fit.frequencies_rad_s, BINS);
        for sensor in 0..shown {
            let title = format!("{}, {}", channel_name(input, sensor), fit.record);
            let y = Axis::log(density(input, index, sensor));
            let panel = Panel::new(title, Axis::log("frequency (rad/s)"), y);
            let lines = lines(fit, record, sensor, &bins);
            if lines.iter().all(|line| !line.xy.is_empty()) {
                figure = figure.with(lines.into_iter().fold(panel, Panel::with));
            }
        }
    }
    if !figure.panels.is_empty() {
        blocks.push(figure.into());
    }
    blocks.extend(residuals::blocks(input, &fits));
    Ok(blocks)
}

/// The spectra, or a sentence that says why there are none.
fn fits(input: &Outcome<'_>) -> Result<Vec<SpectralFit>, String> {
    match reconstruct::spectral_fits(input.records, input.options, input.result) {
        Ok(fits) if fits.is_empty() => {
            Err("The method as printed has no model of all sensors to hold against them; the other methods do.".to_owned())
        }
        Ok(fits) => Ok(fits),
        Err(error) => Err(format!("The spectra cannot be drawn: {error}.")),
    }
}

fn lines(fit: &SpectralFit, record: &Record, sensor: usize, bins: &[Bin]) -> [Line; 3] {
    let spectrum = &fit.sensors[sensor];
    let density = 2.0 * record.period().seconds();
    let points = |values: &dyn Fn(&Bin) -> f64| {
        let at = |bin: &Bin| (bin.frequency_rad_s, density * values(bin));
        bins.iter().map(at).filter(|(_, y)| y.is_finite() && *y > 0.0).collect::<Vec<_>>()
    };
    let measured = points(&|bin| bin.mean(&spectrum.measured));
    let noise = points(&|bin| bin.mean(&spectrum.noise));
    // The response follows the noise as far as an excitation could; on average that is known.
    let signal = |bin: &Bin| bin.mean(&spectrum.response) - bin.mean(&spectrum.absorbed);
    let model = points(&|bin| signal(bin).max(0.0) + bin.mean(&spectrum.noise));
    [
        Line::new("measured", Dash::Solid, measured).ink(Ink::Grey).width(2.8),
        Line::new("model", Dash::Dashed, model).ink(Ink::Blue).width(1.5),
        Line::new("noise", Dash::Dotted, noise).ink(Ink::Vermillion).width(1.6),
    ]
}
