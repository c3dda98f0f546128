//! Every option of `transmode identify` with what it cannot take: exit code 2, one sentence that names the option, nothing half-written.

use transmode::Exit;

use crate::flights::{AILERON, Flight, QUIET, RUDDER, table};
use crate::program::{Folder, transmode};

/// Options, and a part of the sentence.
type Case<'a> = (&'a [&'a str], &'a str);

/// Two good flights and what is needed for the cases.
struct Files {
    folder: Folder,
    aileron: String,
    rudder: String,
}

fn files() -> Files {
    let folder = Folder::new();
    let short = |flight: Flight| Flight { samples: 400, ..flight };
    let aileron = folder.file("aileron.csv", short(AILERON).csv());
    let rudder = folder.file("rudder.csv", short(RUDDER).csv());
    Files { folder, aileron, rudder }
}

impl Files {
    /// Expects exit code 2, nothing on standard output, the sentence, and no new file.
    fn refuse(&self, options: &[&str], expected: &str) {
        let before = self.folder.names();
        let json = self.folder.path("modes.json");
        let identify = ["identify", &self.aileron, &self.rudder, "--outputs", "beta,p,r", "--json"];
        let ran = transmode(&[&identify[..], &[json.to_str().unwrap()], options].concat());
        assert_eq!((ran.exit, ran.out.as_str()), (Exit::BadInput, ""), "{options:?}: {expected}");
        assert!(ran.err.starts_with("error: "), "{}", ran.err);
        assert!(ran.err.contains(expected), "{options:?}: {}\nshould contain\n{expected}", ran.err);
        assert_eq!(self.folder.names(), before);
    }
}

#[test]
fn a_sensor_is_the_same_in_all_files() {
    let files = files();
    let headed = |name: &str, beta: &str, flight: Flight| {
        let text = Flight { samples: 400, ..flight }.csv();
        files.folder.file(name, text.replacen("beta", beta, 1))
    };
    let radians = headed("radians.csv", "beta [rad]", RUDDER);
    let metres = headed("metres.csv", "beta [m]", AILERON);
    transmode(&["identify", &radians, &metres, "--outputs", "beta,p,r"])
        .refused("\"beta\" is in m there and in rad in ");
    let ran = transmode(&["identify", &radians, &files.aileron, "--outputs", "beta,p,r"]);
    let expected = format!(
        "warning: {} does not say the unit of beta, and its numbers are taken to be in rad, as {radians} has it",
        files.aileron
    );
    assert_eq!(ran.out.matches(&expected).count(), 1, "{}", ran.out);
}

#[test]
fn a_json_file_is_no_part_of_a_report() {
    let files = files();
    let report = files.folder.path("report");
    let within = report.join("modes.json");
    for json in [&report, &within] {
        let places = ["--json", json.to_str().unwrap(), "--report", report.to_str().unwrap()];
        let words = ["identify", &files.aileron, &files.rudder];
        transmode(&[&words[..], &places].concat())
            .refused("lies in the folder of --report, which is replaced as a whole");
        assert!(!report.exists());
    }
    files.refuse(&["--report", "-"], "cannot write -: a report is a folder of files");
}

#[test]
fn words_that_are_no_value() {
    let files = files();
    let cases: [Case<'_>; 26] = [
        (&["--method", "best"], "invalid value 'best' for '--method <METHOD>'"),
        (&["--order", "0"], "an order is a whole number, at least 1, or auto"),
        (&["--order", "-3"], "an order is a whole number, at least 1, or auto"),
        (&["--order", "2.5"], "an order is a whole number, at least 1, or auto"),
        (&["--order", "many"], "an order is a whole number, at least 1, or auto"),
        (&["--offsets", "-0.1"], "offsets are auto, zero, free, or positive standard deviations"),
        (&["--offsets", "0.1,NaN,0.1"], "offsets are auto, zero, free, or positive"),
        (&["--offsets", "some"], "offsets are auto, zero, free, or positive"),
        (&["--hold", "second-order"], "invalid value 'second-order' for '--hold"),
        (&["--trend=perhaps"], "invalid value 'perhaps' for '--trend"),
        (&["--band", "5"], "a band is written LO:HI, two frequencies in rad/s"),
        (&["--band", "-1:5"], "a band is written LO:HI, two frequencies in rad/s, none negative"),
        (&["--band", "a:5"], "a band is written LO:HI"),
        (&["--band", "5:5"], "the band is empty: it ends at 5 rad/s"),
        (&["--band", "5:1"], "the band is empty: it ends at 1 rad/s"),
        (&["--threads", "0"], "a number of threads is a whole number from 1 to 256"),
        (&["--noise", "-1e-3,1,1"], "a noise level is a positive number"),
        (&["--noise", "0,1,1"], "a noise level is a positive number"),
        (&["--noise", "NaN,1,1"], "a noise level is a positive number"),
        (&["--noise", "1,,1"], "a noise level is a positive number"),
        (&["--noise", "inf,1,1"], "a noise level is a positive number"),
        (&["--noise", "1,1,1", "--noise-record", "quiet.csv"], "cannot be used with"),
        (&["--aircraft-class", "V", "--flight-phase", "B"], "there are I, II-L, II-C, III and IV"),
        (&["--aircraft-class", "IV", "--flight-phase", "D"], "there are A-CO, A, B and C"),
        (&["--aircraft-class", "IV"], "--flight-phase <CATEGORY>"),
        (&["--iir", "0", "--method", "as-printed"], "an order must be at least 1"),
    ];
    for (options, expected) in cases {
        files.refuse(options, expected);
    }
}

