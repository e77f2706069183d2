use super::*;
use crate::arch::SelfWeight;
use crate::picture::print::SMALLEST;
use crate::picture::{PaperLength, Print};
use crate::problem::measures::{Circle, Measures};
use crate::problem::{Arch, Landmark, Mode};
use crate::reading::{sizes, texts, trouble};
use std::sync::OnceLock;

fn arch(half_opening: &str, friction: &str) -> Arch {
    Arch::parse("milankovitch", half_opening, friction).unwrap()
}

fn drawn(sketches: Vec<Sketch>, style: Style) -> Sketched {
    Sketched {
        sketches,
        style,
        measures: None,
        between: Vec::new(),
        command: "couplet draw".into(),
    }
}

fn as_svg(drawn: &Sketched) -> String {
    page::picture(drawn, &Print::default()).unwrap()
}

fn picture(sketches: Vec<Sketch>, style: Style) -> String {
    as_svg(&drawn(sketches, style))
}

/// Of a radius of 5 m, with forces or without.
fn measured(sketch: Sketch, style: Style, circle: Circle, has_forces: bool) -> Sketched {
    let length = |text: &str| text.parse().unwrap();
    let loaded = has_forces.then(|| ("24kN/m3".parse().unwrap(), length("1m")));
    let measures = Some(Measures::new(circle, length("5m"), loaded));
    Sketched { measures, ..drawn(vec![sketch], style) }
}

/// All kinds of pictures, by name.
fn pictures() -> Vec<(String, String)> {
    drawings().iter().map(|(name, drawn)| (name.clone(), as_svg(drawn))).collect()
}

/// Arches that these show.
fn drawings() -> &'static [(String, Sketched)] {
    static DRAWINGS: OnceLock<Vec<(String, Sketched)>> = OnceLock::new();
    DRAWINGS.get_or_init(all_drawings)
}

