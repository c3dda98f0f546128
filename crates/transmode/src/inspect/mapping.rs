//! Which columns look like the sensors of lateral motion, by their usual names.

/// Sideslip, roll rate, yaw rate: what they are called, in lower case without anything but letters.
const USUAL: [(&str, &[&str]); 3] = [
    (
        "sideslip",
        &[
            "beta",
            "sideslip",
            "sideslipangle",
            "angleofsideslip",
            "aos",
            "ss",
            "betadeg",
            "betarad",
        ],
    ),
    ("roll rate", &["p", "rollrate", "rolldot", "gyrox", "prate", "pdeg", "pb", "wx", "omegax"]),
    ("yaw rate", &["r", "yawrate", "yawdot", "gyroz", "rrate", "rdeg", "rb", "wz", "omegaz"]),
];

/// The columns that look like sideslip, roll rate and yaw rate, or what no column looks like.
pub(super) fn lateral<'a>(names: &[&'a str]) -> Result<[&'a str; 3], Vec<&'static str>> {
    let plain = |name: &str| {
        let letters = name.chars().filter(|c| c.is_alphanumeric());
        letters.flat_map(char::to_lowercase).collect::<String>()
    };
    let find = |usual: &[&str]| {
        // The first spelling that is there, so that `beta` goes before `ss`.
        usual.iter().find_map(|usual| names.iter().find(|name| plain(name) == *usual)).copied()
    };
    let found = USUAL.map(|(_, usual)| find(usual));
    match found {
        [Some(beta), Some(p), Some(r)] => Ok([beta, p, r]),
        _ => Err(USUAL
            .iter()
            .zip(found)
            .filter(|(_, found)| found.is_none())
            .map(|((what, _), _)| *what)
            .collect()),
    }
}

/// A word for a shell.
pub(super) fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./,:=+@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}

#[cfg(test)]
mod tests;
