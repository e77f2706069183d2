//! Certificates and their spoiled copies: each is refused for exactly its reason, in both arithmetics.

mod common;
#[path = "common/program.rs"]
mod program;

use common::certificates::{at_root, both, find_root, landmark, root, state, to_value};
use couplet::arch::{SelfWeight, Unknown};
use couplet::certify::certify_landmark;
use couplet::check::{Refusal, check_certificate};
use couplet::number::{Ball, ExactNumber};
use couplet::problem::{Claim, Exact, State, Subject};
use couplet::problem::{Landmark, Mode};
use program::{couplet, fed};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::process::Output;

/// The largest number of digits in this file.
const MAX_DIGITS: usize = 60;

/// The name of a variant. A new one has to be added here, and then needs a case.
fn variant(refusal: &Refusal) -> &'static str {
    match refusal {
        Refusal::Encoding(_) => "Encoding",
        Refusal::Format(_) => "Format",
        Refusal::Schema(_) => "Schema",
        Refusal::Subject => "Subject",
        Refusal::Name { .. } => "Name",
        Refusal::Mismatch { .. } => "Mismatch",
        Refusal::Given { .. } => "Given",
        Refusal::Digits(..) => "Digits",
        Refusal::Size { .. } => "Size",
        Refusal::Large { .. } => "Large",
        Refusal::Radius { .. } => "Radius",
        Refusal::Denominator(_) => "Denominator",
        Refusal::Contraction { .. } => "Contraction",
        Refusal::Outside(_) => "Outside",
        Refusal::Condition(_) => "Condition",
        Refusal::Quantity(_) => "Quantity",
        Refusal::NoValues => "NoValues",
        Refusal::Decimal(_) => "Decimal",
        Refusal::Rounding(_) => "Rounding",
    }
}

const VARIANTS: usize = 19;

/// The variants of each test below.
const FILE: &[&str] = &["Encoding", "Format"];
const CLAIM: &[&str] = &["Digits", "Given", "Mismatch", "Name", "Schema", "Subject"];
const SIZES: &[&str] = &["Large", "Radius", "Size"];
const WITNESSES: &[&str] = &["Contraction", "Denominator", "Outside"];
const CONDITIONS: &[&str] = &["Condition"];
const VALUES: &[&str] = &["Decimal", "NoValues", "Quantity", "Rounding"];

#[test]
fn every_variant_has_a_case() {
    let all = [FILE, CLAIM, SIZES, WITNESSES, CONDITIONS, VALUES].concat();
    assert_eq!(BTreeSet::from_iter(all).len(), VARIANTS);
}

