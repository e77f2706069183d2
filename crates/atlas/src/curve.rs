//! The curves of the map, with their ends and their equations.
//!
//! | curve | equations | parameter | from – to |
//! |---|---|---|---|
//! | rotation | (2), (4), (5) | `alpha` | origin – l |
//! | overturning | (4), `h = 0` | `eta` | l – L |
//! | sliding | (17), (18) | `chi` | origin – `alpha = pi` |
//! | `[r,r,r]/[s,r,r]` | (2), (4), (5), (17) | `alpha` | origin – T |
//! | `[s,r,r]/[s,s]` | (2), (5), (17), (18) | `chi` | origin – T |
//! | `[r,r,r]/[r,r,s]` | (2), (4), (5), (18) | `chi` | T – l |
//! | `[r,r,s]/[s,s]`, `[r,s,r]/[s,s]` | (3), (5), (17), (18) | `chi` | T – S – J |
//! | `[r,s]/[s,s]` | (3), (17), (18), `beta_r = 0` | `eta` | J – B |
//! | `[r,r,s]/[r,s,r]` | (3), (5), (18), `beta_r = beta_s` | `chi` | S – l |
//! | `[r,s,r]/[r,s]` | (3), (5), (18), `beta_r = 0` | `chi` | J – l |
//! | limit: `[r,s]` at `eta = 2` | (3), (18), `beta_r = 0` | `chi` | B – L |
//!
//! `chi` is the inclination of the force on the inner joint that slides.

use super::end::CurveEnd;
use super::form::{CurveForm, FixedJoint, Thrust};
use super::law::Law;
use super::variable::Variable;
use crate::arch::SelfWeight;
use crate::number::list;
use crate::problem::Line;
use std::fmt;

/// A curve of the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Curve {
    /// The purely rotational states; their friction is any from `[r,r,r]/[s,r,r]` or `[r,r,r]/[r,r,s]` on.
    Rotation,
    /// The purely overturning states, at unlimited friction.
    Overturning,
    /// The purely sliding states; their thickness is any from that of their line on.
    Sliding,
    /// The line where one mode becomes another.
    Line(Line),
    /// The overturning-sliding states at the physical limit, `eta = 2`: beyond it no thickness is enough.
    Limit,
}

/// A part of a curve on which one form of its equations is used.
#[derive(Clone, Debug)]
pub(super) struct Leg {
    pub form: CurveForm,
    /// Parameter at which it begins and ends, if not at the ends of the curve.
    pub from: Option<f64>,
    pub to: Option<f64>,
}

/// Up to this inclination the forms for flat arches are used, with squares of angles that are well in the
/// range of Stumpff's functions.
const FLAT: f64 = 0.375;

impl Leg {
    /// One form from end to end.
    fn whole(form: CurveForm) -> Vec<Self> {
        vec![Self { form, from: None, to: None }]
    }

    /// A form for flat arches first, then another one.
    fn two(flat: CurveForm, other: CurveForm) -> Vec<Self> {
        let flat = Self { form: flat, from: None, to: Some(FLAT) };
        vec![flat, Self { form: other, from: Some(FLAT), to: None }]
    }
}

impl Curve {
    /// All curves.
    pub const ALL: [Self; 12] = [
        Self::Rotation,
        Self::Overturning,
        Self::Sliding,
        Self::Line(Line::RotationShoulder),
        Self::Line(Line::ShoulderEnd),
        Self::Line(Line::RotationInner),
        Self::Line(Line::AboveHaunchEnd),
        Self::Line(Line::BelowHaunchEnd),
        Self::Line(Line::CrownEnd),
        Self::Line(Line::Joints),
        Self::Line(Line::Crown),
        Self::Limit,
    ];

