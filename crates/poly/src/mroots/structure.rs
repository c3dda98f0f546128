//! Which roots are one multiple root: hypotheses from clusters, judged by the backward error.
//!
//! Simple roots of perturbed coefficients surround a multiple root at about the distance by which each of them is
//! uncertain. So roots are linked in the order of `|z_i - z_j| / (u_i + u_j)`, and each level of the linkage is a
//! hypothesis. The uncertainty u of a root under relative changes e of the coefficients is
//! `min over k of (e sum |c_j z^j| / |p^(k)(z) / k!|)^(1/k)`: with k = 1 alone it would grow without bound as roots meet. The one with the fewest distinct roots is taken whose
//! nearest polynomial explains the coefficients within their error, and whose clusters stand apart.

use super::common_factor;
use super::multiset::Root;
use super::options::MrootsOptions;
use super::pejorative::{Fit, Multiple, Target};
use crate::aberth::{ScaledPoly, scale_by_power};
use num_complex::Complex;

type C = Complex<f64>;

/// Roots further apart than this many uncertainties are not linked: members of one cluster are at most one apart.
const FARTHEST_LINK: f64 = 10.0;

/// Hypotheses whose fit is computed, at most: they come fewest distinct roots first.
const MAXIMUM_FITS: usize = 32;

/// A cluster of m roots of diameter d, a gap g away from other roots, speaks for a multiple root if `(d/g)^m` is
/// below this: the same coefficients with the cluster opened to the gap would be that much farther from the manifold.
const ISOLATION: f64 = 0.01;

/// The best structure with multiple roots, if there is one.
pub(crate) fn multiple_structure(
    p: &mut ScaledPoly,
    target: &Target,
    simple: &[Root],
    options: &MrootsOptions,
) -> Option<Fit> {
    let reaches: Vec<f64> =
        simple.iter().map(|root| reach(p, root, options.coefficient_error)).collect();
    let levels = linkage(simple, &reaches);
    if levels.is_empty() {
        return None;
    }
    let clustered = from_clusters(target, simple, &levels, options);
    // Common factors answer for the rest: many multiple roots whose clusters overlap.
    let few = |fit: &Fit| 2 * fit.roots.len() <= target.degree();
    if clustered.as_ref().is_some_and(few) {
        return clustered;
    }
    common_factor::hypotheses(target)
        .iter()
        .filter_map(|start| target.fit(start, options.coefficient_error))
        .min_by_key(|fit| fit.roots.len())
        .or(clustered)
}

/// The first level, fewest clusters first, whose clusters stand apart and whose fit is good enough.
fn from_clusters(
    target: &Target,
    simple: &[Root],
    levels: &[Vec<usize>],
    options: &MrootsOptions,
) -> Option<Fit> {
    levels
        .iter()
        .map(|links| merge(simple, links))
        .filter(|hypothesis| hypothesis.iter().all(|cluster| cluster.stands_apart))
        .take(MAXIMUM_FITS)
        .find_map(|hypothesis| {
            let start: Vec<Multiple> = hypothesis.iter().map(|cluster| cluster.root).collect();
            target.fit(&start, options.coefficient_error)
        })
}

/// How far a root may move under relative changes of the coefficients.
fn reach(p: &mut ScaledPoly, root: &Root, coefficient_error: f64) -> f64 {
    let exponent = ScaledPoly::exponent(root.value);
    let y = scale_by_power(root.value, -exponent);
    let mut taylor = p.scaled(exponent).to_vec();
    let modulus = y.norm();
    let terms = taylor.iter().rev().fold(0.0, |sum, c| sum * modulus + c.norm());
    let degree = taylor.len() - 1;
    for start in 0..degree {
        for k in (start..degree).rev() {
            let above = taylor[k + 1];
            taylor[k] += y * above;
        }
    }
    let radius = taylor
        .iter()
        .skip(1)
        .zip(1_u32..)
        .map(|(c, k)| (coefficient_error * terms / c.norm()).powf(1.0 / f64::from(k)))
        .fold(f64::INFINITY, f64::min);
    scale_by_power(C::new(radius, 0.0), exponent).re
}

/// The clusters of each level of the linkage, as a label per root; fewest clusters first.
fn linkage(roots: &[Root], reaches: &[f64]) -> Vec<Vec<usize>> {
    let mut links = Vec::new();
    for (i, a) in roots.iter().enumerate() {
        for (j, b) in roots.iter().enumerate().skip(i + 1) {
            let distance = (a.value - b.value).norm() / (reaches[i] + reaches[j]);
            if distance <= FARTHEST_LINK {
                links.push((distance, i, j));
            }
        }
    }
    links.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut labels: Vec<usize> = (0..roots.len()).collect();
    let mut levels = Vec::new();
    for (k, &(distance, i, j)) in links.iter().enumerate() {
        let (from, to) = (labels[i].max(labels[j]), labels[i].min(labels[j]));
        for label in &mut labels {
            if *label == from {
                *label = to;
            }
        }
        // Equal distances, as between conjugates, belong to one level.
        let last_of_level = links.get(k + 1).is_none_or(|next| next.0 > distance * (1.0 + 1e-6));
        if last_of_level && levels.last() != Some(&labels) {
            levels.push(labels.clone());
        }
    }
    levels.reverse();
    levels
}

/// A cluster of simple roots taken as one.
#[derive(Debug, Clone, Copy)]
struct Cluster {
    root: Multiple,
    stands_apart: bool,
}

fn merge(roots: &[Root], labels: &[usize]) -> Vec<Cluster> {
    let mut clusters = Vec::new();
    for label in 0..roots.len() {
        let members: Vec<C> =
            (0..roots.len()).filter(|&k| labels[k] == label).map(|k| roots[k].value).collect();
        if members.is_empty() {
            continue;
        }
        let others = (0..roots.len()).filter(|&k| labels[k] != label).map(|k| roots[k].value);
        clusters.push(cluster(&members, others));
    }
    clusters
}

fn cluster(members: &[C], others: impl Iterator<Item = C> + Clone) -> Cluster {
    let multiplicity = members.len();
    let count = multiplicity as f64;
    // Shares are summed, so that nothing overflows; conjugates cancel exactly in pairs.
    let mut value: C = members.iter().map(|z| z / count).sum();
    if members.iter().map(|z| z.im).filter(|&im| im > 0.0).count()
        == members.iter().map(|z| z.im).filter(|&im| im < 0.0).count()
        && members.iter().all(|z| members.contains(&z.conj()))
    {
        value.im = 0.0;
    }
    let mut diameter = 0.0_f64;
    let mut gap = members.iter().map(|z| z.norm()).fold(f64::INFINITY, f64::min);
    for z in members {
        for w in members {
            diameter = diameter.max((z - w).norm());
        }
        for w in others.clone() {
            gap = gap.min((z - w).norm());
        }
    }
    let stands_apart = multiplicity == 1 || (diameter / gap).powf(count) <= ISOLATION;
    Cluster { root: Multiple { value, multiplicity }, stands_apart }
}
