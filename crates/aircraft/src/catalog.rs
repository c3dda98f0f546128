//! Aircraft whose numbers have been read in a source.

use crate::{Inertia, LateralDerivatives};

/// An aircraft in one flight condition.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CatalogEntry {
    /// Short name, for a command line or a legend.
    pub name: &'static str,
    /// Where the numbers stand.
    pub source: &'static str,
    /// Stability and control derivatives.
    pub derivatives: LateralDerivatives,
    /// Moments of inertia.
    pub inertia: Inertia,
}

/// The aircraft of the paper's part VI.
///
/// The paper takes it from its reference \[1\], p. 358, and names neither the aircraft nor the units; `g = 32.174` and
/// `U0 = 400` are ft/s^2 and ft/s, and that fixes the rest. The values are the paper's, digit for digit. It lists
/// `L_da` and `N_da` twice, each time with the same value.
pub const PAPER_AIRCRAFT: CatalogEntry = CatalogEntry {
    name: "paper",
    source: "paper part VI, from its reference [1], p. 358",
    derivatives: LateralDerivatives {
        trim_speed_ft_s: 400.0,
        gravity_ft_s2: 32.174,
        y_beta_ft_s2: -55.4022,
        y_p_ft_s: 0.0,
        y_r_ft_s: 0.7689,
        l_beta_per_s2: -4.1845,
        l_t_beta_per_s2: 0.0,
        l_p_per_s: -0.4365,
        l_r_per_s: 0.1571,
        n_beta_per_s2: 2.8643,
        n_t_beta_per_s2: 0.0,
        n_p_per_s: 0.0046,
        n_r_per_s: -0.1148,
        y_aileron_ft_s2: 0.0,
        l_aileron_per_s2: 6.7714,
        n_aileron_per_s2: -0.3879,
        y_rudder_ft_s2: 10.4733,
        l_rudder_per_s2: 0.6543,
        n_rudder_per_s2: -1.6847,
    },
    inertia: Inertia { ixx_slug_ft2: 27915.0, izz_slug_ft2: 47085.0, ixz_slug_ft2: 450.0 },
};

/// All entries.
pub const ALL: [&CatalogEntry; 1] = [&PAPER_AIRCRAFT];

/// The entry of this name, if there is one.
///
/// # Example
///
/// ```
/// use aircraft::catalog;
///
/// assert_eq!(catalog::find("paper").map(|entry| entry.derivatives.trim_speed_ft_s), Some(400.0));
/// assert!(catalog::find("Spruce Goose").is_none());
/// ```
#[must_use]
pub fn find(name: &str) -> Option<&'static CatalogEntry> {
    ALL.into_iter().find(|entry| entry.name == name)
}
