use clap::Parser;

use super::*;
use crate::study::noise::NoiseStudy;

#[derive(Debug, Parser)]
struct Line {
    #[command(flatten)]
    extent: Extent,
}

fn parsed(line: &str) -> Result<Extent, clap::Error> {
    let words = std::iter::once("noise").chain(line.split_whitespace());
    Line::try_parse_from(words).map(|line| line.extent)
}

#[test]
fn the_document_says_what_was_run() {
    let command = |line| parsed(line).unwrap().command::<NoiseStudy>();
    assert_eq!(command(""), "cargo xtask study noise --seeds 200");
    assert_eq!(
        command("--seeds 50 --threads 1 --update"),
        "cargo xtask study noise --seeds 50 --update"
    );
    assert_eq!(command("--quick"), "cargo xtask study noise --quick");
    assert_eq!(parsed("").unwrap().seeds::<NoiseStudy>(), 200);
    assert!(parsed("--quick").unwrap().seeds::<NoiseStudy>() < 10);
    assert_eq!(parsed("--threads 3").unwrap().threads(), 3);
}

#[test]
fn a_quick_run_leaves_the_long_one_alone() {
    let file = |line| parsed(line).unwrap().file::<NoiseStudy>();
    assert_eq!((file("").as_str(), file("--quick").as_str()), ("noise.jsonl", "noise-quick.jsonl"));
}

#[test]
fn a_few_seeds_cannot_replace_the_document() {
    assert!(parsed("--quick --update").is_err());
    assert!(parsed("--quick --seeds 7").is_err());
    assert!(parsed("--seeds 0").is_err());
    assert!(parsed("--threads 0").is_err());
}
