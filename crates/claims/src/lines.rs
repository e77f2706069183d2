//! The lines of the map as curves: each one arc from landmark to landmark.

use super::regular::{CYCLOID, SHOULDER_IN_ANGLES};
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::SelfWeight;
use crate::atlas::{Curve, Trace};
use std::sync::OnceLock;

claims! {
    Implicit("map-lines", "Sec. 3, Fig. 5, 6", lines):
        "each line between two modes is one curve without a gap from landmark to landmark, analytic inside, and so \
         are the purely rotational, overturning and sliding states; the corners of the domains are T, S, J, B, l and \
         L";
}

/// Half-width of the tubes.
const TOLERANCE: f64 = 1e-3;

/// Each curve with its weight, and whether every piece of it is proved, decided once.
fn traced() -> &'static [(String, Checked<bool>)] {
    static DECIDED: OnceLock<Vec<(String, Checked<bool>)>> = OnceLock::new();
    DECIDED.get_or_init(|| {
        let all = SelfWeight::ALL.into_iter().flat_map(|weight| Curve::ALL.map(|c| (c, weight)));
        let trace = |(curve, weight): (Curve, SelfWeight)| {
            let [from, to] = curve.ends();
            let words = format!("{curve} from {from} to {to}, {weight}");
            let traced = Trace::new(curve, weight, TOLERANCE);
            (words, traced.map(|trace| trace.gaps().next().is_none()))
        };
        all.map(trace).collect()
    })
}

fn lines(d: &mut Derivation) -> Checked {
    lemmas(d, [&CYCLOID, &SHOULDER_IN_ANGLES])?;
    for (words, is_whole) in traced() {
        d.proved_elsewhere(format!("{words}: one solution for each parameter"), is_whole.clone()?)?;
    }
    d.argue(
        "On each piece Krawczyk's test holds for every value of the parameter: one solution in a tube, with a regular \
         derivative, so that it is an analytic function of the parameter. At a node the solution lies in the tubes on \
         both sides, where there is no other. The enclosures of the landmarks lie in the first and the last tube.",
    )?;
    d.argue(
        "The lines, with the edges phi = 0, phi = pi/2, eta = 0 and eta = 2, close a loop around each domain, and each \
         line is a side of its two modes: so the corners are where the lines end.",
    )
}
