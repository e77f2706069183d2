//! The states of a flat arch that turns at the haunch while its shoulder is about to slide, over powers of an
//! inclination.
//!
//! To each friction angle belongs one inclination, `phi = chi - sin chi cos chi` ([`cycloid`]), whatever
//! slides. As `chi -> 0` the states of (2), (4), (5) and (17) have `alpha ~ chi`, `beta_r² ~ chi²`, `1 - h ~ chi²` and
//! `eta ~ chi⁴`. With
//!
//! ```text
//! alpha = p chi,   beta_r² = s chi²,   eta = e chi²,   1 - h = d chi²
//! ```
//!
//! and [Stumpff's functions](crate::number::Stumpff) `c_n` at `beta_r²` a power of `chi` is divided out of each
//! equation, and what is left is regular: at `chi = 0` the root is `p³ = 4`, `s = p²/2`, `d = s/3`, and simple.

use super::{Ring, SelfWeight, cycloid};
use crate::number::{Field, Stumpff};

/// Results of (2) and (5) for such an arch, and the half opening with it.
#[derive(Clone, Debug)]
pub struct Flat<T> {
    /// `p = alpha/chi`.
    pub opening: T,
    /// `s = beta_r²/chi²`.
    pub joint: T,
    /// `beta_r²`.
    pub square: T,
    /// `c_0, …, c_3` at `beta_r²`.
    pub functions: Vec<T>,
    /// `eta`.
    pub thickness: T,
}

impl<T: Field> Flat<T> {
    /// `e = eta/chi²`, of which (2) and (5) leave one:
    ///
    /// ```text
    /// 2 e ((c_0 + c_1)(2 - eta) - 2 fac c_1) = s beta_r² (2 - eta)² c_2 c_3
    /// ```
    pub fn thinness(&self, ring: &Ring<T>) -> T {
        let c = &self.functions;
        let intrados = ring.intrados();
        let lever = (c[0].clone() + &c[1]) * &intrados
            - ring.centroid_factor.clone() * &c[1] * self.joint.int(2);
        let bow = self.joint.clone() * &self.square * intrados.square() * &c[2] * &c[3];
        bow / (lever * self.joint.int(2))
    }

    /// `d = (1 - h)/chi²` by (5): `s (c_2 - c_3)/c_1 + e (1 + delta_M eta/6)/(2 - eta)`.
    pub fn deficit(&self, delta: &T, ring: &Ring<T>) -> T {
        let c = &self.functions;
        let push = self.thinness(ring) * (delta.int(1) + self.lift(delta)) / ring.intrados();
        self.joint.clone() * (c[2].clone() - &c[3]) / &c[1] + push
    }

    /// (5) less (4) over `chi²`, with `c_1, c_2, c_3` at `alpha²/4`: `d - p²/2 (c_2 - c_3)/c_1 + e (1 - delta_M
    /// eta/6)/(2 + eta)`.
    pub fn whole(&self, delta: &T, half: &[T], ring: &Ring<T>) -> T {
        let drop = (half[2].clone() - &half[3]) * &self.opening * &self.opening
            / (half[1].clone() * delta.int(2));
        let push = self.thinness(ring) * (delta.int(1) - self.lift(delta)) / ring.extrados();
        self.deficit(delta, ring) - drop + push
    }

    /// `delta_M eta/6 = 2 (fac_M - 1)/eta`.
    fn lift(&self, delta: &T) -> T {
        delta.clone() * &self.thickness / delta.int(6)
    }
}

impl<T: Stumpff> Flat<T> {
    /// (4) and (5) of a weight, zero where both hold.
    pub fn turning(&self, weight: SelfWeight, half_opening: &T) -> T {
        let half = (half_opening.square() / half_opening.int(4)).stumpff(4);
        self.whole(&half_opening.int(weight.flag()), &half, &self.ring(weight))
    }

