//! The proof of a piece: for each parameter exactly one solution in a tube about a cubic.
//!
//! Let `X(s)` be Hermite's cubic through two nodes, `Z` a box about zero and `C` any matrix. If
//!
//! ```text
//! K = -C F(X(s), s) + (I - C F_x(X(s) + Z, s)) Z
//! ```
//!
//! lies in the interior of `Z` for all `s` of the piece, then for **each** of these `s` there is exactly one
//! root of `F(·, s)` in `X(s) + Z`, it lies in `X(s) + K`, and, as `F_x` is regular there, it is an analytic
//! function of `s` (Krawczyk's test about the centre `X(s)`, with the same `Z` for each). `F(X(s), s)` nearly
//! vanishes twice at both ends; Taylor's theorem to the fourth order about the middle of the piece, by
//! [jets](crate::number::Jet), sees that, so that the tube narrows like the fourth power of the length.
//!
//! **Two pieces join** where the root of their common node, enclosed and proved to be unique on its own, lies in
//! both tubes: there each tube holds one root only, so that the branches are one.

use super::cubic::{BITS, Cubic, exact};
use super::form::CurveForm;
use super::search::{CurvePoint, preconditioner};
use crate::check::krawczyk;
use crate::number::{Ball, Dual, Enclosure, Field, Jet, Magnitude};
use rug::Float;

/// A node of a curve: an exact parameter, and the root there.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub sketch: CurvePoint,
    /// The root, proved to be the only one in a box that holds this.
    pub root: Vec<Ball>,
}

/// A piece of a curve between two nodes.
#[derive(Clone, Debug)]
pub(super) struct Tube {
    middle: Ball,
    cubics: Vec<Cubic>,
    /// Half-widths in which the root is unique.
    unique: Vec<Magnitude>,
    /// Half-widths in which it lies.
    pub widths: Vec<Magnitude>,
    /// The slopes of the unknowns to the parameter, over the whole piece.
    pub slopes: Vec<Ball>,
}

/// Below this half-width, in bits, no tube is looked for: doubles are rounded nodes.
const LEAST: i64 = -44;
/// Number of times that a tube that is not mapped into itself is widened.
const TRIALS: usize = 4;

/// The set symmetric about zero of a half-width.
fn about_zero(width: Magnitude) -> Ball {
    Ball::new(Float::new(32), width, BITS)
}

fn in_balls(matrix: &[Vec<f64>]) -> Vec<Vec<Ball>> {
    matrix.iter().map(|row| row.iter().map(|y| exact(*y)).collect()).collect()
}

/// `-C v`.
fn minus_product(matrix: &[Vec<Ball>], v: &[Ball]) -> Vec<Ball> {
    let row = |row: &Vec<Ball>| {
        let products = row.iter().zip(v).map(|(y, v)| y.clone() * v);
        -products.fold(Ball::integer(0, BITS), |sum, product| sum + product)
    };
    matrix.iter().map(row).collect()
}

/// The residuals over a set, with slopes to the unknowns and, last, to the parameter.
fn slopes(form: &CurveForm, s: &Ball, x: &[Ball]) -> Vec<Dual<Ball>> {
    let number = |given: &Ball| Dual::constant(given.with_precision(BITS));
    form.residuals(&number, &Dual::variable(s.clone(), x.len()), &Dual::variables(x))
}

/// Result of Krawczyk's test.
struct Contraction {
    /// `Z`.
    domain: Vec<Ball>,
    /// `K`.
    image: Vec<Ball>,
    /// The residuals on `X + Z`, with their slopes.
    slopes: Vec<Dual<Ball>>,
}

/// Rounds by which the slopes of the root are narrowed.
const ROUNDS: usize = 12;

/// `Z` such that `start + (I - C F_x) Z` lies in its interior.
fn contracted(
    form: &CurveForm,
    s: &Ball,
    centre: &[Ball],
    (matrix, start): (&[Vec<Ball>], &[Ball]),
) -> Option<Contraction> {
    let wider = |k: &Ball| about_zero(k.size().shifted(1).plus(Magnitude::power_of_two(LEAST)));
    let mut domain: Vec<Ball> = start.iter().map(wider).collect();
    for _ in 0..TRIALS {
        let x: Vec<Ball> = centre.iter().zip(&domain).map(|(x, z)| x.clone() + z).collect();
        let slopes = slopes(form, s, &x);
        let spread = krawczyk::spread(&slopes, matrix, &domain);
        let image: Vec<Ball> = start.iter().zip(spread).map(|(k, z)| k.clone() + z).collect();
        if !image.iter().all(Enclosure::is_bounded) {
            return None;
        }
        if krawczyk::is_contracted(&image, &domain) {
            return Some(Contraction { domain, image, slopes });
        }
        domain = image.iter().map(wider).collect();
    }
    None
}

