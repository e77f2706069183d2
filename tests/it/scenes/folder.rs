//! A run writes inside its folder, and replaces what a run wrote.

use super::scene_in;
use crate::program::{Scratch, command, couplet, fed, said};
use std::fs;
use std::process::Output;

const ONE: &str = "[constants]\nlandmarks = \"L\"\ndigits = 5\noutput = \"f.csv\"\n";
const BELOW: &str = "[constants]\nlandmarks = \"L\"\ndigits = 5\noutput = \"link/f.csv\"\n";

/// A scene in a folder with an empty folder `o`, and a run into that.
fn run(scratch: &Scratch, text: &str, options: &[&str]) -> Output {
    let scene = scene_in(scratch, text);
    couplet([&["run", &scene, "-o", &scratch.path("o")], options].concat())
}

fn scratch() -> Scratch {
    let scratch = Scratch::new();
    fs::create_dir(scratch.path("o")).unwrap();
    scratch
}

/// The run is refused in one line with this exit code and these words.
fn is_refused(output: &Output, code: i32, words: &str) {
    let (found, _, message) = said(output);
    assert_eq!((found, message.lines().count()), (Some(code), 1), "{message}");
    assert!(message.contains(words), "{message}");
}

#[cfg(unix)]
mod links {
    use super::*;
    use std::os::unix::fs::symlink;

    #[test]
    fn a_link_of_a_folder_that_leads_outside_is_not_followed() {
        let scratch = scratch();
        fs::create_dir(scratch.path("outside")).unwrap();
        symlink("../outside", scratch.path("o/link")).unwrap();
        is_refused(
            &run(&scratch, BELOW, &["--overwrite"]),
            3,
            "it leads outside the folder of outputs",
        );
        assert!(scratch.files("outside").is_empty());
        // Not even a folder is made there.
        let deeper = BELOW.replace("link/f.csv", "link/deep/f.csv");
        is_refused(&run(&scratch, &deeper, &[]), 3, "it leads outside the folder of outputs");
        assert!(scratch.files("outside").is_empty());
    }

    #[test]
    fn a_link_in_place_of_an_output_does_not_lead_outside() {
        let scratch = scratch();
        scratch.write("mine.txt", "mine");
        symlink("../mine.txt", scratch.path("o/f.csv")).unwrap();
        is_refused(
            &run(&scratch, ONE, &["--overwrite"]),
            3,
            "it leads outside the folder of outputs",
        );
        assert_eq!(scratch.read("mine.txt"), "mine");
        fs::remove_file(scratch.path("mine.txt")).unwrap();
        is_refused(&run(&scratch, ONE, &[]), 3, "it is a link that leads nowhere");
        assert!(!scratch.folder().join("mine.txt").exists());
    }

    #[test]
    fn a_link_inside_the_folder_is_followed_and_so_is_one_to_it() {
        let scratch = scratch();
        fs::create_dir(scratch.path("o/inside")).unwrap();
        symlink("inside", scratch.path("o/link")).unwrap();
        assert_eq!(run(&scratch, BELOW, &[]).status.code(), Some(0));
        assert_eq!(scratch.files("o/inside"), ["f.csv"]);
        symlink("o", scratch.path("other")).unwrap();
        let scene = scene_in(&scratch, ONE);
        let output = couplet(["run", &scene, "-o", &scratch.path("other")]);
        assert_eq!(output.status.code(), Some(0));
        assert_eq!(scratch.files("o"), ["couplet-run.json", "f.csv", "inside", "link"]);
    }

    #[test]
    fn a_record_that_is_a_link_is_not_written_through() {
        let scratch = scratch();
        scratch.write("mine.txt", "mine");
        symlink("../mine.txt", scratch.path("o/couplet-run.json")).unwrap();
        for options in [&[][..], &["--resume"], &["--overwrite"]] {
            let words = "couplet-run.json: it is a link, a folder, a pipe or a device";
            is_refused(&run(&scratch, ONE, options), 3, words);
        }
        assert_eq!(scratch.read("mine.txt"), "mine");
    }

    #[test]
    fn a_record_that_is_a_pipe_is_not_waited_for() {
        let scratch = scratch();
        let pipe = scratch.path("o/couplet-run.json");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        for options in [&[][..], &["--resume"]] {
            is_refused(&run(&scratch, ONE, options), 3, "a pipe or a device");
        }
    }
}

#[test]
fn a_file_that_no_run_wrote_is_kept() {
    let scratch = scratch();
    scratch.write("o/f.csv", "mine");
    is_refused(
        &run(&scratch, ONE, &[]),
        2,
        "f.csv is there, and no run wrote it; --overwrite replaces it",
    );
    assert_eq!((scratch.read("o/f.csv").as_str(), scratch.files("o").len()), ("mine", 1));
    assert_eq!(run(&scratch, ONE, &["--overwrite"]).status.code(), Some(0));
    assert!(scratch.read("o/f.csv").starts_with("weight,landmark,"));
    // From now on it is the run's.
    assert_eq!(run(&scratch, ONE, &[]).status.code(), Some(0));
    // Of all outputs, before any is written.
    let two =
        format!("[{ONE}{}", ONE.replace("[constants]", "[[constants]]").replace("f.csv", "g.csv"))
            .replacen("[constants]", "[constants]]", 1);
    scratch.write("o/g.csv", "mine");
    fs::remove_file(scratch.path("o/f.csv")).unwrap();
    is_refused(&run(&scratch, &two, &[]), 2, "g.csv is there");
    assert!(!scratch.folder().join("o/f.csv").exists());
}

#[test]
fn a_scene_without_a_folder_keeps_what_is_in_the_current_one() {
    let scratch = scratch();
    scratch.write("f.csv", "mine");
    scene_in(&scratch, ONE);
    let run = || command("run scene.toml").current_dir(scratch.folder()).output().unwrap();
    is_refused(&run(), 2, "f.csv is there, and no run wrote it");
    fs::remove_file(scratch.path("f.csv")).unwrap();
    assert_eq!((run().status.code(), run().status.code()), (Some(0), Some(0)));
}

#[test]
fn a_record_larger_than_any_is_no_record() {
    let scratch = scratch();
    let record =
        format!("{{\"schema\":\"couplet.run/1\",\"outputs\":{{}}}}{}", " ".repeat(17 << 20));
    scratch.write("o/couplet-run.json", record);
    is_refused(&run(&scratch, ONE, &["--resume"]), 2, "is not the record of a run");
    assert_eq!(run(&scratch, ONE, &["--overwrite"]).status.code(), Some(0));
    assert!(scratch.read("o/couplet-run.json").len() < 1000);
}

#[test]
fn a_run_has_no_standard_output_for_a_folder() {
    let text = format!("schema = \"couplet.scene/1\"\n{ONE}");
    is_refused(&fed("run - -o -", text), 2, "not to standard output");
}
