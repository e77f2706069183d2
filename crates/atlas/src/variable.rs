//! The variables of the curves' equations.

use crate::number::worded;

worded! {
    /// A variable of a form.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Variable {
        /// `alpha`, the half opening, rad.
        HalfOpening = "half_opening",
        /// `phi`, the friction angle, rad.
        FrictionAngle = "friction_angle",
        /// `chi`, the inclination of the force on the joint that slides, rad.
        Inclination = "inclination",
        /// `b = beta_r²`, rad².
        JointSquare = "rotation_joint_squared",
        /// `eta`, the thickness.
        Thickness = "thickness",
        /// `q = (alpha - phi)/chi`, of a flat arch that slides.
        Ratio = "inclination_ratio",
        /// `p = alpha/chi`, of a flat arch that turns at the haunch.
        OpeningRatio = "opening_ratio",
        /// `s = beta_r²/chi²`, of the same.
        JointRatio = "joint_ratio",
        /// `v`, the vertical force in the crown of an asymmetric state.
        VerticalForce = "vertical_force",
        /// `p`, the moment in the crown of the same.
        CrownMoment = "crown_moment",
        /// `b0`, the hinge next to the crown of the same, rad.
        CrownHinge = "crown_hinge",
    }
    /// All of them, in order.
    pub const ALL;
    /// The name used in files and on the command line.
    pub fn name -> &'static str;
}

impl Variable {
    /// The variables in which a map is drawn: a tube is as narrow in these as was asked.
    pub const PLANE: [Self; 3] = [Self::HalfOpening, Self::FrictionAngle, Self::Thickness];
}
