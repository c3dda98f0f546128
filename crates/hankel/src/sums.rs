//! Sums of products of two channels, each in units of two to the sum of the channels' exponents.

use doubled::{DoubleDouble, power_of_two};

use crate::{
    kernel::{BLOCK, CHUNK_ERROR},
    plan::{Owners, Plan},
    tile::TileSums,
};

/// Running sums. The exponent of a channel only grows; what is there is scaled down then, which is exact.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sums {
    /// One for each channel: 2^exponent is above every modulus so far.
    pub(crate) exponents: Vec<i32>,
    /// Whether a channel has had a sample other than zero, so that its exponent means something.
    pub(crate) seen: Vec<bool>,
    /// Lag products (of a plan's sums or of its entries), each with the channels that it belongs to.
    pub(crate) products: Vec<DoubleDouble>,
    /// Sums of single channels (of channels or of columns).
    pub(crate) plain: Vec<DoubleDouble>,
    /// Squared standard deviation of the rounding, for each pair of channels of the plan.
    pub(crate) variances: Vec<f64>,
}

impl Sums {
    /// Nothing summed yet.
    pub(crate) fn new(channels: usize, owners: Owners<'_>) -> Self {
        Self {
            exponents: vec![0; channels],
            seen: vec![false; channels],
            products: vec![DoubleDouble::ZERO; owners.products.len()],
            plain: vec![DoubleDouble::ZERO; owners.plain.len()],
            variances: vec![0.0; owners.pairs.len()],
        }
    }

    /// Makes room for samples below 2^exponent in modulus; `None` for a channel without any but zeros.
    pub(crate) fn raise(&mut self, exponents: &[Option<i32>], owners: Owners<'_>) {
        let mut steps = vec![0; self.exponents.len()];
        for (channel, new) in exponents.iter().enumerate() {
            let Some(new) = *new else { continue };
            if !self.seen[channel] {
                (self.seen[channel], self.exponents[channel]) = (true, new);
            } else if new > self.exponents[channel] {
                steps[channel] = new - self.exponents[channel];
                self.exponents[channel] = new;
            }
        }
        if steps.iter().all(|step| *step == 0) {
            return;
        }
        let down = |x: DoubleDouble, step: i32| times(x, power_of_two(-step));
        for (product, (a, b)) in self.products.iter_mut().zip(owners.products) {
            *product = down(*product, steps[*a] + steps[*b]);
        }
        for (sum, channel) in self.plain.iter_mut().zip(owners.plain) {
            *sum = down(*sum, steps[*channel]);
        }
        for (variance, (a, b)) in self.variances.iter_mut().zip(owners.pairs) {
            *variance *= power_of_two(-2 * (steps[*a] + steps[*b]));
        }
    }

    /// Adds a tile.
    pub(crate) fn add_tile(&mut self, tile: &TileSums, plan: &Plan) {
        let owners = plan.sum_owners();
        self.raise(&tile.y_exponents, owners);
        let down = |exponents: &[Option<i32>]| -> Vec<i32> {
            let own = exponents.iter().zip(&self.exponents);
            own.map(|(tile, own)| tile.map_or(0, |tile| tile - own)).collect()
        };
        let (x, y) = (down(&tile.x_exponents), down(&tile.y_exponents));
        for (index, pair) in plan.pairs.iter().enumerate() {
            let factor = power_of_two(x[pair.x] + y[pair.y]);
            for i in pair.offset..pair.offset + pair.blocks.len() * BLOCK {
                let sum = DoubleDouble::sum(tile.high[i] * factor, tile.low[i] * factor);
                self.products[i] += sum;
            }
            self.variances[index] += tile.chunks * (CHUNK_ERROR * factor).powi(2);
        }
        for (channel, sum) in self.plain.iter_mut().enumerate() {
            let factor = power_of_two(x[channel]);
            for part in 0..BLOCK {
                let high = tile.channel_high[channel][part] * factor;
                *sum += DoubleDouble::sum(high, tile.channel_low[channel][part] * factor);
            }
        }
    }

    /// Adds sums of the same kind.
    pub(crate) fn add(&mut self, other: &Self, owners: Owners<'_>) {
        let exponents: Vec<Option<i32>> = other
            .exponents
            .iter()
            .zip(&other.seen)
            .map(|(exponent, seen)| seen.then_some(*exponent))
            .collect();
        self.raise(&exponents, owners);
        let down: Vec<f64> = exponents
            .iter()
            .zip(&self.exponents)
            .map(|(other, own)| power_of_two(other.unwrap_or(*own) - own))
            .collect();
        for ((sum, new), (a, b)) in
            self.products.iter_mut().zip(&other.products).zip(owners.products)
        {
            *sum += times(times(*new, down[*a]), down[*b]);
        }
        for ((sum, new), channel) in self.plain.iter_mut().zip(&other.plain).zip(owners.plain) {
            *sum += times(*new, down[*channel]);
        }
        for ((sum, new), (a, b)) in
            self.variances.iter_mut().zip(&other.variances).zip(owners.pairs)
        {
            *sum += new * (down[*a] * down[*b]).powi(2);
        }
    }
}

/// A double-double times a power of two.
pub(crate) fn times(x: DoubleDouble, power: f64) -> DoubleDouble {
    DoubleDouble::sum(x.high() * power, x.low() * power)
}

#[cfg(test)]
mod tests;
