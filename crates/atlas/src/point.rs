//! A point of a curve at an exact parameter, to any number of digits.

use super::crossing::in_tube;
use super::curve::Curve;
use super::end::EndValues;
use super::form::{CurveForm, Thrust};
use super::place::Place;
use super::trace::{leg_to, pieces_of};
use super::variable::Variable;
use crate::arch::SelfWeight;
use crate::certify::{Refused, Undecided};
use crate::number::{Ball, Enclosure, ExactNumber, Rounded, bits_of, says};
use crate::problem::Quantity;

/// Reason why there is no point at a parameter.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum NoPoint {
    /// The parameter is not strictly between those of the ends.
    Outside {
        /// The name of the parameter.
        name: &'static str,
        /// Value that was asked for.
        parameter: String,
        /// About where the curve begins.
        low: f64,
        /// About where it ends.
        high: f64,
    },
    /// The question makes no sense.
    Refused(Refused),
    /// The proof fails, or a rounding stays open.
    Undecided(Undecided),
}

says!(NoPoint {
    Self::Outside { name, parameter, low, high } =>
        "{name} {parameter} is not on the curve, where it is between {low:.6} and {high:.6}";
} from {
    Refused => Self::Refused;
    Undecided => Self::Undecided;
});

/// Bits beyond the digits asked for, doubled as often as a rounding stays open.
const GUARD: u32 = 48;
const ATTEMPTS: u32 = 6;

/// The quantities of the point of a curve at an exact parameter, strictly between those of its ends, each correctly
/// rounded to `digits` significant digits, up to [`MAX_DIGITS`](crate::certify::MAX_DIGITS). What the curve fixes,
/// as the thickness 2 of its limit, is left out, as is what was given. That the point is on the curve, and not on
/// another branch, is proved by the tube around it, the last one of a chain from the nearer end.
pub fn point(
    curve: Curve,
    weight: SelfWeight,
    parameter: &ExactNumber,
    digits: usize,
) -> Result<Vec<(Quantity, Rounded)>, NoPoint> {
    Refused::digits(digits)?;
    let exactly = |bits: u32| parameter.enclosure::<Ball>(bits);
    let s = exactly(256);
    let ends = EndValues::both(curve.ends(), weight)?;
    let [low, high] = ends.each_ref().map(|end| end.value(curve.parameter()));
    if !low.is_less_than(&s).and(s.is_less_than(&high)).is_proved() {
        let [low, high] = [low, high].map(|end| end.mid().to_f64());
        let name = curve.parameter().name();
        return Err(NoPoint::Outside { name, parameter: parameter.to_string(), low, high });
    }
    let (form, walk) = leg_to(curve, weight, ends, &s)?;
    let piece = pieces_of(&form, &walk).last().filter(|piece| piece.is_over(&s));
    let tube = piece.and_then(|piece| piece.tube);
    let tube = tube.ok_or_else(|| Undecided::new("the curve is not proved at this parameter"))?;
    for attempt in 0..ATTEMPTS {
        let bits = bits_of(digits) + (GUARD << attempt);
        let place = in_tube(&form, tube, &exactly(bits), bits)?;
        let rounded = asked(&form, &place)
            .into_iter()
            .map(|(quantity, ball)| Some((quantity, Rounded::from_ball(&ball, digits)?)));
        if let Some(all) = rounded.collect() {
            return Ok(all);
        }
    }
    Err(Undecided::rounding("a rounding is not decided").into())
}

