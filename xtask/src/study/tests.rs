use clap::Parser;

use super::*;

#[derive(Debug, Parser)]
struct Line {
    #[command(flatten)]
    args: Args,
}

fn parsed(line: &str) -> Result<NoiseArgs, clap::Error> {
    let words = std::iter::once("study").chain(line.split_whitespace());
    Line::try_parse_from(words).map(|line| {
        let Study::Noise(args) = line.args.study;
        args
    })
}

#[test]
fn the_document_says_what_was_run() {
    let command = |line| parsed(line).unwrap().command();
    assert_eq!(command("noise"), "cargo xtask study noise --seeds 200");
    assert_eq!(
        command("noise --seeds 50 --threads 1 --update"),
        "cargo xtask study noise --seeds 50 --update"
    );
    assert_eq!(command("noise --quick"), "cargo xtask study noise --quick");
    assert_eq!(parsed("noise").unwrap().seeds(), 200);
    assert!(parsed("noise --quick").unwrap().seeds() < 10);
    assert_eq!(parsed("noise --threads 3").unwrap().threads(), 3);
}

#[test]
fn a_few_seeds_cannot_replace_the_document() {
    assert!(parsed("noise --quick --update").is_err());
    assert!(parsed("noise --quick --seeds 7").is_err());
    assert!(parsed("noise --seeds 0").is_err());
    assert!(parsed("noise --threads 0").is_err());
}
