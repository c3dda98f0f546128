use super::*;

fn source(text: &str) -> Source {
    Source { path: "crates/lti/src/a.rs".into(), text: text.replace("EQ", MARK) }
}

const TABLE: &str =
    "| equation | item | file |\n|---|---|---|\n| (5) | `numerator` | `crates/lti/src/a.rs` |\n";

#[test]
fn agreement_is_silent() {
    let code =
        source("/// The numerator, EQ5).\n#[must_use]\npub(crate) const fn numerator<T>() {}\n");
    assert_eq!(disagreements(TABLE, &[code]), Vec::<String>::new());
}

#[test]
fn each_kind_of_disagreement_is_told() {
    let check = |table: &str, code: &str, expected: &str| {
        let faults = disagreements(table, &[source(code)]);
        assert_eq!(faults.len(), 1, "{faults:?}");
        assert!(faults[0].contains(expected), "{faults:?}");
    };
    check(TABLE, "fn numerator() {}", "no doc comment names it");
    check("", "/// EQ5)\nfn numerator() {}", "missing in docs/equations.md");
    check(TABLE, "/// EQ5)\nfn other() {}", "docs/equations.md says");
    check(TABLE, "/// EQ5)\nfn numerator() {}\n/// EQ5)\nfn numerator() {}", "more than once");
}

#[test]
fn finds_items_fields_and_modules() {
    let check = |text: &str, expected: &str| {
        let marks = marks(&source(text));
        assert_eq!(marks.len(), 1);
        assert_eq!(marks[0].1.item, expected);
    };
    check("//! EQ7)\nfn a() {}", "module");
    check("/// EQ7)\npub struct StateSpace<T> {", "StateSpace");

    check("struct S {\n    /// EQ7)\n    pub(crate) feedthrough: f64,\n", "feedthrough");
    check("/// EQ7)\n/// more\nfn b(x: i32) {}", "b");
}
