use super::*;

fn parse(text: &str) -> Result<Header, String> {
    Header::parse(text).map_err(|error| error.to_string())
}

#[test]
fn reads_what_numpy_writes() {
    let header = |descr: &str, layout, shape: &[u64]| {
        Ok(Header { descr: Descr::Number(descr.to_owned()), layout, shape: shape.to_vec() })
    };
    use Layout::{ChannelByChannel, SampleBySample};
    assert_eq!(
        parse("{'descr': '<f8', 'fortran_order': False, 'shape': (2000, 3), }            \n"),
        header("<f8", SampleBySample, &[2000, 3])
    );
    // Python 2 marked long integers, other writers order and space entries as they like.
    assert_eq!(
        parse("{\"shape\":(2L,3L),\"fortran_order\":True,\"descr\":\">f4\"}"),
        header(">f4", ChannelByChannel, &[2, 3])
    );
    let entries =
        |shape: &str| format!("{{'descr': '|b1', 'fortran_order': False, 'shape': {shape}}}");
    assert_eq!(parse(&entries("()")), header("|b1", SampleBySample, &[]));
    assert_eq!(parse(&entries("(7,)")), header("|b1", SampleBySample, &[7]));
}

#[test]
fn says_what_is_damaged() {
    let check = |text: &str, expected: &str| {
        let error = parse(text).unwrap_err();
        assert!(error.contains(expected), "{text}: {error}");
    };
    let whole = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)}";
    for end in 0..whole.len() {
        assert!(parse(&whole[..end]).is_err(), "{}", &whole[..end]);
    }
    check("", "no dictionary");
    check("[1, 2]", "no dictionary");
    check("{'descr': '<f8', 'shape': (2, 3)}", "is missing");
    check(&whole.replace("False", "0"), "neither True nor False");
    check(&whole.replace("(2, 3)", "(-2, 3)"), "something else than sizes");
    check(&whole.replace("(2, 3)", "(2, , 3)"), "something else than sizes");
    check(&whole.replace("(2, 3)", "(99999999999999999999, 3)"), "something else than sizes");
    check(&whole.replace("(2, 3)", "((2, 3))"), "something else than sizes");
    check(&whole.replace("(2, 3)", "2"), "no dictionary");
    check(&whole.replace("'<f8'", "8"), "a text in quotes is missing");
    check(&whole.replace("'<f8'", "'<f8"), "no dictionary");
    check("{'descr': '<f8", "a quote never ends");
    check(&whole.replace("'<f8'", "[('a', [('b', '<f8')])]"), "structured");
    check(&whole.replace("shape", "size"), "neither descr nor fortran_order nor shape");
    check(&whole.replace("}", ", 'descr': '<f4'}"), "there twice");
    check(&format!("{whole} {{"), "something follows");
}

#[test]
fn fields_of_structures() {
    let text = "{'descr': [('t', '<f8'), ('xyz', '<f4', (3,)), (('title', 'n'), '|u1')], 'fortran_order': False, 'shape': (7,)}";
    let Ok(Header { descr: Descr::Structure(fields), .. }) = Header::parse(text) else {
        panic!("no structure");
    };
    let found: Vec<_> =
        fields.iter().map(|f| (f.name.as_str(), f.descr.as_str(), f.count)).collect();
    assert_eq!(found, [("t", "<f8", 1), ("xyz", "<f4", 3), ("n", "|u1", 1)]);
    for wrong in ["[('t',)]", "[('t', '<f8')", "[('a', [('b', '<f8')])]", "[(t, '<f8')]"] {
        let text =
            text.replace("[('t', '<f8'), ('xyz', '<f4', (3,)), (('title', 'n'), '|u1')]", wrong);
        assert!(Header::parse(&text).is_err(), "{wrong}");
    }
}
