//! How the order used compares with others, in words.

use reconstruct::ComparedOrder;
use report::format_significant;

/// `e^57 times as likely as 3, e^9.1 times as likely as 5`; empty where no other was fitted.
pub(crate) fn ratios(compared: &[ComparedOrder]) -> String {
    let ratio = |other: &ComparedOrder| {
        // The criterion is minus twice a logarithm.
        let exponent = format_significant(other.above / 2.0, 2);
        format!("e^{exponent} times as likely as {}", other.order)
    };
    compared.iter().map(ratio).collect::<Vec<_>>().join(", ")
}
