use clap::CommandFactory;

use super::*;

/// `identify` of these words, completed from a file with this text.
fn completed(text: &str, words: &[&str]) -> Result<IdentifyArgs, CommandError> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("run.toml");
    std::fs::write(&file, text).unwrap();
    let file = file.to_str().unwrap();
    let words = [&["identify", "--config", file], words].concat();
    let command = IdentifyArgs::augment_args(Command::new("identify"));
    let matches = command.try_get_matches_from(words).unwrap();
    complete(&Given::from_arg_matches(&matches).unwrap())
}

fn refused(text: &str, expected: &str) {
    let message = completed(text, &[]).unwrap_err().to_string();
    assert!(message.contains(expected), "{message}\nshould contain\n{expected}");
}

#[test]
fn the_command_line_wins() {
    let text = "order = 4\nmethod = \"subspace\"\nnoise = [1e-3, 2, 0.5]\ntime = \"clock\"\ntrend = true\n";
    let found = completed(text, &[]).unwrap();
    assert_eq!(found.noise, [1e-3, 2.0, 0.5]);
    assert_eq!(found.trend, Some(true));
    assert_eq!(found.files.time.column.as_deref(), Some("clock"));
    let words = ["--order", "auto", "--noise-record", "q.csv", "--sample-period", "0.1"];
    let found = completed(text, &[&words[..], &["--trend=false"]].concat()).unwrap();
    assert_eq!(found.method().word(), "subspace");
    assert_eq!(found.order, Some(crate::args::values::OrderAsked::Auto));
    assert!(found.noise.is_empty());
    assert_eq!((found.files.time.column, found.files.time.sample_period), (None, Some(0.1)));
    assert_eq!(found.trend, Some(false));
}

#[test]
fn files_start_from_the_folder_of_the_options() {
    let text = "files = [\"a.csv\", \"/b.csv\"]\nwindow = [\"a.csv:1:2\"]\njson = \"-\"\n";
    let found = completed(text, &[]).unwrap();
    assert!(found.files.files[0].is_absolute() && found.files.files[0].ends_with("a.csv"));
    assert_eq!(found.files.files[1], Path::new("/b.csv"));
    assert!(found.files.window[0].file.is_absolute());
    assert_eq!(found.json.as_deref(), Some(Path::new("-")));
    // Records of the command line replace those of the file.
    let found = completed(text, &["c.csv"]).unwrap();
    assert_eq!(found.files.files, [Path::new("c.csv")]);
    assert!(found.files.window.is_empty());
}

/// Whatever the command line can say, the file can.
#[test]
fn every_option_is_known() {
    let command = crate::args::Args::command();
    let identify = command.find_subcommand("identify").unwrap();
    let mut count = 0;
    for long in identify.get_arguments().filter_map(Arg::get_long) {
        if matches!(long, "config" | "help") {
            continue;
        }
        count += 1;
        // A date is no value of any option, but the name must be known.
        let message = completed(&format!("{long} = 1979-05-27\n"), &[]).unwrap_err().to_string();
        assert!(message.contains(&format!("{long} is a date")), "{message}");
    }
    assert!(count >= 18, "{count}");
}

#[test]
fn mistakes_have_a_place() {
    refused(
        "order = 4\nodrer = 5\n",
        "run.toml, line 2, column 1: \"odrer\" is no option; there are",
    );
    refused(
        "order = 4\n  noise = \"-1\"\n",
        "line 2, column 11: noise: a noise level is a positive",
    );
    refused("order = \n", "run.toml, line 1, column 9: ");
    refused("order = 4\norder = 5\n", "line 2, column 1: duplicate key");
    refused("[order]\nn = 4\n", "line 1, column 1: order is a table");
    refused("outputs = []\n", "line 1, column 11: outputs is an empty list; leave it out");
    refused("outputs = [[\"a\"]]\n", "outputs is a list of lists");
    refused("method = \"best\"\n", "method: \"best\" is none of ml, subspace, as-printed");
    refused("trend = 3\n", "trend: \"3\" is none of true, false");
    refused("order = 4.5\n", "order: an order is a whole number, at least 1, or auto");
    refused("band = \"3:2\"\n", "the band is empty");
    refused("time = \"t\"\nsample-period = 1\n", "cannot be used together with");
    refused("aircraft-class = \"III\"\n", "--flight-phase <CATEGORY> is needed as well");
    refused("config = \"other.toml\"\n", "\"config\" is no option");
}
