use super::*;

#[test]
fn the_words_choose_and_else_the_terminal() {
    let of = |words: &[&str], out: bool| {
        let words: Vec<OsString> = words.iter().map(Into::into).collect();
        Colors::of(&words, Terminals { out, err: false })
    };
    let (plain, all) = (Colors { out: false, err: false }, Colors { out: true, err: true });
    assert_eq!(of(&["transmode"], false), plain);
    assert_eq!(of(&["transmode"], true), Colors { out: true, err: false });
    assert_eq!(of(&["transmode", "--color", "never"], true), plain);
    assert_eq!(of(&["transmode", "fit", "--color=always"], false), all);
    assert_eq!(of(&["transmode", "--color=always", "--color", "auto"], false), plain);
    assert_eq!(of(&["transmode", "--color"], false), plain);
    assert_eq!(of(&["transmode", "--color=pink"], false), plain);
    assert_eq!(of(&["transmode", "--", "--color=always"], false), plain);
    assert_eq!(plain.label("error:"), "error:");
    assert!(all.label("error:").starts_with('\u{1b}'));
}
