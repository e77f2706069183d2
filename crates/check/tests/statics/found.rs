//! How an arch collapses, found by the statics: a place for a certificate to begin at.

use super::ball::Ball;
use super::decide::Arch;
use super::judge::{Forces, Row};
use super::ring::{Contact, Joint, Ring};
use rug::{Integer, Rational};
use std::collections::BTreeMap;

/// A mode, or why the arch stands at no thickness; and roughly the values there.
pub(crate) struct Found {
    pub(crate) subject: &'static str,
    pub(crate) values: BTreeMap<&'static str, Rational>,
}

/// Shifts after which ends of ordinary size are next to each other.
const CLOSE: u32 = 24;

pub(crate) fn found(
    true_centroids: bool,
    alpha: &Ball,
    mu: Option<&Ball>,
) -> Result<Found, String> {
    let ring = |eta: &Ball| Ring::new(true_centroids, eta, mu.cloned());
    let thick = |eta: &Ball| Arch { ring: ring(eta), half_opening: alpha.clone() };
    let limit = alpha.int(2);
    let thickest = thick(&limit).decide(&[])?;
    if thickest.stands {
        let row = Row { arch: &thick, upwards: true };
        return at_border(row, &limit, &|eta| eta.over(2), "thickness", None);
    }
    let sliding = thickest.joints.iter().filter(|(contact, _)| contact.slides()).cloned();
    match (mu, thick(&limit).thrusts(&sliding.collect::<Vec<_>>())) {
        (Some(mu), [Some(low), Some(high)]) if low > high => {
            let wide = alpha.int(1000);
            let rough = |mu: &Ball| Arch {
                ring: Ring::new(false, &wide, Some(mu.clone())),
                half_opening: alpha.clone(),
            };
            let row = Row { arch: &rough, upwards: true };
            at_border(row, mu, &|mu| mu + &mu.int(1).over(4), "friction", Some("slides"))
        }
        _ => {
            let open = |alpha: &Ball| Arch { ring: ring(&limit), half_opening: alpha.clone() };
            let row = Row { arch: &open, upwards: false };
            let narrower = |alpha: &Ball| (&alpha.int(7) * alpha).over(8);
            at_border(row, alpha, &narrower, "half_opening", Some("too_wide"))
        }
    }
}

/// The border between one arch and the first on the other side of it, some steps away.
fn at_border(
    row: Row,
    from: &Ball,
    step: &dyn Fn(&Ball) -> Ball,
    unknown: &'static str,
    subject: Option<&'static str>,
) -> Result<Found, String> {
    let mut ends = [from.point(), step(from).point()];
    let stands = (row.arch)(&ends[0]).decide(&[])?.stands;
    while (row.arch)(&ends[1]).decide(&[])?.stands == stands {
        ends = [ends[1].clone(), step(&ends[1]).point()];
        if ends[1].mid.significant_bits() < 40 {
            return Err("no other end".into());
        }
    }
    ends.sort_by(|a, b| a.mid.cmp(&b.mid));
    let border = row.border(ends, &[], CLOSE)?;
    let between = border.falls.hull(&border.stands);
    let arch = (row.arch)(&between);
    let alpha = arch.half_opening.clone();
    // The shoulder is where it is, however wide the arch.
    let joints = border.joints.iter().map(|(contact, joint)| {
        let is_shoulder = joint.at.mid >= alpha.low();
        (*contact, if is_shoulder { Joint::new(&alpha) } else { joint.clone() })
    });
    let forces = Forces::new(arch, &joints.collect())?;
    let at =
        |contact| border.joints.iter().find(|(c, _)| *c == contact).map(|(_, joint)| &joint.at);
    let [haunch, slides, slips] = [Contact::Intrados, Contact::Inwards, Contact::Outwards].map(at);
    let is_crown = haunch.is_none_or(|x| Integer::from(&x.mid << 16) < alpha.mid);
    let mode = match (slides, slips) {
        (Some(_), _) if is_crown => "[r,s]",
        (Some(slides), _) if haunch.is_some_and(|x| x.mid > slides.mid) => "[r,r,s]",
        (Some(_), _) => "[r,s,r]",
        (None, Some(_)) => "[s,r,r]",
        (None, None) if is_crown => "[r]",
        (None, None) => "[r,r,r]",
    };
    let mut values =
        BTreeMap::from([(unknown, between.rational()), ("thrust", forces.thrust.rational())]);
    values.extend(haunch.map(|x| ("rotation_joint", x.rational())));
    values.extend(slides.map(|x| ("sliding_joint", x.rational())));
    Ok(Found { subject: subject.unwrap_or(mode), values })
}
