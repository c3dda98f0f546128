use clap::Parser;

use super::*;

#[derive(Debug, Parser)]
struct Line {
    #[command(flatten)]
    args: Args,
}

fn parsed(line: &str) -> Result<Args, clap::Error> {
    Line::try_parse_from(std::iter::once("bench").chain(line.split_whitespace()))
        .map(|line| line.args)
}

#[test]
fn the_document_says_what_was_typed() {
    for line in ["", "--peers", "--peers --long --update", "--long --only growth"] {
        let expected = format!("cargo xtask bench {line}");
        assert_eq!(command(&parsed(line).unwrap()), expected.trim());
    }
}

#[test]
fn a_part_of_the_groups_cannot_replace_the_document() {
    assert!(parsed("--only speed --update").is_err());
    assert!(parsed("--stream x --peers").is_err());
}

#[test]
fn groups_have_names() {
    assert_eq!(chosen_groups(None).unwrap().len(), GROUPS.len());
    assert_eq!(chosen_groups(Some("limit")).unwrap()[0].0, "limit");
    assert!(matches!(chosen_groups(Some("x")), Err(TaskError::NoSuchPart { .. })));
}
