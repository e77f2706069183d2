//! Asymmetric solutions of Eq. (19): in which arches they are, and how many.
//!
//! The three kinds are all there are (`asymmetric-kinds`). Their hinges touch at one thickness for each thrust
//! and vertical force; in balls all of these are looked at: [`asymmetric_cover`](super::asymmetric_cover). In one
//! arch with a shoulder that slides the vertical force alone is left, and what holds on the way from the
//! symmetric state changes but once.

use super::asymmetric_cover::{Directions, ForceRectangle, RECTANGLE, elsewhere, known};
use super::asymmetric_kinds::{borne, margin_at};
use super::letters::ring;
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::mechanism::Contact;
use crate::arch::whole::Side;
use crate::number::{Angle, Field};
use crate::symbolic::{Fraction, Letters, Symbol, along_the_joint};
use rayon::prelude::*;
use std::sync::OnceLock;

claims! {
    Ours("asymmetric-number", "Eq. (19), Sec. 5", number):
        "with Milankovitch's weight (19) has an asymmetric solution exactly where the state at the least thickness is [s,r,r], \
         inside, with alpha > 90° and (1 + eta/2 - (1 - eta/2) cos(beta_r)) |cot(alpha)| > (1 - eta/2) sin(beta_r), and then \
         one beside its mirror image: at each half opening at an interval of frictions, from pure sliding on; with Heyman's one there too, and elsewhere none or two: one that opens the shoulder, \
         which may be the symmetric state, and one that does not, or a single one where they meet. Other asymmetric solutions \
         do not exist";
}

/// Directions, with the proofs outside of the rectangle and in it.
type DecidedDirections = (Directions, Checked<usize>, Checked<[usize; 2]>);

/// Results for each weight, each decided once.
fn decided() -> &'static [DecidedDirections] {
    static DECIDED: OnceLock<Vec<DecidedDirections>> = OnceLock::new();
    DECIDED.get_or_init(|| {
        let both = Directions::ALL.par_iter().map(|directions| {
            (*directions, elsewhere(directions.weight, RECTANGLE), known(*directions))
        });
        both.collect()
    })
}

/// The two hinges touch at one thickness.
fn one_touch(d: &mut Derivation) -> Checked {
    let (eta, delta) = (ring().thickness, Symbol::Flag.number());
    let two = eta.int(2);
    let crown =
        Angle { rad: Symbol::Radius.number(), sin: Symbol::F.number(), cos: Symbol::G.number() };
    d.define("b0, the hinge right of the crown", &crown.rad);
    d.define("sin(b0)", &crown.sin);
    d.define("cos(b0)", &crown.cos);
    let haunch = Symbol::joint();
    let (thrust, vertical) = (Symbol::Thrust.number(), Symbol::CrownShear.number());
    let bow = thrust.clone() - thrust.int(1) + ring().centroid_factor * &two / ring().extrados();
    let arm = (haunch.rad.clone() - vertical) * &haunch.cos - bow * &haunch.sin;
    let slope = margin_at(Contact::Extrados, &haunch).derivative(&along_the_joint());
    let words = "dU/d beta; c = h - 1 + 2 fac/(2 + eta) in the bracket";
    d.on_circle(words, slope, arm * ring().extrados() / &two)?;
    let left = Side::Left.joint(&haunch);
    let [above, below] =
        [margin_at(Contact::Extrados, &crown), margin_at(Contact::Intrados, &left)];
    let [[over, _], [under, _]] = [borne(&crown), borne(&left)];
    let growth = (above.clone() + below).partial(Symbol::Thickness) * &two;
    let third = delta.clone() * &eta / eta.int(3);
    let expected = over.clone() + under + third.clone() * (crown.cos.clone() - &haunch.cos);
    d.identity("2 d/d eta of U at b0 and L at -b1, together free of p", growth, expected)?;
    let rest = eta.int(12) - delta.clone() * &eta * eta.int(4) - delta * eta.square();
    let most = over - third * crown.versine();
    let moment = Symbol::CrownMoment.number();
    let expected = moment + crown.versine() * &rest / eta.int(12) + above;
    let words = "N at b0 less (delta eta/3) (1 - cos(b0)), times 1 + eta/2: positive where U is zero, as p is and the \
                 factor of delta is at most 12";
    d.identity(words, most * ring().extrados() / &two, expected)?;
    let bow: Fraction = ring().centroid_factor * &two / ring().extrados();
    let expected = -(rest / (ring().extrados().square() * eta.int(6)));
    d.identity("d/d eta of 2 fac/(2 + eta)", bow.partial(Symbol::Thickness), expected)
}

/// Regions of the forces and turns along the vertical force, decided in balls for each weight.
fn in_balls(d: &mut Derivation) -> Checked {
    for (directions, nowhere, near) in decided() {
        let weight = directions.weight;
        let [least, most] = RECTANGLE.inclinations.map(|n| f64::from(n) / 64.0);
        let words = format!(
            "{weight}: so it is only where h is between cos²({most}) and cos²({least}), and v at most {}",
            f64::from(RECTANGLE.vertical) / 64.0
        );
        // Solutions are beyond a smaller one.
        let smaller = ForceRectangle { vertical: RECTANGLE.vertical / 4, ..RECTANGLE };
        d.known(words, nowhere, smaller, |rectangle| elsewhere(weight, rectangle))?;
        let turn = if directions.opening_grows { "from - to +" } else { "from + to -" };
        let words = format!(
            "{weight}: there, in one arch with growing v, the misfit alpha - alpha_Q turns from + to - only, where alpha >= alpha_I; \
             U at the springing turns {turn} only, where alpha >= alpha_I and alpha >= alpha_Q; and with one h, alpha_U falls \
             below the larger of the others once at the most; with one v, the misfit and U turn from + to - as h grows. Each \
             solution is between {} and {} degrees",
            directions.half_openings[0], directions.half_openings[1]
        );
        let other = Directions { opening_grows: !directions.opening_grows, ..*directions };
        d.known(words, near, other, known)?;
    }
    Ok(())
}

