//! Does the answer depend on choices that should not matter? Poles for many orders and several numbers of block rows.

use lti::Mode;
use reconstruct::subspace::{Intersection, OrderChoice};
use reconstruct::{Channel, NoiseModel, Record, subspace};
use report::{Axis, Block, Figure, Fill, Guide, Ink, Marker, Panel, Points};

use crate::CommandError;
use crate::identify::outcome::Outcome;

pub(super) const ID: &str = "stabilisation";

/// Of longer records this many samples are used: more would take minutes and show the same.
const LARGEST_SAMPLES: usize = 20_000;

/// Orders up to this much above the one used, and at least up to 8, are looked at.
const ORDERS_ABOVE: usize = 4;
const LEAST_HIGHEST_ORDER: usize = 8;

/// A pole is stable where a lower order has one this close: relative distance of frequencies, distance of damping ratios.
const FREQUENCY_TOLERANCE: f64 = 0.02;
const DAMPING_TOLERANCE: f64 = 0.02;

/// Each number of block rows: what it is drawn with.
const LOOKS: [(Ink, Marker); 3] = [
    (Ink::Blue, Marker::Circle),
    (Ink::Vermillion, Marker::Square),
    (Ink::Green, Marker::Triangle),
];

pub(super) fn blocks(input: &Outcome<'_>) -> Result<Vec<Block>, CommandError> {
    let mut blocks = vec![Block::section("Stability of the answer")];
    let diagrams = diagrams(input);
    if diagrams.iter().all(|diagram| diagram.poles.is_empty()) {
        blocks.push(Block::paragraph(
            "Signal subspaces do not intersect in these records for any order, so that there is nothing to compare.",
        ));
        return Ok(blocks);
    }
    blocks.push(figure(input, &diagrams).into());
    Ok(blocks)
}

/// The poles of all orders for one number of block rows.
struct Diagram {
    block_rows: usize,
    poles: Vec<Pole>,
}

struct Pole {
    order: usize,
    frequency_rad_s: f64,
    damping_ratio: f64,
    stable: bool,
}

fn diagrams(input: &Outcome<'_>) -> Vec<Diagram> {
    let records: Vec<Record> = input.records.iter().filter_map(shortened).collect();
    let mut options = options(input);
    let first = match input.result.intersection() {
        Some(first) if records.len() == input.records.len() => Some(first.clone()),
        _ => subspace::identify(&records, &options).ok(),
    };
    let Some(first) = first else { return Vec::new() };
    if matches!(options.noise, NoiseModel::Estimated | NoiseModel::White) {
        options.noise = NoiseModel::Levels(first.noise.deviations.clone());
    }
    let highest = (first.order.order + ORDERS_ABOVE).max(LEAST_HIGHEST_ORDER);
    let numbers = [first.block_rows / 2, first.block_rows, first.block_rows * 3 / 2];
    let diagram = |block_rows: usize| {
        options.block_rows = Some(block_rows);
        let mut poles: Vec<Pole> = Vec::new();
        for order in 1..=highest {
            options.order = OrderChoice::Fixed(order);
            // An error says that the records do not tell so many states with so many block rows.
            let Ok(found) = subspace::identify(&records, &options) else { continue };
            let new = modes(&found).into_iter().map(|mode| pole(order, &mode, &poles));
            let new: Vec<Pole> = new.collect();
            poles.extend(new);
        }
        Diagram { block_rows, poles }
    };
    numbers.into_iter().filter(|rows| *rows > 0).map(diagram).collect()
}

/// The options of the first stage of a reconstruction with the input's options, whatever order and block rows it asked for.
fn options(input: &Outcome<'_>) -> subspace::Options {
    let any = subspace::Options::default();
    let mut options = input.options.subspace();
    (options.order, options.block_rows) = (any.order, any.block_rows);
    let inputs = options.measurement.known_inputs.iter_mut().flatten();
    inputs.for_each(|signal| signal.truncate(LARGEST_SAMPLES));
    options
}

