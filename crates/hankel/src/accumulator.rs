//! Records of any length, piece by piece.

use pulp::Arch;

use crate::{
    Gram, HankelError, Layout, Missing, gaps::pieces, kernel::TILE, segment::Segment, sums::Sums,
};

/// How to sum.
///
/// # Example
///
/// ```
/// use hankel::{Missing, Options};
///
/// let options = Options { missing: Missing::Gap, ..Options::default() };
/// assert_eq!(options.threads, 1);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// Threads to work with, at least 1. The result is the same to the last bit whatever their number.
    ///
    /// The default is 1: a caller that works on several records at once has better use for the others.
    pub threads: usize,
    /// What a NaN means.
    pub missing: Missing,
}

impl Default for Options {
    fn default() -> Self {
        Self { threads: 1, missing: Missing::Refuse }
    }
}

/// How two partial results meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Seam {
    /// Different records, or a gap: no row reaches across.
    Gap,
    /// The samples of the second follow those of the first without a gap.
    Continuous,
}

/// Samples needed from the two sides of a continuous seam, or of a record that is still short.
type Window = Vec<Vec<f64>>;

/// A Gram matrix in the making: samples are pushed in pieces of any size, in memory that does not grow with their number.
///
/// It holds `O(p^2)` sums and, for each channel, about 2000 samples and four times the span of the lags. How the samples were cut
/// into pieces makes no difference to the result, to the last bit.
///
/// # Example
///
/// ```
/// use hankel::{Accumulator, Layout, Options, Seam, gram};
///
/// let x = [1.0, 2.0, 3.0, 4.0, 5.0];
/// let layout = Layout::block_hankel(1, 2)?;
/// let whole = gram(&layout, &[&x], &Options::default())?;
///
/// let mut first = Accumulator::new(&layout, &Options::default())?;
/// first.push(&[&x[..1]])?;
/// first.push(&[&x[1..3]])?;
/// let mut second = Accumulator::new(&layout, &Options::default())?;
/// second.push(&[&x[3..]])?;
/// first.merge(&second, Seam::Continuous)?;
/// assert_eq!(first.gram()?.matrix()?, whole.matrix()?);
/// # Ok::<(), hankel::HankelError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Accumulator {
    layout: Layout,
    options: Options,
    /// Entries of all segments but the last.
    closed: Sums,
    closed_rows: usize,
    segments: usize,
    longest: usize,
    open: Segment,
    /// The first samples of the very first segment, if that is not the open one; empty if there was a gap before any sample.
    first: Option<Window>,
}

impl Accumulator {
    /// An accumulator without samples.
    ///
    /// # Errors
    ///
    /// [`HankelError::BadValue`] for no threads.
    pub fn new(layout: &Layout, options: &Options) -> Result<Self, HankelError> {
        if options.threads == 0 {
            return Err(HankelError::BadValue {
                what: "the number of threads",
                value: 0.0,
                needed: "at least 1",
            });
        }
        Ok(Self {
            closed: Sums::new(layout.channels(), layout.plan().entry_owners()),
            closed_rows: 0,
            segments: 0,
            longest: 0,
            open: Segment::new(layout),
            first: None,
            layout: layout.clone(),
            options: *options,
        })
    }

