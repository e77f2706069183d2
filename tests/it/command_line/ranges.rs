//! Questions with ranges: what is proved of every arch inside, against single arches that are asked for one by one.

use super::exact;
use crate::program::{Scratch, couplet, fed, lines, object, printed, rows};
use couplet::report::MEANING;
use rug::Rational;
use serde_json::Value;

/// What a survey says of a quantity.
fn range<'a>(survey: &'a Value, quantity: &str) -> &'a Value {
    let all = survey["ranges"].as_array().unwrap();
    let found = all.iter().find(|range| range["quantity"] == quantity);
    found.unwrap_or_else(|| panic!("no {quantity}: {survey}"))
}

/// The ends of a quantity, where both are numbers.
fn ends(survey: &Value, quantity: &str) -> [Rational; 2] {
    ["lower", "upper"].map(|end| exact(&range(survey, quantity)[end]["value"]))
}

/// The value of a quantity of one arch; with a thrust is told what limits it.
fn value<'a>(one: &'a Value, quantity: &str) -> &'a Value {
    one[quantity].get("thrust").unwrap_or(&one[quantity])
}

/// Whether a value is within the range of its quantity; one that is not there only where nothing is enough.
fn is_within(survey: &Value, quantity: &str, value: &Value) -> bool {
    let [lower, upper] = ["lower", "upper"].map(|end| &range(survey, quantity)[end]);
    let is_number = |end: &Value| end["bound"] == "number";
    if value["value"].is_null() {
        return [lower, upper].into_iter().any(|end| end["bound"] == "not_enough");
    }
    let value = exact(&value["value"]);
    (!is_number(lower) || exact(&lower["value"]) <= value)
        && (!is_number(upper) || value <= exact(&upper["value"]))
        && (is_number(lower) || is_number(upper))
}

/// Arches inside, by their options, on a grid with the corners in it: of `alpha=1;2 mu=0.5` two.
fn inside(fields: &str) -> Vec<String> {
    fields.split(' ').fold(vec![String::new()], |lines, field| {
        let (name, values) = field.split_once('=').unwrap();
        let with =
            |value: &str| lines.iter().map(|line| format!("{line} --{name} {value}")).collect();
        values.split(';').map(with).collect::<Vec<Vec<String>>>().concat()
    })
}

/// Every arch of a grid inside has its values within the ranges, and stands or not as the verdict says.
#[test]
fn every_arch_inside_is_within_the_ranges() {
    for (ranges, outcome, fields) in [
        (
            "--alpha 80deg±1deg --mu 0.6±10% --eta 0.1..0.12 --digits 5",
            "all_stand",
            "alpha=79deg;80.3deg;81deg mu=0.54;0.6;0.66 eta=0.1;0.12",
        ),
        (
            "--alpha 1.5..1.6 --mu 31deg±1deg --eta 0.06±0.01 --digits 5",
            "none_stands",
            "alpha=1.5;1.55;1.6 mu=30deg;32deg eta=0.05;0.07",
        ),
        (
            "--span 10m±10cm --rise 3m±5cm --eta 15cm+-1cm --mu 0.5 --digits 4",
            "both_occur",
            "span=9.9m;10m;10.1m rise=2.95m;3.05m eta=14cm;16cm mu=0.5",
        ),
        (
            "--radius 5m±2cm --alpha 1 --eta 12cm±1cm --mu 0.5 --digits 5",
            "all_stand",
            "radius=4.98m;5m;5.02m alpha=1 eta=11cm;13cm mu=0.5",
        ),
    ] {
        let survey = object(format!("assess {ranges}"));
        assert_eq!(survey["outcome"], outcome, "{ranges}");
        let mut stand = Vec::new();
        for arch in inside(fields) {
            let one = object(format!("assess{arch} --digits 12"));
            stand.push(one["stands"].as_bool().unwrap());
            for quantity in
                ["least_thickness", "geometric_safety", "required_friction", "friction_safety"]
            {
                let value = value(&one, quantity);
                assert!(
                    is_within(&survey, quantity, value),
                    "{ranges}: {quantity} of {arch}: {one}"
                );
            }
        }
        let told = match (stand.contains(&true), stand.contains(&false)) {
            (true, false) => "all_stand",
            (false, true) => "none_stands",
            _ => "both_occur",
        };
        assert_eq!(told, outcome, "{ranges}");
    }
}

