//! The half openings at which rotation and overturning end, from the closed forms of `A`.

use super::head;
use super::numeral::{exact, nearest, text, unit};
use super::table::DECIMALS;
use crate::arch::{Landmark, Quantity, SelfWeight, Unknown};
use crate::certify::{CertifiedLandmark, Exact, Undecided};
use crate::number::Surd;
use rug::Rational;
use std::fmt::Write;

/// Bits of an enclosure, and bits with which Coq compares.
const BITS: u32 = 256;

/// The file of the half openings at `l` and `L`.
pub fn file(points: &[CertifiedLandmark]) -> Result<String, Undecided> {
    let mut out = head(
        "The half openings at l and L",
        "    Where rotation and overturning end, [A] has an exact value, which it takes only once between 0\n    \
         and two straight angles.",
    );
    for landmark in [Landmark::RotationEnd, Landmark::OverturningEnd] {
        for weight in SelfWeight::ALL {
            let point = points
                .iter()
                .find(|point| (point.landmark(), point.weight()) == (landmark, weight));
            let theorem = point.and_then(theorem).ok_or_else(|| {
                Undecided(format!("{} for Coq: no exact value of A", landmark.symbol()))
            })?;
            out.push_str(&theorem);
        }
    }
    Ok(out)
}

fn theorem(point: &CertifiedLandmark) -> Option<String> {
    let Some(Exact::Surd(value)) = point.exact(Quantity::OpeningVariable) else { return None };
    let value = surd(&value);
    let alpha = point.enclosure(BITS).ok()?.value(Unknown::HalfOpening)?;
    let centre = nearest(&exact(alpha.mid()), DECIMALS + 2);
    let radius = unit(DECIMALS);
    let (lo, hi) = (centre.clone() - &radius, centre.clone() + radius);
    let name = format!("{}_{}", point.landmark().name().replace(' ', "_"), point.weight().name());
    let mut out = String::new();
    let _ = write!(
        out,
        "\nTheorem {name} : exists alpha,\n  \
         Rabs (alpha - {centre}) <= 1e-{DECIMALS} /\\ A alpha = {value} /\\\n  \
         (forall other, 0 < other < 2 * PI -> A other = {value} -> other = alpha).\n\
         Proof.\n  \
         destruct (half_opening ({value}) {lo} {hi}) as [alpha [H [HA unique]]];\n    \
         [lra | lra | interval with (i_prec 53) | unfold A; interval with (i_prec 140)\n    \
         | unfold A; interval with (i_prec 140) |].\n  \
         exists alpha. split; [apply Rabs_le; lra | split; [exact HA | exact unique]].\n\
         Qed.\n",
        centre = text(&centre),
        lo = text(&lo),
        hi = text(&hi),
    );
    Some(out)
}

/// `a + b sqrt d` as Coq reads it.
fn surd(value: &Surd) -> String {
    let (rational, factor, radicand) = value.parts();
    let root = match () {
        () if *factor == 0 => return text(rational),
        () if *factor == 1 => format!("sqrt {radicand}"),
        () => format!("{} * sqrt {radicand}", text(factor)),
    };
    if *rational == 0 {
        root
    } else if *rational < 0 {
        format!("{root} - {}", text(&Rational::from(-rational)))
    } else {
        format!("{root} + {}", text(rational))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surds_read_as_one_writes_them() {
        assert_eq!(surd(&Surd::new(-1, 1, 3)), "sqrt 3 - 1");
        assert_eq!(surd(&Surd::new(-6, 4, 3)), "4 * sqrt 3 - 6");
        assert_eq!(surd(&Surd::rational((2, 3), 3)), "2/3");
        assert_eq!(surd(&Surd::rational(5, 3)), "5");
    }
}
