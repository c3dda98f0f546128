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
    cases
}

/// Every root is found to a few units in the last place of the exact root of the given coefficients, as long as
/// the condition number stays far below 1 / u^2; conditions agree with the reference, estimates cover the error.
#[test]
fn simple_roots_to_the_last_places() {
    let mut options = MrootsOptions::default();
    options.multiplicities = Multiplicities::AllSimple;
    let mut report = String::new();
    for case in cases() {
        let found = mroots(&Poly::new(case.coefficients.clone()), &options).expect(case.name);
        assert!(found.converged, "{}: no convergence", case.name);
        assert_eq!(found.values().len(), case.roots.len(), "{}", case.name);
        let mut rest = found.roots.clone();
        let (mut worst, mut worst_condition): (f64, f64) = (0.0, 1.0);
        for &(value, condition) in &case.roots {
            // Scaled before the modulus is taken: it may be 1e-307.
            let size = value.re.abs().max(value.im.abs());
            let distance = |z: Complex<f64>| ((z - value) / size).norm();
            let nearest = (0..rest.len())
                .min_by(|&i, &j| distance(rest[i].value).total_cmp(&distance(rest[j].value)))
                .expect("as many roots as expected");
            let root = rest.swap_remove(nearest);
            let error = distance(root.value);
            worst = worst.max(error);
            worst_condition =
                worst_condition.max((root.condition / condition).max(condition / root.condition));
            if error > 4e-16
                || (root.condition / condition - 1.0).abs() > 1e-3
                || root.error_estimate < error * size
            {
                report += &format!(
                    "{}: root {value}, found {}, relative error {error:.1e}, estimate {:.1e}, condition {:.3e} for {condition:.3e}\n",
                    case.name, root.value, root.error_estimate, root.condition
                );
            }
        }
        report += &format!(
            "# {:32} {worst:.1e} {worst_condition:.6} iterations {}\n",
            case.name, found.iterations
        );
    }
    panic!("{report}");
}
