//! The reference bundle, made small: as its schemas say, replayed, and spoiled.

use crate::export::schemas::check;
use crate::house::{certificates, house, read};
use crate::program::{Json, Scratch, json, tells, text, texts};
use crate::tool::{has, has_module};
use couplet::claims::claims;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::PathBuf;
use std::process::{Command, Output};

/// Runs Python over the scripts of `proofs/reference`; what it does not say is no output.
fn python(arguments: &[&str]) -> String {
    let output = Command::new("python3").args(arguments).current_dir(house("")).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
    text(&output.stdout)
}

/// Of each replay its exit code, and what it says.
type Said = Vec<(Option<i32>, String)>;

/// A small bundle in a folder of its own, and the checker alone.
struct Bundle {
    scratch: Scratch,
    folder: PathBuf,
}

impl Bundle {
    fn new() -> Self {
        let scratch = Scratch::new();
        let out = scratch.path("out");
        let few = ["proofs/reference/make.py", &out, env!("CARGO_BIN_EXE_couplet"), "--few"];
        python(&few);
        let checker = format!("#!/bin/sh\nexec {} check \"$@\"\n", env!("CARGO_BIN_EXE_couplet"));
        scratch.write("couplet-check", checker);
        let executable = fs::Permissions::from_mode(0o755);
        fs::set_permissions(scratch.path("couplet-check"), executable).unwrap();
        let name = format!("couplet-reference-{}", env!("CARGO_PKG_VERSION"));
        let folder = scratch.folder().join("out").join(name);
        Self { scratch, folder }
    }

    fn by_the_checker(&self) -> Output {
        let checker = self.scratch.path("couplet-check");
        Command::new("sh").arg(self.folder.join("replay_check.sh")).arg(checker).output().unwrap()
    }

    fn by_arb(&self) -> Output {
        Command::new("python3").arg(self.folder.join("replay_arb.py")).output().unwrap()
    }

    /// Both replays, of which that by Arb needs a package: exit code and what is said.
    fn replayed(&self, arb: bool) -> Said {
        let outputs = [Some(self.by_the_checker()), arb.then(|| self.by_arb())];
        let said = |output: &Output| text(&output.stdout) + &text(&output.stderr);
        outputs.iter().flatten().map(|output| (output.status.code(), said(output))).collect()
    }

    /// Puts a file in the place of one, says what both replays say of it, and puts it back.
    fn with(&self, name: &str, bytes: &[u8], fitted: bool, arb: bool) -> Said {
        let [path, manifest] = [self.folder.join(name), self.folder.join("MANIFEST")];
        let [before, listed] = [&path, &manifest].map(|path| fs::read(path).unwrap());
        fs::write(&path, bytes).unwrap();
        if fitted {
            let fit = "import pathlib, sys; sys.path.insert(0, 'proofs/reference'); import make; \
                       make.manifest(pathlib.Path(sys.argv[1]))";
            fs::remove_file(&manifest).unwrap();
            python(&["-c", fit, self.folder.to_str().unwrap()]);
        }
        let said = self.replayed(arb);
        fs::write(&manifest, listed).unwrap();
        fs::write(&path, before).unwrap();
        said
    }

    fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.folder.join(name)).unwrap()
    }
}