fn all_drawings() -> Vec<(String, Sketched)> {
    let mut all = Vec::new();
    let mut put = |name: &str, drawn: Sketched| all.push((name.to_owned(), drawn));
    let mut add = |name: &str, sketch: Sketch, style: Style| put(name, drawn(vec![sketch], style));
    let least = |alpha: &str, mu: &str| Sketch::least(&arch(alpha, mu), false).unwrap();
    for (name, alpha, mu) in [
        ("rrr", "1.5", "1"),
        ("srr", "pi/2", "0.35"),
        ("rrs", "2.45", "1.35"),
        ("rsr", "2.535", "1.57"),
        ("rs", "2.57", "2.2"),
        ("r", "2.62", "inf"),
        ("thin", "20deg", "0.6"),
        ("thinner", "1e-6", "0.6"),
        ("thinnest", "1e-9", "0.6"),
    ] {
        add(name, least(alpha, mu), Style::default());
    }
    let rich = Style { half: true, arrows: true, animate: true, ..Style::default() };
    add("half", least("2.45", "1.35"), rich);
    add("moving", least("2.45", "1.35"), Style { animate: true, ..Style::default() });
    let thick = "1".parse().unwrap();
    add("ss", Sketch::sliding(&arch("1", "1"), &thick, true).unwrap(), Style::default());
    for (name, alpha, mu, eta) in [
        ("stands", "80deg", "0.35", "0.16"),
        ("inner", "2.4", "1.5", "1"),
        ("loose", "80deg", "inf", "1.2"),
        ("falls", "80deg", "0.6", "0.05"),
        ("slides", "80deg", "0.1", "0.5"),
    ] {
        add(
            name,
            Sketch::standing(&arch(alpha, mu), &eta.parse().unwrap(), false).unwrap(),
            Style::default(),
        );
    }
    for weight in SelfWeight::ALL {
        for landmark in Landmark::ALL.into_iter().filter(|l| *l != Landmark::WidestJoint) {
            let name = format!("{}-{}", weight.name(), landmark.long_name());
            add(&name, Sketch::landmark(landmark, weight, false).unwrap(), Style::default());
        }
    }
    for (name, alpha, mu, circle, has_forces, half) in [
        ("metres", "80deg", "0.35", Circle::Centreline, false, false),
        ("metres-flat", "20deg", "0.6", Circle::Intrados, true, false),
        ("metres-half", "1.2", "0.5", Circle::Extrados, true, true),
        ("metres-plain-half", "1.2", "0.5", Circle::Extrados, false, true),
        ("metres-wide", "2.45", "1.35", Circle::Intrados, true, false),
    ] {
        let style = Style { half, ..Style::default() };
        put(name, measured(least(alpha, mu), style, circle, has_forces));
    }
    let thick = |eta: &str| eta.parse().unwrap();
    let of_stones = |alpha: &str, mu: &str, stones| {
        Sketch::least_of_stones(&arch(alpha, mu), stones, false).unwrap()
    };
    put("keystone", drawn(vec![of_stones("120deg", "0.75", 21)], Style::default()));
    put("stones", drawn(vec![of_stones("2.45", "1.35", 20)], Style::default()));
    let rich = Style { half: true, arrows: true, animate: true, ..Style::default() };
    put("keystone-half", drawn(vec![of_stones("pi/2", "1", 9)], rich));
    // Names as long as they are, the joints in all places.
    for (name, alpha, mu, eta, stones) in [
        ("many-stones", "80deg", "0.35", "0.16", 31),
        ("few-stones", "pi/2", "0.6", "0.08", 11),
        ("wide-stones", "150deg", "2", "1.2", 40),
    ] {
        let sketch = Sketch::standing_of_stones(&arch(alpha, mu), stones, &thick(eta), false);
        put(name, drawn(vec![sketch.unwrap()], Style::default()));
    }
    let bridge = Sketch::standing(&arch("34deg", "0.41"), &thick("0.0223"), false).unwrap();
    put("bridge", measured(bridge, Style::default(), Circle::Intrados, true));
    let standing =
        Sketch::standing_of_stones(&arch("2.45", "1.35"), 21, &thick("0.8"), false).unwrap();
    put("stones-stand", measured(standing, Style::default(), Circle::Intrados, true));
    let standing =
        Sketch::standing(&arch("80deg", "0.35"), &"0.16".parse().unwrap(), false).unwrap();
    let of = measured(standing, Style::default(), Circle::Centreline, true);
    put("metres-stands", of);
    let triple = Sketch::landmark(Landmark::Triple, SelfWeight::Milankovitch, false).unwrap();
    let triple = triple.in_modes(&[Mode::RotationalSliding]).unwrap();
    put("notation", drawn(vec![triple], Style::of_figure(1)));
    all
}

#[test]
fn pictures_are_well_formed_finite_and_small() {
    for (name, svg) in pictures() {
        assert!(texts(&svg).is_some(), "{name}");
        assert!(!svg.contains("NaN") && !svg.contains("inf "), "{name}");
        assert!(svg.len() < 100_000, "{name}: {}", svg.len());
    }
}

/// The blocks of both halves, and a mark for each joint that gives way on each side.
#[test]
fn each_mode_has_its_blocks_hinges_and_sliding_joints() {
    let all = pictures();
    for (name, blocks, hinges, slides) in [
        ("rrr", 2, 5, 0),
        ("srr", 2, 3, 2),
        ("rrs", 3, 4, 2),
        ("rsr", 3, 4, 2),
        ("rs", 2, 3, 2),
        ("r", 1, 2, 0),
        ("ss", 2, 0, 4),
        ("stones", 3, 4, 2),
    ] {
        let svg = &all.iter().find(|(other, _)| other == name).unwrap().1;
        let group = |id: &str| {
            let rest = svg.split(&format!("<g id=\"{id}\">")).nth(1).unwrap();
            rest.split("\n<g id=").next().unwrap().to_owned()
        };
        assert_eq!(group("mechanism").matches("<g transform=").count(), 2 * blocks, "{name}");
        assert_eq!(
            group("hinges").split("</g>").next().unwrap().matches("<circle").count(),
            hinges
        );
        let sliding = group("sliding");
        assert_eq!(sliding.split("</g>").next().unwrap().matches("<path").count(), slides);
    }
}

