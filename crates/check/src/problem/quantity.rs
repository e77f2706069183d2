//! Quantities of a landmark, of a state and of an arch of a given thickness: one vocabulary.

use crate::arch::Unknown;
use crate::number::{list, worded};

worded! {
    /// A quantity of a landmark, of a state, or of an arch of a given thickness.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum Quantity {
        /// `eta = t/r`, thickness over centreline radius.
        Thickness = ["thickness", "eta = t/r", r"$\eta = t/r$"],
        /// `mu`, the friction coefficient.
        Friction = ["friction", "mu", r"$\mu$"],
        /// `phi = atan(mu)`, rad.
        FrictionAngle = ["friction_angle", "phi, rad", r"$\varphi$, rad"],
        /// `phi` in degrees.
        FrictionAngleDegrees = ["friction_angle_degrees", "phi, deg", r"$\varphi$, deg"],
        /// `alpha`, the half-angle of embrace, rad.
        HalfOpening = ["half_opening", "alpha, rad", r"$\alpha$, rad"],
        /// `alpha` in degrees.
        HalfOpeningDegrees = ["half_opening_degrees", "alpha, deg", r"$\alpha$, deg"],
        /// `h = H/(w r)`, the horizontal thrust.
        Thrust = ["thrust", "h = H/(w r)", r"$h = H/(w r)$"],
        /// `eta h = H/(gamma d r²)`, the intrinsic thrust.
        IntrinsicThrust = ["intrinsic_thrust", "eta h", r"$\eta h$"],
        /// `beta_r`, the inner rotational joint, rad from the crown.
        RotationJoint = ["rotation_joint", "beta_r, rad", r"$\beta_r$, rad"],
        /// `beta_r` in degrees.
        RotationJointDegrees = ["rotation_joint_degrees", "beta_r, deg", r"$\beta_r$, deg"],
        /// `beta_s`, the inner sliding joint, rad from the crown; a mode without one has none.
        SlidingJoint = ["sliding_joint", "beta_s, rad", r"$\beta_s$, rad"],
        /// `beta_s` in degrees.
        SlidingJointDegrees = ["sliding_joint_degrees", "beta_s, deg", r"$\beta_s$, deg"],
        /// `A = alpha cot(alpha/2)`.
        OpeningVariable = ["A", "alpha cot(alpha/2)", r"$A = \alpha \cot(\alpha/2)$"],
        /// `p`, the moment of the forces in the crown about the centre. Like what follows of an asymmetric solution of
        /// (19).
        CrownMoment = ["crown_moment", "p", r"$p$"],
        /// `v`, the vertical force in the crown.
        VerticalForce = ["vertical_force", "v", r"$v$"],
        /// `b0`, the hinge right of the crown, rad from there.
        CrownHinge = ["crown_hinge", "b0, rad", r"$b_0$, rad"],
        /// `b0` in degrees.
        CrownHingeDegrees = ["crown_hinge_degrees", "b0, deg", r"$b_0$, deg"],
        /// The slip of the shoulder where the hinge next to the crown turns by one.
        ShoulderSlip = ["shoulder_slip", "slip of the shoulder", "slip of the shoulder"],
        /// The opening of the shoulder then.
        ShoulderOpening = ["shoulder_opening", "opening of the shoulder", "opening of the shoulder"],
        /// The slip of the inner joint then.
        InnerSlip = ["inner_slip", "slip of the inner joint", "slip of the inner joint"],
        /// The power of the weight then, which is that of friction.
        Power = ["power", "w r", r"$w r$"],
        /// The friction below which no arch of this half opening stands.
        SlidingFriction = ["sliding_friction", "mu at pure sliding", r"$\mu$ at pure sliding"],
        /// The friction from which collapse is purely rotational; infinite where none is enough.
        RotationalFriction =
            ["rotational_friction", "mu from which nothing slides", r"$\mu$ from which nothing slides"],
        /// The largest thickness of an asymmetric solution of (19) that is found for an arch that stands.
        AsymmetricThickness = ["asymmetric_thickness", "eta of (19)", r"$\eta$ of (19)"],
        /// The least thickness at which an arch stands.
        LeastThickness = ["least_thickness", "least eta", r"least $\eta$"],
        /// The thickness over the least thickness.
        GeometricSafety = ["geometric_safety", "eta over least eta", r"$\eta$ over least $\eta$"],
        /// The least friction with which an arch of given thickness stands.
        RequiredFriction = ["required_friction", "least mu", r"least $\mu$"],
        /// The friction over the required one.
        FrictionSafety = ["friction_safety", "mu over least mu", r"$\mu$ over least $\mu$"],
        /// The least admissible thrust.
        LeastThrust = ["least_thrust", "least h", r"least $h$"],
        /// The joint that limits it, rad.
        LeastThrustJoint = ["least_thrust_joint", "its joint, rad", "its joint, rad"],
        /// The largest admissible thrust; infinite where it has no bound.
        LargestThrust = ["largest_thrust", "largest h", r"largest $h$"],
        /// The joint that limits it, rad.
        LargestThrustJoint = ["largest_thrust_joint", "its joint, rad", "its joint, rad"],
        /// The span of the circle that is measured, m.
        Span = ["span_m", "span, m", "span, m"],
        /// The rise of that circle, m.
        Rise = ["rise_m", "rise, m", "rise, m"],
        /// The radius of the centreline, m.
        Radius = ["radius_m", "r, m", r"$r$, m"],
        /// The thickness that an arch has, m.
        GivenThicknessInMetres = ["thickness_m", "t, m", r"$t$, m"],
        /// The thickness that an arch has, over the radius of the centreline.
        GivenThickness = ["thickness_ratio", "t/r", "$t/r$"],
        /// The least thickness, m.
        ThicknessInMetres = ["least_thickness_m", "least t, m", r"least $t$, m"],
        /// The weight of the whole arch, kN.
        Weight = ["weight_kn", "2 w r alpha, kN", r"$2 w r \alpha$, kN"],
        /// The horizontal thrust, kN.
        Force = ["thrust_kn", "H, kN", r"$H$, kN"],
        /// The vertical force in the crown, kN.
        VerticalForceInKilonewtons = ["vertical_force_kn", "V, kN", r"$V$, kN"],
        /// The least admissible thrust, kN.
        LeastForce = ["least_thrust_kn", "least H, kN", r"least $H$, kN"],
        /// The largest admissible one, kN; infinite where it has no bound.
        LargestForce = ["largest_thrust_kn", "largest H, kN", r"largest $H$, kN"],
    }
    /// All of them, in order.
    pub const ALL;
    /// The one place where a quantity gets its names.
    fn row -> [&'static str; 3];
}

