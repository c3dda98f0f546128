use super::Span::{Code, Strong, Text};
use super::*;

#[test]
fn marks_need_their_partner() {
    let check = |text, expected: &[Span<'_>]| assert_eq!(spans(text), expected, "{text}");
    check("", &[]);
    check("plain φ", &[Text("plain φ")]);
    check("run `cargo` now", &[Text("run "), Code("cargo"), Text(" now")]);
    check("**chi²** = 1.00", &[Strong("chi²"), Text(" = 1.00")]);
    check("`**`", &[Code("**")]);
    check("2 * 3 * 4", &[Text("2 * 3 * 4")]);
    check("2 ** 3", &[Text("2 ** 3")]);
    check("a ` b", &[Text("a ` b")]);
    check("``", &[Text("``")]);
    check("****", &[Text("****")]);
    check("δ**β**δ`ψ`", &[Text("δ"), Strong("β"), Text("δ"), Code("ψ")]);
}
