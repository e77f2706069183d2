//! `couplet map` and `couplet figure` as pictures: what is in them, and what is refused.

use crate::program::{Scratch, couplet, refused, said, text};

#[test]
fn the_name_of_the_file_tells_the_format() {
    let scratch = Scratch::new();
    let file = scratch.path("map.svg");
    let (code, output, error) = said(&couplet(&["map", "--tolerance", "1e-3", "-o", &file]));
    assert_eq!((code, &error[..]), (Some(0), ""));
    assert!(output.contains("map.svg: 12 curves and 9 lines of one value, in tubes"), "{output}");
    assert!(output.contains("; proved: ") && output.lines().count() == 1, "{output}");
    let svg = scratch.read("map.svg");
    for mode in ["rrr", "srr", "rrs", "rsr", "rs", "r", "ss"] {
        assert!(svg.contains(&format!("<g id=\"domain-{mode}\">")), "{mode}");
    }
    for said in ["Milankovitch-like self-weight", "is proved to lie within", "--tolerance 1e-3"] {
        assert!(svg.contains(said), "{said}");
    }
    assert!(!svg.contains("line-rotation"), "it has no place in this plane");
}

#[test]
fn standard_output_takes_a_picture() {
    let figure = text(&couplet(&["figure", "5", "--tolerance", "1e-2"]).stdout);
    let lines = ["map", "--lines", "--weight", "both", "--tolerance", "1e-2", "--format", "svg"];
    let map = text(&couplet(&lines).stdout);
    // But for the command they are one.
    let drawn = |svg: &str| svg.split("<g id=\"caption\">").next().unwrap().to_owned();
    let body = |svg: &str| drawn(svg).lines().skip(3).collect::<Vec<_>>().join("\n");
    assert!(figure.starts_with("<svg ") && body(&figure).len() > 10_000);
    assert_eq!(body(&figure), body(&map));
}

/// The levels that are asked for, the usual ones, or none.
#[test]
fn a_map_has_the_levels_asked_for() {
    let svg = |more: &[&str]| {
        let line = ["map", "--tolerance", "1e-2", "--format", "svg"];
        text(&couplet(&[&line[..], more].concat()).stdout)
    };
    let count = |svg: &str| svg.matches("<g id=\"level-").count();
    let asked = svg(&["--half-opening", "80deg,5/2"]);
    assert_eq!(count(&asked), 2);
    for part in ["level-half-opening-80deg", ">80°</text>", ">5/2</text>", "Thin lines: equal half"]
    {
        assert!(asked.contains(part), "{part}");
    }
    assert!(asked.contains("domain-rrr"), "the map is there");
    assert_eq!(count(&svg(&["--bare"])), 0);
    let usual = svg(&["--plane", "opening-thickness"]);
    assert!(count(&usual) > 5 && usual.contains("lines of equal least friction"));
}

/// Other axes have other labels, and say in what the lines are near the true ones.
#[test]
fn a_map_has_the_axes_asked_for() {
    for (arguments, parts) in [
        (
            &[
                "--scale",
                "log",
                "--friction-unit",
                "mu",
                "--friction-range",
                "0..3",
                "--tolerance",
                "1e-2",
            ][..],
            &[">10⁻³</text>", "friction coefficient μ<", "in decades of η", "in μ"][..],
        ),
        (
            &["--plane", "opening-thickness", "--half-opening-unit", "A"],
            &["A = α cot(α/2)", "in A and"],
        ),
        (
            &["--plane", "opening-friction", "--half-opening-unit", "rad"],
            &["half opening α (rad)", ">2.5</text>"],
        ),
        (&["--thickness-range", "0..0.3"], &[">0.30</text>", "in radians"]),
    ] {
        let line = ["map", "--format", "svg", "--bare"];
        let svg = text(&couplet(&[&line[..], arguments].concat()).stdout);
        for part in parts {
            assert!(svg.contains(part), "{arguments:?}: {part}");
        }
        assert!(svg.contains("domain-srr"), "{arguments:?}");
        // S and J are shown larger where they are seen.
        assert_eq!(svg.contains("inset-sj-"), !arguments.contains(&"0..0.3"), "{arguments:?}");
    }
}

