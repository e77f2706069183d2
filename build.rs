//! Tells the program which commit it is built from, where that is known, for `couplet --version`; and leaves out what a
//! program does not need that ends at a panic.

use std::process::Command;
use std::{env, fs};

/// What the program is built from.
const SOURCES: [&str; 5] = ["build.rs", "Cargo.toml", "Cargo.lock", "src", "crates"];

fn main() {
    for path in SOURCES {
        println!("cargo:rerun-if-changed={path}");
    }
    let commit = packaged().or_else(checked_out).unwrap_or("unknown".to_owned());
    println!("cargo:rustc-env=COUPLET_COMMIT={commit}");
    let is_linux = env::var("CARGO_CFG_TARGET_OS").is_ok_and(|system| system == "linux");
    let flags = env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    if is_linux && flags.contains(NO_TABLES) && !flags.contains("link") {
        leave_out_tables();
    }
}

/// The option of a build without tables of unwinding (Makefile).
const NO_TABLES: &str = "force-unwind-tables=no";

/// Leaves out the tables that the compiler makes all the same, for whatever might have to be dropped: a fifteenth of
/// the program. Linkers that are chosen by name may not know how.
fn leave_out_tables() {
    let (Ok(folder), Err(_)) = (env::var("OUT_DIR"), env::var("RUSTC_LINKER")) else { return };
    let script = format!("{folder}/no_tables.ld");
    let discarded = "SECTIONS { /DISCARD/ : { *(.eh_frame) } } INSERT AFTER .text;";
    if fs::write(&script, discarded).is_ok() {
        println!("cargo:rustc-link-arg-bins=-Wl,--no-eh-frame-hdr");
        println!("cargo:rustc-link-arg-bins=-T{script}");
    }
}

/// The commit of a package: cargo writes it down.
fn packaged() -> Option<String> {
    let text = fs::read_to_string(".cargo_vcs_info.json").ok()?;
    let (_, rest) = text.split_once("\"sha1\": \"")?;
    rest.split_once('"').map(|(commit, _)| commit.to_owned())
}

/// The last commit of this repository that changed the sources, and whether what is built differs from it. A commit of
/// other files changes nothing of the program, so nothing is built again.
fn checked_out() -> Option<String> {
    let top = git(&["rev-parse", "--show-toplevel"])?;
    let is_ours = fs::canonicalize(top).ok()? == fs::canonicalize(".").ok()?;
    let of_sources = |words: &[&str]| git(&[words, &["--"], &SOURCES].concat());
    let commit = of_sources(&["log", "-1", "--format=%H"]).filter(|_| is_ours)?;
    if of_sources(&["status", "--porcelain"]).is_none() {
        return Some(commit);
    }
    // Once the changes are committed, they are none any more: what is logged of the head tells when.
    if let Some(log) = git(&["rev-parse", "--git-path", "logs/HEAD"]) {
        println!("cargo:rerun-if-changed={log}");
    }
    Some(format!("{commit} with changes"))
}

/// What git answers, if anything.
fn git(arguments: &[&str]) -> Option<String> {
    let output =
        Command::new("git").args(arguments).output().ok().filter(|o| o.status.success())?;
    let text = String::from_utf8(output.stdout).ok()?.trim().to_owned();
    (!text.is_empty()).then_some(text)
}
