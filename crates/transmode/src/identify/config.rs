//! Options from a TOML file: read as words of a command line, so that both take the same options and say the same of bad ones.

use std::collections::BTreeMap;
use std::error::Error as _;
use std::ffi::OsString;
use std::path::Path;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches, ValueHint};
use toml::{Spanned, Value};

use crate::CommandError;
use crate::args::{Given, IdentifyArgs};
use crate::error::OptionError;

/// Options that are given together or instead of each other: where the command line has one of them, the file's are not used.
const TOGETHER: [&[&str]; 3] =
    [&["files", "window"], &["time", "sample_period"], &["noise", "noise_record", "white_noise"]];

/// A table of options, each key and value with its place in the text.
type Table = BTreeMap<Spanned<String>, Spanned<Value>>;

/// The options of the command line, completed from the file that `--config` names. Those of the command line win.
pub(super) fn complete(given: &Given<IdentifyArgs>) -> Result<IdentifyArgs, CommandError> {
    let Some(file) = &given.args.config else { return Ok(given.args.clone()) };
    let bytes =
        std::fs::read(file).map_err(|source| CommandError::Read { file: file.clone(), source })?;
    let text = String::from_utf8(bytes).map_err(|_| CommandError::InFile {
        file: file.clone(),
        message: "it is no text in UTF-8; --config takes a TOML file of options".to_owned(),
    })?;
    let place = Place { file, text: &text };
    let table: Table = toml::from_str(&text).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        let message = error.message().lines().collect::<Vec<_>>().join("; ");
        CommandError::from(place.fault(at, message))
    })?;
    let command = IdentifyArgs::augment_args(Command::new("identify").no_binary_name(true));
    let mut words: Vec<OsString> = Vec::new();
    let mut used: BTreeMap<&str, usize> = BTreeMap::new();
    for (key, value) in &table {
        let (name, at) = (key.get_ref().as_str(), key.span().start);
        let argument = command.get_arguments().find(|argument| is_called(argument, name));
        let Some(argument) = argument.filter(|_| name != "config") else {
            let message = format!("{name:?} is no option; there are {}", names(&command));
            return Err(place.fault(at, message).into());
        };
        let own = as_words(argument, value.get_ref(), file)
            .map_err(|message| place.fault(value.span().start, format!("{name} {message}")))?;
        // Alone first, so that a mistake has a place.
        command.clone().try_get_matches_from(&own).map(|_| ()).or_else(|error| {
            let alone = error.kind() == ErrorKind::MissingRequiredArgument;
            let fault = || place.fault(value.span().start, format!("{name}: {}", sentence(&error)));
            if alone { Ok(()) } else { Err(fault()) }
        })?;
        if !is_overridden(argument, &given.matches) {
            used.insert(name, at);
            words.extend(own);
        }
    }
    let matches = command.try_get_matches_from(&words).map_err(|error| {
        let at = used.values().copied().max().unwrap_or(0);
        place.fault(at, sentence(&error))
    })?;
    let built = |error: clap::Error| place.fault(0, sentence(&error));
    let mut complete = IdentifyArgs::from_arg_matches(&matches).map_err(built)?;
    complete.update_from_arg_matches(&given.matches).map_err(built)?;
    Ok(complete)
}

/// A text and its file, for messages.
struct Place<'a> {
    file: &'a Path,
    text: &'a str,
}

impl Place<'_> {
    fn fault(&self, at: usize, message: String) -> OptionError {
        let before = self.text.get(..at).unwrap_or(self.text);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
        OptionError::Configuration { file: self.file.to_owned(), line, column, message }
    }
}

fn is_called(argument: &Arg, name: &str) -> bool {
    let aliases = argument.get_all_aliases().unwrap_or_default();
    argument.get_long() == Some(name)
        || aliases.contains(&name)
        || (argument.is_positional() && argument.get_id() == name)
}

/// Whether the command line has the option, or one that takes its place.
fn is_overridden(argument: &Arg, matches: &ArgMatches) -> bool {
    let id = argument.get_id().as_str();
    let alone = [id];
    let group = TOGETHER.into_iter().find(|group| group.contains(&id)).unwrap_or(&alone);
    group.iter().any(|id| matches.contains_id(id))
}

fn names(command: &Command) -> String {
    let name = |argument: &Arg| match argument.get_long() {
        Some("config" | "help") => None,
        Some(long) => Some(long.to_owned()),
        None => argument.is_positional().then(|| argument.get_id().to_string()),
    };
    command.get_arguments().filter_map(name).collect::<Vec<_>>().join(", ")
}

/// The words that say the same on a command line.
fn as_words(argument: &Arg, value: &Value, file: &Path) -> Result<Vec<OsString>, String> {
    let many = matches!(argument.get_action(), ArgAction::Append);
    let texts: Vec<String> = match value {
        Value::Array(items) => {
            let items = items.iter().map(scalar).collect::<Result<Vec<_>, _>>()?;
            if items.is_empty() {
                return Err("is an empty list; leave it out".to_owned());
            }
            if many { items } else { vec![items.join(",")] }
        }
        value => vec![scalar(value)?],
    };
    let is_path = !matches!(argument.get_value_hint(), ValueHint::Unknown);
    let word = |text: String| {
        let text = match file.parent() {
            // An absolute path stays what it is.
            Some(folder) if is_path && text != "-" => folder.join(text).into_os_string(),
            _ => OsString::from(text),
        };
        match argument.get_long() {
            Some(long) => {
                let mut word = OsString::from(format!("--{long}="));
                word.push(text);
                word
            }
            None => text,
        }
    };
    Ok(texts.into_iter().map(word).collect())
}

fn scalar(value: &Value) -> Result<String, String> {
    match value {
        Value::String(text) => Ok(text.clone()),
        Value::Integer(number) => Ok(number.to_string()),
        Value::Float(number) => Ok(number.to_string()),
        Value::Boolean(flag) => Ok(flag.to_string()),
        other => Err(format!(
            "is {}; a text, a number, true or false, or a list of these is needed",
            match other {
                Value::Datetime(_) => "a date",
                Value::Table(_) => "a table",
                _ => "a list of lists",
            }
        )),
    }
}

/// What clap says, without its layout.
fn sentence(error: &clap::Error) -> String {
    if let Some(reason) = error.source() {
        return reason.to_string();
    }
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => text.clone(),
        Some(ContextValue::Strings(texts)) => texts.join(", "),
        _ => String::new(),
    };
    match error.kind() {
        ErrorKind::InvalidValue => format!(
            "{:?} is none of {}",
            context(ContextKind::InvalidValue),
            context(ContextKind::ValidValue)
        ),
        ErrorKind::ArgumentConflict => format!(
            "{} cannot be used together with {}",
            context(ContextKind::InvalidArg),
            context(ContextKind::PriorArg)
        ),
        ErrorKind::MissingRequiredArgument => {
            format!("{} is needed as well", context(ContextKind::InvalidArg))
        }
        ErrorKind::TooManyValues | ErrorKind::WrongNumberOfValues => {
            "one value is needed, not a list".to_owned()
        }
        kind => kind.as_str().unwrap_or("it cannot be used").to_owned(),
    }
}

#[cfg(test)]
mod tests;
