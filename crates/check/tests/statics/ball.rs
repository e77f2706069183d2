//! Enclosures that share nothing with those of the house: integers in units of `2^-bits`, and series.

use rug::ops::NegAssign;
use rug::{Integer, Rational};
use std::ops::{Add, Mul, Neg, Sub};

/// All numbers within `rad` of `mid`, both in units of `2^-bits`.
#[derive(Clone, Debug)]
pub(crate) struct Ball {
    pub(crate) mid: Integer,
    pub(crate) rad: Integer,
    pub(crate) bits: u32,
}

impl Ball {
    pub(crate) fn new(x: &Rational, bits: u32) -> Self {
        let (mid, rest) = Integer::from(x.numer() << bits).div_rem_floor(x.denom().clone());
        Self { mid, rad: Integer::from(u32::from(rest != 0)), bits }
    }

    pub(crate) fn int(&self, n: i32) -> Self {
        Self { mid: Integer::from(n) << self.bits, rad: Integer::new(), bits: self.bits }
    }

    /// The middle alone.
    pub(crate) fn point(&self) -> Self {
        self.at(self.mid.clone())
    }

    pub(crate) fn at(&self, mid: Integer) -> Self {
        Self { mid, rad: Integer::new(), bits: self.bits }
    }

    pub(crate) fn wider(mut self, rad: &Integer) -> Self {
        self.rad += rad;
        self
    }

    /// Zero, give or take.
    pub(crate) fn around(&self, rad: Integer) -> Self {
        Self { mid: Integer::new(), rad, bits: self.bits }
    }

    /// From the least of one to the largest of another.
    pub(crate) fn hull(&self, other: &Self) -> Self {
        let low = self.low().min(other.low());
        let width = self.high().max(other.high()) - &low;
        let rad = (width + 1u32) >> 1;
        Self { mid: low + &rad, rad, bits: self.bits }
    }

    pub(crate) fn low(&self) -> Integer {
        Integer::from(&self.mid - &self.rad)
    }

    pub(crate) fn high(&self) -> Integer {
        Integer::from(&self.mid + &self.rad)
    }

    pub(crate) fn is_positive(&self) -> bool {
        self.low() > 0
    }

    pub(crate) fn is_not_negative(&self) -> bool {
        self.low() >= 0
    }

    pub(crate) fn is_negative(&self) -> bool {
        self.high() < 0
    }

    pub(crate) fn rational(&self) -> Rational {
        Rational::from(self.mid.clone()) >> self.bits
    }

    pub(crate) fn over(&self, n: u32) -> Self {
        let rad = Integer::from(&self.rad / n) + 2u32;
        Self { mid: Integer::from(&self.mid / n), rad, bits: self.bits }
    }

    /// The quotient, where the divisor is not zero.
    pub(crate) fn divided_by(&self, by: &Self) -> Option<Self> {
        let least = Integer::from(by.mid.abs_ref()) - &by.rad;
        if least <= 0 {
            return None;
        }
        let mid = Integer::from(&self.mid << self.bits) / &by.mid;
        let off =
            (Integer::from(mid.abs_ref()) + 1u32) * &by.rad + Integer::from(&self.rad << self.bits);
        Some(Self { mid, rad: off / least + 2u32, bits: self.bits })
    }

    /// Sine and cosine: of a small part by series of falling terms with signs in turn, which is doubled again; both have
    /// slopes of at most one.
    pub(crate) fn sin_cos(&self) -> [Self; 2] {
        const HALVED: u32 = 6;
        let x = self.point().over(1 << HALVED);
        let square = &x * &x;
        let [mut sin, mut cos] = [(x, 1), (square.int(1), 0)].map(|(mut term, mut n)| {
            let mut sum = term.clone();
            loop {
                term = -(&term * &square).over((n + 1) * (n + 2));
                n += 2;
                sum = &sum + &term;
                if Integer::from(term.mid.abs_ref()) <= term.rad {
                    return sum.wider(&Integer::from(&term.rad << 1));
                }
            }
        });
        for _ in 0..HALVED {
            let product = &sin * &cos;
            let square = &sin * &sin;
            (sin, cos) = (&product + &product, &square.int(1) - &(&square + &square));
        }
        [sin, cos].map(|value| value.wider(&self.rad))
    }

