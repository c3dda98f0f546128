//! Options together with what of them stood on the command line, so that others may be filled in from elsewhere.

use clap::{ArgMatches, Args, Command, Error, FromArgMatches};

/// Parsed options, and the matches that they come from.
#[derive(Clone, Debug)]
pub(crate) struct Given<T> {
    pub(crate) args: T,
    pub(crate) matches: ArgMatches,
}

impl<T: FromArgMatches> FromArgMatches for Given<T> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        Ok(Self { args: T::from_arg_matches(matches)?, matches: matches.clone() })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        self.args.update_from_arg_matches(matches)?;
        self.matches = matches.clone();
        Ok(())
    }
}

impl<T: Args> Args for Given<T> {
    fn augment_args(command: Command) -> Command {
        T::augment_args(command)
    }

    fn augment_args_for_update(command: Command) -> Command {
        T::augment_args_for_update(command)
    }
}
