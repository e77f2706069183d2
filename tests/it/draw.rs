//! `couplet draw`, and the figures of arches: what is in them, and what is refused.

use crate::program::{Json, Scratch, Words, object, printed, tells, text, texts};
use crate::tool::has_module;
use serde_json::Value;
use std::process::Command;

const ARCH: &str = "draw --alpha 2.45 --mu 1.35";

/// The first arch of a drawing as JSON.
fn arch(line: impl Words) -> Value {
    object(line)["arches"][0].take()
}

/// The texts of a picture.
fn texts_in(svg: &str) -> impl Iterator<Item = &str> {
    svg.split('<').filter_map(|tag| tag.split('>').nth(1))
}

/// Its end, which may be the name of the format too.
#[test]
fn the_name_of_the_file_tells_the_format() {
    let scratch = Scratch::new();
    for (line, end, start) in [
        (ARCH, "svg", "<svg "),
        (ARCH, "json", "{"),
        (ARCH, "dxf", "999\ncouplet"),
        ("state --alpha 1 --mu 1", "csv2", "weight;"),
        ("state --alpha 1 --mu 1", "latex", "% States"),
        ("state --alpha 1 --mu 1", "markdown", "| "),
        ("state --alpha 1 --mu 1", "tex", "% States"),
    ] {
        assert_eq!(printed(format!("{line} -o {}", scratch.path(&format!("a.{end}")))), "");
        let text = scratch.read(&format!("a.{end}"));
        assert!(text.starts_with(start), "{end}: {text}");
    }
}

/// The rates are those of the state, the lines begin at the crown and end at the shoulder.
#[test]
fn json_has_the_geometry() {
    let arch = arch(ARCH);
    assert_eq!(arch["verdict"], "collapses");
    let starts = |value: &Value, digits: &str| value["value"].text().starts_with(digits);
    assert!(starts(&arch["thickness"], "0.650243780801383"));
    assert_eq!(arch["half_opening"]["double"], 2.45);
    let mechanism = &arch["mechanisms"][0];
    assert_eq!(mechanism["mode"], "[r,r,s]");
    let joints = mechanism["joints"].list();
    let contacts = ["hinge at the extrados", "hinge at the intrados", "slides inwards"];
    assert_eq!(texts(joints, "contact"), contacts);
    assert!(starts(&joints[2]["rate"], "4.57727272879"));
    assert_eq!(mechanism["blocks"].list().len(), 3);
    let line = arch["lines"][0]["thrust_lines"][0].list();
    let [x, y] = [0, 1].map(|k| line[line.len() - 1][k].number());
    assert!(line[0][0] == 0.0 && (x.atan2(y) - 2.45).abs() < 1e-12);
}

/// At S the joint that opens is the one that slides: between them there is no block. The last one is the crown's.
#[test]
fn each_block_has_its_own_twist() {
    for (line, modes) in [
        ("draw --at S", &["[r,r+s]", "[s,s]"][..]),
        ("draw --at S --weight heyman --dilatant", &["[r,r+s]", "[s,s]"]),
        ("draw --at T", &["[r,r,r]", "[r,r,s]", "[s,r,r]", "[s,s]"]),
    ] {
        let arch = arch(line);
        let mechanisms = arch["mechanisms"].list();
        let mut found = texts(mechanisms, "mode");
        found.sort_unstable();
        assert_eq!(found, modes, "{line}");
        for of in mechanisms {
            let blocks = of["blocks"].list();
            let [above, below] = [0, 1].map(|end| blocks.iter().map(move |of| &of["between"][end]));
            assert!(above.take(blocks.len() - 1).eq(below.skip(1)), "end to end: {line}");
            let last = blocks.last().unwrap();
            assert_eq!(last["between"][0], 0.0);
            let up = last["twist"]["velocity"][1]["double"].number();
            assert_eq!(of["crown_drop"]["double"].number(), -up, "{line} {}", of["mode"]);
            assert!(of.get("twists").is_none());
        }
    }
}

