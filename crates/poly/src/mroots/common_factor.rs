//! Multiplicities from the greatest common divisor of p and p', for clusters too wide to be told apart.
//!
//! With `u = gcd(p, p')`, `v = p/u` and `w = p'/u` the roots of v are the distinct roots of p, and since
//! `p'/p = w/v = sum of m_i / (x - z_i)`, the multiplicities are the residues `m_i = w(z_i) / v'(z_i)`.
//! Nearness decides, not exactness: the degree k of v is one at which the matrix of `p w - p' v = 0` is nearly
//! singular, and then (u, v, w) is refined by Gauss-Newton on `u v = p`, `u w = p'` (Zeng 2005, algorithm I; he repeats
//! the division for the multiplicities, which loses digits at each stage). What comes out are hypotheses; the
//! pejorative fit judges them.

use super::conjugate::symmetrize;
use super::pejorative::{Multiple, Target};
use crate::aberth::{ScaledPoly, scale_by_power};
use crate::least_squares::Factored;
use num_complex::Complex;

type C = Complex<f64>;
const ZERO: C = Complex::new(0.0, 0.0);

/// Smallest singular value, relative to p of norm 1, below which a common divisor is tried.
const NEARLY_SINGULAR: f64 = 1e-6;

/// At this size of the singular value no larger degree is worth a trial.
const SINGULAR: f64 = 1e-14;

/// Distinct roots at most: the matrices grow with them.
const MAXIMUM_DISTINCT: usize = 40;

/// Trials at most.
const TRIALS: usize = 6;

/// A residue may be this far from an integer.
const RESIDUE_ERROR: f64 = 0.3;

/// Gauss-Newton steps on (u, v, w).
const REFINEMENTS: usize = 8;

/// Sweeps of the iteration for the roots of v.
const SWEEPS: usize = 200;

/// Structures with at most half as many distinct roots as the degree, and at most 40; fewest distinct roots first.
pub(crate) fn hypotheses(target: &Target) -> Vec<Vec<Multiple>> {
    let p = normalized(target.coefficients());
    let derivative = derivative(&p);
    let mut found = Vec::new();
    let mut trials = 0;
    for k in 1..=MAXIMUM_DISTINCT.min(target.degree() / 2) {
        let Some((singular, v, w)) = nearly_common(&p, &derivative, k) else { continue };
        if singular > NEARLY_SINGULAR {
            continue;
        }
        trials += 1;
        found.extend(
            refine(&p, &derivative, v, w).and_then(|(v, w)| multiplicities(&v, &w, target)),
        );
        if singular <= SINGULAR || trials == TRIALS {
            break;
        }
    }
    found
}

/// The smallest singular value of `(v, w) -> p w - p' v` with v of degree k and w of degree k - 1, and its vector.
fn nearly_common(p: &[C], derivative: &[C], k: usize) -> Option<(f64, Vec<C>, Vec<C>)> {
    let length = p.len() - 1 + k;
    let mut columns: Vec<Vec<C>> = (0..k).map(|shift| shifted(p, shift, length)).collect();
    let negative: Vec<C> = derivative.iter().map(|c| -c).collect();
    columns.extend((0..=k).map(|shift| shifted(&negative, shift, length)));
    let (singular, vector) = Factored::new(columns)?.smallest_singular();
    let (w, v) = vector.split_at(k);
    Some((singular, v.to_vec(), w.to_vec()))
}