/// What was seen of the variants.
#[derive(Default)]
struct Seen(BTreeSet<&'static str>);

impl Seen {
    fn were(self, variants: &[&str]) {
        assert_eq!(Vec::from_iter(self.0), variants);
    }

    /// The bytes are refused for exactly this reason.
    fn refused(&mut self, what: &str, bytes: &[u8], expected: &Refusal) {
        let found = both(bytes, MAX_DIGITS).expect_err(what);
        match (&found, expected) {
            // The place in the file and the types expected are serde's words.
            (Refusal::Format(found), Refusal::Format(expected)) => {
                assert!(found.starts_with(expected), "{what}: {found}");
            }
            _ => assert_eq!(found, *expected, "{what}"),
        }
        let words = found.to_string();
        assert!(words.len() < 400 && !words.contains(char::is_control), "{what}: {words}");
        self.0.insert(variant(&found));
    }

    /// A copy with another value at some place of it is.
    fn with(&mut self, base: &Value, place: &str, value: Value, expected: &Refusal) {
        let what = format!("{place} = {value:.60}");
        let mut copy = base.clone();
        *copy.pointer_mut(place).expect(place) = value;
        self.refused(&what, &bytes(&copy), expected);
    }

    /// A copy with one text replaced by another is.
    fn replaced(&mut self, base: &Value, from: &str, to: &str, expected: &Refusal) {
        let text = base.to_string();
        assert!(text.contains(from), "{from}");
        self.refused(to, text.replacen(from, to, 1).as_bytes(), expected);
    }
}

fn bytes(value: &Value) -> Vec<u8> {
    value.to_string().into_bytes()
}

fn format(words: &str) -> Refusal {
    Refusal::Format(words.to_owned())
}

/// What holds for everything below: the copies that are not spoiled are accepted.
#[test]
fn the_originals_are_accepted() {
    for base in
        [landmark("T"), landmark("l"), landmark("sb"), state("2.45", "1.35"), state("2.5", "inf")]
    {
        both(&bytes(base), MAX_DIGITS).unwrap();
    }
}

#[test]
fn what_is_no_certificate_is_told_with_its_place() {
    let mut seen = Seen::default();
    let raw: [(&str, &[u8], Refusal); 13] = [
        (
            "empty",
            include_bytes!("refused/empty.json"),
            format("EOF while parsing a value at line 1 column 0"),
        ),
        (
            "null",
            include_bytes!("refused/null.json"),
            format("invalid type: null, expected an object"),
        ),
        ("number", b"1", format("invalid type: integer `1`, expected an object")),
        ("cut", include_bytes!("refused/cut.json"), format("EOF while parsing a list")),
        (
            "list",
            include_bytes!("refused/list.json"),
            format("invalid type: sequence, expected an object"),
        ),
        ("latin-1", include_bytes!("refused/latin-1.json"), Refusal::Encoding(49)),
        ("utf-16", include_bytes!("refused/utf-16.json"), Refusal::Encoding(0)),
        (
            "byte order mark",
            include_bytes!("refused/byte-order-mark.json"),
            format("expected value at line 1 column 1"),
        ),
        (
            "surrogate",
            include_bytes!("refused/surrogate.json"),
            format("unexpected end of hex escape"),
        ),
        (
            "comment",
            include_bytes!("refused/comment.json"),
            format("expected value at line 1 column 1"),
        ),
        ("text", include_bytes!("refused/text.json"), format("expected value at line 1 column 1")),
        (
            "control",
            include_bytes!("refused/control.json"),
            format("unknown field `a\\n\\u{1b}[2J`"),
        ),
        ("empty object", b"{}", format("missing field `schema`")),
    ];
    for (what, bytes, expected) in raw {
        seen.refused(what, bytes, &expected);
    }
    let base = landmark("T");
    for (from, to, words) in [
        ("{", "{\"extra\":1,", "unknown field `extra`"),
        ("\"weight\"", "\"Weight\"", "unknown field `Weight`"),
        ("\"centre\"", "\"center\"", "unknown field `center`"),
        ("\"quantity\"", "\"error\":1,\"quantity\"", "unknown field `error`"),
        ("\"digits\"", "\"digits\":30,\"digits\"", "duplicate field `digits`"),
        ("\"landmark\"", "\"landmark\":\"T\",\"landmark\"", "duplicate field `landmark`"),
        ("\"centre\"", "\"centre\":[],\"centre\"", "duplicate field `centre`"),
        ("\"value\":", "\"value\":\"1\",\"value\":", "duplicate field `value`"),
        ("}]}", "}],}", "trailing comma"),
        ("}]}", "},]}", "trailing comma"),
        ("}]}", "}]}{}", "trailing characters"),
        ("}]}", "}]}\u{0}", "trailing characters"),
        ("}]}", "}]", "EOF while parsing an object"),
        ("\"digits\"", "'digits'", "key must be a string"),
        ("\"digits\":30", "\"digits\":030", "invalid number"),
        ("\"digits\":30", "\"digits\":+30", "expected value"),
        ("\"digits\":30", "\"digits\":NaN", "expected value"),
        ("\"digits\":30", "\"digits\":1e400", "number out of range"),
    ] {
        seen.replaced(base, from, to, &format(words));
    }
    let arch = state("2.45", "1.35");
    seen.replaced(arch, "\"mode\"", "\"mode\":\"[r]\",\"mode\"", &format("duplicate field `mode`"));
    seen.replaced(arch, "\"mode\"", "\"Mode\"", &format("unknown field `Mode`"));
    seen.with(arch, "/claim/state", json!(null), &format("invalid type: null, expected an object"));
    seen.with(
        arch,
        "/claim/state",
        json!(["[r]", "1/1", "inf"]),
        &format("invalid type: sequence"),
    );

    // Every field of every object is needed.
    for (base, place) in [
        (base, ""),
        (base, "/claim"),
        (base, "/unique"),
        (base, "/root"),
        (base, "/values/0"),
        (arch, "/claim/state"),
    ] {
        for key in base.pointer(place).unwrap().as_object().unwrap().keys() {
            if place == "/claim" && key == "landmark" {
                continue;
            }
            let mut copy = base.clone();
            copy.pointer_mut(place).unwrap().as_object_mut().unwrap().remove(key);
            seen.refused(key, &bytes(&copy), &format(&format!("missing field `{key}`")));
        }
    }
    for (place, value, words) in [
        ("/tool", json!(5), "invalid type: integer `5`, expected a string"),
        ("/digits", json!("30"), "invalid type: string \"30\", expected usize"),
        ("/digits", json!(-1), "invalid value: integer `-1`, expected usize"),
        ("/digits", json!(30.0), "invalid type: floating point `30.0`, expected usize"),
        ("/digits", json!(1e30), "invalid type: floating point `1e+30`, expected usize"),
        ("/digits", json!(null), "invalid type: null, expected usize"),
        ("/claim", json!(["heyman", "T", [], []]), "invalid type: sequence, expected an object"),
        ("/claim/landmark", json!(null), "invalid type: null, expected a string"),
        (
            "/claim/unknowns",
            json!("thickness"),
            "invalid type: string \"thickness\", expected a sequence",
        ),
        ("/unique", json!([[], []]), "invalid type: sequence, expected an object"),
        ("/root", json!(null), "invalid type: null, expected an object"),
        ("/inverse/0", json!("0x1p0"), "invalid type: string \"0x1p0\", expected a sequence"),
        ("/root/centre/0", json!(1.5), "invalid type: floating point `1.5`, expected a string"),
        ("/values", json!({}), "invalid type: map, expected a sequence"),
        ("/values/0", json!(["thickness", "0.7"]), "invalid type: sequence, expected an object"),
        ("/values/0/value", json!(0.7), "invalid type: floating point `0.7`, expected a string"),
    ] {
        seen.with(base, place, value, &format(words));
    }
    for text in [
        "", "1.5", "0x1", "0x1p", "0xFp1", "+0x1p1", "0x1.8p0", "0x1p+1", "--0x1p0", " 0x1p0",
        "0x1p0\n", "inf",
    ] {
        let words =
            format!("{text:?} is no number of a certificate: it is not of the form -0x1f3p-12");
        seen.with(base, "/root/centre/0", json!(text), &format(&words));
    }
    for text in ["0x1p10000001", "0x1p-10000001", "0x0p10000001", "0x1p999999999999999999"] {
        let words =
            format!("{text:?} is no number of a certificate: its exponent is beyond ±10000000");
        seen.with(base, "/inverse/0/0", json!(text), &format(&words));
    }
    seen.were(FILE);
}

#[test]
fn a_claim_that_is_none_is_told() {
    let mut seen = Seen::default();
    let (base, arch) = (landmark("T"), state("2.45", "1.35"));
    for text in ["couplet.certificate/2", "couplet.certificate/1 ", "couplet.constants/1", ""] {
        seen.with(base, "/schema", json!(text), &Refusal::Schema(text.into()));
    }
    let mut both_subjects = base.clone();
    both_subjects["claim"]["state"] = arch["claim"]["state"].clone();
    seen.refused("both", &bytes(&both_subjects), &Refusal::Subject);
    let mut neither = base.clone();
    neither["claim"].as_object_mut().unwrap().remove("landmark");
    seen.refused("neither", &bytes(&neither), &Refusal::Subject);

    for (base, place, text) in [
        (base, "weight", "couplet"),
        (base, "weight", "Heyman"),
        (base, "weight", ""),
        (base, "landmark", "X"),
        (base, "landmark", "t"),
        (base, "landmark", ""),
        (arch, "mode", "[r,s,s]"),
        (arch, "mode", "r,r,s"),
        // No thickness belongs to the purely sliding state.
        (arch, "mode", "[s,s]"),
    ] {
        let whole = if place == "mode" {
            "/claim/state/mode".to_owned()
        } else {
            format!("/claim/{place}")
        };
        seen.with(base, &whole, json!(text), &Refusal::Name { place, text: text.into() });
    }

    for base in [base, arch] {
        for place in ["unknowns", "equations"] {
            let names: Vec<String> = serde_json::from_value(base["claim"][place].clone()).unwrap();
            let expected = Refusal::Mismatch { place, expected: names.join(", ") };
            let mut swapped = names.clone();
            swapped.swap(0, 1);
            let mut other = names.clone();
            other[0] = "width".to_owned();
            let more = [&names[..], &names[..1]].concat();
            for list in [swapped, other, more, names[1..].to_vec(), vec![]] {
                seen.with(base, &format!("/claim/{place}"), json!(list), &expected);
            }
        }
    }
    // Another landmark with the unknowns of this one.
    let mismatch = both(
        &bytes(&{
            let mut copy = base.clone();
            copy["claim"]["landmark"] = json!("S");
            copy
        }),
        MAX_DIGITS,
    );
    assert!(matches!(mismatch, Err(Refusal::Mismatch { place: "unknowns", .. })), "{mismatch:?}");

    let long = "7".repeat(100_001);
    let given = |place, text: &str| {
        let more = if text.chars().count() > 40 { "…" } else { "" };
        Refusal::Given { place, text: text.chars().take(40).collect::<String>() + more }
    };
    for place in ["half_opening", "friction"] {
        for text in [
            "",
            "1",
            "1.5",
            "1/0",
            "0/00",
            "-1/2",
            "1/-2",
            "+1/2",
            "1/2pi",
            "1/2 pi ",
            "pi/2",
            " 1/2",
            "1/2/3",
            "١/٢",
            "nan",
            "0x1/2",
            &format!("{long}/2"),
            &format!("2/{long}"),
        ] {
            seen.with(arch, &format!("/claim/state/{place}"), json!(text), &given(place, text));
        }
    }
    seen.with(arch, "/claim/state/half_opening", json!("inf"), &given("half_opening", "inf"));
    seen.with(arch, "/claim/state/friction", json!("inf"), &given("friction", "inf"));
    // Overturning is a state of unlimited friction only.
    let mut overturning = state("2.62", "inf").clone();
    assert_eq!(overturning["claim"]["state"]["mode"], "[r]");
    overturning["claim"]["state"]["friction"] = json!("5/1");
    seen.refused("[r]", &bytes(&overturning), &given("friction", "5/1"));

    for digits in [0, MAX_DIGITS + 1, 1_000_001, usize::MAX] {
        seen.with(base, "/digits", json!(digits), &Refusal::Digits(digits, MAX_DIGITS));
    }
    seen.were(CLAIM);
}

#[test]
fn every_size_is_looked_at() {
    let mut seen = Seen::default();
    let base = landmark("T");
    for (whole, place) in [
        ("/inverse", "inverse"),
        ("/inverse/0", "inverse"),
        ("/inverse/5", "inverse"),
        ("/unique/centre", "unique"),
        ("/unique/radius", "unique"),
        ("/root/centre", "root"),
        ("/root/radius", "root"),
    ] {
        let list = base.pointer(whole).unwrap().as_array().unwrap();
        assert_eq!(list.len(), 6);
        let more = [&list[..], &list[..1]].concat();
        for list in [more, list[1..].to_vec(), vec![]] {
            let found = list.len();
            seen.with(base, whole, json!(list), &Refusal::Size { place, found, expected: 6 });
        }
    }
    // The same number with zeros behind it, up to the last bit allowed and one more.
    for (whole, place, bits) in [
        ("/inverse/2/3", "inverse", 256),
        ("/unique/radius/1", "unique", 256),
        ("/unique/centre/1", "unique", 20_000),
        ("/root/radius/4", "root", 256),
        ("/root/centre/4", "root", 20_100),
    ] {
        let text = base.pointer(whole).unwrap().as_str().unwrap();
        let (mantissa, exponent) = text.split_once('p').unwrap();
        let (sign, digits) = mantissa.split_once("0x").unwrap();
        let size = rug::Integer::from_str_radix(digits, 16).unwrap();
        let exponent: i64 = exponent.parse().unwrap();
        let longer = |bits: u32| {
            let zeros = bits - size.significant_bits();
            let mantissa = size.clone() << zeros;
            json!(format!("{sign}0x{mantissa:x}p{}", exponent - i64::from(zeros)))
        };
        let mut copy = base.clone();
        *copy.pointer_mut(whole).unwrap() = longer(bits);
        both(&bytes(&copy), MAX_DIGITS).unwrap_or_else(|e| panic!("{whole}: {e}"));
        let expected = Refusal::Large { place, bits: bits as usize };
        seen.with(base, whole, longer(bits + 1), &expected);
    }
    for place in ["unique", "root"] {
        for (k, unknown) in [(0, "half_opening"), (4, "thrust")] {
            for text in ["0x0p0", "-0x1p-90", "0x0000p5"] {
                let whole = format!("/{place}/radius/{k}");
                seen.with(base, &whole, json!(text), &Refusal::Radius { place, unknown });
            }
        }
    }
    seen.were(SIZES);
}

#[test]
fn witnesses_that_prove_nothing_are_refused() {
    let mut seen = Seen::default();
    let base = landmark("T");
    let contraction = |place, unknown| Refusal::Contraction { place, unknown };
    // 2 - eta is a denominator; so is the thrust's, which an angle of every size makes zero.
    seen.with(base, "/unique/radius/3", json!("0x1p1"), &Refusal::Denominator("unique"));
    seen.with(base, "/unique/radius/0", json!("0x1p10000000"), &Refusal::Denominator("unique"));

    // A box without the root, one that is too large, and an inverse that is none.
    seen.with(base, "/unique/centre/1", json!("0x1p-1"), &contraction("unique", "half_opening"));
    seen.with(base, "/unique/radius/5", json!("0x1p0"), &contraction("unique", "half_opening"));
    let zeros = vec![vec!["0x0p0"; 6]; 6];
    seen.with(base, "/inverse", json!(zeros), &contraction("unique", "half_opening"));
    seen.with(base, "/inverse/3", json!(zeros[0]), &contraction("unique", "thickness"));
    let mut rows = base["inverse"].as_array().unwrap().clone();
    rows.swap(4, 5);
    seen.with(base, "/inverse", json!(rows), &contraction("unique", "thrust"));
    seen.with(base, "/inverse/0/0", json!("0x1p200"), &contraction("unique", "half_opening"));

    // A small box outside, astride, as large as the large one, and beside the root.
    seen.with(base, "/root/centre/0", json!("0x1p1"), &Refusal::Outside("half_opening"));
    seen.with(base, "/root/centre/5", json!("-0x1p-1"), &Refusal::Outside("friction"));
    seen.with(base, "/root/radius/4", json!("0x1p0"), &Refusal::Outside("thrust"));
    seen.with(base, "/root", base["unique"].clone(), &Refusal::Outside("half_opening"));
    seen.with(
        base,
        "/root/centre",
        base["unique"]["centre"].clone(),
        &contraction("root", "half_opening"),
    );
    seen.with(base, "/root/radius/3", json!("0x1p-300"), &contraction("root", "thickness"));
    seen.with(
        base,
        "/root/radius/2",
        json!("0x1p-10000000"),
        &contraction("root", "sliding_joint"),
    );

    // Another landmark's box, another weight's, another arch's: their roots are not here.
    let mut other = base.clone();
    other["claim"]["weight"] = json!("milankovitch");
    seen.refused("the other weight", &bytes(&other), &contraction("unique", "half_opening"));
    let arch = state("2.45", "1.35");
    let mut other = arch.clone();
    other["claim"]["state"]["half_opening"] =
        json!("245000000000000000000000000001/100000000000000000000000000000");
    seen.refused("another arch", &bytes(&other), &contraction("root", "rotation_joint"));
    seen.were(WITNESSES);
}

fn landmark_claim(landmark: Landmark, weight: SelfWeight) -> Claim {
    Claim { weight, subject: Subject::Landmark(landmark) }
}

/// The claim that an arch of this half opening and friction collapses in this mode.
fn state_claim(weight: SelfWeight, mode: Mode, half_opening: &str, friction: &str) -> Claim {
    let exact = |text: &str| {
        let number: ExactNumber = text.parse().unwrap();
        let (numerator, denominator) = number.factor().clone().into_numer_denom();
        let (numerator, denominator) = (numerator.to_string(), denominator.to_string());
        Exact { numerator, denominator, times_pi: !number.is_rational() }
    };
    let friction = (friction != "inf").then(|| exact(friction));
    let state = State { mode, half_opening: exact(half_opening), friction };
    Claim { weight, subject: Subject::State(state) }
}

/// True roots, with witnesses that prove them, of which something else is not true.
#[test]
fn a_root_that_is_not_the_one_claimed_is_refused() {
    use {Landmark as L, Mode as M, SelfWeight::*};
    let mut seen = Seen::default();
    let arch = state_claim;
    let cases: [(Claim, &[f64], &str); 18] = [
        (landmark_claim(L::OverturningEnd, Heyman), &[-2.7865], "a positive half opening"),
        (landmark_claim(L::OverturningEnd, Heyman), &[9.2], "a half opening below pi"),
        (
            landmark_claim(L::Shift, Heyman),
            &[9.2804, 0.0718, 0.9965, 0.0052, 6.9075],
            "a half opening below pi",
        ),
        (
            landmark_claim(L::WidestJoint, Heyman),
            &[2.2303, -1.1291, 0.4214, 0.267],
            "an unknown above zero",
        ),
        (
            landmark_claim(L::Triple, Heyman),
            &[2.4872, -1.0375, 0.2971, 0.6796, 0.0978, 1.4153],
            "an unknown above zero",
        ),
        (
            landmark_claim(L::Triple, Heyman),
            &[2.7447, 6.6674, 0.1893, 1.8854, 0.0372, 2.4796],
            "an unknown below its largest value",
        ),
        (
            arch(Heyman, M::Rotational, "2.3", "1.1"),
            &[-1.1248, 0.4793, 0.2226],
            "a rotational joint below the crown",
        ),
        (
            arch(Heyman, M::Rotational, "2.3", "1.1"),
            &[7.3168, 1.5906, 0.4723],
            "a rotational joint above the shoulder",
        ),
        (
            arch(Heyman, M::Rotational, "2.3", "1.1"),
            &[5.1537, 2.9703, 0.6269],
            "a thickness below the physical limit",
        ),
        (
            arch(Milankovitch, M::Rotational, "pi/2", "1/4"),
            &[0.9509, 0.1075, 0.6209],
            "friction enough at the shoulder",
        ),
        (
            arch(Milankovitch, M::Rotational, "2.45", "1.35"),
            &[1.03, 0.648, 0.105],
            "friction enough inside",
        ),
        (
            arch(Heyman, M::SlidingRotational, "2.3", "1.1"),
            &[1.1275, 0.4565, 0.2395],
            "the line of thrust inside the extrados at the shoulder",
        ),
        (
            arch(Heyman, M::RotationalSliding, "2.3", "1.1"),
            &[1.2592, 0.416, 0.143, 0.35],
            "the line of thrust inside the extrados at the crown",
        ),
        (
            arch(Heyman, M::OverturningSliding, "2.3", "1.1"),
            &[0.2149, 0.143, 0.35],
            "the line of thrust leaves the intrados at the crown",
        ),
        (
            arch(Milankovitch, M::RotationalSlidingRotational, "2.45", "1.35"),
            &[1.0036, 0.6502, 0.1053, 0.307],
            "a rotational joint nearer to the crown",
        ),
        (
            arch(Milankovitch, M::RotationalSliding, "2.533", "1.545"),
            &[0.2, 0.88, 0.085, 0.279],
            "a sliding joint nearer to the crown",
        ),
        (
            arch(Heyman, M::Rotational, "2.3", "inf"),
            &[-1.1248, 0.4793, 0.2226],
            "a rotational joint below the crown",
        ),
        (
            arch(Heyman, M::Overturning, "2.6", "inf"),
            &[0.9],
            "the line of thrust leaves the intrados at the crown",
        ),
    ];
    for (claim, start, words) in cases {
        let certificate = bytes(&to_value(&at_root(&claim, start)));
        seen.refused(words, &certificate, &Refusal::Condition(words));
    }
    seen.were(CONDITIONS);
}

/// Newton's method from many starts finds many roots, all with right witnesses; the only one that is
/// accepted is the one that is meant.
#[test]
fn of_all_the_roots_one_is_accepted() {
    let mut state = 1u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut claims: Vec<(Claim, usize)> = Vec::new();
    for weight in SelfWeight::ALL {
        claims.extend(Landmark::ALL.map(|landmark| (landmark_claim(landmark, weight), 40)));
        let modes =
            Mode::ALL.into_iter().filter(|mode| !matches!(mode, Mode::Sliding | Mode::Overturning));
        for (half_opening, friction) in
            [("pi/2", "0.38"), ("2.45", "1.35"), ("2.6", "2"), ("3", "50"), ("2.9", "0.3")]
        {
            claims.extend(
                modes.clone().map(|mode| (state_claim(weight, mode, half_opening, friction), 12)),
            );
        }
    }
    let (mut refused, mut accepted, mut reasons) = (0, 0, BTreeSet::new());
    for (claim, starts) in &claims {
        let mut known: Option<Vec<f64>> = None;
        for _ in 0..*starts {
            let alpha = 1.5 + 1.6 * random();
            let start = claim.unknowns().iter().map(|unknown| match unknown {
                Unknown::HalfOpening => alpha,
                Unknown::RotationJoint | Unknown::SlidingJoint => alpha * random() / 2.0,
                Unknown::Thickness => 2.0 * random(),
                Unknown::Thrust => random(),
                Unknown::Friction => 3.0 * random(),
            });
            let start: Vec<f64> = start.collect();
            let Some(certificate) = find_root(claim, &start) else { continue };
            // Without a value everything else is examined.
            match check_certificate::<Ball>(&certificate, 5) {
                Err(Refusal::NoValues) => {
                    accepted += 1;
                    let root = root(&to_value(&certificate));
                    let known = known.get_or_insert_with(|| root.clone());
                    let same = known.iter().zip(&root).all(|(a, b)| (a - b).abs() < 1e-12);
                    assert!(same, "{claim:?}: {known:?} and {root:?}");
                }
                Err(Refusal::Condition(words)) => {
                    refused += 1;
                    reasons.insert(words);
                }
                other => assert!(other.is_err(), "{claim:?} {other:?}"),
            }
        }
        if let (Subject::Landmark(landmark), Some(root)) = (&claim.subject, &known) {
            let certified = certify_landmark(*landmark, claim.weight, 12).unwrap();
            let expected = self::root(&to_value(&certified));
            assert!(root.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-11), "{claim:?}");
        }
    }
    assert!(refused > 200 && accepted > 200, "{refused} {accepted}");
    for words in ["a positive thickness", "a thrust below one", "a positive thrust"] {
        assert!(reasons.contains(words), "{words}: {reasons:?}");
    }
}