/// The quantities that are neither given nor fixed.
fn asked(form: &CurveForm, place: &Place) -> Vec<(Quantity, Ball)> {
    let is_found = |variable| form.unknowns.contains(&variable);
    let slides_inside = form.thrust == Thrust::Sliding;
    let all = [
        (Quantity::HalfOpening, &place.half_opening, is_found(Variable::HalfOpening)),
        (Quantity::FrictionAngle, &place.friction_angle, is_found(Variable::FrictionAngle)),
        (Quantity::Friction, &place.friction, is_found(Variable::FrictionAngle)),
        (Quantity::Thickness, &place.thickness, is_found(Variable::Thickness)),
        (Quantity::Thrust, &place.thrust, form.thrust != Thrust::Zero),
        (Quantity::RotationJoint, &place.rotation_joint, form.has_haunch()),
        (Quantity::SlidingJoint, &place.sliding_joint, slides_inside),
    ];
    let known = all.into_iter().filter(|(.., is_found)| *is_found);
    known.filter_map(|(quantity, value, _)| Some((quantity, value.clone()?))).collect()
}

#[cfg(test)]
mod tests {
    use super::super::trace::Trace;
    use super::*;

    fn at(
        curve: &str,
        parameter: &str,
        digits: usize,
    ) -> Result<Vec<(Quantity, Rounded)>, NoPoint> {
        let curve = Curve::named(curve).unwrap();
        point(curve, SelfWeight::Milankovitch, &parameter.parse().unwrap(), digits)
    }

    #[test]
    fn a_point_of_rotation_is_the_state_of_its_arch() {
        use couplet_prove::prelude::{Arch, Certify};
        let arch = Arch::parse("milankovitch", "80deg", "inf").unwrap();
        let state = arch.least(40).unwrap();
        let found = at("rotation", "80deg", 40).unwrap();
        let of = |quantity| found.iter().find(|(q, _)| *q == quantity).unwrap().1.value.to_string();
        assert_eq!(of(Quantity::Thickness), state.thickness.to_string());
        assert!(
            found.iter().all(|(quantity, _)| *quantity != Quantity::HalfOpening),
            "it is given"
        );
    }

    /// From either end, and next to it: the points are those of the curve that is proved from end to end.
    #[test]
    fn every_curve_has_points() {
        for curve in Curve::ALL {
            let trace = Trace::new(curve, SelfWeight::Heyman, 1e-3).unwrap();
            let [low, high] = trace.parameters().clone().map(|end| end.mid().to_f64());
            for share in [0.001, 0.3, 0.49, 0.51, 0.8, 0.999] {
                let at: ExactNumber = format!("{:.6}", low + share * (high - low)).parse().unwrap();
                let [few, many] =
                    [10, 50].map(|digits| point(curve, SelfWeight::Heyman, &at, digits).unwrap());
                let s = at.enclosure(128);
                let (form, tube) = trace.tube_at(&s).unwrap();
                let there = asked(form, &Place::new(form, &s, &tube.enclosure(&s)));
                assert!(!few.is_empty() && few.len() == there.len(), "{curve} {at}");
                for (((quantity, few), (_, many)), (_, there)) in few.iter().zip(&many).zip(&there)
                {
                    let [few, many] =
                        [few, many].map(|found| found.value.to_string().parse::<f64>().unwrap());
                    approx::assert_relative_eq!(few, many, max_relative = 1e-9);
                    let off = (many - there.mid().to_f64()).abs();
                    assert!(
                        few > 0.0 && off <= 1e-15 + there.rad().to_float().to_f64(),
                        "{curve} {quantity:?} {at}"
                    );
                }
            }
        }
    }

    #[test]
    fn no_digits_are_refused() {
        let error = at("rotation", "1", 0).unwrap_err();
        assert!(matches!(error, NoPoint::Refused(Refused::Digits { asked: 0, .. })), "{error}");
    }

    #[test]
    fn outside_there_is_no_point() {
        for parameter in ["0", "-1", "2.9", "pi"] {
            let error = at("rotation", parameter, 10).unwrap_err();
            assert!(matches!(error, NoPoint::Outside { .. }), "{parameter}: {error}");
        }
        assert!(matches!(at("limit", "pi/2", 10), Err(NoPoint::Outside { .. })), "an end");
    }
}
