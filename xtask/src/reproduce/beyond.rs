//! Beyond the paper: what noise does to the paper's method, and what this project makes of noisy
//! records.

use num_complex::Complex;
use reconstruct::likelihood::ComplexEstimate;
use reconstruct::{Method, Options};
use report::{
    Axis, Block, Column, Dash, Ellipse, Ellipses, Figure, Ink, Line, Panel, Points, Table,
    format_significant,
};

use super::check::Check;
use super::{AircraftExample, Part};
use crate::TaskError;
use crate::shared::averages::median;
use crate::shared::matching::{holds_in_ellipse, with_conjugate};
use crate::shared::methods::{Look, METHODS, RATIO_AXIS, apply, most_likely, paper_errors};
use crate::shared::modes::{MODES, TrueModes};
use crate::shared::noisy_flights::{Excitation, Simulator};
use crate::shared::parallel::{all_cores, in_parallel};
use crate::shared::reference;

const PART: &str = "beyond the paper";
/// Decades from hardly any noise to what cheap sensors have.
const RATIOS: [f64; 8] = [1e8, 1e7, 1e6, 1e5, 1e4, 1e3, 1e2, 1e1];
/// Pairs of records for each ratio.
const PAIRS: u64 = 3;
/// Reconstructions in the s-plane, and their signal to noise ratio: 20 dB.
const RECONSTRUCTIONS: u64 = 50;
const RATIO: f64 = 10.0;

/// Errors of one pair of records: as printed, maximum likelihood.
type Errors = [Option<[f64; 3]>; 2];

/// The modes of one reconstruction: spiral, roll, Dutch roll.
type EstimatedModes = [ComplexEstimate; 3];

pub(crate) fn build(example: &AircraftExample) -> Result<Part, TaskError> {
    let simulator = Simulator::new()?;
    let truth = simulator.aircraft.modes;
    let curves = against_ratio(&simulator)?;
    let found = reconstructions(&simulator)?;
    Ok(Part {
        title: "Beyond the paper: records with noise",
        introduction: "The printed method needs records without noise. Maximum likelihood, started from the intersection of the records' signal subspaces, knows neither \
                       the excitations nor the noise levels either, and says how certain its eigenvalues are. White excitation, 2000 samples, white noise in every \
                       sensor. docs/study-noise.md has other excitations and more runs.",
        checks: checks(example, &truth, &found)?,
        blocks: vec![error_figure(&curves), error_table(&curves)?, plane_figure(&truth, &found)],
    })
}

fn checks(
    example: &AircraftExample,
    truth: &TrueModes,
    found: &[EstimatedModes],
) -> Result<Vec<Check>, TaskError> {
    let Options { noise, order, .. } = Options::default();
    let noise_free = apply(&example.records, Method::MaximumLikelihood, noise, order)
        .ok_or_else(|| TaskError::computation(PART)("nothing from records without noise"))?;
    let eigenvalues: Vec<Complex<f64>> = noise_free
        .modes
        .iter()
        .map(|found| found.mode.eigenvalue)
        .flat_map(with_conjugate)
        .collect();
    let held = found.iter().filter(|run| holds_in_ellipse(&run[2], truth.dutch_roll)).count();
    let all = found.len() as f64;
    Ok(vec![
        Check::computed_roots(
            "beyond-noise-free",
            &eigenvalues,
            &reference::roots("/aircraft/spec_A")?,
            1e-7,
            "maximum likelihood on the records of the paper's figures, nothing given but the records",
        ),
        Check::computed(
            "beyond-coverage",
            &[held as f64 / all],
            &[0.95],
            0.05,
            "part of the reconstructions at a signal to noise ratio of 10 whose 95 % ellipse holds the Dutch roll",
        ),
    ])
}

/// For each ratio the errors of each pair of records.
fn against_ratio(simulator: &Simulator) -> Result<Vec<(f64, Vec<Errors>)>, TaskError> {
    let cases: Vec<(f64, u64)> =
        RATIOS.iter().flat_map(|ratio| (1..=PAIRS).map(|seed| (*ratio, seed))).collect();
    let truth = simulator.aircraft.modes;
    let errors = in_parallel(&cases, all_cores(), |(ratio, seed)| {
        let pair = simulator.fly(Excitation::White, *ratio, *seed)?;
        let likely = most_likely(&pair.records, &truth).map(|(_, modes)| {
            let truth = truth.list();
            [0, 1, 2].map(|mode| (modes[mode].continuous.value - truth[mode]).norm())
        });
        Ok([paper_errors(&pair.records, &truth), likely])
    })?;
    let by_ratio = errors.chunks(usize::try_from(PAIRS).unwrap_or(1));
    Ok(RATIOS.into_iter().zip(by_ratio.map(<[_]>::to_vec)).collect())
}

fn reconstructions(simulator: &Simulator) -> Result<Vec<EstimatedModes>, TaskError> {
    let truth = simulator.aircraft.modes;
    let seeds: Vec<u64> = (1..=RECONSTRUCTIONS).collect();
    in_parallel(&seeds, all_cores(), |seed| {
        let pair = simulator.fly(Excitation::White, RATIO, *seed)?;
        let (_, modes) = most_likely(&pair.records, &truth)
            .ok_or_else(|| TaskError::computation(PART)(format!("nothing from seed {seed}")))?;
        Ok(modes.map(|mode| mode.continuous))
    })
}

/// The middle error of one method and mode; `None` where no pair gave anything.
fn middle(runs: &[Errors], method: usize, mode: usize) -> Option<f64> {
    let errors: Vec<f64> =
        runs.iter().filter_map(|run| run[method].map(|errors| errors[mode])).collect();
    (!errors.is_empty()).then(|| median(&errors))
}

