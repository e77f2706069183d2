//! The lines of the map as curves: each one arc from landmark to landmark.

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
    lemmas(d, ["eq-18-cycloid", "eq-17-angles"])?;
    for (words, is_whole) in traced() {
        d.proved_elsewhere(format!("{words}: one solution for each parameter"), is_whole.clone()?)?;
    }
    d.theorems(["Map.pieces_are_one"])?;
    d.conclude(
        "Krawczyk's test holds at each parameter, with a regular derivative: a line is analytic. A node is in both \
         tubes, landmarks in first or last. Lines and edges close loops around the domains: corners are their ends.",
    )
}