/// Answer to the command of an end, run as it is printed.
fn asked_again(command: &Value) -> Value {
    let command = command.as_str().unwrap().replace('\'', "");
    object(format!("{} --digits 20", command.strip_prefix("couplet ").unwrap()))
}

/// What is sought of every arch of a grid inside is within its range, whose ends the named questions attain.
#[test]
fn what_is_sought_is_within_its_range() {
    let (all, both, none) = ("all_can_stand", "both_occur", "none_can_stand");
    for (what, ranges, outcome, fields) in [
        (
            "half_opening",
            "--mu 0.5..0.7 --eta 0.1±10% --digits 7",
            all,
            "mu=0.5;0.58;0.7 eta=0.09;0.1;0.11",
        ),
        ("half_opening", "--phi 0deg..30deg --digits 6", both, "phi=0deg;1deg;20deg;30deg"),
        (
            "half_opening_degrees",
            "--radius 5m±1cm --mu 0.6 --eta 50cm±1cm --weight heyman --digits 6",
            all,
            "weight=heyman radius=4.99m;5.01m mu=0.6 eta=49cm;51cm",
        ),
        (
            "friction",
            "--alpha 78deg..82deg --eta 0.1..0.12 --digits 8",
            all,
            "alpha=78deg;1.4;82deg eta=0.1;0.117;0.12",
        ),
        ("friction", "--alpha 1..2.7 --digits 5", both, "alpha=1;2;2.6;2.7"),
        ("friction", "--alpha pi/2 --eta 0.05..0.1 --digits 5", none, "alpha=pi/2 eta=0.05;0.1"),
        (
            "friction",
            "--span 10m±10cm --rise 3m±5cm --eta 40cm±1cm --digits 4",
            all,
            "span=9.9m;10m;10.1m rise=2.95m;3m;3.05m eta=39cm;41cm",
        ),
    ] {
        let find = format!("find {}", what.trim_end_matches("_degrees").replace('_', "-"));
        let line = format!("{find} {ranges}");
        let survey = object(&line);
        assert_eq!(survey["outcome"], outcome, "{line}");
        assert!(survey.get("modes").is_none() && survey["sought"].is_string(), "{survey}");
        for arch in inside(fields) {
            let one = object(format!("{find}{arch} --digits 12"));
            assert!(is_within(&survey, what, &one[what]), "{line}: {arch}: {one}");
        }
        for (end, is_lower) in [("lower", true), ("upper", false)] {
            let end = &range(&survey, what)[end];
            let one = asked_again(&end["arch"]["command"]);
            if end["value"].is_null() {
                assert!(end["bound"] == "not_enough" && one[what]["value"].is_null(), "{line}");
                continue;
            }
            let (value, bound) = (exact(&one[what]["value"]), exact(&end["value"]));
            let off = if is_lower { value.clone() - bound } else { bound - value.clone() };
            assert!(off >= 0 && off < value / 1000, "{line}: {end}");
        }
    }
}

