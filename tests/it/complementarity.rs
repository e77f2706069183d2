//! `couplet complementarity`, and what `state` and `assess` say of it.

use crate::program::{Json, ended, object, printed, says, tells};
use serde_json::{Value, json};

type Solution = (bool, String, String);

fn solutions(arch: &str) -> Vec<Solution> {
    let found = object(format!("complementarity --digits 8 {arch}"));
    let solution = |of: &Value| {
        let is_symmetric = of["symmetric"].as_bool().unwrap();
        solution(is_symmetric, of["mode"].text(), of["thickness"]["value"].text())
    };
    found["solutions"].list().iter().map(solution).collect()
}

fn solution(symmetric: bool, mode: &str, thickness: &str) -> Solution {
    (symmetric, mode.to_owned(), thickness.to_owned())
}

#[test]
fn solutions_come_by_their_thickness() {
    let line = "--weight heyman --half-opening 2.3 --friction 1.09";
    let expected = [
        solution(true, "[r,r,r]", "0.47926966"),
        solution(false, "shoulder_opening", "0.63927187"),
        solution(false, "inner_sliding", "0.65299139"),
    ];
    assert_eq!(solutions(line), expected);
    assert_eq!(object(format!("complementarity {line}"))["complete"], true);
    let more = printed("complementarity --weight heyman --alpha 2.31 --mu 1.108");
    tells(&more, ["that there is no other solution is not."]);
}

#[test]
fn an_arch_without_friction_to_slide_has_the_symmetric_one() {
    let line = "--half-opening pi/2 --friction inf";
    assert_eq!(solutions(line), [solution(true, "[r,r,r]", "0.10747804")]);
    assert!(solutions("--half-opening pi/2 --friction 0.3").is_empty());
    let words = printed("complementarity --alpha pi/2 --mu 0.6");
    assert!(words.contains("there is no asymmetric solution"), "{words}");
}

/// The programme (20): a positive least value, or nothing admissible.
#[test]
fn the_programme_is_enclosed() {
    let arch = "complementarity --half-opening 2.3 --friction 1.05 --stones 8 --thickness";
    let at = |eta: &str| printed(format!("{arch} {eta}"));
    tells(&at("0.52"), ["least value 0.0000761478", "positive, proved"]);
    assert!(at("0.45").contains("nothing is admissible at these joints, proved"));
}

/// At the least thickness of the stones it is zero exactly, for the whole arch and for its half.
#[test]
fn the_programme_is_zero_at_the_least_thickness() {
    let arch = "complementarity --alpha 2.3 --mu 1.05 --stones 8 --digits 6";
    for half in ["", "--half"] {
        let words = printed(format!("{arch} --eta least {half}"));
        tells(&words, ["at thickness 0.511561, the least", "least value 0, exactly"]);
        tells(&printed(format!("{arch} --eta 0.511562 {half}")), ["positive, proved"]);
    }
    let half = printed(format!("{arch} --eta 0.52 --half"));
    tells(&half, ["5 joints of the half arch", "least value 0.0"]);
}

/// All solutions between stones, in every format.
#[test]
fn all_solutions_between_stones_are_told() {
    let arch = "complementarity --alpha 2.3 --mu 1.05 --stones 8 --digits 8";
    let words = printed(arch);
    tells(
        &words,
        [
            "All solutions of (19) between 8 equal stones, 9 joints of the whole arch",
            "   0.51156098  symmetric: the least thickness",
            "   0.68442173  asymmetric; its mirror image is a solution too",
            "no other thickness up to 2 has a solution but mirror images, proved",
            "7140 triples",
        ],
    );
    let half = printed(format!("{arch} --half"));
    assert!(half.contains("no other thickness up to 2 has a symmetric solution, proved"), "{half}");
    assert!(!half.contains("0.68442173"));
    let found = object(arch);
    let all = &found["enumeration"];
    says(all, json!({"outcome": "complete", "looked_at": 7140}));
    says(&all["solutions"][1], json!({"thickness": {"value": "0.68442173"}}));
    assert_eq!(all["solutions"][1]["joints"][2]["side"], "crown");
    let rows = printed(format!("{arch} --format csv"));
    let is_told = |row: &str| row.ends_with(",8,solution,,,") && row.contains("0.68442173");
    assert!(rows.lines().any(is_told), "{rows}");
    let nothing = printed("complementarity --alpha pi/2 --mu 0.1 --stones 6");
    assert!(nothing.contains("none, proved: at no thickness up to 2"), "{nothing}");
}

