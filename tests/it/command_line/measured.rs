//! Arches in metres: the numbers against those of a ring that is computed from its measures, and what is refused.

use super::exact;
use crate::program::{
    Json, Scratch, couplet, ended, fed, lines, object, printed, refused, rows, tells,
};
use rug::{Float, Rational};
use serde_json::Value;

/// The two bounds of a value.
fn bounds(value: &Value) -> [Float; 2] {
    ["lower", "upper"].map(|end| Float::with_val(200, exact(&value[end])))
}

fn holds(value: &Value, truth: &Float) {
    let [lower, upper] = bounds(value);
    assert!(lower <= *truth && *truth <= upper, "{value} {truth}");
}

/// A bare ring that is a little short says nothing of the bridge.
#[test]
fn a_ring_that_nearly_stands_is_no_bridge() {
    for (thickness, is_near) in [("0.588m", true), ("0.5m", false), ("0.7m", false)] {
        let arch = "assess --span 10.36m --rise 5.18m --friction 0.6 --thickness";
        let said = printed(format!("{arch} {thickness}"));
        let tolerance = format!("(--thickness {thickness}±5%)");
        assert_eq!(said.contains(&tolerance), is_near, "{said}");
    }
}

/// The same arch by span and rise, by radius and half opening, and by its ratios.
#[test]
fn measures_and_ratios_are_the_same_arch() {
    let [of_span, of_radius] =
        ["--span 10m --rise 5m", "--radius 5m --half-opening 90deg"].map(|arch| {
            object(format!("state {arch} --friction 0.6 --measured-at centreline --digits 30"))
        });
    let of_ratios = object("state --half-opening pi/2 --friction 0.6");
    for quantity in ["thickness", "thrust", "rotation_joint", "sliding_friction"] {
        assert_eq!(of_span[quantity], of_ratios[quantity], "{quantity}");
        assert_eq!(of_radius[quantity], of_ratios[quantity], "{quantity}");
    }
    assert_eq!(of_span["least_thickness_m"], of_radius["least_thickness_m"]);
    assert_eq!(of_ratios.get("least_thickness_m"), None);
    let [eta, _] = bounds(&of_ratios["thickness"]);
    let [metres, _] = bounds(&of_span["least_thickness_m"]);
    assert!(Float::with_val(200, eta * 5u32 - metres).abs() < 1e-28);
}

/// Sizes have six digits and ratios thirty, unless their number is given.
#[test]
fn sizes_have_few_digits() {
    let digits = |value: &Value| value["value"].text().trim_start_matches("0.").len();
    let found = object("state --span 10m --rise 3m --friction 0.6");
    assert_eq!((digits(&found["least_thickness_m"]), digits(&found["thickness"])), (6, 31));
    let found = object("state --span 10m --rise 3m --friction 0.6 --digits 9");
    assert_eq!((digits(&found["least_thickness_m"]), digits(&found["thickness"])), (9, 10));
}

/// The half opening of a span and a rise is that of its sine and cosine; the neighbour's is not.
#[test]
fn the_half_opening_is_that_of_the_measures() {
    for (span, rise) in [(10u32, 3u32), (10, 1), (3, 2), (7, 2)] {
        let found = object(format!("state --span {span}m --rise {rise}m --friction inf"));
        let ratio = Float::with_val(300, Rational::from((2 * rise, span)));
        let degrees = ratio.atan() * 360u32 / Float::with_val(300, rug::float::Constant::Pi);
        holds(&found["half_opening_degrees"], &degrees);
    }
    for (arch, degrees) in
        [("--span 10m --rise 5m", "90"), ("--radius 5m --half-opening 5pi/18", "50")]
    {
        let found = object(format!("state {arch} --friction inf"));
        assert_eq!(found["half_opening_degrees"]["value"], degrees);
    }
}

