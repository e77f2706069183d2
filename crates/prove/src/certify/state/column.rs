//! One half opening at many frictions: what its arches share is proved once.
//!
//! From its rotational friction on an arch has the state that it has at unlimited friction; below its purely sliding
//! friction it falls; and where none stands at unlimited friction, none stands. Both frictions are proved with that
//! state, in balls of double-doubles. A friction that is proved to lie beside them needs that comparison alone; one
//! that these balls cannot tell from them, and every one between them, is proved on its own. The two frictions are
//! those of the half opening, whatever the friction of the arch. So the answers are those that each arch has alone, to
//! the last digit.

use super::certify::Certify;
use super::digits::{Answer, Digits};
use super::enough::{AtOpening, Enough};
use super::mode::{Asked, outcome, pure_sliding};
use super::query::{DOUBLE_DOUBLE, Query};
use super::quick::is_quick;
use super::state::{Fall, Frictions, Outcome};
use crate::arch::SelfWeight;
use crate::number::{DoubleDouble, DoubleDoubleBall, Enclosure, ExactNumber, Real};
use crate::problem::{Arch, Friction};
use crate::prover::Figure;
use crate::prover::{Error, Refused};
use std::borrow::Cow;
use std::sync::OnceLock;

/// The arches of one half opening and weight, whatever their friction.
///
/// ```
/// use couplet_prove::certify::state::{Answer, Column};
/// use couplet_prove::prelude::*;
/// let column = Column::new(SelfWeight::Milankovitch, "80deg".parse()?, 17)?;
/// for friction in ["0.1", "0.35", "0.6", "1.2"] {
///     match &*column.certify_alone(friction.parse()?)? {
///         Answer::Stands(state) => println!("{friction}: {} {}", state.mode, state.thickness),
///         Answer::Falls { fall, .. } => println!("{friction}: {}", fall.reason()),
///     }
/// }
/// # Ok::<(), couplet_prove::certify::Error>(())
/// ```
///
/// See also: [`Certify::certify_alone`], which answers one.
#[derive(Debug)]
pub struct Column {
    /// At unlimited friction.
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
    /// What would be enough at this half opening, asked for by the first arch that falls.
    enough: OnceLock<AtOpening>,
}

impl Column {
    /// The arches of a half opening in `(0, pi)`, with values to `digits` significant digits. It costs about as much as two
    /// arches. Any other half opening, and digits beyond [`MAX_ARCH_DIGITS`](crate::certify::MAX_ARCH_DIGITS), are refused.
    pub fn new(
        weight: SelfWeight,
        half_opening: ExactNumber,
        digits: usize,
    ) -> Result<Self, Refused> {
        Refused::arch_digits(digits)?;
        let unlimited = Arch::new(weight, half_opening, Friction::Infinite)?;
        let query = Query::<DoubleDoubleBall>::new(&unlimited, DOUBLE_DOUBLE);
        let (sliding, same_from) = match outcome(&query, Asked::Frictions) {
            Ok(Outcome::Stands(state)) => match state.frictions {
                Some(frictions) => (Some(frictions.sliding), frictions.rotational),
                None => (None, None),
            },
            // With less friction nothing stands either.
            Ok(Outcome::Falls(_)) => {
                let sliding = pure_sliding(&query).ok();
                (sliding, sliding)
            }
            Err(_) => (None, None),
        };
        let answer = same_from.as_ref().and_then(|_| unlimited.certify_alone(digits).ok());
        let slides = Answer::Falls { fall: Fall::Sliding, enough: None };
        let (frictions, enough) = (OnceLock::new(), OnceLock::new());
        Ok(Self { unlimited, digits, answer, sliding, same_from, slides, frictions, enough })
    }

