//! Completions, manual pages, and the options that every command has.

use transmode::Exit;

use crate::program::{Folder, shipped, transmode};

#[test]
fn completions_know_every_command() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let ran = transmode(&["completions", shell]);
        assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
        for word in ["identify", "simulate", "monitor", "false-alarms"] {
            assert!(ran.out.contains(word), "{shell}: {word}");
        }
    }
    let ran = transmode(&["completions", "tcsh"]);
    assert_eq!((ran.exit, ran.out.as_str()), (Exit::BadInput, ""));
    assert!(ran.err.contains("invalid value 'tcsh'"), "{}", ran.err);
}

#[test]
fn a_manual_page_for_each_command() {
    let folder = Folder::new();
    let place = folder.path("man");
    let ran = transmode(&["man", "-o", place.to_str().unwrap()]);
    assert_eq!((ran.exit, ran.err.as_str()), (Exit::Fine, ""));
    for (name, word) in [
        ("transmode", "transmode\\-monitor(1)"),
        ("transmode-monitor", "false\\-alarms"),
        ("transmode-simulate", "trainer.toml"),
        ("transmode-identify", "Examples:"),
    ] {
        assert!(ran.out.contains(&format!("{name}.1\n")), "{}", ran.out);
        let page = std::fs::read_to_string(place.join(format!("{name}.1"))).unwrap();
        assert!(page.contains(word), "{word} is missing in\n{page}");
    }
    // Again, over what is there: the same pages.
    let before = std::fs::read(place.join("transmode.1")).unwrap();
    let ran = transmode(&["man", "--quiet", "-o", place.to_str().unwrap()]);
    assert_eq!((ran.exit, ran.out.as_str()), (Exit::Fine, ""));
    assert_eq!(std::fs::read(place.join("transmode.1")).unwrap(), before);
    let missing = folder.path("no/where");
    transmode(&["man", "-o", missing.to_str().unwrap()]).refused("cannot write");
}

#[test]
fn quiet_is_silent_where_the_result_is_in_files() {
    let folder = Folder::new();
    let record = shipped("noise_free_aileron.csv");
    let json = folder.path("fit.json");
    let fit = ["fit", &record, "--input", "beta", "--output", "p"];
    let ran = transmode(&[&fit[..], &["-q", "--json", json.to_str().unwrap()]].concat());
    assert_eq!((ran.exit, ran.out.as_str(), ran.err.as_str()), (Exit::Fine, "", ""));
    assert!(json.exists());
    // A result that is nowhere else is said.
    assert!(!transmode(&[&fit[..], &["--quiet"]].concat()).out.is_empty());
    let ran = transmode(&[&fit[..], &["--quiet", "--json", "-"]].concat());
    assert!(ran.out.starts_with('{'));
    // And so are errors.
    transmode(&["--quiet", "inspect", "no-such.csv"]).refused("cannot read no-such.csv");
}

#[test]
fn colours_where_they_are_asked_for() {
    let escape = '\u{1b}';
    for words in [&["--help"][..], &["fit", "--help"]] {
        assert!(!transmode(words).out.contains(escape));
        let always = [&["--color", "always"], words].concat();
        assert!(transmode(&always).out.contains(escape), "{words:?}");
        assert!(!transmode(&[words, &["--color=never"]].concat()).out.contains(escape));
    }
    let ran = transmode(&["--color=always", "inspect", "no-such.csv"]);
    assert!(ran.err.starts_with(escape) && ran.err.contains("cannot read no-such.csv"));
    let ran = transmode(&["--color", "pink", "inspect", "no-such.csv"]);
    assert_eq!(ran.exit, Exit::BadInput);
    assert!(ran.err.contains("invalid value 'pink'"), "{}", ran.err);
}
