//! Junction of the rotational and the overturning branch at `l`.

use super::asymptotics::{check_states, slope_to_thickness};
use super::overturning::opening_at;
use super::{Checked, Derivation, claims};
use crate::arch::{SelfWeight, overturning};
use crate::certify::Undecided;
use crate::number::{Field, Surd};
use crate::solve::expansion::{AboutEnd, about_end};
use crate::symbolic::Series;

claims! {
    AsPrinted("joining-heyman", "Sec. 2.1, Fig. 4", |d| joining(d, SelfWeight::Heyman, &Surd::rational((-9, 2), 3))):
        "for Heyman's weight eta(A) and eta(alpha) of the rotational and of the overturning states join with one \
         slope at l (C1); they do not join C2";
    AsPrinted("joining-milankovitch", "Sec. 2.1, Fig. 4",
        |d| joining(d, SelfWeight::Milankovitch, &Surd::new(0, -4, 3))):
        "for Milankovitch's weight eta(A) and eta(alpha) of the rotational and of the overturning states join with \
         one slope at l (C1); they do not join C2";
}

/// Coefficients shown and checked.
const TERMS: usize = 8;

fn joining(d: &mut Derivation, weight: SelfWeight, slope: &Surd) -> Checked {
    let thickness = &overturning::thickness_at_end(weight, &Surd::new(0, 1, 3));
    d.assume(
        "x = A - A_l; rotation for x >= 0 with u = beta_r^2, overturning for x <= 0 with h = 0",
    );
    let AboutEnd { joint_squared, thickness: rotation, thrust, overturning_thickness: overturned } =
        about_end(weight, thickness, TERMS)
            .ok_or_else(|| Undecided::new("the series about l do not settle"))?;
    let a_at_end = opening_at(weight, thickness);
    d.equal("A_l", &opening_at(weight, &overturned).coefficient(0), &a_at_end)?;

    let end = Series::new(thickness, vec![thickness.clone()], 2);
    let words =
        "the slope of (2) - (5), cleared, to eta at l, so that eta is an analytic function of u";
    let slope_at_end = slope_to_thickness(weight, &end).coefficient(0);
    d.differ(words, &slope_at_end, &thickness.int(0))?;
    d.define("u", joint_squared.show("x"));
    d.define("eta, rotation", rotation.show("x"));
    d.define("h, rotation", thrust.show("x"));
    d.define("eta, overturning", overturned.show("x"));
    let x = Series::variable(thickness, rotation.length());
    let a = Series::new(thickness, vec![a_at_end.clone()], rotation.length()) + &x;
    check_states(d, weight, [&joint_squared, &rotation, &thrust], &a)?;
    let rest = opening_at(weight, &overturned) - &a;
    d.vanishes("(13) on the side of overturning", &rest)?;

    let zero = thickness.int(0);
    d.equal("eta_l on the side of rotation", &rotation.coefficient(0), thickness)?;
    d.equal("eta_l on the side of overturning", &overturned.coefficient(0), thickness)?;
    d.equal("d eta/dA at l, rotation", &rotation.coefficient(1), slope)?;
    d.equal("d eta/dA at l, overturning", &overturned.coefficient(1), slope)?;
    d.equal("h at l", &thrust.coefficient(0), &zero)?;
    d.equal("dh/dA at l: zero on both sides", &thrust.coefficient(1), &zero)?;
    let second = |series: &Series<Surd>| series.coefficient(2) * Surd::rational(2, 3);
    d.differ(
        "d^2 eta/dA^2 at l, rotation and overturning",
        &second(&rotation),
        &second(&overturned),
    )?;
    d.differ(
        "du/dA at l, so that beta_r = sqrt(u) starts vertically",
        &joint_squared.coefficient(1),
        &zero,
    )?;
    d.conclude(
        "dA/du at l is 1 over du/dA: so u is an analytic function of A, and the series are those of u, eta and h. That \
         of overturning is that of eta, as d eta/dA is not zero and (13) has no pole at l.",
    )?;
    d.conclude("dA/d alpha is not zero at alpha_l (alpha-one-to-one), so that in alpha, too, the slopes agree and the \
                curvatures differ")
}
