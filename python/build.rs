//! Has the linker put functions that look alike next to each other, if it can: a wheel has a thirtieth less then, as
//! what compresses it looks back 32 kB.

use std::env;
use std::path::PathBuf;
use std::process::Command;

/// An option of lld, from its version 20 on; the one that Rust brings links by default on Linux.
const SORTED: &str = "-Wl,--bp-compression-sort=both";

/// Whether an empty library can be linked with it, as the package will be: by the same linker with the same flags.
fn is_understood() -> Option<bool> {
    let folder = PathBuf::from(env::var_os("OUT_DIR")?);
    let source = folder.join("empty.rs");
    std::fs::write(&source, "").ok()?;
    let mut rustc = Command::new(env::var_os("RUSTC")?);
    rustc.args(["--crate-type=cdylib", "--edition=2024", "--target"]).arg(env::var_os("TARGET")?);
    rustc.arg("--out-dir").arg(&folder).args(["-C", &format!("link-arg={SORTED}")]);
    let flags = env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    rustc.args(flags.split('\u{1f}').filter(|flag| !flag.is_empty()));
    if let Some(linker) = env::var_os("RUSTC_LINKER") {
        let mut option = std::ffi::OsString::from("linker=");
        option.push(linker);
        rustc.arg("-C").arg(option);
    }
    Some(rustc.arg(source).output().ok()?.status.success())
}

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let is_linux = env::var("CARGO_CFG_TARGET_OS").is_ok_and(|system| system == "linux");
    if is_linux && is_understood() == Some(true) {
        println!("cargo::rustc-cdylib-link-arg={SORTED}");
    }
}
