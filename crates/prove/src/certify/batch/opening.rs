//! One half opening at many frictions: what its arches share is proved once.
//!
//! From its rotational friction on an arch has the state that it has at unlimited friction; below its purely sliding
//! friction it falls; and where none stands at unlimited friction, none stands. Both frictions are proved with that
//! state, in balls of double-doubles. A friction that is proved to lie beside them needs that comparison alone; one
//! that these balls cannot tell from them, and every one between them, is proved on its own. The two frictions are
//! those of the half opening, whatever the friction of the arch. So the answers are those that each arch has alone, to
//! the last digit.

use crate::arch::SelfWeight;
use crate::certify::state::{
    Answer, AtOpening, Balls, DOUBLE_DOUBLE, Digits, Enough, Fall, Figure, Frictions, Tier,
    critical_frictions,
};
use crate::lanes::LaneArch;
use crate::number::{DoubleDoubleBall, Enclosure, ExactNumber, Real};
use crate::problem::{Arch, Friction};
use crate::prover::{Error, Refused};
use std::borrow::Cow;
use std::sync::OnceLock;

/// Rows of one half opening from which sharing pays, where all rows are there.
pub(super) const PAYS_FROM: usize = 4;
/// Arches of one half opening that are proved alone before more are expected, where nothing is known of what comes.
pub(super) const ALONE: usize = 2;

/// The arches of one half opening and weight, whatever their friction.
///
/// ```
/// use couplet_prove::certify::batch::SharedOpening;
/// use couplet_prove::certify::state::Answer;
/// use couplet_prove::prelude::*;
/// let opening = SharedOpening::new(SelfWeight::Milankovitch, "80deg".parse()?, 17)?;
/// for friction in ["0.1", "0.35", "0.6", "1.2"] {
///     match &*opening.certify(friction.parse()?, false)? {
///         Answer::Stands(state) => println!("{friction}: {} {}", state.mode, state.thickness),
///         Answer::Falls { fall, .. } => println!("{friction}: {}", fall.reason()),
///     }
/// }
/// # Ok::<(), couplet_prove::certify::Error>(())
/// ```
///
/// See also: [`Certify::certify`](crate::certify::state::Certify::certify), which answers one.
#[derive(Debug)]
pub struct SharedOpening {
    /// Arch of the half opening with unlimited friction.
    unlimited: Arch,
    digits: usize,
    /// The answer at unlimited friction, where it is proved.
    answer: Option<Answer>,
    /// The friction below which the arch falls.
    sliding: Option<DoubleDoubleBall>,
    /// The friction from which the answer is that at unlimited friction.
    same_from: Option<DoubleDoubleBall>,
    slides: Answer,
    /// The frictions at which the mode changes, where some arch stands and they are proved; asked for by the first.
    frictions: OnceLock<Option<Frictions<Figure>>>,
    /// Remedies at this half opening, asked for by the first arch that falls.
    enough: OnceLock<AtOpening>,
}

impl SharedOpening {
    /// The arches of a half opening in `(0, pi)`, with values to `digits` significant digits. It costs about as much
    /// as two arches. Any other half opening, and digits beyond
    /// [`MAX_DIGITS`](crate::certify::MAX_DIGITS), are refused.
    pub fn new(
        weight: SelfWeight,
        half_opening: ExactNumber,
        digits: usize,
    ) -> Result<Self, Refused> {
        Refused::digits(digits)?;
        let unlimited = Arch::new(weight, half_opening, Friction::Infinite)?;
        let [sliding, same_from] = critical_frictions(&unlimited);
        let answer = same_from
            .as_ref()
            .and_then(|_| Balls::DoubleDoubles.state(&unlimited, digits, false).ok());
        let slides = Answer::Falls { fall: Fall::Sliding, enough: None };
        let (frictions, enough) = (OnceLock::new(), OnceLock::new());
        Ok(Self { unlimited, digits, answer, sliding, same_from, slides, frictions, enough })
    }

