//! The conditions of an arch of equal stones as polynomials in its thickness.

use super::polynomial::ShortPolynomial;
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::number::{Ball, Field, Jet};
use crate::problem::{Arch, Extent, JointLimit, Joints};
use crate::prover::arithmetic::Arithmetic;

/// The conditions of an arch.
pub(super) struct Conditions<T> {
    /// The conditions of each joint, in the order of [`Contact::ALL`], from the left.
    pub all: Vec<JointLimit<ShortPolynomial<T>>>,
    /// Number of conditions at each joint: with unlimited friction the hinges, as both ask for a normal force.
    at_joint: usize,
    /// Loads of the force that works on each motion, free of the forces: of a hinge that of the row, of a slip
    /// that of `T` or `-T`.
    pub weights: Vec<ShortPolynomial<T>>,
    pub extent: Extent,
    /// Conditions `-N` at each joint: both hinges together are `eta` times this.
    compressions: Vec<[ShortPolynomial<T>; 4]>,
    /// Condition that a state of the half arch satisfies beside them: no vertical force.
    no_vertical_force: [ShortPolynomial<T>; 4],
    /// The radius of the intrados, `1 - eta/2`.
    intrados: ShortPolynomial<T>,
}

/// Bits of conditions that are only named.
const FEW: u32 = 64;
/// The order of jets in the thickness: that of the load.
const ORDER: usize = 2;

/// Number of conditions at each joint of an arch: the first of [`Contact::ALL`].
pub(crate) fn limits_at_joint(arch: &Arch) -> usize {
    if arch.is_limited() { Contact::ALL.len() } else { 2 }
}

/// Coefficients of `h, p` and `v`. With `v` it is linear in the thickness: the centroids, of second order, drop out
/// exactly.
fn entries<T: Field>([h, p, v]: &[Jet<T>; 3]) -> [ShortPolynomial<T>; 3] {
    let linear = Jet::new(v.coefficients().iter().take(2).cloned().collect(), ORDER);
    [h, p, &linear].map(ShortPolynomial::of)
}

impl<T: Arithmetic> Conditions<T> {
    /// The conditions in numbers of `bits` bits.
    pub(super) fn new(arch: &Arch, stones: i32, extent: Extent, bits: u32) -> Self {
        Self::of(arch, stones, extent, bits, |_| true)
    }

    /// The conditions in numbers of `bits` bits at some joints, and of few at the others.
    pub(super) fn of(
        arch: &Arch,
        stones: i32,
        extent: Extent,
        bits: u32,
        is_asked: impl Fn(i32) -> bool,
    ) -> Self {
        let in_bits = |bits: u32| {
            let alpha: T = arch.half_opening().enclosure(bits);
            let grip: Grip<Ball> = arch.friction().grip(bits);
            let grip = grip.map(|x| T::from_ball(&x, bits));
            (alpha, Joints::in_thickness(arch.weight(), grip, ORDER))
        };
        let at_joint = limits_at_joint(arch);
        let all_bits = in_bits(bits);
        let few_bits = in_bits(bits.min(FEW));
        let (mut all, mut weights, mut compressions) = (Vec::new(), Vec::new(), Vec::new());
        for k in extent.joints(stones) {
            let (alpha, joints) = if is_asked(k) { &all_bits } else { &few_bits };
            let one = joints.ring.thickness.int(1);
            let grip = Grip { normal: one.int(0), shear: one };
            let without_friction = Joints { grip, ring: joints.ring.clone() };
            let angle = Extent::angle(k, stones, alpha).map(|x| Jet::constant(x, ORDER));
            for limit in joints.limits((k, &angle), extent).into_iter().take(at_joint) {
                let [h, p, v, load] = limit.row;
                let [h, p, v] = entries(&[h, p, v]);
                let row = [h, p, v, ShortPolynomial::of(&load)];
                let JointLimit { contact, joint, .. } = limit;
                all.push(JointLimit { contact, joint, row, motion: entries(&limit.motion) });
                weights.push(ShortPolynomial::of(&without_friction.row(contact, &angle).load));
            }
            let [h, p, v] = extent.seen([-angle.cos.clone(), angle.cos.int(0), angle.sin.clone()]);
            let load = -(angle.rad * &angle.sin);
            compressions.push([&h, &p, &v, &load].map(ShortPolynomial::of));
        }
        let (alpha, _) = all_bits;
        let entry = |n: i32| ShortPolynomial::constant(alpha.int(n));
        let intrados = Jet::new(vec![alpha.int(1), -alpha.ratio(1, 2)], ORDER);
        let (no_vertical_force, intrados) =
            ([0, 0, 1, 0].map(entry), ShortPolynomial::of(&intrados));
        Self { all, at_joint, weights, extent, compressions, no_vertical_force, intrados }
    }

