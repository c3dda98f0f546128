//! Group 1: a million samples, beside numpy, scipy, SLICOT and faer.

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use report::Block;

use super::ours::{self, How, PAPER};
use super::peers::Answer;
use super::records::{self, Channels, Surface};
use super::times::{TimeRow, speedup, times, times_table};
use super::timing::{Runs, Timing, measure as time};
use super::{Bench, Group};
use crate::TaskError;
use crate::shared::asked::{Asked, Row, asked_and_reached};

const SAMPLES: usize = 1_000_000;
/// Block rows of the Hankel matrices; with three channels 60 and 120 rows.
const BLOCK_ROWS: [usize; 2] = [20, 40];

pub(crate) fn measure(bench: &Bench) -> Result<Group, TaskError> {
    bench.say("speed: a million samples");
    let clean = records::record(Surface::Aileron, SAMPLES)?;
    let noisy = records::with_noise(clean.clone());
    let mut blocks = composite(bench, &clean, &noisy)?;
    blocks.extend(block_hankel(bench, &noisy)?);
    Ok(Group {
        title: "A million samples",
        introduction: "The paper's aircraft, aileron moving, white excitation; sideslip and roll rate for the composite fit with l = 4, r = d = 25 (54 \
                       regressors), all three sensors for the block-Hankel matrices. Noise, where there is any, is white, a hundredth of each sensor's rms."
            .to_owned(),
        blocks,
    })
}

/// The composite fit, its Gram matrix, and the peers on the same regressors.
fn composite(bench: &Bench, clean: &Channels, noisy: &Channels) -> Result<Vec<Block>, TaskError> {
    let (input, output) = (clean[0].as_slice(), clean[1].as_slice());
    let layout = ours::cfi_layout(PAPER)?;
    let gram = |threads| time(Runs::MANY, || ours::gram(&layout, &[input, output], threads));
    let fit = |channels: &Channels, how, runs| {
        time(runs, || ours::fit(&channels[0], &channels[1], PAPER, how))
    };
    let [one, two] = [1, 2].map(|threads| How::Gram { threads });

    bench.say("speed: our Gram matrix and fit");
    let (gram_one, gram_two) = (gram(1)?, gram(2)?);
    let (clean_one, clean_two) = (fit(clean, one, Runs::MANY)?, fit(clean, two, Runs::MANY)?);
    let (noisy_one, noisy_two) = (fit(noisy, one, Runs::MANY)?, fit(noisy, two, Runs::MANY)?);
    bench.say("speed: our QR");
    let qr = fit(clean, How::Qr, Runs::FEW)?;
    bench.say("speed: faer's QR");
    let faer = faer_qr(input, output)?;

    let files = records::write(bench.folder.path(), "composite", &clean[..2])?;
    let peer = |task: &str, runs: &str| {
        bench.say(format!("speed: {task}"));
        let samples = SAMPLES.to_string();
        bench.peers.run(&[task, &samples, "4", "25", "25", runs, &files[0], &files[1]])
    };
    let (lstsq, gelsy, plain) = (peer("lstsq", "5"), peer("gelsy", "5"), peer("gram", "11"));

    let mut asked = Vec::new();
    for (record, fit) in [("with noise", &noisy_one), ("noise-free", &clean_one)] {
        let over = |peer| format!("fit, {record}, over {peer}");
        asked.push(speedup(over("numpy.linalg.lstsq"), 40.0, &lstsq, fit));
        asked.push(speedup(over("numpy's Gram and Cholesky"), 2.5, &plain, fit));
    }
    for (what, one, two) in [
        ("Gram matrix", &gram_one, &gram_two),
        ("fit, with noise", &noisy_one, &noisy_two),
        ("fit, noise-free", &clean_one, &clean_two),
    ] {
        let ratio = one.median() / two.median();
        asked.push(Row::new(
            format!("{what}, 2 threads over 1"),
            Asked::AtLeast(1.7),
            ratio,
            times,
        ));
    }
    let rows = [
        TimeRow::ours("Gram matrix, 1 thread", &gram_one, "55 columns: regressors and target"),
        TimeRow::ours("Gram matrix, 2 threads", &gram_two, ""),
        TimeRow::ours(
            "fit, with noise, 1 thread",
            &noisy_one,
            "all of it: check, Gram matrix, solution, residual, covariance",
        ),
        TimeRow::ours("fit, with noise, 2 threads", &noisy_two, ""),
        TimeRow::ours(
            "fit, noise-free, 1 thread",
            &clean_one,
            "with the refinement that such data ask for",
        ),
        TimeRow::ours("fit, noise-free, 2 threads", &clean_two, ""),
        TimeRow::ours("fit by QR, 1 thread", &qr, "our cross-check"),
        TimeRow::peer("numpy.linalg.lstsq", &lstsq, "singular values"),
        TimeRow::peer("scipy.linalg.lstsq, gelsy", &gelsy, "pivoted QR"),
        TimeRow::peer("numpy's Gram and scipy's Cholesky", &plain, "plain double precision"),
        TimeRow::ours("faer's QR", &faer, "Householder, blocked"),
    ];
    Ok(vec![
        asked_and_reached("Composite fit, N = 1e6: asked and reached", &asked)?,
        times_table("Composite fit, N = 1e6: times", &rows)?,
    ])
}

