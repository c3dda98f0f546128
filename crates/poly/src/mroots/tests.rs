//! Tests of the roots: closed forms, planted multiplicities, limits of scale, bad input.

use super::{MrootsMethod, MrootsOptions, Multiplicities, mroots};
use crate::{Complex, Poly, PolyError};
use proptest::prelude::*;

type C = Complex<f64>;

fn c(re: f64, im: f64) -> C {
    C::new(re, im)
}

/// The real polynomial with the given roots and multiplicities; conjugates are added.
fn planted(roots: &[(f64, f64, usize)]) -> Poly<f64> {
    let mut list = Vec::new();
    for &(re, im, multiplicity) in roots {
        for _ in 0..multiplicity {
            list.push(c(re, im));
            if im != 0.0 {
                list.push(c(re, -im));
            }
        }
    }
    Poly::real_from_roots(&list).unwrap()
}

fn with_error(coefficient_error: f64) -> MrootsOptions {
    MrootsOptions { coefficient_error, ..MrootsOptions::default() }
}

/// Expects the planted roots with their multiplicities, each to a relative error.
fn check_planted(roots: &[(f64, f64, usize)], tolerance: f64) {
    check_roots(&planted(roots), &MrootsOptions::default(), roots, tolerance);
}

fn check_roots(
    p: &Poly<f64>,
    options: &MrootsOptions,
    roots: &[(f64, f64, usize)],
    tolerance: f64,
) {
    let found = mroots(p, options).unwrap();
    assert!(found.converged);
    let distinct: usize = roots.iter().map(|r| if r.1 == 0.0 { 1 } else { 2 }).sum();
    assert_eq!(found.roots.len(), distinct, "{roots:?}: {found:#?}");
    for &(re, im, multiplicity) in roots {
        for value in [c(re, im), c(re, -im)] {
            let root = found
                .roots
                .iter()
                .min_by(|a, b| (a.value - value).norm().total_cmp(&(b.value - value).norm()))
                .unwrap();
            let error = (root.value - value).norm() / value.norm();
            assert_eq!(root.multiplicity, multiplicity, "{value}: {found:#?}");
            assert!(error <= tolerance, "{value}: error {error:e}, {root:?}");
        }
    }
}

#[test]
fn constants_and_lines() {
    let options = MrootsOptions::default();
    assert!(mroots(&Poly::constant(3.0), &options).unwrap().roots.is_empty());
    assert_eq!(
        mroots(&Poly::from_descending(&[3.0, -1.5]), &options).unwrap().values(),
        [c(0.5, 0.0)]
    );
    // The root is -b/a, rounded once, also where intermediate values leave the range.
    let root =
        |a: f64, b: f64| mroots(&Poly::from_descending(&[a, b]), &options).unwrap().values()[0];
    assert_eq!(root(3.0, 1.0), c(-1.0 / 3.0, 0.0));
    assert_eq!(root(1e-150, 3e150), c(-3e150 / 1e-150, 0.0));
    assert_eq!(root(3e-300, -1e-305), c(1e-305 / 3e-300, 0.0));
    assert_eq!(root(1e300, 7e300), c(-7e300 / 1e300, 0.0));
}

#[test]
fn quadratics() {
    let options = MrootsOptions::default();
    let roots = |p: [f64; 3]| mroots(&Poly::from_descending(&p), &options).unwrap().values();
    assert_eq!(roots([1.0, -3.0, 2.0]), [c(1.0, 0.0), c(2.0, 0.0)]);
    assert_eq!(roots([1.0, 0.0, 4.0]), [c(0.0, 2.0), c(0.0, -2.0)]);
    assert_eq!(roots([2.0, -4.0, 10.0]), [c(1.0, 2.0), c(1.0, -2.0)]);
    // Cancellation in b^2 - 4ac: the roots are 1e-8 + 1e-24 + ... and 1e8 - 1e-8 - ...
    assert_eq!(roots([1.0, -1e8, 1.0]), [c(1e-8, 0.0), c(99_999_999.999_999_99, 0.0)]);
    // Kahan's example: b^2 and 4ac agree to all digits of a float; the roots are 1 and c/a.
    let p = Poly::from_descending(&[94_906_265.0, -189_812_533.0, 94_906_268.0]);
    let exact =
        MrootsOptions { multiplicities: Multiplicities::AllSimple, ..MrootsOptions::default() };
    assert_eq!(
        mroots(&p, &exact).unwrap().values(),
        [c(1.0, 0.0), c(94_906_268.0 / 94_906_265.0, 0.0)]
    );
    // They are 3e-8 apart: within a few roundings of the coefficients lies a double root at the mean.
    let merged = mroots(&p, &MrootsOptions::default()).unwrap();
    assert_eq!((merged.roots.len(), merged.roots[0].multiplicity), (1, 2));
    assert!(merged.backward_error < 4.0 * f64::EPSILON);
    // Scales at which the discriminant overflows or underflows.
    assert_eq!(roots([1e200, -3e200, 2e200]), [c(1.0, 0.0), c(2.0, 0.0)]);
    assert_eq!(roots([1.0, -3e-160, 2e-320]).len(), 2);
}