fn number(d: &mut Derivation) -> Checked {
    d.assume("0 < alpha < pi, 0 < eta <= 2, 0 <= mu < inf; v > 0, the right springing slides");
    lemmas(d, ["asymmetric-kinds", "unique-thickness"])?;
    one_touch(d)?;
    d.argue(
        "With h and v a hinge b0 exists from one thickness on, as c falls, and none with h >= 3/2, where c >= 1; the margins at \
         b0 and -b1 can both be zero at one thickness only, where their sum grows. So h and v give eta, b0, b1 and p, whatever alpha and the friction are. The \
         springing is on the extrados at one half opening alpha_U, and U is positive there if alpha < alpha_U. The slips of the \
         three kinds are not negative if alpha >= alpha_Q, where the two hinges and the springing fit alone. The springing \
         slides, h = (alpha - v) cot(alpha - phi), so that the joint v - s is not beyond its limit if alpha >= alpha_I, where \
         (17) and (18) hold with alpha - v for alpha. A state has one of the three kinds just where alpha_I <= alpha, alpha_Q <= \
         alpha and alpha <= alpha_U, one of them with equality.",
    )?;
    in_balls(d)?;
    d.argue(
        "In one arch h falls as v grows, so that alpha_I grows: it is at most alpha up to one v, and alpha_Q is so too, up to a \
         first v1. In each solution v <= v1, with equality in those that do not open the shoulder; where v < v1 U is zero. So \
         there is one of each kind at the most: of those with U > 0 or U = 0 at v1 one, and of those with U = 0 before one, as U \
         turns once.",
    )?;
    d.argue(
        "At v = 0 these are the arches whose symmetric state with a sliding shoulder has U > 0 there, no sliding joint inside \
         and room to fit, the inequality above: this state is a solution of (19), the least thickness. If U turns from + to -, U \
         at v = 0 decides: where it is positive there is one solution, at v1 or before, and else none. If it turns from - to \
         +, U at v1 decides: where it is positive there is one at v1, and one before if U is negative at v = 0; where it is zero \
         there is one at v1; else none.",
    )?;
    d.argue(
        "At one half opening these symmetric states have an interval of frictions, from that of pure sliding on: h grows with \
         the friction, alpha_I falls, and what is positive at one is so at each less, down to alpha_I = alpha.",
    )?;
    d.conclude(
        "With v < 0 take the mirror image; with v = 0 a motion and its mirror image add up to a symmetric one, and \
         unique-thickness says where it is.",
    )
}

#[cfg(test)]
mod tests {
    use super::super::along::{parsed, standing};
    use super::*;
    use crate::arch::SelfWeight;
    use crate::certify::state::Certify;
    use crate::certify::{asymmetric, asymmetric_thicknesses, most_asymmetric};

    /// The bounds of the half opening are used.
    #[test]
    fn narrower_bounds_are_refused() {
        for directions in Directions::ALL {
            let [low, high] = directions.half_openings;
            for half_openings in [[low + 3, high], [low, high - 3]] {
                let narrower = Directions { half_openings, ..directions };
                assert!(known(narrower).is_err(), "{half_openings:?}");
            }
        }
    }

    /// Asymmetric solutions that the program finds of an arch: as many as there are. `None` where nothing stands.
    fn found(weight: SelfWeight, alpha: &str, mu: &str) -> Option<usize> {
        let arch = parsed(weight, alpha, mu).unwrap();
        standing(arch.state(64).unwrap()).ok()?;
        let (found, most) = (asymmetric(&arch, 9).unwrap(), most_asymmetric(&arch).unwrap());
        let found = found.found.into_iter().map(Result::unwrap).count();
        let told = asymmetric_thicknesses(&arch, 9).unwrap().len();
        assert_eq!(told, found, "the table holds what is found: {weight:?} {alpha} {mu}");
        assert!(
            found == most || (found, most) == (0, 2),
            "{weight:?} {alpha} {mu}: {found}, {most}"
        );
        Some(found)
    }

    #[test]
    fn the_search_finds_as_many() {
        let mut counts = [0; 3];
        for weight in SelfWeight::ALL {
            for k in 0..16 {
                for n in 0..10 {
                    let alpha = format!("{}", 2.17 + 0.021 * f64::from(k));
                    let mu = format!("{}", 0.82 + 0.032 * f64::from(k) + 0.013 * f64::from(n));
                    let Some(found) = found(weight, &alpha, &mu) else { continue };
                    counts[found] += 1;
                }
            }
        }
        assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
    }

    /// A hundred thousand arches about the region, a minute long: `cargo test --lib in_many_arches -- --ignored`.
    #[test]
    #[ignore = "a minute long"]
    fn the_search_finds_as_many_in_many_arches() {
        let mut seed = 1u64;
        let mut random = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut counts = [0; 4];
        for k in 0..100_000 {
            let weight = SelfWeight::ALL[k % 2];
            let alpha = 2.17 + 0.35 * random();
            // About the friction of pure sliding, and above.
            let mu = 0.86 + 1.8 * (alpha - 2.2) + 0.25 * (random() - 0.4);
            let [alpha, mu] = [alpha, mu].map(|x| format!("{x:.9}"));
            counts[found(weight, &alpha, &mu).unwrap_or(3)] += 1;
        }
        println!("{counts:?} arches with none, one and two, and that do not stand");
        assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
    }
}
