//! The lines of the map, on each of which one mode becomes another.
//!
//! | line | equations | what is fixed |
//! |---|---|---|
//! | `[r,r,r]/[s,r,r]` | (2), (4), (5), (17) | |
//! | `[r,r,r]/[r,r,s]` | (2), (4), (5), (18) | |
//! | `[s,r,r]/[s,s]` | (2), (5), (17), (18) | |
//! | `[r,r,s]/[s,s]`, `[r,s,r]/[s,s]` | (3), (5), (17), (18) | |
//! | `[r,s]/[s,s]` | (3), (17), (18) | `beta_r = 0` |
//! | `[r,r,s]/[r,s,r]` | (3), (5), (18) | `beta_r = beta_s` |
//! | `[r,s,r]/[r,s]` | (3), (5) at `beta_r -> 0`, (18) | `beta_r = 0` |
//!
//! A line has one unknown more than equations: at a half opening the friction is solved for, at a friction
//! the half opening.

use super::Mode::*;
use super::system::system;
use super::{Condition, Landmark, Mode, Quantity, System};
use crate::arch::{SelfWeight, Unknown};
use crate::number::{says, shown, worded};
use std::fmt;

worded! {
    /// A line of the map.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Line {
        /// `[r,r,r]/[s,r,r]`: the shoulder begins to slide.
        RotationShoulder = [Rotational, SlidingRotational],
        /// `[r,r,r]/[r,r,s]`: an inner joint begins to slide.
        RotationInner = [Rotational, RotationalSliding],
        /// `[s,r,r]/[s,s]`: nothing stands below.
        ShoulderEnd = [SlidingRotational, Sliding],
        /// `[r,r,s]/[s,s]`: nothing stands below.
        AboveHaunchEnd = [RotationalSliding, Sliding],
        /// `[r,s,r]/[s,s]`: nothing stands below.
        BelowHaunchEnd = [RotationalSlidingRotational, Sliding],
        /// `[r,s]/[s,s]`: nothing stands below.
        CrownEnd = [OverturningSliding, Sliding],
        /// `[r,r,s]/[r,s,r]`: the rotational and the sliding joint coincide.
        Joints = [RotationalSliding, RotationalSlidingRotational],
        /// `[r,s,r]/[r,s]`: the rotational joint reaches the crown.
        Crown = [RotationalSlidingRotational, OverturningSliding],
    }
    /// All lines.
    pub const ALL;
    /// The modes on its two sides: the first where there is more friction, or the narrower half opening.
    pub fn modes -> [Mode; 2];
}

impl Line {
    /// The landmarks between which the line runs; some begin where the half opening is zero.
    pub fn ends(self) -> [Option<Landmark>; 2] {
        use Landmark::*;
        match self {
            Self::RotationShoulder | Self::ShoulderEnd => [None, Some(Triple)],
            Self::RotationInner => [Some(Triple), Some(RotationEnd)],
            Self::AboveHaunchEnd => [Some(Triple), Some(Shift)],
            Self::BelowHaunchEnd => [Some(Shift), Some(Junction)],
            Self::CrownEnd => [Some(Junction), Some(Border)],
            Self::Joints => [Some(Shift), Some(RotationEnd)],
            Self::Crown => [Some(Junction), Some(RotationEnd)],
        }
    }

    /// The condition of each mode that is zero on the line. A mode whose equations have a form of their own
    /// there, as at the crown, has none.
    pub fn ties(self) -> [Option<Condition>; 2] {
        use Condition as C;
        match self {
            Self::RotationShoulder => [Some(C::FrictionAtShoulder), Some(C::ExtradosAtShoulder)],
            Self::RotationInner => [Some(C::FrictionInside), Some(C::ExtradosAtCrown)],
            Self::ShoulderEnd => [Some(C::FrictionInside), None],
            Self::AboveHaunchEnd | Self::BelowHaunchEnd | Self::CrownEnd => {
                [Some(C::FrictionAtShoulder), None]
            }
            Self::Joints => [Some(C::SlidesAboveHaunch), Some(C::SlidesBelowHaunch)],
            Self::Crown => [Some(C::Above(Unknown::RotationJoint)), Some(C::IntradosAtCrown)],
        }
    }

