//! Programs that look for the library by pkg-config and by CMake, where `make install` put it, moved elsewhere since.

use crate::languages::{is_as_expected, path};
use crate::library::{Scratch, built, couplet, here};
use crate::tool::has;
use std::fs;

/// The library and the command as they are installed, in another folder by now.
struct Moved {
    scratch: Scratch,
}

impl Moved {
    fn new() -> Self {
        let moved = Self { scratch: Scratch::new() };
        moved.make("install");
        fs::rename(moved.scratch.path("stage/opt/couplet"), moved.prefix()).unwrap();
        moved
    }

    fn prefix(&self) -> String {
        self.scratch.path("elsewhere")
    }

    /// Runs a target of the Makefile, as a packager does; nothing of what was built is built again.
    fn make(&self, target: &str) {
        let variables = [
            format!("DESTDIR={}", self.scratch.path("stage")),
            "PREFIX=/opt/couplet".to_owned(),
            format!("C={}", path(&built())),
            format!("COMMAND={}", path(&couplet())),
        ];
        let home = path(here().parent().unwrap());
        let mut words = vec!["-u", "MAKEFLAGS", "make", "--silent", "-C", &home, target];
        words.extend(variables.iter().map(String::as_str));
        self.scratch.run("env", &words);
    }
}

#[test]
fn what_is_uninstalled_is_gone() {
    let moved = Moved::new();
    let version = |command: &str| moved.scratch.run(command, &["--version"]);
    assert_eq!(version(&format!("{}/bin/couplet", moved.prefix())), version(&path(&couplet())));
    fs::rename(moved.prefix(), moved.scratch.path("stage/opt/couplet")).unwrap();
    moved.make("uninstall");
    let left = moved.scratch.run("find", &["stage", "-type", "f", "-o", "-type", "l"]);
    assert_eq!(left, "");
}

#[test]
fn a_program_finds_it_by_pkg_config() {
    if !has("gcc", "--version") || !has("pkg-config", "--version") {
        return;
    }
    let moved = Moved::new();
    let compile = format!(
        "export PKG_CONFIG_PATH={prefix}/lib/pkgconfig; gcc -Wall -Werror {source} \
         $(pkg-config --cflags --libs couplet_c) -Wl,-rpath,{prefix}/lib -o program",
        prefix = moved.prefix(),
        source = path(&here().join("examples/arches.c")),
    );
    moved.scratch.run("sh", &["-c", &compile]);
    is_as_expected(&moved.scratch.run(&moved.scratch.path("program"), &[]));
    // What it needs of the library has the version of the library's symbols.
    let needed = moved.scratch.run("nm", &["-D", "--undefined-only", "program"]);
    let ours: Vec<_> = needed.lines().filter(|line| line.contains("couplet_")).collect();
    assert!(ours.len() > 5 && ours.iter().all(|line| line.contains("@COUPLET_C_")), "{ours:?}");
}

#[test]
fn a_program_finds_it_by_cmake() {
    if !has("gcc", "--version") || !has("cmake", "--version") {
        return;
    }
    let moved = Moved::new();
    let version = env!("CARGO_PKG_VERSION");
    let minor = concat!(env!("CARGO_PKG_VERSION_MAJOR"), ".", env!("CARGO_PKG_VERSION_MINOR"));
    let (source, prefix) = (path(&here().join("tests/programs")), moved.prefix());
    for wanted in [version, minor] {
        let (prefix, wanting) =
            (format!("-DCMAKE_PREFIX_PATH={prefix}"), format!("-DWANTED={wanted}"));
        let said = moved.scratch.run("cmake", &["-S", &source, "-B", wanted, &prefix, &wanting]);
        assert!(said.contains(&format!("couplet_c: {version}")), "{said}");
        moved.scratch.run("cmake", &["--build", wanted]);
        for program in ["shared", "static"] {
            is_as_expected(
                &moved.scratch.run(&moved.scratch.path(&format!("{wanted}/{program}")), &[]),
            );
        }
    }
}
