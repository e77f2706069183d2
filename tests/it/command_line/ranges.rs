//! Questions with ranges: what is proved of every arch inside, against single arches that are asked for one by one.

use super::{exact, printed, stdout};
use crate::program::{Scratch, couplet, fed};
use couplet::report::MEANING;
use rug::Rational;
use serde_json::Value;

fn words(line: &str) -> Vec<&str> {
    line.split(' ').collect()
}

fn object(line: &str) -> Value {
    let all: Vec<&str> = line.split(' ').chain(["--format", "json"]).collect();
    serde_json::from_str(&printed(&all)).unwrap()
}

/// The ends of a quantity, where both are numbers.
fn ends(survey: &Value, quantity: &str) -> [Rational; 2] {
    let all = survey["ranges"].as_array().unwrap();
    let range = all.iter().find(|range| range["quantity"] == quantity).unwrap();
    ["lower", "upper"].map(|end| exact(&range[end]["value"]))
}

/// The value of a quantity of one arch; with a thrust is told what limits it.
fn value<'a>(one: &'a Value, quantity: &str) -> &'a Value {
    one[quantity].get("thrust").unwrap_or(&one[quantity])
}

/// Whether a value is within the range of its quantity; one that is not there only where nothing is enough.
fn is_within(survey: &Value, quantity: &str, value: &Value) -> bool {
    let all = survey["ranges"].as_array().unwrap();
    let range = all.iter().find(|range| range["quantity"] == quantity).unwrap();
    let [lower, upper] = ["lower", "upper"].map(|end| &range[end]);
    let is_number = |end: &Value| end["bound"] == "number";
    if value["value"].is_null() {
        return [lower, upper].into_iter().any(|end| end["bound"] == "not_enough");
    }
    let value = exact(&value["value"]);
    (!is_number(lower) || exact(&lower["value"]) <= value)
        && (!is_number(upper) || value <= exact(&upper["value"]))
        && (is_number(lower) || is_number(upper))
}

/// Arches inside, by their options, on a grid with the corners in it.
fn inside(fields: &[(&str, &[&str])]) -> Vec<String> {
    let mut lines = vec![String::new()];
    for (name, values) in fields {
        let with =
            |value: &&str| lines.iter().map(|line| format!("{line} --{name} {value}")).collect();
        lines = values.iter().map(with).collect::<Vec<Vec<String>>>().concat();
    }
    lines
}

/// Every arch of a grid inside has its values within the ranges, and stands or not as the verdict says.
#[test]
fn every_arch_inside_is_within_the_ranges() {
    let quantities =
        ["least_thickness", "geometric_safety", "required_friction", "friction_safety"];
    for (line, outcome, fields) in [
        (
            "assess --alpha 80deg±1deg --mu 0.6±10% --eta 0.1..0.12 --digits 5",
            "all_stand",
            &[
                ("alpha", &["79deg", "80.3deg", "81deg"][..]),
                ("mu", &["0.54", "0.6", "0.66"]),
                ("eta", &["0.1", "0.12"]),
            ][..],
        ),
        (
            "assess --alpha 1.5..1.6 --mu 31deg±1deg --eta 0.06±0.01 --digits 5",
            "none_stands",
            &[
                ("alpha", &["1.5", "1.55", "1.6"]),
                ("mu", &["30deg", "32deg"]),
                ("eta", &["0.05", "0.07"]),
            ],
        ),
        (
            "assess --span 10m±10cm --rise 3m±5cm --eta 15cm+-1cm --mu 0.5 --digits 4",
            "both_occur",
            &[
                ("span", &["9.9m", "10m", "10.1m"]),
                ("rise", &["2.95m", "3.05m"]),
                ("eta", &["14cm", "16cm"]),
                ("mu", &["0.5"]),
            ],
        ),
        (
            "assess --radius 5m±2cm --alpha 1 --eta 12cm±1cm --mu 0.5 --digits 5",
            "all_stand",
            &[
                ("radius", &["4.98m", "5m", "5.02m"]),
                ("alpha", &["1"]),
                ("eta", &["11cm", "13cm"]),
                ("mu", &["0.5"]),
            ],
        ),
    ] {
        let survey = object(line);
        assert_eq!(survey["outcome"], outcome, "{line}");
        let mut stand = Vec::new();
        for arch in inside(fields) {
            let one = object(&format!("assess{arch} --digits 12"));
            stand.push(one["stands"].as_bool().unwrap());
            for quantity in quantities {
                let value = value(&one, quantity);
                assert!(is_within(&survey, quantity, value), "{line}: {quantity} of {arch}: {one}");
            }
        }
        let told = match (stand.contains(&true), stand.contains(&false)) {
            (true, false) => "all_stand",
            (false, true) => "none_stands",
            _ => "both_occur",
        };
        assert_eq!(told, outcome, "{line}");
    }
}