    /// What [`Certify::certify_alone`] finds for the arch of this friction; refused if that is out of its range.
    pub fn certify_alone(&self, friction: Friction) -> Result<Cow<'_, Answer>, Error> {
        if let Friction::Coefficient(mu) = &friction
            && let Some(answer) = self.shared(&mu.enclosure(DOUBLE_DOUBLE))
        {
            return Ok(Cow::Borrowed(answer));
        }
        self.alone(&self.arch(friction)?)
    }

    /// What [`Certify::certify`] finds for the arch of this friction, with the frictions at which its mode changes; refused
    /// if that is out of its range.
    ///
    /// ```
    /// use couplet_prove::certify::state::{Answer, Column};
    /// use couplet_prove::prelude::*;
    /// let column = Column::new(SelfWeight::Milankovitch, "80deg".parse()?, 17)?;
    /// let Answer::Stands(state) = column.certify("0.6".parse()?)? else { panic!() };
    /// assert_eq!(state.frictions.unwrap().sliding.to_string(), "0.21939417869493803");
    /// # Ok::<(), couplet_prove::certify::Error>(())
    /// ```
    pub fn certify(&self, friction: Friction) -> Result<Answer, Error> {
        self.whole(&self.arch(friction)?)
    }

    /// The arch of a friction.
    fn arch(&self, friction: Friction) -> Result<Arch, Refused> {
        Ok(Arch::new(self.unlimited.weight(), self.unlimited.half_opening().clone(), friction)?)
    }

    /// What is found for an arch of this half opening and weight, without frictions.
    pub(super) fn alone(&self, arch: &Arch) -> Result<Cow<'_, Answer>, Error> {
        let shared = match Self::enclosed(arch.friction()) {
            Some(friction) => self.shared(&friction),
            None => self.answer.as_ref(),
        };
        match shared {
            Some(answer) => Ok(Cow::Borrowed(answer)),
            None => arch.certify_alone(self.digits).map(Cow::Owned),
        }
    }

    /// The same with them.
    pub(super) fn whole(&self, arch: &Arch) -> Result<Answer, Error> {
        match self.alone(arch).map(Cow::into_owned) {
            Ok(Answer::Stands(state)) => {
                if let Some(frictions) = self.frictions() {
                    let frictions = Some(frictions.clone());
                    return Ok(Answer::Stands(Box::new(Digits { frictions, ..*state })));
                }
            }
            Ok(Answer::Falls { fall, .. }) => {
                let is_quick = is_quick(self.digits);
                let at =
                    kept(&self.enough, || AtOpening::new(&self.unlimited, self.digits, is_quick));
                let enough = Enough::new(arch, at, self.digits, is_quick);
                return Ok(Answer::Falls { fall, enough: Some(Box::new(enough)) });
            }
            // With the frictions other things may be left open.
            Err(_) => {}
        }
        arch.certify(self.digits)
    }

    /// The frictions of the half opening.
    fn frictions(&self) -> Option<&Frictions<Figure>> {
        let proved = || match self.unlimited.certify(self.digits) {
            Ok(Answer::Stands(state)) => state.frictions,
            _ => None,
        };
        kept(&self.frictions, proved).as_ref()
    }

    /// A friction as columns compare it with their own; none if it is unlimited.
    pub fn enclosed(friction: &Friction) -> Option<DoubleDoubleBall> {
        match friction {
            Friction::Coefficient(mu) => Some(mu.enclosure(DOUBLE_DOUBLE)),
            Friction::Angle(phi) => {
                let (sin, cos) = phi.enclosure::<DoubleDoubleBall>(DOUBLE_DOUBLE).sin_cos();
                Some(sin / cos)
            }
            Friction::Infinite => None,
        }
    }

    /// The same of a friction that is a double, as the number that it is, if no proof of its own is needed: much
    /// quicker. None says nothing.
    pub fn shared_at(&self, friction: f64) -> Option<&Answer> {
        // Far below that their parts would be out of range.
        let is_ordinary = (1e-100..1e100).contains(&friction);
        let exact = || DoubleDoubleBall::exact(DoubleDouble::exact(friction));
        is_ordinary.then(exact).and_then(|friction| self.shared(&friction))
    }

    /// The same of a friction in an enclosure, which may be asked of many columns; one that is not positive has none.
    pub fn shared(&self, friction: &DoubleDoubleBall) -> Option<&Answer> {
        let exceeds = |bound: &DoubleDoubleBall| bound.is_less_than(friction).is_proved();
        let sliding = self.sliding.as_ref()?;
        if friction.is_less_than(sliding).is_proved() {
            return friction.is_positive().is_proved().then_some(&self.slides);
        }
        exceeds(self.same_from.as_ref()?).then_some(self.answer.as_ref()?)
    }
}

