//! Rationals with few decimals, which is how a table is printed.

use crate::number::{Ball, terminating};
use rug::ops::{DivRounding, Pow};
use rug::{Float, Integer, Rational};

/// Longer numerals do not occur.
const DIGITS: usize = 100;
/// Smaller numbers do not occur.
const MOST: u32 = 90;

/// A rational number that ends after some decimals, as Coq reads it.
pub(super) fn text(value: &Rational) -> String {
    terminating(value, DIGITS).map_or_else(|| value.to_string(), |d| d.to_string())
}

/// A rational number as a fraction.
pub(super) fn fraction(value: &Rational) -> String {
    if value.is_integer() {
        value.to_string()
    } else {
        format!("{} / {}", value.numer(), value.denom())
    }
}

/// The multiple of `10^-places` nearest to `value`.
pub(super) fn nearest(value: &Rational, places: u32) -> Rational {
    scaled(value, places, |x| Rational::from(x.round_ref()).numer().clone())
}

/// The least multiple of `10^-places` not below `value`.
pub(super) fn up(value: &Rational, places: u32) -> Rational {
    scaled(value, places, |x| x.numer().clone().div_ceil(x.denom()))
}

/// The greatest multiple of `10^-places` not above `value`.
pub(super) fn down(value: &Rational, places: u32) -> Rational {
    scaled(value, places, |x| x.numer().clone().div_floor(x.denom()))
}

/// Number of decimals that show `digits` significant digits of a positive number below one.
pub(super) fn places(value: &Rational, digits: u32) -> u32 {
    let one = Rational::from(1);
    (0..MOST).find(|&n| value.clone() * power(n) >= one).unwrap_or(MOST) + digits - 1
}

/// `10^-places`.
pub(super) fn unit(places: u32) -> Rational {
    Rational::from((1, power(places)))
}

/// The exact value of a finite float.
pub(super) fn exact(value: &Float) -> Rational {
    value.to_rational().unwrap_or_default()
}

/// The radius of a ball.
pub(super) fn radius(ball: &Ball) -> Rational {
    exact(&ball.rad().to_float())
}

/// The largest absolute value that `ball - centre` can have.
pub(super) fn distance(ball: &Ball, centre: &Rational) -> Rational {
    (exact(ball.mid()) - centre).abs() + radius(ball)
}

fn power(places: u32) -> Integer {
    Integer::from(10).pow(places)
}

fn scaled(value: &Rational, places: u32, round: impl Fn(&Rational) -> Integer) -> Rational {
    let power = power(places);
    let scaled = value.clone() * &power;
    Rational::from((round(&scaled), power))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_goes_where_it_says() {
        let third = Rational::from((-1, 3));
        assert_eq!(text(&nearest(&third, 3)), "-0.333");
        assert_eq!(text(&up(&third, 3)), "-0.333");
        assert_eq!(text(&down(&third, 3)), "-0.334");
        assert_eq!(text(&unit(30)), "1e-30");
        assert_eq!(text(&Rational::from(2)), "2");
        assert_eq!(places(&Rational::from((3, 1000)), 2), 4);
        assert_eq!(places(&Rational::from((3, 10)), 2), 2);
    }
}
