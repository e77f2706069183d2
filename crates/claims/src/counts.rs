//! Number of equations that rule a state: three or fewer, beside a half opening and a friction. The five hold together
//! at `T` alone.

use super::{Checked, Derivation, claims, lemmas};
use crate::arch::{SelfWeight, Unknown};
use crate::problem::{Equation, Landmark, Mode, System};
use rug::Rational;

claims! {
    Implicit("equations-five", "Sec. 2.3", five_equations):
        "at a given half opening and friction a state has three equations for eta, h and beta_r, in [r,s] two and in \
         [r] one with beta_r = 0; [s,s] has two, for h and one of alpha and mu. Five equations in the five variables \
         alpha, mu, eta, h and beta_r are those of T";
}

/// Number of equations of a system, and of variables for which it is solved; `beta_s` is that of (18).
fn count(system: &System) -> [usize; 2] {
    let equations = system.equations.iter().filter(|x| **x != Equation::Steepest);
    let unknowns = system.unknowns.iter().filter(|x| **x != Unknown::SlidingJoint);
    [equations.count(), unknowns.count()]
}

/// Checks both numbers for either weight.
fn check(
    d: &mut Derivation,
    words: &str,
    expected: usize,
    system: impl Fn(SelfWeight) -> System,
) -> Checked {
    for weight in SelfWeight::ALL {
        let [equations, unknowns] = count(&system(weight)).map(Rational::from);
        let expected = Rational::from(expected);
        d.equal(format!("{words}: its equations, {weight}"), &equations, &expected)?;
        d.equal(format!("{words}: its variables, {weight}"), &unknowns, &expected)?;
    }
    Ok(())
}

fn five_equations(d: &mut Derivation) -> Checked {
    lemmas(d, ["eq-2-4-imply-3", "map-T"])?;
    for mode in Mode::ALL {
        let expected = match mode {
            Mode::Overturning => 1,
            Mode::OverturningSliding | Mode::Sliding => 2,
            _ => 3,
        };
        check(d, mode.label(), expected, |weight| mode.system(weight))?;
    }
    check(d, "T", 5, |weight| Landmark::Triple.system(weight))?;
    d.conclude(
        "(3) follows from (2) and (4): with (5), (17) and (18) they are five. All five hold where the lines of rotation \
         and of sliding meet, with one half opening and one thrust: at T alone. Elsewhere a mode has the equations of \
         the joints that move in it.",
    )
}