/// Answer to the command of an end, run as it is printed.
fn asked_again(command: &Value) -> Value {
    let command = command.as_str().unwrap().replace('\'', "");
    object(&format!("{} --digits 20", command.strip_prefix("couplet ").unwrap()))
}

/// What is sought of every arch of a grid inside is within its range, whose ends the named questions attain.
#[test]
fn what_is_sought_is_within_its_range() {
    for (what, quantity, ranges, outcome, fields) in [
        (
            "find half-opening",
            "half_opening",
            "--mu 0.5..0.7 --eta 0.1±10% --digits 7",
            "all_can_stand",
            &[("mu", &["0.5", "0.58", "0.7"][..]), ("eta", &["0.09", "0.1", "0.11"])][..],
        ),
        (
            "find half-opening",
            "half_opening",
            "--phi 0deg..30deg --digits 6",
            "both_occur",
            &[("phi", &["0deg", "1deg", "20deg", "30deg"])],
        ),
        (
            "find half-opening",
            "half_opening_degrees",
            "--radius 5m±1cm --mu 0.6 --eta 50cm±1cm --weight heyman --digits 6",
            "all_can_stand",
            &[
                ("weight", &["heyman"]),
                ("radius", &["4.99m", "5.01m"]),
                ("mu", &["0.6"]),
                ("eta", &["49cm", "51cm"]),
            ],
        ),
        (
            "find friction",
            "friction",
            "--alpha 78deg..82deg --eta 0.1..0.12 --digits 8",
            "all_can_stand",
            &[("alpha", &["78deg", "1.4", "82deg"]), ("eta", &["0.1", "0.117", "0.12"])],
        ),
        (
            "find friction",
            "friction",
            "--alpha 1..2.7 --digits 5",
            "both_occur",
            &[("alpha", &["1", "2", "2.6", "2.7"])],
        ),
        (
            "find friction",
            "friction",
            "--alpha pi/2 --eta 0.05..0.1 --digits 5",
            "none_can_stand",
            &[("alpha", &["pi/2"]), ("eta", &["0.05", "0.1"])],
        ),
        (
            "find friction",
            "friction",
            "--span 10m±10cm --rise 3m±5cm --eta 40cm±1cm --digits 4",
            "all_can_stand",
            &[
                ("span", &["9.9m", "10m", "10.1m"]),
                ("rise", &["2.95m", "3m", "3.05m"]),
                ("eta", &["39cm", "41cm"]),
            ],
        ),
    ] {
        let line = format!("{what} {ranges}");
        let survey = object(&line);
        assert_eq!(survey["outcome"], outcome, "{line}");
        assert!(survey.get("modes").is_none() && survey["sought"].is_string(), "{survey}");
        for arch in inside(fields) {
            let one = object(&format!("{what}{arch} --digits 12"));
            assert!(is_within(&survey, quantity, &one[quantity]), "{line}: {arch}: {one}");
        }
        let all = survey["ranges"].as_array().unwrap();
        let range = all.iter().find(|range| range["quantity"] == quantity).unwrap();
        for (end, is_lower) in [("lower", true), ("upper", false)] {
            let end = &range[end];
            let one = asked_again(&end["arch"]["command"]);
            if end["value"].is_null() {
                assert!(end["bound"] == "not_enough" && one[quantity]["value"].is_null(), "{line}");
                continue;
            }
            let (value, bound) = (exact(&one[quantity]["value"]), exact(&end["value"]));
            let off = if is_lower { value.clone() - bound } else { bound - value.clone() };
            assert!(off >= 0 && off < value / 1000, "{line}: {range}");
        }
    }
}