    /// Each curve of some weights, once: one that is the same for every weight is of the first.
    pub fn of_weights(weights: &[SelfWeight]) -> Vec<(SelfWeight, Self)> {
        let is_new =
            |weight, curve: Self| !curve.is_weightless() || weights.first() == Some(weight);
        let of = |weight| {
            let new = Self::ALL.into_iter().filter(move |curve| is_new(weight, *curve));
            new.map(move |curve| (*weight, curve))
        };
        weights.iter().flat_map(of).collect()
    }

    /// The curve of a name: `rotation`, or two modes that meet, as [`Line`] reads them.
    pub fn named(name: &str) -> Option<Self> {
        let named = |curve: &Self| curve.to_string().eq_ignore_ascii_case(name.trim());
        Self::ALL.into_iter().find(named).or_else(|| name.parse().ok().map(Self::Line))
    }

    /// Parameters at which it begins and ends, in the direction in which its parameter grows or falls.
    pub fn ends(self) -> [CurveEnd; 2] {
        use crate::problem::Landmark as L;
        match self {
            Self::Rotation => [CurveEnd::Origin, CurveEnd::Landmark(L::RotationEnd)],
            Self::Overturning => [L::RotationEnd, L::OverturningEnd].map(CurveEnd::Landmark),
            Self::Sliding => [CurveEnd::Origin, CurveEnd::Circle],
            Self::Line(line) => {
                line.ends().map(|end| end.map_or(CurveEnd::Origin, CurveEnd::Landmark))
            }
            Self::Limit => [L::Border, L::OverturningEnd].map(CurveEnd::Landmark),
        }
    }

    /// Parameter by which it is traced.
    pub fn parameter(self) -> Variable {
        match self {
            Self::Rotation | Self::Line(Line::RotationShoulder) => Variable::HalfOpening,
            Self::Overturning | Self::Line(Line::CrownEnd) => Variable::Thickness,
            _ => Variable::Inclination,
        }
    }

    /// Tells whether the curve is the same for every weight: sliding does not see the thickness.
    pub fn is_weightless(self) -> bool {
        self == Self::Sliding
    }

    /// Equations of the curve, part by part.
    pub(super) fn legs(self, weight: SelfWeight) -> Vec<Leg> {
        use {Law as L, Variable as V};
        let form = |unknowns, laws| CurveForm::new(weight, self.parameter(), unknowns, laws);
        let touching =
            |unknowns, laws| CurveForm { thrust: Thrust::Tangent, ..form(unknowns, laws) };
        const OPENING_ANGLE: &[Variable] = &[V::HalfOpening, V::FrictionAngle];
        const ALL: &[Variable] = &[V::HalfOpening, V::FrictionAngle, V::JointSquare, V::Thickness];
        match self {
            Self::Rotation => Leg::whole(touching(
                &[V::JointSquare, V::Thickness],
                &[L::Rotation, L::WholeTangency],
            )),
            Self::Overturning => {
                let form = form(&[V::HalfOpening], &[L::Whole]);
                Leg::whole(CurveForm { thrust: Thrust::Zero, ..form })
            }
            Self::Sliding => {
                const FLAT: &[Variable] = &[V::Ratio, V::HalfOpening, V::FrictionAngle];
                let flat = form(FLAT, &[L::FlatShoulder, L::Ratio, L::Cycloid]);
                Leg::two(flat, form(OPENING_ANGLE, &[L::Shoulder, L::Cycloid]))
            }
            Self::Line(Line::RotationShoulder) => Leg::whole(touching(
                &[V::JointSquare, V::Thickness, V::FrictionAngle],
                &[L::Rotation, L::WholeTangency, L::Shoulder],
            )),
            Self::Line(Line::ShoulderEnd) => Leg::two(
                form(
                    &[V::Ratio, V::HalfOpening, V::FrictionAngle, V::JointSquare, V::Thickness],
                    &[L::FlatShoulder, L::Ratio, L::Cycloid, L::Tangency, L::Touching],
                ),
                form(ALL, &[L::Shoulder, L::Cycloid, L::Tangency, L::Touching]),
            ),
            Self::Line(Line::RotationInner) => {
                Leg::whole(form(ALL, &[L::Whole, L::Cycloid, L::Tangency, L::TouchingRoot]))
            }
            Self::Line(Line::AboveHaunchEnd | Line::BelowHaunchEnd) => {
                Leg::whole(form(ALL, &[L::Shoulder, L::Cycloid, L::Tangency, L::Upper]))
            }
            Self::Line(Line::CrownEnd) => Leg::whole(form(
                &[V::HalfOpening, V::FrictionAngle, V::Inclination],
                &[L::Shoulder, L::Cycloid, L::Upper],
            )),
            Self::Line(line @ (Line::Joints | Line::Crown)) => {
                const UNKNOWNS: &[Variable] = &[V::HalfOpening, V::FrictionAngle, V::Thickness];
                let joint =
                    if line == Line::Joints { FixedJoint::Sliding } else { FixedJoint::Crown };
                let form = form(UNKNOWNS, &[L::Upper, L::Cycloid, L::Tangency]);
                Leg::whole(CurveForm { joint, ..form })
            }
            Self::Limit => Leg::whole(form(OPENING_ANGLE, &[L::Upper, L::Cycloid])),
        }
    }

