//! Group 3: how time and memory grow with the number of samples and of regressors.

use report::{
    Axis, Block, Column, Dash, Figure, Ink, Line, Marker, Panel, Table, format_significant,
};

use super::machine::free_bytes;
use super::ours::{self, How, ModelOrders, PAPER};
use super::records::{self, Surface};
use super::stream::{self, Streamed};
use super::times::times;
use super::timing::{Runs, Timing, measure as time, show_seconds};
use super::{Bench, Group};
use crate::TaskError;
use crate::shared::asked::{Asked, Row, asked_and_reached};

/// Lengths of the records that are held in memory.
const LENGTHS: [usize; 4] = [10_000, 100_000, 1_000_000, 10_000_000];
/// The length that is streamed with `--long` only.
const LONGEST: usize = 100_000_000;
/// The longest record that the least-squares peers get: theirs needs 400 MB and more.
const PEER_LENGTH: usize = 1_000_000;
/// Records below this length are not asked about their memory: the program itself takes more.
const MEMORY_FROM: usize = 1_000_000;

/// r and d of the models of growing size, with l = 4: 2 r + 4 regressors.
const REACHES: [usize; 6] = [5, 10, 25, 50, 100, 200];
/// Samples of those.
const COLUMNS_LENGTH: usize = 100_000;
/// More regressors than this take a peer too long.
const PEER_REACH: usize = 100;

/// What is drawn; it looks the same in both figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Who {
    Gram,
    Fit,
    Streamed,
    Lstsq,
    PlainGram,
}

impl Who {
    fn label(self) -> &'static str {
        match self {
            Self::Gram => "Gram matrix, 1 thread",
            Self::Fit => "fit, 1 thread",
            Self::Streamed => "fit streamed from disk, 1 thread",
            Self::Lstsq => "numpy.linalg.lstsq",
            Self::PlainGram => "numpy Gram and Cholesky",
        }
    }

    fn style(self) -> (Ink, Dash, Marker) {
        match self {
            Self::Gram => (Ink::Blue, Dash::Solid, Marker::Circle),
            Self::Fit => (Ink::Vermillion, Dash::Dashed, Marker::Square),
            Self::Streamed => (Ink::Green, Dash::DashDot, Marker::Diamond),
            Self::Lstsq => (Ink::Purple, Dash::Dotted, Marker::Triangle),
            Self::PlainGram => (Ink::Orange, Dash::LongDash, Marker::TriangleDown),
        }
    }
}

/// One line of a figure.
struct Curve {
    who: Who,
    points: Vec<(f64, f64)>,
}

impl Curve {
    fn new(who: Who) -> Self {
        Self { who, points: Vec::new() }
    }

    fn push(&mut self, x: usize, timing: &Timing) {
        self.points.push((x as f64, timing.median()));
    }
}

pub(crate) fn measure(bench: &Bench) -> Result<Group, TaskError> {
    let mut blocks = with_length(bench)?;
    blocks.extend(with_columns(bench)?);
    Ok(Group {
        title: "Growth",
        introduction: format!(
            "Time against the number of samples N with l = 4, r = d = 25, from {} to {}; then against the number of regressors p at N = {}. Slopes are those of \
             least-squares lines through the logarithms. Streamed fits read two files of raw doubles, in blocks, in a process of their own, whose largest memory \
             Linux reports (`VmHWM`).",
            power(LENGTHS[0]),
            power(if bench.long { LONGEST } else { LENGTHS[3] }),
            power(COLUMNS_LENGTH),
        ),
        blocks,
    })
}

