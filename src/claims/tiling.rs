//! The map as the graph of one function: to each thickness and friction belongs one half opening that just stands,
//! and two questions tell its mode.
//!
//! The inner part asks for a thrust: at least `h_R` of the rotational state of the thickness, so that the line of
//! thrust stays between crown and haunch, and at least `h_s` of the friction, so that no inner joint slides. The
//! shoulder ends the arch where it is on the extrados or where it slides, and does so the later the smaller the thrust.

use super::contacts::Contact;
use super::curve::STATES_IN_ORDER;
use super::domains::INNER_SLIDING_BEYOND_T;
use super::frictions::{
    FRICTION_FOR_ROTATION_GROWS, FRICTION_OF_SMALL_THRUST, ROTATION_MEETS_SLIDING,
};
use super::letters::{ring, variables};
use super::modes::{CONTACTS, SEVEN_MODES};
use super::uniqueness::{MECHANISM_BOUNDS, THICKER_HAS_ROOM};
use super::{Claim, Derivation, Finding};
use crate::arch::{sliding, statics, thrust};
use crate::certify::Undecided;
use crate::number::{Angle, Field};
use crate::symbolic::{Letters, Polynomial, Relations, Symbol};

pub(super) const CLAIMS: &[Claim] = &[
    ONE_HALF_OPENING,
    Claim {
        id: "map-columns",
        place: "Sec. 3, Fig. 5, 6",
        statement: "the modes fill the map: at a given friction they follow each other, as the thickness \
                    grows, in the order [r,r,r], [s,r,r], [r,r,s], [r,s,r], [r,s], [s,s], each on an \
                    interval or not at all; the second is left of T, the next three are right of it",
        decide: columns,
    },
    Claim {
        id: "map-T-frictions",
        place: "Sec. 3",
        statement: "beyond T an inner joint asks for a higher friction than the shoulder, in the purely \
                    rotational states and, without limit, in the purely overturning ones; in the mixed ones \
                    it takes all there is",
        decide: frictions_beyond_t,
    },
];

const ONE_HALF_OPENING: Claim = Claim {
    id: "map-function",
    place: "Sec. 3, Fig. 5, 6",
    statement: "to each thickness 0 < eta < 2 and each friction 0 < mu < inf belongs one half opening: \
                narrower arches stand, wider ones fall, and there alone a symmetric mechanism exists",
    decide: one_half_opening,
};

fn one_half_opening(d: &mut Derivation) -> Result<Finding, Undecided> {
    d.lemma(&CONTACTS)?;
    d.lemma(&SEVEN_MODES)?;
    d.lemma(&MECHANISM_BOUNDS)?;
    let (h, free) = (Symbol::Thrust.number(), Relations::none());
    let (crown, one) = (Angle::zero(&h), h.int(1));
    let eta = ring().thickness;
    let cases = [
        (Contact::Extrados, eta.clone() / h.int(2)),
        (Contact::Intrados, eta / h.int(2)),
        (Contact::Inwards, Symbol::Friction.number()),
        (Contact::Outwards, Symbol::Friction.number()),
    ];
    for (contact, expected) in cases {
        let margin = contact.margin(&crown).evaluate(&h, |symbol| match symbol {
            Symbol::Thrust | Symbol::CrownMoment => one.clone(),
            other => other.number(),
        });
        let words = format!("{} at the crown for h = p = 1: positive", contact.name());
        d.identity(words, &margin, &expected, &free)?;
    }
    let flat = Angle { rad: Symbol::HalfOpening.number(), sin: h.int(0), cos: h.int(-1) };
    d.identity("N at pi", &statics::normal_force(&flat, &h), &-h, &free)?;
    d.conclude(
        "So narrow arches stand, by continuity; none of half opening pi does, as N > 0 in an admissible state; and \
         a part of an arch that stands, cut off at a joint, stands. The limit of arches that stand \
         does, since the conditions are closed: the widest is alpha* < pi.",
    );
    d.conclude(
        "At alpha* no state leaves a positive margin at all joints, else a wider arch would stand. So it has a mechanism \
         (linear inequalities without a strict solution have multipliers). Suppose a narrower arch has one. In a state \
         of a wider one, U > 0 and mu N + T > 0 at its shoulder, a joint within. But margins that are not negative \
         are all zero where the mechanism moves: so it does not move at the shoulder, and then nowhere, as it has a term on \
         each side.",
    );
    Ok(Finding::Implicit)
}

