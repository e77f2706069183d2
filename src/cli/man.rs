//! `couplet man`.

use crate::sweep::failure::{Failure, print};
use clap::{Args, Command};
use clap_mangen::{Man, generate_to};
use std::fs;
use std::path::PathBuf;

/// Print the manual page, or write those of all commands.
///
/// `couplet man | man -l -` shows it; `couplet man ~/.local/share/man/man1` installs couplet.1,
/// couplet-state.1 and the others.
#[derive(Args)]
pub(super) struct Arguments {
    /// The folder for a page of each command; it is made if need be.
    #[arg(value_name = "FOLDER")]
    folder: Option<PathBuf>,
}

pub(super) fn run(arguments: &Arguments, mut command: Command) -> Result<(), Failure> {
    let Some(folder) = &arguments.folder else {
        let mut page = Vec::new();
        Man::new(command).render(&mut page).map_err(|e| Failure::writing("the page", &e))?;
        return print(&page);
    };
    // Otherwise each command has a page of `help` too.
    command = command.disable_help_subcommand(true);
    command.build();
    fs::create_dir_all(folder)
        .and_then(|()| generate_to(command, folder))
        .map_err(|error| Failure::writing(folder.display(), &error))
}
