//! Arches of a given thickness.

use super::mode;
use crate::arches::{H, M, arch, number};
use couplet::certify::state::Certify;
use couplet::problem::Mode;

/// A thickness outside `(0, 2)` is none: nothing is said of it.
#[test]
fn an_impossible_thickness_is_a_doubt() {
    for (thickness, question) in [
        ("0", "whether the thickness is positive"),
        ("-1/10", "whether the thickness is positive"),
        ("2", "whether the thickness is below the limit 2"),
        ("3", "whether the thickness is below the limit 2"),
    ] {
        let doubt = arch(H, "pi/2", "0.5").certify_thickness(&number(thickness), 6).unwrap_err();
        assert_eq!(doubt.reason, question, "{thickness}");
    }
    assert!(arch(H, "pi/2", "0.5").certify_thickness(&number("1.99"), 6).unwrap().stands);
}

/// Arches on which a comparison of the assessment is an exact tie that does not matter for the answer.
#[test]
fn exact_ties_do_not_hide_the_answer() {
    let cases = [
        // The lever arm that bounds the thrust at the crown is zero: (2 - eta) = (2 + eta) cos(alpha).
        (M, "pi/3", "0.5", "2/3"),
        // Besides, the line of least thrust touches the intrados exactly at the shoulder.
        (H, "pi/3", "0.5", "2/3"),
        // The friction angle is the half opening: the shoulder can just not slide.
        (M, "pi/4", "1", "0.1"),
        // The thickness is that of the end of rotation.
        (H, "pi/2", "0.5", "1"),
        (H, "pi/2", "inf", "1"),
        // No friction at all.
        (M, "1", "0", "0.2"),
        // A thrust far below any double.
        (M, "2.3", "1e900", "1.5"),
    ];
    for (weight, alpha, mu, eta) in cases {
        let found = arch(weight, alpha, mu).certify_thickness(&number(eta), 20);
        let found = found.unwrap_or_else(|doubt| panic!("{alpha} {mu} {eta}: {doubt:?}"));
        assert_eq!(found.stands, mu != "0", "{alpha} {mu} {eta}");
    }
    assert_eq!(mode(M, "2.6", "1e900"), Mode::OverturningSliding);
}
