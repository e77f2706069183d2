//! Each clause of a statement is a claim: a copy that denies it is refused, and nothing but clauses is said.

use super::asymmetric::{self, another_digit, inner};
use super::conditions::unmet;
use super::originals::{file_alike, landmark_problem, state_problem};
use super::refusals::{Cases, MAX_DIGITS, Original, Spoiled, arch, point};
use super::survey::all;
use super::verdicts::{slides, stands, stands_at_the_crown, too_thin, too_wide};
use couplet::arch::SelfWeight::{Heyman, Milankovitch};
use couplet::arch::asymmetric::AsymmetricMode::InnerSliding;
use couplet::problem::{Landmark, Mode, Problem};

/// A clause, a copy that denies it, and what the reason says for which the copy is refused.
type Clause = (String, Spoiled, String);

/// Words of reasons.
const NO_ROOT: &str = "the Krawczyk operator does not map the box into itself";
const NOT_SHOWN: &str = "root: it does not show ";
const ANOTHER: &str = "is not that of the arch that decides there";

const STANDS: &str = "the arch stands (an admissible symmetric state exists)";

/// The statement on a certificate that is accepted.
fn statement(original: Original) -> String {
    file_alike(original.0.to_string().as_bytes(), MAX_DIGITS).unwrap().statement()
}

/// Clauses with another text at a place: words, place, text and reason of each.
fn changed(original: Original, all: &[[&str; 4]]) -> Vec<Clause> {
    let of = |[words, place, text, reason]: &[&str; 4]| {
        ((*words).to_owned(), original.with(place, *text), (*reason).to_owned())
    };
    all.iter().map(of).collect()
}

/// The same in the subject of a claim, and its values with their digits.
fn claimed(original: Original, subject: &str, all: &[[&str; 4]]) -> Vec<Clause> {
    let places = all.iter().map(|[_, field, ..]| match *field {
        "weight" | "landmark" => format!("/claim/{field}"),
        _ => format!("/claim/{subject}/{field}"),
    });
    let places: Vec<String> = places.collect();
    let all = all.iter().zip(&places);
    let all: Vec<[&str; 4]> = all.map(|(&[a, _, c, d], place)| [a, place, c, d]).collect();
    let mut clauses = changed(original, &all);
    let values = original.0["values"].as_array().unwrap();
    for (value, (copy, reason)) in values.iter().zip(another_digit(original)) {
        let [name, value] = ["quantity", "value"].map(|key| value[key].as_str().unwrap());
        clauses.push((format!("{name} = {value}"), copy, reason.to_string()));
    }
    if !values.is_empty() {
        let digits = original.0["digits"].as_u64().unwrap();
        let rounded = format!("each correctly rounded to {digits} significant digits");
        clauses.push((rounded, original.with("/digits", digits + 1), "values: ".to_owned()));
    }
    clauses
}

/// A true root of the equations of which something else is not true.
fn root(words: &str, mut of: Cases) -> Clause {
    let (copy, reason) = of.remove(0);
    (words.to_owned(), copy, reason.to_string())
}

fn of_a_landmark() -> Vec<Clause> {
    let not = |words, start: &[f64], condition| {
        root(words, unmet(landmark_problem(Landmark::Triple, Heyman), start, condition))
    };
    let mut clauses = claimed(
        point(),
        "",
        &[
            ["landmark T", "landmark", "S", "claim: the unknowns are not"],
            ["heyman weight", "weight", "milankovitch", NO_ROOT],
        ],
    );
    let only = "the only one in the large box";
    clauses.extend(changed(
        point(),
        &[
            ["its equations have a solution", "/unique/centre/0", "0x1p0", NO_ROOT],
            [only, "/unique/radius/0", "0x1p0", "a denominator of the equations may vanish"],
        ],
    ));
    let beyond = landmark_problem(Landmark::Shift, Heyman);
    let beyond =
        unmet(beyond, &[9.2804, 0.0718, 0.9965, 0.0052, 6.9075], "a half opening below pi");
    clauses.push(root("none of its half opening with less friction", beyond));
    clauses.push(not(
        "that is a state of [r,r,r], [s,r,r], [r,r,s], [s,s], admissible at every joint",
        &[2.7447, 6.6674, 0.1893, 1.8854, 0.0372, 2.4796],
        "a rotational joint above the shoulder",
    ));
    clauses.push(not(
        "no thinner arch of its half opening and friction stands",
        &[2.4872, -1.0375, 0.2971, 0.6796, 0.0978, 1.4153],
        "a rotational joint below the crown",
    ));
    clauses
}

