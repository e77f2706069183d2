//! The half openings at which rotation and overturning end, from the closed forms of `A`.

use super::landmark::title;
use super::names::{BITS, bracket, find, module, weight_name};
use super::numeral::fraction;
use super::template::fill;
use crate::arch::{SelfWeight, Unknown};
use crate::certify::{CertifiedLandmark, Exact, Undecided};
use crate::number::Surd;
use crate::problem::{Landmark, Quantity};
use rug::Rational;

/// The file of the half openings at `l` and `L`.
pub(super) fn file(points: &[CertifiedLandmark]) -> Result<String, Undecided> {
    let mut out = include_str!("templates/half_openings.v").to_owned();
    for landmark in [Landmark::RotationEnd, Landmark::OverturningEnd] {
        for weight in SelfWeight::ALL {
            let point = find(points, landmark, weight)?;
            let theorems = theorems(point)
                .ok_or_else(|| Undecided::new(format!("no exact value of A at {landmark}")))?;
            out.push_str(&theorems);
        }
    }
    Ok(out)
}

fn theorems(point: &CertifiedLandmark) -> Option<String> {
    let (landmark, weight) = (point.landmark(), point.weight());
    let Some(Exact::Surd(opening)) = point.exact(Quantity::OpeningVariable) else { return None };
    let alpha = point.enclosure(BITS).ok()?.value(Unknown::HalfOpening)?;
    let name = format!("{}_{weight}", landmark.name().replace(' ', "_"));
    let (template, lemma) = match landmark {
        Landmark::RotationEnd => (include_str!("templates/rotation_end.v"), "rotation_end"),
        _ => (include_str!("templates/overturning_end.v"), "overturning_end"),
    };
    let thickness = match weight {
        SelfWeight::Heyman => "1",
        SelfWeight::Milankovitch => "eta_l_milankovitch",
    };
    let mut values = bracket(&alpha);
    values.extend([
        ("title", title(landmark)),
        ("weight", weight_name(weight).into()),
        ("name", name),
        ("opening", surd(&opening)),
        ("thickness", thickness.into()),
        ("module", module(landmark, weight)),
        ("lemma", format!("{lemma}_{weight}")),
    ]);
    let both = [include_str!("templates/half_opening.v"), template];
    Some(both.map(|template| fill(template, &values)).concat())
}

/// `a + b sqrt d` as Coq reads it.
fn surd(value: &Surd) -> String {
    let (rational, factor, radicand) = value.parts();
    let root = match () {
        () if *factor == 0 => return fraction(rational),
        () if *factor == 1 => format!("sqrt {radicand}"),
        () => format!("{} * sqrt {radicand}", fraction(factor)),
    };
    if *rational == 0 {
        root
    } else if *rational < 0 {
        format!("{root} - {}", fraction(&Rational::from(-rational)))
    } else {
        format!("{root} + {}", fraction(rational))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surds_read_as_one_writes_them() {
        assert_eq!(surd(&Surd::new(-1, 1, 3)), "sqrt 3 - 1");
        assert_eq!(surd(&Surd::new(-6, 4, 3)), "4 * sqrt 3 - 6");
        assert_eq!(surd(&Surd::rational((2, 3), 3)), "2 / 3");
        assert_eq!(surd(&Surd::rational(5, 3)), "5");
    }
}