    /// The row of a condition beside others that are zero: where the opposite hinge of its joint is one of them,
    /// `-N`, which has its sign and is free of the factor `eta` that both hinges together have.
    fn row_beside(&self, place: usize, of: &[usize]) -> &[ShortPolynomial<T>; 4] {
        let opposite = match place % self.at_joint {
            0 => Some(place + 1),
            1 => Some(place - 1),
            _ => None,
        };
        match opposite.is_some_and(|opposite| of.contains(&opposite)) {
            true => &self.compressions[self.joint(place)],
            false => &self.all[place].row,
        }
    }

    /// The rows of conditions that are zero together, with `-N` for the second hinge of a joint.
    pub(super) fn rows_of(&self, of: &[usize]) -> Vec<&[ShortPolynomial<T>; 4]> {
        (0..of.len()).map(|k| self.row_beside(of[k], &of[..k])).collect()
    }

    /// The place of a condition.
    pub(super) fn place(&self, contact: Contact, joint: i32) -> Option<usize> {
        self.all.iter().position(|at| at.contact == contact && at.joint == joint)
    }

    /// Number of the joint of a condition, from the left.
    pub(super) fn joint(&self, place: usize) -> usize {
        place / self.at_joint
    }

    /// The conditions of the mirror image, in order; of a half arch the same.
    pub(super) fn mirrored(&self, of: &[usize]) -> Vec<usize> {
        let joints = self.all.len() / self.at_joint;
        let other = |place: usize| {
            let contact = match place % self.at_joint {
                2 => 3,
                3 => 2,
                hinge => hinge,
            };
            self.at_joint * (joints - 1 - self.joint(place)) + contact
        };
        let mut places = match self.extent {
            Extent::Whole => of.iter().map(|place| other(*place)).collect(),
            Extent::Half => of.to_vec(),
        };
        places.sort_unstable();
        places
    }

    /// Number of the equations of compatibility and one more, which is that of the rates.
    pub(super) fn rank(&self) -> usize {
        match self.extent {
            Extent::Whole => 3,
            Extent::Half => 2,
        }
    }

    /// The state at which three conditions are zero, or two of a half arch: `h, p, v` and one, times a common factor.
    ///
    /// Two mirror images are zero together where one is and `v` is zero. Of three hinges at the intrados the factor
    /// `1 - eta/2`, which all four have, is left out, and of the two hinges of a joint the factor `eta`.
    pub(super) fn meeting(&self, of: &[usize]) -> [ShortPolynomial<T>; 4] {
        self.meeting_by(of, &self.minors(of))
    }

    /// The minors of the rows of the first two conditions, which serve each third one.
    pub(super) fn minors(&self, of: &[usize]) -> Minors<T> {
        let rows = self.rows_of(&of[..2]);
        minors([rows[0], rows[1]])
    }