/// Weight and thrusts in kN of every arch inside are within their ranges, whichever measures have one.
#[test]
fn the_forces_of_every_arch_inside_are_within_their_ranges() {
    let load = " --density 24kN/m3 --depth 2m";
    for (question, fields, load) in [
        (
            "assess",
            &[
                ("span", "9.9m..10.1m", &["9.9m", "10.1m"][..]),
                ("rise", "2.95m..3.05m", &["2.95m", "3m", "3.05m"]),
                ("thickness", "45cm..50cm", &["45cm", "47cm", "50cm"]),
                ("friction", "0.5..0.6", &["0.5", "0.6"]),
            ][..],
            load,
        ),
        (
            "assess",
            &[
                ("span", "9m..11m", &["9m", "11m"]),
                ("rise", "4m..6m", &["4m", "4.5m", "5m", "6m"]),
                ("thickness", "0.22r..0.25r", &["0.22r", "0.25r"]),
                ("friction", "0.9", &["0.9"]),
            ],
            load,
        ),
        (
            "assess",
            &[
                ("radius", "4.98m..5.02m", &["4.98m", "5.02m"]),
                ("alpha", "1..1.1", &["1", "1.1"]),
                ("thickness", "15cm..17cm", &["15cm", "17cm"]),
                ("friction", "0.5", &["0.5"]),
                ("measured-at", "extrados", &["extrados"]),
                ("density", "22kN/m3..2400kg/m3", &["22kN/m3", "2400kg/m3"]),
                ("depth", "1m", &["1m"]),
            ],
            "",
        ),
        (
            "voussoirs",
            &[
                ("span", "10m", &["10m"]),
                ("rise", "3m", &["3m"]),
                ("stones", "21", &["21"]),
                ("thickness", "28cm..32cm", &["28cm", "30cm", "32cm"]),
                ("friction", "0.5..0.7", &["0.5", "0.7"]),
            ],
            load,
        ),
        (
            "state",
            &[
                ("span", "10m", &["10m"]),
                ("rise", "3m", &["3m"]),
                ("friction", "0.3..0.7", &["0.3", "0.5", "0.7"]),
            ],
            load,
        ),
    ] {
        let all: String =
            fields.iter().map(|(name, range, _)| format!(" --{name} {range}")).collect();
        let survey = object(&format!("{question}{all}{load}"));
        let told = if question == "state" {
            &["weight_kn", "thrust_kn"][..]
        } else {
            &["weight_kn", "least_thrust_kn", "largest_thrust_kn"]
        };
        let grid: Vec<(&str, &[&str])> =
            fields.iter().map(|(name, _, values)| (*name, *values)).collect();
        for arch in inside(&grid) {
            let one = object(&format!("{question}{arch}{load} --digits 12"));
            for quantity in told {
                assert!(
                    is_within(&survey, quantity, &one[quantity]),
                    "{arch}: {quantity}: {survey}"
                );
            }
        }
        // They say something: no end is farther off than the measures let it be.
        for quantity in told {
            let [lower, upper] = ends(&survey, quantity);
            assert!(lower > 0 && upper < lower * 5u32, "{question}{all}: {quantity}");
        }
    }
    // An end that is exactly a tie is rounded outward too: 2 · 22.5 · 0.21 · 3.05 = 28.8225.
    let tie = "assess --half-opening 1 --radius 3.05m --measured-at centreline --thickness 0.21m..0.3m --friction 0.9 \
               --density 22.5kN/m3 --depth 1m";
    let [lower, _] = ends(&object(tie), "weight_kn");
    assert_eq!(lower, Rational::from((28_822, 1000)));
    let alone = object(&format!("{tie} --quantity geometric_safety"));
    assert_eq!(alone["ranges"].as_array().unwrap().len(), 1, "forces are not asked for");
    let thin =
        "assess --span 10m±10cm --rise 3m --eta 14cm..16cm --mu 0.5 --density 24kN/m3 --depth 1m";
    let survey = object(thin);
    assert_eq!(survey["outcome"], "both_occur");
    let all = survey["ranges"].as_array().unwrap();
    let forces: Vec<&Value> = all
        .iter()
        .map(|range| &range["quantity"])
        .filter(|of| of.as_str().unwrap().ends_with("_kn"))
        .collect();
    assert_eq!(forces, ["weight_kn"]);
    assert!(printed(&words(thin)).contains("in kN too, where every arch stands"));
    let rows = "span,rise,thickness,mu,density,depth\n10m±10cm,3m,50cm,0.6,24kN/m3,1m\n10m±10cm,3m,50cm,0.6,,\n";
    let table = stdout(&fed(&["states", "--ranges", "--quantity", "largest_thrust_kn"], rows));
    let cells: Vec<&str> = table.lines().collect();
    assert!(cells[0].contains("largest_thrust_kn_lower,largest_thrust_kn_upper"), "{table}");
    let asked =
        object("assess --span 10m±10cm --rise 3m --eta 50cm --mu 0.6 --density 24kN/m3 --depth 1m");
    let [lower, _] = ["lower", "upper"].map(|end| {
        let all = asked["ranges"].as_array().unwrap();
        let range = all.iter().find(|range| range["quantity"] == "largest_thrust_kn").unwrap();
        range[end]["value"].as_str().unwrap().to_owned()
    });
    assert!(cells[1].contains(&lower) && !cells[2].contains(&lower), "{table}");
}

