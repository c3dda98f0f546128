use pulp::{Arch, Scalar, WithSimd};

use super::*;

/// The sums of a small tile, each vector width the machine has.
fn sums(run: impl Fn(LagProducts<'_>)) -> Vec<u64> {
    let value = |k: usize| ((k * k + 3 * k) % 97) as f64 / 97.0 - 0.4;
    let (length, span) = (300, 40);
    let mut x = vec![0.0; FRONT + TILE + BACK];
    (0..length).for_each(|m| x[FRONT + m] = value(m));
    let y: Vec<f64> = (0..TILE + 2 * span + SLACK).map(|k| value(k + 5)).collect();
    let blocks = [-40, -32, -20, 0, 8, 16, 24, 33];
    let mut high = vec![0.25; blocks.len() * BLOCK];
    let mut low = vec![1e-20; blocks.len() * BLOCK];
    run(LagProducts {
        x: &x,
        y: &y,
        origin: span,
        length,
        blocks: &blocks,
        high: &mut high,
        low: &mut low,
    });
    high.iter().chain(&low).map(|x| x.to_bits()).collect()
}

#[test]
fn the_width_of_the_vectors_makes_no_difference() {
    let scalar = sums(|products| products.with_simd(Scalar));
    assert_eq!(sums(|products| Arch::new().dispatch(products)), scalar);
    #[cfg(target_arch = "x86_64")]
    if let Some(v3) = pulp::x86::V3::try_new() {
        assert_eq!(sums(|products| Simd::vectorize(v3, products)), scalar);
    }
}

#[test]
fn a_plain_sum_keeps_what_cancels() {
    let mut numbers = vec![0.5; 64];
    numbers[3] = 1e-20;
    (32..64).for_each(|i| numbers[i] = -0.5);
    numbers[60] = 0.5e-20;
    let (mut high, mut low) = ([0.0; BLOCK], [0.0; BLOCK]);
    Arch::new().dispatch(PlainSum { numbers: &numbers, high: &mut high, low: &mut low });
    // One half too many negative, one too many positive, and the two small numbers.
    let total: f64 = high.iter().sum::<f64>() + low.iter().sum::<f64>();
    assert!((total - 1.5e-20).abs() < 1e-34, "{total:e}");
}
