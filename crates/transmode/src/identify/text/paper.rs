//! What the paper's method says of its own on the terminal.

use reconstruct::paper;
use report::{format_conjugate_pair, format_significant};

/// What the modes rest on, in a line or two.
pub(super) fn summary(result: &paper::Solution) -> String {
    let worst_residual =
        result.identifications.iter().map(|found| found.fit.relative_residual).fold(0.0, f64::max);
    let fits = || result.identifications.iter().map(|found| &found.fit);
    let rank = fits().map(|fit| fit.rank).min().unwrap_or(0);
    let parameters = fits().map(|fit| fit.model.structure().parameter_count()).max().unwrap_or(0);
    let condition = fits().map(|fit| fit.condition).fold(0.0, f64::max);
    let mut text = format!(
        "fits: rank {rank} of {parameters}, condition number up to {}, relative residual up to {}\n\
         zeros: {} shared by {} differences",
        format_significant(condition, 2),
        format_significant(worst_residual, 2),
        result.shared.zeros.len(),
        result.differences.len(),
    );
    if !result.shared.zeros.is_empty() {
        text +=
            &format!(", largest spread {}", format_significant(result.shared.largest_spread(), 2));
    }
    if let Some(refused) = result.shared.closest_refused {
        text += &format!(", smallest spread refused {}", format_significant(refused, 2));
    }
    for zero in result.unobservable_zeros.iter().filter(|zero| zero.im >= 0.0) {
        let place = format_conjugate_pair(zero.re, zero.im, 6);
        text += &format!(
            "\nz = {place} is no mode: there the pseudo input reads nothing in any record"
        );
    }
    text
}
