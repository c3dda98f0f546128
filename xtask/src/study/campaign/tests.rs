use clap::Parser;

use super::*;
use crate::study::noise::NoiseStudy;
use crate::study::simulator::SimulatorStudy;

#[derive(Debug, Parser)]
struct Line {
    #[command(flatten)]
    seeded: SeededExtent,
}

fn parsed(line: &str) -> Result<SeededExtent, clap::Error> {
    let words = std::iter::once("noise").chain(line.split_whitespace());
    Line::try_parse_from(words).map(|line| line.seeded)
}

fn seeds<S: Study>(line: &str) -> u64 {
    let SeededExtent { seeds, extent } = parsed(line).unwrap();
    extent.seeds::<S>(seeds)
}

fn command<S: Study>(line: &str) -> String {
    parsed(line).unwrap().extent.command::<S>(seeds::<S>(line))
}

#[test]
fn the_document_says_what_was_run() {
    let noise = command::<NoiseStudy>;
    assert_eq!(noise(""), "cargo xtask study noise --seeds 200");
    assert_eq!(
        noise("--seeds 50 --threads 1 --update"),
        "cargo xtask study noise --seeds 50 --update"
    );
    assert_eq!(noise("--quick"), "cargo xtask study noise --quick");
    assert_eq!(seeds::<NoiseStudy>(""), 200);
    assert!(seeds::<NoiseStudy>("--quick") < 10);
    assert_eq!(parsed("--threads 3").unwrap().extent.threads(), 3);
}

#[test]
fn given_records_have_no_seeds() {
    let simulator = command::<SimulatorStudy>;
    assert_eq!(simulator(""), "cargo xtask study simulator");
    assert_eq!(simulator("--update"), "cargo xtask study simulator --update");
    assert_eq!(simulator("--quick"), "cargo xtask study simulator --quick");
    assert_eq!((seeds::<SimulatorStudy>(""), seeds::<SimulatorStudy>("--quick")), (1, 1));
}

#[test]
fn a_quick_run_leaves_the_long_one_alone() {
    let file = |line| parsed(line).unwrap().extent.file::<NoiseStudy>();
    assert_eq!((file("").as_str(), file("--quick").as_str()), ("noise.jsonl", "noise-quick.jsonl"));
}

#[test]
fn a_few_seeds_cannot_replace_the_document() {
    assert!(parsed("--quick --update").is_err());
    assert!(parsed("--quick --seeds 7").is_err());
    assert!(parsed("--seeds 0").is_err());
    assert!(parsed("--threads 0").is_err());
}
