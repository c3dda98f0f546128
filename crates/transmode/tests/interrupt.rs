//! Ctrl-C leaves whole files or none.
#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "a test that unwraps an error has failed")]

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Records of some megabytes, so that writing them takes a while.
fn simulate(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_transmode"));
    command.args(["simulate", "paper", "--duration", "6000", "--sample-period", "0.1", "-o"]);
    command.arg(folder).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

fn names(folder: &Path) -> Vec<String> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn an_interruption_leaves_whole_files_or_none() {
    const ALL: [&str; 3] = ["aileron.csv", "rudder.csv", "truth.json"];
    let place = tempfile::tempdir().unwrap();
    let whole = place.path().join("whole");
    let started = Instant::now();
    assert!(simulate(&whole).status().unwrap().success());
    let takes = started.elapsed();
    assert_eq!(names(&whole), ALL);

    let (mut interrupted, mut finished) = (0, 0);
    for part in 1..=24 {
        let folder = place.path().join(part.to_string());
        let mut child = simulate(&folder).spawn().unwrap();
        // Most of them towards the end, where files are written.
        std::thread::sleep(takes.mul_f64(1.1 * (f64::from(part) / 24.0).sqrt()));
        let signal = if part % 2 == 0 { "-INT" } else { "-TERM" };
        let _ = Command::new("kill").args([signal, &child.id().to_string()]).status();
        let ended = Instant::now();
        let status = child.wait().unwrap();
        assert!(ended.elapsed() < takes + Duration::from_secs(5));
        let found = names(&folder);
        assert!(found.is_empty() || found == ALL, "{part}: {found:?}");
        for name in &found {
            let [now, before] = [&folder, &whole].map(|at| std::fs::read(at.join(name)).unwrap());
            assert!(now == before, "{part}: {name}");
        }
        match status.code() {
            // Ended by the signal.
            None => interrupted += 1,
            Some(0) => finished += 1,
            code => panic!("{part}: exit code {code:?}"),
        }
    }
    assert!(interrupted > 0, "{finished} finished");
}
