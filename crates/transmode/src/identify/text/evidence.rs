//! What the modes rest on, where noise is reckoned with: order, noise levels, fit.

use report::format_significant;

use crate::identify::outcome::Outcome;

/// How many other orders are named.
const NAMED: usize = 4;

/// A line for each of order, noise, band and fit.
pub(super) fn summary(outcome: &Outcome<'_>) -> String {
    let lines = [order(outcome), noise(outcome), band(outcome), fit(outcome)];
    lines.into_iter().flatten().collect::<Vec<_>>().join("\n")
}

fn order(outcome: &Outcome<'_>) -> Option<String> {
    let evidence = outcome.result.order.as_ref()?;
    let (order, gap) = (evidence.order, format_significant(evidence.gap, 2));
    if evidence.asked {
        return Some(format!("order: {order}, as asked for, with a gap of {gap}"));
    }
    let mut others: Vec<_> =
        evidence.gaps.iter().filter(|(other, _)| *other != order).copied().collect();
    others.sort_by(|a, b| b.1.total_cmp(&a.1));
    let others: Vec<_> = others
        .iter()
        .take(NAMED)
        .map(|(other, gap)| format!("{} for {other}", format_significant(*gap, 2)))
        .collect();
    Some(format!("order: {order}, by a gap of {gap} (next are {})", others.join(", ")))
}

fn noise(outcome: &Outcome<'_>) -> Option<String> {
    let origin = match outcome.noise_origin()? {
        "given" => "as given",
        "estimated" => "estimated from the records",
        "rounding" => "the records hold rounding errors only, of which these are upper bounds",
        _ => return Some("noise: its spectrum is that of the quiet record".to_owned()),
    };
    let channels = outcome.records.first()?.channels();
    let levels = outcome.result.noise_levels.iter().flatten();
    let level =
        |(index, (channel, level)): (usize, (&reconstruct::Channel, &reconstruct::Estimate))| {
            let unit = outcome.unit(index).filter(|unit| !unit.is_empty());
            let deviation = if level.deviation > 0.0 {
                format!(" +- {}", format_significant(level.deviation, 2))
            } else {
                String::new()
            };
            let value = format_significant(level.value, 3);
            let unit = unit.map_or_else(String::new, |unit| format!(" {unit}"));
            format!("{} {value}{deviation}{unit}", channel.name)
        };
    let levels: Vec<_> = channels.iter().zip(levels).enumerate().map(level).collect();
    Some(format!("noise: {}; {origin}", levels.join(", ")))
}

fn band(outcome: &Outcome<'_>) -> Option<String> {
    let band = outcome.band?;
    Some(format!(
        "band: {} to {} rad/s",
        format_significant(band.lowest_rad_s, 4),
        format_significant(band.highest_rad_s, 4)
    ))
}

fn fit(outcome: &Outcome<'_>) -> Option<String> {
    let goodness = outcome.result.goodness.as_ref()?;
    // Where the level was chosen for want of noise, the size of the residuals says nothing.
    if outcome.noise_origin() == Some("rounding") {
        return None;
    }
    let value = format_significant(goodness.per_degree_of_freedom(), 4);
    Some(match goodness.p_value {
        Some(p_value) => {
            let p_value = format_significant(p_value, 2);
            format!("fit: chi-squared per degree of freedom {value}, p-value {p_value}")
        }
        None => format!(
            "fit: chi-squared per degree of freedom {value}, by construction, since the noise levels come from the same residuals"
        ),
    })
}
