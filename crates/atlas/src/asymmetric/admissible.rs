//! Proof that each state of a part of a branch is admissible at every joint of the whole arch, with rates
//! that are not negative.
//!
//! A tube is halved until all states over the vertical forces `v` of a half are decided at once:
//!
//! 1. **Signs.** The left sides of the two equations that other kinds close by are not negative: as balls, or, next
//!    to the end at which one is zero, by the sign of its slope along the curve. So is the rate that closes the
//!    motion; of the hinges that fit alone it is zero.
//! 2. **Sliding.** With `v >= 0` and `N > 0` the force on a joint is inclined by `atan((beta -+ v)/h) - beta`, `-`
//!    on the right. Inwards that is largest where `h = cos² chi`: on the left it is no more than `phi` where `phi -
//!    chi + sin chi cos chi - v >= 0`, and on the right less by `2 v`. Outwards, for `v² < h - h²`, it is least at
//!    an end: at the right springing, which slides, or in the crown, where `v cos phi <= h sin phi` is enough.
//! 3. **Faces.** The distance from the extrados on the left is that on the right and `(2 + eta) v sin beta`; from the
//!    intrados on the right, that on the left and `(2 - eta) v sin beta`. So one half is enough for each: it is
//!    covered by balls, but next to the hinge, where the curvature is positive, and next to the right springing,
//!    where the slope falls to what is known not to be negative.
//!
//! Each is said of all `v` between two nodes, so that nothing is left out.

use super::super::cell::TubeCell;
use super::super::cubic::exact;
use super::super::form::CurveForm;
use super::super::law::Law;
use super::super::trace::pieces_of;
use super::super::walk::Walk;
use super::meeting::Meeting;
use crate::arch::asymmetric::{Asymmetric, AsymmetricMode};
use crate::arch::mechanism::Contact;
use crate::arch::whole::{Side, carried, margin_along};
use crate::arch::{Ring, SelfWeight, statics};
use crate::certify::{Undecided, between, cover};
use crate::number::{Angle, Ball, Enclosure, Field, Jet};
use crate::prover::decide::{ensure, is_positive};
use crate::prover::halve::halve;
use rug::{Float, Rational};

/// A tube is halved no more often than this, and the vertical forces of one in it.
const DEPTH: u32 = 8;
const SLICES: u32 = 4;
/// The neighbourhood of a joint is halved no more often than this.
const HALVINGS: u32 = 20;
/// Bits of what covers the arch.
const BITS: u32 = 64;

/// Proves it of the whole of a walk, from one end to the other.
pub(super) fn is_admissible(
    kind: AsymmetricMode,
    form: &CurveForm,
    walk: &Walk,
    [low, high]: [&Meeting; 2],
) -> Result<(), Undecided> {
    let count = walk.tubes.len();
    pieces_of(form, walk).enumerate().try_for_each(|(index, piece)| {
        let [from, to] = piece.range();
        let gap = || Undecided::new(format!("not proved between v = {from} and {to}"));
        let cell = TubeCell::new(&piece).ok_or_else(gap)?;
        // The ends are in the first tube and in the last.
        let ends = [(index == 0).then_some(low), (index + 1 == count).then_some(high)];
        halve(Slice { kind, cell, ends }, DEPTH, Slice::halves, Slice::is_admissible).map(drop)
    })
}

/// All states between two vertical forces, in a tube.
struct Slice<'a> {
    kind: AsymmetricMode,
    cell: TubeCell<'a>,
    /// The ends of the walk that are in it, that of the smaller vertical force first.
    ends: [Option<&'a Meeting>; 2],
}

/// Quantity that is not negative on an admissible branch.
#[derive(Clone, Copy)]
enum OpenSign {
    /// The left side of an equation that another kind closes by.
    Law(Law),
    /// The rate of the joint that closes the motion.
    Rate,
}

impl OpenSign {
    /// The equation that holds where it is zero.
    fn zero(self) -> Law {
        match self {
            Self::Law(law) => law,
            Self::Rate => Law::HingesFit,
        }
    }
}

