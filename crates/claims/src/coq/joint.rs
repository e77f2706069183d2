//! The widest rotational joint as the zero of the radicand (12) alone.

use super::names::{BITS, bracket, find, module, weight_name};
use super::table::derivative;
use super::template::fill;
use super::term::Term;
use crate::arch::{SelfWeight, Unknown, cubic};
use crate::certify::{CertifiedLandmark, Undecided};
use crate::problem::Landmark;

/// The bracket in which the zero is the only one, and where inside the radicand is known to rise.
const BRACKET: [(&str, &str); 4] =
    [("first", "0.25"), ("rise", "0.9"), ("top", "1.6"), ("last", "2.4")];

/// The file of the zeros of the radicand.
pub(super) fn file(points: &[CertifiedLandmark]) -> Result<String, Undecided> {
    let mut out = fill(
        include_str!("templates/joints.v"),
        &BRACKET.map(|(name, value)| (name, value.to_owned())),
    );
    for weight in SelfWeight::ALL {
        let point = find(points, Landmark::WidestJoint, weight)?;
        let delta = weight.flag();
        let radicand =
            cubic::radicand(&cubic::abbreviations(&Term::angle("beta")), &Term::constant(delta));
        let beta = point.enclosure(BITS)?.value(Unknown::RotationJoint);
        let beta = beta.ok_or_else(|| Undecided::new("sb has no rotational joint"))?;
        let mut values = bracket(&beta);
        values.extend(BRACKET.map(|(name, value)| (name, value.to_owned())));
        values.extend([
            ("weight", weight_name(weight).into()),
            ("name", weight.name().into()),
            ("delta", delta.to_string()),
            ("module", module(Landmark::WidestJoint, weight)),
            ("slope", derivative(&radicand, "beta").to_string()),
        ]);
        out.push_str(&fill(include_str!("templates/joint.v"), &values));
    }
    Ok(out)
}
