use super::*;

#[test]
fn blocks_make_up_the_record() {
    for samples in [0, 1, BLOCK - 1, BLOCK, 2 * BLOCK + 3] {
        assert_eq!(blocks(samples).sum::<usize>(), samples);
    }
}

#[test]
fn a_record_goes_on_where_it_stopped() {
    let mut whole = EndlessRecord::new(Surface::Rudder).unwrap();
    let mut parts = EndlessRecord::new(Surface::Rudder).unwrap();
    let [whole, _, _] = whole.next(300).unwrap();
    let [mut first, _, _] = parts.next(100).unwrap();
    let [second, _, _] = parts.next(200).unwrap();
    first.extend(second);
    let largest = whole.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    assert!(largest > 0.1);
    for (a, b) in whole.iter().zip(&first) {
        assert!((a - b).abs() < 1e-13 * largest, "{a} {b}");
    }
}

#[test]
fn noise_has_its_level() {
    let flat: Channels = [vec![2.0; 4000], vec![2.0; 4000], vec![0.0; 4000]];
    let [first, second, silent] = with_noise(flat);
    for noisy in [&first, &second] {
        let variance = noisy.iter().map(|x| (x - 2.0).powi(2)).sum::<f64>() / 4000.0;
        assert!((variance.sqrt() / 0.02 - 1.0).abs() < 0.05, "{variance}");
    }
    assert_ne!(first, second);
    assert!(silent.iter().all(|x| x.abs() <= 0.0));
}

#[test]
fn files_hold_the_record() {
    let folder = tempfile::tempdir().unwrap();
    let channels = vec![vec![1.0, -2.5], vec![f64::MIN_POSITIVE]];
    let files = write(folder.path(), "x", &channels).unwrap();
    let bytes = std::fs::read(&files[0]).unwrap();
    assert_eq!(bytes, [1.0_f64.to_le_bytes(), (-2.5_f64).to_le_bytes()].concat());
    assert_eq!(std::fs::read(&files[1]).unwrap().len(), 8);

    let [input, output] = write_long(folder.path(), BLOCK + 5, |_| ()).unwrap();
    for file in [input, output] {
        assert_eq!(std::fs::metadata(file).unwrap().len(), 8 * (BLOCK as u64 + 5));
    }
}