#[test]
fn values_are_believed_to_the_last_place_only_if_they_are_right() {
    let mut seen = Seen::default();
    let base = landmark("T");
    let value = |k: usize| base["values"][k]["value"].as_str().unwrap().to_owned();
    let name = |k: usize| -> &'static str {
        let text = base["values"][k]["quantity"].as_str().unwrap();
        couplet::problem::Quantity::LANDMARK.iter().find(|q| q.name() == text).unwrap().name()
    };
    let count = base["values"].as_array().unwrap().len();
    assert_eq!(count, 13);
    for k in 0..count {
        let place = format!("/values/{k}/value");
        let (rounding, decimal) = (Refusal::Rounding(name(k)), Refusal::Decimal(name(k)));
        let right = value(k);
        let (head, last) = right.split_at(right.len() - 1);
        let last: u32 = last.parse().unwrap();
        for wrong in [(last + 1) % 10, (last + 9) % 10] {
            seen.with(base, &place, json!(format!("{head}{wrong}")), &rounding);
        }
        for text in ["0", "inf", "1e-3000000", "1e3000000", "9e9", &value((k + 1) % count)] {
            seen.with(base, &place, json!(text), &rounding);
        }
        for text in [
            "",
            "abc",
            "nan",
            "Inf",
            "-inf",
            "infinity",
            ".5",
            "-0",
            "0.000",
            "00.5",
            "1.",
            "1e+5",
            "+0.5",
            " 0.5",
            "0.5 ",
            "0,5",
            "1e",
            "1e3000001",
            "1e-9223372036854775808",
            "1e9223372036854775807",
            "1e99999999999999999999",
            "0x1p0",
            "½",
            &format!("-{right}"),
            &format!("{right}0"),
            &format!("{right}1"),
        ] {
            seen.with(base, &place, json!(text), &decimal);
        }
    }
    // One digit more than the values have: a zero behind them is not right either.
    seen.with(base, "/digits", json!(31), &Refusal::Rounding("thickness"));
    seen.with(base, "/digits", json!(29), &Refusal::Decimal("thickness"));
    // A small box that is true and too large to tell.
    let mut wide = base.clone();
    for radius in wide["root"]["radius"].as_array_mut().unwrap() {
        let text = radius.as_str().unwrap();
        let (mantissa, exponent) = text.split_once('p').unwrap();
        *radius = json!(format!("{mantissa}p{}", exponent.parse::<i32>().unwrap() + 60));
    }
    seen.refused("too wide", &bytes(&wide), &Refusal::Rounding("thickness"));

    // Infinite and zero where they are exact, and what is near them.
    let end = landmark("l");
    let index = |name: &str| {
        end["values"].as_array().unwrap().iter().position(|v| v["quantity"] == name).unwrap()
    };
    for (quantity, text) in
        [("friction", "inf"), ("thrust", "0"), ("thickness", "1"), ("friction_angle_degrees", "90")]
    {
        assert_eq!(end["values"][index(quantity)]["value"], text);
    }
    for (quantity, text) in [
        ("friction", "1e3000000"),
        ("friction", "0"),
        ("thrust", "1e-3000000"),
        ("thrust", "inf"),
        ("thickness", "1.00001"),
        ("thickness", "0.99999"),
        ("friction_angle", "inf"),
        ("friction_angle_degrees", "89.999"),
        ("rotation_joint", "1e-30"),
    ] {
        let known = couplet::problem::Quantity::LANDMARK
            .iter()
            .find(|q| q.name() == quantity)
            .unwrap()
            .name();
        let place = format!("/values/{}/value", index(quantity));
        seen.with(end, &place, json!(text), &Refusal::Rounding(known));
    }

    let unknown = |text: &str| Refusal::Quantity(text.to_owned());
    for text in ["", "Thickness", "thickness ", "eta", "tool"] {
        seen.with(base, "/values/0/quantity", json!(text), &unknown(text));
    }
    seen.with(base, "/values/1", base["values"][0].clone(), &unknown("thickness"));
    let widest = landmark("sb");
    seen.with(widest, "/values/0/quantity", json!("friction"), &unknown("friction"));
    seen.with(widest, "/values/0/quantity", json!("sliding_joint"), &unknown("sliding_joint"));
    let arch = state("2.45", "1.35");
    for text in ["half_opening", "half_opening_degrees", "friction", "friction_angle", "A"] {
        seen.with(arch, "/values/0/quantity", json!(text), &unknown(text));
    }
    seen.with(
        state("pi/2", "1/2"),
        "/values/0/quantity",
        json!("sliding_joint"),
        &unknown("sliding_joint"),
    );
    seen.with(base, "/values", json!([]), &Refusal::NoValues);
    seen.were(VALUES);
}

