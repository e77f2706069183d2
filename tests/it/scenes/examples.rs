//! The scenes in `examples/`.

use super::column;
use crate::house::house;
use crate::program::{Json, Scratch, printed, rows};
use couplet::arch::SelfWeight;
use couplet::certify::{CertifiedLandmark, fingerprint};
use couplet::problem::Landmark;

/// Runs an example into a folder and gives the folder.
fn example(name: &str) -> Scratch {
    let scratch = Scratch::new();
    let scene = house(&format!("examples/{name}"));
    assert_eq!(printed(["run", scene.to_str().unwrap(), "--output", &scratch.path("")]), "");
    scratch
}

#[test]
fn reference_constants_for_a_paper() {
    let out = example("reference-constants.toml");
    let table = out.read("constants.txt");
    let thickness = "0.61831824107432344637443225651706527335559298950489";
    assert!(table.contains(&format!("eta = t/r           {thickness}\n")), "{table}");
    assert!(!table.contains("beta_r, rad"), "not asked for");
    let file = out.json("constants.json");
    assert_eq!(file["digits"], 50);
    assert!(file["schema"].text().starts_with("couplet.constants/"));
    let constants = file["constants"].list();
    assert!(constants.iter().any(|constant| constant["value"] == thickness));
}

#[test]
fn a_table_for_the_semicircle_under_falling_friction() {
    let out = example("semicircle-friction.toml");
    let csv = out.read("semicircle.csv");
    let rows = rows(csv.as_str());
    assert_eq!(rows.len(), 28);
    let of = |weight: &str, mu: &str| {
        let mut of_arch =
            rows.iter().filter(|row| row["weight"] == weight && row["friction"] == mu);
        of_arch.next().unwrap()["thickness"].as_str()
    };
    // The literature: 0.107426, and 0.122192 with a friction of 0.38.
    assert!(of("heyman", "inf").starts_with("0.107426"), "{}", of("heyman", "inf"));
    assert!(of("heyman", "0.38").starts_with("0.122191"));
    assert_eq!(of("heyman", "0.4"), of("heyman", "inf"), "rotation does not see the friction");
    assert_eq!(of("heyman", "0.3"), "", "it slides");
    assert!(!csv.contains("joint"), "not asked for");
}

#[test]
fn a_horseshoe_study() {
    let out = example("horseshoe.toml");
    let csv = out.read("horseshoe.csv");
    assert_eq!(column(&csv, "half_opening")[..4], ["95deg", "95deg", "95deg", "100deg"]);
    let modes = column(&csv, "mode");
    assert_eq!(modes.len(), 33);
    for mode in ["[r,r,r]", "[s,r,r]", ""] {
        assert!(modes.iter().any(|m| m == mode), "{mode} in {modes:?}");
    }
    assert!(out.read("landmarks.txt").contains("139.232703571"), "the half opening of T");
}

#[test]
fn a_verification_run() {
    let out = example("verification.toml");
    let claims = out.read("claims.txt");
    assert!(claims.contains("1 refuted as printed and proved as corrected"), "{claims}");
    let audit = out.read("audit.csv");
    assert!(column(&audit, "landmark").iter().all(|landmark| landmark == "T" || landmark == "l"));
    assert!(column(&audit, "verdict").contains(&"wrong".to_owned()));
    let vault = out.read("vault.csv");
    let stands = column(&vault, "stands");
    assert_eq!(stands.iter().filter(|stands| *stands == "true").count(), 7, "{vault}");
}

#[test]
fn values_for_a_c_solver() {
    let out = example("c-solver.toml");
    let csv = out.read("states.csv");
    let (value, hex) = (column(&csv, "thickness"), column(&csv, "thickness_hex"));
    assert_eq!(hex.len(), 40);
    let place = value.iter().position(|value| value == "0.10747803810747631").unwrap();
    assert_eq!(hex[place], "0x1.b83ae42b5b8e5p-4");
    let header = out.read("landmarks.h");
    assert!(header.contains("COUPLET_T_HEYMAN_THICKNESS "), "{header}");
    assert!(!header.contains("ROTATION_JOINT"), "not asked for");
    // The hash is that of the certificate that `couplet certify` writes.
    let point = CertifiedLandmark::new(Landmark::Triple, SelfWeight::Heyman).unwrap();
    let certificate = fingerprint(&point, 17).unwrap();
    assert!(header.contains(&certificate), "{header}");
}
