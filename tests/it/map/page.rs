//! `couplet map --format html`: one file, and a script whose numbers are those of the program.

use crate::program::{Scratch, object, printed, tells};
use crate::tool;
use serde_json::Value;
use std::process::Command;
use std::sync::OnceLock;

/// The page, made once.
fn page() -> &'static str {
    static PAGE: OnceLock<String> = OnceLock::new();
    PAGE.get_or_init(|| {
        let scratch = Scratch::new();
        printed(["map", "--tolerance", "1e-3", "-o", &scratch.path("map.html")]);
        scratch.read("map.html")
    })
}

/// What becomes of a page in a browser.
fn shown(page: &str, fragment: &str) -> String {
    let scratch = Scratch::new();
    scratch.write("page.html", page);
    let address = format!("file://{}#{fragment}", scratch.path("page.html"));
    let profile = format!("--user-data-dir={}", scratch.path("profile"));
    let quiet = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--dump-dom"];
    let mut browser = Command::new("chromium");
    let output = browser.args(quiet).args([&profile, &address]).output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

/// What stands in an element.
fn element<'a>(page: &'a str, id: &str) -> &'a str {
    let (_, rest) = page.split_once(&format!("id=\"{id}\"")).unwrap();
    let text = rest.split_once('>').unwrap().1;
    text.split_once("</dd>").unwrap().0
}

/// The answer of a command that the page shows, to as many digits as the number beside it has.
fn certified(command: &str, number: &str) -> Value {
    let is_digit = |c: &char| c.is_ascii_digit();
    let digits = number.chars().filter(is_digit).skip_while(|c| *c == '0').count();
    assert!((5..=6).contains(&digits), "{number}");
    object(format!("{} --digits {digits}", command.strip_prefix("couplet ").unwrap()))
}

#[test]
fn a_page_needs_nothing_from_elsewhere() {
    let page = page();
    assert!(page.len() < 1_000_000);
    let addresses: Vec<&str> =
        page.match_indices("http").map(|(at, _)| &page[at..at + 26]).collect();
    // Names of what SVG is, which nothing is loaded from.
    let is_name = |of: &str| of.starts_with("http-equiv=") || of == "http://www.w3.org/2000/svg";
    assert!(addresses.iter().copied().all(is_name), "{addresses:?}");
    for loaded in ["src=", "href=", "@import", "fetch(", "{{"] {
        assert!(!page.contains(loaded), "{loaded}");
    }
    assert!(page.contains("default-src 'none'; style-src 'sha256-"));
    tells(
        page,
        ["not certified", "0.618318241074323", "1.41527082775689", "couplet map --tolerance"],
    );
    // No two elements have one name.
    let mut names: Vec<&str> =
        page.split(" id=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
    let all = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), all);
}

/// Levels that are asked for are drawn in the planes where they are lines, and marks have the state of either weight.
#[test]
fn a_page_has_the_levels_and_marks_asked_for() {
    let scratch = Scratch::new();
    let file = scratch.path("map.html");
    let levels = "--half-opening 80deg --thickness 0.1 --friction 0.4";
    printed(format!("map --tolerance 1e-2 --mark 80deg,0.6,0.15 {levels} -o {file}"));
    let page = scratch.read("map.html");
    assert!(page.len() < 1_000_000);
    for weight in ["heyman", "milankovitch"] {
        let levels = [
            "thickness-friction-level-half-opening-80deg",
            "opening-friction-level-thickness-0.1",
            "opening-thickness-level-friction-0.4",
        ];
        tells(&page, levels.map(|of| format!("id=\"{weight}-{of}\"")));
    }
    assert_eq!(page.matches("<figure ").count(), 6);
    let marked = |figure: &&str| !figure.contains("&quot;marks&quot;:[]");
    assert_eq!(page.split("<figure ").skip(1).filter(marked).count(), 6);
    tells(&page, ["stands; least thickness 0.0686505", "stands; least thickness 0.06"]);
}

#[test]
fn one_weight_alone_has_a_page() {
    let scratch = Scratch::new();
    let file = scratch.path("map.html");
    printed(format!("map --weight heyman --tolerance 1e-2 -o {file}"));
    let page = scratch.read("map.html");
    let figures: Vec<&str> = page.split("<figure ").skip(1).collect();
    assert_eq!(figures.len(), 3);
    assert!(figures.iter().all(|figure| figure.starts_with("data-weight=\"heyman\"")));
}

/// The page as it is, with an arch in its address.
#[test]
fn an_address_has_its_arch() {
    if !tool::has("chromium", "--version") {
        return;
    }
    let there = shown(page(), "half_opening=80deg&friction=0.6&weight=heyman");
    let thickness = element(&there, "thickness");
    let line = "couplet state --half-opening 80deg --friction 0.6 --weight heyman";
    let truth = certified(line, thickness);
    assert_eq!(thickness, truth["thickness"]["value"]);
    assert_eq!(element(&there, "mode"), "[r,r,r]");
    let falls = shown(page(), "alpha=2.7&mu=0.5");
    assert!(falls.contains("falls: no thickness is enough"));
}

/// Points at both maps, and asks for arches by their half openings: each number is that of the command beside it.
const HARNESS: &str = r#"<script>
const noted = [];
function note() {
  noted.push(["command", "mode", "half_opening", "thickness"].map((id) => at(id).textContent));
}
for (const [weight, points] of [["heyman", 6], ["milankovitch", 6]]) {
  choose(weight);
  const { frames, svg } = largePlane(), { left, top, width, height } = frames.at(-1), box = svg.getBoundingClientRect();
  for (let k = 0; k < points; k++) {
    const [across, up] = [(0.05 + 0.618034 * (k + 1)) % 1, (0.05 + 0.31 * k) % 1];
    const [clientX, clientY] = [box.x + left + across * width, box.y + top + up * height];
    svg.dispatchEvent(new PointerEvent("pointermove", { clientX, clientY, pointerType: "mouse" }));
    note();
  }
  for (const [half_opening, friction] of [["80deg", "0.35"], ["2.5", "1.5"], ["pi/2", "inf"], ["2.58", "1.9"], ["1", "0.12"]]) {
    show({ weight, half_opening, friction });
    note();
  }
}
document.body.textContent = noted.map((texts) => `\n${texts.join("\t")}\n`).join("");
</script>"#;

#[test]
fn what_lies_under_the_cursor_is_what_the_command_finds() {
    if !tool::has("chromium", "--version") {
        return;
    }
    // The policy of the page lets no other script run.
    let (before, rest) = page().split_once("<meta http-equiv").unwrap();
    let (_, after) = rest.split_once('\n').unwrap();
    let noted = shown(&format!("{before}{after}{HARNESS}"), "");
    let lines: Vec<&str> = noted.lines().filter(|line| line.contains('\t')).collect();
    assert_eq!(lines.len(), 22, "{noted}");
    let mut modes = Vec::new();
    for line in lines {
        let cells: Vec<&str> = line.split('\t').collect();
        let [command, mode, alpha, eta] = cells[..] else { panic!("{line}") };
        let is_state = command.starts_with("couplet state");
        let number = if is_state { eta } else { alpha.split_once(" rad").unwrap().0 };
        let truth = certified(command, number);
        let (value, known) = match is_state {
            true => (&truth["thickness"]["value"], &truth["mode"]),
            false => (&truth["half_opening"]["value"], &truth["modes"][0]),
        };
        assert_eq!((value, known), (&Value::from(number), &Value::from(mode)), "{command}");
        modes.push(mode.to_owned());
    }
    modes.sort();
    modes.dedup();
    assert!(modes.len() > 4, "{modes:?}");
}
