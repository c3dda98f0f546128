//! The modes as numbers, with deviations and flying-quality levels.

use std::f64::consts::TAU;

use aircraft::{AircraftClass, FlightPhaseCategory, FlyingQualityLevel, level};
use num_complex::Complex;
use reconstruct::{Estimate, Method};
use report::{Block, Column, Table, format_significant};

use super::Input;
use crate::CommandError;
use crate::modes::Found;

pub(super) fn blocks(input: &Input<'_>) -> Result<Vec<Block>, CommandError> {
    let mut blocks = vec![Block::section("Modes")];
    if input.found.is_empty() {
        blocks.push(Block::paragraph("No mode was found."));
        return Ok(blocks);
    }
    let mut columns = vec![
        Column::left("mode"),
        Column::right("real part (1/s)"),
        Column::right("imaginary part (rad/s)"),
        Column::right("natural frequency (rad/s)"),
        Column::right("damping ratio"),
        Column::right("time constant (s)"),
        Column::right("time to half or double (s)"),
    ];
    if input.flying.is_some() {
        columns.push(Column::center("level"));
    }
    let mut table = Table::new("Modes, the fastest first", columns);
    for found in input.found {
        let mut row = numbers(found);
        if let Some((class, category)) = input.flying {
            row.push(levels(found, class, category));
        }
        table.push(row).map_err(|error| CommandError::Report(error.to_string()))?;
    }
    blocks.push(table.into());
    blocks.push(Block::paragraph(explanation(input)));
    Ok(blocks)
}

fn explanation(input: &Input<'_>) -> String {
    let deviations = if input.result.method == Method::MaximumLikelihood {
        "Numbers stand with one standard deviation; 1.96 of them are a 95 % interval."
    } else {
        "This method gives no deviations; maximum likelihood does."
    };
    let levels = match input.flying {
        Some((class, category)) => format!(
            "Levels are those of MIL-F-8785C for class {class} and flight-phase category {category}: 1 is clearly adequate, 2 adequate with more work for \
             the pilot, 3 safe to control. In brackets: the levels within the 95 % region, where there are several."
        ),
        None => "Flying-quality levels need `--aircraft-class` and `--flight-phase`.".to_owned(),
    };
    format!("{deviations} {levels}")
}

fn numbers(found: &Found) -> Vec<String> {
    let mode = &found.mode.mode;
    let estimate = found.mode.estimate.as_ref();
    let number = |value: f64| format_significant(value, 5);
    let oscillates = mode.period_s.is_some();
    let cell = |value: f64, of: Option<Estimate>| match of {
        Some(estimate) => with_deviation(value, estimate.deviation),
        None => number(value),
    };
    let dash = || "-".to_owned();
    let real = |deviation: Option<f64>| match deviation {
        Some(deviation) => with_deviation(mode.eigenvalue.re, deviation),
        None => number(mode.eigenvalue.re),
    };
    let imaginary = |deviation: Option<f64>| match deviation {
        Some(deviation) => with_deviation(mode.eigenvalue.im, deviation),
        None => number(mode.eigenvalue.im),
    };
    let plane = estimate.map(|estimate| estimate.continuous);
    let doubles = if mode.eigenvalue.re > 0.0 { "doubles in " } else { "" };
    vec![
        found.named.name.to_string(),
        real(plane.map(|plane| plane.real_deviation())),
        if oscillates { imaginary(plane.map(|plane| plane.imaginary_deviation())) } else { dash() },
        cell(
            mode.natural_frequency_rad_s,
            estimate.map(|estimate| estimate.natural_frequency_rad_s),
        ),
        if oscillates {
            cell(mode.damping_ratio, estimate.map(|estimate| estimate.damping_ratio))
        } else {
            dash()
        },
        mode.time_constant_s.map_or_else(dash, |value| {
            cell(value, estimate.map(|estimate| estimate.time_constant_s))
        }),
        format!("{doubles}{}", number(mode.time_to_half_or_double_s)),
    ]
}

/// `1.6923 ± 0.0012`: two digits of the deviation, and as many decimals of the number.
fn with_deviation(value: f64, deviation: f64) -> String {
    const LARGEST_DECIMALS: i32 = 12;
    if !(value.is_finite() && deviation.is_finite() && deviation > 0.0) {
        return format_significant(value, 5);
    }
    let two_digits = |decimals: &i32| deviation * 10_f64.powi(*decimals) >= 9.95;
    let decimals = (0..LARGEST_DECIMALS).find(two_digits).unwrap_or(LARGEST_DECIMALS);
    let decimals = usize::try_from(decimals).unwrap_or(0);
    format!("{value:.decimals$} ± {deviation:.decimals$}").replace('-', "\u{2212}")
}

/// The level, and in brackets the best and the worst within the 95 % region where they differ.
fn levels(found: &Found, class: AircraftClass, category: FlightPhaseCategory) -> String {
    const AROUND: u32 = 32;
    let Some(here) = level(&found.named, class, category) else { return "-".to_owned() };
    let mut all = vec![here];
    if let Some(estimate) = &found.mode.estimate {
        let ellipse = estimate.continuous.ellipse_95();
        for step in 0..AROUND {
            let angle = TAU * f64::from(step) / f64::from(AROUND);
            let along = Complex::new(ellipse.major * angle.cos(), ellipse.minor * angle.sin());
            let mut moved = found.named;
            moved.eigenvalue += along * Complex::from_polar(1.0, ellipse.angle_rad);
            if moved.eigenvalue.re.is_finite() && moved.eigenvalue.im >= 0.0 {
                all.extend(level(&moved, class, category));
            }
        }
    }
    let (best, worst) = (all.iter().min().unwrap_or(&here), all.iter().max().unwrap_or(&here));
    if best == worst { here.to_string() } else { format!("{here} ({})", range(*best, *worst)) }
}

fn range(best: FlyingQualityLevel, worst: FlyingQualityLevel) -> String {
    match worst {
        FlyingQualityLevel::Worse => format!("{best} or worse"),
        _ => format!("{best} to {worst}"),
    }
}

#[cfg(test)]
mod tests;
