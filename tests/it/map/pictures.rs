//! `couplet map` and `couplet figure` as pictures: what is in them, and what is refused.

use crate::program::{Scratch, Words, printed, refused, tells};

#[test]
fn the_name_of_the_file_tells_the_format() {
    let scratch = Scratch::new();
    let file = scratch.path("map.svg");
    let output = printed(["map", "--tolerance", "1e-3", "-o", &file]);
    assert!(output.contains("map.svg: 12 curves and 9 lines of one value, in tubes"), "{output}");
    assert!(output.contains("; proved: ") && output.lines().count() == 1, "{output}");
    let svg = scratch.read("map.svg");
    let modes = ["rrr", "srr", "rrs", "rsr", "rs", "r", "ss"];
    tells(&svg, modes.map(|mode| format!("<g id=\"domain-{mode}\">")));
    tells(&svg, ["Milankovitch-like self-weight", "is proved to lie within", "--tolerance 1e-3"]);
    assert!(!svg.contains("line-rotation"), "it has no place in this plane");
}

#[test]
fn standard_output_takes_a_picture() {
    let figure = printed("figure 5 --tolerance 1e-2");
    let map = printed("map --lines --weight both --tolerance 1e-2 --format svg");
    // But for the command they are one.
    let drawn = |svg: &str| svg.split("<g id=\"caption\">").next().unwrap().to_owned();
    let body = |svg: &str| drawn(svg).lines().skip(3).collect::<Vec<_>>().join("\n");
    assert!(figure.starts_with("<svg ") && body(&figure).len() > 10_000);
    assert_eq!(body(&figure), body(&map));
}

/// The levels that are asked for, the usual ones, or none.
#[test]
fn a_map_has_the_levels_asked_for() {
    let svg = |more: &str| printed(format!("map --tolerance 1e-2 --format svg {more}"));
    let count = |svg: &str| svg.matches("<g id=\"level-").count();
    let asked = svg("--half-opening 80deg,5/2");
    assert_eq!(count(&asked), 2);
    tells(
        &asked,
        ["level-half-opening-80deg", ">80°</text>", ">5/2</text>", "Thin lines: equal half"],
    );
    assert!(asked.contains("domain-rrr"), "the map is there");
    assert_eq!(count(&svg("--bare")), 0);
    let usual = svg("--plane opening-thickness");
    assert!(count(&usual) > 5 && usual.contains("lines of equal least friction"));
}

/// Other axes have other labels, and say in what the lines are near the true ones.
#[test]
fn a_map_has_the_axes_asked_for() {
    for (arguments, parts) in [
        (
            "--scale log --friction-unit mu --friction-range 0..3 --tolerance 1e-2",
            &[">10⁻³</text>", "friction coefficient μ<", "in decades of η", "in μ"][..],
        ),
        ("--plane opening-thickness --half-opening-unit A", &["A = α cot(α/2)", "in A and"]),
        (
            "--plane opening-friction --half-opening-unit rad",
            &["half opening α (rad)", ">2.5</text>"],
        ),
        ("--thickness-range 0..0.3", &[">0.30</text>", "in radians"]),
    ] {
        let svg = printed(format!("map --format svg --bare {arguments}"));
        tells(&svg, parts);
        tells(&svg, ["domain-srr"]);
        // S and J are shown larger where they are seen.
        assert_eq!(svg.contains("inset-sj-"), !arguments.contains("0..0.3"), "{arguments}");
    }
}

#[test]
fn an_arch_is_marked_with_its_state() {
    let marks = "--mark 80deg,0.6,0.15 --mark 100deg,30deg";
    let svg = printed(format!("map --tolerance 1e-2 --format svg --bare {marks}"));
    assert_eq!(svg.matches("<g id=\"mark-").count(), 2);
    tells(
        &svg,
        [
            "(1) α = 80°, μ = 0.6, η = 0.15: stands; least thickness 0.0686505, [r,r,r]",
            "(2) α = 100°, μ = tan(30°)",
        ],
    );
}

