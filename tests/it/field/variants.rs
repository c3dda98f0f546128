//! More files of the same kinds.

use super::*;

#[test]
fn angles_that_wrap_go_on() {
    let folder = Folder::new();
    let rows = |offset: f64| -> String {
        (0..400_usize)
            .map(|k| {
                let heading = (350.0 + 30.0 * (k as f64 / 25.0 + offset).sin()).rem_euclid(360.0);
                format!(
                    "{:.1},{heading:.4},{:.5},{:.5}\n",
                    0.1 * k as f64,
                    scatter(k),
                    scatter(k * 3 + 1)
                )
            })
            .collect()
    };
    let files = [("a.csv", 0.0), ("b.csv", 1.0)]
        .map(|(name, offset)| folder.file(name, format!("time,psi [deg],p,r\n{}", rows(offset))));
    let (_, json) = inspect(&[&files[0]]);
    let verdict = &json["files"][0]["channels"][0]["verdict"];
    assert_eq!(verdict["is"], "wraps");
    assert!((verdict["number"].as_f64().unwrap() - std::f64::consts::TAU).abs() < 1e-12);
    let (_, json) = identify(&files, &["--order", "2"]);
    assert!(warning(&json, "unwrapped").unwrap().contains("psi jumps by a turn"));
    let (_, json) = identify(&files, &["--order", "2", "--unwrap=false"]);
    assert!(warning(&json, "unwrapped").is_none());
}

/// The rows of the complete records, time in s, beta in rad, p and r in rad/s.
fn complete(surface: &str) -> Vec<[f64; 4]> {
    let text = std::fs::read_to_string(field(&format!("04-complete-{surface}.csv"))).unwrap();
    let row = |line: &str| {
        let fields: Vec<f64> = line.split(',').map(|field| field.parse().unwrap()).collect();
        [fields[0], fields[1], fields[2], fields[3]]
    };
    text.lines().skip(1).map(row).collect()
}

/// What a logger makes of these rows.
type Written = fn(&[[f64; 4]]) -> Vec<u8>;

fn lines(header: &str, rows: &[[f64; 4]], row: impl Fn(&[f64; 4]) -> String) -> String {
    let rows: Vec<String> = rows.iter().map(row).collect();
    format!("{header}\n{}\n", rows.join("\n"))
}

fn plain([t, beta, p, r]: &[f64; 4]) -> String {
    format!("{t},{beta},{p},{r}")
}

/// Digits in groups of three.
fn grouped(value: f64) -> String {
    let text = format!("{value:.3}");
    let (whole, decimals) = text.split_once('.').unwrap();
    let (sign, digits) = whole.strip_prefix('-').map_or(("", whole), |digits| ("-", digits));
    let groups: Vec<&str> = digits
        .as_bytes()
        .rchunks(3)
        .rev()
        .map(|group| std::str::from_utf8(group).unwrap())
        .collect();
    format!("\"{sign}{}.{decimals}\"", groups.join(","))
}

#[test]
fn texts_of_other_loggers_give_the_same_modes() {
    let kinds: [(&str, Written, Option<&str>); 11] = [
        (
            "bars between the fields",
            |rows| {
                let row = |row: &[f64; 4]| plain(row).replace(',', "|");
                lines("time|beta|p|r", rows, row).into_bytes()
            },
            None,
        ),
        (
            "UTF-16",
            |rows| {
                let text = lines("time,beta,p,r", rows, plain);
                std::iter::once(0xfeff)
                    .chain(text.encode_utf16())
                    .flat_map(u16::to_le_bytes)
                    .collect()
            },
            None,
        ),
        (
            "degree signs of a code page",
            |rows| {
                let turn = 180.0 / std::f64::consts::PI;
                let row =
                    |[t, beta, p, r]: &[f64; 4]| plain(&[*t, beta * turn, p * turn, r * turn]);
                let text = lines("Time [s],beta [deg],p [?/s],r (?/s)", rows, row);
                text.bytes().map(|byte| if byte == b'?' { 0xb0 } else { byte }).collect()
            },
            None,
        ),
        (
            "the header again and again",
            |rows| {
                let text = lines("time,beta,p,r", rows, plain);
                let again = |(row, line): (usize, &str)| match row % 250 {
                    200 => format!("time,beta,p,r\n{line}\n"),
                    _ => format!("{line}\n"),
                };
                text.lines().enumerate().map(again).collect::<String>().into_bytes()
            },
            None,
        ),
        (
            "digits in groups",
            |rows| {
                let row =
                    |[t, beta, p, r]: &[f64; 4]| format!("{t},{},{p},{r}", grouped(beta * 1e6));
                lines("time,beta,p,r", rows, row).into_bytes()
            },
            None,
        ),
        (
            "exponents of Fortran",
            |rows| {
                let row = |row: &[f64; 4]| {
                    row.map(|value| format!("{value:.9e}").replace('e', "D")).join(" ")
                };
                lines("time beta p r", rows, row).into_bytes()
            },
            None,
        ),
        (
            "days of a spreadsheet",
            |rows| {
                let row = |[t, beta, p, r]: &[f64; 4]| {
                    format!("{:.11},{beta},{p},{r}", 45_989.5 + t / 86_400.0)
                };
                lines("time,beta,p,r", rows, row).into_bytes()
            },
            Some("clock-unit"),
        ),
        (
            "rows that were written twice",
            |rows| {
                let text = lines("time,beta,p,r", rows, plain);
                let twice = |(row, line): (usize, &str)| match row {
                    100 | 400 => format!("{line}\n{line}\n"),
                    _ => format!("{line}\n"),
                };
                text.lines().enumerate().map(twice).collect::<String>().into_bytes()
            },
            Some("rows-repeated"),
        ),
        (
            "a block that was lost with its time",
            |rows| {
                let kept: Vec<[f64; 4]> = rows
                    .iter()
                    .enumerate()
                    .filter(|(index, _)| !(300..325).contains(index))
                    .map(|(index, [t, beta, p, r])| {
                        let late = if index >= 325 { 0.037 } else { 0.0 };
                        [t + late, *beta, *p, *r]
                    })
                    .collect();
                lines("time,beta,p,r", &kept, plain).into_bytes()
            },
            Some("gaps"),
        ),
        (
            "the unit of time in its name",
            |rows| {
                let row = |[t, beta, p, r]: &[f64; 4]| format!("{},{beta},{p},{r}", 1000.0 * t);
                lines("time_ms,beta,p,r", rows, row).into_bytes()
            },
            None,
        ),
        (
            "one sensor in degrees",
            |rows| {
                let turn = 180.0 / std::f64::consts::PI;
                let row = |[t, beta, p, r]: &[f64; 4]| plain(&[*t, beta * turn, *p, r * turn]);
                lines("time,beta (deg),p (rad/s),r (deg/s)", rows, row).into_bytes()
            },
            None,
        ),
    ];
    for (kind, written, code) in kinds {
        let folder = Folder::new();
        let files = ["aileron", "rudder"]
            .map(|surface| folder.file(&format!("{surface}.txt"), written(&complete(surface))));
        let (exit, json) = identify(&files, &["--outputs", "beta,p,r"]);
        assert_eq!(exit, Exit::Fine, "{kind}: {:#}", json["warnings"]);
        has_the_modes(&json);
        match code {
            Some(code) => assert!(warning(&json, code).is_some(), "{kind}: {:#}", json["warnings"]),
            None => assert_eq!(json["warnings"].as_array().unwrap().len(), 0, "{kind}"),
        }
    }
}