impl Slice<'_> {
    /// Halves of it, each in a tube of its own.
    fn halves(&self) -> Option<[Self; 2]> {
        let &Self { kind, ref cell, ends: [low, high] } = self;
        let [first, last] = cell.halves()?;
        Some([
            Self { kind, cell: first, ends: [low, None] },
            Self { kind, cell: last, ends: [None, high] },
        ])
    }

    /// Checks admissibility in one tube.
    fn is_admissible(&self) -> Result<(), Undecided> {
        let halves = |&[from, to]: &[f64; 2]| {
            let middle = from + (to - from) / 2.0;
            Some([[from, middle], [middle, to]])
        };
        let proof = |&[from, to]: &[f64; 2]| {
            let found = self.is_admissible_on(&exact(from).hull(&exact(to)));
            found.map_err(|open| open.about(&format!("between v = {from} and {to}")))
        };
        halve(self.cell.range(), SLICES, halves, proof).map(drop)
    }

    /// Checks admissibility at once for some vertical forces.
    fn is_admissible_on(&self, s: &Ball) -> Result<(), Undecided> {
        let TubeCell { form, tube, .. } = &self.cell;
        let spot = form.spot(&few, s, &tube.enclosure(s));
        let at = spot.asymmetric();
        self.signs(s, at)?;
        let (h, v, phi) = (&at.forces.thrust, &at.forces.vertical, &spot.friction_angle);
        let above = h.int(1) - h;
        ensure(is_positive(h) && is_positive(&above), "0 < h < 1")?;
        let shoulder = Angle::new(spot.half_opening.clone() - phi);
        let is_steep = is_positive(&shoulder.sin) && is_positive(&shoulder.cos);
        ensure(is_positive(phi) && is_steep, "0 < alpha - phi < pi/2")?;
        ensure(is_positive(&(above * h - v.square())), "v² < h - h²")?;
        let room = h.clone() * &at.grip.normal - v.clone() * &at.grip.shear;
        ensure(is_positive(&room), "v < mu h")?;
        is_between_the_faces(form.weight, at)
    }

    /// The signs that the equations of the kind leave open, and the order of the joints.
    fn signs(&self, s: &Ball, at: &Asymmetric<Ball>) -> Result<(), Undecided> {
        let eta = &at.thickness;
        ensure(is_positive(eta) && is_positive(&(eta.int(2) - eta)), "0 < eta < 2")?;
        let others = match self.kind {
            AsymmetricMode::InnerSliding => [OpenSign::Law(Law::ShoulderOpens), OpenSign::Rate],
            AsymmetricMode::ShoulderOpening => [OpenSign::Law(Law::InnerSlides), OpenSign::Rate],
            AsymmetricMode::ShoulderSliding => {
                [Law::InnerSlides, Law::ShoulderOpens].map(OpenSign::Law)
            }
        };
        for other in others {
            ensure(self.is_not_negative(other, s), "a sign at which the kind changes")?;
        }
        let slip = &at.motion(self.kind).0[0].rate;
        ensure(is_positive(slip), "whether the shoulder slides outwards")?;
        let Asymmetric { half_opening, crown_hinge, haunch, sliding_joint, .. } = at;
        // From the right springing to the left.
        let left = match self.kind {
            AsymmetricMode::InnerSliding => vec![-sliding_joint.rad.clone(), -haunch.rad.clone()],
            _ => vec![-haunch.rad.clone()],
        };
        let all: Vec<Ball> = [half_opening.rad.clone(), crown_hinge.rad.clone()]
            .into_iter()
            .chain(left)
            .chain([-half_opening.rad.clone()])
            .collect();
        let falls = all.windows(2).all(|pair| is_positive(&(pair[0].clone() - &pair[1])));
        ensure(falls, "in which order the joints are")
    }

    fn is_not_negative(&self, kept: OpenSign, s: &Ball) -> bool {
        if is_positive(self.along(kept, s, 0).value()) {
            return true;
        }
        // Zero at an end: it rises from the first, or falls to the last.
        self.ends.iter().zip([1, -1]).any(|(end, sign)| {
            let Some(end) = end.filter(|end| end.has(kept.zero())) else { return false };
            let whole = s.hull(&end.crossing.value(self.cell.form.parameter));
            is_positive(&(self.along(kept, &whole, 1).coefficient(1) * s.int(sign)))
        })
    }

    /// Margin of one of the states along the curve, with its slope.
    fn along(&self, kept: OpenSign, s: &Ball, order: usize) -> Jet<Ball> {
        let TubeCell { form, tube, .. } = &self.cell;
        let line = Jet::new(vec![s.clone(), s.int(1)], order);
        let pairs = tube.enclosure(s).into_iter().zip(&tube.slopes);
        let x: Vec<Jet<Ball>> =
            pairs.map(|(x, slope)| Jet::new(vec![x, slope.clone()], order)).collect();
        let number = |given: &Ball| Jet::constant(few(given), order);
        match kept {
            OpenSign::Law(law) => form.residual(law, &number, &line, &x),
            OpenSign::Rate => {
                let spot = form.spot(&number, &line, &x);
                let place = if self.kind == AsymmetricMode::InnerSliding { 2 } else { 1 };
                spot.asymmetric().motion(self.kind).0.swap_remove(place).rate
            }
        }
    }
}

fn few(given: &Ball) -> Ball {
    given.with_precision(BITS)
}