/// A list with the asymmetric thickness behind it.
const fn and_asymmetric<const N: usize, const M: usize>(list: [Quantity; N]) -> [Quantity; M] {
    let mut all = [Quantity::AsymmetricThickness; M];
    let mut k = 0;
    while k < N {
        all[k] = list[k];
        k += 1;
    }
    all
}

impl Quantity {
    /// Quantities that a landmark can have, in the order in which it is shown.
    pub const LANDMARK: [Self; 13] = list![Quantity:
        Thickness Friction FrictionAngle FrictionAngleDegrees HalfOpening HalfOpeningDegrees Thrust
        IntrinsicThrust RotationJoint RotationJointDegrees SlidingJoint SlidingJointDegrees OpeningVariable
    ];

    /// Quantities that an asymmetric solution of (19) has besides; its haunch is the rotational joint.
    pub const ASYMMETRIC: [Self; 8] = list![Quantity:
        CrownMoment VerticalForce CrownHinge CrownHingeDegrees ShoulderSlip ShoulderOpening InnerSlip Power
    ];

    /// Quantities that the state of an arch at its least thickness can have, in the order in which it is shown.
    pub const STATE: [Self; 7] = list![Quantity:
        Thickness Thrust IntrinsicThrust RotationJoint SlidingJoint SlidingFriction RotationalFriction
    ];

    /// Quantities shown of a state that is found from its thickness, its friction or its mode.
    pub const FOUND: [Self; 7] = list![Quantity:
        HalfOpening HalfOpeningDegrees Friction Thickness Thrust RotationJoint SlidingJoint
    ];

    /// Quantities that can be asked of an arch of a given thickness, in the order in which it is shown. With
    /// a thrust comes the [joint](Self::joint) that limits it.
    pub const ASSESSMENT: [Self; 6] = list![Quantity:
        LeastThickness GeometricSafety RequiredFriction FrictionSafety LeastThrust LargestThrust
    ];

    /// Quantities that rows of arrays and sweeps may ask of a state. Elsewhere the asymmetric thickness goes
    /// with each verdict, asked or not.
    pub const STATE_ROW: [Self; 8] = and_asymmetric(Self::STATE);

    /// Quantities that rows of arrays and sweeps may ask of an arch of a given thickness.
    pub const ASSESSMENT_ROW: [Self; 7] = and_asymmetric(Self::ASSESSMENT);

    /// Quantities told besides of an arch that is [measured](super::measures), at its least thickness.
    pub const MEASURED_STATE: [Self; 7] = list![Quantity:
        Span Rise HalfOpeningDegrees Radius ThicknessInMetres Weight Force
    ];

    /// Quantities told besides of an arch that is measured, at a given thickness: the radius and the weight
    /// are at that, the least thickness is of an arch with the same measures.
    pub const MEASURED_ASSESSMENT: [Self; 10] = list![Quantity:
        Span Rise HalfOpeningDegrees Radius GivenThicknessInMetres GivenThickness ThicknessInMetres Weight
        LeastForce LargestForce
    ];

