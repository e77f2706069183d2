//! Forces of asymmetric states in balls: all of them are looked at, box by box.
//!
//! A state of a kind of [`AsymmetricMode`](crate::arch::asymmetric::AsymmetricMode) touches the extrados at `b0`
//! and the intrados at `b1`. These two and the thickness follow from the thrust `h` and the vertical force `v`,
//! whatever the half opening and the friction are; the shoulder that slides then leaves one friction to each half
//! opening. There are three bounds of the half opening `alpha`:
//!
//! | bound | where it is reached | a state needs |
//! |---|---|---|
//! | `alpha_I` | an inner joint slides: (17) and (18) hold at `alpha - v` | `alpha >= alpha_I` |
//! | `alpha_Q` | the hinges and the shoulder fit | `alpha >= alpha_Q` |
//! | `alpha_U` | the shoulder opens | `alpha <= alpha_U` |
//!
//! and one of the three has to be reached. So what is asked is where `max(alpha_I, alpha_Q) <= alpha_U`. `wide`
//! proves that it is so only in a rectangle of `h = cos² chi` and `v`, and `near` looks at that rectangle.

mod near;
mod wide;

pub(super) use near::{Directions, known};
pub(super) use wide::elsewhere;

use crate::arch::cycloid;
use crate::number::{Angle, DoubleBall, Real};

/// Range of inclinations `chi` and of vertical forces in which the states are, each a number of 64ths.
#[derive(Clone, Copy, Debug)]
pub(super) struct ForceRectangle {
    /// Least and largest inclination.
    pub inclinations: [i32; 2],
    /// Largest vertical force; the least is zero.
    pub vertical: i32,
}

/// The rectangle in which all states are: `h` from 0.08 to 0.33, `v` up to 1/4.
pub(super) const RECTANGLE: ForceRectangle =
    ForceRectangle { inclinations: [62, 83], vertical: 16 };

/// The parts of one in which a rectangle is written.
const PARTS: i32 = 64;

/// An interval with exact ends.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Span {
    low: f64,
    high: f64,
}

impl Span {
    /// The interval between two numbers of 64ths.
    fn of_parts([low, high]: [i32; 2]) -> Self {
        let part = |n: i32| f64::from(n) / f64::from(PARTS);
        Self { low: part(low), high: part(high) }
    }

    /// Halves of the interval.
    fn halves(self) -> [Self; 2] {
        let middle = self.middle();
        [Self { high: middle, ..self }, Self { low: middle, ..self }]
    }

    fn middle(self) -> f64 {
        (self.low + self.high) / 2.0
    }

    fn width(self) -> f64 {
        self.high - self.low
    }

    /// The ball that is the interval: its ends have few bits, so that nothing is rounded.
    fn ball(self) -> DoubleBall {
        DoubleBall::new(self.middle(), self.width() / 2.0)
    }
}

/// A box of forces: the thrust by its inclination, and the vertical force.
#[derive(Clone, Copy, Debug)]
struct ForceBox {
    inclination: Span,
    vertical: Span,
}

impl ForceBox {
    /// `h` times the sine less the weight times the cosine of the inclination with which (17) and (18) hold at `alpha -
    /// v`: negative where an inner joint slides before the shoulder does.
    fn room_inside(self, half_opening: &DoubleBall) -> DoubleBall {
        let inclination = Angle::new(self.inclination.ball());
        inner_room(&inclination, &self.vertical.ball(), half_opening)
    }

    /// Halves of the box across its longest side.
    fn halves(&self) -> Option<[Self; 2]> {
        Some(match self.inclination.width() > self.vertical.width() {
            true => self.inclination.halves().map(|inclination| Self { inclination, ..*self }),
            false => self.vertical.halves().map(|vertical| Self { vertical, ..*self }),
        })
    }
}

fn inner_room<T: Real>(inclination: &Angle<T>, vertical: &T, half_opening: &T) -> T {
    let carried = half_opening.clone() - vertical;
    let shoulder = Angle::new(carried.clone() - cycloid::friction_angle(inclination));
    cycloid::shoulder(&carried, &shoulder, &cycloid::thrust(inclination))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In the certified solution with an inner slip of the half opening 2.3 and the friction 1.05.
    #[test]
    fn an_inner_joint_slides_where_it_is_known_to() {
        let exact = |x: f64| Span { low: x, high: x };
        let thrust: f64 = 0.180_668_643_785_119_95;
        let place = ForceBox {
            inclination: exact(thrust.sqrt().acos()),
            vertical: exact(0.062_749_253_520_080_37),
        };
        let room = |half_opening: f64| place.room_inside(&DoubleBall::exact(half_opening)).mid();
        assert!(room(2.3).abs() < 1e-14);
        assert!(room(2.301) > 1e-4 && room(2.299) < -1e-4, "false twins");
    }

    #[test]
    fn halves_are_the_whole() {
        let span = Span::of_parts([62, 83]);
        let [low, high] = span.halves();
        assert_eq!((low.low, low.high, high.high), (span.low, high.low, span.high));
        assert_eq!(span.ball().mid() - span.ball().rad(), 0.96875);
    }
}