fn of_a_state() -> Vec<Clause> {
    let problem =
        |alpha, mu| -> Problem { state_problem(Milankovitch, Mode::Rotational, alpha, mu) };
    let of_mode = "at the least one it has a state of [r,r,s]";
    let order = format!("{NOT_SHOWN}a rotational joint nearer to the crown");
    let mut clauses = claimed(
        arch(),
        "state",
        &[
            ["half opening 49/20", "half_opening", "24/10", NO_ROOT],
            ["friction 27/20", "friction", "26/20", NO_ROOT],
            ["milankovitch weight", "weight", "heyman", NO_ROOT],
            [of_mode, "mode", "[r,s,r]", &order],
        ],
    );
    let slides = unmet(problem("2.45", "1.35"), &[1.03, 0.648, 0.105], "friction enough inside");
    clauses.push(root(STANDS, slides));
    let start = [5.1537, 2.9703, 0.6269];
    let thick = unmet(problem("2.3", "1.1"), &start, "a thickness below the physical limit");
    clauses.push(root("exactly from a least thickness on, up to 2", thick));
    let only = "the only solution of its equations in the large box";
    clauses.extend(changed(arch(), &[[only, "/unique/radius/0", "0x1p0", NO_ROOT]]));
    clauses
}

fn of_too_little_friction() -> Vec<Clause> {
    let reason = &format!("{NOT_SHOWN}a friction below that of the purely sliding state");
    claimed(
        slides(),
        "slides",
        &[
            ["half opening 3/2", "half_opening", "1/1", NO_ROOT],
            ["friction 1/10", "friction", "28/100", reason],
            ["the arch stands at no thickness", "friction", "1/2", reason],
            ["as its friction is below that of pure sliding", "friction", "tan 1/4 pi", reason],
        ],
    )
}

fn of_too_wide_an_arch() -> Vec<Clause> {
    let reason = &format!("{NOT_SHOWN}a half opening beyond the limit for the friction");
    let beyond = "as its half opening is beyond a bound for its friction";
    claimed(
        too_wide(),
        "too_wide",
        &[
            ["half opening 14/5", "half_opening", "5/2", reason],
            ["friction 4/1", "friction", "3/1", NO_ROOT],
            ["milankovitch weight", "weight", "heyman", NO_ROOT],
            ["the arch stands at no thickness up to 2", "half_opening", "13/5", reason],
            [beyond, "half_opening", "1/2 pi", reason],
        ],
    )
}

fn of_too_thin_an_arch() -> Vec<Clause> {
    let reason = &format!("{NOT_SHOWN}a thickness below the least");
    let of_mode = "as its least thickness, of [s,r,r]";
    claimed(
        too_thin(),
        "too_thin",
        &[
            ["half opening 1/2 pi", "half_opening", "1/3 pi", NO_ROOT],
            ["friction 19/50", "friction", "18/50", NO_ROOT],
            ["thickness 3/25", "thickness", "1/8", reason],
            ["milankovitch weight", "weight", "heyman", NO_ROOT],
            ["the arch does not stand", "thickness", "2/1", reason],
            [of_mode, "mode", "[r,r,r]", "claim: the equations are not"],
            ["is larger", "thickness", "13/100", reason],
        ],
    )
}

fn of_an_arch_that_stands() -> Vec<Clause> {
    let friction = format!("{NOT_SHOWN}friction enough at the shoulder");
    let inside = format!("{NOT_SHOWN}the line of thrust inside the intrados");
    claimed(
        stands(),
        "stands",
        &[
            ["half opening 49/20", "half_opening", "29/10", NOT_SHOWN],
            ["friction 27/20", "friction", "1/2", &friction],
            ["thickness 4/5", "thickness", "3/5", NO_ROOT],
            ["milankovitch weight", "weight", "heyman", NO_ROOT],
            [STANDS, "crown_moment", "0x0p0", &inside],
        ],
    )
}

