//! The rectangle of forces in which asymmetric states are: how the three bounds of the half opening change.

use super::{ForceBox, RECTANGLE, Span, inner_room};
use crate::arch::asymmetric::Asymmetric;
use crate::arch::joint::Grip;
use crate::arch::whole::Forces;
use crate::arch::{Ring, SelfWeight, cycloid};
use crate::certify::{Undecided, asymmetric_half_openings};
use crate::check::krawczyk;
use crate::number::{Angle, DoubleBall, Enclosure, Field, Gradient, Real};
use crate::prover::decide::is_positive;
use crate::prover::halve::halve;
use crate::solve::invert;
use std::array;

/// Signs that are proved of the states with a weight.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Directions {
    /// Self-weight.
    pub weight: SelfWeight,
    /// Tells whether the room at a shoulder that just opens grows with the vertical force, in one arch.
    pub opening_grows: bool,
    /// Degrees between which the half openings are.
    pub half_openings: [i32; 2],
}

impl Directions {
    /// Signs of each weight.
    pub(in super::super) const ALL: [Self; 2] = {
        use SelfWeight::{Heyman, Milankovitch};
        [Self::new(Milankovitch, false), Self::new(Heyman, true)]
    };

    const fn new(weight: SelfWeight, opening_grows: bool) -> Self {
        Self { weight, opening_grows, half_openings: asymmetric_half_openings(weight) }
    }
}

/// A box is halved so often at the most.
const DEPTH: u32 = 30;

/// The unknowns next to a state of an inner joint that slides: `p, eta, b0 + 1, b1, alpha_U, alpha_Q, alpha_I`.
const START: [f64; 7] = [0.2309, 0.5831, 1.0613, 1.0567, 2.35, 2.2, 2.3];
/// Steps of Newton's method to the middle of a box from that of the box before it.
const STEPS: usize = 4;
/// A step after which the middle is as good as any other.
const SHORT: f64 = 1e-6;
/// Ratio of the width of a box of unknowns to what the first order leaves of it: the haunch and the half opening that
/// fits bend most, and the others are not to be wider than they have to.
const INFLATION: [f64; 7] = [1.4, 1.4, 1.4, 2.0, 1.4, 2.0, 1.4];

/// The two hinges touch, and the half openings at which the shoulder opens, the mechanism fits and an inner joint
/// slides. `b0` has one added: it is zero where `v` is. The last two of the variables are the inclination and `v`.
fn touching<T: Real>(weight: SelfWeight, of: &[T; 9]) -> [T; 7] {
    let [moment, thickness, crown, haunch, opens, fits, slides, inclination, vertical] = of;
    let angle = |x: &T| Angle::new(x.clone());
    let inclination = angle(inclination);
    let ring = Ring::new(weight, thickness);
    let at = Asymmetric {
        half_opening: angle(opens),
        grip: without_friction(moment),
        thickness: thickness.clone(),
        forces: Forces {
            thrust: cycloid::thrust(&inclination),
            moment: moment.clone(),
            vertical: vertical.clone(),
        },
        crown_hinge: Angle::new(crown.clone() - crown.int(1)),
        haunch: angle(haunch),
        sliding_joint: Angle::zero(moment),
    };
    let fitting = Asymmetric { half_opening: angle(fits), ..at.clone() };
    let ([above, crown], [below, haunch]) = (at.crown(&ring), at.haunch(&ring));
    let inner = inner_room(&inclination, vertical, slides);
    [above, crown, below, haunch, at.shoulder_opens(&ring), fitting.misfit(&ring), inner]
}

