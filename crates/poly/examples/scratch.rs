//! scratch
use poly::*;
use std::io::Write;
fn show(name: &str, p: &Poly<f64>, tol: f64) {
    let mut o = std::io::stdout().lock();
    let mut opt = MrootsOptions::default();
    opt.coefficient_error = tol;
    let t = std::time::Instant::now();
    let m = mroots(p, &opt).unwrap();
    writeln!(
        o,
        "== {name} {:?} back {:.2e} it {} conv {} {:?}",
        m.method,
        m.backward_error,
        m.iterations,
        m.converged,
        t.elapsed()
    )
    .unwrap();
    for r in &m.roots {
        writeln!(
            o,
            "   {:.17} m{} res {:.1e} cond {:.2e} err {:.1e}",
            r.value, r.multiplicity, r.residual, r.condition, r.error_estimate
        )
        .unwrap();
    }
}
fn rep(l: &[(f64, f64, usize)]) -> Poly<f64> {
    let mut v = vec![];
    for &(a, b, m) in l {
        for _ in 0..m {
            v.push(Complex::new(a, b));
            if b != 0.0 {
                v.push(Complex::new(a, -b));
            }
        }
    }
    Poly::real_from_roots(&v).unwrap()
}
fn main() {
    let e = f64::EPSILON;
    show("dbl", &Poly::from_descending(&[1., -2., 1.]), 4. * e);
    show("x2-2+", &Poly::from_descending(&[1., 0., 2., 0., 1.]), 4. * e);
    show("(x-1)^7", &Poly::from_roots(&[1.0; 7]), 4. * e);
    show("(x-.1)^5(x-.3)^3", &Poly::from_roots(&[0.1, 0.1, 0.1, 0.1, 0.1, 0.3, 0.3, 0.3]), 4. * e);
    show("zeng k=1", &rep(&[(1., 0., 4), (2., 0., 3), (3., 0., 2), (4., 0., 1)]), 4. * e);
    show("zeng k=5", &rep(&[(1., 0., 20), (2., 0., 15), (3., 0., 10), (4., 0., 5)]), 4. * e);
    show("near .1", &rep(&[(0.9, 0., 20), (1., 0., 20), (-0.5, 0., 5)]), 4. * e);
    show("inexact", &rep(&[(10. / 11., 0., 5), (20. / 11., 0., 3), (30. / 11., 0., 2)]), 4. * e);
    show("conj", &rep(&[(0.3, 0.6, 3), (0.1, 0.7, 4), (0.7, 0.4, 2), (-2.0, 0., 2)]), 4. * e);
    show("(x-1)^20", &rep(&[(1., 0., 20)]), 4. * e);
    let mut w = vec![];
    for k in 1..=20 {
        w.push(Complex::new(k as f64, 0.0));
    }
    show("W20", &Poly::real_from_roots(&w).unwrap(), 4. * e);
    let air = [
        [
            0.6906440710552105,
            -4.05982359385132,
            9.962354672244818,
            -13.062468527299336,
            9.651879761575605,
            -3.8105190830713336,
            0.6279326993463553,
        ],
        [
            -0.033328348944732286,
            0.19546128243380537,
            -0.4784430167887857,
            0.6256435968153042,
            -0.46095963230101994,
            0.18142435333801096,
            -0.029798234532190666,
        ],
    ];
    for a in &air {
        for t in [4., 8., 16., 32., 64., 256.] {
            show(&format!("air {t}"), &Poly::from_descending(a), t * e);
        }
    }
}
