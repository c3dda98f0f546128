//! Roots against high-precision references; `data/make_roots.py` made them.

use poly::{Complex, MrootsOptions, Multiplicities, Poly, mroots};

struct Case {
    name: &'static str,
    coefficients: Vec<Complex<f64>>,
    /// Root and condition number.
    roots: Vec<(Complex<f64>, f64)>,
}

fn cases() -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    for line in include_str!("data/roots.txt").lines() {
        let (key, rest) = line.split_once(' ').expect("every line has a key");
        let numbers = || rest.split(' ').map(|text| text.parse::<f64>().expect("a number"));
        if key == "case" {
            cases.push(Case { name: rest, coefficients: Vec::new(), roots: Vec::new() });
            continue;
        }
        let case = cases.last_mut().expect("a case comes first");
        match key {
            "real" => case.coefficients = numbers().map(|c| Complex::new(c, 0.0)).collect(),
            "complex" => {
                let parts: Vec<f64> = numbers().collect();
                case.coefficients = parts.chunks(2).map(|c| Complex::new(c[0], c[1])).collect();
            }
            "root" => {
                let parts: Vec<f64> = numbers().collect();
                case.roots.push((Complex::new(parts[0], parts[1]), parts[2]));
            }
            other => panic!("unknown key {other}"),
        }
    }
    assert_eq!(cases.len(), 28);
    cases
}

/// Every root is the float nearest to the exact root of the given coefficients, or a neighbour of it; condition
/// numbers agree with the reference to the four digits printed there, and estimates cover the error.
#[test]
fn simple_roots_to_the_last_place() {
    let mut options = MrootsOptions::default();
    options.multiplicities = Multiplicities::AllSimple;
    let mut failures = String::new();
    for Case { name, coefficients, roots } in cases() {
        let found = mroots(&Poly::new(coefficients), &options).expect(name);
        assert!(found.converged, "{name}: no convergence");
        assert_eq!(found.values().len(), roots.len(), "{name}");
        let mut rest = found.roots.clone();
        for (value, condition) in roots {
            // Scaled before the modulus is taken: it may be 1e-307.
            let size = value.re.abs().max(value.im.abs());
            let distance = |z: Complex<f64>| ((z - value) / size).norm();
            let nearest = (0..rest.len())
                .min_by(|&i, &j| distance(rest[i].value).total_cmp(&distance(rest[j].value)))
                .expect("as many roots as expected");
            let root = rest.swap_remove(nearest);
            let error = distance(root.value);
            let condition_error = (root.condition / condition - 1.0).abs();
            let covered = root.error_estimate / size + 1.2e-16 >= error;
            if error > 2.3e-16 || condition_error > 1e-3 || !covered {
                failures += &format!("{name}: {root:?} for {value}, condition {condition:e}\n");
            }
        }
    }
    assert!(failures.is_empty(), "{failures}");
}

/// None of the references has multiple roots, although some pairs are 1e-6 apart: the default options agree.
#[test]
fn resolved_roots_are_not_merged() {
    for Case { name, coefficients, .. } in cases() {
        let p = Poly::new(coefficients);
        let mut options = MrootsOptions::default();
        let detected = mroots(&p, &options).expect(name);
        options.multiplicities = Multiplicities::AllSimple;
        assert_eq!(detected, mroots(&p, &options).expect(name), "{name}");
        assert!(detected.backward_error < 3e-15, "{name}: {:e}", detected.backward_error);
    }
}

/// The roots of real polynomials are exactly real or exactly conjugate, neighbours in the list and in order.
#[test]
fn real_polynomials_have_conjugate_roots_in_order() {
    for Case { name, coefficients, .. } in cases() {
        if coefficients.iter().any(|c| c.im != 0.0) {
            continue;
        }
        let p = Poly::new(coefficients.iter().map(|c| c.re).collect());
        let roots = mroots(&p, &MrootsOptions::default()).expect(name).roots;
        let mut k = 0;
        while k < roots.len() {
            let root = roots[k].value;
            if root.im != 0.0 {
                assert!(root.im > 0.0, "{name}: positive imaginary part first");
                assert_eq!(roots[k + 1].value, root.conj(), "{name}");
                k += 1;
            }
            k += 1;
        }
        assert!(roots.windows(2).all(|pair| pair[0].value.re <= pair[1].value.re), "{name}");
    }
}
