//! Drawing of an arch: at its least thickness, at a landmark, or as it stands.

use super::falling;
use super::forces::{forces_of_limit, forces_of_mode};
use super::stability::Stability;
use super::stones;
use super::{Collapse, Forces, Mark};
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::certify::state::{
    Fall, Figure, Outcome, assessment_enclosed, raised, sliding_configuration, state_enclosed,
};
use crate::certify::{CertifiedLandmark, Error, Refused, Undecided, asymmetric_thicknesses};
use crate::number::{Ball, Drawable, Enclosure, ExactNumber, Rounded, Ternary, says};
use crate::problem::stones::Stones;
use crate::problem::{Arch, Fixed, Landmark, Mode};
use crate::sketch::{NoCollapse, faces, joints_of};
use couplet_stones::{VoussoirStanding, Voussoirs, assess_voussoirs, voussoirs};

/// An arch to be drawn.
#[derive(Clone, Debug)]
pub struct Sketch {
    /// Subject of the drawing.
    pub subject: Subject,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// Half opening and thickness; joints, thrust and friction as far as they are known, else zero.
    pub at: Configuration<Ball>,
    /// True if the friction is limited.
    pub is_limited: bool,
    /// Stones of the arch, if its joints are between them alone.
    pub stones: Option<Stones>,
    /// The lines: of the state, of the least and the largest thrust, or of one with which it falls.
    pub forces: Vec<Forces>,
    /// Mechanisms in which the arch falls: in one mode, in several at once, or not at all.
    pub collapses: Vec<Collapse>,
}

/// Subject of a drawing.
#[derive(Clone, Debug)]
pub enum Subject {
    /// An arch at its least thickness.
    Least(Box<Arch>),
    /// A landmark.
    Landmark(Landmark),
    /// An arch of a given thickness.
    Standing {
        /// The arch.
        arch: Box<Arch>,
        /// Thickness of the arch as given.
        thickness: ExactNumber,
        /// Stability of the arch.
        stability: Box<Stability>,
        /// The thicknesses of its asymmetric solutions, if it stands and has a joint at every angle.
        asymmetric: Vec<Figure>,
        /// True if the thickness was not asked for, as none is enough.
        is_chosen: bool,
    },
    /// An arch of a given thickness at the friction at which it slides.
    Sliding {
        /// The arch, without its friction.
        arch: Box<Arch>,
        /// Thickness of the arch as given.
        thickness: ExactNumber,
    },
}

/// Reason why there is nothing to draw.
#[derive(Clone, Debug)]
pub enum NoSketch {
    /// The thickness or the stones are none.
    Refused(Refused),
    /// The proof did not succeed.
    Undecided(Undecided),
    /// An arch too thin to slide only.
    NoRoom,
    /// An arch of so few stones that it stands at every thickness.
    AnyThickness(u64),
    /// A keystone without a thrust on it.
    HangingKeystone(u64),
    /// A mode in which the arch does not fall.
    OtherMode(Mode, String),
    /// An arch so narrow that doubles do not resolve how its blocks move.
    TooNarrow(String),
    /// A half opening with which no arch stands.
    TooWide(String),
    /// A landmark without a friction.
    NoFriction(Landmark),
}

says!(NoSketch {
    Self::NoRoom =>
        "no line of thrust fits into an arch of this thickness that slides only: it has to be thicker";
    Self::AnyThickness(stones) =>
        "an arch of {stones} stones stands at every thickness: give --thickness, or more stones";
    Self::HangingKeystone(stones) =>
        "with unlimited friction the keystone of {stones} stones hangs where there is no thrust: give a limited \
         --friction, or an even number of stones";
    Self::OtherMode(asked, own) => "the arch does not fall as {asked}, but as {own}";
    Self::TooNarrow(alpha) =>
        "the half opening {alpha} is too small for a picture, which takes 1e-9 at least";
    Self::TooWide(alpha) => "no arch of the half opening {alpha} stands at a thickness up to 2";
    Self::NoFriction(landmark) =>
        "{} is a point of the purely rotational states, at no friction of its own", landmark.symbol();
} from {
    Refused => Self::Refused;
    Undecided => Self::Undecided;
});

/// The least half opening of a picture, rad: of smaller ones doubles do not tell how blocks move.
const LEAST: f64 = 1e-9;
/// Digits that are decided of every number: with so many a decimal number tells the double.
const DIGITS: usize = 17;