#[test]
fn scales() {
    let options = MrootsOptions::default();
    for exponent in [-500, -100, 0, 100, 500] {
        let scale = 2f64.powi(exponent);
        for (p, expected) in [
            (Poly::from_descending(&[1.0, -3.0, 2.0]), vec![c(1.0, 0.0), c(2.0, 0.0)]),
            (Poly::from_descending(&[1.0, -2.0, 1.0]), vec![c(1.0, 0.0); 2]),
            (Poly::from_descending(&[1.0, 0.0, 4.0]), vec![c(0.0, 2.0), c(0.0, -2.0)]),
        ] {
            // c p(x): the same roots.
            assert_eq!(mroots(&p.scale(&scale), &options).unwrap().values(), expected);
            // p(x / s): roots times s, exactly for a power of two.
            if exponent.abs() <= 100 {
                let mut power = 1.0;
                let stretched = p.map(|a| {
                    let value = a * power;
                    power /= scale;
                    value
                });
                let roots = mroots(&stretched, &options).unwrap().values();
                let scaled: Vec<C> = expected.iter().map(|z| z * scale).collect();
                assert_eq!(roots, scaled, "{exponent}");
            }
        }
    }
}

#[test]
fn zeros_at_zero() {
    let p = Poly::from_descending(&[2.0, -2.0, 0.0, 0.0, 0.0]);
    let found = mroots(&p, &MrootsOptions::default()).unwrap();
    assert_eq!(found.roots[0].value, c(0.0, 0.0));
    assert_eq!((found.roots[0].multiplicity, found.roots[0].condition), (3, 0.0));
    assert_eq!((found.roots[1].value, found.roots[1].multiplicity), (c(1.0, 0.0), 1));
    let only = mroots(&Poly::monomial(-7.0, 5), &MrootsOptions::default()).unwrap();
    assert_eq!(only.values(), [c(0.0, 0.0); 5]);
    assert!(only.converged);
}

#[test]
fn vanishing_leading_coefficients() {
    let p = Poly::from_descending(&[1e-18, -1e-17, 1.0, -3.0, 2.0]);
    let mut options = MrootsOptions::default();
    // By default they count: two roots of modulus 1e9.
    let all = mroots(&p, &options).unwrap();
    assert_eq!(all.vanished_leading, 0);
    assert_eq!(all.values().iter().filter(|z| z.norm() > 9e8).count(), 2);
    options.vanishing_leading = 1e-14;
    let few = mroots(&p, &options).unwrap();
    assert_eq!(few.vanished_leading, 2);
    assert_eq!(few.values(), [c(1.0, 0.0), c(2.0, 0.0)]);
}

#[test]
fn roots_of_unity() {
    let mut descending = vec![0.0; 101];
    (descending[0], descending[100]) = (1.0, -1.0);
    let found = mroots(&Poly::from_descending(&descending), &MrootsOptions::default()).unwrap();
    assert_eq!(found.method, MrootsMethod::Simple);
    assert_eq!(found.roots[0].value, c(-1.0, 0.0));
    assert_eq!(found.roots[99].value, c(1.0, 0.0));
    for root in &found.roots {
        assert!((root.value.norm() - 1.0).abs() < 2.3e-16);
        assert!((root.condition - 0.02).abs() < 1e-15, "|z^n| + 1 over n");
    }
}

