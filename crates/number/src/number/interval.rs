//! Intervals: all numbers from one end to another, each end rounded outward.
//!
//! What an interval is and how its ends combine is written here; what an end is, and who rounds it, in the file of
//! [`Astro`]. A failure, or an end on the wrong side, becomes the whole line.

use super::astro::Astro;
use super::astro::RoundingMode::{Down, Up};
use super::halving::Halving;
use super::{Enclosure, Field, Real, Ternary};
use std::cmp::Ordering;

/// The least precision, bits.
const LEAST: usize = 64;

/// From so many bits on sines are computed by products, which are quicker than what astro-float has.
const HALVED: usize = 512;

/// All real numbers from one astro-float number to another, and the precision of results.
#[derive(Clone, Debug)]
pub struct AstroInterval {
    pub(super) low: Astro,
    pub(super) high: Astro,
    pub(super) prec: usize,
}

impl AstroInterval {
    /// The integer `n`, with results to be rounded to `prec` bits, at least 64.
    pub fn integer(n: i32, prec: usize) -> Self {
        Self::dyadic(n < 0, &[n.unsigned_abs().into()], 0, prec)
    }

    /// The number `± mantissa * 2^exponent`, exactly, with results to be rounded to `prec` bits, at least 64; the
    /// mantissa in words of 64 bits, the least significant first. The whole line where the arithmetic has no such
    /// exponent.
    pub fn dyadic(negative: bool, mantissa: &[u64], exponent: i32, prec: usize) -> Self {
        let size = mantissa.iter().rposition(|word| *word != 0).map_or(0, |last| last + 1);
        match Astro::dyadic(negative, &mantissa[..size], exponent) {
            Some(point) => Self { low: point.clone(), high: point, prec: prec.max(LEAST) },
            None => Self::whole(prec),
        }
    }

    /// All numbers from one end to the other; the whole line if they are not in order.
    pub(super) fn new(low: Astro, high: Astro, prec: usize) -> Self {
        let is_ordered = low.order(&high).is_some_and(Ordering::is_le);
        let is_low = low.is_finite() || low.sign() == Some(Ordering::Less);
        let is_high = high.is_finite() || high.sign() == Some(Ordering::Greater);
        if !is_ordered || !is_low || !is_high {
            return Self::whole(prec);
        }
        Self { low, high, prec: prec.max(LEAST) }
    }

    /// The whole line.
    pub fn whole(prec: usize) -> Self {
        Self { low: Astro::infinite(true), high: Astro::infinite(false), prec: prec.max(LEAST) }
    }

    /// Gives the set, its ends rounded outward if they have more bits, with results to be rounded to `prec`
    /// bits, at least
    /// 64.
    pub fn with_precision(&self, prec: usize) -> Self {
        let prec = prec.max(LEAST);
        Self::new(self.low.rounded(prec, Down), self.high.rounded(prec, Up), prec)
    }

    /// All numbers that are at most as large as the largest of this set, whatever their sign.
    pub fn symmetric(&self) -> Self {
        let below = self.low.negated();
        let is_above = below.order(&self.high).is_some_and(Ordering::is_gt);
        let size = if is_above { below } else { self.high.clone() };
        Self::new(size.negated(), size, self.prec)
    }

    fn is_non_negative(&self) -> bool {
        self.low.sign().is_some_and(Ordering::is_ge)
    }

    fn is_non_positive(&self) -> bool {
        self.high.sign().is_some_and(Ordering::is_le)
    }

    /// Interval from the least to the largest product of two ends.
    fn corners(&self, other: &Self, prec: usize) -> Self {
        let ends = [
            (&self.low, &other.low),
            (&self.low, &other.high),
            (&self.high, &other.low),
            (&self.high, &other.high),
        ];
        let pick = |to, side| {
            let products = ends.iter().map(|(a, b)| a.times(b, prec, to));
            products.reduce(|best, next| next.beyond(&best, side)).expect("four corners")
        };
        Self::new(pick(Down, Ordering::Less), pick(Up, Ordering::Greater), prec)
    }

