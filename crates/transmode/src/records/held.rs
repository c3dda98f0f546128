//! Channels of a lower rate, whose values are held until the next one.

/// Fewer runs of equal values than this say nothing.
const FEWEST_RUNS: usize = 20;

/// So many of all runs are as long as the usual one, or one row longer or shorter.
const REGULAR: f64 = 0.9;

/// For how many rows each value is held, if they are held regularly: two at least.
pub(crate) fn length(values: &[f64]) -> Option<usize> {
    let runs: Vec<usize> = values
        .chunk_by(|a, b| a.to_bits() == b.to_bits())
        .filter(|run| !run[0].is_nan())
        .map(<[f64]>::len)
        .collect();
    // Those at the ends are cut.
    let inner = runs.get(1..runs.len().checked_sub(1)?)?;
    if inner.len() < FEWEST_RUNS {
        return None;
    }
    let mut sorted = inner.to_vec();
    let usual = *sorted.select_nth_unstable(inner.len() / 2).1;
    // Two equal values in a row make a run of twice the length.
    let is_regular =
        |run: &&usize| run.abs_diff(usual) <= 1 && **run > 1 || run.abs_diff(2 * usual) <= 1;
    let regular = inner.iter().filter(is_regular).count();
    (usual >= 2 && regular as f64 >= REGULAR * inner.len() as f64).then_some(usual)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn held_values_are_told_from_coarse_and_smooth_ones() {
        let smooth: Vec<f64> = (0..600).map(|k| (f64::from(k) / 40.0).sin()).collect();
        let held: Vec<f64> = (0..600).map(|k| smooth[k / 4 * 4]).collect();
        let coarse: Vec<f64> = smooth.iter().map(|x| (x * 20.0).round() / 20.0).collect();
        // Rates of three to one, not quite.
        let uneven: Vec<f64> = (0..600).map(|k| smooth[k * 3 / 10 * 10 / 3]).collect();
        assert_eq!(length(&held), Some(4));
        assert!(matches!(length(&uneven), Some(3 | 4)));
        assert_eq!(length(&smooth), None);
        assert_eq!(length(&coarse), None);
        assert_eq!(length(&[1.0; 500]), None);
        assert_eq!(length(&[]), None);
    }
}