#[test]
fn wilkinson() {
    let integers: Vec<C> = (1..=20).map(|k| c(f64::from(k), 0.0)).collect();
    let p = Poly::real_from_roots(&integers).unwrap();
    let found = mroots(&p, &MrootsOptions::default()).unwrap();
    assert_eq!(found.method, MrootsMethod::Simple);
    assert!(found.backward_error < 1e-15, "{:e}", found.backward_error);
    let worst = found.roots.iter().map(|r| r.condition).fold(0.0, f64::max);
    assert!(worst > 5e13 && worst < 6e13, "the condition of root 14 is 5.4e13: {worst:e}");
    // Rounding the coefficients moves the roots by up to u times the condition number, and by no more.
    for (root, integer) in found.roots.iter().zip(&integers) {
        let moved = (root.value - integer).norm() / integer.re;
        assert!(moved <= 1.2e-16 * root.condition + 1e-15, "{root:?}");
    }
    // Merging neighbours is not supported by the coefficients, whatever the tolerance.
    for coefficient_error in [1e-15, 1e-13, 1e-11] {
        assert_eq!(mroots(&p, &with_error(coefficient_error)).unwrap().roots.len(), 20);
    }
}

#[test]
fn zeng_multiple_roots() {
    // (x-1)^(4k) (x-2)^(3k) (x-3)^(2k) (x-4)^k: Zeng 2005, where k = 8 gives 14 digits.
    for k in 1..=8 {
        check_planted(
            &[(1.0, 0.0, 4 * k), (2.0, 0.0, 3 * k), (3.0, 0.0, 2 * k), (4.0, 0.0, k)],
            1e-14,
        );
    }
}

#[test]
fn zeng_near_multiple_roots() {
    // (x - 1 + e)^20 (x - 1)^20 (x + 1/2)^5: the condition grows like 1/e.
    for (e, tolerance) in [(0.1, 2e-15), (0.01, 2e-14), (0.001, 2e-13)] {
        check_planted(&[(1.0 - e, 0.0, 20), (1.0, 0.0, 20), (-0.5, 0.0, 5)], tolerance);
    }
}

#[test]
fn zeng_inexact_coefficients() {
    // (x - 10/11)^5 (x - 20/11)^3 (x - 30/11)^2 with coefficients rounded to so many decimals.
    let roots = [(10.0 / 11.0, 0.0, 5), (20.0 / 11.0, 0.0, 3), (30.0 / 11.0, 0.0, 2)];
    for (decimals, error) in [(1e10, 1e-9), (1e9, 1e-8), (1e8, 1e-7), (1e7, 1e-6)] {
        let p = planted(&roots).map(|c| (c * decimals).round() / decimals);
        check_roots(&p, &with_error(error), &roots, 50.0 / decimals);
    }
    // With exact coefficients claimed, the rounded ones have ten simple roots.
    let p = planted(&roots).map(|c| (c * 1e7).round() / 1e7);
    assert_eq!(mroots(&p, &MrootsOptions::default()).unwrap().roots.len(), 10);
}

#[test]
fn conjugate_clusters() {
    check_planted(&[(0.3, 0.6, 3), (0.1, 0.7, 4), (0.7, 0.4, 2), (-2.0, 0.0, 2)], 3e-15);
    check_planted(&[(0.0, 1.0, 2)], 1e-30);
    check_planted(&[(-0.5, 0.01, 3), (-0.5, 0.0, 2)], 1e-11);
    let circle: Vec<(f64, f64, usize)> = (1..=10)
        .map(|k| {
            let z = C::from_polar(0.9, 0.3 * f64::from(k));
            (z.re, z.im, 3)
        })
        .collect();
    check_planted(&circle, 1e-14);
}

#[test]
fn an_exact_double_root_does_not_hide_the_others() {
    // 3 is a double root to all digits, so its first-order uncertainty as two simple roots is unbounded.
    let z = C::from_polar(0.8806913313265604, 1.8745582997352064);
    check_planted(&[(1.3190996338726941, 0.0, 1), (z.re, z.im, 2), (3.0, 0.0, 2)], 1e-15);
}

#[test]
fn multiple_roots_of_all_sizes() {
    check_planted(&[(1e-30, 0.0, 1), (1e-10, 0.0, 2), (1e10, 0.0, 3), (1e30, 0.0, 4)], 1e-15);
    check_planted(&[(1e-25, 0.0, 1), (2e-25, 0.0, 2), (3e-25, 0.0, 3)], 1e-14);
    check_planted(&[(1e49, 0.0, 2), (-1e-50, 0.0, 4)], 1e-15);
}

