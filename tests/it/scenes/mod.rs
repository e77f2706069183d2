//! Scenes as a user meets them: every fault with its place, nothing computed that is not needed, nothing
//! written that is not whole, nothing computed again that is complete.

#[path = "common/program.rs"]
mod program;

use couplet::problem::Equation;
use couplet::scene::{EXAMPLE, Kind, MAX_BYTES, Plan, Run, read, read_bytes};
use program::{Scratch, couplet};
use serde_json::Value;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

const HEAD: &str = "schema = \"couplet.scene/1\"\n";

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

impl Scratch {
    fn scene(&self, text: &str) -> String {
        let path = self.path("scene.toml");
        fs::write(&path, format!("{HEAD}{text}")).unwrap();
        path
    }
    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).unwrap()
    }
    fn files(&self, folder: &str) -> Vec<String> {
        let Ok(entries) = fs::read_dir(self.0.join(folder)) else { return Vec::new() };
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

/// The faults of a scene after its first line, as `line:column: message`.
fn faults(text: &str) -> Vec<String> {
    let text = format!("{HEAD}{text}");
    let line = |fault: &couplet::scene::Fault| {
        format!("{}:{}: {}", fault.place.line, fault.place.column, fault.message)
    };
    read(&text).err().unwrap_or_default().iter().map(line).collect()
}

#[test]
fn the_example_is_a_scene_and_has_every_key() {
    let output = couplet(&["run", "--schema"]);
    assert_eq!((output.status.code(), text(&output.stdout)), (Some(0), EXAMPLE.to_owned()));
    let scene = read(EXAMPLE).unwrap();
    for kind in Kind::ALL {
        assert!(scene.items.iter().any(|item| item.what.kind() == kind), "{}", kind.name());
        for key in kind.keys() {
            assert!(EXAMPLE.contains(&format!("\n{key} = ")), "{} {key}", kind.name());
        }
    }
    for name in couplet::report::STATE_VALUES.into_iter().chain(couplet::report::ASSESS_VALUES) {
        assert!(EXAMPLE.contains(name), "{name}");
    }
    for quantity in couplet::problem::Quantity::ALL.iter().filter(|q| q.in_radians().is_none()) {
        assert!(EXAMPLE.contains(quantity.name()), "{}", quantity.name());
    }
}

/// Runs an example into a folder and gives the folder.
fn example(name: &str) -> Scratch {
    let scratch = Scratch::new(name);
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(name);
    let output = couplet(&["run", scene.to_str().unwrap(), "--output", &scratch.path("")]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(output.stdout.is_empty());
    scratch
}

/// A column of a CSV file.
fn column(csv: &str, name: &str) -> Vec<String> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let place = reader.headers().unwrap().iter().position(|header| header == name).unwrap();
    reader.records().map(|record| record.unwrap()[place].to_owned()).collect()
}

#[test]
fn reference_constants_for_a_paper() {
    let out = example("reference-constants.toml");
    let table = out.read("constants.txt");
    let thickness = "0.61831824107432344637443225651706527335559298950489";
    assert!(table.contains(&format!("eta = t/r           {thickness}\n")), "{table}");
    assert!(!table.contains("beta_r, rad"), "not asked for");
    let file: Value = serde_json::from_str(&out.read("constants.json")).unwrap();
    assert_eq!(file["digits"], 50);
    assert!(file["schema"].as_str().unwrap().starts_with("couplet.constants/"));
    let constants = file["constants"].as_array().unwrap();
    assert!(constants.iter().any(|constant| constant["value"] == thickness));
}

#[test]
fn a_table_for_the_semicircle_under_falling_friction() {
    let out = example("semicircle-friction.toml");
    let csv = out.read("semicircle.csv");
    let (weight, friction, eta) =
        (column(&csv, "weight"), column(&csv, "friction"), column(&csv, "thickness"));
    assert_eq!(eta.len(), 28);
    let of = |w: &str, mu: &str| {
        (0..28).find(|&k| weight[k] == w && friction[k] == mu).map(|k| eta[k].as_str()).unwrap()
    };
    // The literature: 0.107426, and 0.122192 with a friction of 0.38.
    assert!(of("heyman", "inf").starts_with("0.107426"), "{}", of("heyman", "inf"));
    assert!(of("heyman", "0.38").starts_with("0.122191"));
    assert_eq!(of("heyman", "0.4"), of("heyman", "inf"), "rotation does not see the friction");
    assert_eq!(of("heyman", "0.3"), "", "it slides");
    assert!(!csv.contains("joint"), "not asked for");
}

#[test]
fn a_horseshoe_study() {
    let out = example("horseshoe.toml");
    let csv = out.read("horseshoe.csv");
    assert_eq!(column(&csv, "half_opening")[..4], ["95deg", "95deg", "95deg", "100deg"]);
    let modes = column(&csv, "mode");
    assert_eq!(modes.len(), 33);
    for mode in ["[r,r,r]", "[s,r,r]", ""] {
        assert!(modes.iter().any(|m| m == mode), "{mode} in {modes:?}");
    }
    assert!(out.read("landmarks.txt").contains("139.232703571"), "the half opening of T");
}

#[test]
fn a_verification_run() {
    let out = example("verification.toml");
    let claims = out.read("claims.txt");
    assert!(claims.contains("1 refuted as printed and proved as corrected"), "{claims}");
    let audit = out.read("audit.csv");
    assert!(column(&audit, "landmark").iter().all(|landmark| landmark == "T" || landmark == "l"));
    assert!(column(&audit, "verdict").contains(&"wrong".to_owned()));
    let vault = out.read("vault.csv");
    let stands = column(&vault, "stands");
    assert_eq!(stands.iter().filter(|stands| *stands == "true").count(), 7, "{vault}");
}

#[test]
fn values_for_a_c_solver() {
    let out = example("c-solver.toml");
    let csv = out.read("states.csv");
    let (value, hex) = (column(&csv, "thickness"), column(&csv, "thickness_hex"));
    assert_eq!(hex.len(), 40);
    let place = value.iter().position(|value| value == "0.10747803810747631").unwrap();
    assert_eq!(hex[place], "0x1.b83ae42b5b8e5p-4");
    let header = out.read("landmarks.h");
    assert!(header.contains("COUPLET_T_HEYMAN_THICKNESS "), "{header}");
    assert!(!header.contains("ROTATION_JOINT"), "not asked for");
    // The hash is that of the certificate that `couplet certify` writes.
    let certificate = couplet::certify::fingerprint(
        couplet::problem::Landmark::Triple,
        couplet::arch::SelfWeight::Heyman,
        17,
    );
    assert!(header.contains(&certificate.unwrap()), "{header}");
}

/// Every class of fault: what comes after the first line, and what is said of it.
const FAULTS: [(&str, &str); 47] = [
    (
        "",
        "1:1: the scene asks for nothing; it may have [[constants]], [[arches]], [[claims]], [[audit]]",
    ),
    ("digits = 3\ndigits = 4\n", "3:1: not TOML: duplicate key"),
    ("[[arches]\n", "2:10: not TOML: unclosed array table, expected `]`"),
    (
        "colour = 1\n",
        "2:1: there is no key \"colour\" in a scene; the keys are schema, digits, weight, constants, arches, claims, audit",
    ),
    ("digits = \"30\"\n", "2:10: digits \"30\" is not a whole number from 1 to 1000000"),
    ("digits = 0\n", "2:10: digits 0 is not a whole number from 1 to 1000000"),
    ("weight = [\"heyman\", \"heyman\"]\n", "2:21: weight \"heyman\" is listed twice"),
    ("weight = []\n", "2:10: weight is an empty list; give one of heyman, milankovitch"),
    ("constants = 3\n", "2:13: constants 3 is not a table [[constants]]"),
    (
        "[constants]\nlandmarks = \"X\"\n",
        "3:13: landmarks \"X\" is not one of T, S, J, B, l, L, sb",
    ),
    (
        "[constants]\nlandmarks = [\"T\", 3]\n",
        "3:19: landmarks 3 is not one of T, S, J, B, l, L, sb",
    ),
    (
        "[constants]\nlandmark = \"T\"\n",
        "3:1: there is no key \"landmark\" in [[constants]] (did you mean \"landmarks\"?); the keys are landmarks, quantities, weight, digits, format, output",
    ),
    (
        "[constants]\nlandmarks = \"sb\"\nquantities = \"friction\"\n",
        "4:14: none of the landmarks has the quantity friction",
    ),
    (
        "[constants]\nquantities = \"thicknes\"\n",
        "3:14: quantities \"thicknes\" is not one of thickness, friction, friction_angle, friction_angle_degrees, half_opening, half_opening_degrees, thrust, intrinsic_thrust, rotation_joint, rotation_joint_degrees, sliding_joint, sliding_joint_degrees, A (did you mean \"thickness\"?)",
    ),
    ("[audit]\nformat = \"xml\"\n", "3:10: format \"xml\" is not one of table, json, csv"),
    (
        "[audit]\noutput = \"a.xml\"\n",
        "3:10: output \"a.xml\" does not tell a format by its end (txt, json, csv); give it such an end, or a format, one of table, json, csv",
    ),
    ("[constants]\noutput = 3\n", "3:10: output 3 is not a text"),
    (
        "[constants]\noutput = \"../a.csv\"\n",
        "3:10: output \"../a.csv\" is not a file inside the folder of outputs (a relative path without ..)",
    ),
    (
        "[constants]\noutput = \"/a.csv\"\n",
        "3:10: output \"/a.csv\" is not a file inside the folder of outputs (a relative path without ..)",
    ),
    (
        "[constants]\noutput = \"a\\nb.csv\"\n",
        "3:10: output \"a\\nb.csv\" is not a file inside the folder of outputs (a relative path without ..)",
    ),
    (
        "[constants]\noutput = \"couplet-run.json\"\n",
        "3:10: output \"couplet-run.json\" is where the run keeps its own record",
    ),
    (
        "[[constants]]\noutput = \"a.csv\"\n[[audit]]\noutput = \"./a.csv\"\n",
        "5:10: output \"./a.csv\" is already written by the item whose output is in line 3",
    ),
    (
        "[[constants]]\noutput = \"a.csv\"\n[[audit]]\noutput = \"A.csv\"\n",
        "5:10: output \"A.csv\" differs in case only from the output in line 3",
    ),
    (
        "[[constants]]\noutput = \"a.csv\"\n[[audit]]\noutput = \"a.csv/b.csv\"\n",
        "5:10: output \"a.csv/b.csv\" and the output in line 3 cannot be a file and its folder",
    ),
    (
        "[arches]\nhalf_opening = 1\nfriction = 1\nquantities = \"least_thickness\"\n",
        "5:14: quantities \"least_thickness\" is not one of thickness, thrust, intrinsic_thrust, rotation_joint, sliding_joint, sliding_friction, rotational_friction",
    ),
    (
        "[arches]\nfriction = 1\n",
        "2:1: half_opening is missing; give an angle (2.45, \"pi/2\", \"80deg\")",
    ),
    (
        "[arches]\nhalf_opening = 1\n",
        "2:1: friction is missing; give a coefficient (0.6, \"3/5\", \"inf\"), or friction_angle, an angle (0.5, \"pi/6\", \"21deg\")",
    ),
    (
        "[arches]\nhalf_opening = 1\nfriction = 1\nfriction_angle = 1\n",
        "5:18: friction_angle besides friction; give one of them",
    ),
    (
        "[arches]\nfriction = 1\nhalf_opening = \"200deg\"\n",
        "4:16: half_opening \"200deg\" is not between 0 and pi (180deg)",
    ),
    (
        "[arches]\nfriction = 1\nhalf_opening = \"2pideg\"\n",
        "4:16: half_opening: '2pideg' has two units",
    ),
    (
        "[arches]\nhalf_opening = 1\nfriction = 1e99999999999999999999\n",
        "4:12: friction: '1e99999999999999999999' is out of range: numbers from 1e-1000 to 1e1000 are read",
    ),
    (
        "[arches]\nfriction = 1\nhalf_opening = [1, true]\n",
        "4:20: half_opening true is not an angle (2.45, \"pi/2\", \"80deg\")",
    ),
    (
        "[arches]\nfriction = 1\nhalf_opening = []\n",
        "4:16: half_opening is an empty list; give an angle (2.45, \"pi/2\", \"80deg\")",
    ),
    (
        "[arches]\nhalf_opening = 1\nfriction = [0.5, 1, \"1/2\"]\n",
        "4:21: friction \"1/2\" is listed twice, first in line 4, column 13",
    ),
    ("[arches]\nhalf_opening = 1\nfriction = -0.5\n", "4:12: friction -0.5 is not 0 or more"),
    (
        "[arches]\nhalf_opening = 1\nfriction_angle = \"pi\"\n",
        "4:18: friction_angle \"pi\" is not between 0 and pi/2 (90deg)",
    ),
    (
        "[arches]\nhalf_opening = 1\nfriction = 1\nthickness = \"pi/3\"\n",
        "5:13: thickness \"pi/3\" is not a ratio of thickness to radius (0.12, \"3/25\")",
    ),
    (
        "[arches]\nhalf_opening = 1\nfriction = 1\nthickness = 2\n",
        "5:13: thickness 2 is not between 0 and 2",
    ),
    (
        "[arches]\nhalf_opening = 1\nfriction = { from = 0.5, to = 0.3, steps = 3 }\n",
        "4:12: friction from 0.5 to 0.3 does not rise; give the smaller first",
    ),
    (
        "[arches]\nhalf_opening = 1\nfriction = { from = 0.5, to = 0.6, steps = 1 }\n",
        "4:44: steps 1 is not a whole number from 2 to 100000",
    ),
    (
        "[arches]\nhalf_opening = 1\nfriction = { from = 0.5, to = \"inf\", steps = 3 }\n",
        "4:12: friction has a range without end",
    ),
    (
        "[arches]\nhalf_opening = 1\nfriction = { from = 0.5, steps = 3 }\n",
        "4:12: friction has no to; a range is { from = …, to = …, steps = … }",
    ),
    (
        "[arches]\nfriction = 1\nhalf_opening = { from = \"10deg\", to = \"pi/2\", steps = 3 }\n",
        "4:16: half_opening from 10deg to pi/2 is in two units; give both in radians, as multiples of pi, or in degrees",
    ),
    (
        "[arches]\nhalf_opening = { from = 1, to = 2, steps = 1000 }\nfriction = { from = 1, to = 2, steps = 101 }\n",
        "2:1: 101000 arches are too many; a scene has at most 100000",
    ),
    (
        "digits = 20000\n[arches]\nhalf_opening = 1\nfriction = 1\n",
        "3:1: the scene's 20000 digits are too many for arches; give this item digits of its own, 1 to 10000",
    ),
    ("[claims]\nshow = \"yes\"\n", "3:8: show \"yes\" is not true or false"),
    ("[claims]\nprove = [\"eq-16\", \"eq-16\"]\n", "3:19: prove \"eq-16\" is listed twice"),
];

#[test]
fn every_class_of_fault_has_its_place_and_says_what_is_allowed() {
    for (scene, fault) in FAULTS {
        assert_eq!(faults(scene), [fault], "{scene}");
    }
    let claim = faults("[claims]\nprove = \"eq-99\"\n");
    assert!(
        claim[0].starts_with("3:9: prove \"eq-99\" is not a claim (did you mean "),
        "{claim:?}"
    );
    assert!(claim[0].contains("the claims are eq-2, eq-3, "), "{claim:?}");
}

#[test]
fn no_scene_is_so_large_that_reading_it_takes_long() {
    let range = "{ from = 0.1, to = 3, steps = 60_000 }";
    let item = format!("[[arches]]\nhalf_opening = {range}\nfriction = 1\n");
    let start = Instant::now();
    let said = faults(&item.repeat(1001));
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
    assert_eq!(said.len(), 1000, "all items but the first, and that they are too many");
    let second = "60000 arches after 60000 before are too many; a scene has at most 100000";
    assert_eq!(said[0], format!("5:1: {second}"));
    assert_eq!(said[999], "3002:1: a scene has at most 1000 items");

    // A long list on one line, in which everything is wrong.
    let list = "9,".repeat(300_000);
    let start = Instant::now();
    let said = faults(&format!("[arches]\nfriction = 1\nhalf_opening = [{list}]\n"));
    assert!(start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
    assert_eq!(said.len(), 300_000);
    assert_eq!(said[299_999], "4:600015: half_opening 9 is not between 0 and pi (180deg)");
}

#[test]
fn what_is_no_scene_of_this_version_is_said_and_no_more() {
    let at = |text: &[u8]| {
        let faults = read_bytes(text).unwrap_err();
        let fault = &faults[0];
        (faults.len(), format!("{}:{}: {}", fault.place.line, fault.place.column, fault.message))
    };
    let other = at(b"colour = 1\nschema = \"couplet.scene/2\"\n");
    let known = "\"couplet.scene/1\"";
    let message = format!("2:10: schema \"couplet.scene/2\" is not one that is read here: {known}");
    assert_eq!(other, (1, message));
    let missing = at(b"[constants]\n");
    assert_eq!(missing, (1, format!("1:1: schema is missing; a scene has schema = {known}")));
    let latin = at(b"a = 1\n# \xe4\n");
    assert_eq!(latin, (1, "2:3: not TOML: this is no text in UTF-8".to_owned()));
    let long = vec![b'#'; MAX_BYTES + 1];
    assert_eq!(at(&long), (1, format!("1:1: a scene has at most {MAX_BYTES} bytes")));
    // Nested deeper than anything that is meant.
    assert!(read(&format!("{HEAD}x = {}", "[".repeat(100_000))).is_err());
}

/// What a hasty hand makes of a file: cut, or with a piece gone, or twice.
#[test]
fn a_spoiled_scene_is_a_scene_or_has_faults_with_places() {
    let lines = EXAMPLE.lines().count();
    let (mut good, mut bad) = (0, 0);
    let pieces = (0..EXAMPLE.len()).step_by(17).filter(|k| EXAMPLE.is_char_boundary(*k));
    for k in pieces {
        let end = (k + 1..).find(|end| EXAMPLE.is_char_boundary(*end)).unwrap();
        for spoiled in [
            EXAMPLE[..k].to_owned(),
            format!("{}{}", &EXAMPLE[..k], &EXAMPLE[end..]),
            format!("{}{}", &EXAMPLE[..end], &EXAMPLE[k..]),
            format!("{}\"{}", &EXAMPLE[..k], &EXAMPLE[k..]),
            format!("{}]\n[{}", &EXAMPLE[..k], &EXAMPLE[k..]),
        ] {
            match read(&spoiled) {
                Ok(scene) => good += usize::from(!scene.items.is_empty()),
                Err(faults) => {
                    bad += 1;
                    assert!(!faults.is_empty() && faults.is_sorted());
                    for fault in faults {
                        assert!((1..=lines + 2).contains(&fault.place.line), "{fault:?}");
                        assert_eq!(fault.message.lines().count(), 1, "{fault:?}");
                    }
                }
            }
        }
    }
    assert!(good > 100 && bad > 100, "{good} good, {bad} bad");
}

#[test]
fn all_faults_are_said_at_once_and_nothing_is_computed() {
    let scratch = Scratch::new("faults");
    // Valid items that would take hours, with one wrong thing each behind them.
    let mut scene = "[[constants]]\ndigits = 1_000_000\noutput = \"out/all.csv\"\n".to_owned();
    let wrong: Vec<&str> = FAULTS
        .iter()
        .map(|(text, _)| *text)
        .filter(|text| text.starts_with("[arches]") || text.starts_with("[claims]"))
        .collect();
    for text in &wrong {
        scene += &text.replacen("[arches]", "[[arches]]", 1).replacen("[claims]", "[[claims]]", 1);
    }
    let path = scratch.scene(&scene);
    let start = Instant::now();
    let output = couplet(&["run", &path, "--output", &scratch.path("out")]);
    assert!(start.elapsed() < Duration::from_secs(20));
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    assert_eq!(scratch.files("."), ["scene.toml"]);
    let said = text(&output.stderr);
    let lines: Vec<&str> = said.lines().collect();
    assert_eq!(lines.len(), wrong.len() + 1, "{said}");
    let places: Vec<usize> = lines[..wrong.len()]
        .iter()
        .map(|line| {
            let place = line.strip_prefix(&format!("{path}:")).unwrap();
            place.split(':').next().unwrap().parse().unwrap()
        })
        .collect();
    assert!(places.is_sorted(), "{said}");
    let sum = format!("couplet: {path} has {} errors; nothing was computed", wrong.len());
    assert_eq!(lines[wrong.len()], sum);
}

#[test]
fn a_number_is_what_its_text_says() {
    let scratch = Scratch::new("exact");
    // As a double the first would be another number than the second.
    let scene = "[arches]\nhalf_opening = \"pi/2\"\nquantities = \"thickness\"\ndigits = 40\n";
    let run = |friction: &str| {
        let path = scratch.scene(&format!("{scene}friction = {friction}\n"));
        let output = couplet(&["run", &path]);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        let words = text(&output.stdout);
        words.split_whitespace().find(|word| word.starts_with("0.1")).unwrap().to_owned()
    };
    assert_eq!(
        run("0.350000000000000000001"),
        run("\"350000000000000000001/1000000000000000000000\"")
    );
    assert_ne!(run("0.350000000000000000001"), run("0.35"));
    assert_eq!(run("0.35"), run("\"7/20\""));
    assert_eq!(run("+3.5e-1"), run("0.35"));
    assert_eq!(run("0.3_5"), run("0.35"));
}

#[test]
fn a_range_has_both_its_ends_and_exact_steps() {
    let scene = read(&format!(
        "{HEAD}[arches]\nhalf_opening = {{ from = \"pi/6\", to = \"pi/2\", steps = 3 }}\n\
         friction = {{ from = 0.4, to = 1, steps = 4 }}\n"
    ));
    let couplet::scene::What::Arches { arches, .. } = &scene.unwrap().items[0].what else {
        panic!()
    };
    let texts: Vec<(String, &str)> = arches
        .iter()
        .map(|asked| (asked.arch.half_opening().to_string(), asked.friction.as_str()))
        .collect();
    assert_eq!(texts.len(), 12);
    assert_eq!(texts[0], ("pi/6".to_owned(), "0.4"));
    assert_eq!(texts[5], ("pi/3".to_owned(), "0.6"));
    assert_eq!(texts[11], ("pi/2".to_owned(), "1"));
}

/// What a scene costs: evaluations of each equation for each arch and each landmark.
fn costs(scene: &str) -> couplet::scene::Costs {
    let scene = read(&format!("{HEAD}{scene}")).unwrap();
    let plan = Plan::new(&scene, vec![false; scene.items.len()]);
    let mut run = Run::new(&plan);
    for index in 0..scene.items.len() {
        let found = run.item(index, &|| ());
        assert!(found.undecided.is_empty() && found.write(&mut std::io::sink()).is_ok());
    }
    run.costs().clone()
}

/// Whatever is computed once in a process and then kept is kept from here on.
fn warm() {
    costs(
        "weight = \"milankovitch\"\n[arches]\nhalf_opening = [0.5, \"pi/2\", 2.5]\nfriction = [0.5, 1, \"inf\"]\n",
    );
}

const ONE_THICKNESS: &str =
    "[[arches]]\nhalf_opening = \"pi/2\"\nfriction = \"inf\"\nquantities = \"thickness\"\n";

#[test]
fn the_thickness_of_a_rotational_arch_needs_its_proof_and_no_more() {
    warm();
    let costs = costs(ONE_THICKNESS);
    let [Some(cost)] = costs.arches[..] else { panic!() };
    assert!(costs.landmarks.is_empty() && costs.claims.is_empty());
    let tally = cost.tally;
    let rotational = [Equation::LowerThrust, Equation::WholeThrust, Equation::Tangency];
    let count: u64 = rotational.iter().map(|equation| tally.of(*equation)).sum();
    assert!((3..40).contains(&count) && count == tally.evaluations(), "{tally:?}");
    for equation in [
        Equation::UpperThrust,
        Equation::TangencyAtCrown,
        Equation::DoubleThickness,
        Equation::ShoulderSliding,
        Equation::InnerSliding,
        Equation::Steepest,
    ] {
        assert_eq!(tally.of(equation), 0, "{}", equation.label());
    }
    assert_eq!(tally.landmarks, 0);
    // The same as the library's own proof of this arch alone.
    let arch = couplet::certify::state::Arch::new(
        couplet::arch::SelfWeight::Milankovitch,
        "pi/2".parse().unwrap(),
        couplet::certify::state::Friction::Infinite,
    );
    let (_, alone) = couplet::problem::tally::measure(|| arch.unwrap().certify_alone(30));
    assert_eq!(tally, alone);
}

#[test]
fn an_item_adds_its_own_cost_only() {
    warm();
    let one = costs(ONE_THICKNESS);
    let other = "[[arches]]\nhalf_opening = 1.2\nfriction = 0.32\n";
    let both = costs(&format!("{ONE_THICKNESS}{other}"));
    assert_eq!(both.arches.len(), 2);
    assert_eq!(both.arches[0].unwrap().tally, one.arches[0].unwrap().tally);
    assert_eq!(both.arches[1].unwrap().tally, costs(other).arches[0].unwrap().tally);
    let landmark =
        "[[constants]]\nlandmarks = \"T\"\nquantities = \"thickness\"\nweight = \"heyman\"\n";
    let with_landmark = costs(&format!("{ONE_THICKNESS}{landmark}"));
    assert_eq!(with_landmark.arches[0].unwrap().tally, one.arches[0].unwrap().tally);
    assert_eq!(
        with_landmark.landmarks[0].unwrap().tally,
        costs(landmark).landmarks[0].unwrap().tally
    );
}

#[test]
fn what_two_items_share_is_computed_once() {
    warm();
    // The same arch in other words, and the same landmark to fewer digits, cost nothing more.
    let again = ONE_THICKNESS.replace("\"pi/2\"", "\"90deg\"");
    let twice = costs(&format!("{ONE_THICKNESS}{again}"));
    assert_eq!(twice.arches.len(), 1);
    assert_eq!(twice.total().tally, costs(ONE_THICKNESS).total().tally);
    let landmark = "[[constants]]\nlandmarks = \"T\"\nweight = \"heyman\"\n";
    let many = format!("{landmark}digits = 100\n");
    let few = format!("{landmark}digits = 10\nquantities = \"thrust\"\n");
    for both in [format!("{many}{few}"), format!("{few}{many}")] {
        assert_eq!(costs(&both).total().tally, costs(&many).total().tally);
    }
    // An arch with several thicknesses has one state.
    let vault = |thickness: &str| {
        costs(&format!(
            "[arches]\nhalf_opening = \"pi/2\"\nfriction = \"inf\"\nquantities = \"geometric_safety\"\n\
             thickness = {thickness}\n"
        ))
    };
    assert_eq!(vault("[0.1, 0.2, 0.3]").total().tally, vault("0.2").total().tally);
    let range = vault("0.2").total().tally;
    assert_eq!(range.of(Equation::UpperThrust) + range.of(Equation::ShoulderSliding), 0);
}

#[test]
fn an_output_does_not_depend_on_what_else_is_asked() {
    let scratch = Scratch::new("alone");
    let item = "[[constants]]\nlandmarks = [\"T\", \"l\"]\ndigits = 12\noutput = \"a.json\"\n\
                [[arches]]\nhalf_opening = [1, 2]\nfriction = 0.7\ndigits = 8\noutput = \"a.csv\"\n\
                quantities = \"thickness\"\n";
    let others = "[[constants]]\ndigits = 300\noutput = \"b.csv\"\n\
                  [[arches]]\nhalf_opening = [2, 1]\nfriction = \"7/10\"\ndigits = 90\noutput = \"c.json\"\n";
    let alone = scratch.scene(item);
    assert_eq!(couplet(&["run", &alone, "-o", &scratch.path("alone")]).status.code(), Some(0));
    let among = scratch.scene(&format!("{others}{item}"));
    assert_eq!(couplet(&["run", &among, "-o", &scratch.path("among")]).status.code(), Some(0));
    for name in ["a.json", "a.csv"] {
        let (alone, among) =
            (scratch.read(&format!("alone/{name}")), scratch.read(&format!("among/{name}")));
        assert_eq!(alone, among, "{name}");
    }
}

const THREE: &str = "digits = 20\n\
    [[constants]]\nlandmarks = \"T\"\noutput = \"constants.json\"\n\
    [[arches]]\nhalf_opening = { from = 0.5, to = 2.5, steps = 9 }\nfriction = [0.5, 1.5]\n\
    output = \"deep/arches.csv\"\n\
    [[claims]]\nprove = [\"eq-7\", \"eq-16\"]\nshow = true\noutput = \"claims.json\"\n\
    [[arches]]\nhalf_opening = 1\nfriction = 1\n";

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
    let scratch = Scratch::new("twice");
    let scene = scratch.scene(THREE);
    let mut all = Vec::new();
    for (folder, threads) in [("one", "1"), ("two", "2"), ("three", "7")] {
        let output = Command::new(env!("CARGO_BIN_EXE_couplet"))
            .args(["run", &scene, "--output", &scratch.path(folder)])
            .env("RAYON_NUM_THREADS", threads)
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(0));
        assert_eq!(
            scratch.files(folder),
            ["claims.json", "constants.json", "couplet-run.json", "deep"]
        );
        let files = ["claims.json", "constants.json", "couplet-run.json", "deep/arches.csv"];
        let contents = files.map(|name| scratch.read(&format!("{folder}/{name}")));
        all.push((contents, output.stdout));
    }
    assert!(all[0] == all[1] && all[1] == all[2]);
    assert!(text(&all[0].1).starts_with("Arches at their least thickness"));
}

