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

use super::end::End;
use super::form::{Form, Joint, Thrust};
use super::law::Law;
use super::variable::Variable;
use crate::arch::SelfWeight;
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
    /// Where one mode becomes another.
    Line(Line),
    /// The overturning-sliding states at the physical limit, `eta = 2`: beyond it no thickness is enough.
    Limit,
}

/// A part of a curve on which one form of its equations is used.
#[derive(Clone, Debug)]
pub(super) struct Leg {
    pub form: Form,
    /// Where it begins and ends, if not at the ends of the curve.
    pub from: Option<f64>,
    pub to: Option<f64>,
}

/// Up to this inclination the forms for flat arches are used, with squares of angles that are well in the
/// range of Stumpff's functions.
const FLAT: f64 = 0.375;

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

    /// Where it begins and ends, in the direction in which its parameter grows or falls.
    pub fn ends(self) -> [End; 2] {
        use crate::problem::Landmark as L;
        match self {
            Self::Rotation => [End::Origin, End::Landmark(L::RotationEnd)],
            Self::Overturning => [L::RotationEnd, L::OverturningEnd].map(End::Landmark),
            Self::Sliding => [End::Origin, End::Circle],
            Self::Line(line) => line.ends().map(|end| end.map_or(End::Origin, End::Landmark)),
            Self::Limit => [L::Border, L::OverturningEnd].map(End::Landmark),
        }
    }

    /// What it is traced by.
    pub fn parameter(self) -> Variable {
        match self {
            Self::Rotation | Self::Line(Line::RotationShoulder) => Variable::HalfOpening,
            Self::Overturning | Self::Line(Line::CrownEnd) => Variable::Thickness,
            _ => Variable::Inclination,
        }
    }

    /// Whether it is the same for every weight: sliding does not see the thickness.
    pub fn is_weightless(self) -> bool {
        self == Self::Sliding
    }

    /// Its equations, part by part.
    pub(super) fn legs(self, weight: SelfWeight) -> Vec<Leg> {
        use {Law as L, Variable as V};
        let form = |unknowns, laws, thrust, joint| Form {
            weight,
            parameter: self.parameter(),
            unknowns,
            laws,
            thrust,
            joint,
            given: None,
        };
        let whole = |unknowns, laws, thrust, joint| {
            vec![Leg { form: form(unknowns, laws, thrust, joint), from: None, to: None }]
        };
        // A form for flat arches first.
        let two = |flat: (&'static [V], &'static [L]), other: (&'static [V], &'static [L])| {
            let form = |(unknowns, laws)| form(unknowns, laws, Thrust::Sliding, Joint::Crown);
            vec![
                Leg { form: form(flat), from: None, to: Some(FLAT) },
                Leg { form: form(other), from: Some(FLAT), to: None },
            ]
        };
        const OPENING_ANGLE: &[Variable] = &[V::HalfOpening, V::FrictionAngle];
        const ALL: &[Variable] = &[V::HalfOpening, V::FrictionAngle, V::JointSquare, V::Thickness];
        match self {
            Self::Rotation => whole(
                &[V::JointSquare, V::Thickness],
                &[L::Rotation, L::WholeTangency],
                Thrust::Tangent,
                Joint::Crown,
            ),
            Self::Overturning => whole(&[V::HalfOpening], &[L::Whole], Thrust::Zero, Joint::Crown),
            Self::Sliding => two(
                (
                    &[V::Ratio, V::HalfOpening, V::FrictionAngle],
                    &[L::FlatShoulder, L::Ratio, L::Cycloid],
                ),
                (OPENING_ANGLE, &[L::Shoulder, L::Cycloid]),
            ),
            Self::Line(Line::RotationShoulder) => whole(
                &[V::JointSquare, V::Thickness, V::FrictionAngle],
                &[L::Rotation, L::WholeTangency, L::Shoulder],
                Thrust::Tangent,
                Joint::Crown,
            ),
            Self::Line(Line::ShoulderEnd) => two(
                (
                    &[V::Ratio, V::HalfOpening, V::FrictionAngle, V::JointSquare, V::Thickness],
                    &[L::FlatShoulder, L::Ratio, L::Cycloid, L::Tangency, L::Touching],
                ),
                (ALL, &[L::Shoulder, L::Cycloid, L::Tangency, L::Touching]),
            ),
            Self::Line(Line::RotationInner) => whole(
                ALL,
                &[L::Whole, L::Cycloid, L::Tangency, L::TouchingRoot],
                Thrust::Sliding,
                Joint::Crown,
            ),
            Self::Line(Line::AboveHaunchEnd | Line::BelowHaunchEnd) => whole(
                ALL,
                &[L::Shoulder, L::Cycloid, L::Tangency, L::Upper],
                Thrust::Sliding,
                Joint::Crown,
            ),
            Self::Line(Line::CrownEnd) => whole(
                &[V::HalfOpening, V::FrictionAngle, V::Inclination],
                &[L::Shoulder, L::Cycloid, L::Upper],
                Thrust::Sliding,
                Joint::Crown,
            ),
            Self::Line(line @ (Line::Joints | Line::Crown)) => whole(
                &[V::HalfOpening, V::FrictionAngle, V::Thickness],
                &[L::Upper, L::Cycloid, L::Tangency],
                Thrust::Sliding,
                if line == Line::Joints { Joint::Sliding } else { Joint::Crown },
            ),
            Self::Limit => {
                whole(OPENING_ANGLE, &[L::Upper, L::Cycloid], Thrust::Sliding, Joint::Crown)
            }
        }
    }

    /// Its equations with the inclination as the parameter, of a line: to it belongs one friction angle, whatever slides.
    pub(super) fn legs_over_inclination(self, weight: SelfWeight) -> Vec<Leg> {
        use {Law as L, Variable as V};
        let form = |unknowns, laws, thrust| Form {
            weight,
            parameter: V::Inclination,
            unknowns,
            laws,
            thrust,
            joint: Joint::Crown,
            given: None,
        };
        match self {
            Self::Line(Line::RotationShoulder) => {
                let flat = form(
                    &[
                        V::OpeningRatio,
                        V::HalfOpening,
                        V::FrictionAngle,
                        V::JointRatio,
                        V::JointSquare,
                        V::Thickness,
                    ],
                    &[
                        L::FlatTurningShoulder,
                        L::OpeningRatio,
                        L::Cycloid,
                        L::FlatTurning,
                        L::JointRatio,
                        L::Rotation,
                    ],
                    Thrust::Tangent,
                );
                let other = form(
                    &[V::HalfOpening, V::FrictionAngle, V::JointSquare, V::Thickness],
                    &[L::Shoulder, L::Cycloid, L::WholeTangency, L::Rotation],
                    Thrust::Tangent,
                );
                vec![
                    Leg { form: flat, from: None, to: Some(FLAT) },
                    Leg { form: other, from: Some(FLAT), to: None },
                ]
            }
            Self::Line(Line::CrownEnd) => {
                let form = form(
                    &[V::HalfOpening, V::FrictionAngle, V::Thickness],
                    &[L::Shoulder, L::Cycloid, L::Upper],
                    Thrust::Sliding,
                );
                vec![Leg { form, from: None, to: None }]
            }
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
