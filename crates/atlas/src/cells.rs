//! The mode of each arch in a rectangle of frictions and thicknesses, by signs.
//!
//! To a thickness belongs the rotational state with its thrust `h_R` and half opening `alpha_0`, to a friction the
//! thrust `h_s` at which an inner joint slides and the half opening `alpha_P` that just slides. Their order tells
//! the mode ([`ThicknessRow::mode`]; why is the claim `map-columns`):
//!
//! ```text
//! h_R > h_s:  [r,r,r] if the shoulder does not slide at alpha_0, else [s,r,r]
//! h_R < h_s:  [s,s] if U > 0 at the shoulder of alpha_P, else by (5) for h_s
//!             [r,s] without a haunch, [r,r,s] with beta_r > beta_s, [r,s,r] with beta_r < beta_s
//! ```
//!
//! Each comparison moves one way only with the friction and with the thickness. So a cell is in one domain
//! if the corner of the least friction and the largest thickness is, and the corner opposite to it. Balls of doubles
//! are asked first, and balls of MPFR for what those leave open.

use crate::arch::haunch::Haunch;
use crate::arch::{Ring, SelfWeight, cycloid, thrust};
use crate::number::{Angle, Ball, DoubleBall, Dyadic, Field, Real, Ternary};
use crate::problem::Mode;
use crate::prover::arithmetic::Arithmetic;
use std::collections::HashMap;

/// Row of cells: all that belongs to a thickness alone.
#[derive(Clone, Debug)]
struct ThicknessRow<E> {
    ring: Ring<E>,
    /// The thrust and the half opening of the rotational state; none from the end of rotation on.
    rotation: Option<(E, E)>,
}

/// Column of cells: all that belongs to a friction alone.
#[derive(Clone, Debug)]
struct FrictionColumn<E> {
    inclination: Angle<E>,
    /// `h_s`, and the half opening that just slides.
    thrust: E,
    half_opening: Angle<E>,
}

/// Bits of the balls of MPFR, and the most steps of a bisection.
const BITS: u32 = 96;

fn exact<E: Arithmetic>(x: f64) -> E {
    E::exact(&Dyadic::from(x), BITS as usize)
}

/// Zero of a function that falls between two exact numbers, between which it has one.
fn falling<E: Arithmetic>(low: E, high: E, f: impl Fn(&E) -> E) -> E {
    let (mut low, mut high) = (low, high);
    for _ in 0..BITS {
        let middle = ((low.clone() + &high) / low.int(2)).midpoint();
        let value = f(&middle);
        match value.is_positive() {
            Ternary::True => low = middle,
            Ternary::False => high = middle,
            Ternary::Undecided => break,
        }
    }
    low.hull_with(&high)
}

/// More than the widest rotational joint, and more than the widest half opening.
const JOINTS: f64 = 1.5;
const OPENINGS: f64 = 3.0;
/// A little more than a right angle.
const RIGHT_ANGLE: f64 = 1.571;

impl<E: Arithmetic> ThicknessRow<E> {
    /// A thickness from 0 to 2; at 0 the limit of thin arches.
    fn new(weight: SelfWeight, thickness: f64) -> Option<Self> {
        let eta: E = exact(thickness);
        let ring = Ring::new(weight, &eta);
        let (zero, one) = (eta.int(0), eta.int(1));
        if thickness == 0.0 {
            return Some(Self { ring, rotation: Some((one, zero)) });
        }
        // 2 - 2 fac/(2 - eta), positive before the end of rotation, times (2 - eta)/2.
        let is_before = (ring.intrados() - &ring.centroid_factor).is_positive();
        if is_before == Ternary::False {
            return Some(Self { ring, rotation: None });
        }
        let touching = |beta: &E| {
            let haunch = Haunch::from(&Angle::new(beta.clone()));
            thrust::touching(&haunch.versine, &haunch.excess, &ring)
        };
        let excess = |beta: &E| {
            let cotangent = Angle::new(beta.clone()).times_cotangent();
            thrust::tangency(&cotangent, &ring).value() - touching(beta).value()
        };
        let end = exact(JOINTS);
        if is_before != Ternary::True || excess(&end).is_positive() != Ternary::False {
            return None;
        }
        let h = touching(&falling(zero.clone(), end, excess)).value();
        let moment = |alpha: &E| thrust::whole(&Angle::new(alpha.clone()), &ring).value() - &h;
        if moment(&exact(OPENINGS)).is_positive() != Ternary::False {
            return None;
        }
        let alpha = falling(zero, exact(OPENINGS), moment);
        Some(Self { rotation: Some((h, alpha)), ring })
    }

