//! A file that describes an aircraft: TOML or JSON, whose fields are those of the library, with their units in their names.

use std::path::Path;

use aircraft::Inertia;
use serde::Deserialize;
use serde::de::DeserializeOwned;

use crate::CommandError;

/// Moments of inertia, for `#[serde(with = "InertiaFields")]`.
#[derive(Deserialize)]
#[serde(remote = "Inertia", deny_unknown_fields)]
pub(crate) struct InertiaFields {
    ixx_slug_ft2: f64,
    izz_slug_ft2: f64,
    ixz_slug_ft2: f64,
}

/// Reads a file that ends in `.toml` or `.json`.
///
/// # Errors
///
/// [`CommandError::Read`], or one sentence with the file, and with the line where it is at fault.
pub(crate) fn read<T: DeserializeOwned>(file: &Path) -> Result<T, CommandError> {
    let bytes = std::fs::read(file)
        .map_err(|source| CommandError::Read { file: file.to_owned(), source })?;
    parse(file, &bytes).map_err(|message| CommandError::InFile { file: file.to_owned(), message })
}

fn parse<T: DeserializeOwned>(file: &Path, bytes: &[u8]) -> Result<T, String> {
    let extension = file.extension().map(|e| e.to_string_lossy().to_lowercase());
    match extension.as_deref() {
        Some("json") => serde_json::from_slice(bytes).map_err(|error| error.to_string()),
        Some("toml") => {
            let text =
                std::str::from_utf8(bytes).map_err(|_| "the file is not UTF-8 text".to_owned())?;
            toml::from_str(text).map_err(|error| {
                let line = |span: std::ops::Range<usize>| {
                    let before = bytes.get(..span.start).unwrap_or_default();
                    before.iter().filter(|byte| **byte == b'\n').count() + 1
                };
                let place =
                    error.span().map_or_else(String::new, |span| format!("line {}: ", line(span)));
                format!("{place}{}", error.message())
            })
        }
        _ => Err("an aircraft is described by a file that ends in .toml or .json".to_owned()),
    }
}
