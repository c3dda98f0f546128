//! How far records are sampled faster than anything in them moves.
//!
//! At 500 Hz a mode below 1 Hz hardly moves from sample to sample: the signal subspaces, which look at some tens of samples, see free motion and noise, and an excitation only where
//! it jumps. Where the sensors show nothing but noise beyond some frequency, samples beyond it say nothing of the system, and a record of every K-th sample behind a low-pass filter
//! says as much and says it better.
//!
//! The spectrum of each channel is estimated by Welch's method. Noise is what the upper half of the frequencies has. What has to be kept of a channel ends
//!
//! - twice as high as the highest band that stands clearly above the noise; or
//! - where white noise moves the controls and its response falls off slowly, 40 times as high as the frequency below which nine tenths of its power lie, and twice as high as that below
//!   which all but 1/200 does,
//!
//! whichever is lower. Where the upper half itself falls off by much, as in records without noise, the first is the Nyquist frequency: then samples are so good that the excitation shows between any two
//! of them.
//!
//! Source: P. D. Welch, "The use of fast Fourier transform for the estimation of power spectra", IEEE Transactions on Audio and Electroacoustics 15 (1967).

use std::num::NonZero;

use realfft::RealFftPlanner;
use reconstruct::Record;

use super::source::Source;

/// The longest stretch that is transformed at once, in samples.
const LONGEST: usize = 32_768;
/// A record has so many stretches side by side at least, and nearly twice as many that overlap by half.
const STRETCHES: usize = 4;
/// The shortest stretch that tells a band of signals from the noise beyond it.
const SHORTEST: usize = 256;
/// Neighbouring frequencies that are averaged.
const BAND: usize = 8;
/// A band with more than so many times the noise's power holds a signal. Estimated from some forty numbers, noise alone does not come near.
const ABOVE_NOISE: f64 = 2.0;

/// How far beyond the highest signal there may be more of it: a mode may show less than the noise in one band, but in all of them.
const MARGIN: f64 = 2.0;
/// Parts of a channel's power, and how many times as high as the frequencies below which they lie the rest may begin.
const POWERS: [(f64, f64); 2] = [(0.9, 40.0), (0.995, 2.0)];
/// The filter passes up to this part of the new Nyquist frequency.
const PASSED: f64 = 0.8;
/// A smaller factor is no gain.
const LEAST: usize = 4;
/// Samples that a record keeps.
const KEPT: usize = 500;

/// Records that are sampled too fast.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Oversampled {
    /// Every how many samples one is enough.
    pub(crate) factor: NonZero<usize>,
    /// What the records have of all that moves in them ends here, in Hz.
    pub(crate) highest_hz: f64,
}

/// Whether all records are sampled too fast, and how much; they have one sample period. Of the stretches between the gaps of a record one has to be long enough.
pub(crate) fn oversampled(records: &[Record], sources: &[Source]) -> Option<Oversampled> {
    let first = records.first()?;
    let mut highest = 0.0_f64;
    let mut samples = usize::MAX;
    for whole in 0..=sources.last()?.whole {
        let stretches = records.iter().zip(sources).filter(|(_, source)| source.whole == whole);
        let (longest, _) = stretches.max_by_key(|(record, _)| record.samples())?;
        samples = samples.min(longest.samples());
        for channel in longest.channels() {
            highest = highest.max(needed(&channel.values)?);
        }
    }
    let by_length = samples / KEPT;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a number of samples, from 0 to the length of a record"
    )]
    let by_band = (PASSED / highest).min(samples as f64) as usize;
    let factor = NonZero::new(by_band.min(by_length)).filter(|factor| factor.get() >= LEAST)?;
    let passed = PASSED / factor.get() as f64;
    Some(Oversampled { factor, highest_hz: 0.5 * passed / first.period().seconds() })
}

/// How high the frequencies reach that have to be kept of a channel, as a part of the Nyquist frequency; `None` where that cannot be told.
fn needed(values: &[f64]) -> Option<f64> {
    let length = previous_power_of_two(values.len() / STRETCHES).min(LONGEST);
    if length < SHORTEST {
        return None;
    }
    let power = spectrum(values, length)?;
    let bands: Vec<f64> =
        power.chunks_exact(BAND).map(|band| band.iter().sum::<f64>() / BAND as f64).collect();
    let mut upper = bands[bands.len() / 2..].to_vec();
    let middle = upper.len() / 2;
    let noise = *upper.select_nth_unstable_by(middle, f64::total_cmp).1;
    if noise <= 0.0 {
        return None;
    }
    let highest = bands.iter().rposition(|power| *power > ABOVE_NOISE * noise).unwrap_or(0);
    let by_noise = MARGIN * (highest + 1) as f64 / bands.len() as f64;
    let signal = || power.iter().map(|own| (own - noise).max(0.0));
    let whole: f64 = signal().sum();
    let below = |part: f64| {
        let mut left = part * whole;
        let end = signal().position(|own| {
            left -= own;
            left <= 0.0
        });
        (end.unwrap_or(power.len()) + 1) as f64 / power.len() as f64
    };
    let by_power = POWERS.map(|(part, times)| times * below(part));
    Some(by_noise.min(by_power[0].max(by_power[1])).min(1.0))
}

/// The power at the frequencies from the lowest above zero to half the sampling frequency, without what a straight line from end to end explains.
fn spectrum(values: &[f64], length: usize) -> Option<Vec<f64>> {
    let fft = RealFftPlanner::<f64>::new().plan_fft_forward(length);
    let (mut input, mut output) = (fft.make_input_vec(), fft.make_output_vec());
    let mut power = vec![0.0; length / 2];
    let mut first = 0;
    while first + length <= values.len() {
        let stretch = &values[first..first + length];
        let (start, end) = (stretch[0], stretch[length - 1]);
        for (k, (place, value)) in input.iter_mut().zip(stretch).enumerate() {
            let part = k as f64 / (length - 1) as f64;
            // Hann's window.
            let weight = 0.5 - 0.5 * (std::f64::consts::TAU * part).cos();
            *place = weight * (value - start - part * (end - start));
        }
        fft.process(&mut input, &mut output).ok()?;
        for (sum, number) in power.iter_mut().zip(&output[1..]) {
            *sum += number.norm_sqr();
        }
        first += length / 2;
    }
    Some(power)
}

fn previous_power_of_two(number: usize) -> usize {
    number.checked_ilog2().map_or(0, |exponent| 1 << exponent)
}

#[cfg(test)]
mod tests;
