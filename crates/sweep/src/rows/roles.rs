//! Roles of the columns of files, and what they are called.

use crate::ask::Field;
use crate::problem::Quantity;

/// Role of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The model of self-weight.
    Weight,
    /// A field by which an arch is given.
    Given(Field),
    /// Statement of whether the arch stands at some thickness.
    CanStand,
    /// Statement of whether the arch stands at the thickness that it has, or at some thickness if it has none.
    Stands,
    /// The collapse mode.
    Mode,
    /// The value of a quantity.
    Number(Quantity),
}

/// Purpose for which a file is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Arches to be answered.
    Ask,
    /// Results to be judged.
    Judge,
    /// Verdicts on assemblies of stones, of which each says itself what it is.
    Assemblies,
}

/// Fields of every arch, whatever is asked or said of it.
const ARCH: [Field; 4] =
    [Field::HalfOpening, Field::Friction, Field::FrictionAngle, Field::Thickness];

impl Purpose {
    /// The roles that are read.
    pub(super) fn roles(self) -> Vec<Role> {
        if self == Self::Assemblies {
            return vec![Role::Stands];
        }
        let mut roles = vec![Role::Weight];
        roles.extend(ARCH.map(Role::Given));
        if self == Self::Ask {
            roles.extend(Field::SIZES.map(Role::Given));
        } else {
            roles.extend([Role::CanStand, Role::Stands, Role::Mode]);
            roles.extend(Quantity::STATE.map(Role::Number));
            roles.extend(Quantity::ASSESSMENT.map(Role::Number));
        }
        roles
    }
}

impl Role {
    /// Our name for it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Weight => "weight",
            Self::Given(Field::Thickness) => "given_thickness",
            Self::Given(field) => field.name(),
            Self::CanStand => "can_stand",
            Self::Stands => "stands",
            Self::Mode => "mode",
            Self::Number(quantity) => quantity.name(),
        }
    }

    /// All names of it, the one to show first.
    pub(super) fn names(self, purpose: Purpose) -> Vec<&'static str> {
        let field = match self {
            Self::Number(Quantity::Thickness) => Some(Field::Thickness),
            // Among results the thickness is that of the state.
            Self::Given(Field::Thickness) if purpose != Purpose::Ask => None,
            _ => self.field(),
        };
        let mut names: Vec<_> = field.map(Field::name).into_iter().collect();
        names.extend(field.and_then(Field::letter));
        if !names.contains(&self.name()) {
            names.push(self.name());
        }
        names
    }

    /// The field of an arch that it is.
    pub(super) fn field(self) -> Option<Field> {
        if let Self::Given(field) = self { Some(field) } else { None }
    }

    /// Units that its cells may have, the usual one first.
    pub(super) fn units(self) -> &'static [&'static str] {
        match self {
            Self::Given(Field::HalfOpening | Field::FrictionAngle) => &["rad", "deg", "gon"],
            Self::Given(Field::Friction) => &["deg", "gon"],
            Self::Given(Field::Density) => &["kN/m3", "kg/m3"],
            Self::Given(Field::MeasuredAt) => &[],
            Self::Given(_) => &["m", "cm", "mm", "ft", "in"],
            Self::Number(quantity) if quantity.is_angle() => &["rad", "deg"],
            _ => &[],
        }
    }

    /// Tells whether the role is about an arch of a given thickness.
    pub fn is_of_thickness(self) -> bool {
        match self {
            Self::Given(field) => field == Field::Thickness,
            Self::Number(quantity) => Quantity::ASSESSMENT.contains(&quantity),
            _ => false,
        }
    }

    /// Tells whether the role is something that can be judged.
    pub(crate) fn is_claim(self) -> bool {
        matches!(self, Self::CanStand | Self::Stands | Self::Mode | Self::Number(_))
    }
}
