//! Windows and rates that a file does not have.

use transmode::Exit;

use crate::bad_files::good;
use crate::program::{Folder, transmode};

/// A file and a window or an option that clap refuses, or that needs the file's name.
#[test]
fn windows_and_options_that_cannot_be() {
    let folder = Folder::new();
    let file = folder.file("a.csv", good());
    let window = |text: &str| format!("{file}:{text}");
    for (text, expected) in [
        (
            "30:40",
            "no sample lies in the window from 30 s to 40 s; its time runs from 0 s to 19.9 s",
        ),
        ("5:5.05", "holds 1 sample; at least 2"),
        ("0:10", "1 record of 4 sensors, but 2 records are needed"),
    ] {
        transmode(&["identify", "--window", &window(text)]).refused(expected);
    }
    for (words, expected) in [
        (
            ["--window", &window("10:5")],
            "the window ends at 5 s, which is not after its start at 10 s",
        ),
        (["--window", &window("x:5")], "\"x\" is no time in seconds"),
        (["--window", "a.csv"], "a window is written FILE:START:END"),
        (["--decimate", "0"], "a factor is a whole number, at least 1"),
        (["--decimate", "1.5"], "a factor is a whole number, at least 1"),
        (["--sample-period", "0"], "a sample period is a number of seconds"),
        (["--sample-period", "-1"], "a sample period is a number of seconds"),
    ] {
        let ran = transmode(&[&["identify", &file], &words[..]].concat());
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::BadInput, ""), "{words:?}");
        assert!(ran.err.contains(expected), "{}", ran.err);
    }
    let again = folder.path("./a.csv");
    transmode(&["identify", &file, again.to_str().unwrap()]).refused("is given twice");
    transmode(&["identify", &file, &file]).refused("take two windows of it with --window");
}