impl Sketch {
    /// An arch at its least thickness.
    pub fn least(arch: &Arch, is_dilatant: bool) -> Result<Self, NoSketch> {
        wide(arch)?;
        let found = raised(arch, DIGITS, |bits| {
            let state = match state_enclosed(arch, bits, false)? {
                Outcome::Falls(fall) => return Ok(Some(Err(fall))),
                Outcome::Stands(state) => state,
            };
            let at = falling::configuration(arch, &state, bits);
            let (weight, is_limited) = (arch.weight(), arch.is_limited());
            let subject = Subject::Least(Box::new(arch.clone()));
            Self::of_modes((subject, weight), at, is_limited, &[state.mode], is_dilatant)
                .map(|sketch| sketch.decided().map(Ok))
        })?;
        found.or_else(|fall| {
            let thickness = falling::shown_thickness(arch, fall)?;
            Ok(Self::standing(arch, &thickness, is_dilatant)?.with_chosen_thickness())
        })
    }

    /// Sketch of an arch whose thickness was not asked for.
    fn with_chosen_thickness(mut self) -> Self {
        if let Subject::Standing { is_chosen, .. } = &mut self.subject {
            *is_chosen = true;
        }
        self
    }

    /// A landmark, with each mechanism that is possible there.
    pub fn landmark(
        landmark: Landmark,
        weight: SelfWeight,
        is_dilatant: bool,
    ) -> Result<Self, NoSketch> {
        if landmark == Landmark::WidestJoint {
            return Err(NoSketch::NoFriction(landmark));
        }
        let refined = CertifiedLandmark::new(landmark, weight)?.enclosure(128)?;
        let is_limited = refined.value(Unknown::Friction).is_some();
        let at = refined.configuration().clone();
        let subject = (Subject::Landmark(landmark), weight);
        let sketch = Self::of_modes(subject, at, is_limited, &mechanisms(landmark), is_dilatant)?;
        Ok(sketch.decided().ok_or_else(|| Undecided::rounding("the rounding"))?)
    }

    /// An arch of a given thickness, in `(0, 2]`, as it stands, or as it falls if it does not.
    pub fn standing(
        arch: &Arch,
        thickness: &ExactNumber,
        is_dilatant: bool,
    ) -> Result<Self, NoSketch> {
        Refused::thickness(thickness)?;
        wide(arch)?;
        let asymmetric = asymmetric_thicknesses(arch, DIGITS)?;
        Ok(raised(arch, DIGITS, |bits| {
            let assessment = assessment_enclosed(arch, thickness, bits);
            let stability = Box::new(Stability::of_arch(&assessment)?);
            let eta: Ball = thickness.enclosure(bits);
            let mut at = arch.given(bits).with(Unknown::Thickness, eta.clone());
            let (weight, is_limited) = (arch.weight(), arch.is_limited());
            let (mut forces, mut collapses) = (Vec::new(), Vec::new());
            if !stability.stands {
                let found = falling::fallen(arch, &eta, bits, is_dilatant)?;
                at = found.0;
                forces.push(found.1);
                collapses.push(found.2);
            }
            for (limit, is_least) in assessment.thrust.iter().zip([true, false]) {
                if let Ok(Some(limit)) = limit {
                    forces.extend(forces_of_limit(weight, &at, is_limited, limit, is_least)?);
                }
            }
            let asymmetric = match stability.stands {
                true => asymmetric.clone(),
                false => Vec::new(),
            };
            let (arch, thickness) = (Box::new(arch.clone()), thickness.clone());
            let is_chosen = false;
            let subject = Subject::Standing { arch, thickness, stability, asymmetric, is_chosen };
            let stones = None;
            Ok(Self { subject, weight, at, is_limited, stones, forces, collapses }.decided())
        })?)
    }

    /// An arch of so many stones at the least thickness that these need.
    pub fn least_of_stones(arch: &Arch, stones: u64, is_dilatant: bool) -> Result<Self, NoSketch> {
        wide(arch)?;
        let all = Stones::equal(stones, arch.half_opening().clone()).map_err(Refused::from)?;
        let (weight, is_limited) = (arch.weight(), arch.is_limited());
        let state = match Error::apart(voussoirs(&all, weight, arch.friction(), stones::DIGITS))?? {
            Voussoirs::Stands(state) => state,
            Voussoirs::AnyThickness => return Err(NoSketch::AnyThickness(stones)),
            never @ (Voussoirs::Slides | Voussoirs::TooThick) => {
                let slides = matches!(never, Voussoirs::Slides);
                let fall = if slides { Fall::Sliding } else { Fall::Thickness };
                let thickness = falling::shown_thickness(arch, fall)?;
                let sketch = Self::standing_of_stones(arch, stones, &thickness, is_dilatant)?;
                return Ok(sketch.with_chosen_thickness());
            }
        };
        if state.mode == Mode::Overturning && !all.has_joint_at_crown() {
            return Err(NoSketch::HangingKeystone(stones));
        }
        let at = stones::state(arch, &all, &state);
        let open = |none: NoCollapse| Undecided::new(none.to_string());
        let collapse = Collapse::new(weight, state.mode, &at, is_dilatant).map_err(open)?;
        let moment = stones::moment((arch, &all), &at, state.contacts[1]);
        let joints = joints_of(state.mode, &at);
        let forces = Forces::new(
            weight,
            (&at, &stones::joints(&all)),
            is_limited,
            moment.as_slice(),
            joints,
        );
        let subject = Subject::Least(Box::new(arch.clone()));
        let (stones, forces, collapses) = (Some(all), vec![forces], vec![collapse]);
        let sketch = Self { subject, weight, at, is_limited, stones, forces, collapses };
        Ok(sketch.decided().ok_or_else(|| Undecided::new("the rounding"))?)
    }

