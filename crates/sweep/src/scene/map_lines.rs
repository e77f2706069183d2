//! Lines that a map shows, asked by a command or by a scene.

use crate::arch::SelfWeight;
use crate::atlas::{Contour, Curve};
use crate::report::{MapAsked, Plane};

/// The curves and the contours of a map of some weights: those that are named; all curves where nothing is, and in a
/// map that is drawn the usual contours of its plane, in a page those of every plane.
pub fn map_lines(
    asked: &MapAsked,
    weights: &[SelfWeight],
    curves: &[Curve],
    contours: Vec<Contour>,
) -> (Vec<(SelfWeight, Curve)>, Vec<Contour>) {
    let MapAsked { format, lines, bare, asymmetric, .. } = *asked;
    let is_drawn = format.is_picture || format.is_page();
    let is_whole = curves.is_empty() && (is_drawn || contours.is_empty() && !asymmetric);
    let has_contours = is_drawn && is_whole && !lines && !bare;
    let planes = if format.is_page() { &Plane::ALL[..] } else { &[asked.plane()] };
    let contours = match has_contours && contours.is_empty() {
        true => planes.iter().flat_map(|plane| plane.contours()).collect(),
        false => contours,
    };
    let all = Curve::of_weights(weights).into_iter();
    (all.filter(|(_, curve)| is_whole || curves.contains(curve)).collect(), contours)
}
