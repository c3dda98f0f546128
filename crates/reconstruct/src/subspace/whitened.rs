//! Records whitened once, for the models of many orders.

use super::engine::Engine;
use super::levels;
use super::limits::{Extent, Setting};
use super::options::Options;
use super::order::Spaces;
use super::sources::Sources;
use super::whitening::Whitening;
use crate::{ReconstructError, Record, SharedModel};

/// Records with their noise whitened by levels that are known: the model at one order after another, without what is said about it.
pub(crate) struct Whitened<'a> {
    records: &'a [Record],
    setting: Setting<'a>,
    sources: Sources,
    extent: Extent,
    whitening: Whitening,
    spaces: Spaces,
}

impl<'a> Whitened<'a> {
    /// Whitens the records by the levels of the options.
    pub(crate) fn new(
        records: &'a [Record],
        options: &'a Options,
    ) -> Result<Self, ReconstructError> {
        let setting = Setting::new(records, options)?;
        let extent = setting.extent(options.order, options.block_rows)?;
        let probe = levels::window_rows(setting.sensors, extent.largest_order, extent.block_rows);
        let sources = Sources::new(setting, extent.block_rows, probe)?;
        let engine = Engine { setting, sources: &sources, block_rows: extent.block_rows };
        let (whitening, origin) = engine.noise(&options.noise, extent.largest_order)?;
        let spaces = engine.spaces(&engine.spectra(&whitening)?, &whitening, origin);
        Ok(Self { records, setting, sources, extent, whitening, spaces })
    }

    /// The model of so many states; `None` where the block rows do not tell as many, or hold none.
    pub(crate) fn model(&self, order: usize) -> Option<SharedModel> {
        if order > self.extent.largest_order {
            return None;
        }
        let block_rows = self.extent.block_rows;
        let engine = Engine { setting: self.setting, sources: &self.sources, block_rows };
        let (observability, _) = self.spaces.common(order).ok()?;
        let found = engine.realised(self.records, &self.spaces, &self.whitening, &observability);
        found.ok().map(|found| found.model)
    }
}