/// What a tolerance does alone is what is said of all arches with that one range, the others at their middles; the
/// widest range is the first.
#[test]
fn what_to_measure_better_is_the_answer_with_one_range() {
    for (fields, stones) in [
        (
            &[
                ("span", "10m±10cm", "10m"),
                ("rise", "2.95m..305cm", "3m"),
                ("thickness", "45cm..50cm", "47.5cm"),
                ("friction", "0.5..0.6", "0.55"),
            ][..],
            "",
        ),
        (
            &[
                ("half_opening", "80deg±1deg", "80deg"),
                ("friction", "0.2..1", "0.6"),
                ("thickness", "0.06..0.061", "121/2000"),
            ],
            "",
        ),
        (
            &[
                ("radius", "5m±2cm", "5m"),
                ("friction", "0.4..0.5", "0.45"),
                ("thickness", "12cm±1cm", "12cm"),
            ],
            "--alpha 1",
        ),
        (
            &[("friction", "0.4..0.6", "0.5"), ("thickness", "0.1..0.11", "0.105")],
            "--alpha pi/2 --stones 11",
        ),
    ] {
        let option = |name: &str, text: &str| format!(" --{} {text}", name.replace('_', "-"));
        let all: String = fields.iter().map(|(name, range, _)| option(name, range)).collect();
        let survey = object(&format!("assess{all} {stones} --digits 7").replace("  ", " "));
        let alone = survey["measures_alone"].as_array().unwrap();
        assert_eq!(alone.len(), fields.len(), "{survey}");
        let mut widths = Vec::new();
        for told in alone {
            let of = |(name, range, middle): &(&str, &str, &str)| {
                option(name, if told["measure"] == *name { range } else { middle })
            };
            let one: String = fields.iter().map(of).collect();
            let one = object(&format!("assess{one} {stones} --digits 7").replace("  ", " "));
            assert!(
                one.get("measures_alone").is_none(),
                "one measure alone has a tolerance: {one}"
            );
            let ranges = one["ranges"].as_array().unwrap();
            let range =
                ranges.iter().find(|range| range["quantity"] == "geometric_safety").unwrap();
            for end in ["lower", "upper"] {
                let of = |all: &Value| (all[end]["value"].clone(), all[end]["bound"].clone());
                assert_eq!(of(told), of(range), "{told}");
            }
            // That nothing is enough for some is the most.
            let is_number =
                range["lower"]["bound"] == "number" && range["upper"]["bound"] == "number";
            widths.push(match is_number {
                true => exact(&range["upper"]["value"]) - exact(&range["lower"]["value"]),
                false => Rational::from(1000),
            });
        }
        assert!(widths.is_sorted_by(|a, b| a >= b), "{survey}");
        // In a row too, and of a table the measure that is the first.
        let (names, texts): (Vec<&str>, Vec<&str>) =
            fields.iter().map(|(name, range, _)| (*name, *range)).unzip();
        if stones.is_empty() {
            let rows = format!("{}\n{}\n", names.join(","), texts.join(","));
            let told = |format: &str| {
                let words = ["states", "--ranges", "--digits", "7", "--format", format];
                stdout(&fed(&words, &rows))
            };
            let row: Value = serde_json::from_str(told("jsonl").trim()).unwrap();
            assert_eq!(row["measures_alone"], survey["measures_alone"]);
            let table = told("csv");
            let cells: Vec<Vec<&str>> =
                table.lines().map(|line| line.split(',').collect()).collect();
            let place = cells[0].iter().position(|name| *name == "measure_first").unwrap();
            assert_eq!(cells[1][place], alone[0]["measure"], "{table}");
        }
    }
    // A range without end has no middle, at which the others are asked about.
    let survey = object("assess --alpha 80deg±1deg --mu 0.6..inf --eta 0.11±0.01");
    let reasons: Vec<&Value> =
        survey["measures_alone"].as_array().unwrap().iter().map(|of| &of["reason"]).collect();
    let open = "friction 0.6..inf has no exact middle";
    assert_eq!(reasons, [&open.into(), &Value::Null, &open.into()], "no order is known");
    let rows = "alpha,mu,eta\n80deg±1deg,0.6..inf,0.11±0.01\n80deg±1deg,0.6±0.1,0.11±0.01\n";
    let table = stdout(&fed(&["states", "--ranges"], rows));
    let cells: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let place = cells[0].iter().position(|name| *name == "measure_first").unwrap();
    assert_eq!([cells[1][place], cells[2][place]], ["", "thickness"], "{table}");
    let line = "assess --alpha 80deg±1deg --mu 0.5..0.6 --eta 0.1";
    let table = printed(&words(line));
    let place =
        |words: &str| table.lines().position(|line| line.trim_start().starts_with(words)).unwrap();
    assert!(
        place("what to measure better") < place("half_opening ")
            && table.contains("\n   friction "),
        "{table}"
    );
    for line in [
        format!("{line} --quantity required_friction"),
        line.replace("80deg±1deg", "80deg±0deg"),
        "state --alpha 80deg±1deg --mu 0.5..0.6".to_owned(),
    ] {
        assert!(object(&line).get("measures_alone").is_none(), "{line}");
    }
}