/// Thickness, thrust, mode and joints are those of `couplet voussoirs`; blocks end between stones, at the crown or in a
/// keystone, which does not turn.
#[test]
fn stones_are_those_of_voussoirs() {
    for (arch, stones, blocks) in [
        ("--half-opening 120deg --friction 0.75", 21, 3),
        ("--half-opening 120deg --friction 0.75", 20, 2),
        ("--half-opening pi/2 --friction 1 --weight heyman", 9, 3),
        ("--half-opening 2.45 --friction 1.35", 21, 3),
        ("--half-opening 2.57 --friction 2.2", 21, 2),
        ("--half-opening 2.57 --friction 2.2", 20, 2),
        ("--half-opening 2.62 --friction inf", 20, 1),
    ] {
        let with = |command: &str| object(format!("{command} {arch} --stones {stones}"));
        let (of, truth) = (&with("draw")["arches"][0], with("voussoirs --digits 17"));
        for name in ["thickness", "thrust"] {
            assert_eq!(of[name]["value"], truth[name]["value"], "{arch} {stones} {name}");
        }
        let mechanism = &of["mechanisms"][0];
        assert_eq!(mechanism["mode"], truth["mode"]);
        let alpha = of["half_opening"]["double"].number();
        let is_joint = |angle: f64| {
            let share = (angle / alpha + 1.0) / 2.0 * f64::from(stones);
            (share - share.round()).abs() < 1e-9
        };
        let all = mechanism["blocks"].list();
        assert_eq!(all.len(), blocks, "{arch} {stones}");
        for block in all {
            let ends = [0, 1].map(|k| block["between"][k].number());
            assert!(ends.into_iter().all(|end| is_joint(end) || end == 0.0), "{arch}: {ends:?}");
        }
        for joint in mechanism["joints"].list() {
            assert!(is_joint(joint["joint"]["double"].number()));
        }
        let joints = of["stone_joints"].list();
        assert_eq!(joints.len(), stones as usize / 2);
        assert!(joints.iter().all(|joint| is_joint(joint.number())));
        if stones % 2 == 1 {
            let last = all.last().unwrap();
            assert_eq!(last["rotation"], 0.0);
            assert!(last["shift"][0].number().abs() < 1e-12);
        }
    }
}

/// It may stand where the arch with a joint at every angle does not, with a wider range of thrusts.
#[test]
fn an_arch_of_stones_stands_by_its_own_conditions() {
    let arch = "--half-opening 120deg --friction 0.75 --thickness 0.423";
    assert_eq!(self::arch(format!("draw {arch}"))["verdict"], "falls");
    let of = self::arch(format!("draw {arch} --stones 21"));
    assert_eq!(of["verdict"], "stands");
    let truth = object(format!("voussoirs {arch} --stones 21 --digits 17"));
    for (line, end) in ["least_thrust", "largest_thrust"].into_iter().enumerate() {
        let line = &of["lines"][line];
        assert_eq!(line["thrust"]["value"], truth["assessment"][end]["thrust"]["value"]);
        let limits = truth["assessment"][end]["limited_by"].list();
        assert_eq!(limits.len(), line["at_limit"].list().len());
    }
    let svg = printed("draw --alpha 90deg --mu 0.3 --eta 0.2 --stones 9");
    assert!(svg.contains("none keeps within friction at its joints"));
    let dxf = printed("draw --alpha 2 --mu 0.75 --stones 21 --format dxf");
    assert_eq!(dxf.matches("\n8\nSTONES\n100\nAcDbLine\n").count(), 20);
}