/// At each circle: a thickness that is the least one is, and forces are those of the ring's area.
#[test]
fn thickness_and_forces_are_those_of_the_ring() {
    for (circle, outwards) in [("intrados", 1i32), ("centreline", 0), ("extrados", -1)] {
        let found = object(format!(
            "assess --span 10m --rise 3m --thickness 600mm --measured-at {circle} --friction 0.6 \
             --density 24kN/m3 --depth 2m --digits 30"
        ));
        let radius = Rational::from((17, 3)) + Rational::from((3 * outwards, 10));
        holds(&found["radius_m"], &Float::with_val(300, &radius));
        let alpha = Float::with_val(300, Rational::from((3, 5))).atan() * 2u32;
        let force = radius * Rational::from((24 * 2 * 3, 5));
        let weight = Float::with_val(300, &force) * 2u32 * alpha;
        holds(&found["weight_kn"], &weight);
        for end in ["least_thrust", "largest_thrust"] {
            let thrusts = bounds(&found[end]["thrust"]);
            let [lower, upper] = thrusts.map(|x| x * Float::with_val(300, &force));
            let [from, to] = bounds(&found[format!("{end}_kn")]);
            assert!(from <= upper && lower <= to, "{circle} {end}");
        }
        // An arch as thick as its least thickness, a little more or less, at the same circle.
        let [least, _] = bounds(&found["least_thickness_m"]);
        for (factor, stands) in [(1.000_001, true), (0.999_999, false)] {
            let thickness = Float::with_val(100, &least * factor).to_f64();
            let beside = object(format!(
                "assess --span 10m --rise 3m --thickness {thickness}m --measured-at {circle} --friction 0.6"
            ));
            assert_eq!(beside["stands"], stands, "{circle} {factor}");
        }
    }
}

/// The weight of a rational half opening is rational, which no ball decides.
#[test]
fn a_rational_weight_is_exact() {
    for (alpha, weight) in [("1.5", Some("180")), ("1.25", Some("150")), ("86deg", None)] {
        let found = object(format!(
            "assess --radius 4.75m --half-opening {alpha} --thickness 0.5m --friction 0.6 --density 24kN/m3 --depth 1m"
        ));
        let found = &found["weight_kn"];
        let exact = (found["lower"] == found["upper"]).then_some(&found["value"]);
        assert_eq!(exact.and_then(Value::as_str), weight, "{alpha}");
    }
}

/// At the extrados span and rise are those of the sine and the cosine; an arch without lengths has no circle.
#[test]
fn spans_and_rises_follow_from_a_radius() {
    let found =
        object("state --radius 5m --half-opening 80deg --friction 0.6 --measured-at extrados");
    assert_eq!(found["measured_at"], "extrados");
    let eighty = Float::with_val(300, rug::float::Constant::Pi) * 4u32 / 9u32;
    holds(&found["span_m"], &(Float::with_val(300, eighty.sin_ref()) * 10u32));
    holds(&found["rise_m"], &((1u32 - Float::with_val(300, eighty.cos_ref())) * 5u32));
    let falls = object("state --span 10m --rise 3m --friction 0.1");
    assert_eq!((&falls["can_stand"], &falls["span_m"]["value"]), (&false.into(), &"10".into()));
    assert!(object("state --half-opening 80deg --friction 0.6").get("measured_at").is_none());
}

/// The default is the intrados, and another circle is another arch.
#[test]
fn a_span_is_measured_at_the_intrados() {
    let arch = "assess --span 10m --rise 5m --thickness 60cm --friction 0.6 --digits 5";
    let at = |circle: &str| {
        object(format!("{arch} --measured-at {circle}"))["geometric_safety"]["value"].clone()
    };
    assert_eq!(object(arch)["geometric_safety"]["value"], "1.0533");
    assert_eq!((at("intrados"), at("centreline")), ("1.0533".into(), "1.1165".into()));
}

/// A ratio says that it is one, beside lengths and alone.
#[test]
fn a_thickness_beside_lengths_has_its_unit() {
    let of = |arch: &str, eta: &str| {
        let mut found = object(format!("assess {arch} --friction 0.6 --thickness {eta}"));
        // The question is told as it was written.
        assert!(found.as_object_mut().unwrap().remove("asked").is_some());
        found
    };
    let [metres, ratio] = ["60cm", "18/179r"].map(|eta| of("--span 10m --rise 3m", eta));
    assert_eq!(metres["geometric_safety"], ratio["geometric_safety"]);
    assert_eq!(ratio["thickness_m"]["value"], "0.6");
    let [with, without] = ["0.1r", "0.1"].map(|eta| of("--half-opening 80deg --digits 17", eta));
    assert_eq!(with, without);
    let asked = "states --quantity geometric_safety";
    let row = &rows(fed(asked, "alpha,mu,eta\n80deg,0.6,0.1r\n").stdout)[0];
    assert_eq!(with["geometric_safety"]["value"], row["geometric_safety"]);
}