    /// The mode at a friction; `None` if a sign is not decided.
    fn mode(&self, column: &FrictionColumn<E>) -> Option<Mode> {
        let FrictionColumn { inclination, thrust: h, half_opening } = column;
        if let Some((rotational, alpha)) = &self.rotation {
            let difference = rotational.clone() - h;
            let is_hinged = difference.is_positive();
            if is_hinged == Ternary::True {
                let phi = cycloid::friction_angle(inclination);
                let force = Angle::new(alpha.clone() - phi);
                let slides = cycloid::shoulder(alpha, &force, rotational).is_positive();
                return by(slides, Mode::SlidingRotational, Mode::Rotational);
            }
            if is_hinged == Ternary::Undecided {
                return None;
            }
        }
        let ring = &self.ring;
        // As (5) has it, times 2 - eta: without a haunch where it is negative.
        let two = h.int(2);
        let excess = ring.intrados() * (two.clone() - h) - two * &ring.centroid_factor;
        let joint = match excess.is_positive() {
            Ternary::True => {
                let tangent = |beta: &E| {
                    let cotangent = Angle::new(beta.clone()).times_cotangent();
                    thrust::tangency(&cotangent, ring).value() - h
                };
                let end = exact(JOINTS);
                if tangent(&end).is_positive() != Ternary::False {
                    return None;
                }
                Some(Angle::new(falling(h.int(0), end, tangent)))
            }
            Ternary::False => None,
            Ternary::Undecided => return None,
        };
        let crown = || Angle::zero(h);
        let shoulder = thrust::upper(half_opening, &joint.clone().unwrap_or_else(crown), ring);
        // U at the shoulder, up to the factor -2.
        match shoulder.residual(h).is_positive() {
            Ternary::True => {}
            Ternary::False => return Some(Mode::Sliding),
            Ternary::Undecided => return None,
        }
        let Some(joint) = joint else { return Some(Mode::OverturningSliding) };
        // A haunch beyond the shoulder would say nothing of it.
        if (half_opening.rad.clone() - &joint.rad).is_positive() != Ternary::True {
            return None;
        }
        let is_below = (joint.rad - cycloid::joint(inclination)).is_positive();
        by(is_below, Mode::RotationalSliding, Mode::RotationalSlidingRotational)
    }
}

fn by(truth: Ternary, yes: Mode, no: Mode) -> Option<Mode> {
    match truth {
        Ternary::True => Some(yes),
        Ternary::False => Some(no),
        Ternary::Undecided => None,
    }
}

impl<E: Arithmetic> FrictionColumn<E> {
    /// The friction at which the force on an inner joint that slides has an inclination, from 0 to a right angle.
    fn new(inclination: E) -> Self {
        let inclination = Angle::new(inclination);
        let (h, phi) = (cycloid::thrust(&inclination), cycloid::friction_angle(&inclination));
        let outwards = |force: &E| {
            let force = Angle::new(force.clone());
            -cycloid::shoulder(&(phi.clone() + &force.rad), &force, &h)
        };
        // From a right angle on, where it is -h, it is not positive.
        let force = falling(h.int(0), exact(RIGHT_ANGLE), outwards);
        let half_opening = Angle::new(phi + force);
        Self { inclination, thrust: h, half_opening }
    }
}

/// Areas of the map that are proved to be in each domain.
#[derive(Clone, Debug)]
pub struct Areas {
    /// The modes whose domains have an area, each with the part of the map that is proved to be in its domain, and
    /// the part that may be.
    pub domains: Vec<(Mode, [Ball; 2])>,
    /// The part that is proved to be in one domain or another.
    pub proved: Ball,
    /// Number of cells of that area.
    pub cells: usize,
    /// Number of other cells that have a corner at which a comparison is not decided.
    pub open: usize,
}

/// The modes whose domains have an area, in the order in which a thickness passes them at one friction.
const UPWARDS: &[Mode] = Mode::COLUMNS[0];

/// The corners of the cells of a map, in some numbers: rows and columns as they are asked for.
struct Corners<E> {
    rows: HashMap<u32, Option<ThicknessRow<E>>>,
    columns: HashMap<u32, FrictionColumn<E>>,
}

/// The inclination at a column.
fn inclination<E: Arithmetic>(across: u32, parts: u32) -> E {
    let like: E = exact(f64::from(across));
    like.pi() * &like / exact::<E>(2.0 * f64::from(parts))
}

impl<E: Arithmetic> Corners<E> {
    fn new() -> Self {
        Self { rows: HashMap::new(), columns: HashMap::new() }
    }

