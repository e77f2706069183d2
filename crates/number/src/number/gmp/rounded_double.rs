//! Decimal output of balls of double-doubles and of three words, in which every digit is proved: [`Rounded::from_ball`]
//! in integers of fixed length, without a heap.

use super::{Ball, Decimal, Rounded, TripleWordBall};
use crate::number::{DoubleDouble, DoubleDoubleBall, double::exponent, float_ball::power_of_two};
use std::f64::consts::LOG10_2;
use std::io::Write;

/// Digits beyond this are left to balls of MPFR.
const MOST_DIGITS: usize = 33;
/// Sizes of the midpoint, as powers of two.
const EXPONENTS: std::ops::RangeInclusive<i32> = -120..=60;
/// The bits of the midpoint as an integer.
const BITS: i32 = 119;

/// The true value of `ball` rounded to `digits` significant digits, in the sense of [`Rounded::from_ball`]: the same
/// answer, or none. There is none for zero, beyond 33 digits, and for sizes outside `2^-120` to `2^60`.
pub fn rounded_double(ball: &DoubleDoubleBall, digits: usize) -> Option<Rounded> {
    let is_negative = ball.mid().hi() < 0.0;
    let middle = if is_negative { -ball.mid() } else { ball.mid() };
    let scale = scale(exponent(middle.hi()))?;
    let near = |places| near_cell(&middle, ball.rad(), places);
    if (1..=FEW).contains(&digits)
        && let Some(found) = in_cell(is_negative, middle.hi(), digits, near)
    {
        return Some(found);
    }
    // In units of 2^-scale the first part is an integer, and the second is rounded down.
    let floor = shifted(middle.hi(), scale)? + shifted(middle.lo(), scale)?;
    rounded(is_negative, floor, scale, ball.rad(), digits)
}

/// True value of a ball of three words, rounded in the same way.
pub fn rounded_words(ball: &TripleWordBall, digits: usize) -> Option<Rounded> {
    let (is_negative, [_, middle, high], exponent) = ball.mid().parts();
    let scale = scale(exponent + 191)?;
    // The leading bits.
    let floor = (u128::from(high) << 64 | u128::from(middle)) >> (128 - BITS);
    rounded(is_negative, floor as i128, scale, ball.rad(), digits)
}

/// The power of two by which a number of a size becomes an integer of [`BITS`]; `None` out of range.
fn scale(exponent: i32) -> Option<i32> {
    EXPONENTS.contains(&exponent).then_some(BITS - 1 - exponent)
}

/// A number within `rad` of one that is `floor 2^-scale`, or above by less than a unit.
fn rounded(is_negative: bool, floor: i128, scale: i32, rad: f64, digits: usize) -> Option<Rounded> {
    if !(1..=MOST_DIGITS).contains(&digits) {
        return None;
    }
    let radius = (rad * power_of_two(scale)).ceil() + 1.0;
    if !(0.0..power_of_two(BITS - 2)).contains(&radius) {
        return None;
    }
    // All numbers of the ball lie between `low` and `low + width`.
    let low = u128::try_from(floor - radius as i128).ok()?;
    let width = 2 * radius as u128 + 1;
    let size = floor as f64 * power_of_two(-scale);
    in_cell(is_negative, size, digits, |places| cell(low, width, places, scale))
}

/// Numbers about a size, rounded: `cell` tells the cell of a grid of so many decimal places in which they lie. One
/// digit more than asked for tells the halves of a unit apart.
fn in_cell(
    is_negative: bool,
    size: f64,
    digits: usize,
    cell: impl Fn(i32) -> Option<DecimalCell>,
) -> Option<Rounded> {
    // The estimate may be off by one either way.
    let mut places = digits as i32 - (f64::from(exponent(size)) * LOG10_2).floor() as i32;
    let (cell, exponent) = [0; 3].into_iter().find_map(|_| {
        let cell = cell(places)?;
        let length = length(cell.number) as i32;
        let found = (length == digits as i32 + 1).then_some((cell, 1 - places));
        places += digits as i32 + 1 - length;
        found
    })?;
    if !cell.holds_all {
        return None;
    }
    let (below, last) = (cell.number / 10, cell.number % 10);
    let decimal = |number: u128| {
        // 999 becomes 100 and a higher power of ten: the number of digits stays.
        let (number, exponent) = match length(number) > digits {
            true => (number / 10, exponent + 1),
            false => (number, exponent),
        };
        let mut text = [0; MOST_DIGITS + 1];
        write!(&mut text[..], "{number}").ok()?;
        let text = std::str::from_utf8(&text[..length(number)]).ok()?;
        Some(Decimal::new(is_negative, text, exponent.into()))
    };
    Some(Rounded::between([decimal(below)?, decimal(below + 1)?], last >= 5, is_negative))
}

