//! Place where the self-weight of a thin slice of the arch acts: the two models, and Eq. (6).

use crate::number::{Field, says, worded};

/// Reason why a text is no self-weight model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoWeight;

says!(NoWeight { Self => "a weight is one of {}", SelfWeight::ALL.map(SelfWeight::name).join(", "); });

worded! {
    /// The self-weight model, `delta_M` of the paper.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
    pub enum SelfWeight {
        /// Weight on the centreline (`delta_M = 0`): the classical approximation.
        Heyman = "heyman",
        /// Weight at the true centroids of the wedges (`delta_M = 1`), `r_G = r (1 + eta²/12)`.
        Milankovitch = "milankovitch",
    }
    /// Both models, in the order of the paper's tables.
    pub const ALL;
    /// The name used on the command line and in files.
    pub fn name -> &'static str;
}

impl SelfWeight {
    /// The model of a name, whatever its case.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|weight| weight.name().eq_ignore_ascii_case(name))
    }

    /// `delta_M`: 0 or 1.
    #[inline(always)]
    pub fn flag(self) -> i32 {
        match self {
            Self::Heyman => 0,
            Self::Milankovitch => 1,
        }
    }
}

// A model that is added is listed in `ALL`: the compiler stops here.
const _: () = match SelfWeight::Heyman {
    SelfWeight::Heyman | SelfWeight::Milankovitch => assert!(SelfWeight::ALL.len() == 2),
};

/// A value for each self-weight model: a cache, for instance. A model that is added has to be given one.
#[derive(Clone, Copy, Debug)]
pub struct PerWeight<T> {
    /// Value for [`SelfWeight::Heyman`].
    pub heyman: T,
    /// Value for [`SelfWeight::Milankovitch`].
    pub milankovitch: T,
}

impl<T> PerWeight<T> {
    /// The value for a model.
    pub const fn get(&self, weight: SelfWeight) -> &T {
        match weight {
            SelfWeight::Heyman => &self.heyman,
            SelfWeight::Milankovitch => &self.milankovitch,
        }
    }
}

/// The cross-section of the ring: what an equation needs to know of thickness and weight.
#[derive(Clone, Debug)]
pub struct Ring<T> {
    /// The thickness-to-radius ratio `eta = t/r`.
    pub thickness: T,
    /// `fac_M`, the radius of the centroids in units of `r`, Eq. (6).
    pub centroid_factor: T,
}

impl<T> Ring<T> {
    /// The ring in another number.
    pub fn map<U>(&self, f: impl Fn(&T) -> U) -> Ring<U> {
        Ring { thickness: f(&self.thickness), centroid_factor: f(&self.centroid_factor) }
    }
}

impl<T: Field> Ring<T> {
    /// A ring of the given thickness and self-weight model.
    #[inline(always)]
    pub fn new(weight: SelfWeight, thickness: &T) -> Self {
        Self::with_flag(&thickness.int(weight.flag()), thickness)
    }

    /// Ring with `delta_M` as a number (or a symbol): `fac_M = 1 + delta_M eta²/12`, Eq. (6).
    #[inline(always)]
    pub fn with_flag(delta: &T, thickness: &T) -> Self {
        let centroid_factor = delta.int(1) + delta.clone() * thickness.square() / delta.int(12);
        Self { thickness: thickness.clone(), centroid_factor }
    }

    /// `2 - eta`, twice the radius of the intrados.
    #[inline(always)]
    pub fn intrados(&self) -> T {
        self.thickness.int(2) - &self.thickness
    }

    /// `2 + eta`, twice the radius of the extrados.
    #[inline(always)]
    pub fn extrados(&self) -> T {
        self.thickness.int(2) + &self.thickness
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Rational;

    #[test]
    fn the_centroid_factor_is_the_wedge_centroid() {
        // The centroid of a thin wedge between radii a = 1 - eta/2 and b = 1 + eta/2 lies at the
        // quotient of the moments, (b³ - a³)/3 over (b² - a²)/2.
        let eta = Rational::from((7, 5));
        let (a, b) = (Rational::from((3, 10)), Rational::from((17, 10)));
        let cube = |x: &Rational| Rational::from(x * x) * x;
        let centroid = (cube(&b) - cube(&a)) / 3 / ((b.square() - a.square()) / 2);
        assert_eq!(Ring::new(SelfWeight::Milankovitch, &eta).centroid_factor, centroid);
        assert_eq!(Ring::new(SelfWeight::Heyman, &eta).centroid_factor, 1);
    }
}