    /// The mode at a corner of a map of so many parts.
    fn mode(&mut self, weight: SelfWeight, parts: u32, (across, up): (u32, u32)) -> Option<Mode> {
        let thickness = 2.0 * f64::from(up) / f64::from(parts);
        let row = self.rows.entry(up).or_insert_with(|| ThicknessRow::new(weight, thickness));
        let column = || FrictionColumn::new(inclination(across, parts));
        row.as_ref()?.mode(self.columns.entry(across).or_insert_with(column))
    }
}

/// The cells of a map, as fine as asked.
struct CellGrid {
    weight: SelfWeight,
    parts: u32,
    quick: Corners<DoubleBall>,
    corners: Corners<Ball>,
    modes: HashMap<(u32, u32), Option<usize>>,
    friction_angles: HashMap<u32, Ball>,
    /// Proved, and perhaps, in the unit of the map.
    areas: Vec<[Ball; 2]>,
    cells: usize,
    open: usize,
}

impl CellGrid {
    /// The place of the mode at a corner among those of [`UPWARDS`].
    fn mode(&mut self, across: u32, up: u32) -> Option<usize> {
        if let Some(known) = self.modes.get(&(across, up)) {
            return *known;
        }
        let (weight, parts, at) = (self.weight, self.parts, (across, up));
        let quick = self.quick.mode(weight, parts, at);
        let mode = quick.or_else(|| self.corners.mode(weight, parts, at));
        let mode = mode.and_then(|mode| UPWARDS.iter().position(|of| *of == mode));
        self.modes.insert(at, mode);
        mode
    }

    /// The part of the map that a cell is.
    fn area(&mut self, across: u32, size: u32) -> Ball {
        let parts = self.parts;
        let angle = |k| cycloid::friction_angle(&Angle::new(inclination(k, parts)));
        let [low, high] = [across, across + size]
            .map(|k| self.friction_angles.entry(k).or_insert_with(|| angle(k)).clone());
        let wide = high - low;
        let high = exact::<Ball>(f64::from(size) / f64::from(parts));
        let right = wide.pi() / wide.int(2);
        wide * high / right
    }

    /// Proves a cell, or its quarters.
    fn prove(&mut self, (across, up): (u32, u32), size: u32) {
        let corners = [self.mode(across, up + size), self.mode(across + size, up)];
        let is_one = corners[0].is_some() && corners[0] == corners[1];
        if !is_one && size > 1 {
            let half = size / 2;
            for (right, high) in [(0, 0), (half, 0), (0, half), (half, half)] {
                self.prove((across + right, up + high), half);
            }
            return;
        }
        let area = self.area(across, size);
        // Between the two corners, if they are decided.
        let [high, low] = [corners[0].unwrap_or(self.areas.len()), corners[1].unwrap_or(0)];
        for (index, [proved, perhaps]) in self.areas.iter_mut().enumerate() {
            if (low..=high).contains(&index) {
                *perhaps = perhaps.clone() + &area;
                if is_one {
                    *proved = proved.clone() + &area;
                }
            }
        }
        self.cells += usize::from(is_one);
        self.open += usize::from(corners.contains(&None));
    }
}

impl Areas {
    /// The map of a weight in cells; those that are not in one domain are quartered until the map is this many times
    /// as wide, a power of two.
    pub fn new(weight: SelfWeight, parts: u32) -> Self {
        let zero: Ball = exact(0.0);
        let none = || [zero.clone(), zero.clone()];
        let areas = UPWARDS.iter().map(|_| none()).collect();
        let mut grid = CellGrid {
            weight,
            parts,
            quick: Corners::new(),
            corners: Corners::new(),
            modes: HashMap::new(),
            friction_angles: HashMap::new(),
            areas,
            cells: 0,
            open: 0,
        };
        grid.prove((0, 0), parts);
        let proved = grid.areas.iter().fold(zero, |sum, [proved, _]| sum + proved);
        let domains = UPWARDS.iter().copied().zip(grid.areas).collect();
        Self { domains, proved, cells: grid.cells, open: grid.open }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Curve, Trace};
    use super::*;
    use crate::problem::Line;

