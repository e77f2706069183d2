//! The states against the static programme of the half arch, solved on its own.
//!
//! The programme sees nothing of the equations (2)–(18) but the statics. It asks less than the whole half
//! arch does, so that its least thickness is a lower bound.

use crate::arches::rational_arch as arch;
use crate::hard::{config, millionths, weights};
use couplet::certify::state::{Answer, Certify, Outcome};
use couplet::number::ExactNumber;
use couplet::study::static_programme::{least_thickness, thrust_range};
use proptest::prelude::*;
use rug::Rational;

/// Joints at which the conditions are asked for.
const JOINTS: usize = 1500;

proptest! {
    #![proptest_config(config(150))]

    /// The static programme is a lower bound of the least thickness, and a close one.
    #[test]
    fn the_static_programme_agrees_from_below(
        alpha in millionths(300_000, 2_640_000), mu in millionths(100_000, 5_000_000), weight in weights(),
    ) {
        let Ok(Outcome::Stands(state)) = arch(weight, &alpha, &mu).state(256) else { return Ok(()) };
        let eta = state.thickness.mid().to_f64();
        let discrete = least_thickness(weight, alpha.to_f64(), mu.to_f64(), JOINTS);
        prop_assert!(discrete <= eta * (1.0 + 1e-9), "{discrete} above {eta}");
        prop_assert!(discrete >= eta * (1.0 - 2e-3) - 1e-9, "{discrete} far below {eta}");
    }
}

proptest! {
    #![proptest_config(config(120))]

    /// An arch of a given thickness: the range of thrusts agrees with the static programme, and
    /// standing with the least thickness.
    #[test]
    fn an_assessment_agrees_with_the_static_programme(
        alpha in millionths(200_000, 2_640_000), mu in millionths(50_000, 4_000_000),
        part in millionths(600_000, 3_000_000), weight in weights(),
    ) {
        let asked = arch(weight, &alpha, &mu);
        let Ok(Answer::Stands(least)) = asked.certify(17) else { return Ok(()) };
        // A thickness around the least one, from thinner to much thicker.
        let eta = Rational::from_f64(least.thickness.double).unwrap() * part;
        if eta >= Rational::from((19, 10)) { return Ok(()) }
        let found = asked.certify_thickness(&ExactNumber::from(&eta), 12).unwrap();
        prop_assert_eq!(found.stands.clone(), Ok(eta.to_f64() > least.thickness.double));
        let discrete = thrust_range(weight, alpha.to_f64(), mu.to_f64(), eta.to_f64(), JOINTS);
        let [Some(low), Some(high)] = found.limits() else {
            prop_assert_eq!(found.stands, Ok(false));
            // Infeasible on all joints may be feasible on some: only close to the least thickness.
            prop_assert!(discrete.is_none() || eta.to_f64() > 0.99 * least.thickness.double);
            return Ok(());
        };
        let (a, b) = discrete.expect("what stands on all joints stands on some");
        let close = |x: f64, y: f64| (x - y).abs() < 2e-3 * (1.0 + y.abs());
        let low = low.thrust.as_ref().unwrap().double;
        prop_assert!(close(a, low) && a <= low + 1e-9, "least thrust {a} and {low}");
        match &high.thrust {
            Some(high) => prop_assert!(close(b.min(999.0), high.double.min(999.0)), "largest thrust {b} and {}", high.double),
            None => prop_assert!(b > 999.0),
        }
        let safety = found.geometric_safety.unwrap().unwrap().double;
        approx::assert_relative_eq!(safety, eta.to_f64() / least.thickness.double, max_relative = 1e-9);
        // With the required friction and a little more it stands, with a little less it does not.
        let required = found.required_friction.unwrap().unwrap().decimal.value.to_rational();
        let with = |factor: (i32, i32)| {
            let mu = Rational::from(factor) * &required;
            arch(weight, &alpha, &mu).certify_thickness(&ExactNumber::from(&eta), 6).unwrap().stands == Ok(true)
        };
        prop_assert!(with((1_000_001, 1_000_000)) && !with((999_999, 1_000_000)));
    }
}
