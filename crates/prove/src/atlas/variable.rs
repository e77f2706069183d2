//! The variables of the curves' equations.

/// A variable of a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Variable {
    /// `alpha`, the half opening, rad.
    HalfOpening,
    /// `phi`, the friction angle, rad.
    FrictionAngle,
    /// `chi`, the inclination of the force on the joint that slides, rad.
    Inclination,
    /// `b = beta_r²`, rad².
    JointSquare,
    /// `eta`, the thickness.
    Thickness,
    /// `q = (alpha - phi)/chi`, of a flat arch that slides.
    Ratio,
    /// `p = alpha/chi`, of a flat arch that turns at the haunch.
    OpeningRatio,
    /// `s = beta_r²/chi²`, of the same.
    JointRatio,
    /// `v`, the vertical force in the crown of an asymmetric state.
    VerticalForce,
    /// `p`, the moment in the crown of the same.
    CrownMoment,
    /// `b0`, the hinge next to the crown of the same, rad.
    CrownHinge,
}

impl Variable {
    /// The variables in which a map is drawn: a tube is as narrow in these as was asked.
    pub const PLANE: [Self; 3] = [Self::HalfOpening, Self::FrictionAngle, Self::Thickness];

    /// The name used in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::HalfOpening => "half_opening",
            Self::FrictionAngle => "friction_angle",
            Self::Inclination => "inclination",
            Self::JointSquare => "rotation_joint_squared",
            Self::Thickness => "thickness",
            Self::Ratio => "inclination_ratio",
            Self::OpeningRatio => "opening_ratio",
            Self::JointRatio => "joint_ratio",
            Self::VerticalForce => "vertical_force",
            Self::CrownMoment => "crown_moment",
            Self::CrownHinge => "crown_hinge",
        }
    }
}
