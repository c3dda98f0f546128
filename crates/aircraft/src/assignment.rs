//! Which names go together, and which mode gets which.

use num_complex::Complex;

use crate::agreement::{of_shape, of_speed};
use crate::mode_name::{ModeName, WhyUnnamed};
use crate::shape::Character;

use ModeName::{CoupledRollSpiral, DutchRoll, DutchRollRealRoot, RollSubsidence, Spiral, Unnamed};

/// What counts for a name that no mode bears: a mode that agrees less than this stays without it.
const MISSING: f64 = 0.1;

/// The same where the modes have four states together, as many as the names of an airframe ask for.
const MISSING_OF_FOUR_STATES: f64 = 1e-3;

/// What counts for a spiral that decays faster than the roll subsidence: the shapes have to speak ten times as loud.
const SPIRAL_FASTER_THAN_ROLL: f64 = 0.1;

/// A Dutch-roll frequency to compare with where there is no Dutch roll, rad/s.
const USUAL_FREQUENCY: f64 = 1.0;

/// What a mode is named by. Without a character it has no lateral motion.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Candidate {
    pub(crate) eigenvalue: Complex<f64>,
    pub(crate) oscillatory: bool,
    pub(crate) character: Option<Character>,
}

impl Candidate {
    fn agreement(&self, name: ModeName) -> f64 {
        self.character
            .and_then(|character| of_shape(name, self.oscillatory, character))
            .unwrap_or(0.0)
    }

    /// Agreement of shape and speed together.
    fn claim(&self, name: ModeName, frequency_rad_s: f64) -> f64 {
        self.agreement(name) * of_speed(name, self.eigenvalue, frequency_rad_s)
    }
}

/// Names that go together, with the product of what speaks for them.
#[derive(Debug, Clone)]
struct Assignment {
    product: f64,
    names: Vec<(usize, ModeName)>,
}

impl Assignment {
    fn with(&self, factor: f64, names: &[(usize, ModeName)]) -> Self {
        Self {
            product: self.product * factor,
            names: self.names.iter().chain(names).copied().collect(),
        }
    }

    fn has(&self, mode: usize) -> bool {
        self.names.iter().any(|&(named, _)| named == mode)
    }
}

/// Names and agreements, in the order of the modes: the assignment with the largest product.
pub(crate) fn by_shape(modes: &[Candidate]) -> Vec<(ModeName, f64)> {
    let moving = |oscillatory: bool| -> Vec<usize> {
        let is_one = |mode: &Candidate| mode.character.is_some() && mode.oscillatory == oscillatory;
        (0..modes.len()).filter(|&i| is_one(&modes[i])).collect()
    };
    let (pairs, real) = (moving(true), moving(false));
    let of_four_states = real.len() + 2 * pairs.len() == 4;
    let missing = if of_four_states { MISSING_OF_FOUR_STATES } else { MISSING };

    let mut best = Assignment { product: 0.0, names: Vec::new() };
    for dutch_roll in dutch_rolls(modes, &pairs, &real, missing) {
        let frequency_rad_s = match dutch_roll.names[..] {
            [(pair, DutchRoll)] => modes[pair].eigenvalue.norm(),
            _ => USUAL_FREQUENCY,
        };
        let free = |all: &[usize]| -> Vec<usize> {
            all.iter().copied().filter(|&mode| !dutch_roll.has(mode)).collect()
        };
        let (pairs, real) = (free(&pairs), free(&real));
        let separate = separate(modes, &dutch_roll, &real, frequency_rad_s, missing);
        let coupled = coupled(modes, &dutch_roll, &pairs, &real, frequency_rad_s);
        for assignment in separate.into_iter().chain(coupled) {
            if assignment.product > best.product {
                best = assignment;
            }
        }
    }

    let mut named: Vec<(ModeName, f64)> = modes
        .iter()
        .map(|mode| match mode.character {
            Some(_) => (Unnamed(WhyUnnamed::BetterClaim), 0.0),
            None => (Unnamed(WhyUnnamed::NoLateralMotion), 0.0),
        })
        .collect();
    for (mode, name) in best.names {
        named[mode] = (name, modes[mode].agreement(name));
    }
    named
}

/// No Dutch roll, each pair as the Dutch roll, and, where there is no pair at all, any two real modes.
fn dutch_rolls(
    modes: &[Candidate],
    pairs: &[usize],
    real: &[usize],
    missing: f64,
) -> Vec<Assignment> {
    let none = Assignment { product: 1.0, names: Vec::new() };
    let mut all = vec![none.with(missing, &[])];
    all.extend(pairs.iter().map(|&i| {
        let frequency_rad_s = modes[i].eigenvalue.norm();
        none.with(modes[i].claim(DutchRoll, frequency_rad_s), &[(i, DutchRoll)])
    }));
    if pairs.is_empty() {
        let root = |i: usize| modes[i].agreement(DutchRollRealRoot);
        for (position, &i) in real.iter().enumerate() {
            all.extend(real[position + 1..].iter().map(|&j| {
                none.with(root(i) * root(j), &[(i, DutchRollRealRoot), (j, DutchRollRealRoot)])
            }));
        }
    }
    all
}

/// Each real mode, or none, as the roll subsidence and as the spiral.
fn separate(
    modes: &[Candidate],
    dutch_roll: &Assignment,
    real: &[usize],
    frequency_rad_s: f64,
    missing: f64,
) -> Vec<Assignment> {
    let with = |to: &Assignment, name: ModeName| -> Vec<Assignment> {
        let claimed = real
            .iter()
            .filter(|&&i| !to.has(i))
            .map(|&i| to.with(modes[i].claim(name, frequency_rad_s), &[(i, name)]));
        std::iter::once(to.with(missing, &[])).chain(claimed).collect()
    };
    let mut all: Vec<Assignment> =
        with(dutch_roll, RollSubsidence).iter().flat_map(|rolling| with(rolling, Spiral)).collect();
    for assignment in &mut all {
        let rate = |wanted: ModeName| {
            let named = assignment.names.iter().find(|&&(_, name)| name == wanted);
            named.map(|&(mode, _)| modes[mode].eigenvalue.re)
        };
        if rate(Spiral).zip(rate(RollSubsidence)).is_some_and(|(spiral, roll)| spiral < roll) {
            assignment.product *= SPIRAL_FASTER_THAN_ROLL;
        }
    }
    all
}

/// Each pair as the coupled roll-spiral, which leaves no real mode to be a roll subsidence or a spiral.
fn coupled(
    modes: &[Candidate],
    dutch_roll: &Assignment,
    pairs: &[usize],
    real: &[usize],
    frequency_rad_s: f64,
) -> Vec<Assignment> {
    let is_neither = |&i: &usize| {
        let claim = |name: ModeName| modes[i].claim(name, frequency_rad_s);
        1.0 - claim(RollSubsidence).max(claim(Spiral))
    };
    let neither: f64 = real.iter().map(is_neither).product();
    let claim = |&i: &usize| {
        let claim = modes[i].claim(CoupledRollSpiral, frequency_rad_s);
        dutch_roll.with(claim * neither, &[(i, CoupledRollSpiral)])
    };
    pairs.iter().map(claim).collect()
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
