//! The constants: each quantity of each landmark, with all its digits proved.

use super::closed_value::Exact;
use super::constant::{Constant, quantities};
use super::enclosed::Enclosed;
use crate::arch::SelfWeight;
use crate::number::bits_of;
use crate::problem::{Landmark, Problem, Quantity};
use crate::prover::isolate::isolate;
use crate::prover::refine::{refine, refine_watched, stages};
use crate::prover::{Error, Isolated, Refused, Undecided};
use crate::solve::{newton, start};
use rayon::prelude::*;

/// Number of times that the precision is raised before a rounding counts as undecided.
const ATTEMPTS: u32 = 6;
/// The bits that an enclosure has at least.
const NARROW: u32 = 256;
/// Bits beyond the digits asked for, at the first attempt.
const GUARD: u32 = 32;

/// A landmark whose existence and uniqueness are proved: the only constructor is that proof.
///
/// ```
/// use couplet_prove::prelude::*;
/// let triple = CertifiedLandmark::new(Landmark::Triple, SelfWeight::Heyman)?;
/// let thickness = triple.constant(Quantity::Thickness, 30)?;
/// assert_eq!(thickness.to_string(), "0.679604732098885514787534896210");
/// # Ok::<(), couplet_prove::certify::Error>(())
/// ```
///
/// See also: [`certify_landmark`](super::certify_landmark) for a proof that others can check,
/// [`Certify`](super::state::Certify) for arches.
#[derive(Clone, Debug)]
pub struct CertifiedLandmark {
    /// The enclosure of few digits, on which the conditions were proved.
    narrow: Enclosed,
}

impl CertifiedLandmark {
    /// Finds the landmark and proves that it exists and is unique in a box; undecided if the proof fails,
    /// which it does for none of [`Landmark::ALL`].
    pub fn new(landmark: Landmark, weight: SelfWeight) -> Result<Self, Undecided> {
        let system = landmark.system(weight);
        let candidate = newton(&system, start::landmark(landmark, weight), 64)
            .ok_or_else(Undecided::no_solution)?;
        let isolated = isolate(landmark, weight, &candidate)?;
        let narrow = refine(&isolated, NARROW)?;
        // What is asked for few digits is a copy, in which this is known.
        narrow.friction_angle();
        let problem = Problem::Landmark { landmark, weight };
        match problem.first_failure(narrow.configuration(), 64) {
            None => Ok(Self { narrow: Enclosed::new(landmark, isolated, narrow) }),
            Some(condition) => Err(Undecided::new(condition.label())),
        }
    }

    /// The landmark.
    pub fn landmark(&self) -> Landmark {
        self.narrow.landmark()
    }

    /// The self-weight model.
    pub fn weight(&self) -> SelfWeight {
        self.narrow.weight()
    }

    /// The system and the box in which its root is unique.
    pub fn isolated(&self) -> &Isolated {
        self.narrow.isolated()
    }

    /// The landmark with all variables enclosed to about `bits` bits (and never fewer than 256);
    /// undecided if the proof fails at that precision.
    pub fn enclosure(&self, bits: u32) -> Result<Enclosed, Undecided> {
        self.enclosure_with(bits, &|| ())
    }

    /// Encloses the landmark, calling `tick` [`stages`] times on the way.
    fn enclosure_with(&self, bits: u32, tick: &(dyn Fn() + Sync)) -> Result<Enclosed, Undecided> {
        if bits > NARROW {
            let refined = refine_watched(self.isolated(), bits, tick)?;
            return Ok(self.narrow.narrowed(refined));
        }
        (0..stages(self.isolated().system())).for_each(|_| tick());
        Ok(self.narrow.clone())
    }

    /// The exact value of a quantity, where it has one.
    pub fn exact(&self, quantity: Quantity) -> Option<Exact> {
        self.narrow.exact(quantity)
    }

    /// One quantity of the landmark, correctly rounded to `digits` significant digits, 1 to
    /// [`MAX_DIGITS`](super::MAX_DIGITS). Other digits, and a quantity that the landmark does not have, are refused.
    pub fn constant(&self, quantity: Quantity, digits: usize) -> Result<Constant, Error> {
        let found = self.constants_of(&[(quantity, digits)])?.pop();
        Ok(found.ok_or_else(|| Undecided::rounding("the rounding"))?)
    }