/// Its rate is the horizontal velocity of the half arch at the crown's centreline.
/// A joint between stones is named by its own limits: `βₛ` where it is proved that it slides, `βᵣ` where it turns.
#[test]
fn joints_between_stones_are_named_by_their_limits() {
    let mut seen = [0; 4];
    for arch in [
        "--span 10m --rise 3m --thickness 60cm --mu 0.6 --stones 21",
        "--weight heyman --alpha 2.4 --mu 1.3 --eta 0.8 --stones 21",
        "--weight heyman --alpha 80deg --mu 0.5 --eta 0.3 --stones 9",
        "--weight heyman --alpha 1 --mu 0.9 --eta 0.2 --stones 7",
        "--weight heyman --alpha 2.2 --mu 1.4 --eta 0.7 --stones 11",
        "--alpha pi/2 --mu 0.45 --eta 0.4 --stones 12",
        "--alpha 2.57 --mu 2.2 --eta 1.4 --stones 15",
        "--alpha 2.5 --mu 1.9 --eta 1 --stones 40",
    ] {
        let told =
            |command: &str, format: &str| printed(format!("{command} {arch} --format {format}"));
        let proved = told("voussoirs", "table");
        let limits = proved.lines().filter(|line| line.contains("limited by"));
        let limits: Vec<&str> = limits.flat_map(|line| line.split(", ")).collect();
        let does = |how: &str, joint: &str| {
            limits.iter().any(|of| of.contains(how) && of.contains(&format!("at {joint} (")))
        };
        let (svg, dxf) = (told("draw", "svg"), told("draw", "dxf"));
        let names = texts_in(&svg).filter(|name| name.starts_with("joint ") && name.ends_with('°'));
        for name in names {
            let joint = name.split(',').next().unwrap();
            let [turns, outer, slides] =
                ["hinge", "hinge at the extrados", "slides"].map(|how| does(how, joint));
            let named = ["βᵣ", "βₛ"].map(|symbol| name.contains(symbol));
            assert_eq!(named, [turns && (slides || !outer), slides], "{arch}: {name}: {limits:?}");
            assert!(turns || slides, "{arch}: {name}");
            seen[usize::from(turns) + 2 * usize::from(slides)] += 1;
            assert!(dxf.contains(&format!("{joint}, ")), "{arch}: {name}");
        }
    }
    assert!(seen[1] >= 4 && seen[2] >= 3 && seen[3] == 2, "{seen:?}");
}

#[test]
fn a_crown_that_opens_is_no_pair_of_hinges() {
    for line in ["draw --at L", "draw --at l", "draw --alpha 2.62 --mu inf"] {
        let of = &arch(line)["mechanisms"][0];
        let joints = of["joints"].list();
        let contacts = ["hinge at the extrados", "opens at the crown"];
        assert_eq!(texts(joints, "contact"), contacts, "{line}");
        let twist = &of["blocks"][0]["twist"];
        let [up, across] =
            [&twist["rotation"], &twist["velocity"][0]].map(|x| x["double"].number());
        let across = across - up;
        assert!((joints[1]["rate"]["double"].number() - across).abs() < 1e-12, "{line}: {across}");
    }
}

/// Thin arches are flat before a corner has moved so far.
#[test]
fn the_amplitude_is_the_one_that_is_reached() {
    let thin = arch("draw --half-opening 0.05 --friction 0.3");
    let of = &thin["mechanisms"][0];
    let reached = of["amplitude"].number();
    assert!((2e-4..1e-3).contains(&reached), "{reached}");
    let radii = [-0.5, 0.5].map(|side| 1.0 + side * thin["thickness"]["double"].number());
    let mut most = 0.0_f64;
    for block in of["blocks"].list() {
        let between = block["between"].list();
        let rest = between.iter().flat_map(|joint| {
            let (sin, cos) = joint.number().sin_cos();
            radii.map(|radius| [radius * sin, radius * cos])
        });
        for (rest, moved) in rest.zip(block["corners"].list()) {
            let [x, y] = [0, 1].map(|k| moved[k].number() - rest[k]);
            most = most.max(x.hypot(y));
        }
    }
    assert!((most - reached).abs() < 1e-12, "{most} {reached}");
    let svg = printed("draw --half-opening 0.05 --friction 0.3");
    assert!(svg.contains("the corner that moves most by 5.") && !svg.contains("0.12"));
    tells(&printed(ARCH), ["the corner that moves most by 0.12 r."]);
}

/// With more friction the first stands, the others do not.
#[test]
fn an_arch_that_does_not_stand_says_which_condition_fails() {
    for (alpha, mu, eta, is_friction) in [
        ("90deg", "0.3", "0.2", true),
        ("80deg", "0.1", "0.5", true),
        ("80deg", "0.1", "0.05", false),
        ("80deg", "0.6", "0.05", false),
        ("80deg", "inf", "0.05", false),
        ("2.7", "0.5", "2", false),
    ] {
        let svg = printed(format!("draw --alpha {alpha} --mu {mu} --eta {eta}"));
        let said = |words: &str| svg.contains(words);
        assert_eq!(said("lines of thrust lie within it, none keeps within friction"), is_friction);
        assert_eq!(said("it asks for a friction of"), is_friction, "{alpha} {mu} {eta}");
        assert_eq!(said("no line of thrust lies within it"), !is_friction, "{alpha} {mu} {eta}");
    }
}