/// Nothing is told of the arch with a joint at every angle where it is asked between stones: not as a solution, and not
/// as the one beside which there is no other. `--thickness` of that value proves that it is none.
#[test]
fn between_stones_no_other_arch_is_told() {
    for (mu, stones) in [("inf", "2"), ("0.8", "2"), ("0.8", "3")] {
        let arch = format!("complementarity --alpha 60deg --mu {mu} --stones {stones}");
        let with = |more: &str| printed(format!("{arch} {more}"));
        let words = with("");
        assert!(words.contains("no thickness up to 2 has a solution, proved"), "{words}");
        assert!(!words.contains("least thickness") && !words.contains("no other"), "{words}");
        let enumeration = json!({"outcome": "complete", "solutions": []});
        let expected = json!({"solutions": null, "search": null, "enumeration": enumeration});
        says(&object(&arch), expected);
        let rows = with("--format csv");
        assert_eq!(rows.lines().count(), 2, "{rows}");
        assert!(rows.trim_end().ends_with(&format!(",jointed,,,,,{stones},complete,,,")), "{rows}");
        let every = solutions(&format!("--alpha 60deg --mu {mu}"));
        let words = with(&format!("--thickness {}", every[0].2));
        assert!(words.contains("positive, proved"), "{words}");
        assert!(!words.contains("symmetric, ["), "{words}");
    }
    // Where there is one, no other is told of beside it.
    let arch = "complementarity --alpha pi/2 --mu 0.5 --stones 5";
    let told = ["symmetric: the least thickness", "no other thickness up to 2 has a solution"];
    tells(&printed(arch), told);
    let half = printed(format!("{arch} --half"));
    assert!(half.starts_with("Complementarity problem (19) of the half arch"), "{half}");
}

/// With unlimited friction there may be no rates at all, and so no value of the programme.
#[test]
fn where_no_rates_fit_there_is_no_solution() {
    let arch = "complementarity --alpha 60deg --mu inf --stones 2 --thickness 1.2";
    let at = |format| printed(format!("{arch} --format {format}"));
    assert!(at("table").contains("no rates fit: (19) has no solution"));
    let programme = json!({"outcome": "no_rates", "least_value_lower": null});
    says(&object(arch), json!({"verdict": "proved", "programme": programme}));
    assert!(at("csv").trim_end().ends_with(",2,no_rates,,,"), "{}", at("csv"));
}

/// An arch so flat that doubles tell nothing of it is undecided soon, in one line.
#[test]
fn a_tiny_arch_between_stones_is_undecided_in_a_line() {
    for (alpha, stones) in [("1e-7", "6"), ("1e-9", "8")] {
        let line = format!("complementarity --alpha {alpha} --mu 0.6 --stones {stones}");
        let (_, error) = ended(1, line, "");
        assert_eq!(error.lines().count(), 1, "{error}");
        tells(&error, ["undecided: whether there is a solution at a thickness"]);
    }
}

/// A person is told of them; rows and files are as they were.
#[test]
fn state_and_assess_tell_a_person() {
    let arch = "--half-opening 2.3 --friction 1.05 --digits 6";
    let told = "asymmetric mechanism, proved, at the thickness 0.583084: ";
    assert!(printed(format!("state {arch}")).contains(told));
    assert!(object(format!("state {arch}"))["asymmetric_thickness"].is_object());
    let assess = |eta| printed(format!("assess --thickness {eta} {arch}"));
    assert!(assess("0.55").contains(told));
    assert!(!assess("0.5").contains("asymmetric"), "it falls anyway");
    let semicircle = "state --half-opening pi/2 --friction 0.35";
    assert!(!printed(semicircle).contains("asymmetric"));
}

/// The branch meets what `state` says, at its ends and between them; CSV and JSON have the same nodes.
#[test]
fn a_branch_begins_and_ends_on_the_least_thickness() {
    let line = "complementarity --half-opening 2.3 --branch --digits 20";
    let found = object(line);
    assert_eq!(found["verdict"], "proved");
    let points = found["points"].list();
    let value = |point: &Value, name: &str| point[name]["value"].text().to_owned();
    let thicknesses = ["thickness", "least_thickness"];
    let [first, change, last] = points else { panic!("{points:?}") };
    for end in [first, last] {
        let [own, least] = thicknesses.map(|name| value(end, name));
        assert_eq!((own, end["symmetric"].as_bool()), (least, Some(true)));
    }
    assert_eq!(value(change, "thickness"), "0.60334349864365555821");
    let mu = value(change, "friction");
    let state = printed(format!("state --alpha 2.3 --mu {mu} --digits 15 --plain"));
    let least = value(change, "least_thickness")[..14].to_owned();
    assert!(state.lines().any(|line| line.starts_with(&least)), "{least}: {state}");
    // Of one friction the solution is between the two.
    let both = solutions("--half-opening 2.3 --friction 1.06");
    let [(true, ..), (false, _, other)] = &both[..] else { panic!("{both:?}") };
    assert!(value(first, "thickness") < *other && *other < value(change, "thickness"));
    let parts = found["parts"].list();
    let nodes = parts.iter().chain(found["least"].list());
    let nodes: usize = nodes.map(|part| part["nodes"].list().len()).sum();
    let table = printed(format!("{line} --format csv"));
    assert_eq!(table.lines().count(), nodes + 1);
    assert!(parts.iter().all(|part| part["admissible"] == true), "{parts:?}");
}

