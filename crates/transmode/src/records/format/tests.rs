use super::*;

#[test]
fn what_a_file_holds_decides() {
    let of = |start: &[u8], name: &str| Format::of(start, Path::new(name));
    assert_eq!(of(b"\x93NUMPY\x01\x00", "x.csv"), Ok(Format::Npy));
    assert_eq!(of(b"\x1f\x8b\x08", "x.csv"), Ok(Format::GzippedText));
    assert_eq!(of(b"PK\x03\x04", "x"), Ok(Format::Npz));
    assert_eq!(of(b"MATLAB 5.0 MAT-file, Platform", "x.dat"), Ok(Format::Mat));
    assert_eq!(of(b"MATLAB 7.3 MAT-file", "x.mat"), Ok(Format::Mat73));
    assert_eq!(of(b"\x89HDF\r\n\x1a\n", "x.h5"), Ok(Format::Hdf5));
    assert_eq!(of(b"\x89HDF\r\n\x1a\n", "x.mat"), Ok(Format::Mat73));
    assert_eq!(of(b"time,beta\n", "x.txt"), Ok(Format::Text));
    assert_eq!(of(b"", "x"), Ok(Format::Text));
}

#[test]
fn a_name_that_says_otherwise_is_told() {
    let of = |start: &[u8], name: &str| Format::of(start, Path::new(name));
    assert_eq!(of(b"time,beta\n", "x.NPY"), Err(FormatError::NotNpy));
    assert_eq!(of(b"time,beta\n", "x.mat"), Err(FormatError::Misnamed { format: "MATLAB" }));
    assert_eq!(of(&[0; 32], "x.mat"), Err(FormatError::Mat4));
    assert_eq!(of(&[0; 32], "x.f64"), Err(FormatError::IsRaw));
    assert_eq!(of(b"\xd0\xcf\x11\xe0", "x.xls"), Err(FormatError::Spreadsheet));
}

#[test]
fn formats_that_are_not_read_are_named_with_a_remedy() {
    for (start, word) in [
        (&b"ULog\x01\x12\x35\x01"[..], "ulog2csv"),
        (b"TDSm\x0e\0\0\0", "LabVIEW"),
        (b"#ROSBAG V2.0\n", "topics"),
        (b"CDF\x01\0", "nccopy"),
        (b"\xfd7zXZ\0\0", "xz -d"),
    ] {
        let message = Format::of(start, Path::new("x.csv")).unwrap_err().to_string();
        assert!(message.starts_with("this is a") && message.contains(word), "{message}");
    }
    assert_eq!(Format::of(b"\x28\xb5\x2f\xfd\0", Path::new("x.csv.zst")), Ok(Format::ZstdText));
}
