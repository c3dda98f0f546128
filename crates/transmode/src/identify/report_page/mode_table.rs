//! The modes as numbers, with deviations and flying-quality levels.

use std::f64::consts::TAU;

use aircraft::FlyingQualityLevel;
use num_complex::Complex;
use reconstruct::Method;
use reconstruct::likelihood::Estimate;
use report::{Block, Column, Table, format_significant};

use crate::CommandError;
use crate::identify::near_double;
use crate::identify::outcome::{FlyingQualitiesCase, Outcome};
use crate::modes::IdentifiedMode;

/// As many modes fit a page side by side.
const MODES_IN_A_TABLE: usize = 4;

/// What is said of a mode.
const QUANTITIES: [&str; 7] = [
    "real part (1/s)",
    "imaginary part (rad/s)",
    "natural frequency (rad/s)",
    "damping ratio",
    "time constant (s)",
    "95 % interval of it (s)",
    "time to half or double (s)",
];

pub(super) fn blocks(input: &Outcome<'_>) -> Result<Vec<Block>, CommandError> {
    let mut blocks = vec![Block::section("Modes")];
    if input.found.is_empty() {
        blocks.push(Block::paragraph("No mode was found."));
        return Ok(blocks);
    }
    let all = input.found.chunks(MODES_IN_A_TABLE).enumerate();
    for (part, found) in all {
        let title = match input.found.len() {
            ..=MODES_IN_A_TABLE => "Modes, the fastest first".to_owned(),
            _ => format!("Modes from number {} on, the fastest first", part * MODES_IN_A_TABLE + 1),
        };
        blocks.push(table(input, found, title)?.into());
    }
    blocks.push(Block::paragraph(explanation(input)));
    let sentences = near_double::sentences(input);
    if !sentences.is_empty() {
        blocks.push(Block::paragraph("Nearly double eigenvalues:"));
        blocks.push(Block::bullets(sentences));
    }
    Ok(blocks)
}

/// A column for each mode: names and numbers with deviations are wide, and four of them fit a page.
fn table(
    input: &Outcome<'_>,
    found: &[IdentifiedMode],
    title: String,
) -> Result<Table, CommandError> {
    let names = found.iter().map(|found| Column::right(found.named.name.to_string()));
    let mut table = Table::new(title, std::iter::once(Column::left("")).chain(names));
    let mut push = |what: &str, cells: Vec<String>| {
        let row = std::iter::once(what.to_owned()).chain(cells);
        table.push(row).map_err(|error| CommandError::Report(error.to_string()))
    };
    let columns: Vec<[String; QUANTITIES.len()]> = found.iter().map(numbers).collect();
    for (index, quantity) in QUANTITIES.iter().enumerate() {
        push(quantity, columns.iter().map(|column| column[index].clone()).collect())?;
    }
    if let Some(case) = input.flying_qualities {
        push("level", found.iter().map(|found| levels(found, case)).collect())?;
    }
    Ok(table)
}

fn explanation(input: &Outcome<'_>) -> String {
    let estimated = [Method::MaximumLikelihood, Method::OutputError];
    let deviations = if estimated.contains(&input.result.method()) {
        "Numbers stand with one standard deviation; 1.96 of them are a 95 % interval."
    } else {
        "This method gives no deviations; maximum likelihood does."
    };
    let of_real = match input.found.iter().any(|found| found.mode.interval_95.is_some()) {
        true => " Intervals of real modes are those of the likelihood, and need not be symmetric.",
        false => "",
    };
    let levels = match input.flying_qualities {
        Some(FlyingQualitiesCase { class, phase }) => format!(
            "Levels are those of MIL-F-8785C for class {class} and flight-phase category {phase}: 1 is clearly adequate, 2 adequate with more work for \
             the pilot, 3 safe to control. In brackets: the levels within the 95 % region, where there are several."
        ),
        None => "Flying-quality levels need `--aircraft-class` and `--flight-phase`.".to_owned(),
    };
    format!("{deviations}{of_real} {levels}")
}

fn numbers(found: &IdentifiedMode) -> [String; QUANTITIES.len()] {
    let mode = &found.mode.mode;
    let estimate = found.mode.estimate.as_ref();
    let number = |value: f64| format_significant(value, 5);
    let oscillates = mode.period_s.is_some();
    let cell = |value: f64, of: Option<Estimate>| match of {
        Some(estimate) => with_deviation(value, estimate.standard_error),
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
    [
        real(plane.map(|plane| plane.real_standard_error())),
        if oscillates {
            imaginary(plane.map(|plane| plane.imaginary_standard_error()))
        } else {
            dash()
        },
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
        interval(found),
        format!("{doubles}{}", number(mode.time_to_half_or_double_s)),
    ]
}

/// The 95 % interval of the time constant of a real mode.
fn interval(found: &IdentifiedMode) -> String {
    if found.eigenvalue_interval_95().is_none() {
        return "-".to_owned();
    }
    match found.time_constant_interval_95() {
        Some([low, high]) => {
            // Where both ends begin with the same digits, one more than those.
            let same = |digits: &usize| {
                format_significant(low, *digits) == format_significant(high, *digits)
            };
            let shared = (3..=12).take_while(same).count();
            let digits = if shared == 0 { 3 } else { 4 + shared };
            format!("{} to {}", format_significant(low, digits), format_significant(high, digits))
        }
        None => "any sign".to_owned(),
    }
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
fn levels(found: &IdentifiedMode, case: FlyingQualitiesCase) -> String {
    const AROUND: u32 = 32;
    const FAR: f64 = 1e3;
    let Some(here) = case.level(&found.named) else { return "-".to_owned() };
    let mut all = vec![here];
    if let Some([low, high]) = found.eigenvalue_interval_95() {
        // Levels of real modes have limits on one side, so the ends say all; far out stands for no end.
        let far = FAR * found.named.eigenvalue.norm();
        for end in [low.max(-far), high.min(far)] {
            let mut moved = found.named;
            moved.eigenvalue.re = end;
            all.extend(case.level(&moved));
        }
    } else if let Some(estimate) = &found.mode.estimate {
        let ellipse = estimate.continuous.ellipse_95();
        for step in 0..AROUND {
            let angle = TAU * f64::from(step) / f64::from(AROUND);
            let along = Complex::new(ellipse.major * angle.cos(), ellipse.minor * angle.sin());
            let mut moved = found.named;
            moved.eigenvalue += along * Complex::from_polar(1.0, ellipse.angle_rad);
            if moved.eigenvalue.re.is_finite() && moved.eigenvalue.im >= 0.0 {
                all.extend(case.level(&moved));
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
