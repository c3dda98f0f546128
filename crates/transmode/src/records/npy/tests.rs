use super::*;

/// A version 1.0 file as far as the header.
fn file(text: &str) -> Vec<u8> {
    let size = u16::try_from(text.len()).unwrap();
    [NPY_MAGIC, &[1, 0], &size.to_le_bytes(), text.as_bytes()].concat()
}

fn check(bytes: &[u8], length: u64, expected: &str) {
    match placement(&mut &bytes[..], length) {
        Err(NpyError::Format(error)) => {
            assert!(error.to_string().contains(expected), "{error}");
        }
        other => panic!("{other:?}"),
    }
}

fn entries(descr: &str, shape: &str) -> String {
    format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}\n")
}

#[test]
fn numbers_lie_behind_the_header() {
    // The first 128 bytes of numpy.save("x.npy", numpy.zeros((5, 3))) by numpy 2.2.
    let text = format!("{:117}\n", "{'descr': '<f8', 'fortran_order': False, 'shape': (5, 3), }");
    let bytes = file(&text);
    assert_eq!(bytes.len(), 128);
    let eight = Number { width: Width::Eight, byte_order: ByteOrder::Little };
    let found = placement(&mut &bytes[..], 128 + 120).unwrap();
    assert_eq!(found, Placement::new(128, [5, 3], Layout::SampleBySample, eight, 248).unwrap());
    // Versions 2.0 and 3.0 have four bytes for the header's size.
    let size = u32::try_from(text.len()).unwrap().to_le_bytes();
    for version in [2, 3] {
        let bytes = [NPY_MAGIC, &[version, 0], &size, text.as_bytes()].concat();
        let found = placement(&mut &bytes[..], 130 + 120).unwrap();
        assert_eq!(found.offset(), 130);
    }
}

#[test]
fn refuses_what_is_no_such_array() {
    check(b"", 0, "no samples");
    check(b"time,beta\n", 10, "does not start as an NPY file");
    check(&NPY_MAGIC[..3], 3, "does not start as an NPY file");
    check(NPY_MAGIC, 6, "ends within its NPY header");
    check(&[NPY_MAGIC, &[1, 0, 9]].concat(), 9, "ends within its NPY header");
    check(&[NPY_MAGIC, &[4, 0, 0, 0]].concat(), 10, "version 4.0");
    check(&[NPY_MAGIC, &[2, 0, 255, 255, 255, 255]].concat(), 12, "4294967295 bytes long");
    check(&[NPY_MAGIC, &[1, 0, 2, 0, 0xff, 0xfe]].concat(), 12, "it is not text");
    let whole = file(&entries("<f8", "(5, 3)"));
    check(&whole[..40], 40, "ends within its NPY header");
    for descr in ["<i4", "<f2", "<c16", "|O", "=f8", ""] {
        check(&file(&entries(descr, "(5, 3)")), 200, &format!("of type {descr:?}; floats of"));
    }
    check(&file(&entries("<f8", "()")), 200, "shape (); two dimensions");
    check(&file(&entries("<f8", "(15,)")), 200, "shape (15,); two dimensions");
    check(&file(&entries("<f8", "(5, 3, 1)")), 200, "shape (5, 3, 1); two dimensions");
    check(&file(&entries("<f8", "(0, 3)")), 200, "no samples");
    check(&file(&entries("<f8", "(5, 0)")), 200, "no samples");
    check(&file(&entries("<f8", "(3, 2000000)")), 200, "transpose it");
    let huge = u64::MAX;
    check(
        &file(&entries("<f8", &format!("({huge}, 1000000)"))),
        200,
        "take 147573952589676412920000000 bytes",
    );
    let start = whole.len() as u64;
    check(&whole, start + 119, "take 120 bytes, but the file has 119 for them: it is truncated");
    check(&whole, start + 121, "the file has 121 for them: something else follows");
}