    /// The points of the line at a given half opening, or at a given friction: `sought` is the other one.
    pub fn system(self, weight: SelfWeight, sought: Sought) -> System {
        /// The system with either of the two before the other unknowns.
        macro_rules! with {
            ($($unknown:ident)+; $($rest:tt)*) => {
                match sought {
                    Sought::HalfOpening => system!(weight; HalfOpening $($unknown)+; $($rest)*),
                    Sought::Friction => system!(weight; Friction $($unknown)+; $($rest)*),
                }
            };
        }
        match self {
            Self::RotationShoulder => {
                with!(RotationJoint Thickness Thrust; LowerThrust WholeThrust Tangency ShoulderSliding;)
            }
            Self::RotationInner => with! {
                RotationJoint SlidingJoint Thickness Thrust; LowerThrust WholeThrust Tangency InnerSliding Steepest;
            },
            Self::ShoulderEnd => with! {
                RotationJoint SlidingJoint Thickness Thrust; LowerThrust Tangency ShoulderSliding InnerSliding Steepest;
            },
            Self::AboveHaunchEnd | Self::BelowHaunchEnd => with! {
                RotationJoint SlidingJoint Thickness Thrust; UpperThrust Tangency ShoulderSliding InnerSliding Steepest;
            },
            Self::CrownEnd => with! {
                SlidingJoint Thickness Thrust; UpperThrust ShoulderSliding InnerSliding Steepest;
                RotationJoint = Integer(0)
            },
            Self::Joints => with! {
                SlidingJoint Thickness Thrust; UpperThrust Tangency InnerSliding Steepest;
                RotationJoint = SameAs(Unknown::SlidingJoint)
            },
            Self::Crown => with! {
                SlidingJoint Thickness Thrust; UpperThrust TangencyAtCrown InnerSliding Steepest;
                RotationJoint = Integer(0)
            },
        }
    }
}

worded! {
    /// Unknowns that can be asked for in place of the least thickness.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Sought {
        /// The half opening.
        HalfOpening = Unknown::HalfOpening.name(),
        /// The friction coefficient.
        Friction = Unknown::Friction.name(),
    }
    /// All of them, in order.
    pub const ALL;
    /// The name used in files and on the command line.
    pub fn name -> &'static str;
}

impl Sought {
    /// Quantities in which it is told.
    pub const fn quantities(self) -> &'static [Quantity] {
        match self {
            Self::HalfOpening => &[Quantity::HalfOpening, Quantity::HalfOpeningDegrees],
            Self::Friction => &[Quantity::Friction],
        }
    }
}

/// Reason why a text names no line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoLine {
    text: String,
}

says!(NoLine {
    Self { text } => "'{text}' names no two modes that meet: {}", Line::ALL.map(|line| line.to_string()).join(", ");
});

impl std::str::FromStr for Line {
    type Err = NoLine;

    /// Reads two modes that meet, in either order, with or without brackets and commas: `rrs/rsr`,
    /// `[r,r,s]/[r,s,r]`.
    fn from_str(text: &str) -> Result<Self, NoLine> {
        let short = |text: &str| text.replace(['[', ']', ',', ' '], "").to_lowercase();
        let mut asked: Vec<String> = text.split('/').map(short).collect();
        asked.sort();
        let is_asked = |line: &Self| {
            let mut modes = line.modes().map(|mode| short(mode.label()));
            modes.sort();
            modes[..] == asked[..]
        };
        let no_line = || NoLine { text: shown(text) };
        Self::ALL.into_iter().find(is_asked).ok_or_else(no_line)
    }
}

impl fmt::Display for Line {
    /// The modes without brackets: `rrs/rsr`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [first, second] = self.modes().map(|mode| mode.label().replace(['[', ']', ','], ""));
        f.pad(&format!("{first}/{second}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_read_in_any_spelling() {
        for line in Line::ALL {
            assert_eq!(line.to_string().parse(), Ok(line));
            let [first, second] = line.modes();
            assert_eq!(format!("{second} / {first}").parse(), Ok(line));
        }
        for wrong in ["", "rrr", "rrr/rrr", "rrr/ss", "rrs/rsr/rs", "r/rrr"] {
            assert!(wrong.parse::<Line>().is_err(), "{wrong}");
        }
        // Control characters are not handed on.
        let hostile = "\u{1b}[2J\n".parse::<Line>().unwrap_err().to_string();
        assert!(hostile.starts_with("'\\u{1b}[2J\\n' names no two"), "{hostile}");
    }

    #[test]
    fn every_system_is_square_and_solves_for_what_is_sought() {
        for line in Line::ALL {
            for (sought, unknown) in
                [(Sought::HalfOpening, Unknown::HalfOpening), (Sought::Friction, Unknown::Friction)]
            {
                let system = line.system(SelfWeight::Heyman, sought);
                assert_eq!(system.unknowns.len(), system.equations.len(), "{line}");
                assert_eq!(system.unknowns[0], unknown);
            }
        }
    }

    /// At the end of a line both its modes are among those that meet there, but for `l`.
    #[test]
    fn a_line_ends_where_its_modes_meet() {
        for line in Line::ALL {
            for end in line.ends().into_iter().flatten().filter(|l| *l != Landmark::RotationEnd) {
                assert!(line.modes().iter().all(|mode| end.modes().contains(mode)), "{line}");
            }
        }
    }

    /// The conditions that are zero on a line are conditions of its modes, but for the crown's haunch.
    #[test]
    fn what_ties_is_a_condition_of_the_mode() {
        for line in Line::ALL {
            for (mode, tie) in line.modes().into_iter().zip(line.ties()) {
                if let Some(tie) = tie {
                    assert!(Condition::of(mode, true).any(|c| c == tie), "{line} {mode} {tie:?}");
                }
            }
        }
    }
}