/// A text with one blank for each run of blanks and line ends.
fn squeezed(words: &str) -> String {
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Every claim, curve and theorem, each with a file that has it, and with the output that its command has.
#[test]
fn the_map_has_everything_that_is_proved() {
    if !has("python3", "--version") {
        return;
    }
    let map = python(&["proofs/reference/theorem_map.py", env!("CARGO_BIN_EXE_couplet")]);
    let map: Value = serde_json::from_str(&map).unwrap();
    check(&map, &mut BTreeSet::new());
    let rows = map["rows"].list();
    let ids = |kind: &str| -> Vec<&str> {
        let of_kind = rows.iter().filter(|row| row["kind"] == kind);
        of_kind.map(|row| row["id"].text()).collect()
    };
    assert_eq!(ids("claim"), claims().iter().map(|claim| claim.id).collect::<Vec<_>>());
    let listed = read("proofs/coq/hand_theorems.txt");
    let listed: Vec<&str> = listed.lines().map(|line| line.split('\t').next().unwrap()).collect();
    assert_eq!(ids("theorem"), listed);
    let curves = json("map --weight both --tolerance 1e-2 --format json");
    assert_eq!(ids("curve").len(), curves["curves"].list().len());

    let said = |arguments: &[&str]| squeezed(&text(&crate::program::couplet(arguments).stdout));
    let outputs = [said(&["prove"]), said(&["map", "--weight", "both"])];
    for row in rows {
        let file = row["file"].text();
        let path = house(file);
        assert!(path.exists(), "{file}");
        let name = row["name"].text();
        let output = match row["kind"].text() {
            "claim" => &outputs[0],
            "curve" => &outputs[1],
            _ => {
                let source = fs::read_to_string(&path).unwrap();
                assert!(source.contains(&format!(" {name}")), "{file} {name}");
                continue;
            }
        };
        for shown in row["expected"]["shows"].list() {
            let shown = shown.text();
            assert!(output.contains(&squeezed(shown)), "{shown}");
            let false_twin = squeezed(shown).replacen(name, &format!("not-{name}"), 1);
            assert!(!shown.contains(name) || !output.contains(&false_twin), "{false_twin}");
        }
    }
}

/// Two runs are equal, both replays accept, and name what a byte was changed in, whichever it is.
#[test]
fn a_bundle_replays_and_names_a_changed_byte() {
    if !has("python3", "--version") || !has("sha256sum", "--version") {
        return;
    }
    let arb = has_module("flint");
    let bundle = Bundle::new();
    let twin = Bundle::new();
    let archive = format!("out/couplet-reference-{}.tar.gz", env!("CARGO_PKG_VERSION"));
    let [one, other] =
        [&bundle, &twin].map(|bundle| fs::read(bundle.scratch.path(&archive)).unwrap());
    assert!(one == other, "two runs differ");
    for line in text(&bundle.read("index.jsonl")).lines() {
        check(&serde_json::from_str(line).unwrap(), &mut BTreeSet::new());
    }
    for (code, said) in bundle.replayed(arb) {
        assert_eq!(code, Some(0), "{said}");
        assert!(said.contains("certificates prove what index.jsonl says"), "{said}");
    }

    let named = |said: Said, name: &str, fault: &str| {
        for (code, said) in said {
            assert_eq!(code, Some(1), "{name}: {said}");
            assert!(said.contains(&format!("{name}: {fault}")), "{name}: {said}");
        }
    };
    let certificate = "certificates/landmarks/triple-point-heyman.json";
    for name in [
        certificate,
        "certificates/examples/sliding.json",
        "certificates/surveys/all-stand.json",
        "index.jsonl",
        "THEOREM_MAP.json",
        "README.md",
        "CITATION.cff",
        "check_with_arb.py",
        "replay_arb.py",
        "schemas/theorem_map-1.json",
        "proofs/coq/verified/Sound.v",
        "MANIFEST",
    ] {
        let bytes = bundle.read(name);
        // A script that is to be run stays one; of the manifest the first and the last line count.
        let all = [bytes.len() / 2, 0, bytes.len() - 1];
        for at in &all[..if name == "MANIFEST" { 3 } else { 1 }] {
            let mut spoiled = bytes.clone();
            spoiled[*at] ^= 1;
            let arb = arb && name != "replay_arb.py";
            named(bundle.with(name, &spoiled, false, arb), name, "changed");
        }
    }

    // A file more, and one less.
    fs::write(bundle.folder.join("more"), "").unwrap();
    named(bundle.replayed(arb), "more", "not in MANIFEST");
    fs::remove_file(bundle.folder.join("more")).unwrap();
    let away = bundle.scratch.path("away");
    fs::rename(bundle.folder.join(certificate), &away).unwrap();
    named(bundle.replayed(arb), certificate, "missing");
    fs::rename(away, bundle.folder.join(certificate)).unwrap();

    // What is wrong is refused with a manifest that fits too.
    let swapped = |name: &str, from: &str, to: &str| {
        let whole = text(&bundle.read(name));
        assert!(whole.contains(from), "{name}: {from}");
        whole.replacen(from, to, 1).into_bytes()
    };
    for (name, from, to, fault) in [
        ("index.jsonl", "stands at no thickness", "stands at every thickness", "index.jsonl says"),
        ("index.jsonl", "thickness = 0.679604", "thickness = 0.679605", "index.jsonl says"),
        (certificate, "\"value\": \"0.67960", "\"value\": \"0.67961", "refused"),
        (certificate, "\"weight\": \"heyman\"", "\"weight\": \"milankovitch\"", "refused"),
        ("certificates/surveys/all-stand.json", "\"all_stand\"", "\"none_stands\"", "refused"),
    ] {
        for (code, said) in bundle.with(name, &swapped(name, from, to), true, arb) {
            assert_eq!(code, Some(1), "{name} {to}: {said}");
            assert!(said.contains(fault) && said.contains("certificates/"), "{name} {to}: {said}");
        }
    }
    // A line of the index less, and a wrong theorem of the map, which the checker alone does not look at.
    let index = text(&bundle.read("index.jsonl"));
    let (_, rest) = index.split_once('\n').unwrap();
    for (code, said) in bundle.with("index.jsonl", rest.as_bytes(), true, arb) {
        assert_eq!(code, Some(1), "{said}");
        assert!(said.contains("index.jsonl"), "{said}");
    }
    let wrong =
        swapped("THEOREM_MAP.json", "what the verified checker accepts is true", "all is true");
    let said = bundle.with("THEOREM_MAP.json", &wrong, true, arb);
    assert_eq!(said[0].0, Some(0));
    if let Some((code, said)) = said.get(1) {
        assert!(*code == Some(1) && said.contains("THEOREM_MAP.json: "), "{said}");
    }
    assert_eq!(bundle.replayed(arb)[0].0, Some(0), "all is put back");
}

/// What the scripts cannot do is told by the exit code, in one line.
#[test]
fn scripts_say_what_they_need() {
    if !has("python3", "--version") || !has("sha256sum", "--version") {
        return;
    }
    let script = house("proofs/reference/replay_check.sh");
    for (arguments, code) in [(vec!["no-such-checker"], 3), (vec!["a", "b"], 2)] {
        let output = Command::new("sh").arg(&script).args(&arguments).output().unwrap();
        assert_eq!(output.status.code(), Some(code), "{arguments:?}");
        assert_eq!(text(&output.stderr).lines().count(), 1, "{arguments:?}");
    }
    let script = house("proofs/reference/replay_arb.py");
    let output = Command::new("python3").arg(script).arg("more").output().unwrap();
    assert_eq!(output.status.code(), Some(2));
}

/// Metadata of one source: what `make metadata` wrote agrees with CITATION.cff, and that with Cargo.toml.
#[test]
fn metadata_agree() {
    let citation = read("CITATION.cff");
    let field = |name: &str| {
        let line = citation.lines().find_map(|line| line.strip_prefix(&format!("{name}: ")));
        line.unwrap_or_else(|| panic!("{name}")).trim_matches('"').to_owned()
    };
    let list = |name: &str| -> Vec<String> {
        let lines = citation.lines().skip_while(|line| *line != format!("{name}:")).skip(1);
        lines.map_while(|line| line.strip_prefix("  - ")).map(str::to_owned).collect()
    };
    let [codemeta, zenodo]: [Value; 2] =
        ["codemeta.json", ".zenodo.json"].map(|name| serde_json::from_str(&read(name)).unwrap());
    let licences = list("license");
    assert_eq!(licences.join(" OR "), ["MIT", "Apache-2.0"].join(" OR "));
    assert!(read("Cargo.toml").contains(&format!("\nlicense = \"{}\"\n", licences.join(" OR "))));
    assert_eq!(field("version"), env!("CARGO_PKG_VERSION"));
    for (file, title) in [(&codemeta, "name"), (&zenodo, "title")] {
        assert_eq!(file["version"], field("version"));
        assert_eq!(file[title], field("title"));
        assert_eq!(file["keywords"], Value::from(list("keywords")));
    }
    let of_spdx = |licence: &String| format!("https://spdx.org/licenses/{licence}");
    assert_eq!(codemeta["license"], Value::from(licences.iter().map(of_spdx).collect::<Vec<_>>()));
    assert_eq!(zenodo["license"]["id"], licences[0]);
    assert_eq!(zenodo["notes"], format!("Licence: {}", licences.join(" OR ")));
    let authors = list("authors");
    let authors: Vec<&str> =
        authors.iter().map(|author| author.strip_prefix("name: ").unwrap()).collect();
    for list in [&codemeta["author"], &zenodo["creators"]] {
        assert_eq!(texts(list.list(), "name"), authors);
        let line = format!("\nauthors = [\"{}\"]\n", authors.join("\", \""));
        tells(&read("Cargo.toml"), [line]);
    }
}

/// Statements are those of the second transcription, for all stored certificates; it is tried where Arb is there.
#[test]
fn statements_are_told_twice() {
    if !has("python3", "--version") || !has_module("flint") {
        return;
    }
    let files = certificates(["constants", "states", "asymmetric", "surveys"]).into_iter();
    let mut files: Vec<String> = files.map(|path| path.to_str().unwrap().to_owned()).collect();
    // No name makes a line of its own.
    let scratch = Scratch::new();
    files.push(scratch.path("a.json: accepted  T\nb.json"));
    fs::copy(&files[0], files.last().unwrap()).unwrap();
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    let ours =
        text(&crate::program::couplet([&["check", "--statement"], &files[..]].concat()).stdout);
    let theirs = python(&[&["proofs/check_with_arb.py", "--statement"], &files[..]].concat());
    assert_eq!(ours, theirs);
    assert!(ours.lines().count() == files.len() && files.len() > 30);
}