/// faer's Householder QR of the regressors, and the solution.
fn faer_qr(input: &[f64], output: &[f64]) -> Result<Timing, TaskError> {
    let [l, r, d] = PAPER;
    let first = r;
    let rows = input.len() - r - l.max(d);
    let regressors = Mat::from_fn(rows, l - 1 + r + d + 1, |row, column| {
        let k = first + row;
        if column < l - 1 { -output[k + column + 1] } else { input[k + d - (column + 1 - l)] }
    });
    let target = Mat::from_fn(rows, 1, |row, _| output[first + row + l]);
    time(Runs::FEW, || Ok(regressors.qr().solve_lstsq(&target)))
}

/// Gram matrices of block-Hankel matrices, beside SLICOT's.
fn block_hankel(bench: &Bench, noisy: &Channels) -> Result<Vec<Block>, TaskError> {
    let files = records::write(bench.folder.path(), "hankel", noisy)?;
    let record = [noisy[0].as_slice(), &noisy[1], &noisy[2]];
    let (mut asked, mut rows) = (Vec::new(), Vec::new());
    for block_rows in BLOCK_ROWS {
        let layout = ours::block_hankel(noisy.len(), block_rows)?;
        bench.say(format!("speed: {block_rows} block rows"));
        let one = time(Runs::MANY, || ours::gram(&layout, &record, 1))?;
        let two = time(Runs::MANY, || ours::gram(&layout, &record, 2))?;
        let peer = |task: &str, algorithm: &str| {
            bench.say(format!("speed: {task} {algorithm}, {block_rows} block rows"));
            let mut arguments = vec![task.to_owned(), SAMPLES.to_string(), block_rows.to_string()];
            arguments.extend([algorithm.to_owned(), "7".to_owned()]);
            arguments.extend(files.iter().cloned());
            bench.peers.run(&arguments.iter().map(String::as_str).collect::<Vec<_>>())
        };
        let (cholesky, fast) = (peer("ib01ad", "C"), peer("ib01ad", "F"));
        let pieces = peer("ib01md-blocks", "C");
        let quicker = quicker(&cholesky, &fast);
        asked.push(speedup(
            format!("{block_rows} block rows, 1 thread, over IB01AD"),
            2.5,
            quicker,
            &one,
        ));
        asked.push(Row::new(
            format!("{block_rows} block rows, 2 threads over 1"),
            Asked::AtLeast(1.7),
            one.median() / two.median(),
            times,
        ));
        rows.push(TimeRow::ours(
            format!("Gram matrix, {block_rows} block rows, 1 thread"),
            &one,
            "doubled precision",
        ));
        rows.push(TimeRow::ours(
            format!("Gram matrix, {block_rows} block rows, 2 threads"),
            &two,
            "",
        ));
        for (name, answer) in [("Cholesky", &cholesky), ("fast QR", &fast)] {
            let what = format!("IB01AD, {name}, {block_rows} block rows");
            rows.push(TimeRow::peer(what, answer, slicot_remark(answer, block_rows)));
        }
        let what = format!("IB01MD in blocks, {block_rows} block rows");
        let remark = format!(
            "{}; the factor alone, plain double precision",
            slicot_remark(&pieces, block_rows)
        );
        rows.push(TimeRow::peer(what, &pieces, remark));
    }
    let note = "IB01AD is SLICOT's, with MOESP and no inputs; its matrix has 2 NOBR block rows, so that NOBR is half of ours, and it also factors the matrix and \
                takes its singular values. The records carry noise, since without any Cholesky gives way to the slow QR, and the fast QR to an error. \
                It is called as its manual has it, with the whole record. The rows of IB01MD are its sums and their factor alone, \
                with the record handed over in blocks of 20 000 samples, which stay in the cache: the measure of plain double precision.";
    Ok(vec![
        Block::paragraph(note),
        asked_and_reached("Block-Hankel Gram matrices, N = 1e6: asked and reached", &asked)?,
        times_table("Block-Hankel Gram matrices, N = 1e6: times", &rows)?,
    ])
}

/// The quicker of two answers; the first where neither ran.
fn quicker<'a>(a: &'a Answer, b: &'a Answer) -> &'a Answer {
    match (a.timing(), b.timing()) {
        (Some(x), Some(y)) if y.median() < x.median() => b,
        (None, Some(_)) => b,
        _ => a,
    }
}

fn slicot_remark(answer: &Answer, block_rows: usize) -> String {
    let half = format!("NOBR = {}", block_rows / 2);
    match answer {
        Answer::Measured { warning, .. } if *warning != 0 => {
            format!("{half}; warning {warning}")
        }
        _ => half,
    }
}