/// What is exact is rounded so, ties too. The sine of 30 degrees is a half, the cosine of 60 too.
#[test]
fn a_radius_is_rounded_to_even() {
    for (line, name) in [
        ("state --radius 5.125m --half-opening 1 --measured-at centreline", "radius_m"),
        ("state --radius 5.125m --half-opening 30deg", "span_m"),
        ("state --radius 10.25m --half-opening 60deg", "rise_m"),
        ("assess --radius 5m --half-opening 1 --thickness 25cm --measured-at intrados", "radius_m"),
    ] {
        let found = object(format!("{line} --friction 1 --digits 3"));
        assert_eq!(found[name]["value"], "5.12", "{line}");
    }
}

#[test]
fn a_certificate_holds_a_half_opening_by_its_tangent() {
    let scratch = Scratch::new();
    let file = scratch.path("arch.json");
    printed(format!("certify state --alpha 2atan(3/5) --mu 0.6 --digits 40 -o {file}"));
    let text = scratch.read("arch.json");
    assert!(text.contains("\"2 atan 3/5\""), "{text}");
    for engine in ["mpfr", "astro"] {
        printed(["check", &file, "--engine", engine]);
    }
    for wrong in ["2 atan 4/5", "2 atan 3/5 pi", "atan 3/5", "3/5"] {
        scratch.write("arch.json", text.replace("2 atan 3/5", wrong));
        assert_eq!(couplet(["check", &file]).status.code(), Some(1), "{wrong}");
    }
}

/// By a radius and a span, or a rise, at each circle: the measures are told as they were given, the half opening is
/// that of the sine, or of the cosine, and the answers lie between those of its neighbours. No certificate holds it.
#[test]
fn a_radius_makes_the_arc_of_a_span_or_a_rise() {
    for circle in ["intrados", "centreline", "extrados"] {
        let at = format!("--friction 0.6 --thickness 12cm --measured-at {circle} --digits 20");
        for (chord, name, sine) in [
            ("--span 3300mm", "span_m", Some((110, 133))),
            ("--rise 830mm", "rise_m", None),
            ("--rise 2.5m", "rise_m", None),
        ] {
            let found = object(format!("assess {chord} --radius 1995mm {at}"));
            let given: &str = chord.split(' ').next_back().unwrap();
            let metres = given.parse::<couplet::problem::measures::Length>().unwrap();
            let told = couplet::number::decimal(metres.metres());
            assert_eq!(found[name]["value"], told.as_str());
            let rise = || exact(&Value::from(told.as_str())) * Rational::from((1000, 1995));
            let alpha = match sine {
                Some(sine) => Float::with_val(300, Rational::from(sine)).asin(),
                None => Float::with_val(300, 1 - rise()).acos(),
            };
            let pi = Float::with_val(300, rug::float::Constant::Pi);
            holds(&found["half_opening_degrees"], &(alpha.clone() * 180u32 / &pi));
            let near = [1.0 - 1e-9, 1.0, 1.0 + 1e-9].map(|factor| {
                let alpha = Float::with_val(300, &alpha * factor).to_string_radix(10, Some(30));
                let by = object(format!("assess --half-opening {alpha} --radius 1995mm {at}"));
                bounds(&by["least_thickness"])[0].clone()
            });
            let [least, _] = bounds(&found["least_thickness"]);
            assert!(near[0] < least && least < near[2], "{circle} {chord}");
            assert!((least - &near[1]).abs() < 1e-18, "{circle} {chord}");
        }
    }
    for of in [
        "--span 3300mm --radius 1995mm --friction 0.5..0.6 --thickness 12cm",
        "--rise 830mm±1cm --radius 1995mm --friction 0.6 --thickness 12cm",
    ] {
        tells(&printed(format!("assess {of}")), ["every arch stands, proved"]);
    }
}

/// Every command that takes an arch reads it in metres, and answers as of its ratios.
#[test]
fn an_arch_in_metres_is_the_same_at_every_command() {
    let answered = |line: String| {
        let out = printed(line);
        // Sizes are of the measured one alone, and the question is told as it was written.
        let out = match out.split_once("\nas measured") {
            Some((before, rest)) => {
                let after = rest.split_once("\n\n").map(|(_, after)| format!("\n{after}"));
                before.to_owned() + &after.unwrap_or_default()
            }
            None => out,
        };
        let said = |line: &str| line.contains("self-weight alone") || line.contains("\"words\"");
        out.lines().filter(|line| !said(line)).map(str::to_owned).collect::<Vec<_>>()
    };
    for (command, has_thickness) in [
        ("assess --stones 41 --digits 9", true),
        ("assess --stones 41 --tilt 5deg --digits 9", true),
        ("assess --tilt 0.1 --digits 9", true),
        ("voussoirs --stones 40 --digits 9", true),
        ("voussoirs --stones 11..13 --digits 5", false),
        ("state --stones 7 --digits 9", false),
        ("certify arch --digits 9", true),
        ("complementarity --stones 9 --digits 9", true),
    ] {
        let eta = |eta| if has_thickness { format!("--thickness {eta}") } else { String::new() };
        let measured = format!("{command} --span 18.9m --rise 4.2m --friction 0.6 {}", eta("90cm"));
        let ratios =
            format!("{command} --half-opening 2atan(4/9) --friction 0.6 {}", eta("48/703"));
        assert_eq!(answered(measured), answered(ratios), "{command}");
    }
    let found =
        |arch| printed(format!("find friction {arch} --plain --quantity friction --digits 12"));
    let measured = found("--span 18.9m --rise 4.2m --thickness 90cm");
    assert_eq!(measured, found("--half-opening 2atan(4/9) --thickness 48/703"));
}

