//! The Python peers: a virtual environment of their own, and one process for each measurement.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde::Deserialize;

use super::timing::Timing;
use crate::TaskError;

/// What runs in each process.
const SCRIPT: &str = include_str!("peers.py");

/// Every linear-algebra library that a peer may bring listens to one of these.
const THREAD_LIMITS: [&str; 5] = [
    "OPENBLAS_NUM_THREADS",
    "OMP_NUM_THREADS",
    "MKL_NUM_THREADS",
    "BLIS_NUM_THREADS",
    "VECLIB_MAXIMUM_THREADS",
];

/// The peers, or why there are none.
#[derive(Debug)]
pub(crate) struct Peers {
    state: Result<Environment, String>,
}

#[derive(Debug)]
struct Environment {
    python: PathBuf,
    script: PathBuf,
    versions: Vec<(String, String)>,
}

/// A measurement of a peer.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Answer {
    /// It ran.
    Measured {
        timing: Timing,
        /// The solution, where the task has one.
        theta: Vec<f64>,
        /// What the peer warned of, 0 if nothing.
        warning: i64,
    },
    /// It could not run, and why.
    Unavailable(String),
}

impl Answer {
    pub(crate) fn timing(&self) -> Option<&Timing> {
        match self {
            Self::Measured { timing, .. } => Some(timing),
            Self::Unavailable(_) => None,
        }
    }
}

/// The line that the script prints.
#[derive(Deserialize)]
#[serde(untagged)]
enum Line {
    Measured {
        seconds: Vec<f64>,
        #[serde(default)]
        theta: Vec<f64>,
        #[serde(default)]
        warning: i64,
    },
    Versions {
        versions: serde_json::Map<String, serde_json::Value>,
    },
    Unavailable {
        unavailable: String,
    },
}

impl Peers {
    /// Nobody asked for them.
    pub(crate) fn not_asked() -> Self {
        Self { state: Err("not asked for (`--peers`)".to_owned()) }
    }

    /// Makes or reuses the virtual environment below `target`, and puts the script into `folder`.
    ///
    /// Where Python or a package cannot be had the peers say so, and nothing fails.
    pub(crate) fn prepare(target: &Path, folder: &Path) -> Result<Self, TaskError> {
        let script = folder.join("peers.py");
        std::fs::write(&script, SCRIPT).map_err(|source| TaskError::io(&script, source))?;
        let state = environment(&target.join("bench-peers")).map(|python| {
            let mut environment = Environment { python, script, versions: Vec::new() };
            environment.versions = environment.ask_versions();
            environment
        });
        Ok(Self { state })
    }

    /// Names and versions of what was found.
    pub(crate) fn versions(&self) -> &[(String, String)] {
        self.state.as_ref().map_or(&[], |environment| &environment.versions)
    }

    /// One measurement, in a process of its own.
    pub(crate) fn run(&self, arguments: &[&str]) -> Answer {
        match &self.state {
            Ok(environment) => environment.run(arguments).map_or_else(Answer::Unavailable, judge),
            Err(reason) => Answer::Unavailable(reason.clone()),
        }
    }
}

impl Environment {
    fn run(&self, arguments: &[&str]) -> Result<String, String> {
        let mut command = Command::new(&self.python);
        command.arg(&self.script).args(arguments);
        command.envs(THREAD_LIMITS.map(|name| (name, "1")));
        finished(&mut command)
    }

    fn ask_versions(&self) -> Vec<(String, String)> {
        match self.run(&["versions"]).map(|text| parse(&text)) {
            Ok(Ok(Line::Versions { versions })) => {
                let text = |value: serde_json::Value| value.as_str().unwrap_or("?").to_owned();
                versions.into_iter().map(|(name, version)| (name, text(version))).collect()
            }
            _ => Vec::new(),
        }
    }
}

/// The interpreter of the virtual environment, made if it is not there.
fn environment(folder: &Path) -> Result<PathBuf, String> {
    let places = [folder.join("bin/python"), folder.join("Scripts/python.exe")];
    let found = || places.iter().find(|place| place.is_file()).cloned();
    if found().is_none() {
        let made = ["python3", "python"]
            .map(|python| finished(Command::new(python).args(["-m", "venv"]).arg(folder)));
        if let [Err(reason), Err(_)] = made {
            return Err(format!("no virtual environment: {reason}"));
        }
    }
    let python = found().ok_or("the virtual environment has no interpreter")?;
    // One after the other: where SLICOT has no wheel, numpy and scipy are still worth having. What
    // is missing is told by the script.
    for packages in [&["numpy", "scipy"][..], &["ctrlsys"]] {
        let _ = finished(
            Command::new(&python)
                .args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"])
                .args(packages),
        );
    }
    Ok(python)
}

/// The standard output of a command that succeeded, or the last line of what it complained about.
fn finished(command: &mut Command) -> Result<String, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|error| format!("{name}: {error}"))?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let complaint = String::from_utf8_lossy(&output.stderr);
    let last = complaint.lines().rfind(|line| !line.trim().is_empty());
    Err(format!("{name}: {}", last.unwrap_or("failed without a word")))
}

fn parse(text: &str) -> Result<Line, String> {
    let line = text.lines().rfind(|line| !line.trim().is_empty()).unwrap_or_default();
    serde_json::from_str(line).map_err(|_| format!("the peer answered {line:?}"))
}

fn judge(text: String) -> Answer {
    match parse(&text) {
        Ok(Line::Measured { seconds, theta, warning }) => Timing::new(seconds).map_or_else(
            || Answer::Unavailable("the peer gave no time".to_owned()),
            |timing| Answer::Measured { timing, theta, warning },
        ),
        Ok(Line::Unavailable { unavailable }) => Answer::Unavailable(unavailable),
        Ok(Line::Versions { .. }) => Answer::Unavailable("the peer gave no time".to_owned()),
        Err(reason) => Answer::Unavailable(reason),
    }
}

#[cfg(test)]
mod tests;
