//! Questions with ranges: what is proved of every arch inside, against single arches that are asked for one by one.

use super::exact;
use crate::program::{Json, Scratch, ended, fed, lines, object, printed, rows, tells, texts};
use couplet::report::MEANING;
use rug::Rational;
use serde_json::Value;

/// What a survey says of a quantity.
fn range<'a>(survey: &'a Value, quantity: &str) -> &'a Value {
    let all = survey["ranges"].list();
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

/// A question in which each measure is given as `name=range;value;value`: its line with the ranges, and those of the
/// arches inside that have these values, the corners among them.
fn asked(question: &str) -> (String, Vec<String>) {
    let (mut line, mut inside) = (String::new(), vec![String::new()]);
    for word in question.split(' ') {
        let (name, all) = word.split_once('=').unwrap_or((word, ""));
        let (range, values) = all.split_once(';').unwrap_or((all, all));
        let option = if all.is_empty() { name.to_owned() } else { format!("--{name}") };
        line += &format!("{option} {range} ");
        let with = |line: &String| {
            values.split(';').map(|value| format!("{line}{option} {value} ")).collect::<Vec<_>>()
        };
        inside = inside.iter().flat_map(with).collect();
    }
    (line, inside)
}

/// Every arch of a grid inside has its values within the ranges, and stands or not as the verdict says.
#[test]
fn every_arch_inside_is_within_the_ranges() {
    for case in [
        "all_stand assess alpha=80deg±1deg;79deg;80.3deg;81deg mu=0.6±10%;0.54;0.6;0.66 \
         eta=0.1..0.12;0.1;0.12 digits=5;12",
        "none_stands assess alpha=1.5..1.6;1.5;1.55;1.6 mu=31deg±1deg;30deg;32deg \
         eta=0.06±0.01;0.05;0.07 digits=5;12",
        "both_occur assess span=10m±10cm;9.9m;10m;10.1m rise=3m±5cm;2.95m;3.05m \
         eta=15cm+-1cm;14cm;16cm mu=0.5 digits=4;12",
        "all_stand assess radius=5m±2cm;4.98m;5m;5.02m alpha=1 eta=12cm±1cm;11cm;13cm mu=0.5 \
         digits=5;12",
    ] {
        let (outcome, question) = case.split_once(' ').unwrap();
        let (line, inside) = asked(question);
        let survey = object(&line);
        assert_eq!(survey["outcome"], outcome, "{line}");
        let mut stand = Vec::new();
        for arch in inside {
            let one = object(&arch);
            stand.push(one["stands"].as_bool().unwrap());
            let told =
                ["least_thickness", "geometric_safety", "required_friction", "friction_safety"];
            for quantity in told {
                let is_within = is_within(&survey, quantity, value(&one, quantity));
                assert!(is_within, "{line}: {quantity} of {arch}: {one}");
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
    let command = command.text().replace('\'', "");
    object(format!("{} --digits 20", command.strip_prefix("couplet ").unwrap()))
}

/// What is sought of every arch of a grid inside is within its range, whose ends the named questions attain.
#[test]
fn what_is_sought_is_within_its_range() {
    for case in [
        "half_opening all_can_stand mu=0.5..0.7;0.5;0.58;0.7 eta=0.1±10%;0.09;0.1;0.11 digits=7;12",
        "half_opening both_occur phi=0deg..30deg;0deg;1deg;20deg;30deg digits=6;12",
        "half_opening_degrees all_can_stand radius=5m±1cm;4.99m;5.01m mu=0.6 eta=50cm±1cm;49cm;51cm \
         weight=heyman digits=6;12",
        "friction all_can_stand alpha=78deg..82deg;78deg;1.4;82deg eta=0.1..0.12;0.1;0.117;0.12 \
         digits=8;12",
        "friction both_occur alpha=1..2.7;1;2;2.6;2.7 digits=5;12",
        "friction none_can_stand alpha=pi/2 eta=0.05..0.1;0.05;0.1 digits=5;12",
        "friction all_can_stand span=10m±10cm;9.9m;10m;10.1m rise=3m±5cm;2.95m;3m;3.05m \
         eta=40cm±1cm;39cm;41cm digits=4;12",
    ] {
        let [what, outcome, measures] = case.splitn(3, ' ').collect::<Vec<_>>()[..] else {
            panic!()
        };
        let sought = what.trim_end_matches("_degrees").replace('_', "-");
        let (line, inside) = asked(&format!("find {sought} {measures}"));
        let survey = object(&line);
        assert_eq!(survey["outcome"], outcome, "{line}");
        assert!(survey.get("modes").is_none() && survey["sought"].is_string(), "{survey}");
        for arch in inside {
            let one = object(&arch);
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
    for question in [
        "assess span=9.9m..10.1m;9.9m;10.1m rise=2.95m..3.05m;2.95m;3m;3.05m \
         thickness=45cm..50cm;45cm;47cm;50cm friction=0.5..0.6;0.5;0.6 density=24kN/m3 depth=2m",
        "assess span=9m..11m;9m;11m rise=4m..6m;4m;4.5m;5m;6m thickness=0.22r..0.25r;0.22r;0.25r \
         friction=0.9 density=24kN/m3 depth=2m",
        "assess measured-at=extrados depth=1m radius=4.98m..5.02m;4.98m;5.02m alpha=1..1.1;1;1.1 \
         thickness=15cm..17cm;15cm;17cm friction=0.5 \
         density=22kN/m3..2400kg/m3;22kN/m3;2400kg/m3",
        "voussoirs span=10m rise=3m stones=21 thickness=28cm..32cm;28cm;30cm;32cm \
         friction=0.5..0.7;0.5;0.7 density=24kN/m3 depth=2m",
        "state span=10m rise=3m friction=0.3..0.7;0.3;0.5;0.7 density=24kN/m3 depth=2m",
    ] {
        let (line, inside) = asked(question);
        let survey = object(&line);
        let told = match question.starts_with("state") {
            true => &["weight_kn", "thrust_kn"][..],
            false => &["weight_kn", "least_thrust_kn", "largest_thrust_kn"],
        };
        for arch in inside {
            let one = object(format!("{arch}--digits 12"));
            for quantity in told {
                let is_within = is_within(&survey, quantity, &one[quantity]);
                assert!(is_within, "{arch}: {quantity}: {survey}");
            }
        }
        // They say something: no end is farther off than the measures let it be.
        for quantity in told {
            let [lower, upper] = ends(&survey, quantity);
            assert!(lower > 0 && upper < lower * 5u32, "{line}: {quantity}");
        }
    }
    // An end that is exactly a tie is rounded outward too: 2 · 22.5 · 0.21 · 3.05 = 28.8225.
    let tie = "assess --half-opening 1 --radius 3.05m --measured-at centreline --thickness 0.21m..0.3m --friction 0.9 \
               --density 22.5kN/m3 --depth 1m";
    let [lower, _] = ends(&object(tie), "weight_kn");
    assert_eq!(lower, Rational::from((28_822, 1000)));
    let alone = object(format!("{tie} --quantity geometric_safety"));
    assert_eq!(alone["ranges"].list().len(), 1, "forces are not asked for");
    let thin =
        "assess --span 10m±10cm --rise 3m --eta 14cm..16cm --mu 0.5 --density 24kN/m3 --depth 1m";
    let survey = object(thin);
    assert_eq!(survey["outcome"], "both_occur");
    let mut names = texts(survey["ranges"].list(), "quantity");
    names.retain(|of| of.ends_with("_kn"));
    assert_eq!(names, ["weight_kn"]);
    tells(&printed(thin), ["in kN too, where every arch stands"]);
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
                let given = if is_range(of[0]) { of[1] } else { of[2] };
                format!("--{} {given} ", of[0].replace('_', "-"))
            };
            let all: String = fields.iter().map(option).collect();
            object(format!("assess {all}{more} --digits 7"))
        };
        let survey = with(&|_| true);
        let alone = survey["measures_alone"].list();
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
    let reasons = survey["measures_alone"].list().iter().map(|of| of["reason"].as_str());
    let open = Some("friction 0.6..inf has no exact middle");
    assert_eq!(reasons.collect::<Vec<_>>(), [open, None, open], "no order is known");
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
    for case in [
        "both_occur voussoirs alpha=pi/2 stones=11 mu=0.5..0.6;0.5;0.55;0.6 \
         eta=0.1..0.11;0.1;0.105;0.11 digits=6;12",
        "all_stand assess span=10m rise=3m stones=21 mu=31deg±2deg;29deg;33deg \
         eta=30cm±2cm;28cm;31cm;32cm digits=6;12",
        "all_stand voussoirs joints=0,0.4,0.9,1.3 mu=0.6±10%;0.54;0.66 \
         eta=0.12..0.15;0.12;0.14;0.15 digits=6;12",
    ] {
        let (outcome, question) = case.split_once(' ').unwrap();
        let (line, inside) = asked(question);
        let survey = object(&line);
        assert_eq!(survey["outcome"], outcome, "{line}");
        let told = texts(survey["ranges"].list(), "quantity");
        assert!(told.contains(&"geometric_safety"), "{told:?}");
        let mut stand = Vec::new();
        for arch in inside {
            let one = object(arch.replacen("assess", "voussoirs", 1));
            let given = &one["assessment"];
            stand.push(given["stands"].as_bool().unwrap());
            let least = is_within(&survey, "least_thickness", &one["thickness"]);
            assert!(least, "{line}: {arch}: {one}");
            let all = ["geometric_safety", "required_friction", "friction_safety", "least_thrust"];
            for quantity in all.into_iter().filter(|quantity| told.contains(quantity)) {
                let is_within = is_within(&survey, quantity, value(given, quantity));
                assert!(is_within, "{line}: {quantity} of {arch}");
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
        let named = ["worst", "best"].map(|of| survey[of]["command"].text());
        let parts = ["id=\"all\"", "id=\"each\"", "id=\"unrolled\"", "Proved: every arch stands"];
        tells(&picture, parts.into_iter().chain(named));
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
        for range in survey["ranges"].list() {
            for (end, is_lower) in [(&range["lower"], true), (&range["upper"], false)] {
                if end["arch"].is_null() || end["value"].is_null() {
                    continue;
                }
                let one = asked_again(&end["arch"]["command"]);
                let value = exact(&value(&one, range["quantity"].text())["value"]);
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
        let expected = match survey["outcome"].text() {
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
    assert_eq!(survey["meaning"], MEANING);
    assert_eq!(survey["asked"]["span"], "10m±2cm");
    let csv = printed(format!("{line} --format csv"));
    assert_eq!(csv.lines().count() - 1, survey["ranges"].list().len());
    assert!(csv.starts_with("weight,outcome,quantity,lower,lower_arch,upper,upper_arch,reason\n"));
    let one = printed(format!("{line} --quantity geometric_safety"));
    assert!(one.contains("geometric_safety") && !one.contains("required_friction"), "{one}");
    let both = object(format!("{line} --weight both"));
    assert_eq!(both.as_array().map(Vec::len), Some(2));
}

#[test]
fn an_answer_with_ranges_exits_as_one_without() {
    for eta in ["0.1", "0.05", "0.05..0.1"] {
        ended(0, format!("assess --alpha 80deg±1deg --mu 0.6 --eta {eta}"), "");
    }
    // Without a thickness, and with a trillion digits.
    ended(2, "assess --alpha 80deg±1deg --mu 0.6", "");
    ended(2, format!("state --alpha 1..2 --mu 1 --digits {}", "1".repeat(12)), "");
}