/// A landmark has more joints at their limits than give way in a mode.
#[test]
fn lines_touch_where_some_mode_gives_way() {
    let all = [
        ("figure 1", true),
        ("draw --at T --mode rrs", true),
        ("draw --at J", true),
        (ARCH, false),
    ];
    for (arguments, is_landmark) in all {
        let svg = printed(arguments);
        let words = "on its faces only at joints that give way in one of the modes there";
        assert_eq!(svg.contains(words), is_landmark, "{arguments}");
        assert_eq!(svg.contains("only at the joints that give way,"), !is_landmark);
    }
}

/// Programs for CAD take a number for their own unit, unless the file names its own.
#[test]
fn a_file_for_cad_names_its_unit_where_it_has_one() {
    let metres = printed("draw --radius 5m --alpha 1 --mu 1 --format dxf");
    assert!(metres.contains("9\n$INSUNITS\n70\n6\n9\n$MEASUREMENT\n70\n1\n"));
    assert!(printed(format!("{ARCH} --format dxf")).contains("$INSUNITS\n70\n0\n"));
}

/// Sizes, coordinates and the unit of a file are those of the first length that is given.
#[test]
fn lengths_are_told_in_the_unit_in_which_they_are_given() {
    let told = |span: &str, rise: &str, format: &str| {
        let arch = ["draw", "--span", span, "--rise", rise, "--eta", "0.1r", "--mu", "0.6"];
        printed([&arch[..], &["--format", format]].concat())
    };
    let point = |json: &str| -> f64 {
        let json: Value = serde_json::from_str(json).unwrap();
        json["arches"][0]["lines"][0]["thrust_lines"][0][3][1].number()
    };
    let metres = point(&told("10.0584m", "3.048m", "json"));
    for (span, rise, said, unit, code, size) in [
        ("33ft", "3.048m", "span 33 ft", "ft", 2, 0.3048),
        ("33'0\"", "10'", "rise 10 ft", "ft", 2, 0.3048),
        ("396in", "10ft", "rise 120 in", "in", 1, 0.0254),
        ("11yd", "10ft", "span 11 yd", "yd", 10, 0.9144),
        ("1005.84cm", "10ft", "rise 304.8 cm", "cm", 5, 0.01),
        ("10058.4 mm", "10ft", "rise 3048 mm", "mm", 4, 0.001),
        ("10.0584m", "10ft", "span 10.06 m", "m", 6, 1.0),
    ] {
        let [svg, dxf, json] = ["svg", "dxf", "json"].map(|format| told(span, rise, format));
        tells(&texts_in(&svg).collect::<String>(), [said]);
        let system = u8::from(!["ft", "in", "yd"].contains(&unit));
        tells(&dxf, [format!("$INSUNITS\n70\n{code}\n9\n$MEASUREMENT\n70\n{system}\n")]);
        assert!(dxf.starts_with(&format!("999\ncouplet: lengths in {unit}\n")));
        // A key that has its unit keeps it.
        tells(&json, [&format!("\"unit\": \"{unit}\""), "\"rise_m\": {\n"]);
        assert!((point(&json) * size / metres - 1.0).abs() < 1e-12, "{span}");
    }
}

/// The table for people says them in that unit beside its metres.
#[test]
fn sizes_in_a_table_are_told_in_the_unit_given_too() {
    let of = |span: &str| printed(format!("assess --span {span} --rise 10ft --eta 2ft --mu 0.6"));
    let (feet, metres) = (of("33ft"), of("10.0584m"));
    tells(
        &feet,
        [
            "span_m               span, m            10.0584 = 33 ft",
            "thickness_m          t, m               0.6096 = 2 ft",
            "least_thickness_m    least t, m         0.153098 = 0.502290 ft",
        ],
    );
    for more in ["33ft --stones 41", "33ft --tilt 5deg"] {
        tells(&of(more), ["t, m               0.6096 = 2 ft"]);
    }
    let (_, sizes) = metres.split_once("as measured").unwrap();
    let (sizes, _) = sizes.split_once("\n\n").unwrap();
    assert!(sizes.contains("10.0584\n") && !sizes.contains(" = "), "{metres}");
}