impl Node {
    /// Proves that there is exactly one root next to a point in doubles, at its exact parameter.
    pub(super) fn prove(form: &CurveForm, sketch: CurvePoint) -> Option<Self> {
        let s = exact(sketch.s);
        let centre: Vec<Ball> = sketch.x.iter().map(|x| exact(*x)).collect();
        let matrix = in_balls(&preconditioner(form, sketch.s, &sketch.x)?);
        let number = |given: &Ball| given.with_precision(BITS);
        let start = minus_product(&matrix, &form.residuals(&number, &s, &centre));
        let Contraction { image, .. } = contracted(form, &s, &centre, (&matrix, &start))?;
        let root = centre.into_iter().zip(image).map(|(x, k)| x + k).collect();
        Some(Self { sketch, root })
    }
}

impl Tube {
    /// Proves the piece between two nodes.
    pub(super) fn prove(form: &CurveForm, from: &Node, to: &Node) -> Option<Self> {
        let (a, b) = (&from.sketch, &to.sketch);
        let (s0, s1) = (exact(a.s), exact(b.s));
        let r = (s1.clone() - &s0) / s0.int(2);
        let middle = (s0.clone() + &s1) / s0.int(2);
        let t = about_zero(r.size());
        let s = middle.clone() + &t;
        let cubics: Vec<Cubic> = (0..a.x.len())
            .map(|i| Cubic::new([a.x[i], b.x[i]], [a.slopes[i], b.slopes[i]], &r))
            .collect();
        let number = |order| move |given: &Ball| Jet::constant(given.with_precision(BITS), order);
        let one = s.int(1);
        // About the middle, up to the third order; the fourth over the whole piece.
        let jets = |x: &dyn Fn(&Cubic) -> Vec<Ball>, order| -> Vec<Jet<Ball>> {
            cubics.iter().map(|cubic| Jet::new(x(cubic), order)).collect()
        };
        let line = |base: &Ball, order| Jet::new(vec![base.clone(), one.clone()], order);
        let at_middle =
            form.residuals(&number(3), &line(&middle, 3), &jets(&Cubic::about_middle, 3));
        let on_piece = form.residuals(&number(4), &line(&s, 4), &jets(&|c| c.about(&t), 4));
        let defect: Vec<Ball> = at_middle
            .iter()
            .zip(&on_piece)
            .map(|(middle, piece)| {
                let rest = piece.coefficient(4) * &t;
                (0..4).rev().fold(rest, |sum, k| {
                    let sum = sum + middle.coefficient(k);
                    if k == 0 { sum } else { sum * &t }
                })
            })
            .collect();
        let in_middle: Vec<f64> =
            cubics.iter().map(|cubic| cubic.about_middle()[0].mid().to_f64()).collect();
        let matrix = in_balls(&preconditioner(form, middle.mid().to_f64(), &in_middle)?);
        let start = minus_product(&matrix, &defect);
        let centre: Vec<Ball> = cubics.iter().map(|cubic| cubic.about(&t).swap_remove(0)).collect();
        let Contraction { domain, image, slopes } =
            contracted(form, &s, &centre, (&matrix, &start))?;
        let x: Vec<Ball> = centre.iter().zip(&image).map(|(x, k)| x.clone() + k).collect();
        let number = |given: &Ball| given.with_precision(BITS);
        if !form.divisors(&number, &s, &x).iter().all(Enclosure::excludes_zero) {
            return None;
        }
        let slopes = slopes_of_root(&slopes, &matrix, &domain)?;
        let widths = image.iter().map(Ball::size).collect();
        let unique = domain.iter().map(Ball::rad).collect();
        let tube = Self { middle, cubics, unique, widths, slopes };
        let joins = |node: &Node| tube.holds(&exact(node.sketch.s), &node.root);
        (joins(from) && joins(to)).then_some(tube)
    }

    /// The unknowns at a parameter of the piece, or at each of a set.
    pub(super) fn enclosure(&self, s: &Ball) -> Vec<Ball> {
        let t = s.clone() - &self.middle;
        let sides = self.cubics.iter().zip(&self.widths);
        sides.map(|(cubic, width)| cubic.about(&t).swap_remove(0).widened(*width)).collect()
    }

    /// The coefficients of the cubics about a parameter of the piece, or about each of a set.
    pub(super) fn about(&self, s: &Ball) -> Vec<Vec<Ball>> {
        let t = s.clone() - &self.middle;
        self.cubics.iter().map(|cubic| cubic.about(&t)).collect()
    }

    /// Tells whether a root at a parameter of the piece lies where only one is, and so is that of the curve.
    pub(super) fn holds(&self, s: &Ball, root: &[Ball]) -> bool {
        let t = s.clone() - &self.middle;
        let sides = self.cubics.iter().zip(&self.unique).zip(root);
        root.len() == self.cubics.len()
            && sides.into_iter().all(|((cubic, unique), root)| {
                let offset = root.clone() - &cubic.about(&t)[0];
                offset.size() < *unique
            })
    }
}

