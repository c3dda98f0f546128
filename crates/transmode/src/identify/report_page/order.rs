//! Why the order is what it is.

use reconstruct::subspace::OrderEvidence;
use report::{Axis, Block, Figure, Fill, Guide, Ink, Marker, Panel, Points, Stems};

use crate::CommandError;
use crate::identify::outcome::Outcome;

pub(super) const ID: &str = "order";

/// As many eigenvalues are drawn: the gap is among the first.
const LARGEST_EIGENVALUES: usize = 40;

pub(super) fn blocks(input: &Outcome<'_>) -> Result<Vec<Block>, CommandError> {
    let mut blocks = vec![Block::section("Number of states")];
    let Some(evidence) = input.result.order() else {
        blocks.push(Block::paragraph(
            "The method as printed shows no evidence for the order beside its zeros; the other methods do.",
        ));
        return Ok(blocks);
    };
    let gaps = evidence.gaps.iter().filter(|(_, gap)| gap.is_finite() && *gap > 0.0);
    let gaps: Vec<(usize, f64)> = gaps.copied().collect();
    let values = evidence.eigenvalues.iter().enumerate().take(LARGEST_EIGENVALUES);
    let values: Vec<(f64, f64)> = values
        .filter(|(_, value)| **value > 0.0)
        .map(|(k, value)| ((k + 1) as f64, *value))
        .collect();
    let mut figure =
        Figure::new(ID, "Evidence for the order", caption(evidence, &input.likelihood_ratios()))
            .columns(2);
    if !gaps.is_empty() {
        let split = |used: bool| {
            let own = gaps.iter().filter(move |(order, _)| (*order == evidence.order) == used);
            own.map(|(order, gap)| (*order as f64, *gap)).collect::<Vec<_>>()
        };
        let largest = gaps.iter().map(|(_, gap)| *gap).fold(10.0, f64::max);
        let highest = gaps.iter().map(|(order, _)| *order).max().unwrap_or(1);
        let x = Axis::linear("order").range(0.0, (highest + 1) as f64);
        let mut panel =
            Panel::new("gap behind each order", x, Axis::log("gap").range(0.5, 3.0 * largest));
        if !split(false).is_empty() {
            panel = panel.with(Stems::new("other orders", split(false)).ink(Ink::Grey));
        }
        if !split(true).is_empty() {
            panel = panel.with(
                Stems::new("the order used", split(true))
                    .ink(Ink::Blue)
                    .marker(Marker::Square, Fill::Solid),
            );
        }
        figure = figure.with(panel);
    }
    if !values.is_empty() {
        let x = Axis::linear("number").range(0.0, (values.len() + 1) as f64);
        let panel = Panel::new("eigenvalues at the order used", x, Axis::log("eigenvalue"))
            .guide(Guide::Vertical(evidence.order as f64 + 0.5))
            .with(
                Points::new("eigenvalue", Marker::Circle, values).ink(Ink::Vermillion).radius(3.0),
            );
        figure = figure.with(panel);
    }
    if !figure.panels.is_empty() {
        blocks.push(figure.into());
    }
    Ok(blocks)
}

fn caption(evidence: &OrderEvidence, ratios: &str) -> String {
    let order = evidence.order;
    let why = match (evidence.asked, ratios) {
        (true, _) => "It was asked for.".to_owned(),
        (false, "") => "It was chosen by its gap.".to_owned(),
        (false, ratios) => {
            format!("It was chosen by its gap, and by the likelihood: it is {ratios}.")
        }
    };
    format!(
        "A direction that all records share has an eigenvalue near zero; behind the last of them there is a gap, the ratio of two neighbours. \
         The order used is {order}. {why} The vertical line is where its eigenvalues end."
    )
}