    /// An inclination whose friction angle is next to this.
    fn inclination(phi: f64) -> f64 {
        let (mut low, mut high) = (0.0, std::f64::consts::FRAC_PI_2);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            let [low_, high_] = match cycloid::friction_angle(&Angle::new(middle)) < phi {
                true => [middle, high],
                false => [low, middle],
            };
            (low, high) = (low_, high_);
        }
        low
    }

    fn mode_in<E: Arithmetic>(weight: SelfWeight, phi: f64, eta: f64) -> Option<Mode> {
        ThicknessRow::<E>::new(weight, eta)?.mode(&FrictionColumn::new(exact(inclination(phi))))
    }

    /// The mode, which is the same in other numbers, where these decide it.
    fn mode(weight: SelfWeight, phi: f64, eta: f64) -> Option<Mode> {
        let mode = mode_in::<Ball>(weight, phi, eta);
        let quick = mode_in::<DoubleBall>(weight, phi, eta);
        assert!(quick.is_none() || quick == mode, "{weight:?} {phi} {eta}");
        mode
    }

    /// Tells whether the modes of a line are above and below a thickness, a small step away.
    fn divides(line: Line, weight: SelfWeight, (phi, eta): (f64, f64)) -> bool {
        const AWAY: f64 = 5e-7;
        let sides = [eta - AWAY, eta + AWAY].map(|eta| mode(weight, phi, eta));
        let modes = line.modes();
        modes.map(Some) == sides
    }

    /// A line moved by a millionth is refused.
    #[test]
    fn the_modes_are_on_their_sides_of_the_lines() {
        let mut tried = 0;
        for (line, weight) in Line::ALL.iter().flat_map(|line| SelfWeight::ALL.map(|w| (*line, w)))
        {
            let trace = Trace::new(Curve::Line(line), weight, 1e-8).unwrap();
            let step = trace.pieces().count() / 6 + 1;
            for piece in trace.pieces().step_by(step) {
                let [from, to] = piece.range();
                let place = piece.place(from + 0.4 * (to - from)).unwrap();
                let value = |of: &Option<Ball>| of.as_ref().unwrap().mid().to_f64();
                let (phi, eta) = (value(&place.friction_angle), value(&place.thickness));
                // At the origin the domains are thinner than a millionth.
                if eta < 1e-3 {
                    continue;
                }
                assert!(divides(line, weight, (phi, eta)), "{line} {weight:?} {phi} {eta}");
                for moved in [-1e-6, 1e-6] {
                    assert!(!divides(line, weight, (phi, eta + moved)), "{line} {weight:?} {phi}");
                }
                tried += 1;
            }
        }
        assert!(tried > 50, "{tried}");
    }

    #[test]
    fn on_a_line_no_mode_is_guessed() {
        // At eta = 2 and beyond B, and where h_R = h_s = 0.
        let end = ThicknessRow::<Ball>::new(SelfWeight::Heyman, 1.0).unwrap();
        assert!(end.rotation.is_none());
        let column = FrictionColumn::new(exact(1.5));
        assert_eq!(end.mode(&column), Some(Mode::OverturningSliding));
        // The origin.
        let origin = ThicknessRow::<Ball>::new(SelfWeight::Heyman, 0.0).unwrap();
        assert_eq!(origin.mode(&FrictionColumn::new(exact(0.0))), None);
    }

    #[test]
    fn edges_are_in_the_domains_beside_them() {
        let like: Ball = exact(1.0);
        let right = FrictionColumn::new(like.pi() / like.int(2));
        for weight in SelfWeight::ALL {
            for (eta, edge, mode) in [
                (0.0, &FrictionColumn::new(exact(1.0)), Mode::Rotational),
                (0.5, &right, Mode::Rotational),
                (1.5, &right, Mode::OverturningSliding),
                (2.0, &FrictionColumn::new(exact(1.5)), Mode::OverturningSliding),
                (2.0, &FrictionColumn::new(exact(1.0)), Mode::Sliding),
                (0.5, &FrictionColumn::new(exact(0.0)), Mode::Sliding),
            ] {
                assert_eq!(ThicknessRow::new(weight, eta).unwrap().mode(edge), Some(mode), "{eta}");
            }
        }
    }

    /// Finer cells leave less open; what is proved and what may be enclose the domains.
    #[test]
    fn finer_cells_prove_more() {
        let [coarse, fine] = [16, 64].map(|parts| Areas::new(SelfWeight::Milankovitch, parts));
        let [some, more] = [&coarse, &fine].map(|areas| areas.proved.mid().to_f64());
        assert!(0.6 < some && some + 0.05 < more && more < 1.0, "{some} {more}");
        for ((mode, one), (_, other)) in coarse.domains.iter().zip(&fine.domains) {
            let [one, other] =
                [one, other].map(|area| area.clone().map(|part| part.mid().to_f64()));
            assert!(one[0] <= other[0] && other[0] <= other[1] && other[1] <= one[1], "{mode}");
        }
    }
}
