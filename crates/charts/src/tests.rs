use super::*;
use crate::arch::SelfWeight;
use crate::atlas::{Curve, Level, Trace};
use crate::number::ExactNumber;
use crate::picture::Print;
use crate::problem::{Arch, Mode};
use crate::reading::texts;
use std::sync::OnceLock;

/// Largest distance of a curve from the truth.
const TOLERANCE: f64 = 1e-3;

/// All curves of some weights.
fn traced(weights: &[SelfWeight]) -> Vec<Trace> {
    let curves = weights.iter().flat_map(|w| Curve::ALL.map(|curve| (*w, curve)));
    curves.map(|(weight, curve)| Trace::new(curve, weight, TOLERANCE).unwrap()).collect()
}

/// All curves of some weights, proved once.
fn traces(weights: &[SelfWeight]) -> Vec<Trace> {
    static TRACES: OnceLock<Vec<Trace>> = OnceLock::new();
    let all = TRACES.get_or_init(|| traced(&SelfWeight::ALL)).iter();
    all.filter(|trace| weights.contains(&trace.weight)).cloned().collect()
}

/// Levels of a plane for one weight.
fn levels(traces: &[Trace], weight: SelfWeight, plane: Plane) -> Vec<Level> {
    let level = |contour| Level::among(traces, weight, contour, TOLERANCE).unwrap();
    plane.contours().iter().map(level).collect()
}

/// A picture of some curves.
fn picture(weights: &[SelfWeight], view: View) -> String {
    printed(traces(weights), weights[0], view)(&Print::default())
}

/// Some curves, to be printed; levels of a weight.
fn printed(traces: Vec<Trace>, weight: SelfWeight, view: View) -> impl Fn(&Print) -> String {
    let drawing = Drawing {
        view,
        axes: Axes::default(),
        marks: Vec::new(),
        command: "couplet map -o map.svg".into(),
    };
    let levels = match view {
        View::Map(plane) => levels(&traces, weight, plane),
        _ => Vec::new(),
    };
    move |print| drawing.svg((&traces, &levels, &[]), print).unwrap()
}

/// Picture of a plane with marks.
fn marked(plane: Plane) -> String {
    let weight = SelfWeight::Milankovitch;
    let traces = traces(&[weight]);
    let mark = |(alpha, mu, eta): (&str, &str, Option<&str>)| {
        let eta: Option<ExactNumber> = eta.map(|eta| eta.parse().unwrap());
        Mark::new(&Arch::parse(weight.name(), alpha, mu).unwrap(), eta.as_ref()).unwrap()
    };
    let arches =
        [("80deg", "0.6", Some("0.15")), ("145.1deg", "1.6", None), ("150deg", "inf", None)];
    let marks = arches.map(mark).into();
    let axes = Axes::default();
    let drawing = Drawing { view: View::Map(plane), axes, marks, command: "couplet map".into() };
    drawing.svg((&traces, &[], &[]), &Print::default()).unwrap()
}

/// Each mark is there once in the map or in an inset, and is explained once.
#[test]
fn marks_are_numbered_and_explained() {
    for plane in Plane::ALL {
        let svg = marked(plane);
        let words = texts(&svg).unwrap().join(" ");
        for (number, said) in
            [(1, "(1) α = 80°, μ = 0.6, η = 0.15: stands"), (2, "(2) α"), (3, "μ = ∞")]
        {
            assert!(svg.contains(&format!("mark-{number}\">")), "{plane:?} {number}");
            assert!(words.contains(said), "{plane:?}: {words}");
        }
    }
}

