//! Tables of start values: a cubic on each cell of a number.
//!
//! A table is made of candidates, once and when it is first asked for. Nothing that is proved rests on it.

use crate::arch::{
    Configuration, PerWeight, Ring, SelfWeight, contact, cycloid, overturning, thrust,
};
use crate::number::Angle;
use crate::solve::start;
use std::f64::consts::FRAC_PI_2;
use std::sync::OnceLock;

/// Cells of a table. A power of two, so that a place is some bits of a number.
const CELLS: usize = 256;

/// Adding and taking it away rounds to an integer, which is the last bits of the sum.
const ROUNDING: f64 = (3u64 << 51) as f64;

/// `N` functions of a number between two ends: cubics by the distance from the middle of a cell in widths.
pub(super) struct Table<const N: usize> {
    first: f64,
    cells_a_unit: f64,
    cells: Vec<[[f64; 4]; N]>,
}

impl<const N: usize> Table<N> {
    fn new([first, last]: [f64; 2], of: impl Fn(f64) -> [f64; N]) -> Self {
        let width = (last - first) / (CELLS - 1) as f64;
        let at = |place: f64| of(first + place * width);
        let mut left = at(-0.5);
        let cell = |k: usize| {
            // At the ends of the cell, and at a third of it from them.
            let [low, high, right] = [-1.0 / 6.0, 1.0 / 6.0, 0.5].map(|by| at(k as f64 + by));
            let cell = std::array::from_fn(|which| {
                let [left, low, high, right] = [left, low, high, right].map(|of| of[which]);
                let square = 2.25 * (left + right - low - high);
                let cube = 4.5 * (right - left - 3.0 * (high - low));
                [0.5 * (low + high) - square / 36.0, right - left - 0.25 * cube, square, cube]
            });
            left = right;
            cell
        };
        Self { first, cells_a_unit: width.recip(), cells: (0..CELLS).map(cell).collect() }
    }

    /// The candidates at a number between the ends; elsewhere they mean nothing.
    #[inline(always)]
    pub(super) fn at(&self, x: f64) -> [f64; N] {
        let place = (x - self.first) * self.cells_a_unit;
        let rounded = place + ROUNDING;
        let from = place - (rounded - ROUNDING);
        let cell = &self.cells[rounded.to_bits() as usize % CELLS];
        let mut all = [0.0; N];
        for (value, [a, b, c, d]) in all.iter_mut().zip(cell) {
            *value = a + from * (b + from * (c + from * d));
        }
        all
    }
}

/// A place for a table of each weight.
const fn unfilled<T>() -> PerWeight<OnceLock<T>> {
    PerWeight { heyman: OnceLock::new(), milankovitch: OnceLock::new() }
}

/// The least half opening, rad: below it other equations keep their digits.
pub(super) const LEAST: f64 = 0.00390625;

/// Half openings of rotation, rad; the last one is next to the end of rotation.
#[inline(always)]
pub(super) fn rotates(weight: SelfWeight) -> [f64; 2] {
    [LEAST, if weight == SelfWeight::Heyman { 2.640625 } else { 2.5859375 }]
}

/// By the half opening: the squares of `beta_r` and of the joint that is steepest at the thrust.
pub(super) fn rotation(weight: SelfWeight) -> &'static Table<2> {
    static TABLES: PerWeight<OnceLock<Table<2>>> = unfilled();
    TABLES.get(weight).get_or_init(|| {
        Table::new(rotates(weight), |alpha| {
            let [beta, _, h] = start::rotational(weight, &alpha);
            [beta * beta, (1.0 - h) * h]
        })
    })
}

/// The place of a thickness in its table: for small ones the joint is like their fourth root.
#[inline(always)]
pub(super) fn place_of_thickness(eta: f64) -> f64 {
    eta.sqrt().sqrt()
}

/// The [places](place_of_thickness) of thicknesses that are touched above the joint; the last is next to that of the
/// end of rotation.
#[inline(always)]
pub(super) fn touches_above(weight: SelfWeight) -> [f64; 2] {
    let end = overturning::thickness_at_end(weight, &3f64.sqrt());
    [0.0234375, place_of_thickness(end)]
}

/// By the place of a thickness: the square of `beta_r` where (2) and (5) hold.
pub(super) fn above(weight: SelfWeight) -> &'static Table<1> {
    static TABLES: PerWeight<OnceLock<Table<1>>> = unfilled();
    TABLES.get(weight).get_or_init(|| {
        Table::new(touches_above(weight), |place| {
            let [beta, _] = start::rotational_with_thickness(weight, &place.powi(4));
            [beta * beta]
        })
    })
}

/// By the half opening: the square of `beta_r` and the thickness of the rotational state, and the thickness from which
/// the line of the largest thrust touches the crown.
pub(super) fn below(weight: SelfWeight) -> &'static Table<3> {
    static TABLES: PerWeight<OnceLock<Table<3>>> = unfilled();
    TABLES.get(weight).get_or_init(|| {
        Table::new(rotates(weight), |alpha| {
            let [beta, rotates, _] = start::rotational(weight, &alpha);
            let half_opening = Angle::new(alpha);
            let touches_haunch = |eta: f64| {
                let upper =
                    thrust::upper(&half_opening, &Angle::zero(&0.0), &Ring::new(weight, &eta));
                let at = Configuration {
                    thickness: eta,
                    thrust: upper.value(),
                    ..Configuration::zero(&0.0)
                };
                upper.denominator > 0.0 && contact::crown_slope(weight, &at) < 0.0
            };
            let (mut low, mut high) = (rotates, 2.0);
            for _ in 0..50 {
                let middle = 0.5 * (low + high);
                *if touches_haunch(middle) { &mut low } else { &mut high } = middle;
            }
            [beta * beta, rotates, low]
        })
    })
}