fn of_an_asymmetric_solution() -> Vec<Clause> {
    let solved = "the complementarity problem (19) of the whole arch has an asymmetric solution";
    let outside = "the line of thrust inside the extrados on the whole arch";
    let start = [0.222, 0.2743, 0.1684, 0.6407, 0.1693, 1.0065, 0.2472];
    let mut clauses = claimed(
        inner(),
        "asymmetric",
        &[
            ["half opening 23/10", "half_opening", "3/2", NO_ROOT],
            ["friction 21/20", "friction", "106/100", NO_ROOT],
            ["milankovitch weight", "weight", "heyman", NO_ROOT],
            ["inner_sliding", "mode", "shoulder_opening", "claim: the contacts are not"],
        ],
    );
    clauses.extend(changed(inner(), &[[solved, "/unique/centre/0", "0x1p0", NO_ROOT]]));
    let unmet = asymmetric::unmet(InnerSliding, ("2.3", "1.1"), &start, outside);
    clauses.push(root("admissible at every joint", unmet));
    clauses
}

fn of_a_survey() -> Vec<Clause> {
    let opening = "all arches with half opening 7/18 pi to 4/9 pi";
    let every = "every arch stands (an admissible symmetric state exists)";
    changed(
        all(),
        &[
            [opening, "/survey/free/half_opening/1", "1/2 pi", ANOTHER],
            ["thickness 1/10 to 1/5", "/survey/free/thickness/0", "1/20", ANOTHER],
            ["friction 1/2 to 3/5", "/survey/friction/0", "2/5", ANOTHER],
            ["milankovitch weight", "/survey/weight", "heyman", ANOTHER],
            [every, "/verdict", "none_stands", "part 1: "],
        ],
    )
}

/// Every clause is denied by a copy that is refused, and without its clauses nothing is left of a statement.
#[test]
fn each_clause_is_a_claim_and_nothing_else_is_said() {
    let tables: [(Original, Vec<Clause>); 8] = [
        (point(), of_a_landmark()),
        (arch(), of_a_state()),
        (slides(), of_too_little_friction()),
        (too_wide(), of_too_wide_an_arch()),
        (too_thin(), of_too_thin_an_arch()),
        (stands(), of_an_arch_that_stands()),
        (inner(), of_an_asymmetric_solution()),
        (all(), of_a_survey()),
    ];
    let mut faults = Vec::new();
    for (original, clauses) in tables {
        let statement = statement(original);
        let mut rest = statement.clone();
        // No weight decides whether an arch slides at every thickness: no copy with another one is false.
        if original.0["claim"]["slides"].is_object() {
            rest = rest.replacen("milankovitch weight", "", 1);
        }
        for (words, Spoiled { what, bytes }, reason) in clauses {
            assert!(rest.contains(&words), "'{words}' is not said: {statement}");
            rest = rest.replacen(&words, "", 1);
            match file_alike(&bytes, MAX_DIGITS) {
                Err(refusal) if refusal.to_string().contains(&reason) => {}
                other => faults.push(format!("{words}: {what}: {other:?}")),
            }
        }
        let mut left = rest.split([',', ':', ';', ' ']).filter(|word| !word.is_empty());
        assert!(left.all(|word| ["and", "there"].contains(&word)), "'{rest}' is left: {statement}");
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

/// Where a line of thrust comes nearest to the intrados is another joint than where its moment is least.
#[test]
fn a_hint_is_not_said() {
    let expected =
        format!("half opening 13/5, friction 2/1, thickness 3/2, milankovitch weight: {STANDS}");
    assert_eq!(statement(stands_at_the_crown()), expected);
}

/// The short line says from what an arch stands on only behind that thickness.
#[test]
fn only_a_thickness_is_what_an_arch_stands_from() {
    let line = |keep: &[&str]| {
        let copy = arch().changed("values", |copy| {
            let all = copy["values"].as_array_mut().unwrap();
            all.reverse();
            all.retain(|value| keep.contains(&value["quantity"].as_str().unwrap()));
        });
        file_alike(&copy.bytes, MAX_DIGITS).unwrap().summary()
    };
    let both = line(&["thickness", "rotation_joint"]);
    assert!(both.contains("  thickness 0.65024") && both.contains("stands from it on"), "{both}");
    let joint = line(&["rotation_joint"]);
    assert!(joint.contains("  rotation_joint ") && !joint.contains("stands"), "{joint}");
}