#[test]
fn options_that_do_not_fit_the_records() {
    let files = files();
    let cases: [Case<'_>; 16] = [
        (&["--order", "100"], "--order: an order of 100 needs"),
        (
            &["--noise", "0.1,0.2"],
            "--noise has 2 numbers for 3 sensors; give one for each of beta, p, r",
        ),
        (&["--noise", "0.1,0.2,0.3,0.4"], "--noise has 4 numbers for 3 sensors"),
        (&["--offsets", "0.1,0.2"], "--offsets has 2 numbers for 3 sensors"),
        (
            &["--band", "40:50"],
            "--band reaches 40 rad/s, above the Nyquist frequency of 31.4159 rad/s",
        ),
        (&["--band", "31.416:"], "--band reaches 31.416 rad/s"),
        (&["--band", "1:50"], "--band reaches 50 rad/s, above the Nyquist frequency"),
        (&["--band", "1:1.001"], "the frequencies used give"),
        (
            &["--feedthrough", "ny"],
            "--feedthrough names \"ny\", which is none of the sensors beta, p, r",
        ),
        (&["--feedthrough", "p,p"], "--feedthrough names \"p\" twice"),
        (&["--known-input", "damper"], "has no column \"damper\""),
        (
            &["--known-input", "rudder", "--known-input", "rudder"],
            "--inputs names \"rudder\" twice",
        ),
        (&["--known-input", "p"], "--inputs names \"p\" and --outputs, too"),
        (&["--known-input", "time"], "--inputs names \"time\" but it is the column of time"),
        (&["--decimate", "40"], "--decimate 40 needs more than"),
        (&["--window", "aileron.csv:0:1"], "cannot read aileron.csv"),
    ];
    for (options, expected) in cases {
        files.refuse(options, expected);
    }
}

#[test]
fn options_of_another_method() {
    let files = files();
    let of_likelihood: [&[&str]; 4] =
        [&["--trend"], &["--band", "0:5"], &["--offsets", "0.1"], &["--hold", "zero-order"]];
    let of_both: [&[&str]; 7] = [
        &["--order", "4"],
        &["--offsets", "free"],
        &["--feedthrough", "p"],
        &["--noise", "1,1,1"],
        &["--noise-record", "quiet.csv"],
        &["--inputs", "rudder"],
        &["--trend"],
    ];
    let of_printed: [&[&str]; 3] = [&["--iir", "4"], &["--causal", "20"], &["--anticausal", "20"]];
    let name = |options: &[&str]| options[0].to_owned();
    for options in of_likelihood {
        let expected = "belongs to --method ml, not to --method subspace; leave it out";
        files.refuse(&[options, &["--method", "subspace"]].concat(), expected);
        files.refuse(&[options, &["--method", "subspace"]].concat(), &name(options));
    }
    for options in of_both {
        let expected = "not to --method as-printed; leave it out, or choose that method";
        files.refuse(&[options, &["--method", "as-printed"]].concat(), expected);
        files.refuse(&[options, &["--method", "as-printed"]].concat(), &name(options));
    }
    for method in ["ml", "subspace"] {
        for options in of_printed {
            let expected = format!(
                "{} belongs to --method as-printed, not to --method {method}",
                name(options)
            );
            files.refuse(&[options, &["--method", method]].concat(), &expected);
        }
    }
}

