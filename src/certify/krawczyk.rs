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

/// `K(X)` from its parts. `preconditioner` is `Y`; the box is symmetric about `centre`.
///
/// `slopes` are the residuals on the box as dual numbers: only their gradients are used.
pub fn image<E: Enclosure>(
    centre: &[E],
    residuals: &[E],
    slopes: &[Dual<E>],
    preconditioner: &[Vec<E>],
    domain: &[E],
) -> Vec<E> {
    let n = centre.len();
    let row = |i: usize| {
        let newton = sum(&centre[i], (0..n).map(|j| preconditioner[i][j].clone() * &residuals[j]));
        let contraction = |k: usize| {
            let products = (0..n).filter_map(|j| {
                slopes[j].slope(k).map(|slope| preconditioner[i][j].clone() * slope)
            });
            let identity = preconditioner[i][i].int(i32::from(i == k));
            identity - sum(&preconditioner[i][i], products)
        };
        let spread =
            sum(&preconditioner[i][i], (0..n).map(|k| contraction(k) * domain[k].centred()));
        centre[i].clone() - newton + spread
    };
    (0..n).map(row).collect()
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