#[test]
fn where_there_is_no_branch_it_is_said() {
    let words = printed("complementarity --half-opening 2 --branch");
    let told = "no branch leaves the least thickness: at the friction";
    tells(&words, [told, "and there is no asymmetric solution at all"]);
    let drawn = "complementarity --half-opening 2 --branch --format svg";
    tells(&ended(1, drawn, "").1, ["nothing to draw"]);
}

/// Its parts, its ends and what is not proved are in the picture.
#[test]
fn a_branch_is_drawn_beside_the_least_thickness() {
    let drawn = printed("complementarity --half-opening 2.21 --branch --format svg");
    let ids = ["least", "inner_sliding", "shoulder_sliding", "legend"];
    tells(&drawn, ids.map(|id| format!("id=\"{id}\"")));
    assert!(!drawn.contains("id=\"shoulder_opening\""), "there is none");
    assert!(drawn.contains("Milankovitch's weight there are no others"));
}

/// That there is no least thickness is an answer: every thickness stands, or none does. A row of CSV says it, and
/// what the programme (20) is.
#[test]
fn no_least_thickness_is_an_answer() {
    for (mu, stones, outcome, words) in [
        ("2", "3", "every_thickness_stands", "every thickness up to 2 stands"),
        ("0.01", "5", "no_thickness_stands", "no thickness up to 2 stands"),
    ] {
        let line =
            format!("complementarity --alpha 1 --mu {mu} --stones {stones} --thickness least");
        says(&object(&line), json!({"verdict": "proved", "programme": {"outcome": outcome}}));
        assert!(printed(&line).contains(&format!("there is none, proved: {words}")));
        let rows = printed(format!("{line} --format csv"));
        let last = rows.lines().last().unwrap();
        assert_eq!(last, format!("milankovitch,1,{mu},,programme,least,,,,{stones},{outcome},,,"));
    }
    let line = |thickness| {
        let arch = "complementarity --alpha 2.3 --mu 1.05 --stones 8 --digits 6 --format csv";
        let rows = printed(format!("{arch} --thickness {thickness}"));
        rows.lines().last().unwrap().split(',').skip(4).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(line("least"), ["programme", "0.511561", "", "", "", "8", "zero", "", "0", "0"]);
    let positive = line("0.6");
    assert_eq!(positive[6], "positive");
    let [value, lower] = [8, 9].map(|k| positive[k].parse::<f64>().unwrap());
    assert!(lower > 0.0 && lower <= value && value - lower < 1e-9);
}

/// What stays open is said with its place, on the error stream and as a row.
#[test]
fn open_pieces_are_listed() {
    let line = "complementarity --alpha 0.001 --mu 0.3 --stones 4 --half --format csv";
    let (rows, error) = ended(1, line, "");
    let pieces = rows.lines().filter(|row| row.contains(",open,"));
    let pieces: Vec<Vec<&str>> = pieces.map(|row| row.split(',').collect()).collect();
    assert_eq!(pieces.len(), 1, "{rows}");
    let words = format!("at a thickness from {} to {}\n", pieces[0][5], pieces[0][11]);
    assert!(error.ends_with(&words), "{words}");
}

/// Where only a lower bound of the least value is proved, every format tells it.
#[test]
fn a_lower_bound_of_the_least_value_is_told_in_every_format() {
    let told = |arch: &str, format| printed(format!("complementarity {arch} --format {format}"));
    let programme = |arch: &str| object(format!("complementarity {arch}"))["programme"].clone();
    let flat = |thickness| {
        format!("--weight heyman --alpha 1.066 --mu 0.303 --stones 5 --digits 9 --eta {thickness}")
    };
    let line = |thickness, format| told(&flat(thickness), format);
    let of = |thickness| programme(&flat(thickness));
    let enclosed = programme("--alpha 2.3 --mu 1.05 --stones 8 --eta 0.6 --digits 6");
    assert_eq!(enclosed["least_value_lower"], enclosed["least_value"]["lower"], "{enclosed}");
    assert!(enclosed["least_value_lower"].is_string());
    let bounded = of("1.096");
    assert!(bounded["least_value"].is_null() && bounded["outcome"] == "positive", "{bounded}");
    let lower = bounded["least_value_lower"].text();
    assert!(lower.parse::<f64>().unwrap() > 0.1249);
    assert!(line("1.096", "table").contains(&format!("least value at least {lower}\n")));
    assert!(line("1.096", "csv").trim_end().ends_with(&format!(",positive,,,{lower}")));
    assert_eq!(of("least")["least_value_lower"], "0");
    says(&of("0.01"), json!({"outcome": "nothing_admissible", "least_value_lower": null}));
}
