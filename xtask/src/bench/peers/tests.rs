use super::*;

fn measured(seconds: &[f64], theta: &[f64], warning: i64) -> Answer {
    let timing = Timing::new(seconds.to_vec()).unwrap();
    Answer::Measured { timing, theta: theta.to_vec(), warning }
}

#[test]
fn what_the_script_prints_is_read() {
    for (text, answer) in [
        (
            r#"{"seconds": [0.5, 0.25], "theta": [1.0, -2e-3]}"#,
            measured(&[0.25, 0.5], &[1.0, -2e-3], 0),
        ),
        (r#"{"seconds": [2], "warning": 2}"#, measured(&[2.0], &[], 2)),
        // Libraries may print something of their own first.
        ("hello\n{\"seconds\": [1.0]}\n\n", measured(&[1.0], &[], 0)),
        (
            r#"{"unavailable": "ImportError: No module named 'ctrlsys'"}"#,
            Answer::Unavailable("ImportError: No module named 'ctrlsys'".to_owned()),
        ),
    ] {
        assert_eq!(judge(text.to_owned()), answer, "{text}");
    }
}

#[test]
fn what_is_no_answer_is_no_measurement() {
    for text in [
        "",
        "Killed",
        "{}",
        r#"{"seconds": []}"#,
        r#"{"seconds": ["fast"]}"#,
        r#"{"versions": {}}"#,
    ] {
        assert!(matches!(judge(text.to_owned()), Answer::Unavailable(_)), "{text}");
    }
}

#[test]
fn versions_keep_their_names() {
    let Ok(Line::Versions { versions }) =
        parse(r#"{"versions": {"numpy": "2.0", "scipy": "1.0"}}"#)
    else {
        panic!("these are versions");
    };
    assert_eq!(versions.len(), 2);
    assert_eq!(versions["numpy"], "2.0");
}

#[test]
fn without_peers_each_row_says_why() {
    let answer = Peers::not_asked().run(&["lstsq"]);
    assert_eq!(answer, Answer::Unavailable("not asked for (`--peers`)".to_owned()));
    assert_eq!(answer.timing(), None);
}

#[test]
fn a_missing_program_is_a_reason() {
    let reason = finished(&mut Command::new("no-such-program-anywhere")).unwrap_err();
    assert!(reason.starts_with("no-such-program-anywhere: "), "{reason}");
}
