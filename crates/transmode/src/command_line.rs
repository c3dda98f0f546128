//! A command line as text that can be pasted.

use std::ffi::OsString;

/// The words as a shell takes them, the program by its own name.
///
/// Bytes that are no text come out as replacement characters; such a line is for reading.
pub(crate) fn as_typed(words: &[OsString]) -> String {
    let arguments = words.iter().skip(1).map(|word| word.to_string_lossy());
    let text: Vec<_> = std::iter::once("transmode".into()).chain(arguments).collect();
    // A word with a zero byte, which no shell can take, leaves the line unquoted.
    shlex::try_join(text.iter().map(AsRef::as_ref)).unwrap_or_else(|_| text.join(" "))
}

#[cfg(test)]
mod tests;