fn columns(d: &mut Derivation) -> Result<Finding, Undecided> {
    d.lemma(&ONE_HALF_OPENING)?;
    d.lemma(&THICKER_HAS_ROOM)?;
    d.lemma(&STATES_IN_ORDER)?;
    d.lemma(&FRICTION_FOR_ROTATION_GROWS)?;
    d.lemma(&INNER_SLIDING_BEYOND_T)?;
    let (at, ring, free) = (variables(), ring(), Relations::none());
    let two = at.thrust.int(2);
    let lower = thrust::lower(&at.rotation_joint, &ring);
    let sum =
        Contact::Extrados.margin(&Angle::zero(&two)) + Contact::Intrados.margin(&at.rotation_joint);
    d.identity(
        "U at the crown and L at a joint add up to h - h_L up to a positive factor",
        &sum,
        &(lower.residual(&at.thrust) / &two),
        &free,
    )?;
    d.conclude(
        "So h >= h_R(eta), the largest h_L, that of the rotational state of this thickness; it falls as eta grows, and is 0 from \
         eta_l on. And h >= h_s(mu). The mode has a hinge at the crown only if h = h_R, an inner joint that slides \
         only if h = h_s: below one thickness h_R > h_s, above it h_R < h_s.",
    );
    let rest = two.clone() * &ring.centroid_factor / ring.intrados();
    let slope = rest.derivative(&[(Symbol::Thickness, Polynomial::from(1))]);
    let expected = (two.clone() * &ring.centroid_factor
        + Symbol::Flag.number() * &ring.thickness * ring.intrados() / two.int(3))
        / ring.intrados().square();
    d.identity("2 fac/(2 - eta), by which beta_r falls in (5), grows", &slope, &expected, &free)?;
    d.conclude(
        "Below it h = h_R, and the haunch is that of the rotational state of half opening alpha_0(eta), which grows: \
         [r,r,r] as long as M(alpha_0) <= mu, [s,r,r] from there on. Above it h = h_s: let alpha_P be the half opening that \
         just slides. If it stands, alpha* = alpha_P, [s,s]; and it stands from one thickness on. Below that the \
         shoulder opens, beta_r cot(beta_r) = h_s - 1 + 2 fac/(2 - eta) grows up to 1: beta_r falls, past beta_s, to the crown: \
         [r,r,s], [r,s,r], [r,s].",
    );
    d.conclude(
        "At the thickness where h_R = h_s, mu = m(alpha_0). For mu < mu_T, alpha_0 < alpha_T and M > m: [s,r,r] comes before, \
         and then [s,s], as no inner joint slides with a hinge at the shoulder left of T. For mu >= mu_T, M <= m: [s,r,r] is left out.",
    );
    Ok(Finding::AsPrinted)
}

fn frictions_beyond_t(d: &mut Derivation) -> Result<Finding, Undecided> {
    d.lemma(&ROTATION_MEETS_SLIDING)?;
    d.lemma(&FRICTION_OF_SMALL_THRUST)?;
    let alpha = Symbol::half_opening();
    let none = alpha.rad.int(0);
    d.identity(
        "the friction that the shoulder asks for without thrust: bounded, as alpha < pi",
        &sliding::shoulder(&alpha, &none).value(),
        &-(alpha.cos / alpha.sin),
        &Relations::none(),
    )?;
    d.conclude(
        "In [r,r,r] beyond T, M < m; in [r], m is unbounded. In [r,r,s], [r,s,r] and [r,s] mu = mu_is, and the \
         shoulder, which does not slide, asks for no more.",
    );
    Ok(Finding::AsPrinted)
}
