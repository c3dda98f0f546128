//! The tests of one window.

/// What a test looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TestKind {
    /// The mean in this window against the weighted mean of those before.
    Level,
    /// The variance in this window.
    Spread,
}

impl TestKind {
    /// All, in the order of [`Window::tests`].
    pub const ALL: [Self; 2] = [Self::Level, Self::Spread];
}

impl std::fmt::Display for TestKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Self::Level => "level",
            Self::Spread => "spread",
        })
    }
}

/// A statistic and what it may not exceed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Test {
    /// Hotelling's T^2.
    pub statistic: f64,
    /// Its limit.
    pub limit: f64,
}

impl Test {
    /// Whether the limit is exceeded; a statistic that is no number counts as exceeded.
    #[must_use]
    pub fn is_alarm(&self) -> bool {
        !matches!(
            self.statistic.partial_cmp(&self.limit),
            Some(std::cmp::Ordering::Less | std::cmp::Ordering::Equal)
        )
    }
}

/// One window of new data.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Window {
    /// Index of the stretch.
    pub stretch: usize,
    /// Index in the stretch of the first sample.
    pub first: usize,
    /// Index in the stretch of the last sample that the window's tests need: only then can there be an alarm.
    pub known_at: usize,
    /// The tests of all transmissibilities together, in the order of [`TestKind::ALL`].
    pub tests: [Test; 2],
    /// Deviations of each transmissibility from the healthy mean, in healthy standard deviations, in the order of [`TestKind::ALL`].
    pub deviations: Vec<[f64; 2]>,
    /// The mean of each transmissibility's whitened residual, in healthy standard deviations of a window's mean.
    pub means: Vec<f64>,
}

impl Window {
    /// The test that exceeds its limit by the largest factor, if one does.
    #[must_use]
    pub fn alarm(&self) -> Option<(TestKind, Test)> {
        let ratio = |test: &Test| test.statistic / test.limit;
        TestKind::ALL
            .into_iter()
            .zip(self.tests)
            .filter(|(_, test)| test.is_alarm())
            .max_by(|(_, a), (_, b)| ratio(a).total_cmp(&ratio(b)))
    }
}
