//! The rotational and the overturning states join at `l` with one slope.
//!
//! The exact slopes, and that the curvatures differ, are claims (`couplet prove joining`).

mod closed;
mod states;

use couplet::arch::{SelfWeight, overturning};
use couplet::number::{Ball, Field, Surd};

const BITS: u32 = 512;

/// `A`, `eta` at `l`, and the slope `d eta/dA`, exactly.
fn end(weight: SelfWeight) -> [Surd; 3] {
    let eta = overturning::thickness_at_end(weight, &Surd::new(0, 1, 3));
    match weight {
        SelfWeight::Heyman => [Surd::rational((2, 3), 3), eta, Surd::rational((-9, 2), 3)],
        SelfWeight::Milankovitch => [Surd::new(-1, 1, 3), eta, Surd::new(0, -4, 3)],
    }
}

/// Common tangent of the two branches, in balls.
struct Tangent {
    a: Ball,
    eta: Ball,
    slope: Ball,
}

impl Tangent {
    fn at_end(weight: SelfWeight) -> Self {
        let [a, eta, slope] = end(weight).map(|x| x.enclosure(BITS));
        Self { a, eta, slope }
    }

    /// False twin, whose slope is off by a thousandth.
    fn turned(&self) -> Self {
        let slope = self.slope.clone() + self.slope.ratio(1, 1000);
        Self { a: self.a.clone(), eta: self.eta.clone(), slope }
    }

    /// Height of a point over it.
    fn gap(&self, a: &Ball, eta: &Ball) -> Ball {
        eta.clone() - &self.eta - self.slope.clone() * (a.clone() - &self.a)
    }

    /// Does a point lie as close as a second-order term lets it?
    fn holds(&self, a: &Ball, eta: &Ball) -> bool {
        self.is_flat(a, &self.gap(a, eta))
    }

    /// Is a quantity of second order in the distance from `l`?
    fn is_flat(&self, a: &Ball, quantity: &Ball) -> bool {
        // Half the curvatures are at most 704, and the distance is small.
        let bound = (a.clone() - &self.a).square() * a.int(1500);
        let sizes = [quantity.clone(), -quantity.clone()].map(|x| bound.clone() - x);
        sizes.iter().all(|gap| gap.lower() >= 0)
    }
}
