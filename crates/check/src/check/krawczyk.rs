//! The Krawczyk operator: exactly one root in a box.
//!
//! For `F: R^n -> R^n` with a continuous derivative on a box `X`, a point `m` of it, its centre as a rule,
//! and any matrix `Y`,
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

use crate::number::{Derivatives, Enclosure, Field};

/// `I - Y F'(X)`, row by row. `preconditioner` is `Y`; `slopes` are the residuals with their derivatives on a box
/// that holds `X`, of which only these are used.
pub fn contraction<E: Field>(
    slopes: &[impl Derivatives<E>],
    preconditioner: &[impl AsRef<[E]>],
) -> Vec<Vec<E>> {
    let entry = |row: &[E], i: usize, k: usize| {
        let products = row
            .iter()
            .zip(slopes)
            .filter_map(|(y, slope)| slope.slope(k).map(|slope| y.clone() * slope));
        row[k].int(i32::from(i == k)) - sum(&row[k], products)
    };
    let rows = preconditioner.iter().map(AsRef::as_ref).enumerate();
    rows.map(|(i, row)| (0..row.len()).map(|k| entry(row, i, k)).collect()).collect()
}

/// The last term of `K(X)`, `(I - Y F'(X)) (X - m)`; `offsets` is `X - m`, the rest as for [`contraction`].
pub fn spread<E: Enclosure>(
    slopes: &[impl Derivatives<E>],
    preconditioner: &[impl AsRef<[E]>],
    offsets: &[E],
) -> Vec<E> {
    let rows = contraction(slopes, preconditioner).into_iter();
    let component = |row: Vec<E>| {
        let zero = row[0].int(0);
        row.into_iter().zip(offsets).fold(zero, |sum, (entry, offset)| sum + entry * offset)
    };
    rows.map(component).collect()
}

/// `K(X)` on the box `domain`, from enclosures of the residuals at `centre` and of the slopes on the box.
///
/// A box rounded outward need not be symmetric about its centre, so that its sides are measured from there.
pub fn image<E: Enclosure>(
    centre: &[E],
    residuals: &[E],
    slopes: &[impl Derivatives<E>],
    preconditioner: &[impl AsRef<[E]>],
    domain: &[E],
) -> Vec<E> {
    let newton = preconditioner
        .iter()
        .map(AsRef::as_ref)
        .map(|row| sum(&row[0], row.iter().zip(residuals).map(|(y, r)| y.clone() * r)));
    let offsets: Vec<E> = domain.iter().zip(centre).map(|(x, m)| x.clone() - m).collect();
    let spread = spread(slopes, preconditioner, &offsets);
    let parts = centre.iter().zip(newton).zip(spread);
    parts.map(|((x, newton), spread)| x.clone() - newton + spread).collect()
}

fn sum<E: Field>(like: &E, terms: impl Iterator<Item = E>) -> E {
    terms.fold(like.int(0), |sum, term| sum + term)
}

/// Tells whether each component of `image` lies in the interior of that of `domain`.
pub fn is_contracted<E: Enclosure>(image: &[E], domain: &[E]) -> bool {
    image.len() == domain.len() && image.iter().zip(domain).all(|(k, x)| k.lies_inside(x))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{AstroInterval, Dual};

    /// `F(x) = x/8`, `Y = 1`: `K` is `7/8 x`, whatever the point from which the sides are measured.
    #[test]
    fn a_box_need_not_be_symmetric_about_its_centre() {
        let like = AstroInterval::integer(0, 64);
        let eighth = like.ratio(1, 8);
        let slopes = [Dual::with_derivative(like.int(0), 0, eighth.clone())];
        let domain = [like.int(2) + like.int(2).symmetric()];
        let one = like.int(1);
        let image =
            image(std::slice::from_ref(&one), &[eighth], &slopes, &[vec![one.clone()]], &domain);
        let (low, high) = (like.ratio(-1, 1000), like.ratio(3501, 1000));
        assert!(image[0].overlaps(&like.int(0)) && image[0].overlaps(&like.ratio(7, 2)));
        assert!(low.is_less_than(&image[0]).and(image[0].is_less_than(&high)).is_proved());
    }
}
