//! Group 2: how many digits the Gram matrix costs, held against Householder QR and against exact
//! solutions.

use num_complex::Complex;
use poly::{MrootsOptions, Poly, mroots};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use report::{Block, Column, Table};

use super::ours::{self, How, ModelOrders, PAPER};
use super::peers::Answer;
use super::records::{self, Surface};
use super::times::{small, times};
use super::{Bench, Group, exact};
use crate::TaskError;
use crate::shared::asked::{Asked, Row, asked_and_reached};
use crate::shared::reference;

const PART: &str = "accuracy";

/// Samples of the noise-free records.
const SAMPLES: usize = 100_000;

/// What is judged.
const JUDGED: [(&str, How); 2] =
    [("Gram", How::Gram { threads: 1 }), ("Gram, one pass", How::OnePass)];

/// What it is judged by.
const JUDGE: How = How::Qr;

/// The worst of several cases, for each of what is judged.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Worst {
    error: f64,
    /// Error over the judge's.
    ratio: f64,
}

impl Worst {
    fn add(&mut self, error: f64, judge: f64) {
        // Errors below the rounding unit are luck. `f64::max` would hide what is not a number.
        let floored = |x: f64| if x.is_nan() { x } else { x.max(f64::EPSILON) };
        let ratio = floored(error) / floored(judge);
        // What is not a number is as bad as can be.
        let larger = |a: f64, b: f64| if b.is_nan() { f64::INFINITY } else { a.max(b) };
        *self = Self { error: larger(self.error, error), ratio: larger(self.ratio, ratio) };
    }
}

pub(crate) fn measure(bench: &Bench) -> Result<Group, TaskError> {
    let mut blocks = aircraft(bench)?;
    blocks.extend(planted(bench)?);
    Ok(Group {
        title: "Accuracy",
        introduction: "Gram is the fit as it comes, refined on the data where that brings anything; in one pass it is not refined, as where a record is streamed. QR is our Householder QR \
                       in doubles. Ratios count errors below the rounding unit as one unit."
            .to_owned(),
        blocks,
    })
}

/// Roots of D from noise-free records of the aircraft.
fn aircraft(bench: &Bench) -> Result<Vec<Block>, TaskError> {
    let header = ["record", "sensor", "Gram", "Gram, one pass", "QR", "numpy lstsq", "numpy Gram"];
    let mut table = Table::new(
        "Noise-free aircraft, N = 1e5: largest relative error of the roots of D",
        header
            .iter()
            .enumerate()
            .map(|(i, name)| if i < 2 { Column::left(*name) } else { Column::right(*name) }),
    );
    let mut worst = [Worst::default(); 2];
    for surface in Surface::ALL {
        bench.say(format!("accuracy: noise-free, {}", surface.name()));
        let channels = records::record(surface, SAMPLES)?;
        let truth =
            reference::roots(&format!("/aircraft/as_printed/zeros_sideslip_{}", surface.name()))?;
        for (output, sensor) in [(1, "roll rate"), (2, "yaw rate")] {
            let error = |how| {
                let fit = ours::fit(&channels[0], &channels[output], PAPER, how)?;
                roots_error(&fit.model.denominator(), &truth)
            };
            let judge = error(JUDGE)?;
            let mut cells = vec![surface.name().to_owned(), sensor.to_owned()];
            for (worst, (_, how)) in worst.iter_mut().zip(JUDGED) {
                let error = error(how)?;
                worst.add(error, judge);
                cells.push(small(error));
            }
            cells.push(small(judge));
            let pair = [channels[0].clone(), channels[output].clone()];
            let files = records::write(bench.folder.path(), "accuracy", &pair)?;
            for task in ["lstsq", "gram"] {
                let samples = SAMPLES.to_string();
                let answer =
                    bench.peers.run(&[task, &samples, "4", "25", "25", "1", &files[0], &files[1]]);
                cells.push(peer_error(&answer, &truth)?);
            }
            table.push(cells).map_err(TaskError::computation(PART))?;
        }
    }
    let mut rows = Vec::new();
    for (Worst { error, ratio }, (name, _)) in worst.into_iter().zip(JUDGED) {
        rows.push(Row::new(
            format!("{name}: relative error of the roots"),
            Asked::AtMost(1e-9),
            error,
            small,
        ));
        rows.push(Row::new(format!("{name}: error over QR's"), Asked::AtMost(10.0), ratio, times));
    }
    Ok(vec![asked_and_reached("Noise-free aircraft: asked and reached", &rows)?, table.into()])
}

fn peer_error(answer: &Answer, truth: &[Complex<f64>]) -> Result<String, TaskError> {
    let Answer::Measured { theta, .. } = answer else {
        return Ok("-".to_owned());
    };
    // theta starts with c_1 .. c_(l-1); D has no constant term and the leading coefficient 1.
    let [l, ..] = PAPER;
    let unknown = theta.iter().copied().take(l - 1);
    let denominator: Vec<f64> = std::iter::once(0.0).chain(unknown).chain([1.0]).collect();
    roots_error(&denominator, truth).map(small)
}

/// The largest relative distance of a true zero from the closest root of D.
fn roots_error(denominator: &[f64], truth: &[Complex<f64>]) -> Result<f64, TaskError> {
    let roots = mroots(&Poly::new(denominator.to_vec()), &MrootsOptions::default())
        .map_err(TaskError::computation(PART))?
        .values();
    let error = |z: &Complex<f64>| {
        roots.iter().map(|root| (root - z).norm() / z.norm()).fold(f64::INFINITY, f64::min)
    };
    Ok(truth.iter().map(error).fold(0.0, f64::max))
}