    /// An arch of so many stones and a given thickness, in `(0, 2]`, as it stands, or as it falls if it does not.
    pub fn standing_of_stones(
        arch: &Arch,
        stones: u64,
        thickness: &ExactNumber,
        is_dilatant: bool,
    ) -> Result<Self, NoSketch> {
        wide(arch)?;
        let all = Stones::equal(stones, arch.half_opening().clone()).map_err(Refused::from)?;
        let (weight, is_limited) = (arch.weight(), arch.is_limited());
        let least = Error::apart(voussoirs(&all, weight, arch.friction(), stones::DIGITS))??;
        let found = assess_voussoirs(&all, weight, arch.friction(), thickness, stones::DIGITS)?;
        let stability = Stability::of_stones((&all, is_limited), &least, &found)?;
        let eta: Ball = thickness.enclosure(stones::BITS);
        let mut at = arch.given(stones::BITS).with(Unknown::Thickness, eta.clone());
        let (mut forces, mut collapses) = (Vec::new(), Vec::new());
        match &found.standing {
            Ok(VoussoirStanding::Stands(ends)) => {
                let ends = ends.iter().zip([true, false]);
                forces.extend(ends.filter_map(|(end, is_least)| {
                    stones::forces((arch, &all), &at, end, is_least)
                }));
            }
            // Few stones may fall in no mode that is known.
            Ok(VoussoirStanding::Falls(_)) => {
                let slides = matches!(least, Voussoirs::Slides);
                if let Ok(found) = falling::fallen_stones((arch, &all), &eta, slides, is_dilatant) {
                    at = found.0;
                    forces.push(found.1);
                    collapses.push(found.2);
                }
            }
            Err(_) => {}
        }
        let (arch, stability) = (Box::new(arch.clone()), Box::new(stability));
        let (thickness, asymmetric, is_chosen) = (thickness.clone(), Vec::new(), false);
        let subject = Subject::Standing { arch, thickness, stability, asymmetric, is_chosen };
        let stones = Some(all);
        let sketch = Self { subject, weight, at, is_limited, stones, forces, collapses };
        Ok(sketch.decided().ok_or_else(|| Undecided::new("the rounding"))?)
    }

    /// An arch of a given thickness at the friction at which it slides; the friction of the arch is not read.
    pub fn sliding(
        arch: &Arch,
        thickness: &ExactNumber,
        is_dilatant: bool,
    ) -> Result<Self, NoSketch> {
        Refused::thickness(thickness)?;
        wide(arch)?;
        raised(arch, DIGITS, |bits| {
            let at = sliding_configuration(arch, bits)?;
            let at = at.with(Unknown::Thickness, thickness.enclosure(bits));
            let arch = Box::new(arch.clone());
            let (weight, thickness) = (arch.weight(), thickness.clone());
            let subject = (Subject::Sliding { arch, thickness }, weight);
            let sketch = Self::of_modes(subject, at, true, &[Mode::Sliding], is_dilatant)?;
            // Else another joint than those that slide is past its limit.
            let has_room = |forces: &Forces| {
                let [least, largest] = &forces.moments;
                decide(&(largest.clone() - least), "whether a line of thrust fits")
            };
            let has_room = sketch.forces.iter().map(has_room).collect::<Result<Vec<_>, _>>()?;
            let fits = has_room.into_iter().all(|fits| fits);
            Ok(sketch.decided().map(|sketch| if fits { Ok(sketch) } else { Err(NoSketch::NoRoom) }))
        })?
    }

    /// Sketch with only some modes, in this order, if any is named: each has to be one in which the arch falls.
    pub fn in_modes(mut self, modes: &[Mode]) -> Result<Self, NoSketch> {
        if modes.is_empty() {
            return Ok(self);
        }
        let of = |mode: &Mode| {
            let found = self.collapses.iter().find(|collapse| collapse.mode == *mode);
            let all = || self.collapses.iter().map(|collapse| collapse.mode.label());
            found
                .cloned()
                .ok_or_else(|| NoSketch::OtherMode(*mode, all().collect::<Vec<_>>().join(", ")))
        };
        self.collapses = modes.iter().map(of).collect::<Result<_, _>>()?;
        Ok(self)
    }

