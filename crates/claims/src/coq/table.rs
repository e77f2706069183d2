//! The numbers with which `Contraction.v` proves one root of a system.
//!
//! Nothing here is trusted: Coq checks every number. Floats and balls only choose them, such that the
//! check succeeds with some room.

use super::names::{BITS, DECIMALS, symbol, symbols};
use super::numeral::{distance, down, exact, nearest, places, radius, unit, up};
use super::root::CoqRoot;
use super::term::Term;
use crate::arch::{Configuration, Unknown};
use crate::certify::Undecided;
use crate::number::{Angle, Ball, Dual, Magnitude};
use crate::problem::System;
use crate::solve::inverse;
use rug::{Float, Rational};

/// Decimals to print with: the more the equations lose, the more.
const LADDER: [TableDecimals; 5] = [
    TableDecimals { centre: 36, matrix: 7 },
    TableDecimals { centre: 40, matrix: 7 },
    TableDecimals { centre: 56, matrix: 14 },
    TableDecimals { centre: 72, matrix: 20 },
    TableDecimals { centre: 99, matrix: 30 },
];
/// The factor by which distances have to shrink.
const CONTRACTION: (u32, u32) = (9, 10);
/// The largest radius: the small box is that part of the wide one which shows the decimals where a radius is one.
const LARGEST: (u32, u32) = (99, 100);
/// Factor by which a bound is printed larger than the balls find it; Coq's intervals differ from them.
const ROOM: (u32, u32) = (21, 20);
/// The box is made smaller by a twentieth this often before it is given up.
const TRIALS: u32 = 100;

/// Numbers of decimals that are printed.
#[derive(Clone, Copy)]
struct TableDecimals {
    /// Decimals of a centre: the first Newton step has to stay far inside the small box.
    centre: u32,
    /// Decimals of the preconditioner and of the slopes at the centre.
    matrix: u32,
}

/// A system as terms, cleared of denominators, with its derivatives.
pub(super) struct ClearedSystem {
    /// One term for each equation.
    pub residuals: Vec<Term>,
    /// Derivatives of the equations to the unknowns.
    pub jacobian: Vec<Vec<Term>>,
}

impl ClearedSystem {
    /// The equations of the system, in its own order, in variables named by their symbols; so is what is given.
    pub(super) fn new(system: &System) -> Self {
        let symbols = symbols(system);
        let variables: Vec<Term> = symbols.iter().copied().map(Term::variable).collect();
        let given = Configuration {
            half_opening: Term::angle(symbol(Unknown::HalfOpening)),
            friction: Term::variable(symbol(Unknown::Friction)),
            ..Configuration::zero(&Term::constant(0))
        };
        let at = system.place_with(given, &variables, |k, _| Term::angle(symbols[k]));
        let residuals: Vec<Term> =
            system.residuals(&at).iter().map(|term| term.fraction().0).collect();
        let slopes = |term: &Term| gradient(term, &symbols);
        let jacobian = residuals.iter().map(slopes).collect();
        Self { residuals, jacobian }
    }
}

/// The derivatives of a term to some of its variables.
fn gradient(term: &Term, symbols: &[&str]) -> Vec<Term> {
    let like = Dual::constant(Term::constant(0));
    let slope = term.evaluate(&like, &|name| match symbols.iter().position(|x| *x == name) {
        Some(k) => Term::angle(name).variable(k),
        None => Term::angle(name).map(Dual::constant),
    });
    (0..symbols.len()).map(|k| slope.derivative(k)).collect()
}

/// The derivative of a term in one variable.
pub(super) fn derivative(term: &Term, variable: &'static str) -> Term {
    let like = Dual::constant(Term::constant(0));
    term.evaluate(&like, &|_| Term::angle(variable).variable(0)).derivative(0)
}

/// The numbers that prove one root.
pub(super) struct ContractionTable {
    /// The centre `c`.
    pub centre: Vec<Rational>,
    /// The radii `r` of the wide box.
    pub radii: Vec<Rational>,
    /// A box of short decimals in the wide box, for people.
    pub wide: Vec<(Rational, Rational)>,
    /// The preconditioner `Y`.
    pub inverse: Vec<Vec<Rational>>,
    /// The slopes `M` at the centre.
    pub slopes: Vec<Vec<Rational>>,
    /// Distances of the slopes from those on the wide box, `D`.
    pub spreads: Vec<Vec<Rational>>,
    /// A bound `e` of all residuals at the centre.
    pub residual: Rational,
    /// The factor `q`.
    pub factor: Rational,
    /// Bits in which the residuals are evaluated.
    pub precision: u32,
}

impl ContractionTable {
    /// Chooses the numbers: the largest wide box of the shape that the isolation has found, on which
    /// the system contracts well.
    pub(super) fn new(root: &CoqRoot, cleared: &ClearedSystem) -> Result<Self, Undecided> {
        let failed = Err(Undecided::new("for Coq: nothing was tried"));
        LADDER.into_iter().fold(failed, |found, decimals| {
            found.or_else(|_| Self::with_decimals(root, cleared, decimals))
        })
    }

