use super::*;

#[test]
fn the_name_says_it_or_the_channels_do() {
    let of = |file: &str, channels| Format::of(Path::new(file), channels);
    assert_eq!(of("a/b.npy", None), Ok(Format::Npy));
    assert_eq!(of("b.NPY", None), Ok(Format::Npy));
    assert_eq!(of("b.csv", None), Ok(Format::Table));
    assert_eq!(of("b.txt", None), Ok(Format::Table));
    assert_eq!(of("b", None), Ok(Format::Table));
    assert_eq!(of("b.f64", Some(3)), Ok(Format::Raw(3)));
    assert_eq!(of("b.bin", Some(2)), Ok(Format::Raw(2)));
    assert_eq!(of("b.f64", None), Err(FormatError::MissingChannels));
    assert_eq!(of("b.npy", Some(3)), Err(FormatError::NeedlessChannels));
    assert_eq!(of("b.csv", Some(3)), Err(FormatError::NeedlessChannels));
    assert_eq!(of("b.npz", None), Ok(Format::Table));
}