/// The map with levels on other axes, by name.
fn on_other_axes() -> Vec<(String, String)> {
    let weight = SelfWeight::Heyman;
    let traces = traces(&[weight]);
    let shown = |unit, range| Shown { unit, range };
    let (none, derived) = (Shown::default(), Unit::Derived);
    let cases = [
        ("log", Plane::ThicknessFriction, none, none, shown(derived, None)),
        ("mu", Plane::ThicknessFriction, none, shown(derived, None), none),
        ("A", Plane::OpeningThickness, shown(derived, None), none, none),
        (
            "part",
            Plane::ThicknessFriction,
            none,
            shown(Unit::Usual, Some([0.0, 45.0])),
            shown(Unit::Usual, Some([0.0, 0.4])),
        ),
        ("rad", Plane::OpeningFriction, shown(Unit::Radians, Some([2.2, 2.9])), none, none),
    ];
    let picture = |(name, plane, half_opening, friction, thickness): (&str, Plane, _, _, _)| {
        let axes = Axes { half_opening, friction, thickness };
        let levels = levels(&traces, weight, plane);
        let view = View::Map(plane);
        let drawing = Drawing { view, axes, marks: Vec::new(), command: "couplet map".into() };
        (
            format!("figure-axes-{name}"),
            drawing.svg((&traces, &levels, &[]), &Print::default()).unwrap(),
        )
    };
    cases.map(picture).into()
}

/// All kinds of pictures, by name.
fn pictures() -> &'static [(String, String)] {
    static PICTURES: OnceLock<Vec<(String, String)>> = OnceLock::new();
    PICTURES.get_or_init(|| {
        let both = |name: &str, view| (name.to_owned(), picture(&SelfWeight::ALL, view));
        let mut pictures = vec![
            both("figure-2", View::Branches(Branches::Rotation)),
            both("figure-3", View::Branches(Branches::Overturning)),
            both("figure-4", View::Branches(Branches::Joined)),
            both("figure-5", View::Lines),
        ];
        for weight in SelfWeight::ALL {
            for plane in Plane::ALL {
                let name = format!("{}-{}", weight.name(), plane.name());
                pictures.push((name, picture(&[weight], View::Map(plane))));
            }
        }
        for plane in Plane::ALL {
            pictures.push((format!("figure-marked-{}", plane.name()), marked(plane)));
        }
        pictures.extend(on_other_axes());
        pictures
    })
}