#[test]
fn complex_coefficients() {
    // (x - j)^3 (x - 2 - j)^2
    let p = Poly::from_roots(&[c(0.0, 1.0), c(0.0, 1.0), c(0.0, 1.0), c(2.0, 1.0), c(2.0, 1.0)]);
    let found = mroots(&p, &MrootsOptions::default()).unwrap();
    assert_eq!(found.roots.len(), 2);
    assert!((found.roots[0].value - c(0.0, 1.0)).norm() < 1e-15);
    assert!((found.roots[1].value - c(2.0, 1.0)).norm() < 1e-15);
    assert_eq!((found.roots[0].multiplicity, found.roots[1].multiplicity), (3, 2));
}

#[test]
fn pejorative_condition() {
    // (x - 1)^20: changes of the coefficients that keep one 20-fold root move it by about 1/7 of their size.
    let found = mroots(&planted(&[(1.0, 0.0, 20)]), &MrootsOptions::default()).unwrap();
    assert_eq!(found.method, MrootsMethod::Pejorative);
    assert!((0.1..0.2).contains(&found.roots[0].condition), "{}", found.roots[0].condition);
    // For simple roots, both definitions agree: x^2 - 3x + 2 has 6/1 at 1 and 16/2 ... over |z|: 12/2 = 6 at 2.
    let simple =
        mroots(&Poly::from_descending(&[1.0, -3.0, 2.0]), &MrootsOptions::default()).unwrap();
    assert_eq!((simple.roots[0].condition, simple.roots[1].condition), (6.0, 6.0));
}

#[test]
fn simple_on_request() {
    let p = planted(&[(1.0, 0.0, 3)]);
    let options =
        MrootsOptions { multiplicities: Multiplicities::AllSimple, ..MrootsOptions::default() };
    let found = mroots(&p, &options).unwrap();
    assert_eq!(found.method, MrootsMethod::Simple);
    assert_eq!(found.values().len(), 3);
    assert!(found.roots.iter().all(|root| (root.value - 1.0).norm() < 1e-9));
}

#[test]
fn bad_input() {
    let options = MrootsOptions::default();
    assert_eq!(mroots(&Poly::<f64>::zero(), &options), Err(PolyError::ZeroPolynomial));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = mroots(&Poly::new(vec![1.0, bad, 2.0]), &options);
        assert!(
            matches!(error, Err(PolyError::NonFiniteCoefficient { degree: 1, .. })),
            "{error:?}"
        );
    }
    // A root of modulus 1e400.
    let error = mroots(&Poly::new(vec![1e200, 1e-200]), &options);
    assert!(matches!(error, Err(PolyError::RootOutOfRange { .. })), "{error:?}");
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let error = mroots(&Poly::new(vec![1.0, 1.0]), &with_error(bad));
        assert!(matches!(error, Err(PolyError::InvalidTolerance { .. })), "{error:?}");
    }
    let none = MrootsOptions { maximum_iterations: 0, ..MrootsOptions::default() };
    assert!(!mroots(&Poly::new(vec![1.0, 1.0, 5.0]), &none).unwrap().converged);
}

#[test]
fn the_same_every_time() {
    let p = planted(&[(0.3, 0.6, 3), (0.99, 0.1, 1), (1.0, 0.0, 2), (-0.4, 0.0, 1)]);
    assert_eq!(mroots(&p, &MrootsOptions::default()), mroots(&p, &MrootsOptions::default()));
}

/// Roots near the unit circle, some of them nearly repeated.
fn near_circle() -> impl Strategy<Value = Vec<C>> {
    let root = (0.9..1.1_f64, 0.05..3.09_f64, 0..3_u8, -7.0..-3.0_f64);
    proptest::collection::vec(root, 1..5).prop_map(|list| {
        let mut roots = Vec::new();
        for (radius, angle, kind, exponent) in list {
            let z = C::from_polar(radius, angle);
            match kind {
                0 => roots.push(c(radius * angle.cos().signum(), 0.0)),
                1 => roots.extend([z, z.conj()]),
                _ => {
                    let near = z * (1.0 + 10f64.powf(exponent));
                    roots.extend([z, z.conj(), near, near.conj()]);
                }
            }
        }
        roots
    })
}