    /// Answer to the arch of a friction as if it were alone, with the frictions at which its mode changes if they
    /// are asked for; refused if the friction is out of its range.
    ///
    /// ```
    /// use couplet_prove::certify::batch::SharedOpening;
    /// use couplet_prove::certify::state::Answer;
    /// use couplet_prove::prelude::*;
    /// let opening = SharedOpening::new(SelfWeight::Milankovitch, "80deg".parse()?, 17)?;
    /// let Answer::Stands(state) = opening.certify("0.6".parse()?, true)?.into_owned() else { panic!() };
    /// assert_eq!(state.frictions.unwrap().sliding.to_string(), "0.21939417869493803");
    /// # Ok::<(), couplet_prove::certify::Error>(())
    /// ```
    pub fn certify(&self, friction: Friction, frictions: bool) -> Result<Cow<'_, Answer>, Error> {
        if let Friction::Coefficient(mu) = &friction
            && let Some(answer) = self.shared(&mu.enclosure(DOUBLE_DOUBLE)).filter(|_| !frictions)
        {
            return Ok(Cow::Borrowed(answer));
        }
        self.state(&self.arch(friction)?, frictions)
    }

    /// The arch of a friction.
    fn arch(&self, friction: Friction) -> Result<Arch, Refused> {
        Ok(Arch::new(self.unlimited.weight(), self.unlimited.half_opening().clone(), friction)?)
    }

    /// Answer to an arch of this half opening and weight, as if it were alone.
    pub(super) fn state(&self, arch: &Arch, frictions: bool) -> Result<Cow<'_, Answer>, Error> {
        let shared = match Self::enclosed(arch.friction()) {
            Some(friction) => self.shared(&friction),
            None => self.answer.as_ref(),
        };
        match shared {
            _ if frictions => self.with_frictions(arch, shared).map(Cow::Owned),
            Some(answer) => Ok(Cow::Borrowed(answer)),
            None => Balls::DoubleDoubles.state(arch, self.digits, false).map(Cow::Owned),
        }
    }

    fn with_frictions(&self, arch: &Arch, shared: Option<&Answer>) -> Result<Answer, Error> {
        let alone = |frictions| Balls::DoubleDoubles.state(arch, self.digits, frictions);
        match shared.map_or_else(|| alone(false), |answer| Ok(answer.clone())) {
            Ok(Answer::Stands(state)) => match self.frictions() {
                Some(frictions) => {
                    let frictions = Some(frictions.clone());
                    Ok(Answer::Stands(Box::new(Digits { frictions, ..*state })))
                }
                None => alone(true),
            },
            Ok(Answer::Falls { fall, .. }) => {
                let is_quick = Tier::DoubleDoubles.has(self.digits);
                let at =
                    kept(&self.enough, || AtOpening::new(&self.unlimited, self.digits, is_quick));
                let enough = Enough::new(arch, at, self.digits, is_quick);
                Ok(Answer::Falls { fall, enough: Some(Box::new(enough)) })
            }
            // With the frictions other things may be left open.
            Err(_) => alone(true),
        }
    }

    /// The frictions of the half opening.
    fn frictions(&self) -> Option<&Frictions<Figure>> {
        let proved = || match Balls::DoubleDoubles.state(&self.unlimited, self.digits, true) {
            Ok(Answer::Stands(state)) => state.frictions,
            _ => None,
        };
        kept(&self.frictions, proved).as_ref()
    }

    /// A friction as openings compare it with their own; none if it is unlimited.
    pub fn enclosed(friction: &Friction) -> Option<DoubleDoubleBall> {
        match friction {
            Friction::Coefficient(mu) => Some(mu.enclosure(DOUBLE_DOUBLE)),
            // What is no friction angle is no friction either.
            Friction::Angle(phi) => {
                tangent(&phi.enclosure(DOUBLE_DOUBLE)).or(Some(DoubleDoubleBall::WHOLE))
            }
            Friction::Infinite => None,
        }
    }

    /// An arch as it goes into lanes.
    pub fn enclosed_arch(arch: &Arch) -> LaneArch {
        (Self::enclosed_number(arch.half_opening()), Self::enclosed(arch.friction()))
    }

    /// A number as it goes into lanes.
    pub fn enclosed_number(number: &ExactNumber) -> DoubleDoubleBall {
        number.enclosure(DOUBLE_DOUBLE)
    }

    /// Answer without frictions to the arch of a friction, if it needs no proof of its own: much quicker. None says
    /// nothing.
    fn shared(&self, friction: &DoubleDoubleBall) -> Option<&Answer> {
        let exceeds = |bound: &DoubleDoubleBall| bound.is_less_than(friction).is_proved();
        let sliding = self.sliding.as_ref()?;
        if friction.is_less_than(sliding).is_proved() {
            return friction.is_positive().is_proved().then_some(&self.slides);
        }
        exceeds(self.same_from.as_ref()?).then_some(self.answer.as_ref()?)
    }
}

