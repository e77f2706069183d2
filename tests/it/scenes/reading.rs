//! What is read, and what is no scene at all.

use super::{HEAD, faults, place, scene_in};
use crate::program::{Scratch, ended, printed, tells};
use couplet::problem::Quantity;
use couplet::scene::{EXAMPLE, ItemKind, MAX_BYTES, Request, read, read_bytes};
use cpu_time::ThreadTime;
use std::time::Duration;

#[test]
fn the_example_is_a_scene_and_has_every_key() {
    assert_eq!(printed("run --schema"), EXAMPLE);
    let scene = read(EXAMPLE).unwrap();
    for kind in ItemKind::ALL {
        assert!(scene.items.iter().any(|item| item.kind == kind), "{}", kind.name());
        for key in kind.keys() {
            assert!(EXAMPLE.contains(&format!("\n{key} = ")), "{} {key}", kind.name());
        }
    }
    let of_landmarks = Quantity::LANDMARK.into_iter().filter(|q| q.in_radians().is_none());
    for quantity in of_landmarks.chain(Quantity::STATE).chain(Quantity::ASSESSMENT) {
        assert!(EXAMPLE.contains(quantity.name()), "{}", quantity.name());
    }
}

#[test]
fn no_scene_is_so_large_that_reading_it_takes_long() {
    let range = "{ from = 0.1, to = 3, steps = 60_000 }";
    let item = format!("[[arches]]\nhalf_opening = {range}\nfriction = 1\n");
    let start = ThreadTime::now();
    let said = faults(&item.repeat(1001));
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
    assert_eq!(said.len(), 1000, "all items but the first, and that they are too many");
    let second = "60000 arches after 60000 before are too many; a scene has at most 100000, `couplet states` reads any number";
    assert_eq!(said[0], format!("5:1: {second}"));
    assert_eq!(said[999], "3002:1: a scene has at most 1000 items");

    // A long list on one line, in which everything is wrong.
    let list = "9,".repeat(300_000);
    let start = ThreadTime::now();
    let said = faults(&format!("[arches]\nfriction = 1\nhalf_opening = [{list}]\n"));
    assert!(start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
    assert_eq!(said.len(), 300_000);
    let last = "4:600015: the half opening 9 is not between 0 and pi (180deg); did you mean 9deg?";
    assert_eq!(said[299_999], last);
}

/// The only fault of what is no scene of this version.
fn fault(bytes: &[u8]) -> String {
    let faults = read_bytes(bytes).unwrap_err();
    assert_eq!(faults.len(), 1);
    place(&faults[0])
}

const SCHEMA: &str = "\"couplet.scene/1\"";

#[test]
fn what_is_no_scene_of_this_version_is_said_and_no_more() {
    let long = vec![b'#'; MAX_BYTES + 1];
    let many = format!("1:1: a scene has at most {MAX_BYTES} bytes");
    let other = format!("2:10: schema \"couplet.scene/2\" is not one that is read here: {SCHEMA}");
    let missing = format!("1:1: schema is missing; a scene has schema = {SCHEMA}");
    for (bytes, message) in [
        (&b"colour = 1\nschema = \"couplet.scene/2\"\n"[..], &*other),
        (b"[constants]\n", &missing),
        (b"a = 1\n# \xe4\n", "2:3: not TOML: this is not valid UTF-8"),
        (&long, &many),
    ] {
        assert_eq!(fault(bytes), message);
    }
}

/// Nested deeper than anything that is meant.
#[test]
fn a_deep_list_is_refused() {
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
fn a_number_is_what_its_text_says() {
    let scratch = Scratch::new();
    // As a double the first would be another number than the second.
    let scene = "[arches]\nhalf_opening = \"pi/2\"\nquantities = \"thickness\"\ndigits = 40\n";
    let run = |friction: &str| {
        let path = scene_in(&scratch, &format!("{scene}friction = {friction}\n"));
        let words = printed(["run", &path]);
        words.split_whitespace().find(|word| word.starts_with("0.1")).unwrap().to_owned()
    };
    let near = run("0.350000000000000000001");
    assert_eq!(near, run("\"350000000000000000001/1000000000000000000000\""));
    assert_ne!(near, run("0.35"));
    for same in ["\"7/20\"", "+3.5e-1", "0.3_5"] {
        assert_eq!(run(same), run("0.35"), "{same}");
    }
}

#[test]
fn a_range_has_both_its_ends_and_exact_steps() {
    let scene = read(&format!(
        "{HEAD}[arches]\nhalf_opening = {{ from = \"pi/6\", to = \"pi/2\", steps = 3 }}\n\
         friction = {{ from = 0.4, to = 1, steps = 4 }}\n"
    ));
    let Request::Arches { arches, .. } = &scene.unwrap().items[0].what else { panic!() };
    let texts: Vec<String> = arches
        .iter()
        .map(|one| format!("{} {}", one.arch.half_opening(), one.arch.friction()))
        .collect();
    assert_eq!(texts.len(), 12);
    assert_eq!([&texts[0], &texts[5], &texts[11]], ["pi/6 0.4", "pi/3 0.6", "pi/2 1"]);
}

/// Steps go from degrees to a multiple of pi, and with lengths, as a deviation does.
#[test]
fn steps_have_the_units_of_every_range() {
    let scene = read(&format!(
        "{HEAD}[[arches]]\nspan = {{ from = \"9m\", to = \"1000cm\", steps = 3 }}\nrise = \"3m\"\nfriction = 1\n\
         [[drawing]]\nspan = [\"9m\"]\nrise = \"3m\"\nfriction = 1\n"
    ));
    let items = scene.unwrap().items;
    let Request::Arches { arches, .. } = &items[0].what else { panic!() };
    let spans: Vec<_> = arches.iter().map(|one| one.measured.clone().unwrap().asked.span).collect();
    assert_eq!(spans, ["9m", "9.5m", "10m"].map(|span| Some(span.to_owned())));
    let scene = read(&format!(
        "{HEAD}[arches]\nhalf_opening = {{ from = \"10deg\", to = \"pi/2\", steps = 3 }}\nfriction = 1\n"
    ));
    let Request::Arches { arches, .. } = &scene.unwrap().items[0].what else { panic!() };
    let angles: Vec<_> = arches.iter().map(|one| one.arch.half_opening().to_string()).collect();
    assert_eq!(angles, ["10deg", "50deg", "90deg"]);
}

#[test]
fn a_scene_may_come_from_standard_input() {
    let one = "[constants]\nlandmarks = \"T\"\nquantities = \"thickness\"\ndigits = 12\n";
    tells(&ended(0, "run -", format!("{HEAD}{one}")).0, ["0.618318241074"]);
    let (_, message) = ended(2, "run -", one);
    assert!(message.starts_with("standard input:1:1: schema is missing; "), "{message}");
}