/// Half openings of purely sliding states, rad.
pub(super) const SLIDES: [f64; 2] = [LEAST, 3.0];

/// By the half opening: the inclination inside of the purely sliding state, and that at the shoulder.
pub(super) fn sliding() -> &'static Table<2> {
    static TABLE: OnceLock<Table<2>> = OnceLock::new();
    TABLE.get_or_init(|| {
        Table::new(SLIDES, |alpha| {
            let [_, h, _] = start::sliding(&alpha);
            let chi = inclination(h);
            [chi.rad, alpha - cycloid::friction_angle(&chi)]
        })
    })
}

/// Frictions at which an inner joint slides.
pub(super) const FRICTIONS: [f64; 2] = [0.0009765625, 64.0];

/// The place of a friction in its table: for small ones the inclination is like their cube root.
#[inline(always)]
pub(super) fn place_of_friction(mu: f64) -> f64 {
    mu.sqrt() / (1.0 + mu.sqrt())
}

/// By the [place](place_of_friction) of a friction: the inclination at the joint that slides, and the friction angle.
pub(super) fn steepest() -> &'static Table<2> {
    static TABLE: OnceLock<Table<2>> = OnceLock::new();
    TABLE.get_or_init(|| {
        Table::new(FRICTIONS.map(place_of_friction), |place| {
            let mu = (place / (1.0 - place)).powi(2);
            let [h, _] = start::inner_sliding(&mu);
            [inclination(h).rad, mu.atan()]
        })
    })
}

/// The inclination of the force where an inner joint slides with a thrust.
fn inclination(h: f64) -> Angle<f64> {
    Angle::new(h.sqrt().acos())
}

/// Thrusts at which the shoulder slides.
pub(super) const THRUSTS: [f64; 2] = [0.0625, 0.9921875];

/// By the thrust: the square of `beta_r` where (2) and (5) hold.
pub(super) fn shoulder(weight: SelfWeight) -> &'static Table<1> {
    static TABLES: PerWeight<OnceLock<Table<1>>> = unfilled();
    TABLES.get(weight).get_or_init(|| {
        Table::new(THRUSTS, |h| {
            let [beta, ..] = start::rotational_with_thrust(weight, &h);
            [beta * beta]
        })
    })
}

/// Ends of half openings (rad) and of thrusts between which a joint inside may slide with a hinge at the haunch.
const WIDE: [f64; 2] = [2.375, 2.8125];
const SMALL: [f64; 2] = [0.0, 0.1328125];

/// Cells of a plane in each direction.
const STEPS: usize = 64;

/// A function of a half opening and of a thrust: bilinear on cells.
pub(super) struct StartPlane(Vec<[f64; STEPS + 1]>);

impl StartPlane {
    fn new(of: impl Fn(f64, f64) -> f64) -> Self {
        let at =
            |[first, last]: [f64; 2], k: usize| first + (last - first) * k as f64 / STEPS as f64;
        let row = |i: usize| std::array::from_fn(|j| of(at(WIDE, i), at(SMALL, j)));
        Self((0..=STEPS).map(row).collect())
    }

    /// The candidate next to a half opening and a thrust; none outside the ends.
    #[inline(always)]
    pub(super) fn at(&self, alpha: f64, h: f64) -> f64 {
        let place = |x: f64, [first, last]: [f64; 2]| (x - first) * (STEPS as f64 / (last - first));
        let [x, y] = [place(alpha, WIDE), place(h, SMALL)];
        // What is no number goes to the first cell.
        let cell = |x: f64| x.clamp(0.0, (STEPS - 1) as f64) as usize;
        let (i, j) = (cell(x), cell(y));
        let (x, y) = (x - i as f64, y - j as f64);
        let along = |row: &[f64; STEPS + 1]| row[j] + y * (row[j + 1] - row[j]);
        let [low, high] = [along(&self.0[i]), along(&self.0[i + 1])];
        low + x * (high - low)
    }
}

/// By the half opening and the thrust: the square of `beta_r` where (3) and (5) hold, negative where the crown is
/// touched.
pub(super) fn plane(weight: SelfWeight) -> &'static StartPlane {
    static PLANES: PerWeight<OnceLock<StartPlane>> = unfilled();
    PLANES
        .get(weight)
        .get_or_init(|| StartPlane::new(|alpha, h| start::touching_square_below(weight, alpha, h)))
}

/// Tells whether the friction seems to be below the purely sliding one of a half opening.
pub(super) fn seems_to_slide(alpha: f64, mu: f64) -> bool {
    let [_, at_shoulder] = sliding().at(alpha);
    let [_, phi] = steepest().at(place_of_friction(mu));
    phi < alpha - at_shoulder || mu < FRICTIONS[0]
}

/// Tells whether the physical limit of the thickness seems to be too little for a half opening at a thrust.
pub(super) fn seems_too_wide(weight: SelfWeight, alpha: f64, h: f64) -> bool {
    let (sin, cos) = alpha.sin_cos();
    let half_opening = Angle { rad: alpha, sin, cos };
    let at = Configuration { half_opening, thrust: h, ..Configuration::zero(&h) };
    alpha > FRAC_PI_2 && contact::margin_at_physical_limit(weight, &at) < 0.0
}