/// Arches of stones: each of a grid inside is within the ranges, and the named ones are arches of stones.
#[test]
fn every_arch_of_stones_inside_is_within_the_ranges() {
    let quantities = ["geometric_safety", "required_friction", "friction_safety", "least_thrust"];
    for (line, outcome, fields) in [
        (
            "voussoirs --alpha pi/2 --stones 11 --mu 0.5..0.6 --eta 0.1..0.11 --digits 6",
            "both_occur",
            &[
                ("alpha", &["pi/2"][..]),
                ("stones", &["11"]),
                ("mu", &["0.5", "0.55", "0.6"]),
                ("eta", &["0.1", "0.105", "0.11"]),
            ][..],
        ),
        (
            "assess --span 10m --rise 3m --stones 21 --mu 31deg±2deg --eta 30cm±2cm --digits 6",
            "all_stand",
            &[
                ("span", &["10m"]),
                ("rise", &["3m"]),
                ("stones", &["21"]),
                ("mu", &["29deg", "33deg"]),
                ("eta", &["28cm", "31cm", "32cm"]),
            ],
        ),
        (
            "voussoirs --joints 0,0.4,0.9,1.3 --mu 0.6±10% --eta 0.12..0.15 --digits 6",
            "all_stand",
            &[
                ("joints", &["0,0.4,0.9,1.3"]),
                ("mu", &["0.54", "0.66"]),
                ("eta", &["0.12", "0.14", "0.15"]),
            ],
        ),
    ] {
        let survey = object(line);
        assert_eq!(survey["outcome"], outcome, "{line}");
        let mut stand = Vec::new();
        for arch in inside(fields) {
            let one = object(&format!("voussoirs{arch} --digits 12"));
            let given = &one["assessment"];
            stand.push(given["stands"].as_bool().unwrap());
            let least = is_within(&survey, "least_thickness", &one["thickness"]);
            assert!(least, "{line}: {arch}: {one}");
            let all = survey["ranges"].as_array().unwrap();
            for quantity in quantities {
                if all.iter().any(|range| range["quantity"] == quantity) {
                    let value = value(given, quantity);
                    assert!(is_within(&survey, quantity, value), "{line}: {quantity} of {arch}");
                }
            }
        }
        assert_eq!(stand.iter().all(|stands| *stands), outcome == "all_stand", "{line}");
        for (end, stands) in [("worst", outcome == "all_stand"), ("best", true)] {
            let one = asked_again(&survey[end]["command"]);
            assert_eq!(one["schema"], "couplet.voussoirs/1");
            assert_eq!(one["assessment"]["stands"], stands, "{line}");
        }
    }
    let survey = object("voussoirs --alpha 1 --stones 2 --mu 1..2");
    assert_eq!(survey["ranges"][0]["lower"]["bound"], "any_is_enough");
}

