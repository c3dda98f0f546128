//! How an input moves between samples.

/// How the excitation moves between two samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Hold {
    /// It stays what it was, as the output of a digital controller does.
    ZeroOrder,
    /// It moves on straight from sample to sample: close to anything that moves slowly beside the sampling, as a pilot's hand and a gust do.
    FirstOrder,
}
