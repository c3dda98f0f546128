//! A fit of a record that is read from disk in blocks, in a process of its own: what it takes in
//! time and memory.

use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;
use std::process::Command;

use cfi_ident::Accumulator;
use serde::{Deserialize, Serialize};

use super::ours::{self, PAPER};
use super::timing::{Runs, Timing, measure as time};
use crate::TaskError;

const PART: &str = "streaming";

/// Samples read at a time.
const BLOCK: usize = 1 << 14;

/// What the process found.
#[derive(Debug)]
pub(crate) struct Streamed {
    /// Reading the files and summing the lag products.
    pub(crate) sums: Timing,
    /// What is solved from the sums, whatever the length of the record.
    pub(crate) solution: Timing,
    /// `None` where the system does not tell.
    pub(crate) peak_bytes: Option<u64>,
}

/// The line that the process prints.
#[derive(Serialize, Deserialize)]
struct Line {
    sum_seconds: Vec<f64>,
    solution_seconds: Vec<f64>,
    peak_bytes: Option<u64>,
    rank: usize,
}

/// Starts the process for the record in `folder` and reads its answer.
pub(crate) fn parent(folder: &Path) -> Result<Streamed, TaskError> {
    let program =
        std::env::current_exe().map_err(|source| TaskError::io("this program", source))?;
    let output = Command::new(&program)
        .args(["bench", "--stream"])
        .arg(folder)
        .output()
        .map_err(|source| TaskError::io(&program, source))?;
    let fault = |message: String| TaskError::Computation { part: PART, message };
    if !output.status.success() {
        return Err(fault(String::from_utf8_lossy(&output.stderr).trim().to_owned()));
    }
    judge(&output.stdout).map_err(fault)
}

fn judge(answer: &[u8]) -> Result<Streamed, String> {
    let line: Line = serde_json::from_slice(answer).map_err(|error| error.to_string())?;
    let [l, r, d] = PAPER;
    if line.rank != l + r + d {
        return Err(format!("the fit has rank {}, it should be {}", line.rank, l + r + d));
    }
    let timing = |seconds| Timing::new(seconds).ok_or("the process gave no time");
    Ok(Streamed {
        sums: timing(line.sum_seconds)?,
        solution: timing(line.solution_seconds)?,
        peak_bytes: line.peak_bytes,
    })
}

/// The process: fits the record several times and prints its line.
pub(crate) fn child(folder: &Path, out: &mut dyn Write) -> Result<(), TaskError> {
    let fault = TaskError::computation(PART);
    let sums = time(Runs::FEW, || read(folder))?;
    let read = read(folder)?;
    let solution = time(Runs::FEW, || read.fit().map_err(fault))?;
    let line = Line {
        sum_seconds: sums.seconds().to_vec(),
        solution_seconds: solution.seconds().to_vec(),
        peak_bytes: peak_bytes(),
        rank: read.fit().map_err(fault)?.rank,
    };
    let text = serde_json::to_string(&line).map_err(TaskError::computation(PART))?;
    writeln!(out, "{text}").map_err(|source| TaskError::io("standard output", source))
}

/// The largest memory that this process has had, in bytes as Linux counts it; `None` where the
/// system does not tell.
fn peak_bytes() -> Option<u64> {
    high_water_mark(&std::fs::read_to_string("/proc/self/status").ok()?)
}

/// The line `VmHWM:  1234 kB` of /proc/self/status, in bytes.
fn high_water_mark(status: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let number = line.trim().strip_suffix("kB")?.trim();
    number.parse::<u64>().ok()?.checked_mul(1024)
}

/// Reads the two channels side by side and sums their lag products.
fn read(folder: &Path) -> Result<Accumulator, TaskError> {
    let mut input = Doubles::open(&folder.join("input.f64"))?;
    let mut output = Doubles::open(&folder.join("output.f64"))?;
    let mut sums = ours::streaming(PAPER)?;
    loop {
        let (x, y) = (input.next()?, output.next()?);
        if x.is_empty() && y.is_empty() {
            return Ok(sums);
        }
        sums.push(x, y).map_err(TaskError::computation(PART))?;
    }
}

/// A file of raw little-endian doubles, block by block.
struct Doubles {
    file: File,
    name: std::path::PathBuf,
    bytes: Vec<u8>,
    values: Vec<f64>,
}

impl Doubles {
    fn open(name: &Path) -> Result<Self, TaskError> {
        let file = File::open(name).map_err(|source| TaskError::io(name, source))?;
        Ok(Self { file, name: name.to_owned(), bytes: Vec::new(), values: Vec::new() })
    }

    /// The next block; empty at the end.
    fn next(&mut self) -> Result<&[f64], TaskError> {
        const WIDTH: usize = size_of::<f64>();
        self.bytes.clear();
        Read::by_ref(&mut self.file)
            .take((BLOCK * WIDTH) as u64)
            .read_to_end(&mut self.bytes)
            .map_err(|source| TaskError::io(&self.name, source))?;
        let (whole, rest) = self.bytes.as_chunks::<WIDTH>();
        if !rest.is_empty() {
            return Err(TaskError::Computation {
                part: PART,
                message: format!("{} ends within a number", self.name.display()),
            });
        }
        self.values.clear();
        self.values.extend(whole.iter().map(|bytes| f64::from_le_bytes(*bytes)));
        Ok(&self.values)
    }
}

#[cfg(test)]
mod tests;