/// What a shoulder bears is in the file for CAD too.
#[test]
fn a_file_for_cad_has_the_forces() {
    let arch = "draw --span 10m --rise 3m --mu 0.6 --eta 0.1r";
    let loaded = format!("{arch} --density 24kN/m3 --depth 1m");
    let (svg, dxf) = (printed(&loaded), printed(format!("{loaded} --format dxf")));
    let forces: Vec<&str> = texts_in(&svg).filter(|text| text.ends_with(" kN")).collect();
    assert!(["H ", "V "].iter().all(|name| forces.iter().any(|of| of.starts_with(name))));
    let escaped = |text: &str| text.replace('–', "\\U+2013");
    assert!(forces.iter().all(|of| dxf.contains(&escaped(of))), "{forces:?}");
    assert_eq!(dxf.matches("\n8\nFORCES\n100\nAcDbLine\n").count(), 6, "two arrows");
    assert!(!printed(format!("{arch} --format dxf")).contains(" kN"));
}

/// Each command that answers for one arch draws it as `couplet draw` does, with its options; what is no drawing has
/// none of them, and what does not fall upright only how far it falls.
#[test]
fn every_command_that_draws_has_the_same_options() {
    let scratch = Scratch::new();
    let drawn = |command: &str, arch: &str, end: &str| -> String {
        printed(format!("{command} {arch} -o {}", scratch.path(&format!("a.{end}"))));
        // The command is in its words.
        let svg = scratch.read(&format!("a.{end}"));
        svg.lines().filter(|line| !line.contains("Command: ")).collect()
    };
    let given = "--alpha 80deg --mu 0.6 --eta 0.12 --half";
    let tilted = "--alpha 90deg --mu 0.4 --eta 0.15 --tilt 0.05";
    let far = format!("{tilted} --amplitude 0.2");
    let free = "--alpha 2.45 --mu 1.35 --half --arrows --dilatant --amplitude 0.2";
    for (command, arch, ends) in [
        ("state", free, &["svg"][..]),
        ("assess", given, &["svg", "dxf"]),
        ("voussoirs", &format!("{given} --stones 9"), &["svg", "dxf"]),
        ("assess", tilted, &["svg", "dxf"]),
    ] {
        for end in ends {
            assert_eq!(drawn(command, arch, end), drawn("draw", arch, end), "{command} {arch}");
        }
    }
    for end in ["svg", "dxf"] {
        assert_ne!(drawn("draw", &far, end), drawn("draw", tilted, end));
    }
    let json = object(format!("draw {far}"));
    let drawing = &json["drawing"];
    assert!((drawing["amplitude"].number() - 0.2).abs() < 1e-9);
    assert_eq!(drawing["blocks"].list().len(), 3);
    let line = drawing["thrust_line"].list();
    let [first, last] = [&line[0], &line[line.len() - 1]].map(|point| point[1].number());
    assert!(first.abs() < 1e-12 && last.abs() < 1e-12, "from one springing to the other");
}

