//! `transmode completions` and `transmode man`: what shells and readers of manuals need, from the same definition as the help.

use std::io::Write;
use std::path::Path;

use clap::{Command, CommandFactory};
use clap_mangen::Man;

use crate::args::{Args, CompletionsArgs, ManArgs};
use crate::{CommandError, Exit, output};

/// Writes the script for one shell.
pub(crate) fn completions(
    args: &CompletionsArgs,
    out: &mut dyn Write,
) -> Result<Exit, CommandError> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Args::command(), "transmode", &mut script);
    output::write_whole(Path::new("-"), &script, out)?;
    Ok(Exit::Fine)
}

/// Writes the pages, all or none, and says which.
pub(crate) fn man(args: &ManArgs, out: &mut dyn Write) -> Result<Exit, CommandError> {
    let mut whole = Args::command();
    whole.build();
    let commands = whole.get_subcommands().filter(|command| command.get_name() != "help");
    let mut pages = vec![page(whole.clone().disable_help_subcommand(true))?];
    for command in commands {
        pages.push(page(command.clone())?);
    }
    let names: Vec<String> = pages.iter().map(|(name, _)| name.clone()).collect();
    output::check_folder(&args.output, &names, output::Overwrite::Allowed)?;
    output::write_folder(&args.output, &pages, output::Overwrite::Allowed)?;
    let line = |name: &String| format!("{}\n", args.output.join(name).display());
    let text: String = names.iter().map(line).collect();
    output::write_whole(Path::new("-"), text.as_bytes(), out)?;
    Ok(Exit::Fine)
}

/// The name of a page and what it says; no date, so that the same program writes the same pages.
fn page(command: Command) -> Result<(String, Vec<u8>), CommandError> {
    let page = Man::new(command).date("");
    let file = page.get_filename();
    let mut text = Vec::new();
    page.render(&mut text)
        .map_err(|source| CommandError::Write { file: file.clone().into(), source })?;
    Ok((file, text))
}
