//! The rotational and the overturning states join at `l` with one slope: certified states on either
//! side lie next to the common tangent, as close as a second-order term lets them.
//!
//! The exact slopes, and that the curvatures differ, are claims (`couplet prove joining`).

use crate::hard::config;
use couplet::arch::{SelfWeight, thrust};
use couplet::certify::CertifiedLandmark;
use couplet::certify::state::{Certify, Outcome};
use couplet::number::{Angle, Ball, Field, Real};
use couplet::problem::{Arch, Friction};
use couplet::problem::{Landmark, Mode};
use proptest::prelude::*;
use rug::{Rational, ops::Pow};

const BITS: u32 = 512;

/// `A`, `eta` at `l`, and the slope `d eta/dA`.
fn end(weight: SelfWeight) -> [Ball; 3] {
    let root = Ball::integer(3, BITS).sqrt();
    let one = root.int(1);
    match weight {
        SelfWeight::Heyman => [one.ratio(2, 3), one.clone(), one.ratio(-9, 2)],
        SelfWeight::Milankovitch => {
            [root.clone() - &one, one.int(4) * &root - one.int(6), one.int(-4) * root]
        }
    }
}

/// The purely rotational or overturning state at a half opening `step` away from that of `l`.
fn state(weight: SelfWeight, step: &Rational) -> (Ball, couplet::certify::state::State) {
    let point = CertifiedLandmark::new(Landmark::RotationEnd, weight).unwrap();
    let alpha = point.enclosure(BITS).unwrap().configuration().half_opening.rad.clone();
    let alpha = alpha.mid().to_rational().unwrap() + step;
    let text = format!("{}/{}", alpha.numer(), alpha.denom());
    let arch = Arch::new(weight, text.parse().unwrap(), Friction::Infinite).unwrap();
    let proved = [BITS, 2 * BITS, 4 * BITS].into_iter().find_map(|bits| arch.state(bits).ok());
    let Some(Outcome::Stands(state)) = proved else { panic!("{weight:?} {step}") };
    let a = thrust::opening_variable(&Angle::new(Ball::enclosing(&alpha, BITS))).value();
    (a, *state)
}

fn at_most(x: &Ball, bound: &Ball) -> bool {
    let sizes = [x.clone(), -x.clone()].map(|x| bound.clone() - x);
    sizes.iter().all(|gap| gap.lower() >= 0)
}

proptest! {
    #![proptest_config(config(24))]

    #[test]
    fn states_on_either_side_follow_one_tangent(
        heyman in any::<bool>(), wider in any::<bool>(), mantissa in 1i32..1000, places in 7u32..60,
    ) {
        let weight = if heyman { SelfWeight::Heyman } else { SelfWeight::Milankovitch };
        let size = Rational::from(mantissa) / rug::Integer::from(10).pow(places);
        let step = if wider { size } else { -size };
        let (a, state) = state(weight, &step);
        let side = if wider { Mode::Overturning } else { Mode::Rotational };
        prop_assert_eq!(state.mode, side);
        let [a_end, eta_end, slope] = end(weight);
        let x = a - a_end;
        let rise = state.thickness - eta_end;
        // Half the curvatures are at most 704, and |x| is small.
        let bound = x.square() * x.int(1500);
        let gap = rise.clone() - slope.clone() * &x;
        prop_assert!(at_most(&gap, &bound), "{:?}: {:?}", weight, gap);
        // The thrust joins with the slope zero.
        prop_assert!(at_most(&state.thrust, &bound));
        if places > 10 {
            let twin = rise - (slope + x.ratio(1, 1000)) * &x;
            prop_assert!(!at_most(&twin, &bound), "a slope off by a thousandth is seen");
        }
    }
}