/// Digits up to which doubles nearly always tell the cell.
const FEW: usize = 6;
/// Powers of ten, each the nearest double.
const TENS: [f64; 39] = {
    let mut tens = [1.0; 39];
    let mut exponent = 0;
    while exponent < tens.len() {
        tens[exponent] = 10u128.pow(exponent as u32) as f64;
        exponent += 1;
    }
    tens
};

/// The cell of the grid of `10^-places` in which a number within `rad` of a positive `middle` lies.
///
/// With `h` and `l` the parts of `middle` and `P` the power of ten, such a number times `P` is within `(|l| + rad) P`
/// of `h P`. Two roundings each, `P`'s and the product's, and those of the sums change both by less than `2^-49 h P`,
/// as `|l| + rad` is below `h` where one cell of ten and more holds all.
fn near_cell(middle: &DoubleDouble, rad: f64, places: i32) -> Option<DecimalCell> {
    let power = TENS.get(places.unsigned_abs() as usize)?;
    let scaled = |x: f64| if places < 0 { x / power } else { x * power };
    let (middle, rest) = (scaled(middle.hi()), scaled(middle.lo().abs() + rad));
    let slack = rest + middle * power_of_two(-49);
    let (low, high) = (middle - slack, middle + slack);
    let number = middle.floor();
    let holds_all = number < low && high < number + 1.0;
    Some(DecimalCell { number: number as u128, holds_all })
}

/// `floor(x 2^scale)`; `None` for a subnormal number, or where the result does not fit.
fn shifted(x: f64, scale: i32) -> Option<i128> {
    const MANTISSA: u64 = (1 << 52) - 1;
    if x == 0.0 {
        return Some(0);
    }
    if !x.is_normal() {
        return None;
    }
    let mantissa = i128::from(x.to_bits() & MANTISSA | (MANTISSA + 1));
    let mantissa = if x < 0.0 { -mantissa } else { mantissa };
    let shift = exponent(x.abs()) - 52 + scale;
    match u32::try_from(shift) {
        Ok(left) => (left < 70).then(|| mantissa << left),
        // The shift of a negative number rounds down too.
        Err(_) => Some(mantissa >> shift.unsigned_abs().min(127)),
    }
}

/// A cell of the decimal grid.
struct DecimalCell {
    /// Lower end in units of the grid.
    number: u128,
    /// True if all numbers lie strictly inside.
    holds_all: bool,
}

/// The cell of the grid of `10^-places` in which `low 2^-scale` lies; `None` out of range.
fn cell(low: u128, width: u128, places: i32, scale: i32) -> Option<DecimalCell> {
    let Ok(places) = u32::try_from(places) else {
        return coarse_cell(low, width, places.unsigned_abs(), u32::try_from(scale).ok()?);
    };
    let power = 5u128.checked_pow(places)?;
    let shift = u32::try_from(scale - places as i32).ok()?;
    let start = Wide::product(low, power);
    let number = start.shifted_down(shift)?;
    let end = start.plus(Wide::product(width, power))?;
    let is_inside = !start.is_multiple_of_power(shift) && end.shifted_down(shift)? == number;
    Some(DecimalCell { number, holds_all: is_inside })
}

/// The cell of the grid of `10^zeros`.
fn coarse_cell(low: u128, width: u128, zeros: u32, scale: u32) -> Option<DecimalCell> {
    let power = 10u128.checked_pow(zeros)?;
    let whole = |x: u128| x.checked_shr(scale).unwrap_or(0);
    let number = whole(low) / power;
    let is_on_grid = whole(low).is_multiple_of(power) && whole(low) << scale == low;
    let end = low.checked_add(width)?;
    Some(DecimalCell { number, holds_all: !is_on_grid && whole(end) / power == number })
}

