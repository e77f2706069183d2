//! The header is that of the source, and the library has its functions and no others.

use crate::library::{built, here, symbols};
use std::collections::BTreeSet;
use std::fs;

/// The header of the source, with the version of the source.
fn made() -> String {
    let mut config = cbindgen::Config::from_file(here().join("cbindgen.toml")).unwrap();
    let macros = config.after_includes.as_mut().unwrap();
    for (name, number) in [
        ("@VERSION@", env!("CARGO_PKG_VERSION")),
        ("@MAJOR@", env!("CARGO_PKG_VERSION_MAJOR")),
        ("@MINOR@", env!("CARGO_PKG_VERSION_MINOR")),
        ("@PATCH@", env!("CARGO_PKG_VERSION_PATCH")),
    ] {
        *macros = macros.replace(name, number);
    }
    let header = cbindgen::Builder::new().with_crate(here()).with_config(config);
    let mut bytes = Vec::new();
    header.generate().unwrap().write(&mut bytes);
    String::from_utf8(bytes).unwrap()
}

/// The functions that a header declares.
fn declared(header: &str) -> BTreeSet<String> {
    let before = header.split('(').map(|text| text.rsplit([' ', '*', '\n']).next().unwrap());
    before.filter(|name| name.starts_with("couplet_")).map(str::to_owned).collect()
}

#[test]
fn the_header_is_that_of_the_source() {
    let (path, made) = (here().join("include/couplet_c.h"), made());
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        return fs::write(path, made).unwrap();
    }
    assert_eq!(fs::read_to_string(path).unwrap_or_default(), made, "make header");
}

#[test]
#[cfg(target_os = "linux")]
fn the_libraries_have_the_functions_of_the_header_and_no_others() {
    let declared = declared(&made());
    assert!(declared.len() > 15 && declared.contains("couplet_states"), "{declared:?}");
    assert_eq!(symbols("libcouplet_c.a", &["-g", "--defined-only"]), declared);
    // Each of the shared one is of the version that its name has, which is a symbol too.
    let version = format!("COUPLET_C_{}", number());
    let versioned = declared.iter().map(|name| format!("{name}@@{version}"));
    let versioned: BTreeSet<_> = versioned.chain([version.clone()]).collect();
    assert_eq!(symbols("libcouplet_c.so", &["-D", "--defined-only"]), versioned);
}

/// The number in the name of the shared library, that programs look for.
#[cfg(target_os = "linux")]
fn number() -> String {
    let name = fs::read_link(built().join("lib/libcouplet_c.so")).unwrap();
    name.to_str().unwrap().strip_prefix("libcouplet_c.so.").unwrap().to_owned()
}

/// Neither the folder of the source nor that of whoever built them.
#[test]
fn no_folder_of_the_machine_is_in_the_libraries() {
    let folders = [Some(here().parent().unwrap().into()), std::env::var_os("HOME")];
    for entry in fs::read_dir(built().join("lib")).unwrap() {
        let path = entry.unwrap().path();
        let bytes = if path.is_file() { fs::read(&path).unwrap() } else { continue };
        for folder in folders.iter().flatten() {
            let folder = format!("{}/", folder.to_str().unwrap());
            let is_there = bytes.windows(folder.len()).any(|at| at == folder.as_bytes());
            assert!(!is_there, "{folder} in {}", path.display());
        }
    }
}

/// The module for Fortran and the manual have every function too.
#[test]
fn every_function_is_in_the_module_and_in_the_manual() {
    let [module, manual] = ["include/couplet_c.f90", "../docs/c.md"]
        .map(|file| fs::read_to_string(here().join(file)).unwrap());
    for name in declared(&made()) {
        let kinds = ["function", "subroutine"].map(|kind| format!("    {kind} {name}("));
        let interfaces = kinds.iter().map(|begin| module.matches(begin.as_str()).count());
        assert_eq!(interfaces.sum::<usize>(), 1, "{name} in Fortran");
        assert!(manual.contains(&format!("`{name}")), "{name} in docs/c.md");
    }
}
