//! One statement of the paper, beside what we compute and an independent reference value.

use num_complex::Complex;
use serde::Serialize;
use serde_json::{Value, json};

/// How a check came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Verdict {
    /// Computed value, reference and print agree.
    Match,
    /// Computed value and reference agree, and the print is one of the known slips.
    Erratum,
    /// Anything else: our computation is wrong, or the print has a slip that nobody has looked at.
    Differs,
}

impl Verdict {
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Match => "match",
            Self::Erratum => "erratum",
            Self::Differs => "differs",
        }
    }
}

/// Whether the paper's print is expected to be right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Print {
    /// The printed digits must agree with the computed value.
    Right,
    /// The print is listed in docs/errata.md, so it must *not* agree.
    Slip,
}

/// One row of results.json.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Check {
    pub(crate) id: &'static str,
    /// What the paper prints.
    pub(crate) paper: Value,
    /// What this run computed.
    pub(crate) computed: Value,
    /// The value from tests/data/reference.json or from arithmetic by hand.
    pub(crate) reference: Value,
    /// Largest distance between computed value and reference.
    pub(crate) error: f64,
    /// The largest error that passes.
    pub(crate) tolerance: f64,
    pub(crate) verdict: Verdict,
    pub(crate) note: String,
    /// Computed value and print as a person writes them.
    #[serde(skip)]
    pub(crate) shown: Shown,
}

/// The texts of a check for tables.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shown {
    pub(crate) paper: String,
    pub(crate) computed: String,
}

impl Check {
    /// A check of exact text: a polynomial over the integers, an integer, a statement.
    pub(crate) fn exact(
        id: &'static str,
        print: Print,
        paper: &str,
        computed: &str,
        reference: &str,
        note: &str,
    ) -> Self {
        let error = if computed == reference { 0.0 } else { 1.0 };
        Self {
            id,
            paper: json!(paper),
            computed: json!(computed),
            reference: json!(reference),
            error,
            tolerance: 0.0,
            verdict: verdict(error, 0.0, paper == computed, print),
            note: note.to_owned(),
            shown: Shown { paper: paper.to_owned(), computed: computed.to_owned() },
        }
    }

    /// A check of exact text that the paper does not print.
    pub(crate) fn stated(id: &'static str, computed: &str, reference: &str, note: &str) -> Self {
        Self::exact(id, Print::Right, computed, computed, reference, note)
            .without_print("(not printed)")
    }

    /// A check of numbers that the paper prints with a few decimals, compared one by one.
    pub(crate) fn numbers(
        id: &'static str,
        print: Print,
        paper: &[&str],
        computed: &[f64],
        reference: &[f64],
        tolerance: f64,
        note: &str,
    ) -> Self {
        let agrees = paper.len() == computed.len()
            && paper
                .iter()
                .zip(computed)
                .all(|(printed, &value)| agrees_with_print(printed, value));
        let error = largest(computed.iter().zip(reference).map(|(a, b)| (a - b).abs()))
            + length_penalty(computed.len(), reference.len());
        let rounded =
            paper.iter().zip(computed).map(|(printed, value)| fixed(*value, decimals(printed)));
        Self {
            id,
            paper: json!(paper),
            computed: json!(computed),
            reference: json!(reference),
            error,
            tolerance,
            verdict: verdict(error, tolerance, agrees, print),
            note: note.to_owned(),
            shown: Shown {
                paper: paper.join(", "),
                computed: rounded.collect::<Vec<_>>().join(", "),
            },
        }
    }

    /// A check of numbers that the paper does not print: computed value against reference alone.
    pub(crate) fn computed(
        id: &'static str,
        computed: &[f64],
        reference: &[f64],
        tolerance: f64,
        note: &str,
    ) -> Self {
        let mut check = Self::numbers(id, Print::Right, &[], computed, reference, tolerance, note);
        check.shown.computed = entries(computed);
        check.without_print("(not printed)")
    }

    /// A check of a multiset of complex numbers that the paper does not print.
    pub(crate) fn computed_roots(
        id: &'static str,
        computed: &[Complex<f64>],
        reference: &[Complex<f64>],
        tolerance: f64,
        note: &str,
    ) -> Self {
        let check = Self::roots(id, Print::Right, &[], computed, reference, tolerance, note);
        check.without_print("(a figure)")
    }