#[test]
fn pictures_are_well_formed_and_finite() {
    for (name, svg) in pictures() {
        assert!(texts(svg).is_some(), "{name}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
    }
}

/// S and J have their inset on other axes too, where they are close and where both are seen.
#[test]
fn what_is_close_is_shown_larger_on_all_axes() {
    let has = |name: &str, words: &[&str]| {
        let (_, svg) = pictures().iter().find(|(of, _)| of.ends_with(name)).unwrap();
        let all = texts(svg).unwrap();
        let is_there = |word: &&str| all.iter().any(|text| text == word);
        svg.contains("<g id=\"inset-sj-domain-rsr\">") && words.iter().all(is_there)
    };
    for name in ["axes-log", "axes-mu", "axes-A"] {
        assert!(has(name, &["S", "J", "S, J", "[r,s,r]"]), "{name}");
    }
    assert!(!has("axes-part", &[]), "they are elsewhere");
}

#[test]
fn a_picture_is_always_drawn_alike() {
    let (weight, view) = (SelfWeight::Heyman, View::Map(Plane::OpeningFriction));
    let again = printed(traced(&[weight]), weight, view)(&Print::default());
    assert_eq!(again, picture(&[weight], view));
}

/// Each mode is named, and has its domain where it is an area; each line has its path.
#[test]
fn a_map_has_every_domain_line_and_name() {
    for (name, svg) in pictures().iter().filter(|(name, _)| !name.starts_with("figure")) {
        let words = texts(svg).unwrap();
        let is_there = |id: String| svg.contains(&format!("<g id=\"{id}\">"));
        for mode in Mode::ALL {
            let is_line = match mode {
                Mode::Rotational => name.ends_with("opening-thickness"),
                Mode::Sliding => name.ends_with("opening-friction"),
                Mode::Overturning => name.ends_with("opening-thickness"),
                _ => false,
            };
            assert!(is_line || is_there(content::domain_id(mode)), "{name} {mode}");
            let is_named = words.iter().any(|word| word == mode.label());
            assert!(is_named || (is_line && mode != Mode::Overturning), "{name} {mode}");
        }
        for curve in Curve::ALL.into_iter().filter(|c| matches!(c, Curve::Line(_))) {
            assert!(is_there(format!("line-{}", curve.to_string().replace('/', "-"))), "{curve}");
        }
        let plane = Plane::ALL.into_iter().find(|plane| name.ends_with(plane.name())).unwrap();
        for contour in plane.contours() {
            assert!(
                is_there(format!("level-{}", contour.to_string().replace(' ', "-"))),
                "{contour}"
            );
            let value = contour.given().replace("deg", "°");
            assert!(words.contains(&value), "{name} {value}");
        }
        assert!(words.iter().any(|word| word == plane.contour_label()), "{name}");
        for landmark in ["T", "B", "ℓ", "L", "S", "J"] {
            assert!(words.iter().any(|word| word == landmark), "{name} {landmark}");
        }
    }
}

/// Overturning over A and over the half opening, each with its axis; then rotation and overturning, told apart by
/// dashes, and their tangent where they join.
#[test]
fn overturning_has_figures_of_its_own() {
    let of = |name: &str| &pictures().iter().find(|(other, _)| other == name).unwrap().1;
    let (third, fourth) = (of("figure-3"), of("figure-4"));
    for (svg, panels) in [(third, 2), (fourth, 3)] {
        assert!(svg.contains(&format!("id=\"panel-{}\"", panels - 1)));
        assert!(!svg.contains(&format!("id=\"panel-{panels}\"")));
        let words = texts(svg).unwrap();
        for label in ["A = α cot(α/2)", "half opening α (°)", "(a)", "(b)"] {
            assert!(words.iter().any(|word| word == label), "{label}");
        }
        for weight in SelfWeight::ALL {
            // The ids of all panels but the first have the panel before them.
            let id = format!("{}-overturning\">", weight.name());
            assert_eq!(svg.matches(&id).count(), panels);
        }
    }
    assert!(!third.contains("-rotation\"") && !third.contains("tangent"));
    for weight in SelfWeight::ALL {
        let stroke = |curve: &str| {
            let group =
                fourth.split(&format!("<g id=\"{}-{curve}\">", weight.name())).nth(1).unwrap();
            let path = group.split('>').next().unwrap();
            path.split("stroke-dasharray=\"").nth(1).map(|dashes| dashes.split('"').next().unwrap())
        };
        assert_ne!(stroke("rotation"), stroke("overturning"), "{weight:?}");
        assert!(stroke("tangent").is_some());
    }
    let words = texts(fourth).unwrap().join(" ");
    assert!(words.contains("have one slope") && words.contains("common tangent at ℓ"));
}

#[test]
fn a_caption_says_what_is_proved_and_how_it_is_made() {
    for (name, svg) in pictures() {
        let words = texts(svg).unwrap().join(" ");
        for said in ["proved", "nothing is left open", "self-weight", "Command: couplet map"] {
            assert!(words.contains(said), "{name}: {said}");
        }
        assert!(
            ["10⁻⁵", "10⁻⁴", "×10⁻³"].iter().any(|power| words.contains(power)),
            "{name}: {words}"
        );
    }
}

#[test]
fn nothing_is_no_picture() {
    let drawing = Drawing {
        view: View::Map(Plane::OpeningFriction),
        axes: Axes::default(),
        marks: Vec::new(),
        command: String::new(),
    };
    assert!(drawing.svg((&[], &[], &[]), &Print::default()).is_err());
}

/// Some curves alone are drawn as they are, without domains.
#[test]
fn a_line_alone_is_drawn() {
    let curve = Curve::named("rrr/srr").unwrap();
    let traces = [Trace::new(curve, SelfWeight::Heyman, TOLERANCE).unwrap()];
    for view in [View::Map(Plane::ThicknessFriction), View::Lines] {
        let drawing =
            Drawing { view, axes: Axes::default(), marks: Vec::new(), command: "couplet".into() };
        let text = drawing.svg((&traces, &[], &[]), &Print::default()).unwrap();
        assert!(text.contains("line-rrr-srr") && !text.contains("domain-"));
    }
}

#[cfg(feature = "plots")]
mod pixels {
    use super::*;
    use crate::picture::PaperLength;
    use crate::picture::png::render;
    use crate::picture::print::SMALLEST;
    use crate::reading::rendered::crossed;
    use crate::reading::{sizes, trouble};
    use std::collections::HashSet;

    #[test]
    fn no_name_lies_on_another() {
        for (name, svg) in pictures() {
            assert_eq!(trouble(svg), None, "{name}");
        }
    }

    /// On paper of all usual widths too, in a column with insets and legends below; each group has a name of its own.
    #[test]
    fn paper_has_the_same_names_in_letters_of_its_size() {
        let plane = |plane| (&SelfWeight::ALL[1..], View::Map(plane));
        let both = |view| (&SelfWeight::ALL[..], view);
        let views = [
            both(View::Branches(Branches::Rotation)),
            both(View::Branches(Branches::Overturning)),
            both(View::Branches(Branches::Joined)),
            both(View::Lines),
            plane(Plane::ThicknessFriction),
            plane(Plane::OpeningFriction),
            plane(Plane::OpeningThickness),
        ];
        let mut found = Vec::new();
        for (weights, view) in views {
            let printed = printed(traces(weights), weights[0], view);
            for (wide, points) in [
                ("84mm", "238.11"),
                ("90mm", "255.118"),
                ("120mm", "340.157"),
                ("174mm", "493.228"),
            ] {
                let width = Some(PaperLength::width(wide).unwrap());
                let svg = printed(&Print { width, caption: false, ..Print::default() });
                found.extend(trouble(&svg).map(|trouble| format!("{view:?} {wide}: {trouble}")));
                assert!(svg.contains(&format!("width=\"{points}pt\"")), "{wide}");
                assert!(svg.contains("Command: couplet"));
                assert!(!texts(&svg).unwrap()[2..].iter().any(|text| text.contains("Command")));
                assert!(sizes(&svg).iter().all(|size| *size >= SMALLEST), "{view:?}");
                let ids: Vec<&str> = svg.split(" id=\"").skip(1).collect();
                let ids: HashSet<&str> = ids.iter().filter_map(|id| id.split('"').next()).collect();
                assert_eq!(ids.len(), svg.matches(" id=\"").count(), "{view:?} {wide}");
            }
        }
        assert_eq!(found, [""; 0]);
    }

    /// No text of the figures lies on a line, and no landmark of a map.
    #[test]
    fn no_name_of_a_figure_lies_on_a_line() {
        let is_figure =
            |name: &str| ["2", "3", "4", "5"].iter().any(|n| name == format!("figure-{n}"));
        let landmarks = ["T", "S", "J", "S, J", "B", "ℓ", "L"];
        let mut found = Vec::new();
        for (name, svg) in pictures() {
            let is_map =
                SelfWeight::ALL.iter().any(|w| *name == format!("{}-thickness-friction", w.name()));
            let names = if is_figure(name) || is_map { crossed(svg) } else { continue };
            let is_name = |text: &&String| !is_map || landmarks.contains(&text.as_str());
            found.extend(names.iter().filter(is_name).map(|text| format!("{name}: {text}")));
        }
        // In the inset of (c) there is no room off the lines: these stand on a ground.
        assert_eq!(found, ["figure-2: ℓₕ", "figure-2: ℓₘ"]);
    }

    #[test]
    #[ignore = "writes pictures to look at"]
    fn pictures_to_look_at() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/target/figures");
        std::fs::create_dir_all(folder).unwrap();
        for (name, svg) in pictures() {
            std::fs::write(format!("{folder}/{name}.png"), render(svg, &Print::default()).unwrap())
                .unwrap();
            std::fs::write(format!("{folder}/{name}.svg"), svg).unwrap();
        }
    }
}
