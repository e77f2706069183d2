//! Statics of a single joint: four conditions, each linear in the thrust `h` and the crown moment `p = h (1 +
//! e0)`.
//!
//! ```text
//! hinge at the extrados   p + fac (1 - cos beta) - (1 + eta/2) N <= 0
//! hinge at the intrados   (1 - eta/2) N - p - fac (1 - cos beta) <= 0
//! slides inwards          T - mu N <= 0
//! slides outwards         -T - mu N <= 0
//! ```
//!
//! with `N = h cos beta + beta sin beta` and `T = beta cos beta - h sin beta`. They are the rows of the static
//! matrix of Eqs. (19) and (20). Joints may be anywhere: the weight of a stone between two of them acts at its
//! centroid, and the moments of all stones above a joint add up to `fac (1 - cos beta)`, for both weights.

use super::Ring;
use crate::number::{Angle, Field, Real};

/// A condition `thrust h + moment p + load <= 0`.
#[derive(Clone, Debug)]
pub struct Row<T> {
    /// The coefficient of `h`.
    pub thrust: T,
    /// The coefficient of `p`.
    pub moment: T,
    /// Term free of both.
    pub load: T,
}

/// Friction as a ratio: `shear T <= normal N`. A coefficient `mu` is 1 and `mu`; without limit it is 0 and 1, which
/// asks for `N >= 0` alone.
#[derive(Clone, Debug)]
pub struct Grip<T> {
    /// Factor of the shear force.
    pub shear: T,
    /// Factor of the normal force.
    pub normal: T,
}

impl<T> Grip<T> {
    /// Maps both factors to another number.
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Grip<U> {
        Grip { shear: f(self.shear), normal: f(self.normal) }
    }
}

/// A hinge at the extrados.
pub fn extrados<T: Field>(joint: &Angle<T>, ring: &Ring<T>) -> Row<T> {
    let radius = ring.extrados() / ring.thickness.int(2);
    let weight = joint.versine() * &ring.centroid_factor;
    Row {
        thrust: -(radius.clone() * &joint.cos),
        moment: radius.int(1),
        load: weight - radius * &joint.rad * &joint.sin,
    }
}

/// A hinge at the intrados.
pub fn intrados<T: Field>(joint: &Angle<T>, ring: &Ring<T>) -> Row<T> {
    let radius = ring.intrados() / ring.thickness.int(2);
    let weight = joint.versine() * &ring.centroid_factor;
    Row {
        thrust: radius.clone() * &joint.cos,
        moment: radius.int(-1),
        load: radius * &joint.rad * &joint.sin - weight,
    }
}

/// The part above slides inwards.
pub fn inwards<T: Field>(joint: &Angle<T>, grip: &Grip<T>) -> Row<T> {
    let Grip { shear, normal } = grip;
    let slope = shear.clone() * &joint.cos - normal.clone() * &joint.sin;
    Row {
        thrust: -(shear.clone() * &joint.sin) - normal.clone() * &joint.cos,
        moment: shear.int(0),
        load: slope * &joint.rad,
    }
}

/// The part above slides outwards.
pub fn outwards<T: Field>(joint: &Angle<T>, grip: &Grip<T>) -> Row<T> {
    let Grip { shear, normal } = grip;
    let slope = shear.clone() * &joint.cos + normal.clone() * &joint.sin;
    Row {
        thrust: shear.clone() * &joint.sin - normal.clone() * &joint.cos,
        moment: shear.int(0),
        load: -slope * &joint.rad,
    }
}

impl<T: Field> Row<T> {
    /// The left side at a thrust and a crown moment.
    pub fn at(&self, thrust: &T, moment: &T) -> T {
        self.thrust.clone() * thrust + self.moment.clone() * moment + &self.load
    }

    /// Sum of both rows: a hinge at the extrados and one at the intrados say so what is free of `p`.
    pub fn plus(&self, other: &Self) -> Self {
        Self {
            thrust: self.thrust.clone() + &other.thrust,
            moment: self.moment.clone() + &other.moment,
            load: self.load.clone() + &other.load,
        }
    }

    /// The thrust at which a condition that is free of `p` holds with equality: a lower bound where the coefficient
    /// of `h` is negative, an upper one where it is positive.
    pub fn bound(&self) -> T {
        -self.load.clone() / &self.thrust
    }

