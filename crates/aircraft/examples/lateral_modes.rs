//! Prints the lateral modes of every aircraft of the catalog.

use std::io::Write;

use aircraft::{
    Evidence, LateralModel, LateralState, SideForceScaling, Surface, catalog, name_system_modes,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut out = std::io::stdout().lock();
    for entry in catalog::ALL {
        let model = LateralModel::new(entry.derivatives, entry.inertia)?;
        let system =
            model.state_space(&Surface::ALL, SideForceScaling::AsPrinted, &LateralState::ALL)?;
        writeln!(out, "{} ({})", entry.name, entry.source)?;
        for mode in name_system_modes(&system)? {
            write!(
                out,
                "  {:<20} {:>+9.4} {:>+8.4}j rad/s",
                mode.name, mode.eigenvalue.re, mode.eigenvalue.im
            )?;
            if let Evidence::Shape { slip_fraction, roll_fraction, agreement, .. } = mode.evidence {
                write!(
                    out,
                    "  slip {slip_fraction:.2}, roll {roll_fraction:.2}, agreement {agreement:.2}"
                )?;
            }
            writeln!(out)?;
        }
    }
    Ok(())
}
