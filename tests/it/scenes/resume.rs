//! A run goes on where it was.

use super::{THREE, scene_in};
use crate::program::{Scratch, command, couplet, said as said_whole, tells, text};
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

/// What was said of each output: its name and whether it was kept.
fn said(output: &Output) -> Vec<(String, bool)> {
    text(&output.stderr)
        .lines()
        .filter_map(|line| {
            let (word, path) = line.split_once(' ')?;
            let name = Path::new(path.trim()).file_name()?.to_str()?.to_owned();
            ["kept", "written"].contains(&word).then_some((name, word == "kept"))
        })
        .collect()
}

fn kept(output: &Output) -> Vec<String> {
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    said(output).into_iter().filter(|(_, kept)| *kept).map(|(name, _)| name).collect()
}

#[test]
fn a_run_is_the_same_every_time() {
    let scratch = Scratch::new();
    let scene = scene_in(&scratch, THREE);
    let mut all = Vec::new();
    for (folder, threads) in [("one", "1"), ("two", "2"), ("three", "7")] {
        let output = command(["run", &scene, "--output", &scratch.path(folder)])
            .env("RAYON_NUM_THREADS", threads)
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(0));
        let files = ["claims.json", "constants.json", "couplet-run.json", "deep"];
        assert_eq!(scratch.files(folder), files);
        let files = ["claims.json", "constants.json", "couplet-run.json", "deep/arches.csv"];
        let contents = files.map(|name| scratch.read(&format!("{folder}/{name}")));
        all.push((contents, output.stdout));
    }
    assert!(all[0] == all[1] && all[1] == all[2]);
    assert!(text(&all[0].1).starts_with("Arches at their least thickness"));
}

#[test]
fn resuming_keeps_what_is_complete_by_its_content() {
    let scratch = Scratch::new();
    let scene = scene_in(&scratch, THREE);
    let out = scratch.path("out");
    let resume = || couplet(["run", &scene, "--output", &out, "--resume"]);
    let all = ["constants.json", "arches.csv", "claims.json"];
    assert!(kept(&resume()).is_empty(), "nothing is there yet");
    let paths = ["constants.json", "deep/arches.csv", "claims.json"];
    let first = paths.map(|name| scratch.read(&format!("out/{name}")));
    assert_eq!(kept(&resume()), all);
    // What is printed is printed again, and is all that is computed.
    let again = couplet(["run", &scene, "--output", &out, "--resume", "--explain"]);
    tells(&text(&again.stderr), ["to compute: 1 arch, each once"]);
    // Without --resume everything is written anew.
    assert!(kept(&couplet(["run", &scene, "--output", &out])).is_empty());

    // Damaged, then gone: that one is written again as it was.
    fs::write(scratch.path("out/deep/arches.csv"), "weight,half_opening\n").unwrap();
    assert_eq!(kept(&resume()), ["constants.json", "claims.json"]);
    fs::remove_file(scratch.path("out/claims.json")).unwrap();
    assert_eq!(kept(&resume()), ["constants.json", "arches.csv"]);
    for (name, content) in paths.into_iter().zip(first) {
        assert_eq!(scratch.read(&format!("out/{name}")), content, "{name}");
    }

    // Something else is asked: of one item, of all that have digits, or of none.
    scene_in(&scratch, &THREE.replace("prove = [\"eq-7\", ", "prove = ["));
    assert_eq!(kept(&resume()), ["constants.json", "arches.csv"]);
    let fewer = THREE.replace("prove = [\"eq-7\", ", "prove = [");
    scene_in(&scratch, &fewer.replace("digits = 20", "digits = 21"));
    assert_eq!(kept(&resume()), ["claims.json"]);
    scene_in(&scratch, THREE);
    resume();
    scene_in(&scratch, &format!("# In other words.\n{}", THREE.replace("\"T\"", "[ 'T' ]")));
    assert_eq!(kept(&resume()), all);

    // A record that is damaged or of another time proves nothing, and is not replaced without a word.
    for record in ["", "{}", "{\"schema\": \"couplet.run/9\", \"outputs\": {}}"] {
        fs::write(scratch.path("out/couplet-run.json"), record).unwrap();
        let (code, _, message) = said_whole(&resume());
        assert_eq!((code, message.lines().count()), (Some(2), 1), "{message}");
        tells(&message, ["is not the record of a run; --overwrite replaces it"]);
        assert_eq!(scratch.read("out/couplet-run.json"), record);
        let over = couplet(["run", &scene, "--output", &out, "--resume", "--overwrite"]);
        assert!(kept(&over).is_empty(), "{record}");
    }
}

#[test]
fn an_interrupted_run_leaves_whole_files_and_goes_on_where_it_was() {
    let scratch = Scratch::new();
    let quick = "[[constants]]\nlandmarks = \"T\"\noutput = \"quick.csv\"\n";
    let slow =
        "[[constants]]\nlandmarks = [\"S\", \"J\"]\ndigits = 1_000_000\noutput = \"slow.csv\"\n";
    let scene = scene_in(&scratch, &format!("{quick}{slow}"));
    let out = scratch.path("out");
    let mut child =
        command(["run", &scene, "--output", &out]).stderr(Stdio::piped()).spawn().unwrap();
    let start = Instant::now();
    let is_noted = || {
        let record = fs::read_to_string(scratch.path("out/couplet-run.json"));
        record.is_ok_and(|record| record.contains("\"asked\": \""))
    };
    while !is_noted() && start.elapsed() < Duration::from_secs(100) {
        std::thread::sleep(Duration::from_millis(20));
    }
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(killed.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert_eq!(scratch.files("out"), ["couplet-run.json", "quick.csv"]);
    // The slow item is not what is tested here.
    scene_in(&scratch, &format!("{quick}{}", slow.replace("1_000_000", "100")));
    let output = couplet(["run", &scene, "--output", &out, "--resume"]);
    assert_eq!(said(&output), [("quick.csv".to_owned(), true), ("slow.csv".to_owned(), false)]);
}
