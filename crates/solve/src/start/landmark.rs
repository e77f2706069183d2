//! Start values of the landmarks.

use crate::arch::SelfWeight;
use crate::problem::Landmark;

/// Start values of the unknowns of `landmark.system(weight)`, in its order.
///
/// Four digits of the paper's Tables 1–4; for `sb` of Heyman's weight, which the paper does not
/// give, of a scan of the roots of `f² - 2gS + S²`. They only choose the root: the proof that
/// follows shows which box holds exactly one.
pub fn landmark(landmark: Landmark, weight: SelfWeight) -> &'static [f64] {
    use {Landmark::*, SelfWeight::*};
    match (landmark, weight) {
        (Triple, Heyman) => &[2.487, 1.037, 0.2971, 0.6796, 0.09781, 1.415],
        (Triple, Milankovitch) => &[2.430, 1.043, 0.3187, 0.6183, 0.1148, 1.277],
        (Shift, Heyman) => &[2.600, 0.2516, 0.9534, 0.06792, 1.766],
        (Shift, Milankovitch) => &[2.531, 0.2797, 0.8735, 0.08555, 1.538],
        (Junction, Heyman) => &[2.603, 0.2503, 0.9652, 0.06718, 1.777],
        (Junction, Milankovitch) => &[2.534, 0.2786, 0.8872, 0.08480, 1.546],
        (Border, Heyman) => &[2.774, 0.1760, 0.03200, 2.690],
        (Border, Milankovitch) => &[2.623, 0.2420, 0.06249, 1.854],
        (RotationEnd, Heyman) => &[2.648, 1.000],
        (RotationEnd, Milankovitch) => &[2.591, 0.9282],
        (OverturningEnd, Heyman) => &[2.786],
        (OverturningEnd, Milankovitch) => &[2.648],
        (WidestJoint, Heyman) => &[2.230, 1.129, 0.4214, 0.2670],
        (WidestJoint, Milankovitch) => &[2.196, 1.120, 0.3976, 0.2777],
    }
}