/// One over the crown, with a hinge on each side.
#[test]
fn a_keystone_is_one_block() {
    let all = pictures();
    let svg = &all.iter().find(|(name, _)| name == "keystone").unwrap().1;
    assert_eq!(svg.matches("<g transform=").count(), 2 * 2 + 1);
    let hinges = svg.split("<g id=\"hinges\">").nth(1).unwrap().split("</g>").next().unwrap();
    assert_eq!(hinges.matches("<circle").count(), 4);
}

/// The mechanism on the right, the symbols where they belong.
#[test]
fn figure_1_has_the_symbols_and_half_a_mechanism() {
    let all = pictures();
    let svg = &all.iter().find(|(name, _)| name == "notation").unwrap().1;
    assert_eq!(svg.matches("<g transform=").count(), 3, "three blocks of the right half");
    let words = texts(svg).unwrap();
    for symbol in ["O", "r", "t = ηr", "α", "βᵣ", "βₛ", "G", "H", "V = wrα", "W"] {
        assert!(words.iter().any(|word| word == symbol), "{symbol}: {words:?}");
    }
    assert!(words.iter().any(|word| word.contains("h = H/(wr)")));
}

#[test]
fn a_moving_picture_is_the_still_one_but_for_its_motion() {
    let of = |animate| {
        let sketch = Sketch::least(&arch("2.45", "1.35"), false).unwrap();
        picture(vec![sketch], Style { animate, ..Style::default() })
    };
    let (still, moving) = (of(false), of(true));
    let without: Vec<&str> = moving.lines().filter(|line| !line.starts_with("<animate")).collect();
    assert_eq!(without, still.lines().collect::<Vec<_>>());
    assert_eq!(moving.matches("<animateTransform").count(), 12, "two for each of six blocks");
    assert!(!moving.contains("<script"));
    // It begins and ends where the still picture is.
    for line in moving.lines().filter(|line| line.starts_with("<animate")) {
        let values = line.split("values=\"").nth(1).unwrap().split('"').next().unwrap();
        let values: Vec<&str> = values.split(';').collect();
        assert_eq!((values.first(), values.len()), (values.last(), 25));
        assert!(still.contains(&format!("({})", values[0])), "{}", values[0]);
    }
}

#[test]
fn a_caption_says_the_numbers() {
    let all = pictures();
    for (name, said) in [
        ("srr", &["η = t/r = 0.151858", "It falls as [s,r,r]", "Proved:"][..]),
        ("stands", &["It stands", "2.331 times the least", "sliding of the shoulder"]),
        ("falls", &["does not stand", "0.0686505"]),
        ("slides", &["stands at no thickness"]),
        ("milankovitch-triple", &["+ 1.47164 [s,s] = [s,r,r] + 0.717295 [r,r,s]", "0.618318"]),
        ("milankovitch-shift", &["[r,r+s]", "βᵣ = βₛ"]),
        ("ss", &["associated flow rule", "extreme lines of thrust"]),
        ("thin", &["unrolled"]),
        ("keystone", &["21 equal stones", "0.41946,", "the joint beside the keystone open"]),
        (
            "stones-stand",
            &["slides inwards at joint 2", "The conditions hold at the joints between"],
        ),
        ("metres", &["span 9.848 m", "rise 4.132 m", "r = 5 m, t = 0.34"]),
        ("metres-half", &["half of the span", "at the extrados", "on each shoulder V ="]),
        (
            "metres-stands",
            &[
                "thickness 0.8 m",
                "least t = 0.34",
                "H 51.64–75.19 kN",
                "thrust H = hwr from 51.6436 to 75.1898",
            ],
        ),
    ] {
        let svg = &all.iter().find(|(other, _)| other == name).unwrap().1;
        let words = texts(svg).unwrap().join(" ");
        for part in said {
            assert!(words.contains(part), "{name}: {part}: {words}");
        }
    }
}

fn as_dxf(drawn: &Sketched) -> String {
    let mut file = Vec::new();
    dxf::dxf(drawn, &mut file).unwrap();
    String::from_utf8(file).unwrap()
}