    /// Sketch, if every number can be rounded.
    fn decided(self) -> Option<Self> {
        let angles = [&self.at.half_opening, &self.at.rotation_joint, &self.at.sliding_joint];
        let angles = angles.into_iter().map(|angle| &angle.rad);
        let at = [&self.at.thickness, &self.at.thrust, &self.at.friction].into_iter().chain(angles);
        let rates = self.collapses.iter().flat_map(|collapse| {
            let mechanism = &collapse.mechanism;
            mechanism.joints.iter().chain(&mechanism.crown).map(|joint| &joint.rate)
        });
        let forces = self.forces.iter().flat_map(|forces| {
            let marks = forces.marks.iter().map(|mark| &mark.at);
            [&forces.thrust].into_iter().chain(marks)
        });
        let is_rounded =
            |x: &Ball| Rounded::around(x, DIGITS).is_some() && x.nearest_double().is_some();
        let is_decided = at.chain(rates).chain(forces).all(is_rounded);
        is_decided.then_some(self)
    }

    /// Tells whether it is an arch of a thickness that stands: its lines are those of the least and the largest thrust.
    pub fn stands(&self) -> bool {
        matches!(&self.subject, Subject::Standing { stability, .. } if stability.stands)
    }

    /// Tells whether it is an arch of a thickness that falls.
    pub fn falls(&self) -> bool {
        matches!(&self.subject, Subject::Standing { stability, .. } if !stability.stands)
    }

    /// The half opening, rad.
    pub fn half_opening(&self) -> f64 {
        self.at.half_opening.rad.double()
    }

    /// The joints between stones of the right half but for the shoulder, from the crown, rad; none of an arch that
    /// is not of stones.
    pub fn stone_joints(&self) -> Vec<f64> {
        self.stones.iter().flat_map(stones::joints).collect()
    }

    /// The thickness, in units of `r`.
    pub fn thickness(&self) -> f64 {
        self.at.thickness.double()
    }

    /// The radii of the intrados and the extrados.
    pub fn radii(&self) -> [f64; 2] {
        faces(self.thickness())
    }

    /// Tells whether the line of friction jumps at the crown: without thrust it is at its limit next to it.
    pub fn has_jump(&self) -> bool {
        !self.is_limited && self.forces.iter().any(|forces| Drawable::is_zero(&forces.thrust))
    }

    fn of_modes(
        (subject, weight): (Subject, SelfWeight),
        at: Configuration<Ball>,
        is_limited: bool,
        modes: &[Mode],
        is_dilatant: bool,
    ) -> Result<Self, Undecided> {
        let collapse = |mode: &Mode| {
            let found = Collapse::new(weight, *mode, &at, is_dilatant);
            found.map_err(|open| Undecided::new(open.to_string()))
        };
        let collapses = modes.iter().map(collapse).collect::<Result<Vec<_>, Undecided>>()?;
        let mode = modes.first().copied().unwrap_or(Mode::Sliding);
        let mut forces = forces_of_mode(weight, mode, &at, is_limited)?;
        // All joints that give way in some mode.
        for mark in modes.iter().skip(1).flat_map(|mode| joints_of(*mode, &at)) {
            let is_same =
                |known: &Mark| known.contact == mark.contact && known.at.mid() == mark.at.mid();
            if !forces.marks.iter().any(is_same) {
                forces.marks.push(mark);
            }
        }
        let (stones, forces) = (None, vec![forces]);
        Ok(Self { subject, weight, at, is_limited, stones, forces, collapses })
    }
}

/// Refuses an arch that is too narrow for a picture.
fn wide(arch: &Arch) -> Result<(), NoSketch> {
    let alpha: Ball = arch.half_opening().enclosure(64);
    match alpha.double() < LEAST {
        true => Err(NoSketch::TooNarrow(arch.half_opening().to_string())),
        false => Ok(()),
    }
}

/// The modes of a landmark whose mechanisms differ: where two joints are one, two modes move alike.
fn mechanisms(landmark: Landmark) -> Vec<Mode> {
    let joint = landmark.system(SelfWeight::Heyman).fixed_value(Unknown::RotationJoint);
    let is_double = |mode: &Mode| match joint {
        Some(Fixed::SameAs(_)) => *mode == Mode::RotationalSlidingRotational,
        // At the crown the hinge of the haunch is that of [r,s] or [r].
        Some(Fixed::Integer(_)) => mode.has_haunch(),
        _ => false,
    };
    landmark.modes().iter().copied().filter(|mode| !is_double(mode)).collect()
}

fn decide(difference: &Ball, question: &'static str) -> Result<bool, Undecided> {
    match difference.is_positive() {
        Ternary::True => Ok(true),
        Ternary::False => Ok(false),
        Ternary::Undecided => Err(Undecided::new(question)),
    }
}