    /// The state of [`meeting`](Self::meeting), from these minors.
    pub(super) fn meeting_by(&self, of: &[usize], by: &Minors<T>) -> [ShortPolynomial<T>; 4] {
        let is_intrados = |place: &usize| self.all[*place].contact == Contact::Intrados;
        let without_vertical_force = |of: &[usize]| {
            let rows = self.rows_of(of);
            crossed(&minors([rows[0], rows[1]]), &self.no_vertical_force)
        };
        match (of, self.mirror_images(of)) {
            ([_, _], _) => without_vertical_force(of),
            (_, Some(two)) => without_vertical_force(&two),
            (_, None) if of.iter().all(is_intrados) => {
                let reduced = [0, 1, 2].map(|k| {
                    let [h, p, v, load] = &self.all[of[k]].row;
                    [h.first(), p.clone(), v.first(), load.clone()]
                });
                let [a, b, c] = &reduced;
                let [h, p, v, whole] = crossed(&minors([a, b]), c);
                let times =
                    |x: &ShortPolynomial<T>| ShortPolynomial::alternating(&[[&self.intrados, x]]);
                [h, times(&p), v, times(&whole)]
            }
            _ => crossed(by, self.row_beside(of[2], &of[..2])),
        }
    }

    /// Pair of mirror images among three conditions, as one of these and the third.
    fn mirror_images(&self, of: &[usize]) -> Option<[usize; 2]> {
        let [a, b, c] = *of else { return None };
        let are = |a: usize, b: usize| self.mirrored(&[a]) == [b];
        match (are(a, b), are(a, c), are(b, c)) {
            (true, ..) => Some([a, c]),
            (_, true, _) => Some([a, b]),
            (.., true) => Some([b, a]),
            _ => None,
        }
    }

    /// The left side of a condition at the state of [`meeting`](Self::meeting) of some, times the common factor;
    /// divided by `eta` where these have the opposite hinge.
    pub(super) fn value(
        &self,
        place: usize,
        of: &[usize],
        meeting: &[ShortPolynomial<T>; 4],
    ) -> ShortPolynomial<T> {
        let [h, p, v, load] = self.row_beside(place, of);
        let [a, b, c, d] = meeting;
        let minus = [b, d].map(|x| x.clone().negative());
        ShortPolynomial::alternating(&[[h, a], [p, &minus[0]], [v, c], [load, &minus[1]]])
    }

    /// Rates, up to a common factor, of one condition more than the equations of compatibility, with which the
    /// motion fits.
    pub(super) fn rates(&self, of: &[usize]) -> Vec<ShortPolynomial<T>> {
        let motion = |k: usize| &self.all[of[k]].motion[..];
        let rate = |k: usize| {
            let rest: Vec<usize> = (0..of.len()).filter(|i| *i != k).collect();
            let size = match rest[..] {
                [i, j] => ShortPolynomial::minor([motion(i), motion(j)], [0, 1]),
                _ => self.determinant(&[rest[0], rest[1], rest[2]].map(|i| of[i])),
            };
            if k.is_multiple_of(2) { size } else { size.negative() }
        };
        (0..of.len()).map(rate).collect()
    }

    /// The determinant of three motions: zero where they fit with each other.
    pub(super) fn determinant(&self, of: &[usize; 3]) -> ShortPolynomial<T> {
        let [a, b, c] = of.map(|k| &self.all[k].motion);
        let minor = |i, j| ShortPolynomial::minor([b, c], [i, j]);
        ShortPolynomial::alternating(&[
            [&a[0], &minor(1, 2)],
            [&a[1], &minor(0, 2)],
            [&a[2], &minor(0, 1)],
        ])
    }

    /// Rates of three motions that fit with each other, from two of their three equations.
    pub(super) fn rates_of_three(
        &self,
        of: &[usize; 3],
        by: [usize; 2],
    ) -> Vec<ShortPolynomial<T>> {
        let motion = |k: usize| &self.all[of[k]].motion[..];
        let cross = |i, j| ShortPolynomial::minor([motion(i), motion(j)], by);
        vec![cross(1, 2), cross(2, 0), cross(0, 1)]
    }
}

/// Minors of two rows, by the columns in order.
pub(super) type Minors<T> = [ShortPolynomial<T>; 6];