proptest! {
    /// The expanded roots reproduce the coefficients, and planted roots lie within what the condition allows.
    #[test]
    fn planted_near_repeated_roots(roots in near_circle()) {
        let p = Poly::real_from_roots(&roots).unwrap();
        let found = mroots(&p, &MrootsOptions::default()).unwrap();
        prop_assert!(found.converged);
        prop_assert_eq!(found.values().len(), roots.len());
        prop_assert!(found.backward_error < 1e-14, "{:e}", found.backward_error);
        for z in &roots {
            let near = found.roots.iter().map(|root| {
                let reach = 4e-16 * root.condition * root.multiplicity as f64 + 1e-15;
                (root.value - z).norm() / reach
            });
            let near = near.fold(f64::INFINITY, f64::min);
            // Merged pairs are as far from the planted ones as half a root of the error may bring them.
            prop_assert!(near < 1.0 || found.method == MrootsMethod::Pejorative, "{}: {} in {:#?}", z, near, found);
        }
    }

    /// Planted multiplicities are found, with roots at the pejorative condition limit.
    #[test]
    fn planted_multiplicities(
        real in -2.0..2.0_f64,
        pair in (0.5..1.2_f64, 0.4..2.7_f64),
        counts in (1..5_usize, 1..4_usize, 1..3_usize),
    ) {
        let z = C::from_polar(pair.0, pair.1);
        // Keep the roots apart, the point here is multiplicity.
        prop_assume!((z - real).norm() > 0.3 && real.abs() > 0.1 && (real - 3.0).abs() > 0.3);
        let p = planted(&[(real, 0.0, counts.0), (z.re, z.im, counts.1), (3.0, 0.0, counts.2)]);
        let found = mroots(&p, &MrootsOptions::default()).unwrap();
        prop_assert_eq!(found.roots.len(), 4, "{:#?}", found);
        for (value, multiplicity) in [(c(real, 0.0), counts.0), (z, counts.1), (z.conj(), counts.1), (c(3.0, 0.0), counts.2)] {
            let root = found.roots.iter().min_by(|a, b| (a.value - value).norm().total_cmp(&(b.value - value).norm())).unwrap();
            prop_assert_eq!(root.multiplicity, multiplicity);
            let error = (root.value - value).norm() / value.norm();
            prop_assert!(error <= 4e-16 * (1.0 + root.condition), "{:e} for {:?}", error, root);
        }
    }

    /// Measured coefficients: with the right error level the multiplicities are found, and the roots are as good as
    /// their condition says.
    #[test]
    fn planted_multiplicities_under_noise(
        real in 0.2..2.0_f64,
        pair in (0.5..1.2_f64, 1.7..2.7_f64),
        counts in (1..5_usize, 1..3_usize),
        noise in proptest::collection::vec(-1.0..1.0_f64, 9),
        level in -11.0..-8.0_f64,
    ) {
        let level = 10f64.powf(level);
        let z = C::from_polar(pair.0, pair.1);
        let exact = planted(&[(real, 0.0, counts.0), (z.re, z.im, counts.1)]);
        let p = Poly::new(exact.coefficients().iter().zip(&noise).map(|(c, r)| c * (1.0 + level * r)).collect());
        let found = mroots(&p, &with_error(level)).unwrap();
        prop_assert_eq!(found.roots.len(), 3, "{:#?}", found);
        for (value, multiplicity) in [(c(real, 0.0), counts.0), (z, counts.1), (z.conj(), counts.1)] {
            let root = found.roots.iter().find(|root| (root.value - value).norm() < 1e-3).unwrap();
            prop_assert_eq!(root.multiplicity, multiplicity);
            let error = (root.value - value).norm() / value.norm();
            prop_assert!(error <= 1.01 * level * root.condition + 1e-15, "{:e} for {:?}", error, root);
        }
    }

    /// Any finite coefficients give as many roots as the degree, or an error; nothing panics.
    #[test]
    fn any_coefficients(coefficients in proptest::collection::vec(proptest::num::f64::NORMAL | proptest::num::f64::ZERO | proptest::num::f64::SUBNORMAL, 0..12)) {
        let p = Poly::new(coefficients);
        match mroots(&p, &MrootsOptions::default()) {
            Ok(found) => {
                prop_assert_eq!(Some(found.values().len()), p.degree());
                prop_assert!(found.values().iter().all(|z| z.re.is_finite() && z.im.is_finite()));
            }
            Err(error) => prop_assert!(matches!(error, PolyError::ZeroPolynomial | PolyError::RootOutOfRange { .. }), "{}", error),
        }
    }
}