/// The look of the two methods, as in the study of noise.
fn shown() -> [(usize, Look); 2] {
    [(0, METHODS[0]), (1, METHODS[2])]
}

fn error_figure(curves: &[(f64, Vec<Errors>)]) -> Block {
    let caption = "Median error of each eigenvalue over three pairs of records. For the printed method it is the closest of all zeros of its differences (more than \
                   fifty for each sensor), which nobody could pick without knowing the answer.";
    let mut figure =
        Figure::new("beyond-errors", "Error against the signal to noise ratio", caption).columns(3);
    for (mode, name) in MODES.iter().enumerate() {
        let mut panel = Panel::new(*name, Axis::log(RATIO_AXIS), Axis::log("median error (1/s)"));
        for (method, (label, ink, dash, marker)) in shown() {
            let mut points: Vec<_> = curves
                .iter()
                .filter_map(|(ratio, runs)| middle(runs, method, mode).map(|error| (*ratio, error)))
                .collect();
            points.reverse();
            panel = panel.with(Line::new(label, dash, points).ink(ink).marker(marker));
        }
        figure = figure.with(panel);
    }
    figure.into()
}

fn error_table(curves: &[(f64, Vec<Errors>)]) -> Result<Block, TaskError> {
    let methods = shown().map(|(_, (name, ..))| Column::right(name));
    let header = [Column::right(RATIO_AXIS)].into_iter().chain(methods);
    let mut table = Table::new("Median errors in 1/s: spiral / roll / Dutch roll", header);
    for (ratio, runs) in curves {
        let cell = |method: usize| {
            let errors = [0, 1, 2].map(|mode| {
                middle(runs, method, mode)
                    .map_or_else(|| "-".to_owned(), |error| format_significant(error, 1))
            });
            errors.join(" / ")
        };
        table
            .push([format!("{ratio:.0e}"), cell(0), cell(1)])
            .map_err(TaskError::computation(PART))?;
    }
    Ok(table.into())
}

/// The s-plane with all reconstructions: the upper half, the Dutch roll, the real axis.
fn plane_figure(truth: &TrueModes, found: &[EstimatedModes]) -> Block {
    let caption = "Fifty reconstructions at a signal to noise ratio of 10 (20 dB). The ellipse around the true eigenvalue has the mean of the covariances that the \
                   reconstructions state: about one in twenty lies outside. For the two real modes it is an interval.";
    let xy = |s: &Complex<f64>| (s.re, s.im);
    let values = found.iter().flat_map(|run| run.iter().map(|mode| xy(&mode.value)));
    let values: Vec<_> = values.collect();
    let truths = truth.list();
    let regions: Vec<Ellipse> =
        (0..3).map(|mode| mean_region(truths[mode], found.iter().map(|run| &run[mode]))).collect();
    let (dutch, real) = (regions[2], &regions[..2]);
    let panel = |title: &str| {
        Panel::new(title, Axis::linear("real part (1/s)"), Axis::linear("imaginary part (rad/s)"))
            .equal_axes()
            .with(Points::poles("reconstructed", values.iter().copied()).radius(3.0))
            .with(Points::eigenvalues("true eigenvalue", truths.iter().map(xy)).radius(5.5))
            .with(Ellipses::new("95 % ellipse", Dash::Solid, [dutch]).ink(Ink::Vermillion))
    };
    let panel = |title: &str| real.iter().fold(panel(title), with_interval);
    let around = |title: &str, mode: usize| {
        let (center, size) = (truths[mode], regions[mode].semi_axes.0);
        let farthest =
            found.iter().map(|run| (run[mode].value - center).norm()).fold(0.0, f64::max);
        // All of them, but not at the cost of the region.
        let reach = (1.8 * size).max(1.1 * farthest).min(3.0 * size);
        panel(title)
            .zoom((center.re - reach, center.re + reach), (center.im - reach, center.im + reach))
    };
    Figure::new("beyond-plane", "Fifty reconstructions in the s-plane", caption)
        .columns(2)
        .with(panel("upper half").zoom((-1.05, 0.85), (-0.05, 1.85)))
        .with(around("Dutch roll", 2))
        .with(around("roll", 1))
        .with(around("spiral", 0))
        .into()
}

/// Draws the region of a real mode, an interval on the real axis.
fn with_interval(panel: Panel, region: &Ellipse) -> Panel {
    let (center, half) = (region.center, region.semi_axes.0);
    let ends = [(center.0 - half, center.1), (center.0 + half, center.1)];
    panel.with(Line::new("95 % interval", Dash::Solid, ends).ink(Ink::Vermillion).width(3.0))
}

/// The 95 % region around the truth, with the mean of the stated covariances.
fn mean_region<'a>(
    truth: Complex<f64>,
    estimates: impl Iterator<Item = &'a ComplexEstimate>,
) -> Ellipse {
    let covariances: Vec<_> = estimates.map(|estimate| estimate.covariance).collect();
    let (mut a, mut b, mut c) = (0.0, 0.0, 0.0);
    for covariance in &covariances {
        let share = 1.0 / covariances.len() as f64;
        a += share * covariance[(0, 0)];
        b += share * covariance[(0, 1)];
        c += share * covariance[(1, 1)];
    }
    // Chi-squared with two degrees of freedom; with one where the mode is real.
    let quantile = if truth.im.abs() > 0.0 { 5.991_464_547_107_98 } else { 3.841_458_820_694_124 };
    let (middle, half) = (0.5 * (a + c), (0.5 * (a - c)).hypot(b));
    let axis = |variance: f64| (quantile * variance.max(0.0)).sqrt();
    Ellipse {
        center: (truth.re, truth.im),
        semi_axes: (axis(middle + half), axis(middle - half)),
        angle_rad: 0.5 * (2.0 * b).atan2(a - c),
    }
}