    /// (17) over `chi³`, with `q = (alpha - phi)/chi = p - 4 chi² c_3(4 chi²)`: zero where the shoulder slides.
    pub fn shoulder(&self, weight: SelfWeight, inclination: &T) -> T {
        let square = inclination.square();
        let twice = (square.int(4) * &square).stumpff(4);
        let ratio = self.opening.clone() - square.int(4) * &square * &twice[3];
        let shoulder = (ratio.square() * &square).stumpff(4);
        let deficit = self.deficit(&square.int(weight.flag()), &self.ring(weight));
        cycloid::flat_shoulder_from(&ratio, &shoulder, &deficit, &twice)
    }

    fn ring(&self, weight: SelfWeight) -> Ring<T> {
        Ring::new(weight, &self.thickness)
    }
}

#[cfg(test)]
mod tests {
    use super::super::haunch::Haunch;
    use super::super::{cycloid, thrust};
    use super::*;
    use crate::number::Angle;

    /// A joint and a thickness for which (2) and (5) hold, at `chi` = 0.6 and a half opening of 0.9.
    fn flat(weight: SelfWeight) -> (Flat<f64>, f64, f64) {
        let (chi, alpha, square): (f64, f64, f64) = (0.6, 0.9, 0.3);
        let touching = |eta: f64| {
            let (haunch, ring) = (Haunch::at_square(&square), Ring::new(weight, &eta));
            let touching = thrust::touching(&haunch.versine, &haunch.excess, &ring);
            thrust::tangency(&haunch.times_cotangent, &ring).difference(&touching)
        };
        let (mut low, mut high) = (1e-4, 0.1);
        for _ in 0..60 {
            let middle = (low + high) / 2.0;
            if touching(middle) * touching(low) > 0.0 { low = middle } else { high = middle }
        }
        let functions = square.stumpff(4);
        let (opening, joint) = (alpha / chi, square / chi.powi(2));
        (Flat { opening, joint, square, functions, thickness: low }, chi, alpha)
    }

    #[test]
    fn it_is_the_printed_equations_over_powers_of_the_inclination() {
        for weight in SelfWeight::ALL {
            let (flat, chi, alpha) = flat(weight);
            let (ring, delta) = (Ring::new(weight, &flat.thickness), f64::from(weight.flag()));
            let close = |one: f64, other: f64| {
                approx::assert_relative_eq!(one, other, max_relative = 1e-10);
            };
            close(flat.thinness(&ring), flat.thickness / chi.powi(2));
            let haunch = Haunch::at_square(&flat.square);
            let h = thrust::tangency(&haunch.times_cotangent, &ring).value();
            close(flat.deficit(&delta, &ring), (1.0 - h) / chi.powi(2));
            let whole = thrust::whole(&Angle::new(alpha), &ring).value();
            close(flat.turning(weight, &alpha), (whole - h) / chi.powi(2));
            let phi = cycloid::friction_angle(&Angle::new(chi));
            let printed = cycloid::shoulder(&alpha, &Angle::new(alpha - phi), &h);
            close(flat.shoulder(weight, &chi), printed / chi.powi(3));
            // False twin: another deficit is another thrust.
            let twin = Flat { joint: 1.001 * flat.joint, ..flat };
            assert!((twin.deficit(&delta, &ring) - (1.0 - h) / chi.powi(2)).abs() > 1e-6);
        }
    }

    #[test]
    fn at_no_inclination_the_root_is_known() {
        let opening = 4f64.cbrt();
        let joint = opening.powi(2) / 2.0;
        let functions = 0f64.stumpff(4);
        let flat = Flat { opening, joint, square: 0.0, functions, thickness: 0.0 };
        for weight in SelfWeight::ALL {
            approx::assert_abs_diff_eq!(flat.turning(weight, &0.0), 0.0, epsilon = 1e-15);
            approx::assert_abs_diff_eq!(flat.shoulder(weight, &0.0), 0.0, epsilon = 1e-15);
        }
        let twin = Flat { opening: 1.6, ..flat };
        assert!(twin.shoulder(SelfWeight::Heyman, &0.0).abs() > 1e-2, "false twin");
    }
}