/// The nearest (v, w) for which a u exists with `u v = p` and `u w = p'`.
fn refine(p: &[C], derivative: &[C], mut v: Vec<C>, mut w: Vec<C>) -> Option<(Vec<C>, Vec<C>)> {
    let degree = p.len() - 1;
    let k = w.len();
    // u from u v = p and u w = p', by least squares.
    let unknowns = degree - k + 1;
    let right: Vec<C> = p.iter().chain(derivative).copied().collect();
    let columns: Vec<Vec<C>> = (0..unknowns)
        .map(|shift| {
            let mut column = shifted(&v, shift, degree + 1);
            column.extend(shifted(&w, shift, degree));
            column
        })
        .collect();
    let mut u = Factored::new(columns)?.solve(&right);

    // One linear condition fixes the scale of u against v and w.
    let scale: f64 = u.iter().map(C::norm_sqr).sum();
    let fixed: Vec<C> = u.iter().map(|c| c.conj() / scale).collect();
    let mut best: Option<(f64, Vec<C>, Vec<C>)> = None;
    for _ in 0..REFINEMENTS {
        let mut error: Vec<C> = difference(&product(&u, &v), p);
        error.extend(difference(&product(&u, &w), derivative));
        let size = error.iter().map(C::norm_sqr).sum::<f64>().sqrt();
        if best.as_ref().is_none_or(|(least, ..)| size < *least) {
            best = Some((size, v.clone(), w.clone()));
        } else {
            break;
        }
        let condition: C = fixed.iter().zip(&u).map(|(a, b)| a * b).sum();
        error.push(condition - 1.0);
        let block = |top: Vec<C>, bottom: Vec<C>, last: C| -> Vec<C> {
            top.into_iter().chain(bottom).chain([last]).collect()
        };
        let mut columns: Vec<Vec<C>> = (0..u.len())
            .map(|s| block(shifted(&v, s, degree + 1), shifted(&w, s, degree), fixed[s]))
            .collect();
        columns.extend(
            (0..v.len()).map(|s| block(shifted(&u, s, degree + 1), vec![ZERO; degree], ZERO)),
        );
        columns.extend(
            (0..w.len()).map(|s| block(vec![ZERO; degree + 1], shifted(&u, s, degree), ZERO)),
        );
        let step = Factored::new(columns)?.solve(&error);
        for (value, change) in u.iter_mut().chain(&mut v).chain(&mut w).zip(&step) {
            *value -= change;
        }
    }
    best.map(|(_, v, w)| (v, w))
}

/// The roots of v with the residues of w/v as multiplicities, if these are near positive integers with the right sum.
fn multiplicities(v: &[C], w: &[C], target: &Target) -> Option<Vec<Multiple>> {
    let slope = derivative(v);
    let mut structure = Vec::new();
    for z in roots(v, target.is_real())? {
        let residue = evaluate(w, z) / evaluate(&slope, z);
        let multiplicity = (1..=target.degree()).zip(1_u32..).find_map(|(m, count)| {
            ((residue - f64::from(count)).norm() <= RESIDUE_ERROR).then_some(m)
        })?;
        let value = scale_by_power(z, target.exponent());
        structure.push(Multiple { value, multiplicity });
    }
    let sum: usize = structure.iter().map(|root| root.multiplicity).sum();
    (sum == target.degree()).then_some(structure)
}

fn evaluate(p: &[C], x: C) -> C {
    p.iter().rev().fold(ZERO, |value, c| value * x + c)
}

fn roots(v: &[C], real: bool) -> Option<Vec<C>> {
    if v.first() == Some(&ZERO) || v.last() == Some(&ZERO) {
        return None;
    }
    let found = ScaledPoly::new(v.to_vec()).approximate(SWEEPS).ok()?;
    Some(if real { symmetrize(&found.roots) } else { found.roots })
}

fn normalized(p: &[C]) -> Vec<C> {
    let norm = p.iter().map(C::norm_sqr).sum::<f64>().sqrt();
    p.iter().map(|c| c / norm).collect()
}

fn derivative(p: &[C]) -> Vec<C> {
    let degrees = 1_u32..;
    p.iter().skip(1).zip(degrees).map(|(c, k)| c * f64::from(k)).collect()
}

/// The coefficients shifted up by `shift` and padded to `length`.
fn shifted(p: &[C], shift: usize, length: usize) -> Vec<C> {
    let mut column = vec![ZERO; shift];
    column.extend_from_slice(p);
    column.resize(length, ZERO);
    column
}

fn product(a: &[C], b: &[C]) -> Vec<C> {
    let mut result = vec![ZERO; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (k, y) in b.iter().enumerate() {
            result[i + k] += x * y;
        }
    }
    result
}

fn difference(a: &[C], b: &[C]) -> Vec<C> {
    a.iter().zip(b).map(|(x, y)| x - y).collect()
}