fn with_length(bench: &Bench) -> Result<Vec<Block>, TaskError> {
    let layout = ours::cfi_layout(PAPER)?;
    let mut curves = [
        Curve::new(Who::Gram),
        Curve::new(Who::Fit),
        Curve::new(Who::Streamed),
        Curve::new(Who::Lstsq),
        Curve::new(Who::PlainGram),
    ];
    let [gram, fit, streamed, lstsq, plain] = &mut curves;
    for samples in LENGTHS {
        bench.say(format!("growth: N = {}", power(samples)));
        let channels = records::with_noise(records::record(Surface::Aileron, samples)?);
        let record = [channels[0].as_slice(), channels[1].as_slice()];
        let runs = if samples > 1_000_000 { Runs::FEW } else { Runs::MANY };
        gram.push(samples, &time(runs, || ours::gram(&layout, &record, 1))?);
        fit.push(
            samples,
            &time(runs, || ours::fit(record[0], record[1], PAPER, How::Gram { threads: 1 }))?,
        );
        if samples <= PEER_LENGTH {
            add_peers(bench, &record, PAPER, samples, [&mut *lstsq, &mut *plain], samples)?;
        }
    }
    let lengths = LENGTHS.into_iter().chain(bench.long.then_some(LONGEST));
    let (mut summed, mut solutions, mut peaks) = (Vec::new(), Vec::new(), Vec::new());
    let mut missing = (!bench.long).then(|| "not asked for (`--long`)".to_owned());
    for samples in lengths {
        match stream_one(bench, samples)? {
            Ok(Streamed { sums, solution, peak_bytes }) => {
                summed.push((samples as f64, sums.median()));
                streamed.points.push((samples as f64, sums.median() + solution.median()));
                solutions.push(solution.median());
                peaks.extend(
                    peak_bytes.filter(|_| samples >= MEMORY_FROM).map(|bytes| (samples, bytes)),
                );
            }
            Err(reason) => missing = Some(reason),
        }
    }
    let asked = Asked::Within(0.95, 1.05);
    let mut rows = vec![
        slope_row("slope of the Gram matrix's time over N", &curves[0].points, asked),
        slope_row("slope of the time to read and sum a streamed record", &summed, asked),
        slope_row("slope of the whole fit's time", &curves[1].points, asked),
        slope_row("slope of the whole streamed fit's time", &curves[2].points, asked),
        memory_row(&peaks),
    ];
    rows.extend(
        missing.map(|reason| Row::unknown(format!("N = {}", power(LONGEST)), "streamed", reason)),
    );
    let caption = "Median time of a fit with 54 regressors. The Gram matrix is all that grows.";
    let figure = figure(
        "benchmarks-length",
        "Time against the number of samples",
        caption,
        "samples N",
        &curves,
    );
    let solution = solutions.iter().copied().fold(f64::INFINITY, f64::min);
    Ok(vec![
        Block::paragraph(format!(
            "Only the sums grow with N. The solution of the 54 equations, its condition and its covariance take {} more, whatever the length of the record; the sums of {} \
             samples take {}.",
            show_seconds(solution),
            power(LENGTHS[0]),
            show_seconds(curves[0].points.first().map_or(f64::NAN, |point| point.1)),
        )),
        asked_and_reached("Growth with the number of samples: asked and reached", &rows)?,
        curve_table("Median times against N", "N", &curves)?,
        memory_table(&peaks)?,
        figure.into(),
    ])
}

fn with_columns(bench: &Bench) -> Result<Vec<Block>, TaskError> {
    let channels = records::with_noise(records::record(Surface::Aileron, COLUMNS_LENGTH)?);
    let record = [channels[0].as_slice(), channels[1].as_slice()];
    let mut curves = [
        Curve::new(Who::Gram),
        Curve::new(Who::Fit),
        Curve::new(Who::Lstsq),
        Curve::new(Who::PlainGram),
    ];
    let [gram, fit, lstsq, plain] = &mut curves;
    for reach in REACHES {
        let orders = [PAPER[0], reach, reach];
        let regressors = PAPER[0] + 2 * reach;
        bench.say(format!("growth: p = {regressors}"));
        let layout = ours::cfi_layout(orders)?;
        gram.push(regressors, &time(Runs::MANY, || ours::gram(&layout, &record, 1))?);
        let how = How::Gram { threads: 1 };
        fit.push(regressors, &time(Runs::MANY, || ours::fit(record[0], record[1], orders, how))?);
        if reach <= PEER_REACH {
            add_peers(
                bench,
                &record,
                orders,
                regressors,
                [&mut *lstsq, &mut *plain],
                COLUMNS_LENGTH,
            )?;
        }
    }
    let rows = [slope_row(
        "slope of the Gram matrix's time over p",
        &curves[0].points,
        Asked::Within(0.8, 1.2),
    )];
    let caption = "Median time at 1e5 samples. The lag products grow with p; what is solved afterwards grows with its cube, whatever the number of samples, and shows at the right end.";
    let figure = figure(
        "benchmarks-columns",
        "Time against the number of regressors",
        caption,
        "regressors p",
        &curves,
    );
    Ok(vec![
        asked_and_reached("Growth with the number of regressors: asked and reached", &rows)?,
        curve_table("Median times against p", "p", &curves)?,
        figure.into(),
    ])
}

/// Puts the times of numpy's lstsq and plain Gram on their curves, if they can be had.
fn add_peers(
    bench: &Bench,
    record: &[&[f64]; 2],
    [l, r, d]: ModelOrders,
    x: usize,
    curves: [&mut Curve; 2],
    samples: usize,
) -> Result<(), TaskError> {
    if bench.peers.versions().is_empty() {
        return Ok(());
    }
    let files = records::write(bench.folder.path(), "growth", &record.map(<[f64]>::to_vec))?;
    for (curve, task) in curves.into_iter().zip(["lstsq", "gram"]) {
        let numbers = [samples, l, r, d, 3].map(|n| n.to_string());
        let mut arguments = vec![task];
        arguments.extend(numbers.iter().map(String::as_str));
        arguments.extend(files.iter().map(String::as_str));
        if let Some(timing) = bench.peers.run(&arguments).timing() {
            curve.push(x, timing);
        }
    }
    Ok(())
}

