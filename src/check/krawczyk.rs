//! The Krawczyk operator: exactly one root in a box.
//!
//! For `F: R^n -> R^n` with a continuous derivative on a box `X` with centre `m`, and any matrix `Y`,
//!
//! ```text
//! K(X) = m - Y F(m) + (I - Y F'(X)) (X - m)
//! ```
//!
//! holds every root of `F` in `X`; and **if `K(X)` lies in the interior of `X`, then `X` holds exactly
//! one root**, and it lies in `K(X)` (Krawczyk 1969, Moore 1977). `F(m)` and `F'(X)` are enclosures,
//! the derivative from dual numbers over enclosures. An unbounded enclosure (a divisor that may
//! vanish in `X`) makes `K(X)` unbounded, so that the test fails; hence a success also proves that
//! `F` is smooth on `X`.

use crate::arch::{Point, System};
use crate::number::{Dual, Enclosure, Field};

/// The last term of `K(X)`, `(I - Y F'(X)) (X - m)`. `preconditioner` is `Y`; `slopes` are the
/// residuals as dual numbers on a box that holds `domain`, of which only the gradients are used.
pub fn spread<E: Enclosure>(slopes: &[Dual<E>], preconditioner: &[Vec<E>], domain: &[E]) -> Vec<E> {
    let n = domain.len();
    let contraction = |row: &[E], i: usize, k: usize| {
        let products = row
            .iter()
            .zip(slopes)
            .filter_map(|(y, slope)| slope.slope(k).map(|slope| y.clone() * slope));
        row[k].int(i32::from(i == k)) - sum(&row[k], products)
    };
    let component = |(i, row): (usize, &Vec<E>)| {
        sum(&row[i], (0..n).map(|k| contraction(row, i, k) * domain[k].centred()))
    };
    preconditioner.iter().enumerate().map(component).collect()
}

/// `K(X)` on a box symmetric about `centre`, from enclosures of the residuals at the centre and of
/// the slopes on the box.
pub fn image<E: Enclosure>(
    centre: &[E],
    residuals: &[E],
    slopes: &[Dual<E>],
    preconditioner: &[Vec<E>],
    domain: &[E],
) -> Vec<E> {
    let newton = preconditioner
        .iter()
        .map(|row| sum(&row[0], row.iter().zip(residuals).map(|(y, r)| y.clone() * r)));
    let spread = spread(slopes, preconditioner, domain);
    let parts = centre.iter().zip(newton).zip(spread);
    parts.map(|((x, newton), spread)| x.clone() - newton + spread).collect()
}

fn sum<E: Field>(like: &E, terms: impl Iterator<Item = E>) -> E {
    terms.fold(like.int(0), |sum, term| sum + term)
}

/// The proof: `K(X)` if it lies in the interior of `X`, so that `X` holds exactly one root.
/// `None` says nothing.
pub fn unique_root<E: Enclosure>(
    system: &System,
    centre: &[E],
    preconditioner: &[Vec<E>],
    domain: &[E],
) -> Option<Vec<E>> {
    let at_centre = system.residuals(&Point::new(system, centre));
    let slopes = system.residuals(&Point::new(system, domain).variables());
    let image = image(centre, &at_centre, &slopes, preconditioner, domain);
    is_contracted(&image, domain).then_some(image)
}

/// Whether each component of `image` lies in the interior of that of `domain`.
pub fn is_contracted<E: Enclosure>(image: &[E], domain: &[E]) -> bool {
    image.len() == domain.len() && image.iter().zip(domain).all(|(k, x)| k.lies_inside(x))
}