/// The picture says what is proved, in words that the answer has too.
#[test]
fn a_drawing_of_a_range_has_two_bands() {
    let scratch = Scratch::new();
    let ranges = "--alpha 78deg..82deg --mu 0.6..0.8 --eta 0.1..0.12";
    for command in ["draw", "assess"] {
        let file = scratch.path(&format!("{command}.svg"));
        printed(&words(&format!("{command} {ranges} -o {file}")));
        let picture = scratch.read(&format!("{command}.svg"));
        for part in ["id=\"all\"", "id=\"each\"", "id=\"unrolled\"", "Proved: every arch stands"] {
            assert!(picture.contains(part), "{command}: {part}");
        }
        let survey = object(&format!("assess {ranges}"));
        for of in ["worst", "best"] {
            assert!(picture.contains(survey[of]["command"].as_str().unwrap()), "{command}: {of}");
        }
    }
    let file = scratch.path("falling.svg");
    printed(&words(&format!("draw --alpha 78deg..82deg --mu 0.6 --eta 0.02..0.03 -o {file}")));
    let picture = scratch.read("falling.svg");
    assert!(picture.contains("Proved: no arch stands") && !picture.contains("id=\"all\""));
}

/// The command of each end, run as it is printed, has that value, and those of the verdict stand or not.
#[test]
fn the_named_arches_attain_the_ends() {
    for line in [
        "assess --alpha 80deg±1deg --phi 25deg..31deg --eta 0.07±10% --weight heyman --digits 7",
        "assess --span 33ft±1in --rise 3m±1cm --eta 15cm±1cm --mu 0.4..0.5 --digits 5",
        "assess --span 10m±1cm --rise 3m --eta 0.03r --mu 0.6 --measured-at extrados --digits 6",
    ] {
        let survey = object(line);
        let mut checked = 0;
        for range in survey["ranges"].as_array().unwrap() {
            let [lower, upper] = ["lower", "upper"].map(|end| &range[end]);
            for (end, is_lower) in [(lower, true), (upper, false)] {
                if end["arch"].is_null() || end["value"].is_null() {
                    continue;
                }
                let one = asked_again(&end["arch"]["command"]);
                let quantity = range["quantity"].as_str().unwrap();
                let value = exact(&value(&one, quantity)["value"]);
                let bound = exact(&end["value"]);
                let off = if is_lower { value.clone() - bound } else { bound - value.clone() };
                let least = Rational::from((-1, 1_000_000_000));
                assert!(off > least && off < value / 1000, "{line}: {range}");
                checked += 1;
            }
        }
        assert!(checked >= 6, "{line}: {survey}");
        let [worst, best] =
            ["worst", "best"].map(|of| asked_again(&survey[of]["command"])["stands"].clone());
        let expected = match survey["outcome"].as_str().unwrap() {
            "all_stand" => [true, true],
            "none_stands" => [false, false],
            "both_occur" => [false, true],
            other => panic!("{other}"),
        };
        assert_eq!([worst, best], expected.map(Value::from), "{line}");
    }
}

