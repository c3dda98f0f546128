//! How many numbers the limits of autocorrelations rest on.

use std::path::{Path, PathBuf};

use reconstruct::likelihood::FrequencyBand;
use reconstruct::subspace::OrderChoice;
use reconstruct::{Options, reconstruct, spectral_fits};

use super::*;
use crate::records::{LoadOptions, Progress, load};

#[test]
fn limits_rest_on_the_frequencies_used() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/data/records");
    let files: Vec<PathBuf> =
        ["aileron", "rudder"].map(|name| folder.join(format!("white_snr10_{name}.csv"))).to_vec();
    let records = load(&files, &LoadOptions::default(), Progress::Hidden).unwrap().records;
    let mut options = Options::default();
    options.order = OrderChoice::Fixed(4);
    let period_s = records[0].period().seconds();
    let found = |options: &Options| {
        let result = reconstruct(&records, options).unwrap();
        numbers(&spectral_fits(&records, options, &result).unwrap()[0], period_s)
    };
    // Three sensors less one excitation leave two numbers for each sample.
    let all = 2.0 * records[0].samples() as f64;
    assert!((found(&options) / all - 1.0).abs() < 1e-12);
    let quarter = 0.25 * std::f64::consts::PI / period_s;
    options.band = Some(FrequencyBand { lowest_rad_s: quarter, highest_rad_s: 3.0 * quarter });
    assert!((found(&options) / all - 0.5).abs() < 2e-3);
}
