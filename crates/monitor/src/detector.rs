//! Limits from healthy records, and the tests of new ones.

use nalgebra::DVector;

use crate::features::{Features, features};
use crate::statistics::Healthy;
use crate::stretch::{complete, longest_run};
use crate::{Link, MonitorError, Stretch, Test, Whitening, Window};

/// The weight of the newest window in the mean that the next one is compared with: it remembers about five.
const WEIGHT: f64 = 0.2;
/// Healthy windows beyond those that a covariance takes.
const SPARE_WINDOWS: usize = 10;
/// How new data are watched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Samples in a window, at least 2. A long one sees smaller faults, a short one sees them sooner.
    pub window: usize,
    /// The probability with which a window of healthy data raises an alarm, above 0 and below 1/2.
    pub false_alarms: f64,
}

/// Transmissibilities, and what is usual of their residuals.
#[derive(Debug, Clone)]
pub struct Detector {
    links: Vec<Link>,
    whitenings: Vec<Whitening>,
    options: Options,
    /// The probability of each of the two tests.
    each: f64,
    level: Healthy,
    spread: Healthy,
    /// For each channel, how long it stood still in the healthy data.
    longest_run: Vec<usize>,
}

impl Detector {
    /// Whitens by the training data, and takes the limits from healthy data that had no part in the fit.
    ///
    /// # Errors
    ///
    /// [`MonitorError::NoLink`], [`MonitorError::NoSuchChannel`], [`MonitorError::BadOption`], [`MonitorError::NoTraining`],
    /// [`MonitorError::TooFewWindows`], [`MonitorError::Degenerate`].
    pub fn calibrate(
        links: Vec<Link>,
        training: &[Stretch<'_>],
        healthy: &[Stretch<'_>],
        options: Options,
    ) -> Result<Self, MonitorError> {
        check(&links, training.iter().chain(healthy), options)?;
        let whitenings =
            links.iter().map(|link| whitening(link, training)).collect::<Result<Vec<_>, _>>()?;
        let (mut jumps, mut spreads) = (Vec::new(), Vec::new());
        for stretch in healthy {
            let mut baseline = Baseline::default();
            for features in features(&links, &whitenings, stretch, options.window)? {
                jumps.extend(baseline.jump(&features.level));
                spreads.push(features);
            }
        }
        let (found, needed) = (jumps.len(), 2 * links.len() + SPARE_WINDOWS);
        if found < needed {
            let (window, links) = (options.window, links.len());
            return Err(MonitorError::TooFewWindows { found, needed, window, links });
        }
        let as_read: Vec<_> = spreads.iter().map(|features| features.spread.clone()).collect();
        let usual = Healthy::of(&as_read)?;
        let as_whole = |features: &Features| features.spread_as_whole(usual.mean(), options.window);
        let spreads: Vec<_> = spreads.iter().map(as_whole).collect();
        let (level, spread) = (Healthy::of(&jumps)?, Healthy::of(&spreads)?);
        let channels = healthy.iter().map(Vec::len).min().unwrap_or(0);
        let longest = |channel: usize| {
            let runs = healthy.iter().chain(training).filter_map(|stretch| stretch.get(channel));
            runs.map(|values| longest_run(values)).max().unwrap_or(1)
        };
        Ok(Self {
            longest_run: (0..channels).map(longest).collect(),
            each: 1.0 - (1.0 - options.false_alarms).sqrt(),
            links,
            whitenings,
            options,
            level,
            spread,
        })
    }

    /// The tests of all whole windows, in order of time. What is left at the end of a stretch is not judged, nor are windows of which missing samples leave less than half.
    ///
    /// # Errors
    ///
    /// [`MonitorError::NoSuchChannel`], [`MonitorError::Residual`].
    pub fn watch(&self, stretches: &[Stretch<'_>]) -> Result<Vec<Window>, MonitorError> {
        let mut found = Vec::new();
        for (index, stretch) in stretches.iter().enumerate() {
            let mut baseline = Baseline::default();
            for features in features(&self.links, &self.whitenings, stretch, self.options.window)? {
                found.push(self.window(index, &features, &mut baseline));
            }
        }
        Ok(found)
    }

    fn window(&self, stretch: usize, features: &Features, baseline: &mut Baseline) -> Window {
        let jump = baseline.jump(&features.level);
        let test = |healthy: &Healthy, x: Option<&DVector<f64>>| Test {
            statistic: x.map_or(0.0, |x| healthy.distance(x)),
            limit: healthy.limit(self.each),
        };
        let zero = || DVector::zeros(self.links.len());
        let level = jump.as_ref().map_or_else(zero, |jump| self.level.scaled(jump));
        let as_whole = features.spread_as_whole(self.spread.mean(), self.options.window);
        let spread = self.spread.scaled(&as_whole);
        let ahead = self.links.iter().map(Link::look_ahead).max().unwrap_or(0);
        Window {
            stretch,
            first: features.first,
            known_at: features.first + self.options.window - 1 + ahead,
            tests: [test(&self.level, jump.as_ref()), test(&self.spread, Some(&as_whole))],
            deviations: level.iter().zip(spread.iter()).map(|(x, y)| [*x, *y]).collect(),
            means: self.level.in_deviations(&features.level).iter().copied().collect(),
        }
    }

    /// The transmissibilities.
    #[must_use]
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// The options.
    #[must_use]
    pub fn options(&self) -> Options {
        self.options
    }

    /// How many healthy windows the limits rest on: all but the first of each stretch, which has none before it to be compared with.
    #[must_use]
    pub fn healthy_windows(&self) -> usize {
        self.level.observations()
    }

    /// The number of samples that an alarm needs behind the window itself, and in front of the first one.
    #[must_use]
    pub fn margin(&self) -> usize {
        let before = self.links.iter().zip(&self.whitenings).map(|(link, whitening)| {
            let orders = link.model.structure().orders;
            orders.causal() + orders.iir() + whitening.order()
        });
        let ahead = self.links.iter().map(Link::look_ahead).max().unwrap_or(0);
        before.max().unwrap_or(0) + ahead
    }

    /// The number of whole windows in a stretch of so many samples, those included that missing samples keep from being judged.
    #[must_use]
    pub fn windows_in(&self, samples: usize) -> usize {
        samples.saturating_sub(self.margin()) / self.options.window
    }

    /// What a single transmissibility's squared deviation exceeds as often as a test of all of them.
    pub(crate) fn limit_of_one(&self) -> f64 {
        self.level.limit_of_one(self.each)
    }

    pub(crate) fn longest_run(&self) -> &[usize] {
        &self.longest_run
    }
}

fn check<'a>(
    links: &[Link],
    stretches: impl Iterator<Item = &'a Stretch<'a>>,
    options: Options,
) -> Result<(), MonitorError> {
    if links.is_empty() {
        return Err(MonitorError::NoLink);
    }
    if options.window < 2 {
        let (what, value) = ("the window", options.window as f64);
        return Err(MonitorError::BadOption { what, value, needed: "at least 2 samples" });
    }
    if options.false_alarms.is_nan() || options.false_alarms <= 0.0 || options.false_alarms >= 0.5 {
        let (what, value) = ("the false-alarm rate", options.false_alarms);
        return Err(MonitorError::BadOption {
            what,
            value,
            needed: "a number above 0 and below 1/2",
        });
    }
    for stretch in stretches {
        let is_bad = |link: &&Link| {
            link.input == link.output || link.input.max(link.output) >= stretch.len()
        };
        if let Some(link) = links.iter().find(is_bad) {
            return Err(link.missing(stretch.len()));
        }
    }
    Ok(())
}

fn whitening(link: &Link, training: &[Stretch<'_>]) -> Result<Whitening, MonitorError> {
    let mut residuals = Vec::new();
    for stretch in training.iter().flat_map(complete) {
        residuals.extend(link.residual(&stretch)?.map(|residual| residual.values));
    }
    if residuals.is_empty() {
        return Err(MonitorError::NoTraining);
    }
    Ok(Whitening::fit(&residuals.iter().map(Vec::as_slice).collect::<Vec<_>>()))
}

/// The weighted mean of the windows before, with which the next one is compared.
///
/// It follows what is slow in healthy residuals: a model that is off at frequencies near zero lets a slow mode through.
#[derive(Debug, Clone, Default)]
struct Baseline {
    mean: Option<DVector<f64>>,
    windows: usize,
    /// Variance of the mean over that of a window, were these independent.
    variance: f64,
}

impl Baseline {
    /// How far a window's level is off the mean of those before, divided so that its variance is that of a window; nothing for the first one.
    fn jump(&mut self, level: &DVector<f64>) -> Option<DVector<f64>> {
        self.windows += 1;
        let weight = WEIGHT.max(1.0 / self.windows as f64);
        let variance = self.variance;
        self.variance = (1.0 - weight).powi(2) * variance + weight * weight;
        let Some(mean) = &mut self.mean else {
            self.mean = Some(level.clone());
            return None;
        };
        let off = level - &*mean;
        *mean += &off * weight;
        Some(off / (1.0 + variance).sqrt())
    }
}