/// Writes a record to disk, fits it in another process, and removes it. The inner error says why
/// there was no room for it.
fn stream_one(bench: &Bench, samples: usize) -> Result<Result<Streamed, String>, TaskError> {
    /// What must stay free on the disk.
    const RESERVE: u64 = 1 << 30;
    let needed = 16 * samples as u64 + RESERVE;
    if let Some(free) = free_bytes(bench.folder.path()).filter(|free| *free < needed) {
        return Ok(Err(format!("{free} bytes are free on the disk, {needed} are needed")));
    }
    let folder = bench.folder.path().join("stream");
    std::fs::create_dir_all(&folder).map_err(|source| TaskError::io(&folder, source))?;
    let mut done = 0;
    records::write_long(&folder, samples, |block| {
        done += block;
        bench.say(format!("growth: writing {} of {} samples", done, power(samples)));
    })?;
    bench.say(format!("growth: streaming {} samples", power(samples)));
    let streamed = stream::parent(&folder)?;
    std::fs::remove_dir_all(&folder).map_err(|source| TaskError::io(&folder, source))?;
    Ok(Ok(streamed))
}

fn slope_row(what: &str, points: &[(f64, f64)], asked: Asked) -> Row {
    let ends = points.first().zip(points.last());
    let range = ends.map_or_else(String::new, |(first, last)| {
        format!(", from {} to {}", show_place(whole(first.0)), show_place(whole(last.0)))
    });
    match log_log_slope(points) {
        Some(slope) => Row::new(format!("{what}{range}"), asked, slope, |x| format!("{x:.2}")),
        None => Row::unknown(what, "a slope", "fewer than two points"),
    }
}

/// The least-squares slope of log(y) over log(x); `None` unless two different x and only positive
/// values are given.
///
/// slope = sum (u - mean u)(v - mean v) / sum (u - mean u)^2, with u = log x and v = log y.
fn log_log_slope(points: &[(f64, f64)]) -> Option<f64> {
    if points.iter().any(|(x, y)| !(*x > 0.0 && *y > 0.0 && x.is_finite() && y.is_finite())) {
        return None;
    }
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let mean =
        |part: fn(&(f64, f64)) -> f64| logs.iter().map(part).sum::<f64>() / logs.len() as f64;
    let (u_mean, v_mean) = (mean(|log| log.0), mean(|log| log.1));
    let along: f64 = logs.iter().map(|(u, _)| (u - u_mean).powi(2)).sum();
    let across: f64 = logs.iter().map(|(u, v)| (u - u_mean) * (v - v_mean)).sum();
    (along > 0.0).then(|| across / along)
}

/// Large counts as powers of ten, small ones in full.
fn show_place(count: usize) -> String {
    if count < 10_000 { count.to_string() } else { power(count) }
}

fn memory_row(peaks: &[(usize, u64)]) -> Row {
    const WHAT: &str = "peak memory of the longest record over that of 1e6 samples";
    match peaks {
        [(_, first), .., (_, last)] => {
            let ratio = megabytes(*last) / megabytes(*first);
            Row::new(WHAT, Asked::AtMost(1.1), ratio, times)
        }
        _ => Row::unknown(WHAT, times(1.1), "this system does not tell"),
    }
}

fn memory_table(peaks: &[(usize, u64)]) -> Result<Block, TaskError> {
    let header =
        [Column::right("N"), Column::right("record (MB)"), Column::right("peak memory (MB)")];
    let mut table = Table::new("Memory of the streaming process", header);
    for (samples, bytes) in peaks {
        let record = 16e-6 * *samples as f64;
        table
            .push([
                power(*samples),
                format_significant(record, 3),
                format_significant(megabytes(*bytes), 3),
            ])
            .map_err(TaskError::computation("report"))?;
    }
    Ok(table.into())
}

/// One row for each place, one column for each curve.
fn curve_table(title: &str, first: &str, curves: &[Curve]) -> Result<Block, TaskError> {
    let present: Vec<&Curve> = curves.iter().filter(|curve| !curve.points.is_empty()).collect();
    let header = std::iter::once(first)
        .chain(present.iter().map(|curve| curve.who.label()))
        .map(Column::right);
    let mut table = Table::new(title, header);
    let all: std::collections::BTreeSet<usize> =
        present.iter().flat_map(|curve| curve.points.iter().map(|point| whole(point.0))).collect();
    for place in all {
        let mut cells = vec![show_place(place)];
        for curve in &present {
            let point = curve.points.iter().find(|point| whole(point.0) == place);
            cells.push(point.map_or_else(|| "-".to_owned(), |point| show_seconds(point.1)));
        }
        table.push(cells).map_err(TaskError::computation("report"))?;
    }
    Ok(table.into())
}

fn figure(id: &str, title: &str, caption: &str, x: &str, curves: &[Curve]) -> Figure {
    let mut panel = Panel::new("", Axis::log(x), Axis::log("time (s)"));
    for curve in curves.iter().filter(|curve| !curve.points.is_empty()) {
        let (ink, dash, marker) = curve.who.style();
        let line = Line::new(curve.who.label(), dash, curve.points.clone());
        panel = panel.with(line.ink(ink).marker(marker));
    }
    Figure::new(id, title, caption).with(panel)
}

/// A count as a power of ten, where it is one.
fn power(count: usize) -> String {
    format!("{:e}", count as f64)
}

fn megabytes(bytes: u64) -> f64 {
    (bytes / 1000) as f64 / 1000.0
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "places on the x axis are counts made into doubles"
)]
fn whole(place: f64) -> usize {
    place as usize
}

#[cfg(test)]
mod tests;