#[test]
fn an_arch_is_marked_with_its_state() {
    let line = ["map", "--tolerance", "1e-2", "--format", "svg", "--bare"];
    let marks = ["--mark", "80deg,0.6,0.15", "--mark", "100deg,30deg"];
    let svg = text(&couplet(&[&line[..], &marks].concat()).stdout);
    assert_eq!(svg.matches("<g id=\"mark-").count(), 2);
    for part in [
        "(1) α = 80°, μ = 0.6, η = 0.15: stands; least thickness 0.0686505, [r,r,r]",
        "(2) α = 100°, μ = tan(30°)",
    ] {
        assert!(svg.contains(part), "{part}");
    }
}

#[test]
fn each_figure_has_its_curves() {
    for (number, groups) in [
        ("2", &["panel-2", "heyman-rotation", "sliding-beyond"][..]),
        ("3", &["panel-0", "heyman-overturning"]),
        ("4", &["milankovitch-rotation", "milankovitch-overturning"]),
        ("6", &["domain-ss", "inset-sj-line-rsr-rs", "level-half-opening-80deg"]),
    ] {
        let svg = text(&couplet(&["figure", number, "--tolerance", "1e-2"]).stdout);
        for group in groups {
            assert!(svg.contains(&format!("<g id=\"{group}\">")), "{number} {group}");
        }
    }
}

#[cfg(feature = "plots")]
#[test]
fn pixels_are_a_png_file() {
    let scratch = Scratch::new();
    let file = scratch.path("map.png");
    let line = ["figure", "4", "--tolerance", "1e-2", "-o", &file];
    assert_eq!(said(&couplet(&line)).0, Some(0));
    assert!(std::fs::read(&file).unwrap().starts_with(b"\x89PNG"));
}

/// At a width of a column, with its letters embedded, and nothing of the words below.
#[cfg(feature = "plots")]
#[test]
fn a_page_is_a_pdf_file_of_the_width() {
    let scratch = Scratch::new();
    let file = scratch.path("figure.pdf");
    let line = ["figure", "4", "--tolerance", "1e-2", "--width", "84mm", "-o", &file];
    assert_eq!(said(&couplet(&line)).0, Some(0));
    let bytes = std::fs::read(&file).unwrap();
    assert!(bytes.starts_with(b"%PDF-1."));
    let text = String::from_utf8_lossy(&bytes);
    // 84 mm in points; a font file with a subset of the letters.
    assert!(text.contains("/MediaBox [0 0 238.11"), "{:?}", text.find("MediaBox"));
    assert!(text.contains("DejaVuSans") && text.contains("/FontFile2"));
    assert_eq!(said(&couplet(&line)).0, Some(0));
    assert!(std::fs::read(&file).unwrap() == bytes, "the same bytes each time");
}

#[cfg(not(feature = "plots"))]
#[test]
fn pixels_need_their_feature() {
    refused(&["map", "-o", "map.png"], "", "without the feature plots");
    refused(&["map", "-o", "map.pdf"], "", "without the feature plots");
}

/// The words below go, their description stays; the letters are those asked for.
#[test]
fn a_picture_is_printed_as_asked_for() {
    let line = ["figure", "3", "--tolerance", "1e-2", "--width", "12cm", "--no-caption"];
    let svg = text(&couplet(&[&line[..], &["--font", "Arial"]].concat()).stdout);
    assert!(svg.contains("width=\"340.157pt\"") && svg.contains("font-family=\"'Arial', DejaVu"));
    assert_eq!(svg.matches("Command: couplet figure 3").count(), 1, "in the description");
    let arch = ["draw", "--alpha", "80deg", "--mu", "0.35"];
    let [with, without] = [&[][..], &["--no-title", "--font-size", "8pt"]]
        .map(|more| text(&couplet(&[&arch[..], more].concat()).stdout));
    assert!(with.contains(">[r,r,r]</text>") && !without.contains(">[r,r,r]</text>"));
    assert!(without.contains("pt\" height=\""));
}

