//! Draws a pole-zero map with a panel near z = 1, and writes it as SVG and PNG into the folder given as argument, or into `target`.
//!
//! `cargo run -p report --example pole_zero_map [-- FOLDER]`

use report::{Figure, Notes, Panel, Points, png, svg};
use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args_os().nth(1).unwrap_or_else(|| "target".into()));
    std::fs::create_dir_all(&folder)?;
    // Zeros and eigenvalues of the lateral motion of an aircraft, sampled at 10 Hz: the eigenvalues are zeros of the
    // difference of two transmissibilities, the other zeros are not.
    let zeros = [(0.9788, 0.1672), (0.9788, -0.1672), (0.9469, 0.0), (0.9998, 0.0), (0.9740, 0.0)];
    let poles = [
        (-1.0484, 0.0),
        (0.8166, 0.0),
        (0.9912, 0.0),
        (1.0011, 0.0),
        (0.9646, 0.0046),
        (0.9646, -0.0046),
    ];
    let eigenvalues = [(0.97879, 0.16718), (0.97879, -0.16718), (0.94691, 0.0), (0.99984, 0.0)];
    let map = |title: &str| {
        Panel::z_plane(title)
            .with(Points::poles("pole", poles))
            .with(Points::zeros("zero", zeros))
            .with(Points::eigenvalues("eigenvalue of the aircraft", eigenvalues))
    };
    let near_one = map("near z = 1").zoom((0.92, 1.02), (-0.2, 0.2)).with(Notes::new([
        (0.97879, 0.16718, "Dutch roll"),
        (0.94691, 0.0, "roll"),
        (0.99984, 0.0, "spiral"),
    ]));
    let figure = Figure::new(
        "pole-zero-map",
        "Difference of two transmissibilities",
        "The eigenvalues of the aircraft are among the zeros.",
    )
    .columns(2)
    .with(map("sideslip to roll rate"))
    .with(near_one);
    let picture = svg::render(&figure)?;
    std::fs::write(folder.join("pole-zero-map.svg"), &picture)?;
    std::fs::write(folder.join("pole-zero-map.png"), png::render(&picture, 2.0)?)?;
    Ok(())
}
