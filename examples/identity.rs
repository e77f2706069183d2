//! An identity, verified: `cargo run --example identity`.
//!
//! The same function is a value in doubles, an enclosure in balls, and a formula over symbols.

use couplet::arch::{Ring, cubic, thrust};
use couplet::claims::{Finding, claims};
use couplet::number::{Angle, Ball, Field};
use couplet::rug::Rational;
use couplet::symbolic::{Letters, Relations, Symbol};

/// The second cubic (7) is said to be what is left of (2) = (5). Zero, if that is so.
fn left_over<T: Field>(joint: &Angle<T>, thickness: &T, delta: &T) -> T {
    let ring = Ring::with_flag(delta, thickness);
    let tangency = thrust::tangency(&joint.times_cotangent(), &ring);
    let equal = thrust::lower(joint, &ring).difference(&tangency);
    let cubic = cubic::in_thickness(&cubic::abbreviations(joint), delta, thickness);
    equal * thickness.int(3) * &joint.sin - cubic
}

fn main() {
    let tenth = 0.1;
    println!("in doubles    {:e}", left_over(&Angle::new(0.95), &tenth, &1.0));

    let joint = Angle::new(Ball::enclosing(&Rational::from((19, 20)), 200));
    let tenth = Ball::enclosing(&Rational::from((1, 10)), 200);
    let enclosed = left_over(&joint, &tenth, &tenth.int(1));
    println!("in balls      {enclosed:?}");
    assert!(enclosed.contains(&Rational::new()));

    // Neither shows that it is zero everywhere. The normal form does.
    let (joint, thickness, delta) =
        (Symbol::joint(), Symbol::Thickness.number(), Symbol::Flag.number());
    let formula = left_over(&joint, &thickness, &delta);
    let circle = Relations::trigonometric();
    println!("as a formula  {}", formula.reduced(&circle));
    assert!(formula.vanishes(&circle));
    // A check that cannot fail would be none: without sin² + cos² = 1 it is not an identity.
    assert!(!formula.vanishes(&Relations::none()));

    // What the paper claims is decided in the same way.
    let sixteen =
        claims().into_iter().find(|claim| claim.id == "eq-16").map(|claim| claim.decide());
    let found = sixteen.and_then(|decision| decision.outcome.ok());
    println!("Eq. (16)      {found:?}");
    assert!(matches!(found, Some(Finding::Misprint { .. })));
}
