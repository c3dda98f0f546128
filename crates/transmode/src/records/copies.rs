//! Channels that are multiples of each other: one sensor in two units, say.

/// A copy differs from a multiple of its original by no more than this part of it: rounding to four
/// digits. Two sensors of one quantity differ by their noise, which is more.
const DIFFERENCE: f64 = 2e-4;

/// That `copy` is `factor` times `original`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Copy {
    pub(crate) copy: usize,
    pub(crate) original: usize,
    pub(crate) factor: f64,
}

/// The channels that are multiples of one before them in all records; `records[j][c]` are the samples
/// of channel c in record j. Constants are no copies.
pub(crate) fn copies(records: &[Vec<&[f64]>]) -> Vec<Copy> {
    let channels = records.iter().map(Vec::len).min().unwrap_or(0);
    let mut found: Vec<Copy> = Vec::new();
    for copy in 1..channels {
        // One that is a copy itself says no more than its original.
        let originals = (0..copy).filter(|other| !found.iter().any(|known| known.copy == *other));
        let is_copy = |original: usize| {
            let pairs = || records.iter().map(move |record| [record[original], record[copy]]);
            let factor = factor(pairs())?;
            pairs().all(|[x, y]| is_multiple(x, y, factor)).then_some(Copy {
                copy,
                original,
                factor,
            })
        };
        found.extend(originals.into_iter().find_map(is_copy));
    }
    found
}

/// The least-squares factor from the first to the second of each pair; `None` where the first is
/// constant or a sample is missing in one alone.
fn factor<'a>(pairs: impl Iterator<Item = [&'a [f64]; 2]>) -> Option<f64> {
    let (mut product, mut square, mut varies) = (0.0, 0.0, false);
    for [first, second] in pairs {
        for (x, y) in first.iter().zip(second) {
            if x.is_nan() != y.is_nan() {
                return None;
            }
            if !x.is_nan() {
                product += x * y;
                square += x * x;
            }
        }
        varies |= first.windows(2).any(|pair| (pair[0] - pair[1]).abs() > 0.0);
    }
    let factor = product / square;
    (varies && factor.is_finite() && factor.abs() > 0.0).then_some(factor)
}

fn is_multiple(x: &[f64], y: &[f64], factor: f64) -> bool {
    let (mut difference, mut size) = (0.0, 0.0);
    let mean = |values: &[f64]| {
        let sum: f64 = values.iter().filter(|value| !value.is_nan()).sum();
        sum / values.iter().filter(|value| !value.is_nan()).count().max(1) as f64
    };
    // A large mean would hide that what varies differs.
    let middle = mean(y);
    for (x, y) in x.iter().zip(y).filter(|(x, _)| !x.is_nan()) {
        difference += (y - factor * x).powi(2);
        size += (y - middle).powi(2);
    }
    difference <= DIFFERENCE * DIFFERENCE * size
}

#[cfg(test)]
mod tests {
    use super::*;

    fn signal(seed: u64) -> Vec<f64> {
        let mut random = flight::Stream::new(seed, 0);
        (0..500).map(|k| (f64::from(k) / 20.0).sin() + 0.01 * random.normal()).collect()
    }

    #[test]
    fn a_sensor_in_degrees_is_a_copy_and_a_second_sensor_is_none() {
        let [a, second] = [1, 2].map(signal);
        let degrees: Vec<f64> = a.iter().map(|x| (x.to_degrees() * 1e4).round() / 1e4).collect();
        let again: Vec<f64> = a.iter().map(|x| -x).collect();
        let found = copies(&[vec![&a, &second, &degrees, &again]]);
        let pairs: Vec<_> = found.iter().map(|found| (found.copy, found.original)).collect();
        assert_eq!(pairs, [(2, 0), (3, 0)]);
        assert!((found[0].factor / 1_f64.to_degrees() - 1.0).abs() < 1e-6);
        // In one record of two is no copy.
        assert!(copies(&[vec![&a, &degrees], vec![&a, &second]]).is_empty());
    }

    #[test]
    fn constants_offsets_and_gaps_make_no_copy() {
        let a = signal(3);
        let dead = vec![2.0; 500];
        let shifted: Vec<f64> = a.iter().map(|x| 1000.0 + x).collect();
        let mut gappy = a.clone();
        gappy[7] = f64::NAN;
        assert!(copies(&[vec![&a, &dead, &shifted, &gappy]]).is_empty());
        assert!(copies(&[vec![&dead, &dead]]).is_empty());
        assert!(copies(&[]).is_empty());
    }
}
