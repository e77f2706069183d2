//! One half opening at many frictions: what its arches share is proved once.
//!
//! From its rotational friction on an arch has the state that it has at unlimited friction; below its purely sliding
//! friction it falls; and where none stands at unlimited friction, none stands. Both frictions are proved with that
//! state, in balls of double-doubles. A friction that is proved to lie beside them needs that comparison alone; one
//! that these balls cannot tell from them, and every one between them, is proved on its own. So the answers are those
//! that each arch has alone, to the last digit.

use super::certify::Certify;
use super::digits::Answer;
use super::mode::{Asked, outcome, pure_sliding};
use super::query::{DOUBLE_DOUBLE, Query};
use super::state::{Fall, Outcome};
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::number::{DoubleDouble, DoubleDoubleBall, Enclosure, ExactNumber, Real};
use crate::problem::{Arch, ArchError, Friction};
use std::borrow::Cow;

/// The arches of one half opening and weight, whatever their friction.
///
/// ```
/// use couplet::certify::state::{Answer, Column};
/// use couplet::prelude::*;
/// let column = Column::new(SelfWeight::Milankovitch, "80deg".parse()?, 17)?;
/// for friction in ["0.1", "0.35", "0.6", "1.2"] {
///     match &*column.certify_alone(friction.parse()?)?? {
///         Answer::Stands(state) => println!("{friction}: {} {}", state.mode, state.thickness),
///         Answer::Falls { fall, .. } => println!("{friction}: {}", fall.reason()),
///     }
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
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
}

impl Column {
    /// The arches of a half opening in `(0, pi)`, with values to `digits` significant digits, at least one. It costs
    /// about as much as two arches.
    pub fn new(
        weight: SelfWeight,
        half_opening: ExactNumber,
        digits: usize,
    ) -> Result<Self, ArchError> {
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
        Ok(Self { unlimited, digits, answer, sliding, same_from, slides })
    }

    /// What [`Certify::certify_alone`] finds for the arch of this friction; an error if that is out of its range.
    pub fn certify_alone(
        &self,
        friction: Friction,
    ) -> Result<Result<Cow<'_, Answer>, Undecided>, ArchError> {
        if let Friction::Coefficient(mu) = &friction
            && let Some(answer) = self.shared(&mu.enclosure(DOUBLE_DOUBLE))
        {
            return Ok(Ok(Cow::Borrowed(answer)));
        }
        let (weight, alpha) = (self.unlimited.weight(), self.unlimited.half_opening());
        let arch = Arch::new(weight, alpha.clone(), friction)?;
        if let Friction::Angle(phi) = arch.friction() {
            let (sin, cos) = phi.enclosure::<DoubleDoubleBall>(DOUBLE_DOUBLE).sin_cos();
            if let Some(answer) = self.shared(&(sin / cos)) {
                return Ok(Ok(Cow::Borrowed(answer)));
            }
        }
        Ok(arch.certify_alone(self.digits).map(Cow::Owned))
    }

    /// The same of a friction that is a double, as the number that it is, if no proof of its own is needed: much
    /// quicker. None says nothing.
    pub fn shared_at(&self, friction: f64) -> Option<&Answer> {
        // Far below that their parts would be out of range.
        let is_ordinary = (1e-100..1e100).contains(&friction);
        let exact = || DoubleDoubleBall::exact(DoubleDouble::exact(friction));
        is_ordinary.then(exact).and_then(|friction| self.shared(&friction))
    }

    /// The answer at a friction, if no proof of its own is needed; none for one that is not positive.
    fn shared(&self, friction: &DoubleDoubleBall) -> Option<&Answer> {
        let exceeds = |bound: &DoubleDoubleBall| bound.is_less_than(friction).is_proved();
        let sliding = self.sliding.as_ref()?;
        if friction.is_less_than(sliding).is_proved() {
            return friction.is_positive().is_proved().then_some(&self.slides);
        }
        exceeds(self.same_from.as_ref()?).then_some(self.answer.as_ref()?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rounded;

    fn same(column: &Column, friction: &str) -> bool {
        let friction: Friction = friction.parse().unwrap();
        let (weight, alpha) = (column.unlimited.weight(), column.unlimited.half_opening());
        let alone = Arch::new(weight, alpha.clone(), friction.clone()).unwrap();
        let alone = alone.certify_alone(column.digits).unwrap();
        let found = column.certify_alone(friction).unwrap().unwrap();
        match (&alone, &*found) {
            (Answer::Stands(alone), Answer::Stands(found)) => {
                assert_eq!(alone.mode, found.mode);
                let figures = alone.figures().zip(found.figures());
                for ((of, alone), (other, found)) in figures {
                    let (alone, found) = (alone.unwrap(), found.unwrap());
                    assert_eq!((of, &alone.decimal), (other, &found.decimal));
                    let doubles = |x: &super::super::Figure| {
                        [x.double, x.binary.lower, x.binary.upper].map(f64::to_bits)
                    };
                    assert_eq!(doubles(alone), doubles(found), "{of:?}");
                }
                assert_eq!(alone.figures().count(), found.figures().count());
            }
            (Answer::Falls { fall, .. }, Answer::Falls { fall: found, .. }) => {
                assert_eq!(fall, found)
            }
            _ => panic!("{alone:?} is not {found:?}"),
        }
        matches!(found, Cow::Borrowed(_))
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
            assert!(column.certify_alone(friction.parse().unwrap()).is_err(), "{friction}");
        }
        assert!(same(&column, "1e-30") && same(&column, "89deg"));
        assert!(!same(&column, "0"));
        for friction in [0.0, -1.0, f64::NAN, f64::INFINITY, -f64::INFINITY, 5e-324] {
            assert!(column.shared_at(friction).is_none(), "{friction}");
        }
        assert!(column.shared_at(1e-30).is_some() && column.shared_at(50.0).is_some());
        assert!(Column::new(SelfWeight::Heyman, "pi".parse().unwrap(), 17).is_err());
    }
}