#[test]
fn each_figure_has_its_curves() {
    for (number, groups) in [
        ("2", &["panel-2", "heyman-rotation", "sliding-beyond"][..]),
        ("3", &["panel-0", "heyman-overturning"]),
        ("4", &["milankovitch-rotation", "milankovitch-overturning"]),
        ("6", &["domain-ss", "inset-sj-line-rsr-rs", "level-half-opening-80deg"]),
    ] {
        let svg = printed(["figure", number, "--tolerance", "1e-2"]);
        tells(&svg, groups.iter().map(|group| format!("<g id=\"{group}\">")));
    }
}

#[cfg(feature = "plots")]
#[test]
fn pixels_are_a_png_file() {
    let scratch = Scratch::new();
    let file = scratch.path("map.png");
    printed(["figure", "4", "--tolerance", "1e-2", "-o", &file]);
    assert!(std::fs::read(&file).unwrap().starts_with(b"\x89PNG"));
}

/// At a width of a column, with its letters embedded, and nothing of the words below.
#[cfg(feature = "plots")]
#[test]
fn a_page_is_a_pdf_file_of_the_width() {
    let scratch = Scratch::new();
    let file = scratch.path("figure.pdf");
    let line = format!("figure 4 --tolerance 1e-2 --width 84mm -o {file}");
    printed(&line);
    let bytes = std::fs::read(&file).unwrap();
    assert!(bytes.starts_with(b"%PDF-1."));
    let text = String::from_utf8_lossy(&bytes);
    // 84 mm in points; a font file with a subset of the letters.
    assert!(text.contains("/MediaBox [0 0 238.11"), "{:?}", text.find("MediaBox"));
    assert!(text.contains("DejaVuSans") && text.contains("/FontFile2"));
    printed(&line);
    assert!(std::fs::read(&file).unwrap() == bytes, "the same bytes each time");
}

#[cfg(not(feature = "plots"))]
#[test]
fn pixels_need_their_feature() {
    refused("map -o map.png", "", "without the feature plots");
    refused("map -o map.pdf", "", "without the feature plots");
}

/// The words below go, their description stays; the letters are those asked for.
#[test]
fn a_picture_is_printed_as_asked_for() {
    let figure = "figure 3 --tolerance 1e-2 --width 12cm --no-caption --font Arial";
    let svg = printed(figure);
    assert!(svg.contains("width=\"340.157pt\"") && svg.contains("font-family=\"'Arial', DejaVu"));
    assert_eq!(svg.matches("Command: couplet figure 3").count(), 1, "in the description");
    let [with, without] = ["", "--no-title --font-size 8pt"]
        .map(|more| printed(format!("draw --alpha 80deg --mu 0.35 {more}")));
    assert!(with.contains(">[r,r,r]</text>") && !without.contains(">[r,r,r]</text>"));
    assert!(without.contains("pt\" height=\""));
}

#[cfg(feature = "plots")]
#[test]
fn a_font_that_is_not_there_is_named() {
    let figure = "figure 6 --tolerance 1e-2 --format pdf --font".words();
    refused([&figure[..], &["No Such"]].concat(), "", "no font 'No Such'");
}

/// What asymmetric solutions reach is drawn in one plane, and is data without any.
#[test]
fn what_asymmetric_solutions_reach_is_drawn() {
    let svg = asymmetric("--bare");
    let ids =
        ["asymmetric", "line-asymmetric-begins", "line-inner-sliding-shoulder-opening", "legend"];
    tells(&svg, ids.map(|id| format!("<g id=\"{id}\">")));
    assert!(svg.contains("that there are no other solutions is not"), "said below");
    let heyman = asymmetric("--bare --weight heyman");
    assert!(heyman.contains("turn back") && !svg.contains("turn back"));
    let without = printed("map --tolerance 1e-2 --plane opening-friction --format svg");
    assert!(!without.contains("asymmetric") && !without.contains("legend"));
    let data = printed("map --asymmetric --format csv");
    assert!(data.lines().skip(1).all(|row| row.starts_with("milankovitch,")), "{data}");
    assert!(data.contains(",inner_sliding/shoulder_opening,"));
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
    printed(format!("{line} {more}"))
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