    /// Sine and cosine of an exact number from 1/8 to 3, by products; `None` for others and next to a right angle,
    /// where one of them may be small, and for few bits.
    fn by_halving(&self) -> Option<(Self, Self)> {
        if self.prec < HALVED {
            return None;
        }
        let negative = self.is_non_positive();
        let size = if negative { -self.clone() } else { self.clone() };
        let is_within = size.ratio(1, 8).is_less_than(&size).and(size.is_less_than(&size.int(3)));
        if !is_within.is_proved() {
            return None;
        }
        let plan = Halving::new(self.prec)?;
        let scaled = |exponent: usize| Self::dyadic(false, &[1], -(exponent as i32), plan.bits);
        let y = size * scaled(plan.halvings);
        let (sin, cos) = plan.sin_cos(&y, &scaled(plan.tail).symmetric());
        // A cosine that is nearly zero has lost too many bits.
        let (size, least) = (cos.square(), scaled(32));
        if !least.is_less_than(&size).is_proved() {
            return None;
        }
        let sin = if negative { -sin } else { sin };
        Some((sin.with_precision(self.prec), cos.with_precision(self.prec)))
    }

    /// A point in the middle; the point itself where there is no other.
    fn middle(&self) -> Self {
        let is_point = self.low.order(&self.high) == Some(Ordering::Equal);
        if is_point { self.clone() } else { self.midpoint() }
    }

    /// Sine and cosine of a number so small that its square is lost beside one, and of zero:
    /// `x (1 - x²/6) < sin x < x` and `1 - x² < cos x <= 1`.
    fn nearly_itself(&self) -> (Self, Self) {
        let square = self.square();
        let below = self.int(1) - &square;
        let factor = Self { low: below.low.clone(), ..self.int(1) };
        (self.clone() * &factor, factor)
    }
}

impl Field for AstroInterval {
    fn int(&self, n: i32) -> Self {
        Self::integer(n, self.prec)
    }

    fn square(&self) -> Self {
        let prec = self.prec;
        if self.is_non_negative() {
            let (low, high) =
                (self.low.times(&self.low, prec, Down), self.high.times(&self.high, prec, Up));
            return Self::new(low, high, prec);
        }
        if self.is_non_positive() {
            return (-self.clone()).square();
        }
        let size = self.symmetric().high;
        Self::new(self.int(0).low, size.times(&size, prec, Up), prec)
    }
}

impl Real for AstroInterval {
    fn pi(&self) -> Self {
        Self::new(Astro::pi(self.prec, Down), Astro::pi(self.prec, Up), self.prec)
    }

    fn sqrt(&self) -> Self {
        if !self.is_non_negative() {
            return Self::whole(self.prec);
        }
        Self::new(self.low.root(self.prec, Down), self.high.root(self.prec, Up), self.prec)
    }

    /// Sine and cosine at a point in the middle, widened by what they change up to the ends: for `|d| <= r`,
    /// `|sin(m+d) - sin m| <= min(r, r |cos m| + r²/2)`, and the same with the two exchanged.
    fn sin_cos(&self) -> (Self, Self) {
        let prec = self.prec;
        let unit = self.int(1).symmetric();
        let at = self.middle();
        // Beyond that size the place in the turn would need more bits of pi than anything here.
        let (bits, exponent) = (prec as i64, at.low.exponent());
        let is_known = self.is_bounded() && at.is_bounded();
        if !is_known || exponent.is_some_and(|e| e > bits + 64) {
            return (unit.clone(), unit);
        }
        let is_tiny = exponent.is_none_or(|e| 2 * e < -bits);
        let known = if is_tiny { Some(at.nearly_itself()) } else { at.by_halving() };
        let (sin, cos) = known.unwrap_or_else(|| {
            let set = |(low, high)| Self::new(low, high, prec);
            let both = at.low.sin_cos(prec).map(|[sin, cos]| (set(sin), set(cos)));
            both.unwrap_or_else(|| (unit.clone(), unit.clone()))
        });
        let below = at.low.minus(&self.low, LEAST, Up);
        let radius = self.high.minus(&at.low, LEAST, Up).beyond(&below, Ordering::Greater);
        let half = Self::dyadic(false, &[1], -1, LEAST).low;
        let bend = radius.times(&radius, LEAST, Up).times(&half, LEAST, Up);
        let within = |set: &Self, slope: &Self| {
            let bent = radius.times(&slope.symmetric().high, LEAST, Up).plus(&bend, LEAST, Up);
            let change = bent.beyond(&radius, Ordering::Less);
            let low = set.low.minus(&change, prec, Down);
            let high = set.high.plus(&change, prec, Up);
            Self::new(
                low.beyond(&unit.low, Ordering::Greater),
                high.beyond(&unit.high, Ordering::Less),
                prec,
            )
        };
        (within(&sin, &cos), within(&cos, &sin))
    }
}