/// Number of decimal digits of an integer.
fn length(number: u128) -> usize {
    number.checked_ilog10().map_or(1, |log| log as usize + 1)
}

/// An integer of 256 bits: the upper half first.
#[derive(Clone, Copy)]
struct Wide(u128, u128);

impl Wide {
    fn product(a: u128, b: u128) -> Self {
        const LOW: u128 = u64::MAX as u128;
        let (a1, a0, b1, b0) = (a >> 64, a & LOW, b >> 64, b & LOW);
        let (low, high) = (a0 * b0, a1 * b1);
        let (middle, carry) = (a1 * b0).overflowing_add(a0 * b1);
        let (low, more) = low.overflowing_add(middle << 64);
        Self(high + (middle >> 64) + (u128::from(carry) << 64) + u128::from(more), low)
    }

    fn plus(self, other: Self) -> Option<Self> {
        let (low, carry) = self.1.overflowing_add(other.1);
        Some(Self(self.0.checked_add(other.0)?.checked_add(carry.into())?, low))
    }

    /// `floor(self / 2^shift)`; `None` if that has more than 128 bits.
    fn shifted_down(self, shift: u32) -> Option<u128> {
        match shift {
            0 => (self.0 == 0).then_some(self.1),
            1..128 => (self.0 >> shift == 0).then(|| self.0 << (128 - shift) | self.1 >> shift),
            128..256 => Some(self.0 >> (shift - 128)),
            _ => Some(0),
        }
    }

    fn is_multiple_of_power(self, shift: u32) -> bool {
        let zeros =
            if self.1 == 0 { 128 + self.0.trailing_zeros() } else { self.1.trailing_zeros() };
        zeros >= shift
    }
}

