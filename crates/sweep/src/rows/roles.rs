//! Roles of the columns of files, and what they are called.

use crate::ask::Field;
use crate::problem::Quantity;

/// Role of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The model of self-weight.
    Weight,
    /// The half opening.
    HalfOpening,
    /// The coefficient of friction.
    Friction,
    /// The angle of friction.
    FrictionAngle,
    /// A size of an arch that is measured, or the circle at which it is.
    Size(Field),
    /// The thickness that an arch has.
    GivenThickness,
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

const ARCH: [Role; 4] = [Role::Weight, Role::HalfOpening, Role::Friction, Role::FrictionAngle];

impl Purpose {
    /// The roles that are read.
    pub(super) fn roles(self) -> Vec<Role> {
        if self == Self::Assemblies {
            return vec![Role::Stands];
        }
        let mut roles = ARCH.to_vec();
        roles.push(Role::GivenThickness);
        if self == Self::Ask {
            roles.extend(Field::SIZES.map(Role::Size));
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
            Self::HalfOpening => "half_opening",
            Self::Friction => "friction",
            Self::FrictionAngle => "friction_angle",
            Self::Size(field) => field.name(),
            Self::GivenThickness => "given_thickness",
            Self::CanStand => "can_stand",
            Self::Stands => "stands",
            Self::Mode => "mode",
            Self::Number(quantity) => quantity.name(),
        }
    }

    /// The quantity whose name, and letter in the paper, it may have.
    fn quantity(self, purpose: Purpose) -> Option<Quantity> {
        match (self, purpose) {
            (Self::HalfOpening, _) => Some(Quantity::HalfOpening),
            (Self::Friction, _) => Some(Quantity::Friction),
            (Self::FrictionAngle, _) => Some(Quantity::FrictionAngle),
            (Self::GivenThickness, Purpose::Ask) | (Self::Number(Quantity::Thickness), _) => {
                Some(Quantity::Thickness)
            }
            _ => None,
        }
    }

    /// All names of it, the one to show first.
    pub(super) fn names(self, purpose: Purpose) -> Vec<&'static str> {
        let quantity = self.quantity(purpose);
        let mut names: Vec<_> = quantity.map(Quantity::name).into_iter().collect();
        names.extend(quantity.and_then(Quantity::letter));
        if !names.contains(&self.name()) {
            names.push(self.name());
        }
        names
    }

    /// The field of an arch that it is.
    pub(super) fn field(self) -> Option<Field> {
        match self {
            Self::HalfOpening => Some(Field::HalfOpening),
            Self::Friction => Some(Field::Friction),
            Self::FrictionAngle => Some(Field::FrictionAngle),
            Self::GivenThickness => Some(Field::Thickness),
            Self::Size(field) => Some(field),
            _ => None,
        }
    }

    /// Units that its cells may have, the usual one first.
    pub(super) fn units(self) -> &'static [&'static str] {
        match self {
            Self::HalfOpening | Self::FrictionAngle => &["rad", "deg", "gon"],
            Self::Friction => &["deg", "gon"],
            Self::Number(quantity) if quantity.is_angle() => &["rad", "deg"],
            Self::Size(Field::Density) => &["kN/m3", "kg/m3"],
            Self::Size(Field::MeasuredAt) => &[],
            Self::Size(_) | Self::GivenThickness => &["m", "cm", "mm", "ft", "in"],
            _ => &[],
        }
    }

    /// Tells whether the role is about an arch of a given thickness.
    pub fn is_of_thickness(self) -> bool {
        match self {
            Self::GivenThickness => true,
            Self::Number(quantity) => Quantity::ASSESSMENT.contains(&quantity),
            _ => false,
        }
    }

    /// Tells whether the role is something that can be judged.
    pub(crate) fn is_claim(self) -> bool {
        matches!(self, Self::CanStand | Self::Stands | Self::Mode | Self::Number(_))
    }
}