/// For all forces of a box exactly one root in another box, next to a start value: `K` of [`krawczyk`] with slopes by
/// the forces too, `F(m, p) = F(m, p_0) + F_p (p - p_0)`, so that the rows of `Y` meet all that a force does at once.
/// A row has as many entries as there are variables; those beyond the equations multiply nothing. The start value
/// becomes the middle of the box, which is found where nothing is proved too.
fn root_in(weight: SelfWeight, place: &ForceBox, start: &mut [f64; 7]) -> Option<[DoubleBall; 7]> {
    let forces = [place.inclination, place.vertical];
    let mut centre: [f64; 9] =
        array::from_fn(|k| if k < 7 { start[k] } else { forces[k - 7].middle() });
    let (mut inverse, mut reach) = ([[0.0; 7]; 7], [0.0; 7]);
    let mut longest = f64::INFINITY;
    for _ in 0..STEPS {
        let residuals = touching(weight, &Gradient::<f64, 9>::variables(&centre));
        inverse = invert(residuals.map(|r| array::from_fn(|k| r.slopes[k])))?;
        longest = 0.0;
        for (k, row) in inverse.iter().enumerate() {
            let moved = |of: &dyn Fn(&Gradient<f64, 9>) -> f64| {
                row.iter().zip(&residuals).map(|(y, r)| y * of(r)).sum::<f64>()
            };
            let by = |n: usize| moved(&|r| r.slopes[7 + n]).abs() * forces[n].width() / 2.0;
            let step = moved(&|r| r.value);
            (centre[k], reach[k]) = (centre[k] - step, by(0) + by(1));
            longest = longest.max(step.abs());
        }
        if longest < SHORT {
            break;
        }
    }
    if longest.is_nan() || longest >= SHORT {
        return None;
    }
    start.copy_from_slice(&centre[..7]);
    let centre = centre.map(DoubleBall::exact);
    let residuals = touching(weight, &centre);
    let exact = |row: &[f64; 7], k: usize| DoubleBall::exact(row.get(k).copied().unwrap_or(0.0));
    let inverse = inverse.map(|row| -> [_; 9] { array::from_fn(|k| exact(&row, k)) });
    let domain: [DoubleBall; 9] = array::from_fn(|k| match reach.get(k) {
        Some(reach) => centre[k].widened(INFLATION[k] * reach),
        None => forces[k - 7].ball(),
    });
    let slopes = touching(weight, &Gradient::<_, 9>::variables(&domain));
    let root = krawczyk::image(&centre, &residuals, &slopes, &inverse, &domain);
    krawczyk::is_contracted(&root, &domain[..7]).then(|| root.try_into().ok())?
}

/// A friction where none is looked at.
fn without_friction<T: Field>(like: &T) -> Grip<T> {
    Grip { shear: like.int(0), normal: like.int(1) }
}

fn is_less(a: &DoubleBall, b: &DoubleBall) -> bool {
    a.is_less_than(b).is_proved()
}

/// Numbers with their slopes by `h, v, eta, b0, b1` and the half opening.
type Slopes = Gradient<DoubleBall, 6>;

/// Hinges that touch, for all forces of a box.
struct TouchingHinges {
    weight: SelfWeight,
    forces: [DoubleBall; 2],
    thickness: DoubleBall,
    hinges: [DoubleBall; 2],
    opens: DoubleBall,
    fits: DoubleBall,
    slides: DoubleBall,
}

impl TouchingHinges {
    fn new(weight: SelfWeight, place: &ForceBox, start: &mut [f64; 7]) -> Option<Self> {
        let root = root_in(weight, place, start)?;
        let [_, thickness, crown, haunch, opens, fits, slides] = root;
        Some(Self {
            weight,
            forces: [cycloid::thrust(&Angle::new(place.inclination.ball())), place.vertical.ball()],
            thickness,
            hinges: [crown - crown.int(1), haunch],
            opens,
            fits,
            slides,
        })
    }

    /// Tells whether the hinges are on their sides, the half openings are those of horseshoes, and the thickness
    /// is below 2.
    fn is_in_order(&self, place: ForceBox) -> bool {
        let inner = cycloid::joint(&Angle::new(place.inclination.ball()));
        let [crown, haunch] = self.hinges;
        let right = crown.pi() / crown.int(2);
        is_less(&crown, &haunch)
            && is_less(&haunch, &right)
            && is_less(&right, &self.opens)
            && is_less(&right, &self.fits)
            && is_less(&inner, &(self.slides - self.forces[1]))
            && is_less(&self.opens, &crown.pi())
            && is_less(&self.fits, &crown.pi())
            && is_less(&self.thickness, &crown.int(2))
            && [haunch, self.thickness].iter().all(is_positive)
    }

