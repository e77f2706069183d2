//! The domains of the modes as loops of named curves.

use crate::atlas::{Corner, DomainSide, boundary};
use crate::problem::Mode;
use crate::report::fields::Fields;

fn corner(corner: Corner) -> String {
    match corner {
        Corner::End(end) => end.to_string(),
        Corner::RightBottom => "phi = pi/2, eta = 0".to_owned(),
        Corner::RightTop => "phi = pi/2, eta = 2".to_owned(),
        Corner::LeftTop => "phi = 0, eta = 2".to_owned(),
    }
}

fn side(side: DomainSide) -> Fields {
    let mut fields = Fields::default();
    let [from, to] = side.ends().map(corner);
    let (curve, is_forward) = match side {
        DomainSide::Along(curve) => (Some(curve), true),
        DomainSide::Back(curve) => (Some(curve), false),
        DomainSide::Edge(..) => (None, true),
    };
    fields.add("curve", curve.map(|curve| curve.to_string()));
    fields.add("forward", is_forward);
    fields.add("from", from);
    fields.add("to", to);
    fields
}

/// Each mode with the sides of its domain in the plane of friction angle and thickness.
pub(super) fn domains() -> Vec<Fields> {
    let domain = |mode: Mode| {
        let mut fields = Fields::default();
        fields.add("mode", mode.label());
        fields.add_list("boundary", boundary(mode).into_iter().map(side));
        fields
    };
    Mode::ALL.into_iter().map(domain).collect()
}