/// The tangent of an angle that is proved to be between zero and a right angle.
pub(super) fn tangent(phi: &DoubleDoubleBall) -> Option<DoubleDoubleBall> {
    let (sin, cos) = phi.sin_cos();
    let is_acute = phi.mid().hi() < 2.0 && [phi, &cos].iter().all(|x| x.is_positive().is_proved());
    is_acute.then(|| sin / cos)
}

/// A value that is proved once. Threads that ask for it at a time each prove it: none waits for another, whose
/// proof may wait for the work of this one.
fn kept<T>(place: &OnceLock<T>, proved: impl FnOnce() -> T) -> &T {
    match place.get() {
        Some(kept) => kept,
        None => {
            let found = proved();
            place.get_or_init(|| found)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certify::state::Certify;
    use crate::number::{DoubleDouble, Rounded};

    fn shared_at(opening: &SharedOpening, friction: f64) -> Option<&Answer> {
        opening.shared(&DoubleDoubleBall::exact(DoubleDouble::exact(friction)))
    }

    fn equal_figures(alone: &Figure, found: &Figure, of: &str) {
        assert_eq!(alone.decimal, found.decimal, "{of}");
        let doubles = |x: &Figure| [x.double, x.binary.lower, x.binary.upper].map(f64::to_bits);
        assert_eq!(doubles(alone), doubles(found), "{of}");
    }

    fn equal(alone: &Answer, found: &Answer) {
        match (alone, found) {
            (Answer::Stands(alone), Answer::Stands(found)) => {
                assert_eq!(alone.mode, found.mode);
                for ((of, alone), (other, found)) in alone.figures().zip(found.figures()) {
                    assert_eq!((of, alone.is_some()), (other, found.is_some()));
                    if let Some((alone, found)) = alone.zip(found) {
                        equal_figures(alone, found, of.name());
                    }
                }
                assert_eq!(alone.figures().count(), found.figures().count());
            }
            (Answer::Falls { fall, enough }, Answer::Falls { fall: other, enough: found }) => {
                assert_eq!((fall, enough.is_some()), (other, found.is_some()));
                let all = |x: &Option<Box<Enough>>| {
                    let x = x.as_deref()?;
                    let Enough { sliding_friction, friction, half_opening } = x.clone();
                    Some([sliding_friction, friction, half_opening])
                };
                let all = all(enough).into_iter().flatten().zip(all(found).into_iter().flatten());
                for (alone, found) in all {
                    assert_eq!(alone.is_some(), found.is_some());
                    if let Some((alone, found)) = alone.zip(found) {
                        equal_figures(&alone, &found, "what would be enough");
                    }
                }
            }
            _ => panic!("{alone:?} is not {found:?}"),
        }
    }

    fn same(opening: &SharedOpening, friction: &str) -> bool {
        let friction: Friction = friction.parse().unwrap();
        let arch = opening.arch(friction.clone()).unwrap();
        let found = opening.certify(friction, false).unwrap();
        equal(&arch.certify_alone(opening.digits).unwrap(), &found);
        matches!(found, Cow::Borrowed(_))
    }

    fn same_with_frictions(opening: &SharedOpening, friction: &str) {
        let arch = opening.arch(friction.parse().unwrap()).unwrap();
        let found = opening.certify(friction.parse().unwrap(), true);
        match (arch.certify(opening.digits), found) {
            (Ok(alone), Ok(found)) => equal(&alone, &found),
            (alone, found) => assert_eq!(alone.err(), found.err(), "{arch}"),
        }
    }

    /// Half openings that rotate, that overturn and that fall whatever the friction.
    const OPENINGS: [&str; 6] = ["1e-3", "1/2", "80deg", "2.45", "2.62", "2.85"];

    #[test]
    fn an_opening_answers_as_each_of_its_arches_alone() {
        let mut shared = 0;
        let frictions =
            ["1e-9", "1/10", "0.35", "0.4", "tan(22deg)", "60deg", "1.35", "2", "50", "1e30"];
        for weight in SelfWeight::ALL {
            for alpha in OPENINGS {
                let opening = SharedOpening::new(weight, alpha.parse().unwrap(), 17).unwrap();
                shared += frictions.iter().filter(|mu| same(&opening, mu)).count();
            }
        }
        assert!(shared > 70, "{shared} of 120");
    }

    #[test]
    fn an_opening_has_the_frictions_of_each_of_its_arches_and_what_would_be_enough() {
        for (weight, digits) in [(SelfWeight::Milankovitch, 17), (SelfWeight::Heyman, 30)] {
            for alpha in OPENINGS {
                let opening = SharedOpening::new(weight, alpha.parse().unwrap(), digits).unwrap();
                let frictions = ["0", "1e-9", "0.35", "tan(40deg)", "1.35", "50", "inf"];
                frictions.iter().for_each(|mu| same_with_frictions(&opening, mu));
            }
        }
    }

    /// Next to the frictions at which the answer changes, to either side: the outward bounds of what is proved of them.
    #[test]
    fn an_opening_answers_next_to_where_the_mode_changes() {
        for weight in SelfWeight::ALL {
            for alpha in ["1/2", "80deg", "2.3"] {
                let opening = SharedOpening::new(weight, alpha.parse().unwrap(), 17).unwrap();
                for digits in [17, 45] {
                    let arch = Arch::parse(weight.name(), alpha, "inf").unwrap();
                    let Answer::Stands(state) = arch.certify(digits).unwrap() else { panic!() };
                    let frictions = state.frictions.unwrap();
                    for figure in [frictions.sliding, frictions.rotational.unwrap()] {
                        let Rounded { lower, value, upper, .. } = figure.decimal;
                        same_with_frictions(&opening, &value.to_string());
                        let nearest = [lower, value, upper]
                            .map(|mu| same(&opening, &mu.to_string()))
                            .into_iter()
                            .filter(|shared| *shared)
                            .count();
                        // Nearer than the balls can tell, each is proved alone.
                        assert!(digits < 40 || nearest == 0, "{alpha}");
                        let doubles = [figure.binary.lower, figure.binary.upper];
                        for double in doubles {
                            let exact = rug::Rational::from_f64(double).unwrap();
                            let shared = same(&opening, &exact.to_string());
                            assert_eq!(shared_at(&opening, double).is_some(), shared);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn a_friction_that_makes_no_sense_is_refused() {
        let opening = SharedOpening::new(SelfWeight::Heyman, "1".parse().unwrap(), 17).unwrap();
        for friction in ["-1", "-1e-300", "tan(91deg)", "200deg", "tan(-1)"] {
            let found = opening.certify(friction.parse().unwrap(), false);
            assert!(matches!(found, Err(Error::Refused(Refused::Arch(_)))), "{friction}");
        }
        assert!(same(&opening, "1e-30") && same(&opening, "89deg"));
        assert!(!same(&opening, "0"));
        for friction in [0.0, -1.0, f64::NAN, f64::INFINITY, -f64::INFINITY, 5e-324] {
            assert!(shared_at(&opening, friction).is_none(), "{friction}");
        }
        assert!(shared_at(&opening, 1e-30).is_some() && shared_at(&opening, 50.0).is_some());
        assert!(SharedOpening::new(SelfWeight::Heyman, "pi".parse().unwrap(), 17).is_err());
        let none = SharedOpening::new(SelfWeight::Heyman, "1".parse().unwrap(), 0).unwrap_err();
        assert!(matches!(none, Refused::Digits { asked: 0, .. }));
    }
}
