//! Whether two SVG pictures show the same: equal text, and coordinates that differ by less than
//! anyone can see.

/// Pixels. Other processors round the last digits of a computation differently, and a coordinate
/// with two decimals may then flip.
const INVISIBLE: f64 = 0.05;

pub(super) fn same(a: &str, b: &str) -> bool {
    let (a, b) = (a.replace("\r\n", "\n"), b.replace("\r\n", "\n"));
    let (a, b) = (pieces(&a), pieces(&b));
    a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| a == b || close(a, b))
}

fn close(a: &str, b: &str) -> bool {
    let numbers = a.parse::<f64>().ok().zip(b.parse::<f64>().ok());
    numbers.is_some_and(|(a, b)| (a - b).abs() < INVISIBLE)
}

/// Runs of characters that a number may consist of, and the runs between them.
fn pieces(text: &str) -> Vec<&str> {
    let is_numeric = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-');
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let numeric = is_numeric(first);
        let end = rest.find(|c| is_numeric(c) != numeric).unwrap_or(rest.len());
        let (piece, tail) = rest.split_at(end);
        pieces.push(piece);
        rest = tail;
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_seen_decides() {
        let circle = |x: &str, label: &str| {
            format!("<circle cx=\"{x}\" cy=\"-3.5\"/>\n<text>{label}</text>")
        };
        assert!(same(&circle("10.25", "p"), &circle("10.26", "p")));
        assert!(same(&circle("10.25", "p"), &circle("10.25", "p").replace('\n', "\r\n")));
        assert!(!same(&circle("10.25", "p"), &circle("10.35", "p")));
        assert!(!same(&circle("10.25", "p"), &circle("10.25", "r")));
        assert!(!same(&circle("10.25", "p"), ""));
    }
}
