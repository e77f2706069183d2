//! `couplet completions`.

use crate::sweep::failure::{Failure, print};
use clap::{Args, Command};
use clap_complete::Shell;

/// Print the completions of a shell.
///
/// bash: `couplet completions bash > ~/.local/share/bash-completion/completions/couplet`. zsh: write
/// `_couplet` into a folder of `fpath`. fish: write `~/.config/fish/completions/couplet.fish`.
#[derive(Args)]
pub(super) struct Arguments {
    /// The shell.
    #[arg(value_name = "SHELL")]
    shell: Shell,
}

pub(super) fn run(arguments: &Arguments, mut program: Command) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut program, "couplet", &mut script);
    print(&script)
}
