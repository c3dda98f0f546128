//! Words that a shell would take apart are quoted.

use super::as_typed;

#[test]
fn words_come_back_from_a_shell() {
    let typed = |words: &[&str]| as_typed(&words.iter().map(Into::into).collect::<Vec<_>>());
    assert_eq!(typed(&["/bin/transmode", "identify", "a.csv"]), "transmode identify a.csv");
    let words = ["", "identify", "two words.csv", "it's.csv", "--outputs", "$p,r"];
    let split = shlex::split(&typed(&words)).expect("a shell takes it");
    assert_eq!(split[1..], words[1..]);
}