    /// The crown moment at which a hinge holds with equality, for a thrust. Undefined for a slip.
    pub fn moment_at(&self, thrust: &T) -> T {
        -(self.thrust.clone() * thrust + &self.load) / &self.moment
    }

    /// `a d - b c` of the coefficients of `h` and `p` in this row and another.
    fn cross(&self, other: &Self) -> T {
        self.thrust.clone() * &other.moment - self.moment.clone() * &other.thrust
    }

    /// The thrust and the crown moment at which this condition and another hold with equality. Undefined where
    /// one is a multiple of the other.
    pub fn meeting(&self, other: &Self) -> (T, T) {
        let cross = self.cross(other);
        let thrust = self.moment.clone() * &other.load - self.load.clone() * &other.moment;
        let moment = self.load.clone() * &other.thrust - self.thrust.clone() * &other.load;
        (thrust / &cross, moment / cross)
    }
}

/// The thrust at which a joint `a` asks for as much friction inwards as another `b` outwards, `T/N` of the one and
/// `-T/N` of the other. With `s = a + b` it is the root
///
/// ```text
/// h = 2 a b sin s / (sqrt(s² cos² s + 4 a b sin² s) - s cos s)
/// ```
///
/// of `h² sin s - h s cos s - a b sin s = 0`, at which both normal forces are positive: negative where `s` is above
/// a half turn. Above it the first asks for less and the second for more. Undefined for a joint at the crown, which
/// asks for nothing.
pub fn even_thrust<T: Real>(inwards: &Angle<T>, outwards: &Angle<T>) -> T {
    let sin = inwards.sin.clone() * &outwards.cos + inwards.cos.clone() * &outwards.sin;
    let cos = inwards.cos.clone() * &outwards.cos - inwards.sin.clone() * &outwards.sin;
    let arm = (inwards.rad.clone() + &outwards.rad) * cos;
    let product = inwards.rad.clone() * &outwards.rad * sin.int(2) * &sin;
    let root = (arm.square() + product.clone() * sin.int(2) * &sin).sqrt();
    product / (root - arm)
}

/// Multipliers of three conditions with which `h` and `p` drop out, up to a common factor: the rates of their
/// mechanism.
pub fn multipliers<T: Field>([a, b, c]: &[Row<T>; 3]) -> [T; 3] {
    [b.cross(c), c.cross(a), a.cross(b)]
}

