//! Which streams get colours.

use std::ffi::OsString;

use clap::builder::styling::{AnsiColor, Style};
use clap::{ColorChoice, ValueEnum};

/// Where the output goes, as far as colours depend on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Terminals {
    /// Standard output is a terminal that shows colours.
    pub out: bool,
    /// Standard error is one.
    pub err: bool,
}

/// Whether help and errors are coloured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Colors {
    pub(crate) out: bool,
    pub(crate) err: bool,
}

impl Colors {
    /// From the words themselves, because help and errors about them are coloured too. The last choice counts; one that is none changes nothing.
    pub(crate) fn of(words: &[OsString], terminals: Terminals) -> Self {
        let mut choice = ColorChoice::Auto;
        for (index, word) in words.iter().enumerate() {
            let word = word.to_string_lossy();
            // Behind it there are only files.
            if word == "--" {
                break;
            }
            let next = words.get(index + 1).map(|next| next.to_string_lossy());
            let value = match word.strip_prefix("--color") {
                Some("") => next,
                Some(value) => value.strip_prefix('=').map(Into::into),
                None => None,
            };
            choice =
                value.and_then(|value| ColorChoice::from_str(&value, false).ok()).unwrap_or(choice);
        }
        match choice {
            ColorChoice::Auto => Self { out: terminals.out, err: terminals.err },
            ColorChoice::Always => Self { out: true, err: true },
            ColorChoice::Never => Self { out: false, err: false },
        }
    }

    /// What an error begins with, as the parser of words colours it.
    pub(crate) fn label(self, text: &str) -> String {
        if !self.err {
            return text.to_owned();
        }
        let style = Style::new().bold().fg_color(Some(AnsiColor::Red.into()));
        format!("{style}{text}{style:#}")
    }
}

#[cfg(test)]
mod tests;
