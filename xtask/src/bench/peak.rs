//! The machine's peak: how many fused multiply-adds one core does in a second when nothing else is
//! in their way.

use std::hint::black_box;

use pulp::{Arch, Simd, WithSimd};

use super::timing::{Runs, measure};
use crate::TaskError;

/// Chains of dependent multiply-adds side by side. Latency times throughput is 8 to 10 on present
/// processors; 12 and the two constants just fit the 16 registers of AVX2.
const CHAINS: usize = 12;
/// Links of each chain in one run.
const LINKS: u32 = 2_000_000;

/// What the peak is, and of what.
#[derive(Clone, Debug)]
pub(crate) struct Peak {
    /// Floating-point operations in a second; a fused multiply-add counts as two.
    pub(crate) flops: f64,
    /// Doubles in a vector register.
    pub(crate) lanes: usize,
    /// The instruction set that the dispatch picked.
    pub(crate) instruction_set: &'static str,
}

/// Measures the peak of one core: the fastest run, since whatever slows a run down makes it no
/// peak.
pub(crate) fn fma_peak() -> Result<Peak, TaskError> {
    let arch = Arch::new();
    let timing = measure(Runs::MANY, || Ok(arch.dispatch(Chains)))?;
    let (_, lanes) = arch.dispatch(Chains);
    let flops = 2.0 * lanes as f64 * CHAINS as f64 * f64::from(LINKS) / timing.fastest();
    Ok(Peak { flops, lanes, instruction_set: instruction_set(lanes) })
}

fn instruction_set(lanes: usize) -> &'static str {
    match (cfg!(target_arch = "x86_64"), lanes) {
        (true, 8) => "AVX-512",
        (true, 4) => "AVX2 with FMA",
        (_, 1) => "scalar",
        (false, 2) => "128-bit vectors",
        _ => "unknown",
    }
}

/// x = a x + b in each chain. With a just below one the values stay near b / (1 - a) = 1: nothing
/// overflows, nothing is subnormal.
struct Chains;

impl WithSimd for Chains {
    /// Something made of all chains, and the lanes of a register.
    type Output = (f64, usize);

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let a = simd.splat_f64s(black_box(1.0 - 1e-7));
        let b = simd.splat_f64s(black_box(1e-7));
        let mut chains = [simd.splat_f64s(black_box(1.0)); CHAINS];
        for _ in 0..LINKS {
            for chain in &mut chains {
                *chain = simd.mul_add_f64s(*chain, a, b);
            }
        }
        let sum = chains.into_iter().reduce(|sum, chain| simd.add_f64s(sum, chain));
        (sum.map_or(0.0, |sum| simd.reduce_sum_f64s(sum)), S::F64_LANES)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_chains_do_the_arithmetic_that_is_counted() {
        let (sum, lanes) = Arch::new().dispatch(Chains);
        let count = (lanes * CHAINS) as f64;
        // Every chain stays at its fixed point, 1.
        assert!((sum / count - 1.0).abs() < 1e-6, "{sum} over {lanes} lanes");
    }
}