    /// Table with some decimals.
    fn with_decimals(
        root: &CoqRoot,
        cleared: &ClearedSystem,
        decimals: TableDecimals,
    ) -> Result<Self, Undecided> {
        let failed = |what| Undecided::new(format!("for Coq: {what}"));
        let centre: Vec<Rational> =
            root.values.iter().map(|x| nearest(&exact(x.mid()), decimals.centre)).collect();
        let at_centre = TermValues::new(root, &centre, &vec![Rational::new(); centre.len()]);
        let slopes = matrix(&cleared.jacobian, |term| at_centre.nearest(term, decimals.matrix));
        let floats = matrix(&slopes, |x| Float::with_val(BITS, x));
        let inverse = inverse(floats).ok_or_else(|| failed("a singular Jacobian"))?;
        let inverse = matrix(&inverse, |x| nearest(&exact(x), decimals.matrix));

        let boxes = shrinking(&root.domain);
        let contracting = boxes.into_iter().find_map(|radii| {
            // Tiny unknowns have no radius of this many decimals.
            if radii.contains(&Rational::new()) {
                return None;
            }
            let spreads =
                TermValues::new(root, &centre, &radii).spreads(cleared, &slopes, decimals.matrix);
            let factor = up(&contraction(&inverse, &slopes, &spreads, &radii), 2);
            (factor <= Rational::from(CONTRACTION)).then_some((radii, spreads, factor))
        });
        let (radii, spreads, factor) =
            contracting.ok_or_else(|| failed("no box on which it contracts"))?;
        let residual = at_centre.largest(&cleared.residuals, decimals.centre);
        if !starts(&inverse, &residual, &factor, &radii) {
            return Err(failed("the equations lose too many decimals of the root"));
        }
        let wide = short_bounds(&centre, &radii);
        let shows = |(c, (lo, hi)): (&Rational, &(Rational, Rational))| {
            lo.clone() + unit(DECIMALS) <= *c && c.clone() + unit(DECIMALS) <= *hi
        };
        if !centre.iter().zip(&wide).all(shows) {
            return Err(failed("an unknown is too small for its decimals"));
        }
        // Ten bits are three decimals.
        let precision = decimals.centre * 10 / 3 + 20;
        Ok(Self { centre, radii, wide, inverse, slopes, spreads, residual, factor, precision })
    }
}

/// Smaller and smaller boxes of one shape, with radii of two digits.
fn shrinking(domain: &[Ball]) -> Vec<Vec<Rational>> {
    let largest = Rational::from(LARGEST);
    let mut shape: Vec<Rational> = domain.iter().map(|x| radius(x).min(largest.clone())).collect();
    let step = |_| {
        let radii = shape.iter().map(|r| down(r, places(r, 2))).collect();
        shape.iter_mut().for_each(|r| *r *= Rational::from((19, 20)));
        radii
    };
    (0..TRIALS).map(step).collect()
}

/// A box of few digits that fits into the one given.
fn short_bounds(centre: &[Rational], radii: &[Rational]) -> Vec<(Rational, Rational)> {
    let bounds = |(c, r): (&Rational, &Rational)| {
        let places = places(r, 2);
        (up(&(c.clone() - r), places), down(&(c.clone() + r), places))
    };
    centre.iter().zip(radii).map(bounds).collect()
}

/// Enclosures of terms on a box.
struct TermValues {
    symbols: Vec<&'static str>,
    angles: Vec<Angle<Ball>>,
    given: Configuration<Ball>,
}

impl TermValues {
    fn new(root: &CoqRoot, centre: &[Rational], radii: &[Rational]) -> Self {
        let angle = |((c, r), unknown): ((&Rational, &Rational), &Unknown)| {
            let radius = Magnitude::upper(&Float::with_val(64, r));
            let ball = Ball::enclosing(c, BITS).widened(radius);
            if unknown.is_angle() {
                Angle::new(ball)
            } else {
                Angle { rad: ball.clone(), ..Angle::zero(&ball) }
            }
        };
        let angles = centre.iter().zip(radii).zip(root.system.unknowns).map(angle).collect();
        Self { symbols: symbols(&root.system), angles, given: root.given.clone() }
    }

    fn of(&self, term: &Term) -> Ball {
        let like = &self.angles[0].rad;
        term.evaluate(like, &|name| match self.symbols.iter().position(|x| *x == name) {
            Some(k) => self.angles[k].clone(),
            None if name == symbol(Unknown::HalfOpening) => self.given.half_opening.clone(),
            None => Angle { rad: self.given.friction.clone(), ..Angle::zero(like) },
        })
    }

    /// The value with few decimals; exactly, where the term is constant.
    fn nearest(&self, term: &Term, decimals: u32) -> Rational {
        match term.as_constant() {
            Some(constant) => constant.clone(),
            None => nearest(&exact(self.of(term).mid()), decimals),
        }
    }