/// The end of a file's name asks for a picture: that of `couplet draw`.
#[test]
fn an_answer_is_a_picture_where_its_file_is_one() {
    let scratch = Scratch::new();
    let file = scratch.path("a.svg");
    let picture = |line: &str| {
        printed(format!("{line} -o {file}"));
        // The caption has the command, which is another.
        let text = scratch.read("a.svg");
        let lines = text.lines().filter(|line| !line.contains("couplet "));
        lines.map(str::to_owned).collect::<Vec<_>>()
    };
    let bridge = "--span 18.9m --rise 4.2m --friction 0.6";
    let asked =
        [("assess", "--thickness 90cm --stones 41"), ("state", ""), ("state", "--stones 9")];
    for (command, rest) in asked {
        let [one, other] =
            [command, "draw"].map(|name| picture(&format!("{name} {bridge} {rest}")));
        assert_eq!(one, other, "{command}{rest}");
        assert!(one.len() > 20);
    }
    std::fs::remove_file(&file).unwrap();
    for (line, why) in [
        ("state --alpha 1 --mu 1 --weight both", "one weight"),
        ("state --alpha 1 --mu 1 --quantity eta", "leave out --quantity"),
        ("state --alpha 1 --mu 1 --stones 501", "from 2 to 500"),
        ("state --alpha 1 --mu 1 --joints 0,0.5,1", "say the same"),
        ("state --mu 1 --joints 0,0.5,1", "stones of one angle"),
    ] {
        refused(format!("{line} -o {file}"), "", why);
        assert!(scratch.files(".").is_empty(), "{line}");
    }
}

/// Rows in metres have the answers of the same arches by the command, and their errors.
#[test]
fn rows_may_be_in_metres() {
    let table = "span,rise,radius,half_opening,friction,thickness,measured_at\n\
                 10m,3m,,,0.6,60cm,\n33ft,9ft,,,31deg,,extrados\n,,5m,80deg,0.6,0.1r,centreline\n,,,1,0.6,0.1,\n\
                 10m,,,,0.6,,\n10m,3m,,1,0.6,,\n10m,3m,,,0.6,0.1,\n,,5m,,0.6,,\n1,3m,,,0.6,,\n";
    let found = rows(ended(2, "states --digits 9", table).0);
    for (row, line) in found.iter().zip([
        "assess --span 10m --rise 3m --friction 0.6 --thickness 60cm",
        "state --span 33ft --rise 9ft --friction 31deg --measured-at extrados",
        "assess --radius 5m --half-opening 80deg --friction 0.6 --thickness 0.1r --measured-at centreline",
        "assess --half-opening 1 --friction 0.6 --thickness 0.1",
    ]) {
        let answer = object(format!("{line} --digits 9"));
        for name in ["least_thickness_m", "radius_m", "span_m", "measured_at", "geometric_safety"] {
            let value = &answer[name];
            let value = value["value"].as_str().or(value.as_str()).unwrap_or_default();
            assert_eq!(row[name], value, "{line} {name}");
        }
    }
    for (row, why) in found[4..].iter().zip([
        "span needs rise",
        "half_opening 1 contradicts span and rise",
        "has no unit",
        "the half_opening is empty",
        "'1' is not a length",
    ]) {
        assert!(row["error"].contains(why), "{row:?}");
    }
    assert_eq!(found.len(), 9);
    // An object of JSON has its sizes, another none.
    let all = "{\"span\":\"10m\",\"rise\":\"3m\",\"mu\":0.6}\n{\"alpha\":1,\"mu\":0.6}\n";
    let all = lines("states", all);
    assert_eq!(all[0]["span_m"]["value"], "10");
    assert!(all[1].get("span_m").is_none() && all[0].get("thickness_m").is_none());
}