/// The slopes of the root to the parameter, `x' = -C F_s + (I - C F_x) x'`.
///
/// In the norm of the box `Z`, in which `I - C F_x` is a contraction by some `q < 1`, `|x'| <= |C F_s|/(1 - q)`.
fn slopes_of_root(
    slopes: &[Dual<Ball>],
    matrix: &[Vec<Ball>],
    domain: &[Ball],
) -> Option<Vec<Ball>> {
    let n = slopes.len();
    let by_parameter: Vec<Ball> = slopes.iter().map(|r| r.derivative(n)).collect();
    let first = minus_product(matrix, &by_parameter);
    let norm = |v: &[Ball]| v.iter().zip(domain).map(|(v, z)| v.size().over(z.rad())).max();
    let q = norm(&krawczyk::spread(slopes, matrix, domain))?;
    let room = Magnitude::from_integer_down(1).minus_down(q);
    if room.is_zero() {
        return None;
    }
    let bound = norm(&first)?.over(room);
    let mut all: Vec<Ball> = domain.iter().map(|z| about_zero(z.rad().times(bound))).collect();
    // The bound is one for all unknowns; each round is by the factor of the contraction nearer to the slope of each.
    for _ in 0..ROUNDS {
        let rest = krawczyk::spread(slopes, matrix, &all);
        all = first.iter().zip(rest).map(|(a, b)| a.clone() + b).collect();
    }
    Some(all)
}

#[cfg(test)]
mod tests {
    use super::super::curve::Curve;
    use super::super::search::point;
    use super::*;
    use crate::arch::SelfWeight;
    use crate::problem::Line;

    /// The curve `[r,r,s]/[s,s]` between two parameters near its beginning.
    fn piece(length: f64) -> (CurveForm, CurvePoint, CurvePoint) {
        let curve = Curve::Line(Line::AboveHaunchEnd);
        let form = curve.legs(SelfWeight::Heyman).swap_remove(0).form;
        let at = |s: f64, start: &[f64]| point(&form, s, start.to_vec()).unwrap();
        let from = at(1.27, &[2.47, 0.98, 1.0, 0.7]);
        let to = at(1.27 + length, &from.x);
        (form, from, to)
    }

    fn proved(form: &CurveForm, from: &CurvePoint, to: &CurvePoint) -> Option<Tube> {
        let [from, to] = [from, to].map(|sketch| Node::prove(form, sketch.clone()));
        Tube::prove(form, &from?, &to?)
    }

    #[test]
    fn the_tube_holds_the_root_at_each_parameter_and_narrows_like_the_fourth_power() {
        let width = |length: f64| {
            let (form, from, to) = piece(length);
            let tube = proved(&form, &from, &to).unwrap();
            for part in [0.0, 0.21, 0.5, 0.77, 1.0] {
                let s = from.s + part * length;
                let node = Node::prove(&form, point(&form, s, from.x.clone()).unwrap()).unwrap();
                assert!(tube.holds(&exact(s), &node.root), "{length} {part}");
                let inside = tube.enclosure(&exact(s));
                assert!(node.root.iter().zip(&inside).all(|(root, tube)| root.lies_inside(tube)));
            }
            tube.widths[0].to_float().to_f64()
        };
        let (long, short) = (width(0.02), width(0.01));
        assert!(long > 10.0 * short && long < 40.0 * short, "{long} {short}");
    }

    /// A line moved by a millionth is refused.
    #[test]
    fn a_curve_that_is_elsewhere_is_refused() {
        let (form, from, to) = piece(0.001);
        let tube = proved(&form, &from, &to).unwrap();
        let s = exact(from.s);
        let root = Node::prove(&form, from.clone()).unwrap().root;
        assert!(tube.holds(&s, &root));
        for index in 0..root.len() {
            let mut moved = root.clone();
            moved[index] = moved[index].clone() + exact(1e-6);
            assert!(!tube.holds(&s, &moved), "unknown {index}");
            // Nor is a node that is not on the curve.
            let mut sketch = from.clone();
            sketch.x[index] += 1e-6;
            let node = Node::prove(&form, sketch).unwrap();
            assert!(!node.root[index].lies_inside(&moved[index]), "the root stays where it is");
        }
        assert!(tube.holds(&s, &root[1..]).eq(&false), "nor one of too few unknowns");
    }

    #[test]
    fn a_piece_that_is_too_long_is_not_proved() {
        let rotation = Curve::Rotation.legs(SelfWeight::Heyman).swap_remove(0).form;
        let [flat, wide] = [(0.0, [0.0, 0.0]), (2.0, [1.3, 0.2])]
            .map(|(s, x)| point(&rotation, s, x.to_vec()).unwrap());
        assert!(proved(&rotation, &flat, &wide).is_none());
        // Nor one whose cubic goes astray.
        let (form, from, mut to) = piece(0.01);
        to.slopes[0] += 1000.0;
        assert!(proved(&form, &from, &to).is_none());
    }

    /// The slopes over a piece hold those at its ends, and not others.
    #[test]
    fn slopes_are_those_of_the_curve() {
        let (form, from, to) = piece(0.01);
        let tube = proved(&form, &from, &to).unwrap();
        for (index, slope) in tube.slopes.iter().enumerate() {
            for node in [&from, &to] {
                let found = node.slopes[index];
                assert!(exact(found).overlaps(slope), "{index}");
                let elsewhere = found + 4.0 * slope.rad().to_float().to_f64();
                assert!(!exact(elsewhere).overlaps(slope), "{index}");
            }
        }
    }
}
