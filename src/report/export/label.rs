//! What a quantity is called: in files, in words, and in a formula.

use crate::problem::Quantity;

/// The names of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Label {
    /// The name in files; an identifier in every language.
    pub name: &'static str,
    /// The symbol of the paper and the unit, as plain text.
    pub symbol: &'static str,
    /// The same for LaTeX.
    pub latex: &'static str,
}

const fn label(name: &'static str, symbol: &'static str, latex: &'static str) -> Label {
    Label { name, symbol, latex }
}

impl From<Quantity> for Label {
    fn from(quantity: Quantity) -> Self {
        let latex = match quantity {
            Quantity::Thickness => r"$\eta = t/r$",
            Quantity::Friction => r"$\mu$",
            Quantity::FrictionAngle => r"$\varphi$, rad",
            Quantity::FrictionAngleDegrees => r"$\varphi$, deg",
            Quantity::HalfOpening => r"$\alpha$, rad",
            Quantity::HalfOpeningDegrees => r"$\alpha$, deg",
            Quantity::Thrust => r"$h = H/(w r)$",
            Quantity::IntrinsicThrust => r"$\eta h$",
            Quantity::RotationJoint => r"$\beta_r$, rad",
            Quantity::RotationJointDegrees => r"$\beta_r$, deg",
            Quantity::SlidingJoint => r"$\beta_s$, rad",
            Quantity::SlidingJointDegrees => r"$\beta_s$, deg",
            Quantity::OpeningVariable => r"$A = \alpha \cot(\alpha/2)$",
        };
        label(quantity.name(), quantity.symbol(), latex)
    }
}

/// The friction below which no arch of the opening stands.
pub const SLIDING_FRICTION: Label =
    label("sliding_friction", "mu at pure sliding", r"$\mu$ at pure sliding");
/// The friction from which collapse is purely rotational.
pub const ROTATIONAL_FRICTION: Label = label(
    "rotational_friction",
    "mu from which nothing slides",
    r"$\mu$ from which nothing slides",
);
/// The least thickness at which an arch stands.
pub const LEAST_THICKNESS: Label = label("least_thickness", "least eta", r"least $\eta$");
/// The thickness over the least thickness.
pub const GEOMETRIC_SAFETY: Label =
    label("geometric_safety", "eta over least eta", r"$\eta$ over least $\eta$");
/// The least friction with which an arch of given thickness stands.
pub const REQUIRED_FRICTION: Label = label("required_friction", "least mu", r"least $\mu$");
/// The friction over the required one.
pub const FRICTION_SAFETY: Label =
    label("friction_safety", "mu over least mu", r"$\mu$ over least $\mu$");
/// The least and the largest admissible thrust, with the joints that limit them.
pub const THRUST_LIMITS: [[Label; 2]; 2] = [
    [
        label("least_thrust", "least h", r"least $h$"),
        label("least_thrust_joint", "its joint, rad", "its joint, rad"),
    ],
    [
        label("largest_thrust", "largest h", r"largest $h$"),
        label("largest_thrust_joint", "its joint, rad", "its joint, rad"),
    ],
];