/// Sum of the rows with their multipliers. Where it is positive and the multipliers are, nothing admissible
/// is at this thickness.
pub fn combination<T: Field>(rows: &[Row<T>; 3]) -> T {
    let [a, b, c] = multipliers(rows);
    a * &rows[0].load + b * &rows[1].load + c * &rows[2].load
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::{Configuration, SelfWeight, contact, statics};
    use rug::Rational;

    fn angle(rad: (i32, i32), sin: (i32, i32), cos: (i32, i32)) -> Angle<Rational> {
        Angle { rad: rad.into(), sin: sin.into(), cos: cos.into() }
    }

    /// The rows are the conditions that the statics and [`contact`] write another way.
    #[test]
    fn the_rows_are_the_conditions() {
        let (joint, weight) = (angle((9, 4), (4, 5), (-3, 5)), SelfWeight::Milankovitch);
        let (h, p, mu) = (Rational::from((2, 7)), Rational::from((1, 5)), Rational::from((5, 4)));
        let at = Configuration {
            half_opening: joint.clone(),
            rotation_joint: joint.clone(),
            sliding_joint: joint.clone(),
            thickness: Rational::from((1, 3)),
            thrust: h.clone(),
            friction: mu.clone(),
            ..Configuration::zero(&mu)
        };
        let ring = Ring::new(weight, &at.thickness);
        let outer = -contact::extrados_margin_at_shoulder(weight, &at, &p);
        assert_eq!(extrados(&joint, &ring).at(&h, &p), outer);
        let inner = -contact::intrados_margin(weight, &joint, &at, &p);
        assert_eq!(intrados(&joint, &ring).at(&h, &p), inner);
        let (normal, shear) = (statics::normal_force(&joint, &h), statics::shear_force(&joint, &h));
        let grip = Grip { shear: Rational::from(1), normal: mu.clone() };
        let most = normal.clone() * &mu;
        assert_eq!(inwards(&joint, &grip).at(&h, &p), shear.clone() - &most);
        assert_eq!(outwards(&joint, &grip).at(&h, &p), -shear - most);
        let unlimited = Grip { shear: Rational::from(0), normal: Rational::from(1) };
        assert_eq!(inwards(&joint, &unlimited).at(&h, &p), -normal);
    }

    /// Thrust and moment drop out, with the multipliers of [`contact`]; with those of other rows they do not.
    #[test]
    fn the_combination_is_free_of_thrust_and_moment() {
        let (haunch, shoulder) =
            (angle((1, 1), (20, 29), (21, 29)), angle((9, 4), (4, 5), (-3, 5)));
        let ring = Ring::new(SelfWeight::Milankovitch, &Rational::from((1, 3)));
        let crown = Angle::zero(&ring.thickness);
        let rows = [extrados(&crown, &ring), intrados(&haunch, &ring), extrados(&shoulder, &ring)];
        let of = |rates: &[Rational; 3], h: i32, p: i32| {
            let sum = |sum: Rational, (rate, row): (&Rational, &Row<Rational>)| {
                sum + row.at(&h.into(), &p.into()) * rate
            };
            rates.iter().zip(&rows).fold(Rational::new(), sum)
        };
        let rates = multipliers(&rows);
        assert!(
            [(0, 0), (1, 0), (0, 1)].iter().all(|&(h, p)| of(&rates, h, p) == combination(&rows))
        );
        let [a, b, c] = rates.clone();
        assert_ne!(
            of(&[b.clone(), a, c], 1, 0),
            of(&[b, rates[0].clone(), rates[2].clone()], 0, 0)
        );
        let at = Configuration {
            half_opening: shoulder,
            rotation_joint: haunch.clone(),
            sliding_joint: haunch,
            thickness: Rational::from((1, 3)),
            thrust: Rational::from((2, 7)),
            friction: Rational::from((5, 4)),
            ..Configuration::zero(&Rational::new())
        };
        let known = contact::rates_of_rotation(&at);
        assert_eq!(rates[1].clone() / &rates[0], known.haunch / &known.crown);
        assert_eq!(rates[2].clone() / &rates[0], known.shoulder / &known.crown);
        let (h, p) = rows[0].meeting(&rows[2]);
        assert_eq!(rows[0].at(&h, &p), 0);
        assert_eq!(rows[2].at(&h, &p), 0);
    }

    /// At the bound of a sum the two hinges meet, and nowhere else.
    #[test]
    fn two_hinges_bound_the_thrust() {
        let ring = Ring::new(SelfWeight::Milankovitch, &Rational::from((1, 3)));
        let joint = angle((1, 1), (20, 29), (21, 29));
        let crown = Angle::zero(&ring.thickness);
        let [upper, lower] = [extrados(&crown, &ring), intrados(&joint, &ring)];
        let both = upper.plus(&lower);
        assert_eq!(both.moment, 0);
        let (h, p) = upper.meeting(&lower);
        assert_eq!(
            (both.bound(), upper.moment_at(&h), lower.moment_at(&h)),
            (h.clone(), p.clone(), p)
        );
        assert!(both.thrust < 0 && both.at(&(h + 1), &Rational::new()) < 0, "a lower bound");
        assert_ne!(upper.plus(&intrados(&crown, &ring)).bound(), both.bound());
    }

    /// There both ask for the same friction.
    #[test]
    fn an_even_thrust_asks_for_one_friction() {
        for (a, b) in [(0.3, 1.5), (0.01, 1.2), (0.6, 2.5), (0.7, 0.7), (0.53, 2.65)] {
            let [inner, outer] = [a, b].map(Angle::new);
            let h = even_thrust(&inner, &outer);
            assert_eq!(h > 0.0, a + b < std::f64::consts::PI);
            assert!([&inner, &outer].iter().all(|at| statics::normal_force(at, &h) > 0.0));
            let ratio = |at: &Angle<f64>, h: f64| {
                statics::shear_force(at, &h) / statics::normal_force(at, &h)
            };
            assert!((ratio(&inner, h) + ratio(&outer, h)).abs() < 1e-14, "{a} {b}");
            assert!((ratio(&inner, h + 0.1) + ratio(&outer, h + 0.1)) < -1e-3, "{a} {b}");
        }
    }
}