#[test]
fn a_file_for_cad_has_its_layers_and_ends() {
    let sketch = Sketch::landmark(Landmark::Triple, SelfWeight::Milankovitch, false).unwrap();
    let text = as_dxf(&drawn(vec![sketch], Style::default()));
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len() % 2, 0);
    assert!(lines.iter().step_by(2).all(|code| code.parse::<u16>().is_ok()), "codes and values");
    for layer in
        ["ARCH", "THRUST", "FRICTION", "HINGES", "SLIDING", "MECHANISM", "TEXT", "DIMENSIONS"]
    {
        assert!(lines.chunks(2).any(|pair| pair == ["8", layer]), "{layer}");
    }
    assert_eq!(&lines[lines.len() - 2..], ["0", "EOF"]);
    let count = |value: &str| lines.chunks(2).filter(|pair| *pair == ["0", value]).count();
    // The model and the sheets are blocks too.
    assert_eq!((count("BLOCK"), count("INSERT")), (3, 4), "the arch once, in four panels");
    assert!(text.contains("$ACADVER\n1\nAC1015\n") && text.contains("$INSUNITS\n70\n0\n"));
    assert!(text.is_ascii() && text.len() < 40_000, "four arches: {}", text.len());
}

/// Files for CAD have the numbers in metres where the arch has them: larger by the radius.
#[test]
fn files_for_cad_are_in_metres_where_the_arch_is() {
    let sketch = || Sketch::least(&arch("80deg", "0.35"), false).unwrap();
    let coordinates = |drawn: &Sketched| -> Vec<f64> {
        let text = as_dxf(drawn);
        let lines: Vec<&str> = text.lines().collect();
        let pairs: Vec<(&str, &str)> = lines.chunks(2).map(|pair| (pair[0], pair[1])).collect();
        // Sizes and letters are not alike.
        let is_other =
            |(code, value): &(&str, &str)| *code == "8" && ["DIMENSIONS", "TEXT"].contains(value);
        let entities = pairs.split(|(code, _)| *code == "0");
        let numbers = entities.filter(|of| !of.iter().any(is_other)).flatten();
        let is_length = |code: &str| ["10", "20", "11", "21", "40"].contains(&code);
        numbers
            .filter(|(code, _)| is_length(code))
            .map(|(_, value)| value.parse().unwrap())
            .collect()
    };
    let [unit, metres] = [
        coordinates(&drawn(vec![sketch()], Style::default())),
        coordinates(&measured(sketch(), Style::default(), Circle::Centreline, false)),
    ];
    assert!(unit.len() == metres.len() && unit.len() > 100);
    assert!(unit.iter().zip(&metres).all(|(r, m)| (5.0 * r - m).abs() < 1e-6));
    let text = as_dxf(&measured(sketch(), Style::default(), Circle::Centreline, false));
    for said in ["lengths in m\n", "$INSUNITS\n70\n6\n", "rise ", "span ", "t = "] {
        assert!(text.contains(said), "{said}");
    }
}

/// On paper of all usual widths no text leaves the sheet or lies on another, its letters are of the size asked for, and
/// no two groups have one name; a narrower sheet than a picture can have is refused.
#[test]
fn all_kinds_have_room_on_all_papers() {
    let (mut found, mut refused) = (Vec::new(), Vec::new());
    for (name, drawn) in drawings() {
        for width in ["84mm", "90mm", "120mm", "174mm", ""] {
            let width = PaperLength::width(width).ok();
            let print = Print { width, details: true, ..Print::default() };
            let Ok(svg) = page::picture(drawn, &print) else {
                refused.push((&name[..], width));
                continue;
            };
            found.extend(trouble(&svg).map(|trouble| format!("{name} {width:?}: {trouble}")));
            assert!(sizes(&svg).iter().all(|size| *size >= SMALLEST), "{name}");
            let mut ids: Vec<&str> =
                svg.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
            let count = ids.len();
            ids.sort_unstable();
            ids.dedup();
            assert_eq!(ids.len(), count, "{name}");
        }
        let narrow = Print { width: Some(PaperLength::width("20mm").unwrap()), ..Print::default() };
        assert!(page::picture(drawn, &narrow).is_err(), "{name}");
    }
    assert_eq!(found, [""; 0]);
    assert!(
        refused.iter().all(|(name, _)| {
            name.starts_with("metres") || ["bridge", "stones-stand"].contains(name)
        }),
        "{refused:?}"
    );
}