fn shortened(record: &Record) -> Option<Record> {
    if record.samples() <= LARGEST_SAMPLES {
        return Some(record.clone());
    }
    let cut = |channel: &Channel| {
        let values = channel.values.iter().take(LARGEST_SAMPLES);
        Channel::new(channel.name.clone(), values.copied().collect())
    };
    Record::with_missing(record.name(), record.period(), record.marked().iter().map(cut).collect())
        .ok()
}

/// The modes of an intersection, a complex pair once; those without a frequency are left out.
fn modes(found: &Intersection) -> Vec<Mode> {
    let upper = found.modes.iter().filter(|mode| mode.pole.im >= 0.0);
    let modes =
        upper.filter_map(|mode| Mode::from_discrete_eigenvalue(mode.pole, found.model.period).ok());
    modes
        .filter(|mode| {
            mode.natural_frequency_rad_s.is_finite() && mode.natural_frequency_rad_s > 0.0
        })
        .collect()
}

fn pole(order: usize, mode: &Mode, lower: &[Pole]) -> Pole {
    let (frequency_rad_s, damping_ratio) = (mode.natural_frequency_rad_s, mode.damping_ratio);
    let below = lower.iter().map(|pole| pole.order).max();
    let near = |pole: &&Pole| {
        (pole.frequency_rad_s / frequency_rad_s - 1.0).abs() < FREQUENCY_TOLERANCE
            && (pole.damping_ratio - damping_ratio).abs() < DAMPING_TOLERANCE
    };
    let stable = lower.iter().filter(|pole| Some(pole.order) == below).any(|pole| near(&pole));
    Pole { order, frequency_rad_s, damping_ratio, stable }
}

fn figure(input: &Outcome<'_>, diagrams: &[Diagram]) -> Figure {
    let short = input.records.iter().any(|record| record.samples() > LARGEST_SAMPLES);
    let part = if short {
        format!(" Of longer records the first {LARGEST_SAMPLES} samples are used.")
    } else {
        String::new()
    };
    let caption = format!(
        "Poles of the intersection of signal subspaces for every order, with half, once and one and a half times the block rows. Filled: the order below has \
         a pole within 2 % of the frequency and 0.02 of the damping ratio. The vertical lines are the answer: filled marks should line up on them from some \
         order on, for all block rows.{part}"
    );
    let all = || diagrams.iter().flat_map(|diagram| &diagram.poles);
    let highest = all().map(|pole| pole.order).max().unwrap_or(1);
    let y = || Axis::linear("order").range(0.0, (highest + 1) as f64);
    let damping = Axis::linear("damping ratio").range(-1.1, 1.1);
    let mut panels = [
        Panel::new("frequency", Axis::log("natural frequency (rad/s)"), y()),
        Panel::new("damping", damping, y()),
    ];
    for found in input.found {
        let mode = &found.mode.mode;
        let [frequency, damping] = panels;
        let w = mode.natural_frequency_rad_s;
        let frequency =
            if w > 0.0 && w.is_finite() { frequency.guide(Guide::Vertical(w)) } else { frequency };
        panels = [frequency, damping.guide(Guide::Vertical(mode.damping_ratio))];
    }
    for (diagram, (ink, marker)) in diagrams.iter().zip(LOOKS) {
        for stable in [false, true] {
            let own = || diagram.poles.iter().filter(move |pole| pole.stable == stable);
            if own().next().is_none() {
                continue;
            }
            let fill = if stable { Fill::Solid } else { Fill::Open };
            let label = format!(
                "{} block rows{}",
                diagram.block_rows,
                if stable { "" } else { ", not stable" }
            );
            let points = |x: fn(&Pole) -> f64| {
                let xy = own().map(|pole| (x(pole), pole.order as f64));
                Points::new(label.clone(), marker, xy).ink(ink).fill(fill).radius(3.5)
            };
            let [frequency, damping] = panels;
            panels = [
                frequency.with(points(|pole| pole.frequency_rad_s)),
                damping.with(points(|pole| pole.damping_ratio)),
            ];
        }
    }
    let [frequency, damping] = panels;
    Figure::new(ID, "Poles against the order", caption).columns(2).with(frequency).with(damping)
}
