//! Sizes of a measured arch of voussoirs, in metres and kilonewtons.

use super::joints::{StoneAngles, StoneJoints};
use super::thickness::{LeastOutcome, least};
use super::thrusts::{ThickStones, ThrustRange, Ties};
use super::{GUARD, checked};
use crate::arch::SelfWeight;
use crate::number::{Ball, ExactNumber, bits_of};
use crate::problem::measures::Measures;
use crate::problem::stones::Stones;
use crate::problem::{Friction, Quantity};
use crate::prover::{Error, Refused, raise};
use couplet_prove::certify::state::{Measured, measured_least, measured_of};

/// The sizes of an arch of voussoirs, to `digits` significant digits: of a given thickness in `(0, 2]` those of
/// [`Quantity::MEASURED_ASSESSMENT`], else those at its least one, of [`Quantity::MEASURED_STATE`]. An arch that falls
/// has no thrusts.
pub fn measured_voussoirs(
    stones: &Stones,
    (weight, friction): (SelfWeight, &Friction),
    thickness: Option<&ExactNumber>,
    measures: &Measures,
    digits: usize,
) -> Result<Measured, Error> {
    let arch = checked(stones, weight, friction, digits)?;
    thickness.map_or(Ok(()), Refused::thickness)?;
    let angles = StoneAngles::new(stones);
    let found = raise(bits_of(digits) + GUARD, |bits| {
        let joints = StoneJoints::new(&angles, weight, friction, bits);
        let state = match least(&joints)? {
            LeastOutcome::Stands(state) => Some(state),
            _ => None,
        };
        let Some(thickness) = thickness else {
            let state = state.as_ref().map(|state| [&state.thickness, &state.thrust]);
            return Ok(measured_least(stones.half_opening(), measures, state, (bits, digits)));
        };
        let eta: Ball = thickness.enclosure(bits);
        let range = ThickStones::new(&joints, &eta, Ties::of(&arch, thickness)).range()?;
        let thrusts = match range {
            ThrustRange::Stands([least, largest]) => {
                // That no thrust is too small is no force to tell.
                let least = least.thrust.map(|thrust| (Quantity::LeastForce, Some(thrust)));
                least.into_iter().chain([(Quantity::LargestForce, largest.thrust)]).collect()
            }
            ThrustRange::Falls(_) => Vec::new(),
        };
        let known = (state.map(|state| state.thickness), thrusts);
        Ok(measured_of((stones.half_opening(), thickness), measures, known, (bits, digits)))
    });
    Ok(found?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::measures::Circle;
    use crate::voussoirs::{VoussoirStanding, Voussoirs, assess_voussoirs, voussoirs};
    use rug::Rational;

    /// A radius of 5 m at the extrados, 20 kN/m3 and 2 m deep: ratios that are told, times these.
    #[test]
    fn sizes_are_the_ratios_times_their_units() {
        let stones = Stones::equal(11, "1.2".parse().unwrap()).unwrap();
        let (friction, eta) = ("0.6".parse().unwrap(), "0.2".parse().unwrap());
        let length = |text: &str| text.parse().unwrap();
        let load = Some(("20kN/m3".parse().unwrap(), length("2m")));
        let measures = Measures::new(Circle::Extrados, length("5m"), load);
        let of = (SelfWeight::Milankovitch, &friction);
        let told = |thickness, digits| {
            measured_voussoirs(&stones, of, thickness, &measures, digits).unwrap()
        };
        let near = |all: &Measured, of: Quantity, value: &Rational| {
            let (_, figure) = all.iter().find(|(known, _)| *known == of).unwrap();
            let found = figure.as_ref().unwrap().decimal.value.to_rational();
            let off = Rational::from(&found - value) / value;
            assert!(off.abs() < Rational::from((1, 10_000_000)), "{of}: {found} {value}");
        };
        let Ok(Voussoirs::Stands(state)) = voussoirs(&stones, of.0, of.1, 20) else { panic!() };
        let number = |figure: &crate::prover::Figure| figure.decimal.value.to_rational();
        let [least, thrust] = [&state.thickness, &state.thrust].map(number);
        // r = R/(1 + eta/2), and w r = 40 eta r² kN.
        let radius = |eta: &Rational| Rational::from(5) / (Rational::from(eta / 2u32) + 1u32);
        let unit = |eta: &Rational| radius(eta) * radius(eta) * eta * Rational::from(40);
        let all = told(None, 9);
        near(&all, Quantity::ThicknessInMetres, &(radius(&least) * &least));
        near(&all, Quantity::Force, &(unit(&least) * &thrust));
        near(&all, Quantity::Weight, &(unit(&least) * Rational::from((12, 5))));
        let all = told(Some(&eta), 9);
        let given = Rational::from((1, 5));
        near(&all, Quantity::ThicknessInMetres, &(radius(&least) * &least));
        near(&all, Quantity::GivenThicknessInMetres, &(radius(&given) * &given));
        let found = assess_voussoirs(&stones, of.0, of.1, &eta, 20).unwrap();
        let Ok(VoussoirStanding::Stands(ends)) = found.standing else { panic!() };
        for (end, of) in ends.iter().zip([Quantity::LeastForce, Quantity::LargestForce]) {
            near(&all, of, &(unit(&given) * number(end.thrust.as_ref().unwrap())));
        }
        // An arch that falls has no thrusts to tell.
        let thin = told(Some(&"0.01".parse().unwrap()), 6);
        assert!(thin.iter().all(|(of, _)| !of.is_force() || *of == Quantity::Weight), "{thin:?}");
    }
}