    fn slopes(&self, half_opening: DoubleBall) -> Sloped {
        let [thrust, vertical] = self.forces;
        let [crown, haunch] = self.hinges;
        let all = [thrust, vertical, self.thickness, crown, haunch, half_opening];
        let [thrust, vertical, thickness, crown, haunch, alpha] = Slopes::variables(&all);
        let at = Asymmetric {
            half_opening: Angle::new(alpha),
            grip: without_friction(&thrust),
            thickness,
            forces: Forces { thrust, moment: thrust.int(0), vertical },
            crown_hinge: Angle::new(crown),
            haunch: Angle::new(haunch),
            sliding_joint: Angle::zero(&thrust),
        };
        let ring = Ring::new(self.weight, &thickness);
        Sloped {
            crown: at.crown(&ring),
            haunch: at.haunch(&ring),
            shoulder: at.shoulder_opens(&ring),
            misfit: at.misfit(&ring),
        }
    }

    /// In one arch with a shoulder that slides, `h = (alpha - v) cot(alpha - phi)` falls as `v` grows.
    fn in_one_arch(&self, half_opening: DoubleBall) -> [DoubleBall; 2] {
        let [thrust, vertical] = self.forces;
        [-thrust / (half_opening - vertical), thrust.int(1)]
    }

    /// Tells whether the distance from the extrados is least at its hinge; and whether the misfit falls where the
    /// mechanism fits, in one arch with the vertical force and in symmetric states with the thrust, or an inner
    /// joint slides before.
    fn fits_before(&self, place: ForceBox) -> bool {
        let slopes = self.slopes(self.fits);
        let falls = |direction| is_positive(&-slopes.along(direction)[1][0]);
        is_positive(&slopes.crown[1].slopes[3])
            && (is_positive(&-place.room_inside(&self.fits))
                || falls(self.in_one_arch(self.fits)) && falls(self.with_thrust()))
    }

    /// The direction of a growing thrust.
    fn with_thrust(&self) -> [DoubleBall; 2] {
        [1, 0].map(|n| self.thickness.int(n))
    }

    /// Tells whether a bound from below exceeds that by the shoulder, so that there is no state; or else the
    /// signs are as they are said to be where the shoulder opens, and the arch has its symmetric state inside the
    /// rectangle too. `Some(true)` where there is none.
    fn goes(&self, directions: Directions, place: ForceBox) -> Option<bool> {
        let [thrust, vertical] = self.forces;
        let slopes = self.slopes(self.opens);
        if [place.room_inside(&self.opens), slopes.misfit.value].iter().any(|x| is_positive(&-*x)) {
            return Some(true);
        }
        let [[shoulder, _], _] = slopes.along(self.in_one_arch(self.opens));
        let opening = if directions.opening_grows { shoulder } else { -shoulder };
        // With one thrust, the bound by the shoulder falls below both others.
        let [[opens, by_opening], [misfits, by_fitting]] =
            slopes.along([thrust.int(0), thrust.int(1)]);
        let falls = misfits * by_opening - opens * by_fitting;
        let [[by_thrust, _], _] = slopes.along(self.with_thrust());
        let least = Angle::new(DoubleBall::exact(Span::of_parts(RECTANGLE.inclinations).low));
        let room = cycloid::thrust(&least) - thrust * self.fits / (self.fits - vertical);
        let degrees = |n: i32| thrust.pi() * thrust.int(n) / thrust.int(180);
        let [low, high] = directions.half_openings.map(degrees);
        let is_wide = is_less(&low, &self.fits) || is_positive(&-place.room_inside(&low));
        let signs = [opening, -by_thrust, -(opens + by_opening), falls, room];
        (is_wide && is_less(&self.opens, &high) && signs.iter().all(is_positive)).then_some(false)
    }
}

/// Margins at the hinges and at the springing that touches the extrados, the moment being zero, and the misfit.
struct Sloped {
    crown: [Slopes; 2],
    haunch: [Slopes; 2],
    shoulder: Slopes,
    misfit: Slopes,
}

impl Sloped {
    /// Slopes of the margin at the springing and of the misfit, in a direction of `h` and `v`, each with that by
    /// the half opening. The moment is eliminated, and the hinges follow.
    fn along(&self, direction: [DoubleBall; 2]) -> [[DoubleBall; 2]; 2] {
        let given =
            |value: &Slopes| value.slopes[0] * direction[0] + value.slopes[1] * direction[1];
        let ([above, crown], [below, haunch]) = (&self.crown, &self.haunch);
        // Where a margin touches, its slope by the joint is zero.
        let both = *above + below;
        let thickness = -given(&both) / both.slopes[2];
        let whole = |value: &Slopes| given(value) + value.slopes[2] * thickness;
        let moment = whole(above);
        let hinges = [-whole(crown) / crown.slopes[3], -whole(haunch) / haunch.slopes[4]];
        let Self { shoulder, misfit, .. } = self;
        let fits = whole(misfit) + misfit.slopes[3] * hinges[0] + misfit.slopes[4] * hinges[1];
        [[whole(shoulder) - moment, shoulder.slopes[5]], [fits, misfit.slopes[5]]]
    }
}