#[test]
fn what_cannot_be_printed_is_refused() {
    let figure = ["figure", "6", "--tolerance", "1e-2"];
    for (more, words) in [
        (&["--width", "84"][..], "a width is a length from 20mm to 1189mm on paper, as 84mm"),
        (&["--width", "-84mm"], "a width is a length"),
        (&["--font-size", "7"], "a font size is a length from 3pt to 30pt on paper"),
        (&["--font-size", "70pt"], "a font size is a length"),
        (&["--font", "a,b"], "a font is the name of one family"),
        (&["--width", "30mm"], "this picture is at least 72mm wide with letters of 7pt, not 30mm"),
    ] {
        refused(&[&figure[..], more].concat(), "", words);
    }
    let words = "are for svg, png and pdf, not";
    refused(&["map", "--no-caption", "--format", "csv"], "", words);
    refused(&["draw", "--at", "T", "--width", "84mm", "--format", "dxf"], "", words);
    #[cfg(feature = "plots")]
    refused(
        &[&figure[..], &["--font", "No Such", "--format", "pdf"]].concat(),
        "",
        "no font 'No Such'",
    );
}

#[test]
fn what_makes_no_picture_is_refused() {
    for (arguments, words) in [
        (&["map", "--plane", "eta-mu"][..], "a plane is one of thickness-friction"),
        (&["map", "--lines", "--plane", "opening-friction", "-o", "map.svg"], "leave out --plane"),
        (&["map", "--weight", "both", "--format", "svg"], "a map shows one --weight"),
        (&["map", "--plane", "opening-friction", "-o", "map.html"], "a page shows the whole map"),
        (&["map", "--curve", "limit", "--format", "html"], "a page shows the whole map"),
        (&["map", "--lines", "--format", "html"], "a page shows the whole map"),
        (&["figure", "6", "-o", "map.html"], "name the file .svg, .png or .pdf"),
        (
            &["map", "--thickness", "1", "-o", "map.svg"],
            "over thickness and friction lines of a half opening are drawn",
        ),
        (
            &["map", "--plane", "opening-friction", "--mu", "1", "-o", "map.svg"],
            "over opening and friction lines of a thickness are drawn",
        ),
        (&["map", "--lines", "--alpha", "80deg", "-o", "map.svg"], "--lines are drawn alone"),
        (&["map", "--bare", "--alpha", "80deg", "-o", "map.svg"], "a map that is --bare has no"),
        (&["map", "point", "limit", "--at", "1.5", "--bare"], "unexpected argument '--bare'"),
        (
            &["map", "point", "limit", "--at", "1.5", "--scale", "log"],
            "unexpected argument '--scale'",
        ),
        (&["map", "--thickness-range", "1", "-o", "map.svg"], "'1' is no range: two numbers"),
        (
            &["map", "--thickness-range", "1..0.5", "-o", "map.svg"],
            "the smaller first, as in 0..0.5",
        ),
        (&["map", "--friction-range", "-1..5", "-o", "map.svg"], "'-1..5' is no range"),
        (&["map", "--friction-range", "nan..5", "-o", "map.svg"], "'nan..5' is no range"),
        (&["map", "--half-opening-range", "1..2", "-o", "map.svg"], "has no axis of opening"),
        (
            &["map", "--plane", "opening-friction", "--scale", "log", "-o", "map.svg"],
            "the plane opening-friction has no axis of thickness",
        ),
        (
            &["map", "--scale", "log", "--thickness-range", "0..1", "-o", "map.svg"],
            "begins at 1e-9 or above",
        ),
        (&["map", "--scale", "cubic", "-o", "map.svg"], "cubic"),
        (&["map", "--friction-unit", "mu", "-o", "map.csv"], "are for a map as svg, png or pdf"),
        (
            &["map", "--scale", "log", "--lines", "-o", "map.svg"],
            "are for a map as svg, png or pdf",
        ),
        (&["map", "--mark", "80deg", "-o", "map.svg"], "a mark is a half opening, a friction"),
        (
            &["map", "--mark", "80deg,1,2,3", "-o", "map.svg"],
            "a mark is a half opening, a friction",
        ),
        (&["map", "--mark", "200deg,1", "-o", "map.svg"], "is not between 0 and pi"),
        (&["map", "--mark", "80deg,-1", "-o", "map.svg"], "the friction -1 is negative"),
        (
            &["map", "--mark", "80deg,1,3", "-o", "map.svg"],
            "the thickness 3 is not between 0 and 2",
        ),
        (&["map", "--mark", "80deg,x", "-o", "map.svg"], "'x' is not a friction"),
        (
            &["map", "--mark", "80deg,1", "-o", "map.csv"],
            "for --mark give a map as svg, png, pdf or html",
        ),
        (
            &["map", "--mark", "80deg,1", "--lines", "-o", "map.svg"],
            "for --mark give a map as svg, png, pdf or html",
        ),
        (&["figure", "0"], "a figure is a number from 1 to 12"),
        (&["figure", "13"], "a figure is a number from 1 to 12"),
        (&["figure", "6", "--weight", "both"], "figure 6 shows one --weight"),
        (&["figure", "5", "--format", "csv"], "a format is one of svg, png"),
        (&["figure", "5", "-o", "figure.csv"], "name the file .svg, .png or .pdf"),
        (&["figure", "5", "--tolerance", "0"], "a tolerance is a number from 1e-12 to 1"),
    ] {
        refused(arguments, "", words);
    }
}

