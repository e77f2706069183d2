//! `couplet prove`.

use crate::program::{Json, Scratch, command, ended, object, printed, says, tells};
use serde_json::{Value, json};
use std::sync::LazyLock;

/// Every claim with its derivation: all are decided once, for the tests together.
static CLAIMS: LazyLock<Value> = LazyLock::new(|| object("prove --show"));

#[test]
fn claims_are_decided_and_a_misprint_is_no_failure() {
    let file = &*CLAIMS;
    assert_eq!(file["schema"], "couplet.claims/3");
    let claims = file["claims"].list();
    assert!(claims.len() >= 30);
    for claim in claims {
        // Five are refuted as printed, and none is undecided.
        let verdict = if claim["as_printed"] == "refuted" { "refuted" } else { "proved" };
        assert_eq!(claim["verdict"], verdict, "{claim}");
    }
    let claim = |id: &str| claims.iter().find(|claim| claim["id"] == *id).unwrap();
    assert_eq!(claim("eq-8")["as_printed"], "proved");
    assert_eq!(claim("eq-2-4-imply-3")["as_printed"], "not stated");
    let misprint = claim("eq-16");
    says(misprint, json!({"as_printed": "refuted", "verdict": "refuted"}));
    assert!(misprint["counterexample"].text().contains("7−4√3 is not 0"));
    assert!(misprint["corrected"].text().contains("delta_M eta/6"));
    assert!(misprint.get("derivation").is_some());
    let without = object("prove eq-16");
    assert!(without["claims"][0].get("derivation").is_none(), "only where it is asked for");
}

/// Words between the checks of a claim are an argument where they are more than sixty; the last line counts the claims
/// that fewer join, and the pages say how many there are of each.
#[test]
fn how_much_rests_on_words_is_told() {
    let claims = CLAIMS["claims"].list();
    let words = |claim: &Value, support: &str| -> usize {
        let steps = claim["derivation"].list();
        let steps = steps.iter().filter(|step| step["support"] == support);
        steps.map(|step| step["words"].text().split_whitespace().count()).sum()
    };
    let [mut own, mut joined] = [0, 0];
    for claim in claims {
        let [argument, between] = ["argument", "conclusion"].map(|of| words(claim, of));
        assert!(between <= 60, "{}: {between}", claim["id"]);
        assert_eq!(claim["argument"] == "own", argument > 0, "{}", claim["id"]);
        own += usize::from(argument > 0);
        joined += usize::from(between > 0);
    }
    let beneath = claims.iter().filter(|claim| claim["argument"] == "beneath").count();
    for id in ["asymmetric-number", "survey-safety", "eq-9-11-signs", "safety-rotation"] {
        let claim = claims.iter().find(|claim| claim["id"] == id).unwrap();
        assert_eq!(claim["argument"], "own", "{id}");
    }
    let argued = format!("{own} by an argument in words, {beneath} resting on one");
    let last = format!("; {argued}; {joined} joined by sentences");
    let text = printed("prove");
    assert!(text.trim_end().ends_with(&last), "{last}: {}", text.lines().last().unwrap());
    let told = format!("{own} claims are carried by an argument in words, {beneath} rest on one");
    assert!(include_str!("../../../proofs/README.md").contains(&told), "{told}");
}

/// What the paper does not say is not refuted: it is an opinion, with a note.
#[test]
fn what_may_be_read_otherwise_is_no_refutation() {
    let file = object("prove --index");
    let sentences = file["sentences"].list();
    let of = |id: &str| {
        let bears = |of: &&Value| of["claims"].list().iter().any(|c| c["id"] == *id);
        sentences.iter().filter(bears).collect::<Vec<_>>()
    };
    for id in ["equations-five", "unique-asymmetric"] {
        assert!(!of(id).is_empty());
        for sentence in of(id) {
            assert_eq!(sentence["verdict"], "opinion", "{sentence}");
            assert!(sentence["reason"].text().len() > 20, "{sentence}");
        }
    }
}

/// Claims are decided in parallel, and many of them wait for the same comparison of the weights.
#[test]
fn no_claim_waits_for_one_that_waits_for_it() {
    for _ in 0..3 {
        for threads in ["3", "6", "12"] {
            let mut child = command("prove weights friction")
                .env("RAYON_NUM_THREADS", threads)
                .stdout(std::process::Stdio::null())
                .spawn()
                .unwrap();
            let start = std::time::Instant::now();
            let status = loop {
                if let Some(status) = child.try_wait().unwrap() {
                    break status;
                }
                if start.elapsed() > std::time::Duration::from_secs(60) {
                    child.kill().unwrap();
                    panic!("{threads} threads wait for one another");
                }
                std::thread::sleep(std::time::Duration::from_millis(5));
            };
            assert!(status.success());
        }
    }
}

/// Two arches of one mode and weight do not overwrite each other, and a bad file writes nothing.
#[test]
fn certificates_become_theorems() {
    let scratch = Scratch::new();
    let certificate = |name: &str, friction: &str| {
        let path = scratch.path(name);
        printed(format!("certify state --alpha pi/2 --mu {friction} -o {path}"));
        path
    };
    let (one, other) = (certificate("one.json", "0.5"), certificate("other.json", "0.6"));
    let folder = scratch.path("coq");
    let made = printed(["prove", "--coq", &folder, "--certificate", &one, &other]);
    let names = ["", "2"].map(|n| format!("StateRotationalMilankovitch{n}.v"));
    assert_eq!(made, names.each_ref().map(|name| format!("{folder}/{name}\n")).concat());
    for (name, mu) in names.iter().zip(["1 2", "3 5"]) {
        let given = format!("(Coefficient (Fraction {mu}))");
        tells(&scratch.read(&format!("coq/{name}")), [given]);
    }
    scratch.write("bad.json", scratch.read("one.json").replace("1/2 pi", "2/5 pi"));
    let bad = scratch.path("bad.json");
    for (file, code, reason) in
        [(&bad, 2, "refused: unique"), (&scratch.path("none.json"), 3, "cannot read")]
    {
        let empty = scratch.path("empty");
        let asked = ["prove", "--coq", &empty, "--certificate", &one, file];
        let (output, message) = ended(code, asked, "");
        assert_eq!(output, "");
        assert!(message.contains(reason) && message.lines().count() == 1, "{message}");
        assert!(!std::path::Path::new(&empty).exists());
    }
}