/// Orders of the planted family: 21 Markov parameters, no denominator.
const PLANTED: ModelOrders = [0, 10, 10];
/// Samples of the planted family: short, since the exact solution is computed with integers.
const PLANTED_SAMPLES: usize = 1000;
/// Condition numbers to plant, as powers of ten.
const POWERS: std::ops::RangeInclusive<i32> = 2..=12;
/// Parts of the target that the model cannot explain, rms over rms.
const UNEXPLAINED: [f64; 2] = [0.0, 1e-3];

/// A slow wave with a little white noise on it: its shifted copies are as dependent as the noise is
/// small. Errors of the parameters against the exact solution for the doubles given.
fn planted(bench: &Bench) -> Result<Vec<Block>, TaskError> {
    let header =
        ["planted condition", "unexplained", "condition found", "Gram", "Gram, one pass", "QR"];
    let mut table = Table::new(
        "Planted condition: relative error of the parameters",
        header.map(Column::right),
    );
    let mut rows = Vec::new();
    for unexplained in UNEXPLAINED {
        let mut worst = [Worst::default(); 2];
        for power in POWERS {
            bench.say(format!("accuracy: condition 1e{power}"));
            let [input, output] = planted_record(10.0_f64.powi(power), unexplained);
            let truth = exact_solution(&input, &output)?;
            let reflections = ours::fit(&input, &output, PLANTED, JUDGE)?;
            let judge = distance(&reflections.model.theta(), &truth);
            let mut cells =
                vec![format!("1e{power}"), show_part(unexplained), small(reflections.condition)];
            for (worst, (_, how)) in worst.iter_mut().zip(JUDGED) {
                let fit = ours::fit(&input, &output, PLANTED, how)?;
                let error = distance(&fit.model.theta(), &truth);
                worst.add(error, judge);
                cells.push(small(error));
            }
            cells.push(small(judge));
            table.push(cells).map_err(TaskError::computation(PART))?;
        }
        for (Worst { ratio, .. }, (name, _)) in worst.into_iter().zip(JUDGED) {
            let what = format!(
                "{name}: error over QR's, worst of all, {} unexplained",
                show_part(unexplained)
            );
            rows.push(Row::new(what, Asked::AtMost(10.0), ratio, times));
        }
    }
    Ok(vec![
        Block::paragraph(
            "The input is a slow cosine with white noise of a planted size on it, so that its 21 shifted copies are nearly dependent; the output is a sum of them with random \
             coefficients, with and without a part that no coefficients explain. The reference is the least-squares solution for these very doubles, computed with integers \
             and rounded once.",
        ),
        asked_and_reached("Planted condition: asked and reached", &rows)?,
        table.into(),
    ])
}

/// Input and output whose regressors have about this condition number.
///
/// The cosine's shifted copies span two dimensions with singular values of about sqrt(p N) / 2
/// each, the noise's p dimensions with e sqrt(N) each: the condition is sqrt(p) / (2 e).
fn planted_record(condition: f64, unexplained: f64) -> [Vec<f64>; 2] {
    let [_, r, d] = PLANTED;
    let mut random = ChaCha8Rng::seed_from_u64(4);
    let mut normal = || -> f64 { StandardNormal.sample(&mut random) };
    let noise = ((r + d + 1) as f64).sqrt() / (2.0 * condition);
    let input: Vec<f64> =
        (0..PLANTED_SAMPLES).map(|k| (0.1 * k as f64).cos() + noise * normal()).collect();
    let coefficients: Vec<f64> = (0..=r + d).map(|_| normal()).collect();
    let clean: Vec<f64> = (0..PLANTED_SAMPLES)
        .map(|k| {
            let term =
                |(i, h): (usize, &f64)| input.get((k + d).wrapping_sub(i)).map_or(0.0, |x| h * x);
            coefficients.iter().enumerate().map(term).sum()
        })
        .collect();
    let square: f64 = clean.iter().map(|y| y * y).sum();
    let rms = (square / clean.len() as f64).sqrt();
    let output = clean.into_iter().map(|y| y + unexplained * rms * normal()).collect();
    [input, output]
}

/// h_-d .. h_r without rounding errors.
fn exact_solution(input: &[f64], output: &[f64]) -> Result<Vec<f64>, TaskError> {
    let [_, r, d] = PLANTED;
    let rows = input.len() - r - d;
    // Rows k = r .. N - 1 - d; h_i goes with y_i(k - i), the farthest future first.
    let columns: Vec<&[f64]> = (0..=r + d).map(|i| &input[r + d - i..r + d - i + rows]).collect();
    exact::least_squares(&columns, &output[r..r + rows]).ok_or_else(|| TaskError::Computation {
        part: PART,
        message: "the planted columns are dependent".to_owned(),
    })
}

fn show_part(part: f64) -> String {
    if part > 0.0 { format!("{part:e}") } else { "nothing".to_owned() }
}

/// Relative, in the 2-norm.
fn distance(found: &[f64], truth: &[f64]) -> f64 {
    let square = |values: &mut dyn Iterator<Item = f64>| values.map(|x| x * x).sum::<f64>().sqrt();
    square(&mut found.iter().zip(truth).map(|(a, b)| a - b)) / square(&mut truth.iter().copied())
}

#[cfg(test)]
mod tests;