#[test]
fn every_landmark_at_60_digits_is_accepted_and_fewer_digits_too() {
    for landmark in Landmark::ALL {
        for weight in SelfWeight::ALL {
            for digits in [1, 2, 3, 60] {
                let certificate = certify_landmark(landmark, weight, digits).unwrap();
                let accepted = both(&serde_json::to_vec(&certificate).unwrap(), digits).unwrap();
                assert_eq!(accepted.claim, Claim { weight, subject: Subject::Landmark(landmark) });
                assert_eq!(
                    (accepted.digits, accepted.values.len()),
                    (digits, certificate.values.len())
                );
            }
        }
    }
}

fn said(output: &Output) -> (Option<i32>, String, String) {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

#[test]
fn the_commands_make_and_check_certificates() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (good, bad, empty) = (path("good.json"), path("bad.json"), path("empty.json"));
    let made =
        couplet(&["certify", "T", "--weight", "heyman", "--digits", "60", "--output", &good]);
    assert_eq!(said(&made), (Some(0), String::new(), String::new()));
    let line = "accepted  T heyman  thickness 0.67960473209888551478… to 60 digits\n";
    for arguments in
        [&["check"][..], &["check", "--engine", "astro"], &["check", "--engine", "mpfr"]]
    {
        let output = couplet(&[arguments, &[&good]].concat());
        assert_eq!(said(&output), (Some(0), format!("{good}: {line}"), String::new()));
    }
    let input = std::fs::read(&good).unwrap();
    assert_eq!(said(&fed(&["check", "-"], &input)), (Some(0), format!("-: {line}"), String::new()));
    let state = couplet(&["certify", "state", "--alpha", "2.45", "--mu", "1.35", "--digits", "5"]);
    let (code, output, _) = said(&fed(&["check", "-"], &state.stdout));
    assert_eq!(code, Some(0));
    assert!(
        output.starts_with("-: accepted  [r")
            && output.contains("half_opening 49/20 friction 27/20"),
        "{output}"
    );

    // A refused one does not keep the others from being checked.
    std::fs::write(&bad, std::str::from_utf8(&input).unwrap().replace("\"T\"", "\"Q\"")).unwrap();
    std::fs::write(&empty, "").unwrap();
    let (code, output, message) = said(&couplet(&["check", &bad, &good, &empty]));
    assert_eq!((code, message.as_str()), (Some(1), "couplet: 2 of 3 refused\n"));
    let lines: Vec<&str> = output.lines().collect();
    assert_eq!(lines[0], format!("{bad}: refused: claim: there is no landmark 'Q'"));
    assert_eq!(lines[1], format!("{good}: {}", line.trim_end()));
    let reason =
        "refused: the file is not a certificate: EOF while parsing a value at line 1 column 0";
    assert_eq!(lines[2..], [format!("{empty}: {reason}")]);

    // What cannot be read, and what makes no sense.
    for missing in [path("missing.json"), path("."), String::new()] {
        let (code, output, message) = said(&couplet(&["check", &missing]));
        assert_eq!((code, output.as_str()), (Some(3), ""), "{missing}");
        assert!(message.starts_with(&format!("couplet: cannot read {missing}: ")), "{message}");
        assert_eq!(message.lines().count(), 1, "{message}");
    }
    for arguments in [
        &["check"][..],
        &["check", "--engine", "gmp", &good],
        &["check", "--digits", "5", &good],
        &["certify"],
        &["certify", "Q"],
        &["certify", "T", "--digits", "0"],
        &["certify", "T", "--alpha", "1"],
        &["certify", "state", "--alpha", "4", "--mu", "1"],
        &["certify", "state", "--alpha", "1"],
    ] {
        let (code, output, message) = said(&couplet(arguments));
        assert_eq!((code, output.as_str()), (Some(2), ""), "{arguments:?} {message}");
        assert!(message.starts_with("couplet: "), "{arguments:?} {message}");
    }
    let falls = ["certify", "state", "--alpha", "1.5", "--mu", "0.1"];
    let (code, output, message) = said(&couplet(&falls));
    assert_eq!((code, output.as_str(), message.lines().count()), (Some(1), "", 1), "{message}");
}

#[test]
fn a_folder_of_certificates_is_accepted_whole() {
    let folder = tempfile::tempdir().unwrap();
    let all = folder.path().join("all");
    let made = couplet(&["certify", "all", "--digits", "8", "--output", all.to_str().unwrap()]);
    assert_eq!(made.status.code(), Some(0), "{made:?}");
    let mut files: Vec<String> = std::fs::read_dir(&all)
        .unwrap()
        .map(|entry| entry.unwrap().path().to_str().unwrap().to_owned())
        .collect();
    files.sort();
    assert_eq!(files.len(), 14);
    let names: Vec<&str> = files.iter().map(String::as_str).collect();
    let (code, output, message) = said(&couplet(&[&["check"][..], &names].concat()));
    assert_eq!((code, message.as_str()), (Some(0), ""), "{output}");
    assert_eq!(output.matches(": accepted  ").count(), 14);
}