    /// Quantities that can be asked of an arch, of a given thickness or at its least one; `forces` tells of one that is
    /// measured whether it has any.
    pub fn of_arch(has_thickness: bool, forces: Option<bool>) -> Vec<Self> {
        let [usual, measured] = match has_thickness {
            true => [&Self::ASSESSMENT[..], &Self::MEASURED_ASSESSMENT],
            false => [&Self::STATE[..], &Self::MEASURED_STATE],
        };
        let is_told = |of: &&Self| forces.is_some_and(|has| has || !of.is_force());
        usual.iter().chain(measured.iter().filter(is_told)).copied().collect()
    }

    /// The name used in files and on the command line; stable, and an identifier in every language.
    pub const fn name(self) -> &'static str {
        self.row()[0]
    }

    /// The paper's letter for it, as people type it.
    pub const fn letter(self) -> Option<&'static str> {
        match self {
            Self::Thickness => Some("eta"),
            Self::Friction => Some("mu"),
            Self::FrictionAngle => Some("phi"),
            Self::HalfOpening => Some("alpha"),
            Self::Thrust => Some("h"),
            Self::RotationJoint => Some("beta_r"),
            Self::SlidingJoint => Some("beta_s"),
            _ => None,
        }
    }

    /// The quantity of a name or of a letter of the paper.
    pub fn named(name: &str) -> Option<Self> {
        let all = Self::LANDMARK.into_iter().chain(Self::STATE_ROW).chain(Self::ASSESSMENT);
        let mut all = all.chain(Self::MEASURED_STATE).chain(Self::MEASURED_ASSESSMENT);
        all.find(|quantity| quantity.name() == name || quantity.letter() == Some(name))
    }

    /// The symbol of the paper and the unit.
    pub const fn symbol(self) -> &'static str {
        self.row()[1]
    }

    /// Symbol for LaTeX.
    pub const fn latex(self) -> &'static str {
        self.row()[2]
    }

    /// The quantity in radians of which this is the value in degrees.
    pub fn in_radians(self) -> Option<Self> {
        match self {
            Self::FrictionAngleDegrees => Some(Self::FrictionAngle),
            Self::HalfOpeningDegrees => Some(Self::HalfOpening),
            Self::RotationJointDegrees => Some(Self::RotationJoint),
            Self::SlidingJointDegrees => Some(Self::SlidingJoint),
            Self::CrownHingeDegrees => Some(Self::CrownHinge),
            _ => None,
        }
    }

    /// Tells whether the quantity is an angle in radians.
    pub fn is_angle(self) -> bool {
        matches!(
            self,
            Self::FrictionAngle
                | Self::HalfOpening
                | Self::RotationJoint
                | Self::SlidingJoint
                | Self::CrownHinge
        )
    }

    /// Tells whether the quantity is a friction at which the mode changes, which the proof of a state does not need.
    pub fn is_friction(self) -> bool {
        matches!(self, Self::SlidingFriction | Self::RotationalFriction)
    }

    /// Tells whether the quantity is of an arch that is measured.
    pub fn is_measured(self) -> bool {
        Self::MEASURED_STATE.contains(&self) || Self::MEASURED_ASSESSMENT.contains(&self)
    }

    /// Tells whether the quantity is in kilonewtons.
    pub fn is_force(self) -> bool {
        use Quantity::*;
        matches!(self, Weight | Force | VerticalForceInKilonewtons | LeastForce | LargestForce)
    }

    /// The joint that limits a thrust.
    pub fn joint(self) -> Option<Self> {
        match self {
            Self::LeastThrust => Some(Self::LeastThrustJoint),
            Self::LargestThrust => Some(Self::LargestThrustJoint),
            _ => None,
        }
    }

    /// Tells whether who asks for this quantity is told another: the same, with a thrust the joint that limits it,
    /// and as the least thickness the thickness of a state.
    pub fn tells(self, of: Self) -> bool {
        let is_least = self == Self::LeastThickness && of == Self::Thickness;
        self == of || self.joint() == Some(of) || is_least
    }

    /// The variable that a system has to know for the quantity to exist; `None` for what is no value of one
    /// configuration.
    pub fn variable(self) -> Option<Unknown> {
        use Quantity::*;
        match self {
            Thickness => Some(Unknown::Thickness),
            Friction | FrictionAngle | FrictionAngleDegrees => Some(Unknown::Friction),
            HalfOpening | HalfOpeningDegrees | OpeningVariable => Some(Unknown::HalfOpening),
            Thrust | IntrinsicThrust => Some(Unknown::Thrust),
            RotationJoint | RotationJointDegrees => Some(Unknown::RotationJoint),
            SlidingJoint | SlidingJointDegrees => Some(Unknown::SlidingJoint),
            CrownMoment => Some(Unknown::CrownMoment),
            VerticalForce => Some(Unknown::VerticalForce),
            CrownHinge | CrownHingeDegrees => Some(Unknown::CrownHinge),
            // A rate, a safety, a length or a force is none, nor is what is another state's.
            _ => None,
        }
    }
}
