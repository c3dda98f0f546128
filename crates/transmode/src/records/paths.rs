//! Names of channels in files whose variables lie in structures or groups: `log.imu.p`.

/// The channels that are read, each with its name, of those with these paths; `None` for the others.
///
/// With a `variable` those that are it or lie in it, by the names that they have there. Otherwise all, without
/// what all their paths begin with, so that the fields of a single structure are called as they are.
pub(super) fn chosen(paths: &[&str], variable: Option<&str>) -> Vec<Option<String>> {
    if let Some(variable) = variable {
        let variable = variable.replace('/', ".");
        let variable = variable.trim_matches('.');
        let within = |path: &&str| {
            let rest = path.strip_prefix(variable)?;
            match rest.chars().next() {
                None => Some(path.rsplit('.').next().unwrap_or(path).to_owned()),
                Some('.') => Some(rest[1..].to_owned()),
                Some('(') => Some(rest.to_owned()),
                Some(_) => None,
            }
        };
        return paths.iter().map(within).collect();
    }
    let common = common(paths);
    paths.iter().map(|path| Some(path[common..].to_owned())).collect()
}

/// Length of the structures that all paths begin with, their point included.
fn common(paths: &[&str]) -> usize {
    let mut length = 0;
    if let [first, _, ..] = paths {
        while let Some(point) = first[length..].find('.') {
            let end = length + point + 1;
            if !paths.iter().all(|path| path.starts_with(&first[..end])) {
                break;
            }
            length = end;
        }
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_within_a_variable_and_without_what_all_share() {
        let check = |paths: &[&str], variable, expected: &[Option<&str>]| {
            let expected: Vec<_> = expected.iter().map(|name| name.map(str::to_owned)).collect();
            assert_eq!(chosen(paths, variable), expected, "{paths:?} {variable:?}");
        };
        let paths = ["log.time", "log.imu.p", "log.imu.r", "other"];
        check(&paths, Some("log.imu"), &[None, Some("p"), Some("r"), None]);
        check(&paths, Some("/log/imu/p"), &[None, Some("p"), None, None]);
        check(&paths, Some("lo"), &[None; 4]);
        check(&paths, None, &paths.map(Some));
        check(&["log.a.t", "log.a.p"], None, &[Some("t"), Some("p")]);
        check(&["log.a.t", "log.ab.p"], None, &[Some("a.t"), Some("ab.p")]);
        check(&["log(1).p", "log(2).p"], Some("log"), &[Some("(1).p"), Some("(2).p")]);
        check(&["log.p"], None, &[Some("log.p")]);
        check(&[], None, &[]);
    }
}
