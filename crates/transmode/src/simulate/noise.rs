//! How large the noise of each sensor is to be.

use super::Sensor;

/// What the option `--noise` asks for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Noise {
    /// None at all.
    Absent,
    /// Ratio of the response's standard deviation, the mean over the records that a surface moves, to that of the noise, for each sensor.
    Ratio(f64),
    /// Standard deviations of some sensors, in their own units; the others have no noise.
    Levels(Vec<(Sensor, f64)>),
}

impl Noise {
    /// Reads `none`, `snr=RATIO` or `SENSOR=LEVEL,..`.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        let text = text.trim();
        if text == "none" {
            return Ok(Self::Absent);
        }
        if let Some(ratio) = text.strip_prefix("snr=") {
            return match ratio.trim().parse::<f64>() {
                Ok(ratio) if ratio > 0.0 && ratio.is_finite() => Ok(Self::Ratio(ratio)),
                _ => Err(format!("{ratio:?} is no ratio; a positive number is needed")),
            };
        }
        let mut levels: Vec<(Sensor, f64)> = Vec::new();
        for part in text.split(',') {
            let Some((name, level)) = part.split_once('=') else {
                return Err("noise is written snr=100, or beta=0.001,p=0.002, or none".to_owned());
            };
            let sensor = Sensor::parse(name)?;
            if levels.iter().any(|(other, _)| *other == sensor) {
                return Err(format!("{} is there twice", sensor.name()));
            }
            match level.trim().parse::<f64>() {
                Ok(level) if level >= 0.0 && level.is_finite() => levels.push((sensor, level)),
                _ => {
                    return Err(format!(
                        "{level:?} is no standard deviation; a number that is not negative is needed"
                    ));
                }
            }
        }
        Ok(Self::Levels(levels))
    }
}
