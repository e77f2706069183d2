//! Statics of blocks cut out of the ring, from its geometry alone.
//!
//! Lengths are in radii of the centre line, forces in the weight of one radius of it, angles in radians from the crown. A
//! block between two joints is a sector of the ring, of area `(outer² - inner²) / 2 * angle = eta * angle`: it weighs its
//! angle. At the crown it bears the horizontal thrust `h`, whose moment about the centre is `p`, and a vertical force `v`.

use super::ball::Ball;
use rug::Integer;

/// What may give way at a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Contact {
    Extrados,
    Intrados,
    Inwards,
    Outwards,
}

impl Contact {
    pub(crate) const ALL: [Self; 4] =
        [Self::Extrados, Self::Intrados, Self::Inwards, Self::Outwards];

    pub(crate) fn slides(self) -> bool {
        matches!(self, Self::Inwards | Self::Outwards)
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Joint {
    pub(crate) at: Ball,
    pub(crate) sin: Ball,
    pub(crate) cos: Ball,
}

impl Joint {
    pub(crate) fn new(at: &Ball) -> Self {
        let [sin, cos] = at.sin_cos();
        Self { at: at.clone(), sin, cos }
    }

    /// All joints so far on both sides.
    fn wider(&self, rad: &Integer) -> Self {
        let [at, sin, cos] = [&self.at, &self.sin, &self.cos].map(|x| x.clone().wider(rad));
        Self { at, sin, cos }
    }
}

/// The ring of a thickness, and its friction, if that has a limit.
#[derive(Clone, Debug)]
pub(crate) struct Ring {
    pub(crate) inner: Ball,
    pub(crate) outer: Ball,
    /// The radius at which the weight of a thin sector acts.
    pub(crate) centroid: Ball,
    pub(crate) friction: Option<Ball>,
}

/// Forces that a block bears at the crown, and its weight for each radian.
pub(crate) struct Load<'a> {
    pub(crate) thrust: &'a Ball,
    pub(crate) moment: &'a Ball,
    pub(crate) vertical: &'a Ball,
    pub(crate) weight: &'a Ball,
}

impl Ring {
    pub(crate) fn new(true_centroids: bool, eta: &Ball, friction: Option<Ball>) -> Self {
        let one = eta.int(1);
        let half = eta.over(2);
        let (inner, outer) = (&one - &half, &one + &half);
        // A thin sector has the area eta, and of its points' distance the integral (outer³ - inner³) / 3.
        let centroid = match true_centroids {
            true => (&(&(&outer * &outer) + &(&outer * &inner)) + &(&inner * &inner)).over(3),
            false => one,
        };
        Self { inner, outer, centroid, friction }
    }

    /// Contacts that can give way.
    pub(crate) fn contacts(&self) -> &'static [Contact] {
        if self.friction.is_some() { &Contact::ALL } else { &Contact::ALL[..2] }
    }

    /// Force across a joint, outwards shear, and moment about the centre; of order one and two their slopes and bends along
    /// the arch: a thin sector adds its weight, and the joint turns.
    fn resultants(&self, joint: &Joint, load: &Load, order: u32) -> [Ball; 3] {
        let Joint { at, sin, cos } = joint;
        // Equilibrium of the block from the crown on.
        let across = load.thrust;
        let up = &(load.weight * at) - load.vertical;
        let normal = &(across * cos) + &(&up * sin);
        let shear = &(&up * cos) - &(across * sin);
        let pull = load.weight * &self.centroid;
        if order == 0 {
            let arm = &at.int(1) - cos;
            return [normal, shear, load.moment + &(&pull * &arm)];
        }
        let [along, down] = [sin, cos].map(|x| load.weight * x);
        let slopes = [&shear + &along, &down - &normal];
        match (order, slopes) {
            (1, [of_normal, of_shear]) => [of_normal, of_shear, &pull * sin],
            (_, [of_normal, of_shear]) => [&of_shear + &down, &-of_normal - &along, &pull * cos],
        }
    }

    /// Room of a joint until the contact gives way, as a moment about the face or a force along the joint; of order one
    /// and two its slope and its bend.
    pub(crate) fn room(&self, contact: Contact, joint: &Joint, load: &Load, order: u32) -> Ball {
        let [normal, shear, moment] = self.resultants(joint, load, order);
        let held = || self.friction.as_ref().expect("a limit") * &normal;
        match contact {
            Contact::Extrados => &(&self.outer * &normal) - &moment,
            Contact::Intrados => &moment - &(&self.inner * &normal),
            Contact::Inwards => &held() - &shear,
            Contact::Outwards => &held() + &shear,
        }
    }

    /// Room of a joint as a linear function of thrust and moment: two slopes, and the rest.
    pub(crate) fn row(&self, contact: Contact, joint: &Joint) -> [Ball; 3] {
        let [zero, one] = [0, 1].map(|n| joint.at.int(n));
        [[&one, &zero, &zero], [&zero, &one, &zero], [&zero, &zero, &one]].map(
            |[thrust, moment, weight]| {
                let load = Load { thrust, moment, vertical: &zero, weight };
                self.room(contact, joint, &load, 0)
            },
        )
    }

    /// Tells whether the room of no joint between two is negative: where a piece does not show it, its halves do. On a
    /// piece where the room bends upwards it is nowhere below a tangent, which is taken next to its least value.
    pub(crate) fn holds(&self, contact: Contact, [from, to]: [&Ball; 2], load: &Load) -> bool {
        let room = |joint: &Joint, order| self.room(contact, joint, load, order);
        let mut pieces = vec![from.hull(to)];
        while let Some(piece) = pieces.pop() {
            let Ball { mid, rad, .. } = &piece;
            let reach = piece.around(rad.clone());
            let centre = Joint::new(&piece.point());
            let bend = room(&centre.wider(rad), 2);
            let [middle, slope] = [0, 1].map(|order| room(&centre, order));
            if middle.is_negative() || *rad < 4 {
                return false;
            }
            let slopes = &slope + &(&bend * &reach);
            if (&middle + &(&slopes * &reach)).is_not_negative() {
                continue;
            }
            let end = if slopes.is_positive() { piece.low() } else { piece.high() };
            if slopes.is_positive() || slopes.is_negative() {
                if room(&Joint::new(&piece.at(end)), 0).is_not_negative() {
                    continue;
                }
                return false;
            }
            if bend.is_positive() {
                let least = Joint::new(&self.least(contact, &piece, load));
                let [value, slope] = [0, 1].map(|order| room(&least, order));
                let width = piece.around(Integer::from(rad << 1));
                if (&value + &(&slope * &width)).is_not_negative() {
                    continue;
                }
            }
            let half = Integer::from(rad + 1u32) >> 1;
            for middle in [Integer::from(mid - &half), Integer::from(mid + &half)] {
                pieces.push(piece.at(middle).wider(&half));
            }
        }
        true
    }

    /// A joint next to the least room of a piece, by Newton's steps: nothing is proved of it.
    pub(crate) fn least(&self, contact: Contact, piece: &Ball, load: &Load) -> Ball {
        let mut x = piece.point();
        for _ in 0..12 {
            let joint = Joint::new(&x);
            let [slope, bend] = [1, 2].map(|order| self.room(contact, &joint, load, order));
            if bend.mid <= 0 {
                break;
            }
            let step = Integer::from(&slope.mid << piece.bits) / &bend.mid;
            let next = Integer::from(&x.mid - &step).clamp(&piece.low(), &piece.high()).clone();
            let stays = Integer::from(&next - &x.mid).abs() <= 4;
            x = piece.at(next);
            if stays {
                break;
            }
        }
        x
    }
}