fn minors<T: Arithmetic>([a, b]: [&[ShortPolynomial<T>; 4]; 2]) -> Minors<T> {
    [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]].map(|ij| ShortPolynomial::minor([a, b], ij))
}

/// Four numbers at right angles to three rows, up to a common factor, from the minors of two.
fn crossed<T: Arithmetic>(
    [m01, m02, m03, m12, m13, m23]: &Minors<T>,
    c: &[ShortPolynomial<T>; 4],
) -> [ShortPolynomial<T>; 4] {
    let det = |ab: &ShortPolynomial<T>,
               ac: &ShortPolynomial<T>,
               bc: &ShortPolynomial<T>,
               at: [usize; 3]| {
        ShortPolynomial::alternating(&[[ab, &c[at[2]]], [ac, &c[at[1]]], [bc, &c[at[0]]]])
    };
    [
        det(m12, m13, m23, [1, 2, 3]),
        det(m02, m03, m23, [0, 2, 3]).negative(),
        det(m01, m03, m13, [0, 1, 3]),
        det(m01, m02, m12, [0, 1, 2]).negative(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Enclosure;

    /// Both hinges of a joint are `-eta N` together, so that beside the one the other is `eta` times `-N`.
    #[test]
    fn beside_one_hinge_the_other_is_the_normal_force() {
        let arch = Arch::parse("milankovitch", "2.3", "1.05").unwrap();
        for extent in [Extent::Whole, Extent::Half] {
            let conditions: Conditions<Ball> = Conditions::new(&arch, 5, extent, 100);
            let eta = Ball::integer(3, 100) / &Ball::integer(7, 100);
            for joint in 0..conditions.compressions.len() {
                let (outer, inner) = (4 * joint, 4 * joint + 1);
                let at = |of: &[ShortPolynomial<Ball>; 4]| of.each_ref().map(|x| x.at(&eta));
                let [a, b] = [outer, inner].map(|place| at(&conditions.all[place].row));
                let n = at(conditions.row_beside(inner, &[outer]));
                let same = |k: usize| (a[k].clone() + &b[k]).overlaps(&(n[k].clone() * &eta));
                assert!((0..4).all(same), "{extent:?} {joint}");
                let twin = |k: usize| (a[k].clone() - &b[k]).overlaps(&(n[k].clone() * &eta));
                assert!(!(0..4).all(twin), "false twin");
                assert!(std::ptr::eq(
                    conditions.row_beside(inner, &[inner, outer + 2]),
                    &conditions.all[inner].row
                ));
            }
        }
    }

    /// A hinge works with all of its condition, a slip with what is left of it without friction.
    #[test]
    fn the_weight_works_on_the_motion_as_the_condition_says() {
        let arch = Arch::parse("heyman", "2", "0.7").unwrap();
        let conditions: Conditions<Ball> = Conditions::new(&arch, 4, Extent::Whole, 100);
        let eta = Ball::integer(1, 100) / &Ball::integer(3, 100);
        let forces = [2, 3, 5].map(|n| Ball::integer(n, 100) / &Ball::integer(7, 100));
        let along = |of: [&ShortPolynomial<Ball>; 3], load: &ShortPolynomial<Ball>| {
            let terms = of.into_iter().zip(&forces);
            terms.fold(load.at(&eta), |sum, (entry, force)| sum + entry.at(&eta) * force)
        };
        for (place, condition) in conditions.all.iter().enumerate() {
            let [h, p, v, load] = &condition.row;
            let value = along([h, p, v], load);
            let power = along(condition.motion.each_ref(), &conditions.weights[place]);
            let [h, p, v, load] = &conditions.compressions[place / 4];
            let normal = -along([h, p, v], load);
            let friction = if condition.contact.is_hinge() { 0 } else { 7 };
            let taken = normal * Ball::integer(friction, 100) / &Ball::integer(10, 100);
            assert!((power - taken).overlaps(&value), "{place}");
        }
    }
}