impl Enclosure for AstroInterval {
    fn is_positive(&self) -> Ternary {
        if self.low.sign().is_some_and(Ordering::is_gt) {
            Ternary::True
        } else if self.is_non_positive() {
            Ternary::False
        } else {
            Ternary::Undecided
        }
    }

    fn is_bounded(&self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    fn midpoint(&self) -> Self {
        if !self.is_bounded() {
            return self.int(0);
        }
        let half = Self::dyadic(false, &[1], -1, self.prec);
        let middle = self.low.plus(&self.high, self.prec, Down).times(&half.low, self.prec, Down);
        Self::new(middle.clone(), middle, self.prec)
    }

    fn centred(&self) -> Self {
        let middle = self.midpoint();
        (self.clone() - &middle).symmetric()
    }

    fn lies_inside(&self, outer: &Self) -> bool {
        let below = |a: &Astro, b: &Astro| a.order(b).is_some_and(Ordering::is_lt);
        self.is_bounded() && below(&outer.low, &self.low) && below(&self.high, &outer.high)
    }

    fn overlaps(&self, other: &Self) -> bool {
        let below = |a: &Astro, b: &Astro| a.order(b).is_some_and(Ordering::is_lt);
        !below(&self.high, &other.low) && !below(&other.high, &self.low)
    }
}

impl AstroInterval {
    fn negated(self) -> Self {
        Self { low: self.high.negated(), high: self.low.negated(), prec: self.prec }
    }

    fn plus(self, other: &Self) -> Self {
        let prec = self.prec.max(other.prec);
        Self::new(
            self.low.plus(&other.low, prec, Down),
            self.high.plus(&other.high, prec, Up),
            prec,
        )
    }

    fn minus(self, other: &Self) -> Self {
        let prec = self.prec.max(other.prec);
        Self::new(
            self.low.minus(&other.high, prec, Down),
            self.high.minus(&other.low, prec, Up),
            prec,
        )
    }

    fn times(self, other: &Self) -> Self {
        if self.is_non_positive() && !self.is_non_negative() {
            return -((-self) * other);
        }
        if other.is_non_positive() && !other.is_non_negative() {
            return -(self * -other.clone());
        }
        let prec = self.prec.max(other.prec);
        if self.is_non_negative() && other.is_non_negative() {
            let (low, high) =
                (self.low.times(&other.low, prec, Down), self.high.times(&other.high, prec, Up));
            return Self::new(low, high, prec);
        }
        self.corners(other, prec)
    }

    fn over(self, other: &Self) -> Self {
        let prec = self.prec.max(other.prec);
        if !other.excludes_zero() {
            return Self::whole(prec);
        }
        if other.is_non_positive() {
            return -self / -other.clone();
        }
        let by_low = if self.is_non_negative() { &other.high } else { &other.low };
        let by_high = if self.is_non_positive() { &other.high } else { &other.low };
        Self::new(self.low.over(by_low, prec, Down), self.high.over(by_high, prec, Up), prec)
    }
}

operators!(AstroInterval);

#[cfg(test)]
mod tests;