/// Proves, box by box, that in the whole rectangle the hinges touch at one thickness, and that where a state may
/// be the signs are as said. Returns the number of boxes, and of those in which a state may be.
pub(in super::super) fn known(directions: Directions) -> Result<[usize; 2], Undecided> {
    known_and(directions, |_, _| true)
}

/// Proves what [`known`] does, and something else where a state may be.
fn known_and(
    directions: Directions,
    holds: impl Fn(&TouchingHinges, ForceBox) -> bool,
) -> Result<[usize; 2], Undecided> {
    let weight = directions.weight;
    let whole = ForceBox {
        inclination: Span::of_parts(RECTANGLE.inclinations),
        vertical: Span::of_parts([0, RECTANGLE.vertical]),
    };
    let (mut start, mut states) = (START, 0);
    let proof = |place: &ForceBox| {
        let state = TouchingHinges::new(weight, place, &mut start);
        let state = state.filter(|state| state.is_in_order(*place) && state.fits_before(*place));
        let told = state.and_then(|state| {
            let goes = state.goes(directions, *place);
            goes.filter(|is_none| *is_none || holds(&state, *place))
        });
        states += usize::from(!told.ok_or([place.inclination, place.vertical])?);
        Ok(())
    };
    let boxes = halve(whole, DEPTH, ForceBox::halves, proof).map_err(|at: [Span; 2]| {
        let [chi, v] = at.map(Span::middle);
        Undecided::new(format!("not decided at chi = {chi}, v = {v}"))
    })?;
    Ok([boxes, states])
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::arch::{statics, whole::carried};
    use crate::problem::asymmetric_region::some_may_move;

    /// Room about the table, for its roundings.
    const ROOM: f64 = 1e-9;

    /// Friction at which an inner joint slides.
    fn friction_inside(place: ForceBox) -> DoubleBall {
        let inclination = Angle::new(place.inclination.ball());
        let phi = Angle::new(place.vertical.ball() + cycloid::friction_angle(&inclination));
        phi.sin / phi.cos
    }

    impl TouchingHinges {
        /// Tells whether the arches in which the forces of the box may be those of a state are held by the table of the
        /// program: those of the larger bound from below, and those of the bound from above.
        fn is_in_table(&self, place: ForceBox) -> bool {
            let [slides, fits, opens] =
                [self.slides, self.fits, self.opens].map(|bound| [bound.lower(), bound.upper()]);
            let larger = [slides[0].max(fits[0]), slides[1].max(fits[1])];
            let larger = match is_less(&self.fits, &self.slides) {
                // Where an inner joint slides, phi = v + chi - sin(chi) cos(chi).
                true => (slides, friction_inside(place)),
                false => (larger, self.friction(larger)),
            };
            [larger, (opens, self.friction(opens))].into_iter().all(|([low, high], friction)| {
                // Both bounds of the table grow with the half opening.
                let holds = |alpha: f64, mu: f64| some_may_move(self.weight, [alpha; 2], [mu; 2]);
                holds(high + ROOM, friction.lower() - ROOM)
                    && holds(low - ROOM, friction.upper() + ROOM)
            })
        }

        /// Friction at which the springing slides, at half openings between two.
        fn friction(&self, [low, high]: [f64; 2]) -> DoubleBall {
            let [thrust, vertical] = self.forces;
            let middle = (low + high) / 2.0;
            let half_opening = DoubleBall::exact(middle).widened((high - middle).max(middle - low));
            let joint = carried(&Angle::new(half_opening), &vertical);
            -statics::shear_force(&joint, &thrust) / statics::normal_force(&joint, &thrust)
        }
    }

    /// Proof that no asymmetric solution is outside the table.
    #[test]
    #[ignore = "a minute long"]
    fn the_table_of_the_program_holds_all() {
        for directions in Directions::ALL {
            let counts = known_and(directions, |state, place| state.is_in_table(place));
            println!("{}: {counts:?}", directions.weight);
            counts.unwrap();
        }
    }
}