    /// Bounds of how far the Jacobian on the box can be from the slopes at its centre, rounded up.
    fn spreads(
        &self,
        cleared: &ClearedSystem,
        slopes: &[Vec<Rational>],
        decimals: u32,
    ) -> Vec<Vec<Rational>> {
        let spread = |(term, slope): (&Term, &Rational)| match term.as_constant() {
            Some(_) => Rational::new(),
            None => {
                let spread = distance(&self.of(term), slope) * Rational::from(ROOM);
                up(&spread, places(&spread, 2).min(decimals))
            }
        };
        let rows = cleared.jacobian.iter().zip(slopes);
        rows.map(|(terms, slopes)| terms.iter().zip(slopes).map(spread).collect()).collect()
    }

    /// A bound of few digits for all absolute values, with room.
    fn largest(&self, terms: &[Term], decimals: u32) -> Rational {
        let sizes = terms.iter().map(|term| distance(&self.of(term), &Rational::new()));
        let largest = sizes.max().unwrap_or_default() * Rational::from(2);
        up(&largest, decimals)
    }
}

/// `|I - Y M| + |Y| D` in the norm weighted by the radii.
fn contraction(
    inverse: &[Vec<Rational>],
    slopes: &[Vec<Rational>],
    spreads: &[Vec<Rational>],
    radii: &[Rational],
) -> Rational {
    let n = radii.len();
    let entry = |i: usize, k: usize| {
        let products = (0..n).map(|j| inverse[i][j].clone() * &slopes[j][k]);
        let unit = Rational::from(u32::from(i == k));
        let spread = (0..n).map(|j| inverse[i][j].clone().abs() * &spreads[j][k]);
        products.fold(unit, |sum, x| sum - x).abs() + spread.fold(Rational::new(), |sum, x| sum + x)
    };
    let row = |i: usize| {
        let terms = (0..n).map(|k| entry(i, k) * &radii[k]);
        terms.fold(Rational::new(), |sum, x| sum + x) / &radii[i]
    };
    (0..n).map(row).max().unwrap_or_default()
}

/// Tells whether the first Newton step stays far inside the small box.
fn starts(
    inverse: &[Vec<Rational>],
    residual: &Rational,
    factor: &Rational,
    radii: &[Rational],
) -> bool {
    let room = (Rational::from(1) - factor) * unit(DECIMALS);
    inverse.iter().zip(radii).all(|(row, radius)| {
        let sum = row.iter().fold(Rational::new(), |sum, y| sum + y.clone().abs());
        sum * residual <= room.clone() * radius
    })
}

fn matrix<T, U>(rows: &[Vec<T>], f: impl Fn(&T) -> U) -> Vec<Vec<U>> {
    rows.iter().map(|row| row.iter().map(&f).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::certify::CertifiedLandmark;
    use crate::problem::Landmark;

    fn triple() -> (CoqRoot, ClearedSystem) {
        let point = CertifiedLandmark::new(Landmark::Triple, SelfWeight::Milankovitch).unwrap();
        let root = CoqRoot::of_landmark(&point).unwrap();
        let cleared = ClearedSystem::new(&root.system);
        (root, cleared)
    }

    #[test]
    fn a_cleared_system_has_no_quotients_and_its_own_zeros() {
        let (root, cleared) = triple();
        let centre: Vec<Rational> = root.values.iter().map(|x| exact(x.mid())).collect();
        let values = TermValues::new(&root, &centre, &vec![Rational::new(); centre.len()]);
        for term in &cleared.residuals {
            assert!(!term.to_string().contains(" / "), "{term}");
            assert!(distance(&values.of(term), &Rational::new()) < unit(60));
        }
    }

    #[test]
    fn the_jacobian_is_that_of_the_cleared_system() {
        let (root, cleared) = triple();
        let at = |shift: usize, by: Rational| -> TermValues {
            let mut centre: Vec<Rational> = (2..8).map(|n| Rational::from((n, 7))).collect();
            centre[shift] += by;
            TermValues::new(&root, &centre, &vec![Rational::new(); 6])
        };
        let step = Rational::from((1, 1_000_000_000));
        for k in 0..6 {
            let (below, above) = (at(k, -step.clone()), at(k, step.clone()));
            for (term, slopes) in cleared.residuals.iter().zip(&cleared.jacobian) {
                let difference = exact(above.of(term).mid()) - exact(below.of(term).mid());
                let slope = at(k, Rational::new()).of(&slopes[k]);
                let quotient = difference / (step.clone() * Rational::from(2));
                assert!(distance(&slope, &quotient) < unit(15), "{term}");
            }
        }
    }

    #[test]
    fn the_factor_of_a_perfect_preconditioner_is_the_spread() {
        let row = |x: i32| vec![vec![Rational::from((x, 10))]];
        let factor = contraction(&row(5), &row(20), &row(3), &[Rational::from(1)]);
        assert_eq!(factor, Rational::from((15, 100)));
    }
}
