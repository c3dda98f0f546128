//! On a terminal long work shows that it goes on, and ends.
#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "a test that unwraps an error has failed")]

use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What the program shows on a terminal as its standard error.
fn shown(words: &[&str]) -> String {
    let terminal = nix::pty::openpty(None, None).unwrap();
    let mut child = Command::new(env!("CARGO_BIN_EXE_transmode"))
        .args(words)
        .env("TERM", "xterm")
        .env_remove("NO_COLOR")
        .stdout(Stdio::null())
        .stderr(Stdio::from(terminal.slave))
        .spawn()
        .unwrap();
    let mut screen = File::from(terminal.master);
    let reader = std::thread::spawn(move || {
        let (mut shown, mut part) = (Vec::new(), [0; 4096]);
        // The last one to close a terminal leaves an error behind.
        while let Ok(count @ 1..) = screen.read(&mut part) {
            shown.extend_from_slice(&part[..count]);
        }
        String::from_utf8_lossy(&shown).into_owned()
    });
    let started = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if started.elapsed() > Duration::from_secs(300) {
            child.kill().unwrap();
            panic!("{words:?} does not end");
        }
        std::thread::sleep(Duration::from_millis(20));
    };
    let shown = reader.join().unwrap();
    assert!(status.code().is_some_and(|code| code < 2), "{shown}");
    shown
}

#[test]
fn a_long_search_shows_that_it_goes_on() {
    let records = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/data/records");
    let [aileron, rudder] = ["white_snr10_aileron.csv", "white_snr10_rudder.csv"]
        .map(|name| records.join(name).to_str().unwrap().to_owned());
    // More states than the records show take seconds.
    let words = ["identify", &aileron, &rudder, "--order", "8"];
    let text = shown(&words);
    assert!(text.contains("searching for the modes"), "{text:?}");
    assert_eq!(shown(&[&words[..], &["--quiet"]].concat()), "");
}