#[test]
fn resuming_keeps_what_is_complete_by_its_content() {
    let scratch = Scratch::new("resume");
    let scene = scratch.scene(THREE);
    let out = scratch.path("out");
    let resume = || couplet(&["run", &scene, "--output", &out, "--resume"]);
    let all = ["constants.json", "arches.csv", "claims.json"];
    assert!(kept(&resume()).is_empty(), "nothing is there yet");
    let first = all.map(|name| {
        fs::read(scratch.0.join("out").join(if name == "arches.csv" {
            "deep/arches.csv"
        } else {
            name
        }))
        .unwrap()
    });
    assert_eq!(kept(&resume()), all);
    // What is printed is printed again, and is all that is computed.
    let again = couplet(&["run", &scene, "--output", &out, "--resume", "--explain"]);
    assert!(
        text(&again.stderr).contains("to compute: 1 arch, each once"),
        "{}",
        text(&again.stderr)
    );
    // Without --resume everything is written anew.
    assert!(kept(&couplet(&["run", &scene, "--output", &out])).is_empty());

    // Damaged, then gone: that one is written again as it was.
    fs::write(scratch.path("out/deep/arches.csv"), "weight,half_opening\n").unwrap();
    assert_eq!(kept(&resume()), ["constants.json", "claims.json"]);
    fs::remove_file(scratch.path("out/claims.json")).unwrap();
    assert_eq!(kept(&resume()), ["constants.json", "arches.csv"]);
    for (name, content) in ["constants.json", "deep/arches.csv", "claims.json"].iter().zip(first) {
        assert_eq!(fs::read(scratch.0.join("out").join(name)).unwrap(), content, "{name}");
    }

    // Something else is asked: of one item, of all that have digits, or of none.
    scratch.scene(&THREE.replace("prove = [\"eq-7\", ", "prove = ["));
    assert_eq!(kept(&resume()), ["constants.json", "arches.csv"]);
    scratch.scene(
        &THREE.replace("prove = [\"eq-7\", ", "prove = [").replace("digits = 20", "digits = 21"),
    );
    assert_eq!(kept(&resume()), ["claims.json"]);
    scratch.scene(THREE);
    resume();
    scratch.scene(&format!("# In other words.\n{}", THREE.replace("\"T\"", "[ 'T' ]")));
    assert_eq!(kept(&resume()), all);

    // A record that is damaged or of another time proves nothing.
    for record in ["", "{}", "{\"schema\": \"couplet.run/9\", \"outputs\": {}}"] {
        fs::write(scratch.path("out/couplet-run.json"), record).unwrap();
        assert!(kept(&resume()).is_empty(), "{record}");
    }
}

