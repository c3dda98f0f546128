use super::*;

fn check(bytes: &[u8], channels: u64, expected: &str) {
    match placement(&mut &bytes[..], bytes.len() as u64, channels) {
        Err(npy::NpyError::Format(error)) => {
            assert!(error.to_string().contains(expected), "{error}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_length_says_how_many_samples_there_are() {
    let found = placement(&mut &[0; 48][..], 48, 3).unwrap();
    assert_eq!([found.offset(), found.samples(), found.channels()], [0, 2, 3]);
}

#[test]
fn refuses_what_is_no_whole_number_of_samples() {
    check(&[], 3, "no samples");
    check(&[0; 47], 3, "its 47 bytes are no multiple of 24, one sample of 3 channels");
    check(&[0; 8], 3, "its 8 bytes are no multiple of 24");
    check(&[0; 48], u64::MAX, "no multiple of 18446744073709551615");
    let npy = [NPY_MAGIC, &[0; 18]].concat();
    check(&npy, 3, "this is an NPY file");
}
