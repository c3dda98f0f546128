use super::*;
use crate::bench::records;

#[test]
fn a_file_is_read_in_blocks() {
    let folder = tempfile::tempdir().unwrap();
    let values: Vec<f64> = (0..BLOCK + 3).map(|k| k as f64 / 7.0).collect();
    let files = records::write(folder.path(), "x", std::slice::from_ref(&values)).unwrap();
    let mut file = Doubles::open(Path::new(&files[0])).unwrap();
    assert_eq!(file.next().unwrap(), &values[..BLOCK]);
    assert_eq!(file.next().unwrap(), &values[BLOCK..]);
    assert!(file.next().unwrap().is_empty());

    std::fs::write(&files[0], [0; 11]).unwrap();
    assert!(Doubles::open(Path::new(&files[0])).unwrap().next().is_err());
}

#[test]
fn the_process_says_what_it_found() {
    let folder = tempfile::tempdir().unwrap();
    records::write_long(folder.path(), 3000, |_| ()).unwrap();
    let mut text = Vec::new();
    child(folder.path(), &mut text).unwrap();
    let found = judge(&text).unwrap();
    assert!(found.sums.median() > 0.0 && found.solution.median() > 0.0);

    assert!(
        judge(
            br#"{"sum_seconds": [1.0], "solution_seconds": [1.0], "peak_bytes": null, "rank": 54}"#
        )
        .is_ok()
    );
    assert!(
        judge(br#"{"sum_seconds": [1.0], "solution_seconds": [1.0], "peak_bytes": 5, "rank": 53}"#)
            .is_err()
    );
    assert!(
        judge(br#"{"sum_seconds": [], "solution_seconds": [1.0], "peak_bytes": 5, "rank": 54}"#)
            .is_err()
    );
    assert!(judge(b"").is_err());
}

#[test]
fn the_mark_is_read() {
    assert_eq!(
        high_water_mark("VmPeak:\t  99 kB\nVmHWM:\t    12 kB\nVmRSS:\t 3 kB\n"),
        Some(12_288)
    );
    assert_eq!(high_water_mark("VmPeak:\t  99 kB\n"), None);
    assert_eq!(high_water_mark("VmHWM:\t many kB\n"), None);
}
