//! The numbers with which `Contraction.v` proves one root of a system.
//!
//! Nothing here is trusted: Coq checks every number. Floats and balls only choose them, such that the
//! check succeeds with some room.

use super::numeral::{distance, down, exact, nearest, places, radius, unit, up};
use super::{Symbols, Term};
use crate::arch::{Point, System};
use crate::certify::{CertifiedLandmark, Undecided};
use crate::number::{Angle, Ball, Dual, Magnitude};
use crate::solve::inverse;
use rug::{Float, Rational};

/// Decimals to which a centre is known.
pub const DECIMALS: u32 = 30;
/// Decimals of a centre as printed: the first Newton step has to stay far inside the small box.
const CENTRE: u32 = DECIMALS + 6;
/// Decimals of the preconditioner and of the slopes at the centre.
const MATRIX: u32 = 7;
/// Bits of the balls.
const BITS: u32 = 256;
/// The factor by which distances have to shrink.
const CONTRACTION: (u32, u32) = (9, 10);
/// By how much a bound is printed larger than the balls find it; Coq's intervals differ from them.
const ROOM: (u32, u32) = (21, 20);
/// The box is made smaller by a twentieth this often before it is given up.
const TRIALS: u32 = 100;

/// A system as terms, cleared of denominators, with its derivatives.
pub struct Cleared {
    /// One term for each equation.
    pub residuals: Vec<Term>,
    /// Their derivatives to the unknowns.
    pub jacobian: Vec<Vec<Term>>,
}

impl Cleared {
    /// The equations of the system, in its own order, in variables named by their symbols.
    pub fn new(system: &System) -> Self {
        let symbols = Symbols::of(system);
        let variables: Vec<Term> = symbols.iter().map(Term::variable).collect();
        let point = Point::with_angles(system, &variables, |k, _| Term::angle(symbols.get(k)));
        let residuals: Vec<Term> =
            system.residuals(&point).iter().map(|term| term.fraction().0).collect();
        let slopes = |term: &Term| gradient(term, &symbols);
        let jacobian = residuals.iter().map(slopes).collect();
        Self { residuals, jacobian }
    }
}

/// The derivatives of a term to some of its variables.
fn gradient(term: &Term, symbols: &Symbols) -> Vec<Term> {
    let like = Dual::constant(Term::constant(0));
    let slope = term.evaluate(&like, &|name| match symbols.index(name) {
        Some((k, symbol)) => Term::angle(symbol).variable(k),
        None => Angle::zero(&like),
    });
    symbols.iter().enumerate().map(|(k, _)| slope.derivative(k)).collect()
}

/// The derivative of a term in one variable.
pub fn derivative(term: &Term, variable: &'static str) -> Term {
    let like = Dual::constant(Term::constant(0));
    term.evaluate(&like, &|_| Term::angle(variable).variable(0)).derivative(0)
}

/// The numbers of one landmark.
pub struct Table {
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
    /// How far the slopes are from those on the wide box, `D`.
    pub spreads: Vec<Vec<Rational>>,
    /// A bound `e` of all residuals at the centre.
    pub residual: Rational,
    /// The factor `q`.
    pub factor: Rational,
}

impl Table {
    /// Chooses the numbers: the largest wide box of the shape that the isolation has found, on which
    /// the system contracts well.
    pub fn new(point: &CertifiedLandmark, cleared: &Cleared) -> Result<Self, Undecided> {
        let failed = |what| Undecided(format!("{} for Coq: {what}", point.landmark().symbol()));
        let system = point.isolated().system();
        let refined = point.enclosure(BITS)?;
        let values = system.unknowns.iter().map(|&unknown| refined.value(unknown));
        let centre: Option<Vec<Rational>> =
            values.map(|x| Some(nearest(&exact(x?.mid()), CENTRE))).collect();
        let centre = centre.ok_or_else(|| failed("a value is missing"))?;
        let at = |radii: &[Rational]| -> Vec<Ball> {
            let ball = |(c, r): (&Rational, &Rational)| {
                let radius = Magnitude::upper(&Float::with_val(64, r));
                Ball::enclosing(c, BITS).widened(radius)
            };
            centre.iter().zip(radii).map(ball).collect()
        };
        let exactly = at(&vec![Rational::new(); centre.len()]);
        let size = |term: &Term| distance(&value(term, system, &exactly), &Rational::new());
        let residual = cleared.residuals.iter().map(size).max().unwrap_or_default();
        let residual = up(&(residual * 2), places(&unit(CENTRE), 1));
        let slopes = matrix(&cleared.jacobian, |term| match term.as_constant() {
            Some(constant) => constant.clone(),
            None => nearest(&exact(value(term, system, &exactly).mid()), MATRIX),
        });
        let floats = |rows: &[Vec<Rational>]| -> Vec<Vec<Float>> {
            matrix(rows, |x| Float::with_val(BITS, x))
        };
        let inverse = inverse(floats(&slopes)).ok_or_else(|| failed("a singular Jacobian"))?;
        let inverse = matrix(&inverse, |x| nearest(&exact(x), MATRIX));

        let shape: Vec<Rational> = point.isolated().domain().iter().map(radius).collect();
        for trial in 0..TRIALS {
            let shrunk = |r: &Rational| {
                let r = (0..trial).fold(r.clone(), |r, _| r * Rational::from((19, 20)));
                down(&r, places(&r, 2))
            };
            let radii: Vec<Rational> = shape.iter().map(shrunk).collect();
            let domain = at(&radii);
            let spread = |term: &Term, slope: &Rational| match term.as_constant() {
                Some(_) => Rational::new(),
                None => {
                    let spread = distance(&value(term, system, &domain), slope);
                    let spread = spread * Rational::from(ROOM);
                    up(&spread, places(&spread, 2).min(MATRIX))
                }
            };
            let rows = cleared.jacobian.iter().zip(&slopes);
            let spreads: Vec<Vec<Rational>> = rows
                .map(|(terms, slopes)| {
                    terms.iter().zip(slopes).map(|(term, slope)| spread(term, slope)).collect()
                })
                .collect();
            let factor = up(&contraction(&inverse, &slopes, &spreads, &radii), 2);
            if factor > Rational::from(CONTRACTION) {
                continue;
            }
            let wide = centre.iter().zip(&radii).map(|(c, r)| {
                let places = places(r, 2);
                (up(&(c.clone() - r), places), down(&(c.clone() + r), places))
            });
            let wide = wide.collect();
            return Ok(Self { centre, radii, wide, inverse, slopes, spreads, residual, factor });
        }
        Err(failed("no box on which it contracts"))
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

fn value(term: &Term, system: &System, at: &[Ball]) -> Ball {
    let symbols = Symbols::of(system);
    let like = &at[0];
    term.evaluate(like, &|name| match symbols.index(name) {
        Some((k, _)) if system.unknowns[k].is_angle() => Angle::new(at[k].clone()),
        Some((k, _)) => Angle { rad: at[k].clone(), ..Angle::zero(like) },
        None => Angle::zero(like),
    })
}

fn matrix<T, U>(rows: &[Vec<T>], f: impl Fn(&T) -> U) -> Vec<Vec<U>> {
    rows.iter().map(|row| row.iter().map(&f).collect()).collect()
}