/// The double nearest to a number that has a short enclosure and one of any number of bits, ties to even; `None` beyond
/// the largest double.
pub fn nearest_double(short: DoubleDoubleBall, enclosure: impl Fn(u32) -> Ball) -> Option<f64> {
    // Few bits decide nearly always; a tie is rational, and exact in the bits of a long number.
    let long = || [128, 4096, 80_000].into_iter().find_map(|bits| enclosure(bits).nearest_double());
    short.nearest_double().or_else(long).filter(|x| x.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Ball;
    use crate::number::test_config::config;
    use proptest::prelude::*;
    use rug::{Integer, Rational};

    fn same(ball: &DoubleDoubleBall, digits: usize) -> Option<Rounded> {
        let found = rounded_double(ball, digits);
        let by_mpfr = Rounded::from_ball(&ball.to_ball(256), digits);
        if let Some(found) = &found {
            assert_eq!(Some(found), by_mpfr.as_ref(), "{ball:?} to {digits}");
        }
        found
    }

    fn same_of_words(ball: &TripleWordBall, digits: usize) -> Option<Rounded> {
        let found = rounded_words(ball, digits);
        let by_mpfr = Rounded::from_ball(&ball.to_ball(256), digits);
        if let Some(found) = &found {
            assert_eq!(Some(found), by_mpfr.as_ref(), "{ball:?} to {digits}");
        }
        found
    }

    proptest! {
        #![proptest_config(config(4000))]

        /// Large numbers and few digits: the grid is coarser than the integers.
        #[test]
        fn digits_of_large_numbers_are_those_of_balls_of_mpfr(
            head in 1u64..1000, zeros in 0u32..15, off in -2i32..=2, radius in 40i32..110, digits in 1usize..6,
        ) {
            let x = head as f64 * 10f64.powi(zeros as i32);
            let mid = DoubleDouble::sum(x, f64::from(off) * 2f64.powi(-20));
            let ball = DoubleDoubleBall::new(mid, x * f64::powi(2.0, -radius));
            let found = same(&ball, digits);
            prop_assert!(found.is_some() || off == 0 || radius < 80, "{ball:?} to {digits}");
        }

        /// Of three words too, next to a rounding boundary or not.
        #[test]
        fn digits_of_three_words_are_those_of_balls_of_mpfr(
            words in any::<[u64; 3]>(), shift in -300i32..-140, radius in 80i32..190, negative in any::<bool>(),
            head in 1u64..u64::MAX, hair in 1u32..20, digits in 1usize..36,
        ) {
            let mid = Rational::from(Integer::from_digits(&words, rug::integer::Order::Lsf)) << shift;
            let ball = TripleWordBall::from(&Ball::enclosing(&if negative { -mid } else { mid }, 192));
            let ball = ball.widened(ball.mid().hi().abs() * f64::powi(2.0, -radius));
            let found = same_of_words(&ball, digits);
            let is_easy = radius > 130 && digits < 25 && words[2] > 1 << 60 && shift > -250;
            prop_assert!(found.is_some() || !is_easy, "{ball:?} to {digits}");
            let grid = format!("{head:0<20}5").parse::<Integer>().unwrap();
            let step = Rational::from(1) / Integer::from(Integer::u_pow_u(10, hair));
            let near = (Rational::from(grid) + step) / Integer::from(Integer::u_pow_u(10, 25));
            let near = TripleWordBall::from(&Ball::enclosing(&near, 192));
            same_of_words(&near.widened(near.mid().hi() * f64::powi(2.0, -radius)), digits);
        }

        /// Of any numbers the digits are those that balls of MPFR have.
        #[test]
        fn digits_are_those_of_balls_of_mpfr(
            mantissa in 1u64..1 << 53, low in any::<i64>(), shift in -50i32..50, gap in 53i32..120,
            radius in 80i32..140, negative in any::<bool>(), digits in 1usize..26,
        ) {
            let hi = mantissa as f64 * f64::powi(2.0, shift - 52);
            let hi = if negative { -hi } else { hi };
            let mid = DoubleDouble::sum(hi, low as f64 * f64::powi(2.0, shift - 62 - gap));
            let ball = DoubleDoubleBall::new(mid, hi.abs() * f64::powi(2.0, -radius));
            let found = same(&ball, digits);
            // Most are decided.
            let is_easy = radius > 100 && shift < 0 && digits < 12 && low != 0 && gap < 60 && mantissa > 1 << 50;
            prop_assert!(found.is_some() || !is_easy, "{ball:?} to {digits}");
        }

        /// Values made to lie next to a rounding boundary.
        #[test]
        fn next_to_a_boundary_too(
            head in 1u64..u64::MAX, five in any::<bool>(), up in any::<bool>(), hair in 1u32..16,
            places in 0i32..24, digits in 3usize..18, radius in 90i32..108,
        ) {
            let text = format!("{head:0<20}");
            let grid = format!("{}{}", &text[..digits], if five { "5" } else { "0" });
            let scale = Rational::from(Integer::from(Integer::u_pow_u(10, (digits as i32 + places) as u32)));
            let grid = Rational::from(grid.parse::<Integer>().unwrap()) / scale;
            let step = grid.clone() / Integer::from(Integer::u_pow_u(10, digits as u32 + hair));
            let x = if up { grid + step } else { grid - step };
            let near = DoubleDoubleBall::from(&Ball::enclosing(&x, 256));
            let ball = near.widened(near.mid().hi() * f64::powi(2.0, -radius));
            same(&ball, digits);
        }
    }

    #[test]
    fn what_cannot_be_decided_is_not() {
        let of = |x: f64, rad: f64, digits| {
            rounded_double(&DoubleDoubleBall::new(DoubleDouble::exact(x), rad), digits)
        };
        assert!(of(0.0, 0.0, 5).is_none() && of(1.25, 0.0, 2).is_none(), "zero, a tie");
        assert!(of(0.3, f64::INFINITY, 5).is_none() && of(0.3, 1.0, 5).is_none());
        assert!(of(f64::NAN, 1.0, 5).is_none() && of(1e30, 1e-9, 5).is_none());
        assert!(of(0.3, 1e-30, 29).is_none() && of(0.3, 1e-30, 0).is_none());
        assert_eq!(of(0.99996, 1e-20, 4).unwrap().value.to_string(), "1.000");
        // Within the radius of a boundary, and just outside of it.
        let near = |rad| {
            let mid = DoubleDouble::sum(0.5, 1e-25);
            rounded_double(&DoubleDoubleBall::new(mid, rad), 16)
        };
        assert!(near(1.1e-25).is_none() && near(0.9e-25).is_some());
    }
}