/// What is proved once. Threads that ask for it at a time each prove it: none waits for another, whose proof may wait for
/// the work of this one.
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
    use crate::number::Rounded;

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

    fn same(column: &Column, friction: &str) -> bool {
        let friction: Friction = friction.parse().unwrap();
        let arch = column.arch(friction.clone()).unwrap();
        let found = column.certify_alone(friction).unwrap();
        equal(&arch.certify_alone(column.digits).unwrap(), &found);
        matches!(found, Cow::Borrowed(_))
    }

    fn same_with_frictions(column: &Column, friction: &str) {
        let arch = column.arch(friction.parse().unwrap()).unwrap();
        let found = column.certify(friction.parse().unwrap());
        match (arch.certify(column.digits), found) {
            (Ok(alone), Ok(found)) => equal(&alone, &found),
            (alone, found) => assert_eq!(alone.err(), found.err(), "{arch}"),
        }
    }

    /// Those that rotate, that overturn and that fall whatever the friction.
    const OPENINGS: [&str; 6] = ["1e-3", "1/2", "80deg", "2.45", "2.62", "2.85"];

    #[test]
    fn a_column_answers_as_each_of_its_arches_alone() {
        let mut shared = 0;
        let frictions =
            ["1e-9", "1/10", "0.35", "0.4", "tan(22deg)", "60deg", "1.35", "2", "50", "1e30"];
        for weight in SelfWeight::ALL {
            for alpha in OPENINGS {
                let column = Column::new(weight, alpha.parse().unwrap(), 17).unwrap();
                shared += frictions.iter().filter(|mu| same(&column, mu)).count();
            }
        }
        assert!(shared > 70, "{shared} of 120");
    }

    #[test]
    fn a_column_has_the_frictions_of_each_of_its_arches_and_what_would_be_enough() {
        for (weight, digits) in [(SelfWeight::Milankovitch, 17), (SelfWeight::Heyman, 30)] {
            for alpha in OPENINGS {
                let column = Column::new(weight, alpha.parse().unwrap(), digits).unwrap();
                let frictions = ["0", "1e-9", "0.35", "tan(40deg)", "1.35", "50", "inf"];
                frictions.iter().for_each(|mu| same_with_frictions(&column, mu));
            }
        }
    }

    /// Next to the frictions at which the answer changes, to either side: the outward bounds of what is proved of them.
    #[test]
    fn a_column_answers_next_to_where_the_mode_changes() {
        for weight in SelfWeight::ALL {
            for alpha in ["1/2", "80deg", "2.3"] {
                let column = Column::new(weight, alpha.parse().unwrap(), 17).unwrap();
                for digits in [17, 45] {
                    let arch = Arch::parse(weight.name(), alpha, "inf").unwrap();
                    let Answer::Stands(state) = arch.certify(digits).unwrap() else { panic!() };
                    let frictions = state.frictions.unwrap();
                    for figure in [frictions.sliding, frictions.rotational.unwrap()] {
                        let Rounded { lower, value, upper, .. } = figure.decimal;
                        same_with_frictions(&column, &value.to_string());
                        let nearest = [lower, value, upper]
                            .map(|mu| same(&column, &mu.to_string()))
                            .into_iter()
                            .filter(|shared| *shared)
                            .count();
                        // Nearer than the balls can tell, each is proved alone.
                        assert!(digits < 40 || nearest == 0, "{alpha}");
                        let doubles = [figure.binary.lower, figure.binary.upper];
                        for double in doubles {
                            let exact = rug::Rational::from_f64(double).unwrap();
                            let shared = same(&column, &exact.to_string());
                            assert_eq!(column.shared_at(double).is_some(), shared);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn a_friction_that_makes_no_sense_is_refused() {
        let column = Column::new(SelfWeight::Heyman, "1".parse().unwrap(), 17).unwrap();
        for friction in ["-1", "-1e-300", "tan(91deg)", "200deg", "tan(-1)"] {
            let found = column.certify_alone(friction.parse().unwrap());
            assert!(matches!(found, Err(Error::Refused(Refused::Arch(_)))), "{friction}");
        }
        assert!(same(&column, "1e-30") && same(&column, "89deg"));
        assert!(!same(&column, "0"));
        for friction in [0.0, -1.0, f64::NAN, f64::INFINITY, -f64::INFINITY, 5e-324] {
            assert!(column.shared_at(friction).is_none(), "{friction}");
        }
        assert!(column.shared_at(1e-30).is_some() && column.shared_at(50.0).is_some());
        assert!(Column::new(SelfWeight::Heyman, "pi".parse().unwrap(), 17).is_err());
        let none = Column::new(SelfWeight::Heyman, "1".parse().unwrap(), 0).unwrap_err();
        assert!(matches!(none, Refused::Digits { asked: 0, .. }));
    }
}
