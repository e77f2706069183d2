//! Tells the program which commit it is built from, where that is known, for `couplet --version`.

use std::fs;
use std::process::Command;

fn main() {
    for path in ["build.rs", "Cargo.toml", "Cargo.lock", "src"] {
        println!("cargo:rerun-if-changed={path}");
    }
    // A commit changes what is logged of the head.
    if let Some(log) = git(&["rev-parse", "--git-path", "logs/HEAD"]) {
        println!("cargo:rerun-if-changed={log}");
    }
    let commit = packaged().or_else(checked_out).unwrap_or("unknown".to_owned());
    println!("cargo:rustc-env=COUPLET_COMMIT={commit}");
}

/// The commit of a package: cargo writes it down.
fn packaged() -> Option<String> {
    let text = fs::read_to_string(".cargo_vcs_info.json").ok()?;
    let (_, rest) = text.split_once("\"sha1\": \"")?;
    rest.split_once('"').map(|(commit, _)| commit.to_owned())
}

/// The commit of a checkout of this repository, and whether what is built differs from it.
fn checked_out() -> Option<String> {
    let top = git(&["rev-parse", "--show-toplevel"])?;
    let is_ours = fs::canonicalize(top).ok()? == fs::canonicalize(".").ok()?;
    let commit = git(&["rev-parse", "HEAD"]).filter(|_| is_ours)?;
    let changes =
        git(&["status", "--porcelain", "--", "build.rs", "Cargo.toml", "Cargo.lock", "src"]);
    Some(if changes.is_some() { format!("{commit} with changes") } else { commit })
}

/// What git answers, if anything.
fn git(arguments: &[&str]) -> Option<String> {
    let output =
        Command::new("git").args(arguments).output().ok().filter(|o| o.status.success())?;
    let text = String::from_utf8(output.stdout).ok()?.trim().to_owned();
    (!text.is_empty()).then_some(text)
}