    /// Pi, after Machin.
    pub(crate) fn pi(&self) -> Self {
        let arctangent = |n: u32| {
            let (mut power, mut sum, mut k) = (self.int(1).over(n), self.int(1).over(n), 1);
            while power.mid != 0 {
                power = -power.over(n * n);
                k += 2;
                sum = &sum + &power.over(k);
            }
            sum.wider(&Integer::from(&power.rad + 2u32))
        };
        let [fifth, rest] = [arctangent(5), arctangent(239)];
        &(&fifth * &self.int(16)) - &(&rest * &self.int(4))
    }

    /// The angle below a right one of this tangent `t`: `t cos x - sin x = sin(angle - x) / cos(angle)`.
    pub(crate) fn arctangent(&self) -> Self {
        let near = Rational::from_f64(self.rational().to_f64().atan()).expect("finite");
        let mut x = Self::new(&near, self.bits).point();
        loop {
            let [sin, cos] = x.sin_cos();
            let off = &(self * &cos) - &sin;
            let step = off.divided_by(&(&cos + &(self * &sin))).expect("an acute angle");
            if Integer::from(step.mid.abs_ref()) <= Integer::from(&step.rad << 4) {
                let most = Integer::from(off.mid.abs_ref()) + &off.rad;
                return x.wider(&(most << 1));
            }
            x = x.at(Integer::from(&x.mid + &step.mid));
        }
    }
}

impl Add for &Ball {
    type Output = Ball;
    fn add(self, other: Self) -> Ball {
        let [mid, rad] = [&self.mid + &other.mid, &self.rad + &other.rad].map(Integer::from);
        Ball { mid, rad, bits: self.bits }
    }
}

impl Sub for &Ball {
    type Output = Ball;
    fn sub(self, other: Self) -> Ball {
        let (mid, rad) =
            (Integer::from(&self.mid - &other.mid), Integer::from(&self.rad + &other.rad));
        Ball { mid, rad, bits: self.bits }
    }
}

impl Mul for &Ball {
    type Output = Ball;
    fn mul(self, other: Self) -> Ball {
        if [self, other].iter().any(|x| x.mid == 0 && x.rad == 0) {
            return self.int(0);
        }
        let mut off = Integer::from(self.mid.abs_ref()) * &other.rad;
        off += (Integer::from(other.mid.abs_ref()) + &other.rad) * &self.rad;
        let mid = Integer::from(&self.mid * &other.mid) >> self.bits;
        Ball { mid, rad: (off >> self.bits) + 2u32, bits: self.bits }
    }
}

impl Neg for Ball {
    type Output = Ball;
    fn neg(mut self) -> Ball {
        self.mid.neg_assign();
        self
    }
}

#[test]
fn series_enclose_what_is_known() {
    let one = Ball::new(&Rational::from(1), 200);
    let known = |x: &Ball, digits: &str| {
        let tens = Integer::from(Integer::u_pow_u(10, digits.len() as u32 - 1));
        let (last, tens) = (digits.parse::<Integer>().unwrap(), Rational::from(tens));
        let [low, high] = [-1, 1].map(|k| Rational::from(&last + k) / &tens);
        let [low, high] = [low, high].map(|x| Ball::new(&x, 200));
        assert!((x - &low).is_positive() && (&high - x).is_positive(), "{digits}");
        assert!(x.rad < Integer::from(1) << 20);
    };
    let [sin, cos] = one.sin_cos();
    known(&sin, "08414709848078965066525");
    known(&cos, "05403023058681397174009");
    known(&one.pi(), "31415926535897932384626");
    known(&one.int(3).arctangent(), "12490457723982544258299");
    assert!(one.int(1).divided_by(&one.int(0)).is_none());
}