    /// All quantities of the landmark, correctly rounded to `digits` significant digits, 1 to
    /// [`MAX_DIGITS`](super::MAX_DIGITS); undecided if a rounding stays open.
    pub fn constants(&self, digits: usize) -> Result<Vec<Constant>, Error> {
        let all: Vec<_> = quantities(self.landmark()).map(|quantity| (quantity, digits)).collect();
        self.constants_of(&all)
    }

    /// Some quantities of the landmark, each correctly rounded to its own number of significant digits:
    /// the landmark is refined once, to the most that are asked for. A quantity that the landmark does
    /// not have is refused.
    pub fn constants_of(&self, asked: &[(Quantity, usize)]) -> Result<Vec<Constant>, Error> {
        self.constants_of_with(asked, &|| ())
    }

    /// Constants of some quantities, calling `tick` [`CertifiedLandmark::ticks_of`] times on the way.
    pub fn constants_of_with(
        &self,
        asked: &[(Quantity, usize)],
        tick: &(dyn Fn() + Sync),
    ) -> Result<Vec<Constant>, Error> {
        let possible: Vec<Quantity> = quantities(self.landmark()).collect();
        for &(quantity, digits) in asked {
            Refused::digits(digits)?;
            Refused::quantity(quantity, &possible)?;
        }
        let most = asked.iter().map(|(_, digits)| *digits).max();
        let mut bits = bits_of(most.unwrap_or(1)) + GUARD;
        let mut refined = self.enclosure_with(bits, tick)?;
        let mut found: Vec<((Quantity, usize), Option<Constant>)> =
            asked.iter().map(|&asked| (asked, None)).collect();
        for attempt in 1.. {
            found.par_iter_mut().filter(|(_, constant)| constant.is_none()).for_each(
                |((quantity, digits), constant)| {
                    *constant = refined.rounded(*quantity, *digits);
                    if constant.is_some() {
                        tick();
                    }
                },
            );
            let open = found.iter().find(|(_, constant)| constant.is_none());
            let Some(((quantity, _), _)) = open else { break };
            if attempt > ATTEMPTS {
                let name = quantity.name();
                let reason = format!("the rounding of {name} is not decided at {bits} bits");
                return Err(Undecided::rounding(reason).at(bits).into());
            }
            bits += GUARD << attempt;
            refined = self.enclosure(bits)?;
        }
        Ok(found.into_iter().filter_map(|(_, constant)| constant).collect())
    }