    /// What is summed.
    #[must_use]
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Rows so far.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.closed_rows + self.layout.rows(self.open.samples())
    }

    /// Adds further samples of all channels.
    ///
    /// # Errors
    ///
    /// [`HankelError::WrongChannelCount`], [`HankelError::UnequalLengths`], [`HankelError::NotFinite`]. Nothing has been added then.
    pub fn push(&mut self, record: &[&[f64]]) -> Result<(), HankelError> {
        let samples = self.layout.samples(record)?;
        let arch = Arch::new();
        // Most long pieces are finite throughout, and the sums see that in passing. Only if not does it matter where.
        if samples > TILE {
            let mut trial = self.open.clone();
            if trial.push(&self.layout, record, self.options.threads, arch) {
                self.open = trial;
                return Ok(());
            }
        }
        for (index, (from, to)) in
            pieces(&self.layout, record, self.options.missing)?.into_iter().enumerate()
        {
            if index > 0 {
                self.gap();
            }
            if to > from {
                let piece: Vec<&[f64]> = record.iter().map(|channel| &channel[from..to]).collect();
                self.open.push(&self.layout, &piece, self.options.threads, arch);
            }
        }
        Ok(())
    }

    /// Ends the segment: what is pushed next does not follow the last sample.
    pub fn gap(&mut self) {
        if self.open.samples() == 0 {
            // A gap before the first sample: nothing that comes before may reach across.
            self.first.get_or_insert_with(|| vec![Vec::new(); self.layout.channels()]);
            return;
        }
        let segment = std::mem::replace(&mut self.open, Segment::new(&self.layout));
        self.close(&segment);
        self.longest = self.longest.max(segment.samples());
        self.segments += 1;
        self.first.get_or_insert_with(|| segment.head().to_vec());
    }

    /// Adds the rows of a segment.
    fn close(&mut self, segment: &Segment) {
        let entries = segment.entries(&self.layout, Arch::new());
        self.closed = self.with_closed(entries);
        self.closed_rows += self.layout.rows(segment.samples());
    }

    /// These entries on top of those of the segments that are closed.
    fn with_closed(&self, entries: Sums) -> Sums {
        if self.closed_rows == 0 {
            return entries;
        }
        let mut all = self.closed.clone();
        all.add(&entries, self.layout.plan().entry_owners());
        all
    }

    /// Adds what another accumulator has seen, as if its samples had been pushed here: across a gap, or without one.
    ///
    /// The sums are the same as from one reading but for the rounding of additions in doubled precision, 1e-31 relative.
    ///
    /// # Errors
    ///
    /// [`HankelError::DifferentLayouts`]. Nothing has been added then.
    pub fn merge(&mut self, other: &Self, seam: Seam) -> Result<(), HankelError> {
        if self.layout != other.layout {
            return Err(HankelError::DifferentLayouts);
        }
        let other_is_short =
            other.first.is_none() && other.open.samples() <= 2 * self.layout.span();
        let nothing_to_join = self.open.samples() == 0;
        if seam == Seam::Gap {
            self.gap();
        } else if nothing_to_join {
            // What the other has seen becomes this one's, with what came before its first sample.
        } else if other_is_short {
            let head: Vec<&[f64]> = other.open.head().iter().map(Vec::as_slice).collect();
            self.open.push(&self.layout, &head, 1, Arch::new());
            return Ok(());
        } else {
            self.join(other.first.as_deref().unwrap_or(other.open.head()));
        }
        self.closed.add(&other.closed, self.layout.plan().entry_owners());
        self.closed_rows += other.closed_rows;
        self.segments += other.segments;
        self.longest = self.longest.max(other.longest);
        self.open = other.open.clone();
        if self.first.is_none() {
            self.first.clone_from(&other.first);
        }
        Ok(())
    }

    /// Closes the open segment and adds the rows that begin in it and end in the samples that follow, of which at most a span is needed.
    fn join(&mut self, following: &[Vec<f64>]) {
        let span = self.layout.span();
        let segment = std::mem::replace(&mut self.open, Segment::new(&self.layout));
        let next: Vec<&[f64]> =
            following.iter().map(|samples| &samples[..span.min(samples.len())]).collect();
        let mut across = Segment::new(&self.layout);
        across.push(&self.layout, &segment.tail(span), 1, Arch::new());
        across.push(&self.layout, &next, 1, Arch::new());
        self.close(&segment);
        self.close(&across);
        self.first.get_or_insert_with(|| {
            let mut first = segment.head().to_vec();
            for (samples, more) in first.iter_mut().zip(following) {
                samples.extend(more.iter().take(2 * span - samples.len()));
            }
            first
        });
    }

    /// The Gram matrix of everything so far. More may be pushed afterwards.
    ///
    /// # Errors
    ///
    /// [`HankelError::TooShort`] if there is not a single row.
    pub fn gram(&self) -> Result<Gram, HankelError> {
        if self.rows() == 0 {
            return Err(HankelError::TooShort {
                segments: self.segments + usize::from(self.open.samples() > 0),
                longest: self.longest.max(self.open.samples()),
                needed: self.layout.span() + 1,
            });
        }
        let all = if self.open.samples() > 0 {
            self.with_closed(self.open.entries(&self.layout, Arch::new()))
        } else {
            self.closed.clone()
        };
        Ok(Gram::new(&self.layout, &all, self.rows()))
    }
}

/// The Gram matrix of a record in memory.
///
/// `G = X' X` for the rows X of the layout, or `L' R` for a cross layout, each entry with about twice the digits of a double; O(N p c)
/// operations for N samples, p columns and c channels.
///
/// # Errors
///
/// As [`Accumulator::new`], [`Accumulator::push`] and [`Accumulator::gram`].
///
/// # Example
///
/// ```
/// use hankel::{Column, Layout, Options, gram};
///
/// // How u(k) and u(k-1) go with y(k), for u = 1 2 3 and y = 5 6 7.
/// let layout = Layout::cross(2, vec![Column::new(0, 0), Column::new(0, -1)], vec![Column::new(1, 0)])?;
/// let gram = gram(&layout, &[&[1.0, 2.0, 3.0], &[5.0, 6.0, 7.0]], &Options::default())?;
/// assert_eq!(gram.rows(), 2);
/// assert_eq!(gram.matrix()?.as_slice(), [2.0 * 6.0 + 3.0 * 7.0, 1.0 * 6.0 + 2.0 * 7.0]);
/// # Ok::<(), hankel::HankelError>(())
/// ```
pub fn gram(layout: &Layout, record: &[&[f64]], options: &Options) -> Result<Gram, HankelError> {
    let mut accumulator = Accumulator::new(layout, options)?;
    accumulator.push(record)?;
    accumulator.gram()
}
