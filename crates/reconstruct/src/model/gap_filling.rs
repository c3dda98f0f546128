//! Values for missing samples, so that nothing in a record is NaN.

/// Replaces each NaN, and says where they were. Between two samples stands the cubic with the slopes of the parabolas through these and the next one on
/// either side, so that parabolas go on; before the first sample and behind the last one their values are held. A signal of NaN alone stays as it is.
pub(crate) fn fill(values: &mut [f64]) -> Vec<usize> {
    let missing: Vec<usize> = (0..values.len()).filter(|&index| values[index].is_nan()).collect();
    let mut rest = missing.as_slice();
    while let Some(&first) = rest.first() {
        let length = rest.iter().zip(first..).take_while(|(index, next)| *index == next).count();
        rest = &rest[length..];
        let present = |index: &usize| missing.binary_search(index).is_err();
        let before = (0..first).rev().find(present);
        let after = (first + length..values.len()).find(present);
        let (Some(left), Some(right)) = (before, after) else {
            if let Some(edge) = before.or(after) {
                let held = values[edge];
                values[first..first + length].fill(held);
            }
            continue;
        };
        let slope =
            |from: usize, to: usize| (values[to] - values[from]) / (to as f64 - from as f64);
        let chord = slope(left, right);
        let further = (0..left).rev().find(present);
        let beyond = (right + 1..values.len()).find(present);
        let (start, end, span) = (values[left], values[right], (right - left) as f64);
        let parabola = |outer: f64, distance: usize| {
            let distance = distance as f64;
            (span * outer + distance * chord) / (span + distance)
        };
        let slopes = [
            further.map_or(chord, |k| parabola(slope(k, left), left - k)),
            beyond.map_or(chord, |k| parabola(slope(right, k), k - right)),
        ];
        for (index, value) in values.iter_mut().enumerate().take(first + length).skip(first) {
            let t = (index - left) as f64 / span;
            // Hermite's basis.
            let (t2, t3) = (t * t, t * t * t);
            *value = (2.0 * t3 - 3.0 * t2 + 1.0) * start
                + (3.0 * t2 - 2.0 * t3) * end
                + span * ((t3 - 2.0 * t2 + t) * slopes[0] + (t3 - t2) * slopes[1]);
        }
    }
    missing
}

#[cfg(test)]
mod tests;