#[test]
fn an_interrupted_run_leaves_whole_files_and_goes_on_where_it_was() {
    let scratch = Scratch::new("interrupt");
    let quick = "[[constants]]\nlandmarks = \"T\"\noutput = \"quick.csv\"\n";
    let slow =
        "[[constants]]\nlandmarks = [\"S\", \"J\"]\ndigits = 1_000_000\noutput = \"slow.csv\"\n";
    let scene = scratch.scene(&format!("{quick}{slow}"));
    let out = scratch.path("out");
    let mut child = Command::new(env!("CARGO_BIN_EXE_couplet"))
        .args(["run", &scene, "--output", &out])
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let start = Instant::now();
    while scratch.files("out").len() < 2 && start.elapsed() < Duration::from_secs(100) {
        std::thread::sleep(Duration::from_millis(20));
    }
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(killed.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert_eq!(scratch.files("out"), ["couplet-run.json", "quick.csv"]);
    // The slow item is not what is tested here.
    scratch.scene(&format!("{quick}{}", slow.replace("1_000_000", "100")));
    let output = couplet(&["run", &scene, "--output", &out, "--resume"]);
    assert_eq!(said(&output), [("quick.csv".to_owned(), true), ("slow.csv".to_owned(), false)]);
}

#[test]
fn a_plan_is_printed_and_nothing_is_written() {
    let scratch = Scratch::new("plan");
    let scene = scratch.scene(THREE);
    let output = couplet(&["run", &scene, "--output", &scratch.path("out"), "--plan"]);
    assert_eq!(output.status.code(), Some(0));
    let tree = text(&output.stdout);
    for line in [
        "4 items; to compute: 2 landmarks, 19 arches, 5 claims, each once",
        "├─ constants in line 3 -> constants.json (json)",
        "│  ├─ T heyman",
        "│  │  from (2), (4), (5), (17), (18), beta_s^2 = h (1 - h)",
        "   ├─ landmarks S, J, B, l, L, sb heyman: not asked for",
    ] {
        assert!(tree.lines().any(|found| found == line), "{line} in\n{tree}");
    }
    assert!(!tree.contains(" ms"), "nothing is computed");
    assert_eq!(scratch.files("."), ["scene.toml"]);
}

#[test]
fn what_was_computed_is_explained_with_its_cost() {
    let scratch = Scratch::new("explain");
    let scene = scratch.scene(ONE_THICKNESS);
    let output = couplet(&["run", &scene, "--explain"]);
    assert!(text(&output.stdout).contains("0.107478038107476"));
    let tree = text(&output.stderr);
    assert!(tree.contains("evaluations: (2) "), "{tree}");
    assert!(
        tree.contains("sliding_friction, rotational_friction of 1 arch: not asked for"),
        "{tree}"
    );
    assert!(tree.contains("in all, summed over the cores: "), "{tree}");
}

#[test]
fn a_file_of_arches_has_what_is_asked_and_null_for_the_rest() {
    let scratch = Scratch::new("null");
    let scene = scratch.scene(
        "digits = 17\n[[arches]]\nhalf_opening = 1\nfriction = 1\nquantities = \"thrust\"\noutput = \"a.json\"\n\
         [[arches]]\nhalf_opening = 1\nfriction = 1\nthickness = 0.1\nquantities = \"largest_thrust\"\n\
         output = \"b.json\"\n",
    );
    let out = scratch.path("out");
    assert_eq!(couplet(&["run", &scene, "--output", &out]).status.code(), Some(0));
    for (name, asked, others) in [
        ("a.json", "thrust", &couplet::report::STATE_VALUES[..]),
        ("b.json", "largest_thrust", &couplet::report::ASSESS_VALUES[..]),
    ] {
        let file: Value = serde_json::from_str(&scratch.read(&format!("out/{name}"))).unwrap();
        assert_eq!(file["schema"], "couplet.arches/1");
        assert_eq!(file["quantities"], serde_json::json!([asked]));
        let arch = &file["arches"][0];
        for value in others {
            assert_eq!(arch[value].is_object(), *value == asked, "{name} {value}");
        }
    }
    let state: Value = serde_json::from_str(&scratch.read("out/a.json")).unwrap();
    assert!(state["arches"][0]["thrust"]["hex"].as_str().unwrap().starts_with("0x1."));
}

#[test]
fn what_cannot_be_decided_is_said_and_tried_again() {
    let scratch = Scratch::new("undecided");
    // A friction nearer to the one at which the mode changes than any precision that is tried can tell.
    let state = ["state", "--half-opening", "pi/2", "--friction", "1", "--weight", "heyman"];
    let output = couplet(&[&state[..], &["--digits", "3000", "--format", "json"]].concat());
    let state: Value = serde_json::from_slice(&output.stdout).unwrap();
    let critical = state["rotational_friction"]["value"].as_str().unwrap();
    let scene = scratch.scene(&format!(
        "[arches]\nhalf_opening = \"pi/2\"\nweight = \"heyman\"\nfriction = [1, {critical}]\ndigits = 5\n\
         output = \"a.csv\"\n"
    ));
    let out = scratch.path("out");
    for _ in 0..2 {
        let output = couplet(&["run", &scene, "--output", &out, "--resume"]);
        assert_eq!(output.status.code(), Some(1));
        let stderr = text(&output.stderr);
        assert!(stderr.starts_with("written "), "{stderr}");
        let last = format!("couplet: not everything was proved: 1 of 2 arches in {out}/a.csv\n");
        assert!(stderr.ends_with(&last), "{stderr}");
        assert_eq!(column(&scratch.read("out/a.csv"), "verdict"), ["proved", "undecided"]);
    }
}

#[test]
fn a_file_that_cannot_be_written_is_known_before_any_work() {
    let scratch = Scratch::new("io");
    fs::write(scratch.path("file"), "").unwrap();
    let slow = "[constants]\ndigits = 1_000_000\noutput = \"a.csv\"\n";
    let scene = scratch.scene(slow);
    for folder in ["file", "file/below"] {
        let output = couplet(&["run", &scene, "--output", &scratch.path(folder)]);
        assert_eq!(output.status.code(), Some(3), "{folder}");
        assert_eq!(text(&output.stderr).lines().count(), 1);
    }
    fs::create_dir_all(scratch.path("out/a.csv")).unwrap();
    let output = couplet(&["run", &scene, "--output", &scratch.path("out")]);
    assert_eq!(output.status.code(), Some(3));
    let output = couplet(&["run", &scratch.path("none.toml")]);
    assert_eq!(output.status.code(), Some(3));
    // Nor is the scene itself written over.
    fs::copy(&scene, scratch.path("a.csv")).unwrap();
    let output = couplet(&["run", &scratch.path("a.csv"), "--output", &scratch.path("")]);
    assert_eq!(output.status.code(), Some(2));
    assert!(scratch.read("a.csv").contains("1_000_000"));
}

#[test]
fn a_scene_may_come_from_standard_input() {
    let run = |input: &str| {
        let mut child = Command::new(env!("CARGO_BIN_EXE_couplet"))
            .args(["run", "-"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
        child.wait_with_output().unwrap()
    };
    let one = "[constants]\nlandmarks = \"T\"\nquantities = \"thickness\"\ndigits = 12\n";
    let output = run(&format!("schema = \"couplet.scene/1\"\n{one}"));
    assert_eq!(output.status.code(), Some(0));
    assert!(text(&output.stdout).contains("0.618318241074"));
    let output = run(one);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).starts_with("standard input:1:1: schema is missing; "));
}