/// Points are larger by the radius, rates are the same, and forces are those of `couplet state` and `couplet assess`.
#[test]
fn json_is_in_metres_where_the_arch_is() {
    let plain = object("draw --half-opening 2atan(3/5) --friction 0.6");
    let bridge = "--span 10m --rise 3m --friction 0.6 --density 24kN/m3 --depth 2m";
    let shape = format!("{bridge} --measured-at centreline");
    let metres = object(format!("draw {shape}"));
    assert_eq!((&plain["unit"], &metres["unit"]), (&"r".into(), &"m".into()));
    let [plain, metres] = [&plain["arches"][0], &metres["arches"][0]];
    assert!(plain["measures"].is_null());
    let radius = 17.0 / 3.0;
    let line = |arch: &Value| -> Vec<f64> {
        let points = arch["lines"][0]["thrust_lines"][0].list();
        points.iter().flat_map(|point| [0, 1].map(|k| point[k].number())).collect()
    };
    let both = line(plain).into_iter().zip(line(metres));
    let far = both.map(|(r, m)| (radius * r - m).abs());
    assert!(far.fold(0.0, f64::max) < 1e-14);
    let [one, other] = [plain, metres].map(|arch| &arch["mechanisms"][0]);
    assert_eq!(one["joints"], other["joints"]);
    let shift = |of: &Value| of["blocks"][0]["shift"][0].number();
    assert!((radius * shift(one) - shift(other)).abs() < 1e-14);
    let state = object(format!("state {shape} --digits 17"));
    let measures = &metres["measures"];
    for (ours, theirs) in [
        (&measures["radius_m"], "radius_m"),
        (&measures["thickness_m"], "least_thickness_m"),
        (&measures["weight_kn"], "weight_kn"),
        (&metres["lines"][0]["thrust_kn"], "thrust_kn"),
    ] {
        assert_eq!(ours["value"], state[theirs]["value"], "{theirs}");
    }
    let sizes = ["span_m", "rise_m"].map(|name| measures[name]["double"].number());
    assert_eq!(sizes, [10.0, 3.0]);
    let standing = format!("{bridge} --thickness 60cm");
    let drawn = arch(format!("draw {standing}"));
    let assessed = object(format!("assess {standing} --digits 17"));
    for (k, end) in ["least_thrust_kn", "largest_thrust_kn"].into_iter().enumerate() {
        assert_eq!(drawn["lines"][k]["thrust_kn"]["value"], assessed[end]["value"]);
    }
}

#[test]
fn each_figure_has_its_modes() {
    for (number, modes) in [
        ("1", &["Symbols"][..]),
        ("7", &["[s,s] at T", "[r,r,r] at T"][..]),
        ("8", &["[r,r,s] at T", "[s,r,r] at T"]),
        ("9", &["[s,s] at S", "[r,r+s] at S"]),
        ("10", &["[s,s] at J", "[r,s] at J"]),
        ("11", &["[s,s] at B", "[r,s] at B"]),
        ("12", &["[r] at L", "[r] at ℓ"]),
    ] {
        let svg = printed(["figure", number]);
        for (place, mode) in modes.iter().enumerate() {
            assert!(svg.contains(&format!(">{mode}</text>")), "{number} {mode}");
            assert!(svg.contains(&format!("<g id=\"panel-{place}\">")), "{number}");
        }
        assert!(!svg.contains(&format!("<g id=\"panel-{}\">", modes.len())), "{number}");
    }
}

#[test]
fn options_change_what_they_say() {
    let still = printed(ARCH);
    let with = |option: &str| printed(format!("{ARCH} {option}"));
    let moves = "<animateTransform";
    assert!(!still.contains(moves) && with("--animate").contains(moves));
    let arrows = "id=\"arrows\"";
    assert!(!still.contains(arrows) && with("--arrows").contains(arrows));
    assert!(with("--dilatant").contains("associated flow rule"));
    assert!(with("--half").matches("<circle").count() < still.matches("<circle").count());
    let joints = "stroke-width=\"0.6\"";
    assert!(!still.contains(joints) && with("--stones 9").contains(joints));
    let half = with("--stones 9 --half");
    assert_eq!(half.matches("<g transform=").count(), 3, "with half a keystone");
    let one = printed("draw --at T --mode [s,r,r]");
    assert!(one.contains("[s,r,r] at T") && !one.contains("panel-1"));
}