/// Without a thickness: whether they can stand, and of which least thickness.
#[test]
fn arches_without_a_thickness_can_stand_or_not() {
    for (line, outcome) in [
        ("state --alpha 1..1.5 --mu 0.5..inf", "all_can_stand"),
        ("state --alpha 1.5±0.1 --mu 0.1..0.2", "none_can_stand"),
        ("state --alpha 1.5 --mu 0.2..0.5", "both_occur"),
    ] {
        let survey = object(line);
        assert_eq!(survey["outcome"], outcome, "{line}");
        assert_eq!(survey["ranges"][0]["quantity"], "least_thickness", "{line}");
    }
    let survey = object("state --span 10m±1cm --rise 3m --mu 0.6 --digits 8");
    let one = |span: &str| {
        let one = object(&format!("state --span {span} --rise 3m --mu 0.6 --digits 20"));
        exact(&one["thickness"]["value"])
    };
    let [lower, upper] = ends(&survey, "least_thickness");
    assert!(lower < one("10.01m") && one("9.99m") < upper && upper < one("9.98m"));
}

/// The meaning of a range, and how it was read, in every format that has sentences.
#[test]
fn what_a_range_means_is_said() {
    let line = "assess --span 10m±2cm --rise 3m --eta 60cm --mu 31deg±1deg";
    let table = printed(&words(line));
    assert!(table.contains(MEANING) && MEANING.contains("every arch"), "{table}");
    assert!(table.starts_with("Every arch of span 9.98m to 10.02m, rise 3m at the intrados"));
    assert!(table.contains("friction 30deg to 32deg, Milankovitch-like self-weight alone"));
    let survey = object(line);
    assert_eq!(
        (&survey["meaning"], &survey["asked"]["span"]),
        (&MEANING.into(), &"10m±2cm".into())
    );
    let csv = printed(&[&words(line)[..], &["--format", "csv"]].concat());
    let rows = csv.lines().count() - 1;
    assert_eq!(rows, survey["ranges"].as_array().unwrap().len());
    assert!(csv.starts_with("weight,outcome,quantity,lower,lower_arch,upper,upper_arch,reason\n"));
    let one = printed(&[&words(line)[..], &["--quantity", "geometric_safety"]].concat());
    assert!(one.contains("geometric_safety") && !one.contains("required_friction"), "{one}");
    let both = object(&format!("{line} --weight both"));
    assert_eq!(both.as_array().map(Vec::len), Some(2));
}

/// A range of one arch is that arch.
#[test]
fn a_range_without_extent_is_one_arch() {
    let survey = object("assess --alpha 80deg..80deg --mu 0.6±0 --eta 0.1 --digits 10");
    let one = object("assess --alpha 80deg --mu 0.6 --eta 0.1 --digits 10");
    for quantity in ["least_thickness", "geometric_safety", "required_friction", "least_thrust"] {
        let bounds = ["lower", "upper"].map(|end| exact(&value(&one, quantity)[end]));
        assert_eq!(ends(&survey, quantity), bounds, "{quantity}");
    }
    assert_eq!(survey["worst"], survey["best"]);
}

/// A cell of a row is one value, and one that is a range is told so.
#[test]
fn a_row_with_a_range_is_refused_alone() {
    let rows = "alpha,mu\n80deg±1deg,0.6\n1,0.5..0.6\n1,1\n";
    let output = fed(&["states", "--format", "jsonl"], rows);
    assert_eq!(output.status.code(), Some(2));
    let lines = stdout(&output);
    let lines: Vec<Value> = lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    for (line, text) in lines.iter().zip(["80deg±1deg", "0.5..0.6"]) {
        let error = line["error"].as_str().unwrap();
        assert!(error.contains(text) && error.contains("`couplet states --ranges`"), "{error}");
    }
    assert_eq!(lines[2]["can_stand"], true);
}

#[test]
fn an_answer_with_ranges_exits_as_one_without() {
    let code = |line: &str| couplet(&words(line)).status.code();
    for eta in ["0.1", "0.05", "0.05..0.1"] {
        assert_eq!(code(&format!("assess --alpha 80deg±1deg --mu 0.6 --eta {eta}")), Some(0));
    }
    assert_eq!(code("assess --alpha 80deg±1deg --mu 0.6"), Some(2), "no thickness");
    let many = "1".repeat(12);
    assert_eq!(code(&format!("state --alpha 1..2 --mu 1 --digits {many}")), Some(2));
}