    /// Number of times that [`CertifiedLandmark::constants_of`] reports progress for a number of quantities.
    pub fn ticks_of(landmark: Landmark, quantities: usize) -> u64 {
        stages(&landmark.system(SelfWeight::Heyman)) + quantities as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::Unknown;
    use crate::certify::{MAX_DIGITS, Value};
    use crate::number::Field;
    use crate::problem::{Condition, Examined};
    use rug::Rational;

    #[test]
    fn quantities_exist_where_the_landmark_has_them() {
        let names = |landmark| quantities(landmark).map(Quantity::name).collect::<Vec<_>>();
        assert_eq!(names(Landmark::Triple).len(), Quantity::LANDMARK.len());
        let widest = names(Landmark::WidestJoint);
        assert!(!widest.contains(&"friction") && !widest.contains(&"sliding_joint"));
        assert!(widest.contains(&"rotation_joint") && widest.contains(&"A"));
    }

    /// The conditions of its modes that a landmark leaves out are zero there, and only that.
    #[test]
    fn what_is_left_out_of_the_conditions_is_zero() {
        let mut ties = 0;
        for (landmark, weight) in
            Landmark::ALL.into_iter().flat_map(|l| SelfWeight::ALL.map(|w| (l, w)))
        {
            let point = CertifiedLandmark::new(landmark, weight).unwrap();
            let (system, narrow) = (landmark.system(weight), point.enclosure(256).unwrap());
            let (asked, tied) = (landmark.conditions(weight), landmark.ties(weight));
            for mode in landmark.modes() {
                let state = Examined::new(weight, *mode, narrow.configuration());
                let is_limited = narrow.value(Unknown::Friction).is_some();
                for condition in Condition::of(*mode, is_limited) {
                    let margin = state.margin(condition);
                    let is_zero =
                        margin.contains(&Rational::new()) && margin.rad().to_float() < 1e-30;
                    assert_eq!(
                        condition.is_tie(&system),
                        is_zero,
                        "{landmark:?} {mode} {condition:?}"
                    );
                    let is_asked =
                        asked.iter().any(|(m, all)| m == mode && all.contains(&condition));
                    assert_eq!(is_asked, !is_zero, "{landmark:?} {mode} {condition:?}");
                    let is_tied = tied.iter().any(|(m, all)| m == mode && all.contains(&condition));
                    assert_eq!(is_tied, is_zero, "{landmark:?} {mode} {condition:?}");
                    ties += usize::from(is_zero);
                }
            }
        }
        assert!(ties > 20);
    }

    /// All unknowns are in their ranges, but the joints are in the order of another mode.
    #[test]
    fn a_landmark_without_the_states_of_its_modes_is_refused() {
        let weight = SelfWeight::Milankovitch;
        let point = CertifiedLandmark::new(Landmark::Triple, weight).unwrap();
        let problem = Problem::Landmark { landmark: Landmark::Triple, weight };
        let at = point.enclosure(256).unwrap().configuration().clone();
        assert_eq!(problem.first_failure(&at, 256), None);
        let nearer = at.sliding_joint.rad.ratio(1, 2) * &at.sliding_joint.rad;
        let spoiled = at.with(Unknown::RotationJoint, nearer);
        assert_eq!(problem.first_failure(&spoiled, 256), Some(Condition::SlidesAboveHaunch));
    }

    #[test]
    fn digits_out_of_range_are_refused_before_anything_is_computed() {
        let point = CertifiedLandmark::new(Landmark::OverturningEnd, SelfWeight::Heyman).unwrap();
        for asked in [0, MAX_DIGITS + 1, usize::MAX] {
            let refused = Error::Refused(Refused::Digits { asked, most: MAX_DIGITS });
            assert_eq!(point.constants(asked), Err(refused.clone()));
            assert_eq!(point.constant(Quantity::Thickness, asked), Err(refused));
        }
    }

    #[test]
    fn what_is_asked_together_is_what_is_asked_alone() {
        let point = CertifiedLandmark::new(Landmark::Triple, SelfWeight::Heyman).unwrap();
        let asked = [(Quantity::Friction, 12), (Quantity::Thickness, 60), (Quantity::Friction, 3)];
        let together = point.constants_of(&asked).unwrap();
        for (constant, (quantity, digits)) in together.iter().zip(asked) {
            let alone = point.constants(digits).unwrap();
            assert!(alone.contains(constant), "{quantity:?} to {digits} digits");
            assert_eq!(constant.quantity, quantity);
        }
        assert_eq!(together.len(), asked.len());
    }

    #[test]
    fn a_quantity_that_a_landmark_does_not_have_is_refused() {
        let widest = CertifiedLandmark::new(Landmark::WidestJoint, SelfWeight::Heyman).unwrap();
        for quantity in [Quantity::Friction, Quantity::SlidingJoint, Quantity::GeometricSafety] {
            let Err(Error::Refused(refused)) = widest.constant(quantity, 5) else { panic!() };
            let expected = format!("there is no {quantity} here; the quantities are ");
            assert!(refused.to_string().starts_with(&expected), "{refused}");
        }
        // Zero at every landmark where it is fixed so, and infinite: these it has.
        let end = CertifiedLandmark::new(Landmark::OverturningEnd, SelfWeight::Heyman).unwrap();
        assert_eq!(end.constant(Quantity::Friction, 5).unwrap().to_string(), "inf");
    }

    #[test]
    fn one_digit_and_many_agree() {
        let point = CertifiedLandmark::new(Landmark::Border, SelfWeight::Heyman).unwrap();
        let [few, many] = [1, 60].map(|digits| point.constants(digits).unwrap());
        for (few, many) in few.iter().zip(&many) {
            let (Value::Finite(few), Value::Finite(many)) = (&few.value, &many.value) else {
                panic!()
            };
            assert!(few.lower.to_rational() <= many.value.to_rational());
            assert!(many.value.to_rational() <= few.upper.to_rational());
            assert!(few.value.significant_digits() <= 2, "{:?}", few.value);
        }
    }
}