/// Weight and thrusts in kN of every arch inside are within their ranges, whichever measures have one.
#[test]
fn the_forces_of_every_arch_inside_are_within_their_ranges() {
    let load = "--density 24kN/m3 --depth 2m";
    for (question, ranges, fields, load) in [
        (
            "assess",
            "--span 9.9m..10.1m --rise 2.95m..3.05m --thickness 45cm..50cm --friction 0.5..0.6",
            "span=9.9m;10.1m rise=2.95m;3m;3.05m thickness=45cm;47cm;50cm friction=0.5;0.6",
            load,
        ),
        (
            "assess",
            "--span 9m..11m --rise 4m..6m --thickness 0.22r..0.25r --friction 0.9",
            "span=9m;11m rise=4m;4.5m;5m;6m thickness=0.22r;0.25r friction=0.9",
            load,
        ),
        (
            "assess --measured-at extrados --depth 1m",
            "--radius 4.98m..5.02m --alpha 1..1.1 --thickness 15cm..17cm --friction 0.5 \
             --density 22kN/m3..2400kg/m3",
            "radius=4.98m;5.02m alpha=1;1.1 thickness=15cm;17cm friction=0.5 density=22kN/m3;2400kg/m3",
            "",
        ),
        (
            "voussoirs --span 10m --rise 3m --stones 21",
            "--thickness 28cm..32cm --friction 0.5..0.7",
            "thickness=28cm;30cm;32cm friction=0.5;0.7",
            load,
        ),
        ("state --span 10m --rise 3m", "--friction 0.3..0.7", "friction=0.3;0.5;0.7", load),
    ] {
        let survey = object(format!("{question} {ranges} {load}"));
        let told = match question.starts_with("state") {
            true => &["weight_kn", "thrust_kn"][..],
            false => &["weight_kn", "least_thrust_kn", "largest_thrust_kn"],
        };
        for arch in inside(fields) {
            let one = object(format!("{question}{arch} {load} --digits 12"));
            for quantity in told {
                let is_within = is_within(&survey, quantity, &one[quantity]);
                assert!(is_within, "{arch}: {quantity}: {survey}");
            }
        }
        // They say something: no end is farther off than the measures let it be.
        for quantity in told {
            let [lower, upper] = ends(&survey, quantity);
            assert!(lower > 0 && upper < lower * 5u32, "{question} {ranges}: {quantity}");
        }
    }
    // An end that is exactly a tie is rounded outward too: 2 · 22.5 · 0.21 · 3.05 = 28.8225.
    let tie = "assess --half-opening 1 --radius 3.05m --measured-at centreline --thickness 0.21m..0.3m --friction 0.9 \
               --density 22.5kN/m3 --depth 1m";
    let [lower, _] = ends(&object(tie), "weight_kn");
    assert_eq!(lower, Rational::from((28_822, 1000)));
    let alone = object(format!("{tie} --quantity geometric_safety"));
    assert_eq!(alone["ranges"].as_array().unwrap().len(), 1, "forces are not asked for");
    let thin =
        "assess --span 10m±10cm --rise 3m --eta 14cm..16cm --mu 0.5 --density 24kN/m3 --depth 1m";
    let survey = object(thin);
    assert_eq!(survey["outcome"], "both_occur");
    let all = survey["ranges"].as_array().unwrap().iter();
    let names = all.filter_map(|range| range["quantity"].as_str());
    assert_eq!(names.filter(|of| of.ends_with("_kn")).collect::<Vec<_>>(), ["weight_kn"]);
    assert!(printed(thin).contains("in kN too, where every arch stands"));
    let table = "span,rise,thickness,mu,density,depth\n10m±10cm,3m,50cm,0.6,24kN/m3,1m\n10m±10cm,3m,50cm,0.6,,\n";
    let found = rows(fed("states --ranges --quantity largest_thrust_kn", table).stdout);
    let asked =
        object("assess --span 10m±10cm --rise 3m --eta 50cm --mu 0.6 --density 24kN/m3 --depth 1m");
    for end in ["lower", "upper"] {
        let [with, without] =
            [0, 1].map(|row: usize| &found[row][&format!("largest_thrust_kn_{end}")]);
        assert_eq!(range(&asked, "largest_thrust_kn")[end]["value"], **with);
        assert_eq!(without, "");
    }
}