/// With what is proved of it and what is a drawing only, in the picture as in JSON.
#[test]
fn what_falls_is_drawn_as_it_falls() {
    for (arguments, mode, words) in [
        ("--alpha 2.6 --mu 0.3", "[s,s]", "It stands at no thickness"),
        ("--alpha 2.9 --mu inf", "[r]", "It stands at no thickness"),
        ("--alpha 80deg --mu 0.6 --eta 0.05", "[r,r,r]", "It does not stand"),
        ("--alpha 90deg --mu 0.35 --eta 0.1 --stones 11", "[s,r,r]", "not stand"),
    ] {
        let svg = printed(format!("draw {arguments} --animate"));
        let falls = format!("does not stand: falls as {mode}");
        let said = ["Proved: whatever the thrust", "Drawn, not proved", "<animateTransform"];
        tells(&svg, [words, &falls].into_iter().chain(said));
        let arch = arch(format!("draw {arguments}"));
        assert_eq!(arch["verdict"], "falls");
        assert_eq!(arch["mechanisms"][0]["mode"], mode);
        assert!(arch["proved"].text().starts_with("whatever the thrust"));
        let power = |name: &str| arch["mechanisms"][0][name]["lower"].number();
        assert!(power("weight_power") > arch["mechanisms"][0]["power"]["upper"].number());
    }
}

/// What an arch that stands may do is told as `couplet assess` tells it.
#[test]
fn a_picture_tells_an_asymmetric_mechanism() {
    let line = "draw --half-opening 2.3 --friction 1.05 --thickness 0.55";
    // By a search made apart from this one.
    let moves = "0.583084449604";
    tells(&printed(line), ["an admissible symmetric state exists", moves]);
    assert!(arch(line)["asymmetric_thickness"]["value"].text().starts_with(moves));
}

/// The modes of a half opening, each in a state of its own between the frictions at which they change.
#[test]
fn modes_are_drawn_along_the_friction() {
    let json = object("draw --alpha 2.45 --along friction 0.5..3");
    let arches = json["arches"].list();
    let modes: Vec<&str> = arches.iter().map(|arch| arch["mechanisms"][0]["mode"].text()).collect();
    assert_eq!(modes, ["[s,s]", "[r,r,s]", "[r,r,r]"]);
    assert_eq!(arches[0]["verdict"], "falls");
    for (arch, next) in arches.iter().zip(&arches[1..]) {
        let end = arch["between_frictions"][1].clone();
        assert_eq!(end, next["between_frictions"][0]);
        let friction = end["double"].number();
        // On both sides of it the state has the mode of that side.
        for (by, of) in [(-1e-6, arch), (1e-6, next)] {
            let friction = format!("{:.9}", friction + by);
            let side = self::arch(format!("draw --alpha 2.45 --mu {friction}"));
            let modes = [&side, of].map(|of| &of["mechanisms"][0]["mode"]);
            assert_eq!(modes[0], modes[1], "{friction}");
        }
    }
    let svg = printed("draw --alpha 2.45 --along friction 0.5..3");
    let ends =
        ["friction below 1.32296", "friction 1.32296 to 1.39629", "friction 1.39629 and more"];
    tells(&svg, ends);
}

/// Another program reads the files without a fault: their release and unit, the arch of stones, its sizes and texts.
#[test]
fn a_file_for_cad_is_read_by_ezdxf() {
    if !has_module("ezdxf") {
        return;
    }
    const READ: &str = "
import sys, ezdxf
from collections import Counter
file = ezdxf.readfile(sys.argv[1])
audit = file.audit()
count = Counter(entity.dxf.layer for entity in file.modelspace())
layers = ' '.join(f'{layer}={count[layer]}' for layer in sys.argv[2:])
print(file.dxfversion, file.header['$INSUNITS'], len(audit.errors), len(audit.fixes), layers)
";
    let scratch = Scratch::new();
    let file = scratch.path("a.dxf");
    for (line, words) in [
        (
            "--span 10m --rise 3m --mu 0.6 --stones 21",
            "AC1015 6 0 0 STONES=20 DIMENSIONS=12 TEXT=5",
        ),
        ("--at T", "AC1015 0 0 0 STONES=0 DIMENSIONS=8 TEXT=17"),
        ("--alpha 1 --mu 1 --eta 1 --half", "AC1015 0 0 0 STONES=0 DIMENSIONS=2 TEXT=4"),
    ] {
        printed(format!("draw {line} -o {file}"));
        let layers = ["STONES", "DIMENSIONS", "TEXT"];
        let asked = Command::new("python3").args(["-c", READ, &file]).args(layers).output();
        assert_eq!(text(&asked.unwrap().stdout).trim(), words, "{line:?}");
    }
}