    /// Equations of the curve with the inclination as the parameter, of a line: to it belongs one friction
    /// angle, whatever slides.
    pub(super) fn legs_over_inclination(self, weight: SelfWeight) -> Vec<Leg> {
        use {Law as L, Variable as V};
        let form = |unknowns, laws| CurveForm::new(weight, V::Inclination, unknowns, laws);
        let touching =
            |unknowns, laws| CurveForm { thrust: Thrust::Tangent, ..form(unknowns, laws) };
        match self {
            Self::Line(Line::RotationShoulder) => {
                let flat = touching(
                    &list![V: OpeningRatio HalfOpening FrictionAngle JointRatio JointSquare Thickness],
                    &list![L: FlatTurningShoulder OpeningRatio Cycloid FlatTurning JointRatio Rotation],
                );
                let other = touching(
                    &[V::HalfOpening, V::FrictionAngle, V::JointSquare, V::Thickness],
                    &[L::Shoulder, L::Cycloid, L::WholeTangency, L::Rotation],
                );
                Leg::two(flat, other)
            }
            Self::Line(Line::CrownEnd) => Leg::whole(form(
                &[V::HalfOpening, V::FrictionAngle, V::Thickness],
                &[L::Shoulder, L::Cycloid, L::Upper],
            )),
            _ => self.legs(weight),
        }
    }
}

impl fmt::Display for Curve {
    /// The name used in files and on the command line: `rotation`, `rrr/srr`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rotation => f.pad("rotation"),
            Self::Overturning => f.pad("overturning"),
            Self::Sliding => f.pad("sliding"),
            Self::Line(line) => line.fmt(f),
            Self::Limit => f.pad("limit"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_is_read_by_its_name() {
        for curve in Curve::ALL {
            assert_eq!(Curve::named(&curve.to_string()), Some(curve));
        }
        assert_eq!(Curve::named("[s,r,r]/[r,r,r]"), Some(Curve::Line(Line::RotationShoulder)));
        assert_eq!(Curve::named("Limit"), Some(Curve::Limit));
        assert_eq!(Curve::named("rrr"), None);
    }

    #[test]
    fn every_form_has_one_unknown_more_than_equations() {
        for curve in Curve::ALL {
            let legs = curve.legs(SelfWeight::Heyman);
            let others = curve.legs_over_inclination(SelfWeight::Heyman);
            for leg in legs.iter().chain(&others) {
                assert_eq!(leg.form.unknowns.len(), leg.form.laws.len(), "{curve}");
                assert!(!leg.form.unknowns.contains(&leg.form.parameter), "{curve}");
            }
            assert!(legs[0].from.is_none() && legs[legs.len() - 1].to.is_none());
            assert!(legs.windows(2).all(|pair| pair[0].to == pair[1].from), "{curve}");
        }
    }
}