/// What asymmetric solutions reach is drawn in one plane, and is data without any.
#[test]
fn what_asymmetric_solutions_reach_is_drawn() {
    let line = ["map", "--tolerance", "1e-2", "--asymmetric", "--bare"];
    let with = |more: &[&str]| couplet(&[&line[..], more].concat());
    let opening = ["--plane", "opening-friction", "--format", "svg"];
    let svg = text(&with(&opening).stdout);
    for id in
        ["asymmetric", "line-asymmetric-begins", "line-inner-sliding-shoulder-opening", "legend"]
    {
        assert!(svg.contains(&format!("<g id=\"{id}\">")), "{id}");
    }
    assert!(svg.contains("that there are no other solutions is not"), "said below");
    let heyman = text(&with(&[&opening[..], &["--weight", "heyman"]].concat()).stdout);
    assert!(heyman.contains("turn back") && !svg.contains("turn back"));
    let without = text(&couplet(&[&["map", "--tolerance", "1e-2"], &opening[..]].concat()).stdout);
    assert!(!without.contains("asymmetric") && !without.contains("legend"));
    let data = text(&couplet(&["map", "--asymmetric", "--format", "csv"]).stdout);
    assert!(data.lines().skip(1).all(|row| row.starts_with("milankovitch,")), "{data}");
    assert!(data.contains(",inner_sliding/shoulder_opening,"));
    for wrong in [
        &["--format", "svg"][..],
        &["--format", "html"],
        &["--plane", "opening-thickness", "--format", "svg"],
    ] {
        let (code, _, error) = said(&couplet(&[&["map", "--asymmetric"], wrong].concat()));
        assert_eq!(code, Some(2));
        assert!(
            error.contains("--plane opening-friction") && error.lines().count() == 1,
            "{error}"
        );
    }
}

/// A number of the tag that a text is in.
fn placed(svg: &str, words: &str, attribute: &str) -> f64 {
    let (before, _) = svg.split_once(&format!(">{words}</text>")).unwrap();
    let tag = before.rsplit_once('<').unwrap().1;
    let (_, value) = tag.split_once(&format!(" {attribute}=\"")).unwrap();
    value.split_once('"').unwrap().0.parse().unwrap()
}

fn asymmetric(more: &str) -> String {
    let line = "map --tolerance 1e-2 --asymmetric --plane opening-friction --format svg";
    let words: Vec<&str> = line.split(' ').chain(more.split(' ')).collect();
    text(&couplet(&words).stdout)
}

/// The names of modes keep off the legend, of which no other text is the title.
#[test]
fn nothing_lies_on_the_legend() {
    let first = "asymmetric solutions of (19) too";
    for unit in ["deg", "mu"] {
        let svg = asymmetric(&format!("--friction-unit {unit}"));
        let legend = [placed(&svg, first, "x") - 246.0, placed(&svg, first, "y") - 25.0];
        let name = ["x", "y"].map(|at| placed(&svg, "[s,r,r]", at));
        assert!(name[0] + 28.0 < legend[0] || name[1] < legend[1], "{unit}: {name:?} {legend:?}");
    }
}

/// A window without S and J has no larger view of them.
#[test]
fn what_is_not_shown_is_not_shown_larger() {
    let units =
        "--weight heyman --half-opening-unit rad --friction-unit mu --friction-range 0.6..2";
    let svg = |range: &str| asymmetric(&format!("{units} --half-opening-range {range}"));
    let has = |svg: String| ["inset-sj", "legend"].map(|id| svg.contains(id));
    assert_eq!([has(svg("1.9..2.6")), has(svg("1.9..2.65"))], [[false, true], [true, true]]);
}
