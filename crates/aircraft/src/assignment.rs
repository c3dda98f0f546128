//! Which names go together, and which mode gets which.

use num_complex::Complex;

use crate::mode_name::{ModeName, WhyUnnamed};
use crate::shape::Character;

use ModeName::{CoupledRollSpiral, DutchRoll, DutchRollRealRoot, RollSubsidence, Spiral, Unnamed};

/// The names that a complete set of four eigenvalues can have.
const COMPLETE_SETS: [&[ModeName]; 4] = [
    &[DutchRoll, RollSubsidence, Spiral],
    &[CoupledRollSpiral, DutchRollRealRoot, DutchRollRealRoot],
    &[DutchRoll, CoupledRollSpiral],
    &[DutchRollRealRoot, DutchRollRealRoot, RollSubsidence, Spiral],
];

/// All names, with how many modes of a set may bear each.
const LIMITS: [(ModeName, usize); 5] = [
    (DutchRoll, 1),
    (CoupledRollSpiral, 1),
    (RollSubsidence, 1),
    (Spiral, 1),
    (DutchRollRealRoot, 2),
];

/// How well a mode agrees with a name; `None` where the name is for the other kind of eigenvalue.
fn agreement(name: ModeName, oscillatory: bool, character: Character) -> Option<f64> {
    let Character { slip_fraction: slip, roll_fraction: roll, .. } = character;
    match (name, oscillatory) {
        (DutchRoll, true) | (DutchRollRealRoot, false) => Some(slip),
        (CoupledRollSpiral, true) => Some(1.0 - slip),
        (RollSubsidence, false) => Some((1.0 - slip) * roll),
        (Spiral, false) => Some((1.0 - slip) * (1.0 - roll)),
        _ => None,
    }
}

/// Names and agreements, in the order of the modes.
pub(crate) fn by_shape(
    oscillatory: &[bool],
    characters: &[Option<Character>],
) -> Vec<(ModeName, f64)> {
    let known: Option<Vec<Character>> = characters.iter().copied().collect();
    known
        .and_then(|known| complete(oscillatory, &known))
        .unwrap_or_else(|| one_by_one(oscillatory, characters))
}

/// The best assignment of a complete set, or `None` if the modes are not one.
fn complete(oscillatory: &[bool], characters: &[Character]) -> Option<Vec<(ModeName, f64)>> {
    let mut best: Option<(f64, Vec<(ModeName, f64)>)> = None;
    for set in COMPLETE_SETS.into_iter().filter(|set| set.len() == characters.len()) {
        for order in permutations(set) {
            let named: Option<Vec<(ModeName, f64)>> = order
                .into_iter()
                .enumerate()
                .map(|(i, name)| {
                    agreement(name, oscillatory[i], characters[i]).map(|value| (name, value))
                })
                .collect();
            let Some(named) = named else { continue };
            let sum: f64 = named.iter().map(|(_, value)| value).sum();
            if best.as_ref().is_none_or(|(largest, _)| sum > *largest) {
                best = Some((sum, named));
            }
        }
    }
    best.map(|(_, named)| named)
}

/// All orders of at most four names.
fn permutations(names: &[ModeName]) -> Vec<Vec<ModeName>> {
    if names.is_empty() {
        return vec![Vec::new()];
    }
    let mut all = Vec::new();
    for first in 0..names.len() {
        let mut rest = names.to_vec();
        let head = rest.remove(first);
        for tail in permutations(&rest) {
            let mut order = vec![head];
            order.extend(tail);
            all.push(order);
        }
    }
    all
}

/// Each mode claims its best name; where too many claim one, the best keep it.
fn one_by_one(oscillatory: &[bool], characters: &[Option<Character>]) -> Vec<(ModeName, f64)> {
    let mut claims: Vec<(ModeName, f64)> = oscillatory
        .iter()
        .zip(characters)
        .map(|(&oscillatory, &character)| {
            let Some(character) = character else {
                return (Unnamed(WhyUnnamed::NoLateralMotion), 0.0);
            };
            LIMITS
                .into_iter()
                .filter_map(|(name, _)| {
                    agreement(name, oscillatory, character).map(|value| (name, value))
                })
                .fold((Unnamed(WhyUnnamed::BetterClaim), 0.0), |best, claim| {
                    if claim.1 > best.1 { claim } else { best }
                })
        })
        .collect();
    for (name, limit) in LIMITS {
        let mut holders: Vec<usize> = (0..claims.len()).filter(|&i| claims[i].0 == name).collect();
        holders.sort_by(|&i, &j| claims[j].1.total_cmp(&claims[i].1));
        for &loser in holders.iter().skip(limit) {
            claims[loser] = (Unnamed(WhyUnnamed::BetterClaim), 0.0);
        }
    }
    claims
}

/// Names by the pattern and the order of the eigenvalues.
pub(crate) fn by_eigenvalue(
    oscillatory: &[bool],
    eigenvalues: &[Complex<f64>],
    tolerance: f64,
) -> Vec<ModeName> {
    let pairs: Vec<usize> = (0..eigenvalues.len()).filter(|&i| oscillatory[i]).collect();
    let real: Vec<usize> = (0..eigenvalues.len()).filter(|&i| !oscillatory[i]).collect();
    let mut names = vec![
        Unnamed(WhyUnnamed::IncompleteSet { real: real.len(), pairs: pairs.len() });
        eigenvalues.len()
    ];
    // The two that compete, what orders them, and the names of the larger and the smaller.
    let (i, j, keys, (larger, smaller)) = match (&pairs[..], &real[..]) {
        (&[dutch_roll], &[i, j]) => {
            names[dutch_roll] = DutchRoll;
            (
                i,
                j,
                eigenvalues.iter().map(|eigenvalue| eigenvalue.re).collect::<Vec<f64>>(),
                (Spiral, RollSubsidence),
            )
        }
        (&[i, j], &[]) => (
            i,
            j,
            eigenvalues.iter().map(|eigenvalue| eigenvalue.norm()).collect(),
            (DutchRoll, CoupledRollSpiral),
        ),
        _ => return names,
    };
    let (a, b) = (keys[i], keys[j]);
    let equal = (a - b).abs() <= tolerance * a.abs().max(b.abs());
    let unnamed = Unnamed(WhyUnnamed::EqualEigenvalues);
    (names[i], names[j]) = if equal {
        (unnamed, unnamed)
    } else if a > b {
        (larger, smaller)
    } else {
        (smaller, larger)
    };
    names
}

#[cfg(test)]
mod tests;
