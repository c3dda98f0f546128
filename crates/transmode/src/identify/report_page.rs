//! `transmode identify --report DIR`: one page that says what was found and why it can be trusted, and its figures as files.
//!
//! | file of the folder | what it is |
//! |---|---|
//! | `report.html` | the page: nothing is fetched and no script runs |
//! | `ID.svg`, `ID.png` | each figure; ID is one of [`contents::FIGURES`] |
//!
//! Each section is a file of its own. A section that a method cannot fill says so in one sentence.

mod contents;
mod derivatives;
mod folder;
mod history;
mod mode_table;
mod order;
mod pole_map;
mod provenance;
mod recorded;
mod residuals;
mod spectra;
mod stabilisation;
mod style;
mod summary;
mod thinning;
mod transmissibility;

use std::thread::{Builder, ScopedJoinHandle};

use report::{Block, Document};

use super::outcome::Outcome;
use crate::CommandError;
use crate::records::Progress;
use contents::{PAGE, PROGRAM};

pub(super) use folder::{check_place, replace};

/// Pixels of a PNG per unit of the figure: sharp on paper at half a page's width.
const PNG_SCALE: f32 = 2.0;

/// The files of a report, with their names in its folder.
///
/// # Errors
///
/// [`CommandError::Report`] where a figure cannot be drawn.
pub(super) fn draw(
    outcome: &Outcome<'_>,
    progress: Progress,
) -> Result<Vec<(String, Vec<u8>)>, CommandError> {
    let _working = progress.work("drawing the report");
    let mut document = Document::new("Modes from sensor records")
        .generator(format!("{PROGRAM} {}", env!("CARGO_PKG_VERSION")));
    let sections =
        if outcome.result.output_error().is_some() { &WITH_INPUTS[..] } else { &SECTIONS[..] };
    for section in sections {
        section(outcome)?.into_iter().for_each(|block| document.push(block));
    }
    let fault = |error: report::ReportError| CommandError::Report(error.to_string());
    let page = report::html::render(&document).map_err(fault)?;
    let mut files = vec![(PAGE.to_owned(), page.into_bytes())];
    let pictures: Vec<String> =
        document.figures().map(report::svg::render).collect::<Result<_, _>>().map_err(fault)?;
    let images = images(&pictures).map_err(fault)?;
    for (figure, (picture, image)) in document.figures().zip(pictures.into_iter().zip(images)) {
        files.push((format!("{}.svg", figure.id), picture.into_bytes()));
        files.push((format!("{}.png", figure.id), image));
    }
    Ok(files)
}

/// The pictures as PNG, each drawn by a thread of its own: packing the pixels takes most of a report's time.
fn images(pictures: &[String]) -> Result<Vec<Vec<u8>>, report::ReportError> {
    std::thread::scope(|scope| {
        let draw = |picture: &String| report::png::render(picture, PNG_SCALE);
        let drawn: Vec<_> = pictures
            .iter()
            .map(|picture| (picture, Builder::new().spawn_scoped(scope, move || draw(picture))))
            .collect();
        let image =
            |(picture, thread): (&String, std::io::Result<ScopedJoinHandle<'_, _>>)| match thread {
                Ok(thread) => {
                    thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
                }
                // A system that gives no more threads has this one.
                Err(_) => draw(picture),
            };
        drawn.into_iter().map(image).collect()
    })
}

/// A part of the page.
type Section = fn(&Outcome<'_>) -> Result<Vec<Block>, CommandError>;

/// In reading order: the answer, why it can be trusted, what it comes from.
const SECTIONS: [Section; 10] = [
    summary::blocks,
    mode_table::blocks,
    pole_map::blocks,
    order::blocks,
    derivatives::blocks,
    stabilisation::blocks,
    history::blocks,
    spectra::blocks,
    transmissibility::blocks,
    provenance::blocks,
];

/// The same where all inputs were recorded.
const WITH_INPUTS: [Section; 5] =
    [summary::blocks, mode_table::blocks, pole_map::blocks, recorded::blocks, provenance::blocks];

#[cfg(test)]
mod tests;