    /// A check of a multiset of complex numbers. The print gives real and imaginary parts,
    /// conjugates once with a positive imaginary part.
    pub(crate) fn roots(
        id: &'static str,
        print: Print,
        paper: &[(&str, &str)],
        computed: &[Complex<f64>],
        reference: &[Complex<f64>],
        tolerance: f64,
        note: &str,
    ) -> Self {
        let upper: Vec<Complex<f64>> =
            computed.iter().copied().filter(|root| root.im >= 0.0).collect();
        // Each printed root beside the computed one nearest to it; what is left over has no print.
        let mut left = upper.clone();
        let partners: Vec<_> =
            paper.iter().map(|printed| take_nearest(&mut left, printed)).collect();
        let agrees = left.is_empty()
            && paper.iter().zip(&partners).all(|((re, im), partner)| {
                partner.is_some_and(|root| {
                    agrees_with_print(re, root.re) && agrees_with_print(im, root.im)
                })
            });
        let error = multiset_distance(computed, reference);
        let pairs =
            |values: &[Complex<f64>]| values.iter().map(|z| [z.re, z.im]).collect::<Vec<_>>();
        let shown_paper = paper.iter().map(|(re, im)| complex_text(re, im)).collect::<Vec<_>>();
        let as_printed = paper.iter().zip(&partners).filter_map(|((re, im), partner)| {
            partner.map(|root| {
                complex_text(&fixed(root.re, decimals(re)), &fixed(root.im, decimals(im)))
            })
        });
        let unprinted =
            left.iter().map(|root| complex_text(&fixed(root.re, 6), &fixed(root.im, 6)));
        let shown_computed: Vec<_> = as_printed.chain(unprinted).collect();
        Self {
            id,
            paper: json!(shown_paper),
            computed: json!(pairs(computed)),
            reference: json!(pairs(reference)),
            error,
            tolerance,
            verdict: verdict(error, tolerance, agrees, print),
            note: note.to_owned(),
            shown: Shown { paper: shown_paper.join(", "), computed: shown_computed.join(", ") },
        }
    }

    /// Judges by the reference alone.
    fn without_print(mut self, instead: &str) -> Self {
        self.paper = Value::Null;
        self.verdict = verdict(self.error, self.tolerance, true, Print::Right);
        instead.clone_into(&mut self.shown.paper);
        self
    }
}

/// Takes the root nearest to the printed one out of the list.
fn take_nearest(roots: &mut Vec<Complex<f64>>, (re, im): &(&str, &str)) -> Option<Complex<f64>> {
    let printed = Complex::new(re.parse().ok()?, im.parse().ok()?);
    let distance = |root: &Complex<f64>| (root - printed).norm();
    let nearest =
        (0..roots.len()).min_by(|&a, &b| distance(&roots[a]).total_cmp(&distance(&roots[b])))?;
    Some(roots.swap_remove(nearest))
}

fn verdict(error: f64, tolerance: f64, agrees_with_print: bool, print: Print) -> Verdict {
    // A NaN error fails this comparison, as it must.
    let correct = error <= tolerance;
    match (correct, agrees_with_print, print) {
        (true, true, Print::Right) => Verdict::Match,
        (true, false, Print::Slip) => Verdict::Erratum,
        _ => Verdict::Differs,
    }
}

/// True where `value`, rounded to as many decimals as the print has, is the print.
fn agrees_with_print(printed: &str, value: f64) -> bool {
    let Ok(number) = printed.parse::<f64>() else {
        return false;
    };
    let unit = 10f64.powi(-i32::try_from(decimals(printed)).unwrap_or(i32::MAX));
    // Half a unit of the last printed digit; the tiny surplus is for a value that lies on the edge
    // in decimal but not in binary.
    (value - number).abs() <= 0.5 * unit * (1.0 + 1e-9)
}

fn decimals(printed: &str) -> usize {
    printed.split_once('.').map_or(0, |(_, fraction)| fraction.len())
}

/// `value` with so many decimals and never a negative zero.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let is_zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    if is_zero { text.trim_start_matches('-').to_owned() } else { text }
}

fn complex_text(re: &str, im: &str) -> String {
    if im.parse::<f64>() == Ok(0.0) { re.to_owned() } else { format!("{re} ± j{im}") }
}

/// A few numbers in full; of a whole matrix only how many agree.
fn entries(values: &[f64]) -> String {
    const FEW: usize = 4;
    if values.len() > FEW {
        return format!("{} entries", values.len());
    }
    values.iter().map(|value| fixed(*value, 4)).collect::<Vec<_>>().join(", ")
}

/// Largest distance after pairing each computed root with its nearest reference root, each used
/// once.
pub(crate) fn multiset_distance(computed: &[Complex<f64>], reference: &[Complex<f64>]) -> f64 {
    let mut left = reference.to_vec();
    let mut worst = length_penalty(computed.len(), reference.len());
    for root in computed {
        let nearest = left
            .iter()
            .enumerate()
            .min_by(|(_, a), (_, b)| (*a - root).norm().total_cmp(&(*b - root).norm()))
            .map(|(index, _)| index);
        if let Some(index) = nearest {
            worst = worst.max((left.swap_remove(index) - root).norm());
        }
    }
    worst
}

fn length_penalty(found: usize, expected: usize) -> f64 {
    if found == expected { 0.0 } else { f64::INFINITY }
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |worst, value| if value > worst || value.is_nan() { value } else { worst })
}

#[cfg(test)]
mod tests;
