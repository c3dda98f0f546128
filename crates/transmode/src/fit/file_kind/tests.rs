use super::*;

#[test]
fn the_name_says_it_or_the_channels_do() {
    let of = |file: &str, channels| FileKind::of(Path::new(file), channels);
    assert_eq!(of("a/b.npy", None), Ok(FileKind::Npy));
    assert_eq!(of("b.NPY", None), Ok(FileKind::Npy));
    assert_eq!(of("b.csv", None), Ok(FileKind::Table));
    assert_eq!(of("b.txt", None), Ok(FileKind::Table));
    assert_eq!(of("b", None), Ok(FileKind::Table));
    assert_eq!(of("b.f64", Some(3)), Ok(FileKind::Raw(3)));
    assert_eq!(of("b.bin", Some(2)), Ok(FileKind::Raw(2)));
    assert_eq!(of("b.f64", None), Err(FormatError::MissingChannels));
    assert_eq!(of("b.npy", Some(3)), Err(FormatError::NeedlessChannels));
    assert_eq!(of("b.csv", Some(3)), Err(FormatError::NeedlessChannels));
    assert_eq!(of("b.npz", None), Ok(FileKind::Table));
}