wrong_uses! {
    half_a_range: ["state", "--alpha", "80deg±", "--mu", "1"] => "half a range: give both ends";
    a_range_with_one_unit: ["state", "--alpha", "80..82deg", "--mu", "1"] => "write 80deg..82deg";
    a_range_upside_down: ["state", "--alpha", "82deg..80deg", "--mu", "1"] => "give the lower end first";
    a_range_of_three: ["state", "--alpha", "1..2..3", "--mu", "1"] => "more parts than a range";
    a_negative_deviation: ["state", "--alpha", "1", "--mu", "0.6±-1%"] => "a deviation below 0";
    another_unit: ["assess", "--span", "3m±2deg", "--rise", "1m", "--mu", "1", "--eta", "0.1r"]
        => "make no exact sum";
    stones_beside_a_range: ["state", "--alpha", "1..2", "--mu", "1", "--stones", "5"]
        => "--stones does not go with the range of --half-opening";
    a_tilt_beside_a_range: ["assess", "--alpha", "1..2", "--mu", "1", "--eta", "0.1", "--tilt", "0.1"]
        => "--tilt does not go with the range of --half-opening";
    a_density_upside_down:
        ["assess", "--radius", "1m..2m", "--alpha", "1", "--mu", "1", "--eta", "10cm", "--density", "24kN/m3..22kN/m3", "--depth", "1m"]
        => "24kN/m3..22kN/m3 is empty";
    a_picture_of_a_range_without_a_thickness: ["state", "--alpha", "1..2", "--mu", "1", "-o", "arches.svg"]
        => "a picture of a range is of arches of a thickness";
    a_picture_of_a_range_for_a_machine:
        ["draw", "--alpha", "1..2", "--mu", "1", "--eta", "0.1", "--format", "dxf"]
        => "the picture of a range is written only as json, svg, png, pdf, not dxf";
    a_picture_of_a_range_of_stones:
        ["draw", "--alpha", "1", "--mu", "1..2", "--eta", "0.1", "--stones", "5"]
        => "has a joint at every angle: leave out the stones";
    a_motion_of_a_range: ["draw", "--alpha", "1..2", "--mu", "1", "--eta", "0.1", "--animate"]
        => "--animate is of a picture of one upright arch";
    values_alone_of_a_range: ["state", "--alpha", "1..2", "--mu", "1", "--plain"]
        => "written only as table, json, csv, csv2, latex, markdown, not plain";
    a_quantity_without_a_range: ["state", "--alpha", "1..2", "--mu", "1", "--quantity", "sliding_joint"]
        => "there is no sliding_joint here";
    a_boundary_of_a_range: ["find", "boundary", "rrs/rsr", "--mu", "1.6..1.7"]
        => "ranges are for `couplet assess`, `state`, `voussoirs`, `find half-opening`, `find friction`, `draw` and `certify survey`";
    what_is_sought_in_a_range: ["find", "friction", "--mu", "0.5..0.6", "--alpha", "1"]
        => "--friction does not belong here";
    a_range_of_half_openings_beside_what_is_missing: ["find", "half-opening", "--eta", "0.1..0.2"]
        => "--friction (or --friction-angle) is missing";
    a_range_that_moves_joints: ["voussoirs", "--alpha", "1..2", "--mu", "1", "--stones", "5"]
        => "--stones does not go with the range of --half-opening, which moves the joints";
    a_span_that_moves_joints:
        ["assess", "--span", "9m..10m", "--rise", "3m", "--mu", "1", "--eta", "50cm", "--stones", "5"]
        => "--stones does not go with the range of --span, which moves the joints";
    a_range_of_numbers_of_stones: ["voussoirs", "--alpha", "1", "--mu", "1..2", "--stones", "5..7"]
        => "a range of arches has one number of stones";
    a_drawing_of_a_range_without_a_thickness: ["draw", "--alpha", "1..2", "--mu", "1"] => "--thickness is missing";
    a_certificate_of_a_range: ["certify", "arch", "--alpha", "1..2", "--mu", "1", "--eta", "0.1"]
        => "give one value here";
    an_equation_of_a_range: ["equation", "4", "--alpha", "1..2", "--eta", "0.1"]
        => "'1..2' is a range: one value is read here";
    a_joint_of_a_range: ["state", "--beta", "1..2", "--mu", "1"] => "is a range: one value is read here";
    a_range_beside_a_joint: ["state", "--beta", "1", "--mu", "0.5..1"] => "give one value here";
}