#[test]
fn noise_records_that_are_none() {
    let files = files();
    let folder = &files.folder;
    let quiet = Flight { samples: 400, ..QUIET };
    let slow = folder.file("slow.csv", Flight { period_s: 0.2, ..quiet }.csv());
    let short = folder.file("short.csv", Flight { samples: 20, ..quiet }.csv());
    let [time, beta, p, ..] = quiet.columns();
    let none = vec![0.0; 400];
    let lacking =
        folder.file("lacking.csv", table("time,beta,p", &[time.clone(), beta.clone(), p.clone()]));
    let dead =
        folder.file("dead.csv", table("time,beta,p,r", &[time.clone(), beta, p, none.clone()]));
    let silent = folder
        .file("silent.csv", table("time,beta,p,r", &[time, none.clone(), none.clone(), none]));
    let own = format!("{}:0:20", files.aileron);
    let backwards = format!("{slow}:20:0");
    let cases: [(&str, &str); 9] = [
        (&slow, "--noise-record: record \"slow.csv\" is sampled every 0.2 s"),
        (&short, "--noise-record: short.csv has 20 samples, at least 50 are needed"),
        (&lacking, "lacking.csv has no column \"r\""),
        (&dead, "--noise-record: record \"dead.csv\": channel \"r\" is constant"),
        (&silent, "--noise-record: record \"silent.csv\" is zero throughout"),
        (
            &files.aileron,
            "--noise-record: aileron.csv overlaps with the record aileron.csv; nobody",
        ),
        (&own, "--noise-record: aileron.csv:0:20 overlaps with the record aileron.csv"),
        ("no-such-file.csv", "cannot read no-such-file.csv"),
        (&backwards, "cannot read"),
    ];
    for (file, expected) in cases {
        files.refuse(&["--noise-record", file], expected);
    }
}

#[test]
fn known_inputs_that_say_nothing() {
    let files = files();
    // The rudder rests in one flight, the bias never moves.
    let mut columns = Flight { samples: 400, ..AILERON }.columns().to_vec();
    columns.push(vec![0.25; 400]);
    let header = "time,beta,p,r,aileron,rudder,bias";
    let biased = files.folder.file("biased.csv", table(header, &columns));
    let again = files.folder.file("again.csv", table(header, &columns));
    let identify = ["identify", &biased, &again, "--outputs", "beta,p,r", "--known-input"];
    for (input, value) in [("bias", "0.25"), ("rudder", "0")] {
        transmode(&[&identify[..], &[input]].concat()).refused(&format!(
            "--inputs: {input} is constant in biased.csv, {value} throughout, and tells nothing; leave it out"
        ));
    }
    let all = ["identify", &biased, &again, "--known-input", "beta", "--known-input", "p"];
    let rest = [
        "--known-input",
        "r",
        "--known-input",
        "aileron",
        "--known-input",
        "rudder",
        "--known-input",
        "bias",
    ];
    transmode(&[&all[..], &rest].concat()).refused("and leaves no column for the sensors");
}

#[test]
fn files_of_options_that_cannot_be() {
    let files = files();
    let cases = [
        ("odrer = 4\n", "run.toml, line 1, column 1: \"odrer\" is no option; there are"),
        (
            "order = 4\nnoise = [0.1, \"x\", 0.1]\n",
            "run.toml, line 2, column 9: noise: a noise level",
        ),
        ("order = true\n", "run.toml, line 1, column 9: order: an order is a whole number"),
        ("order = [1, 2\n", "run.toml, line"),
        ("order = 4\norder = 4\n", "run.toml, line 2, column 1: duplicate key"),
        ("[identify]\norder = 4\n", "\"identify\" is no option"),
        ("iir = 4\n", "--iir belongs to --method as-printed, not to --method ml"),
        ("noise = [1.0, 1.0]\n", "--noise has 2 numbers for 3 sensors"),
        ("trend = \"no\"\n", "trend: \"no\" is none of true, false"),
        ("order = 1979-05-27\n", "order is a date; a text, a number"),
    ];
    for (text, expected) in cases {
        let file = files.folder.file("run.toml", text);
        files.refuse(&["--config", &file], expected);
    }
    files.refuse(&["--config", "no-such-file.toml"], "cannot read no-such-file.toml");
    let binary = files.folder.file("run.toml", b"order = \xff\n");
    files.refuse(&["--config", &binary], "it is no text in UTF-8; --config takes a TOML file");
    // The file of options is not replaced by the result either.
    let file = files.folder.file("run.toml", "order = 4\n");
    let words = ["identify", &files.aileron, &files.rudder, "--config", &file, "--json", &file];
    transmode(&words).refused("is the record itself");
}

#[test]
fn nothing_to_read() {
    transmode(&["identify"]).refused("no record is given; name files, or stretches");
    transmode(&["identify", "--outputs", "beta,p,r"]).refused("no record is given");
}
