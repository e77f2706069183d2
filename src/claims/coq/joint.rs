//! The widest rotational joint as the zero of the radicand (12) alone.

use super::numeral::{exact, nearest, text, unit};
use super::table::{DECIMALS, derivative};
use super::{Term, head, module, weight_name};
use crate::arch::{Landmark, SelfWeight, Unknown, cubic};
use crate::certify::{CertifiedLandmark, Undecided};
use std::fmt::Write;

/// Bits of an enclosure.
const BITS: u32 = 256;
/// The bracket in which the zero is the only one, and where inside the radicand is known to rise.
const BRACKET: [&str; 4] = ["0.25", "0.9", "1.6", "2.4"];

/// The file of the zeros of the radicand.
pub fn file(points: &[CertifiedLandmark]) -> Result<String, Undecided> {
    let [first, .., last] = BRACKET;
    let mut out = head(
        "The widest rotational joint as a zero of (12)",
        &format!(
            "    In [{first}, {last}] the radicand (12) has exactly one zero, and it is the joint of the point sb."
        ),
    );
    out = out.replace(
        "Open Scope",
        "From Couplet Require WidestJointHeyman WidestJointMilankovitch.\nOpen Scope",
    );
    for weight in SelfWeight::ALL {
        let theorem = points
            .iter()
            .find(|point| (point.landmark(), point.weight()) == (Landmark::WidestJoint, weight))
            .and_then(theorem)
            .ok_or_else(|| Undecided("sb for Coq: no enclosure".into()))?;
        out.push_str(&theorem);
    }
    Ok(out)
}

fn theorem(point: &CertifiedLandmark) -> Option<String> {
    let (weight, delta) = (point.weight(), point.weight().flag());
    let name = weight.name();
    let module = module(point.landmark(), weight);
    let slope = derivative(&cubic::radicand(&Term::angle("beta"), &Term::constant(delta)), "beta");
    let beta = point.enclosure(BITS).ok()?.value(Unknown::RotationJoint)?;
    let centre = nearest(&exact(beta.mid()), DECIMALS + 2);
    let (lo, hi) = (centre.clone() - unit(DECIMALS), centre.clone() + unit(DECIMALS));
    let [first, rise, top, last] = BRACKET;
    let mut out = String::new();
    let _ = write!(
        out,
        "\n(** ** {title} *)\n\n\
         Definition slope_{name} (beta : R) : R :=\n  {slope}.\n\n\
         Lemma derivative_{name} beta : is_derive (radicand_at {delta}) beta (slope_{name} beta).\n\
         Proof. unfold radicand_at, radicand, f_of, g_of, slope_{name}. auto_derive; [exact I | ring]. Qed.\n\n\
         Theorem widest_joint_{name} : exists beta,\n  \
         Rabs (beta - {centre}) <= 1e-{DECIMALS} /\\\n  \
         radicand {delta} (f_of beta) (g_of beta) (sin beta) = 0 /\\\n  \
         (forall other, {first} <= other <= {last} ->\n     \
         radicand {delta} (f_of other) (g_of other) (sin other) = 0 -> other = beta).\n\
         Proof.\n  \
         destruct (one_joint {delta} slope_{name} {first} {rise} {top} {last} {lo} {hi})\n    \
         as [beta [H [Hroot unique]]]; try lra.\n  \
         - intros x Hx. unfold radicand_at, radicand, f_of, g_of.\n    interval with (i_prec 53, i_bisect x).\n  \
         - exact derivative_{name}.\n  \
         - intros x Hx. unfold slope_{name}. interval with (i_prec 53, i_bisect x).\n  \
         - intros x Hx. unfold radicand_at, radicand, f_of, g_of.\n    interval with (i_prec 53, i_bisect x).\n  \
         - unfold radicand_at, radicand, f_of, g_of. interval with (i_prec 140).\n  \
         - unfold radicand_at, radicand, f_of, g_of. interval with (i_prec 140).\n  \
         - exists beta. split; [apply Rabs_le; lra | split; [exact Hroot | exact unique]].\n\
         Qed.\n\n\
         (** It is the joint of the landmark. *)\n\
         Theorem joint_of_sb_{name} alpha beta_r eta h beta :\n  \
         {module}.wide alpha beta_r eta h -> {module}.equations alpha beta_r eta h ->\n  \
         {first} <= beta <= {last} -> radicand {delta} (f_of beta) (g_of beta) (sin beta) = 0 -> beta = beta_r.\n\
         Proof.\n  \
         intros W E Hbeta Hzero. destruct widest_joint_{name} as [joint [_ [_ unique]]].\n  \
         transitivity joint; [now apply unique | symmetry]. apply unique.\n  \
         - unfold {module}.wide in W. lra.\n  \
         - exact ({module}.radicand_vanishes alpha beta_r eta h W E).\n\
         Qed.\n",
        title = weight_name(weight),
        centre = text(&centre),
        lo = text(&lo),
        hi = text(&hi),
    );
    Some(out)
}
