//! The project's own tasks: reproduce the paper, measure speed and accuracy, study noise,
//! disturbances and flights in a simulator, keep the tree tidy.

mod bench;
mod error;
mod reproduce;
mod shared;
mod study;
mod tidy;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};

pub(crate) use error::TaskError;

/// The project's own tasks.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask", arg_required_else_help = true)]
struct Args {
    #[command(subcommand)]
    task: Task,
}

#[derive(Debug, Subcommand)]
enum Task {
    Reproduce(reproduce::Args),
    Bench(bench::Args),
    Study(study::Args),
    /// Check what the compiler cannot: equation marks against docs/equations.md, the shape of
    /// source files.
    Tidy,
}

fn main() -> ExitCode {
    let args = Args::parse();
    let mut out = std::io::stdout().lock();
    let result = match &args.task {
        Task::Reproduce(args) => reproduce::run(&root(), args, &mut out),
        Task::Bench(args) => bench::run(&root(), args, &mut out),
        Task::Study(args) => study::run(&root(), args, &mut out),
        Task::Tidy => tidy::run(&root(), &mut out),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // The exit code says it too, if even this cannot be written.
            let _ = writeln!(std::io::stderr(), "error: {error}");
            error.exit_code()
        }
    }
}

/// The folder of the workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, Path::to_path_buf)
}
