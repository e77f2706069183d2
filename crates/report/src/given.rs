//! Given values of an arch, as numbers that every program reads.

use crate::number::{Ball, DoubleDoubleBall, Engine, ExactNumber, nearest_double};
use crate::problem::{Arch, Friction};

/// The doubles nearest to what is given, which is exact text; `None` beyond the largest double.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GivenDoubles {
    /// The half opening in radians.
    pub half_opening_rad: Option<f64>,
    /// The half opening in degrees.
    pub half_opening_deg: Option<f64>,
    /// The friction coefficient, also of an angle; infinite if it is unlimited.
    pub friction: Option<f64>,
    /// The thickness, where the arch has one.
    pub thickness: Option<f64>,
}

impl GivenDoubles {
    /// Doubles of an arch, and of its thickness if it has one.
    pub fn new(arch: &Arch, thickness: Option<&ExactNumber>) -> Self {
        let half_opening = arch.half_opening();
        Self {
            half_opening_rad: half_opening.nearest_double(),
            half_opening_deg: degrees(half_opening),
            friction: match arch.friction() {
                Friction::Coefficient(mu) => mu.nearest_double(),
                Friction::Angle(_) => {
                    let short = arch.given::<DoubleDoubleBall>(0).friction;
                    nearest_double(short, |bits| arch.given::<Ball>(bits).friction)
                }
                Friction::Infinite => Some(f64::INFINITY),
            },
            thickness: thickness.and_then(ExactNumber::nearest_double),
        }
    }
}

fn degrees(angle: &ExactNumber) -> Option<f64> {
    let rounded = || nearest_double(in_degrees(angle, 0), |bits| in_degrees(angle, bits));
    angle.in_degrees().map_or_else(rounded, |exact| exact.nearest_double())
}

/// Radians in degrees.
fn in_degrees<E: Engine>(angle: &ExactNumber, bits: u32) -> E {
    let x: E = angle.enclosure(bits);
    x.int(180) * &x / x.pi()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn given(half_opening: &str, friction: &str) -> GivenDoubles {
        let arch = Arch::parse("heyman", half_opening, friction).unwrap();
        GivenDoubles::new(&arch, Some(&"1/3".parse().unwrap()))
    }

    #[test]
    fn doubles_are_the_nearest_to_what_is_given() {
        let right = given("90deg", "tan(45deg)");
        assert_eq!(right.half_opening_rad, Some(std::f64::consts::FRAC_PI_2));
        assert_eq!((right.half_opening_deg, right.friction), (Some(90.0), Some(1.0)));
        assert_eq!(right.thickness, Some(1.0 / 3.0));
        let swept = given("1140/199deg", "inf");
        assert_eq!(swept.half_opening_deg, Some(1140.0 / 199.0));
        assert_eq!(swept.friction, Some(f64::INFINITY));
        let radian = given("1", "0.1");
        // 180/pi = 57.29577951308232087679815…
        assert_eq!(
            (radian.half_opening_deg, radian.friction),
            (Some(57.29577951308232), Some(0.1))
        );
        let angle = given("1", "35deg");
        // tan 35 deg = 0.70020753820970977945852271944…
        assert_eq!(angle.friction, Some(0.700_207_538_209_709_8));
        assert_eq!(given("1", "1e400").friction, None);
        assert_eq!(given("1", "tan(0)").friction, Some(0.0));
    }
}