/// The third statement above.
fn is_between_the_faces(weight: SelfWeight, at: &Asymmetric<Ball>) -> Result<(), Undecided> {
    let ring = Ring::new(weight, &at.thickness);
    let series = |contact, side: Side, joint: &Ball| {
        let joint = side.joint(&Angle::new(joint.clone()));
        margin_along(contact, &joint, &ring, &at.grip, &at.forces)
    };
    let extrados = |joint: &Ball| series(Contact::Extrados, Side::Right, joint);
    let intrados = |joint: &Ball| series(Contact::Intrados, Side::Left, joint);
    let alpha = &at.half_opening.rad;
    let [springing, end] = [rational(&alpha.lower())?, rational(&alpha.upper())?];
    let falls = |width: &Rational| {
        let near = between(&Rational::from(&springing - width), &end);
        is_positive(&-extrados(&near).coefficient(1))
    };
    let width = widest(falls).ok_or_else(|| Undecided::new("a slope at the springing"))?;
    let before = springing - width;
    is_not_negative(&at.crown_hinge.rad, &before, &extrados)
        .map_err(|open| open.about("the distance from the extrados"))?;
    is_not_negative(&at.haunch.rad, &end, &intrados)
        .map_err(|open| open.about("the distance from the intrados"))?;
    let zero = Rational::new();
    let normal = |joint: &Ball| {
        let joint = carried(&Angle::new(joint.clone()), &at.forces.vertical);
        statics::normal_force(&joint, &at.forces.thrust).is_positive()
    };
    cover(&zero, &end, &normal).map_err(|open| open.about("the normal force"))?;
    Ok(())
}

/// The widest of some neighbourhoods for which a statement holds.
fn widest(holds: impl Fn(&Rational) -> bool) -> Option<Rational> {
    (2..HALVINGS).map(|k| Rational::from((1, 1i32 << k))).find(holds)
}

fn rational(x: &Float) -> Result<Rational, Undecided> {
    x.to_rational().ok_or_else(|| Undecided::new("a joint is not bounded"))
}

/// Proves that a margin is not negative from the crown up to an angle: it is zero at a hinge, with its slope,
/// and is curved upwards next to it.
fn is_not_negative(
    hinge: &Ball,
    end: &Rational,
    series: &dyn Fn(&Ball) -> Jet<Ball>,
) -> Result<(), Undecided> {
    let [low, high] = [rational(&hinge.lower())?, rational(&hinge.upper())?];
    let bends = |width: &Rational| {
        let near = between(&Rational::from(&low - width), &Rational::from(&high + width));
        is_positive(&series(&near).coefficient(2))
    };
    let width =
        widest(bends).ok_or_else(|| Undecided::new("a hinge is not told from its sides"))?;
    let margin = |piece: &Ball| {
        let middle = series(&piece.midpoint());
        let (offset, bend) = (piece.centred(), series(piece).coefficient(2));
        (middle.coefficient(1) * &offset + middle.value() + bend * offset.square()).is_positive()
    };
    let zero = Rational::new();
    let sides = [(zero, low - &width), (high + &width, end.clone())];
    sides
        .iter()
        .filter(|(from, to)| from < to)
        .try_for_each(|(from, to)| cover(from, to, &margin).map(drop))
}

#[cfg(test)]
mod tests {
    use super::super::super::walk::walk;
    use super::super::branch::Branch;
    use super::super::kind::over_vertical_force;
    use super::*;
    use AsymmetricMode::{InnerSliding, ShoulderOpening, ShoulderSliding};

    /// Where a kind goes on beyond its ends its solutions are none of (19), and are refused.
    #[test]
    fn beyond_its_ends_a_kind_is_refused() {
        let half_opening: crate::number::ExactNumber = "2.3".parse().unwrap();
        let branch = Branch::new(SelfWeight::Milankovitch, &half_opening, 1e-3).unwrap();
        let (first, _) = &branch.stretches[0];
        let (change, _) = &branch.stretches[1];
        let alpha: Ball = half_opening.enclosure(128);
        let v = change.crossing.value(super::super::super::variable::Variable::VerticalForce);
        let v = v.mid().to_f64();
        let decided = |kind, [from, to]: [f64; 2]| {
            let form = over_vertical_force(kind, SelfWeight::Milankovitch, &alpha);
            let start =
                form.unknowns.iter().map(|x| change.crossing.value(*x).mid().to_f64()).collect();
            let walk = walk(&form, from, start, (to, to), 1e-3).unwrap();
            is_admissible(kind, &form, &walk, [first, first])
        };
        let refused = |kind, range: [f64; 2]| {
            decided(kind, range).err().map_or_else(String::new, |open| open.reason.into_owned())
        };
        assert_eq!(refused(InnerSliding, [0.9 * v, 0.99 * v]), "");
        assert_eq!(refused(ShoulderOpening, [0.9 * v, 0.99 * v]), "");
        let sign = "a sign at which the kind changes";
        assert!(refused(InnerSliding, [1.01 * v, 1.1 * v]).contains(sign), "the shoulder");
        assert!(refused(ShoulderOpening, [1.01 * v, 1.1 * v]).contains(sign), "a joint inside");
        assert!(refused(ShoulderSliding, [0.9 * v, 0.99 * v]).contains(sign), "no such state");
        // Up to the very change no ball tells the sign.
        assert!(refused(InnerSliding, [0.9 * v, v]).contains(sign), "the end is not told");
    }
}
