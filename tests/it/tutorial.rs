//! The tutorial's commands do what the tutorial says.

use std::path::Path;

use transmode::Exit;

use crate::program::{Folder, Ran, transmode};

/// A command of the tutorial, and what it prints there.
struct Step {
    command: String,
    output: String,
}

fn docs() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs"))
}

fn steps() -> Vec<Step> {
    let text = std::fs::read_to_string(docs().join("tutorial.md")).unwrap();
    let blocks = text.split("```console\n$ ").skip(1);
    blocks
        .map(|block| {
            let (block, _) = block.split_once("```").unwrap();
            let (command, output) = block.split_once('\n').unwrap();
            Step { command: command.to_owned(), output: output.to_owned() }
        })
        .collect()
}

/// Runs a command of this program with its files in that folder, whose name is taken out of the output.
fn run(command: &str, folder: &Folder) -> Ran {
    let mut words: Vec<String> = Vec::new();
    for word in command.split_whitespace().skip(1) {
        let is_file = word.contains('/') || word.ends_with(".csv") || word.ends_with(".json");
        let is_folder = words.last().is_some_and(|last| last == "-o" || last == "--report");
        let place = || folder.path(word).to_str().unwrap().to_owned();
        words.push(if is_file || is_folder { place() } else { word.to_owned() });
    }
    let mut ran = transmode(&words.iter().map(String::as_str).collect::<Vec<_>>());
    ran.out = ran
        .out
        .replace(&format!("{}/", folder.path("").to_str().unwrap().trim_end_matches('/')), "");
    ran
}

/// Words as they are, numbers to two parts in a hundred: the last digits belong to the machine, and rounding to two digits may turn.
fn same(found: &str, expected: &str) -> bool {
    let words = |text: &str| -> Vec<String> {
        text.split([' ', '\n', ',', 'j', ')', ';'])
            .filter(|word| !word.is_empty())
            .map(str::to_owned)
            .collect()
    };
    let (found, expected) = (words(found), words(expected));
    found.len() == expected.len()
        && found.iter().zip(&expected).all(|(a, b)| match (a.parse::<f64>(), b.parse::<f64>()) {
            (Ok(a), Ok(b)) => (a - b).abs() <= 0.02 * b.abs(),
            _ => a == b,
        })
}

#[test]
fn every_command_prints_what_the_tutorial_says() {
    let folder = Folder::new();
    let steps = steps();
    assert!(steps.len() >= 10);
    let mut doubtful = 0;
    for Step { command, output } in &steps {
        if let Some(awk) = command.strip_prefix("awk ") {
            // The vane freezes in row 2001 behind the header.
            assert!(awk.contains("NR > 2001 { $2 = 0.01 }"), "{awk}");
            let text = std::fs::read_to_string(folder.path("today/aileron.csv")).unwrap();
            let frozen = |(row, line): (usize, &str)| {
                let mut fields: Vec<&str> = line.split(',').collect();
                if row > 2000 {
                    fields[1] = "0.01";
                }
                fields.join(",") + "\n"
            };
            folder.file("stuck.csv", text.lines().enumerate().map(frozen).collect::<String>());
            continue;
        }
        let ran = run(command, &folder);
        assert_eq!(ran.err, "", "{command}");
        if command.contains("identify both/") {
            // Numbers that nothing determines differ from machine to machine; what is said against them does not.
            assert_eq!(ran.exit, Exit::Doubtful);
            for line in [
                "both.csv, 1000 samples, every 0.1 s, at least 2 excitations",
                "warning: record both.csv: ",
            ] {
                assert!(ran.out.contains(line) && output.contains(line), "{}", ran.out);
            }
            doubtful += 1;
            continue;
        }
        doubtful += usize::from(ran.exit == Exit::Doubtful);
        assert_ne!(ran.exit, Exit::BadInput, "{command}");
        assert!(same(&ran.out, output), "{command}\n{}\nis not\n{output}", ran.out);
    }
    // The record of two excitations, and the frozen sensor.
    assert_eq!(doubtful, 2);
    assert!(folder.path("modes.json").exists());
    assert!(folder.path("report/report.html").exists());
}

#[test]
fn the_records_that_are_shipped_are_those_that_the_command_makes() {
    let folder = Folder::new();
    let first = &steps()[0];
    assert_eq!(run(&first.command, &folder).exit, Exit::Fine);
    for name in ["aileron.csv", "rudder.csv", "truth.json"] {
        let shipped = std::fs::read(docs().join("tutorial/flights").join(name)).unwrap();
        let made = std::fs::read(folder.path("flights").join(name)).unwrap();
        assert!(made == shipped, "{name} has changed; make it anew: {}", first.command);
    }
}
