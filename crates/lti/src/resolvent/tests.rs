//! Tests of `resolvent.rs`.

use nalgebra::dmatrix;
use num_bigint::BigInt;
use num_rational::BigRational;
use poly::PolyMatrix;

use super::*;

fn ratio(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(BigInt::from(numerator), BigInt::from(denominator))
}

fn rational(text: &[(i64, i64)]) -> Poly<BigRational> {
    let list: Vec<BigRational> = text.iter().map(|&(n, d)| ratio(n, d)).collect();
    Poly::from_descending(&list)
}

#[test]
fn example_4_2_of_the_paper_is_exact() {
    // (26), (27): entries in ten-thousandths.
    let a = DMatrix::from_row_slice(
        4,
        4,
        &[-7000, 2300, 2390, 546, 10000, 0, 0, 0, 0, 10000, 0, 0, 0, 0, 10000, 0],
    );
    let a = a.map(|x: i64| ratio(x, 10000));
    let whole = |m: DMatrix<i64>| m.map(|x| ratio(x, 1));
    let b = whole(dmatrix![1, 0; 1, 0; 4, 1; 0, 1]);
    let c = whole(dmatrix![1, 2, 3, 0; 8, 1, 1, 0; 1, 3, 1, 6]);
    let found = resolvent_numerators(&a, &b, &c, &whole(DMatrix::zeros(3, 2))).expect("fits");
    // 60-digit rationals of the workspace's reference.json.
    let wanted = [
        [
            &[(15, 1), (7993, 500), (23547, 5000), (2457, 5000)],
            &[(3, 1), (1496, 625), (-241, 5000), (273, 1000)],
        ],
        [
            &[(13, 1), (3747, 250), (3372, 625), (819, 1250)],
            &[(1, 1), (3811, 1250), (1251, 2500), (273, 2500)],
        ],
        [
            &[(8, 1), (17043, 500), (134_527, 5000), (26949, 5000)],
            &[(7, 1), (6996, 625), (17627, 5000), (-6489, 2500)],
        ],
    ];
    for (i, row) in wanted.iter().enumerate() {
        for (j, gamma) in row.iter().enumerate() {
            assert_eq!(found.numerators[i][j], rational(*gamma), "{i} {j}");
        }
    }
    // delta = (p - 0.6)(p + 0.7)((p + 0.3)^2 + 0.04)
    let factors = [
        rational(&[(1, 1), (-3, 5)]),
        rational(&[(1, 1), (7, 10)]),
        rational(&[(1, 1), (3, 5), (13, 100)]),
    ];
    assert_eq!(found.delta, factors[0].clone() * factors[1].clone() * factors[2].clone());
}

#[test]
fn numerators_are_bordered_determinants() {
    // c adj(pI - A) b + d delta = det [pI - A, -b; c, d], over the integers.
    let mut state = 7_u64;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i64::try_from(state >> 60).expect("four bits") - 8
    };
    for n in 0..=5 {
        let a = DMatrix::from_fn(n, n, |_, _| next());
        let b = DMatrix::from_fn(n, 1, |_, _| next());
        let c = DMatrix::from_fn(1, n, |_, _| next());
        let d = dmatrix![next()];
        let mut entries = Vec::new();
        for i in 0..=n {
            for j in 0..=n {
                entries.push(match (i < n, j < n) {
                    (true, true) => Poly::new(vec![-a[(i, j)], i64::from(i == j)]),
                    (true, false) => Poly::constant(-b[i]),
                    (false, true) => Poly::constant(c[j]),
                    (false, false) => Poly::constant(d[0]),
                });
            }
        }
        let determinant =
            PolyMatrix::new(n + 1, n + 1, entries).and_then(|m| m.determinant()).expect("square");
        let found = resolvent_numerators(&a, &b, &c, &d).expect("fits").numerators;
        assert_eq!(found, [[determinant]], "order {n}");
    }
}

#[test]
fn no_states() {
    let empty = DMatrix::<i64>::zeros(0, 0);
    let found =
        resolvent_numerators(&empty, &DMatrix::zeros(0, 1), &DMatrix::zeros(1, 0), &dmatrix![5])
            .expect("fits");
    assert_eq!((found.delta, found.numerators[0][0].clone()), (Poly::one(), Poly::constant(5)));
}

#[test]
fn shapes() {
    let a = DMatrix::<i64>::identity(2, 2);
    let [zeros_1_2, zeros_2_1] = [DMatrix::zeros(1, 2), DMatrix::zeros(2, 1)];
    let check = |error: LtiError, wanted: &str| assert_eq!(error.to_string(), wanted);
    check(
        resolvent_numerators(&zeros_1_2, &zeros_2_1, &zeros_1_2, &dmatrix![0]).expect_err("A"),
        "A is 1 x 2; a square matrix is needed",
    );
    check(
        resolvent_numerators(&a, &zeros_2_1, &zeros_1_2, &zeros_1_2).expect_err("D"),
        "D is 1 x 2; 1 x 1 is needed",
    );
    check(check_vectors(2, &[1], &[1, 1]).expect_err("b"), "b is 1 x 1; 2 x 1 is needed");
    check(check_vectors(2, &[1, 1], &[1]).expect_err("c"), "c is 1 x 1; 1 x 2 is needed");
}
