//! What belongs to the user stays as it is: permissions, owners, links.

use crate::program::{Scratch, command, couplet, said};
use std::fs::{self, Permissions};
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::os::unix::process::CommandExt;
use std::process::{Command, Output};

fn mode(scratch: &Scratch, name: &str) -> u32 {
    fs::metadata(scratch.path(name)).unwrap().permissions().mode() & 0o7777
}

fn set_mode(path: &str, mode: u32) {
    fs::set_permissions(path, Permissions::from_mode(mode)).unwrap();
}

/// Writes the constants of `L` over a file.
fn write(command: &mut Command, path: &str) -> Output {
    command.args(["constants", "L", "--digits", "5", "-o", path]).output().unwrap()
}

fn is_root() -> bool {
    let scratch = Scratch::new();
    fs::metadata(scratch.folder()).unwrap().uid() == 0
}

/// The program as somebody who is not allowed everything: root runs it as another user, in a folder that is open to
/// all.
fn as_another_user(scratch: &Scratch) -> Command {
    set_mode(&scratch.path("."), 0o777);
    if !is_root() {
        return command([]);
    }
    // Where the program lies is perhaps nobody else's.
    let program = scratch.path("program");
    // By a process of its own: what another thread starts meanwhile would hold the file open, which cannot be run then.
    let copied = Command::new("cp").args([env!("CARGO_BIN_EXE_couplet"), &program]).status();
    assert!(copied.unwrap().success());
    set_mode(&program, 0o755);
    let mut command = Command::new(program);
    command.uid(65_534).gid(65_534);
    command
}

#[test]
fn permissions_are_kept() {
    let scratch = Scratch::new();
    // What runs as its owner, or its group, is another program from now on.
    for (given, kept) in
        [(0o600, 0o600), (0o640, 0o640), (0o755, 0o755), (0o4755, 0o755), (0o2750, 0o750)]
    {
        scratch.write("f", "old");
        set_mode(&scratch.path("f"), given);
        assert_eq!(write(&mut command([]), &scratch.path("f")).status.code(), Some(0));
        assert_eq!(mode(&scratch, "f"), kept);
        assert!(scratch.read("f").contains("2.7865"));
    }
}

#[test]
fn a_file_that_must_not_be_written_is_not_replaced() {
    let scratch = Scratch::new();
    scratch.write("f", "mine");
    set_mode(&scratch.path("f"), 0o444);
    let path = scratch.path("f");
    let (code, output, message) = said(&write(&mut as_another_user(&scratch), &path));
    let words = format!("couplet: cannot write {path}: permission denied\n");
    assert_eq!((code, output.as_str(), message), (Some(3), "", words));
    assert_eq!((scratch.read("f").as_str(), mode(&scratch, "f")), ("mine", 0o444));
}

/// Only root has files of two owners to test with.
#[test]
fn an_owner_is_kept() {
    if !is_root() {
        return;
    }
    let scratch = Scratch::new();
    // Root writes what is somebody's; somebody writes what is root's and open to all.
    for (owner, mode) in [(65_534, 0o600), (0, 0o666)] {
        scratch.write("f", "old, and longer than what comes in its place; ".repeat(100));
        let path = scratch.path("f");
        set_mode(&path, mode);
        std::os::unix::fs::chown(&path, Some(owner), Some(owner)).unwrap();
        let mut program = if owner == 0 { as_another_user(&scratch) } else { command([]) };
        assert_eq!(said(&write(&mut program, &path)), (Some(0), String::new(), String::new()));
        let file = fs::metadata(&path).unwrap();
        assert_eq!((file.uid(), file.gid(), self::mode(&scratch, "f")), (owner, owner, mode));
        assert!(scratch.read("f").contains("2.7865") && !scratch.read("f").contains("old"));
    }
    let hidden = scratch.files(".").into_iter().find(|name| name.starts_with(".couplet"));
    assert_eq!(hidden, None);
}

#[test]
fn a_link_is_followed_and_stays() {
    let scratch = Scratch::new();
    scratch.write("f", "old");
    symlink("f", scratch.path("link")).unwrap();
    assert_eq!(write(&mut command([]), &scratch.path("link")).status.code(), Some(0));
    assert!(fs::symlink_metadata(scratch.path("link")).unwrap().is_symlink());
    assert!(scratch.read("f").contains("2.7865"));
}

#[test]
fn a_link_that_leads_nowhere_is_not_replaced() {
    let scratch = Scratch::new();
    symlink("nothing", scratch.path("link")).unwrap();
    let path = scratch.path("link");
    let (code, _, message) = said(&couplet(["constants", "L", "-o", &path]));
    let words = format!("couplet: cannot write {path}: it is a link that leads nowhere\n");
    assert_eq!((code, message), (Some(3), words));
    assert!(fs::symlink_metadata(&path).unwrap().is_symlink());
    assert_eq!(scratch.files("."), ["link"]);
}