/// What a tolerance does alone is what is said of all arches with that one range, the others at their middles; the
/// widest range is the first.
#[test]
fn what_to_measure_better_is_the_answer_with_one_range() {
    for (fields, more) in [
        (
            "span=10m±10cm;10m rise=2.95m..305cm;3m thickness=45cm..50cm;47.5cm friction=0.5..0.6;0.55",
            "",
        ),
        ("half_opening=80deg±1deg;80deg friction=0.2..1;0.6 thickness=0.06..0.061;121/2000", ""),
        ("radius=5m±2cm;5m friction=0.4..0.5;0.45 thickness=12cm±1cm;12cm", "--alpha 1"),
        ("friction=0.4..0.6;0.5 thickness=0.1..0.11;0.105", "--alpha pi/2 --stones 11"),
    ] {
        let fields = fields.split(' ').map(|field| field.split(['=', ';']).collect::<Vec<_>>());
        let fields: Vec<Vec<&str>> = fields.collect();
        let with = |is_range: &dyn Fn(&str) -> bool| {
            let option = |of: &Vec<&str>| {
                format!(
                    "--{} {} ",
                    of[0].replace('_', "-"),
                    of[if is_range(of[0]) { 1 } else { 2 }]
                )
            };
            let all: String = fields.iter().map(option).collect();
            object(format!("assess {all}{more} --digits 7"))
        };
        let survey = with(&|_| true);
        let alone = survey["measures_alone"].as_array().unwrap();
        assert_eq!(alone.len(), fields.len(), "{survey}");
        let mut widths = Vec::new();
        for told in alone {
            let one = with(&|name| told["measure"] == *name);
            assert!(one.get("measures_alone").is_none(), "one measure has a tolerance: {one}");
            let range = range(&one, "geometric_safety");
            for end in ["lower", "upper"] {
                let of = |all: &Value| (all[end]["value"].clone(), all[end]["bound"].clone());
                assert_eq!(of(told), of(range), "{told}");
            }
            // That nothing is enough for some is the most.
            let is_number = ["lower", "upper"].iter().all(|end| range[end]["bound"] == "number");
            widths.push(match is_number {
                true => exact(&range["upper"]["value"]) - exact(&range["lower"]["value"]),
                false => Rational::from(1000),
            });
        }
        assert!(widths.is_sorted_by(|a, b| a >= b), "{survey}");
        // In a row too, and of a table the measure that is the first.
        if more.is_empty() {
            let column = |k: usize| fields.iter().map(|of| of[k]).collect::<Vec<_>>().join(",");
            let table = format!("{}\n{}\n", column(0), column(1));
            let row = &lines("states --ranges --digits 7", &table)[0];
            assert_eq!(row["measures_alone"], survey["measures_alone"]);
            let cells = &rows(fed("states --ranges --digits 7", &table).stdout)[0];
            assert_eq!(alone[0]["measure"], cells["measure_first"]);
        }
    }
    // A range without end has no middle, at which the others are asked about.
    let survey = object("assess --alpha 80deg±1deg --mu 0.6..inf --eta 0.11±0.01");
    let reasons: Vec<&Value> =
        survey["measures_alone"].as_array().unwrap().iter().map(|of| &of["reason"]).collect();
    let open = "friction 0.6..inf has no exact middle";
    assert_eq!(reasons, [&open.into(), &Value::Null, &open.into()], "no order is known");
    let table = "alpha,mu,eta\n80deg±1deg,0.6..inf,0.11±0.01\n80deg±1deg,0.6±0.1,0.11±0.01\n";
    let cells = rows(fed("states --ranges", table).stdout);
    assert_eq!([0, 1].map(|row: usize| &*cells[row]["measure_first"]), ["", "thickness"]);
    let line = "assess --alpha 80deg±1deg --mu 0.5..0.6 --eta 0.1";
    let table = printed(line);
    let place =
        |words: &str| table.lines().position(|line| line.trim_start().starts_with(words)).unwrap();
    assert!(place("what to measure better") < place("half_opening "), "{table}");
    assert!(table.contains("\n   friction "), "{table}");
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
    for (line, outcome, fields) in [
        (
            "voussoirs --alpha pi/2 --stones 11 --mu 0.5..0.6 --eta 0.1..0.11 --digits 6",
            "both_occur",
            "alpha=pi/2 stones=11 mu=0.5;0.55;0.6 eta=0.1;0.105;0.11",
        ),
        (
            "assess --span 10m --rise 3m --stones 21 --mu 31deg±2deg --eta 30cm±2cm --digits 6",
            "all_stand",
            "span=10m rise=3m stones=21 mu=29deg;33deg eta=28cm;31cm;32cm",
        ),
        (
            "voussoirs --joints 0,0.4,0.9,1.3 --mu 0.6±10% --eta 0.12..0.15 --digits 6",
            "all_stand",
            "joints=0,0.4,0.9,1.3 mu=0.54;0.66 eta=0.12;0.14;0.15",
        ),
    ] {
        let survey = object(line);
        assert_eq!(survey["outcome"], outcome, "{line}");
        let all = survey["ranges"].as_array().unwrap().iter();
        let told: Vec<&str> = all.map(|range| range["quantity"].as_str().unwrap()).collect();
        assert!(told.contains(&"geometric_safety"), "{told:?}");
        let mut stand = Vec::new();
        for arch in inside(fields) {
            let one = object(format!("voussoirs{arch} --digits 12"));
            let given = &one["assessment"];
            stand.push(given["stands"].as_bool().unwrap());
            let least = is_within(&survey, "least_thickness", &one["thickness"]);
            assert!(least, "{line}: {arch}: {one}");
            for quantity in
                ["geometric_safety", "required_friction", "friction_safety", "least_thrust"]
            {
                let is_told = told.contains(&quantity);
                let is_within = |value| is_within(&survey, quantity, value);
                let value = value(given, quantity);
                assert!(!is_told || is_within(value), "{line}: {quantity} of {arch}");
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
    let file = scratch.path("a.svg");
    let drawn = |line: &str| {
        printed(format!("{line} -o {file}"));
        scratch.read("a.svg")
    };
    let ranges = "--alpha 78deg..82deg --mu 0.6..0.8 --eta 0.1..0.12";
    let survey = object(format!("assess {ranges}"));
    for command in ["draw", "assess"] {
        let picture = drawn(&format!("{command} {ranges}"));
        let named = ["worst", "best"].map(|of| survey[of]["command"].as_str().unwrap());
        let parts = ["id=\"all\"", "id=\"each\"", "id=\"unrolled\"", "Proved: every arch stands"];
        for part in parts.into_iter().chain(named) {
            assert!(picture.contains(part), "{command}: {part}");
        }
    }
    let picture = drawn("draw --alpha 78deg..82deg --mu 0.6 --eta 0.02..0.03");
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
        let one = object(format!("state --span {span} --rise 3m --mu 0.6 --digits 20"));
        exact(&one["thickness"]["value"])
    };
    let [lower, upper] = ends(&survey, "least_thickness");
    assert!(lower < one("10.01m") && one("9.99m") < upper && upper < one("9.98m"));
}

/// The meaning of a range, and how it was read, in every format that has sentences.
#[test]
fn what_a_range_means_is_said() {
    let line = "assess --span 10m±2cm --rise 3m --eta 60cm --mu 31deg±1deg";
    let table = printed(line);
    assert!(table.contains(MEANING) && MEANING.contains("every arch"), "{table}");
    assert!(table.starts_with("Every arch of span 9.98m to 10.02m, rise 3m at the intrados"));
    assert!(table.contains("friction 30deg to 32deg, Milankovitch-like self-weight alone"));
    let survey = object(line);
    assert_eq!(
        (&survey["meaning"], &survey["asked"]["span"]),
        (&MEANING.into(), &"10m±2cm".into())
    );
    let csv = printed(format!("{line} --format csv"));
    let rows = csv.lines().count() - 1;
    assert_eq!(rows, survey["ranges"].as_array().unwrap().len());
    assert!(csv.starts_with("weight,outcome,quantity,lower,lower_arch,upper,upper_arch,reason\n"));
    let one = printed(format!("{line} --quantity geometric_safety"));
    assert!(one.contains("geometric_safety") && !one.contains("required_friction"), "{one}");
    let both = object(format!("{line} --weight both"));
    assert_eq!(both.as_array().map(Vec::len), Some(2));
}

#[test]
fn an_answer_with_ranges_exits_as_one_without() {
    let code = |line: &str| couplet(line).status.code();
    for eta in ["0.1", "0.05", "0.05..0.1"] {
        assert_eq!(code(&format!("assess --alpha 80deg±1deg --mu 0.6 --eta {eta}")), Some(0));
    }
    assert_eq!(code("assess --alpha 80deg±1deg --mu 0.6"), Some(2), "no thickness");
    let many = "1".repeat(12);
    assert_eq!(code(&format!("state --alpha 1..2 --mu 1 --digits {many}")), Some(2));
}
