//! The claim of a certificate, in the words of the file.

use super::given::{friction_text, given_text, read_friction, read_given};
use super::record::record;
use super::refusal::Refusal;
use super::visible::shortened;
use crate::arch::asymmetric::{AsymmetricMode, Place};
use crate::arch::mechanism::Contact;
use crate::arch::whole::Side;
use crate::arch::{SelfWeight, Unknown};
use crate::number::{Dyadic, ExactNumber};
use crate::problem::{
    Arch, ArchError, Equation, Landmark, Mode, Nearest, Problem, Standing, System, Verdict,
    is_thickness,
};

record! {
    /// Claim in names and text: of its seven subjects exactly one.
    #[derive(Default)]
    pub struct ClaimFile {
        /// `heyman` or `milankovitch`.
        pub weight: String,
        /// The symbol of a landmark.
        pub landmark: Option<String>,
        /// The state of an arch at its least thickness.
        pub state: Option<StateFile>,
        /// An arch that stands at no thickness for want of friction.
        pub slides: Option<ArchFile>,
        /// An arch that stands at no thickness as it is too wide.
        pub too_wide: Option<ArchFile>,
        /// An arch that is thinner than its least thickness.
        pub too_thin: Option<TooThinFile>,
        /// An arch that stands.
        pub stands: Option<StandsFile>,
        /// An asymmetric solution of the complementarity problem (19) of a whole arch.
        pub asymmetric: Option<AsymmetricFile>,
        /// The names of what is solved for, in the order of every vector.
        pub unknowns: Vec<String>,
        /// The labels of what holds.
        pub equations: Vec<String>,
    }
}

record! {
    /// An arch of any thickness.
    pub struct ArchFile {
        /// The half opening, rad: a fraction of integers, with ` pi` behind it if pi is a factor.
        pub half_opening: String,
        /// The friction coefficient in the same form, `tan` and an angle in that form, or `inf`.
        pub friction: String,
    }
}

record! {
    /// The state of an arch.
    pub struct StateFile {
        /// The label of the mode.
        pub mode: String,
        /// Half opening as in [`ArchFile`].
        pub half_opening: String,
        /// Friction as in [`ArchFile`].
        pub friction: String,
    }
}

record! {
    /// An arch and how it collapses at its least thickness, which is above its own.
    pub struct TooThinFile {
        /// The label of the mode.
        pub mode: String,
        /// Half opening as in [`ArchFile`].
        pub half_opening: String,
        /// Friction as in [`ArchFile`].
        pub friction: String,
        /// The thickness, a fraction of integers.
        pub thickness: String,
    }
}

record! {
    /// An arch and an admissible state of it.
    pub struct StandsFile {
        /// Half opening as in [`ArchFile`].
        pub half_opening: String,
        /// Friction as in [`ArchFile`].
        pub friction: String,
        /// The thickness, a fraction of integers.
        pub thickness: String,
        /// The thrust `h`.
        pub thrust: Dyadic,
        /// The crown moment `p = h (1 + e0)`.
        pub crown_moment: Dyadic,
        /// `crown`, `haunch` or `shoulder`: where the moment about the intrados is least, a hint.
        pub nearest: String,
    }
}

record! {
    /// An arch and how it gives way on one side.
    pub struct AsymmetricFile {
        /// `inner_sliding`, `shoulder_opening` or `shoulder_sliding`: how the mechanism closes.
        pub mode: String,
        /// Half opening as in [`ArchFile`].
        pub half_opening: String,
        /// Friction as in [`ArchFile`], and limited.
        pub friction: String,
        /// The joints that give way, from the right springing to the left: how, on which side, and where.
        pub contacts: Vec<String>,
    }
}

impl ClaimFile {
    /// The problem in the words of the file.
    pub fn new(problem: &Problem) -> Self {
        let system = problem.system();
        let claim = Self {
            weight: system.weight.name().to_owned(),
            unknowns: system.unknowns.iter().map(|unknown| unknown.name().to_owned()).collect(),
            equations: system.equations.iter().map(|e| e.label().to_owned()).collect(),
            ..Self::default()
        };
        match problem {
            Problem::Landmark { landmark, .. } => {
                Self { landmark: Some(landmark.symbol().to_owned()), ..claim }
            }
            Problem::State { mode, arch } => {
                let ArchFile { half_opening, friction } = ArchFile::new(arch);
                let mode = mode.label().to_owned();
                Self { state: Some(StateFile { mode, half_opening, friction }), ..claim }
            }
            Problem::Asymmetric { mode, arch } => {
                let ArchFile { half_opening, friction } = ArchFile::new(arch);
                let (contacts, mode) = (contacts(*mode), mode.name().to_owned());
                let file = AsymmetricFile { mode, half_opening, friction, contacts };
                Self { asymmetric: Some(file), ..claim }
            }
            Problem::Verdict { verdict, arch } => {
                let given = ArchFile::new(arch);
                let ArchFile { half_opening, friction } = given.clone();
                match verdict {
                    Verdict::Slides => Self { slides: Some(given), ..claim },
                    Verdict::TooWide => Self { too_wide: Some(given), ..claim },
                    Verdict::TooThin { mode, thickness } => {
                        let (mode, thickness) = (mode.label().to_owned(), given_text(thickness));
                        let file = TooThinFile { mode, half_opening, friction, thickness };
                        Self { too_thin: Some(file), ..claim }
                    }
                    Verdict::Stands(standing) => {
                        let file = StandsFile {
                            half_opening,
                            friction,
                            thickness: given_text(&standing.thickness),
                            thrust: standing.thrust.clone(),
                            crown_moment: standing.crown_moment.clone(),
                            nearest: standing.nearest.name().to_owned(),
                        };
                        Self { stands: Some(file), ..claim }
                    }
                }
            }
        }
    }

    /// The problem, if every name is known and the unknowns and equations are those of the subject.
    pub fn resolve(&self) -> Result<Problem, Refusal> {
        let weight = named("weight", &self.weight, SelfWeight::ALL, SelfWeight::name)?;
        let Self { landmark, state, slides, too_wide, too_thin, stands, asymmetric, .. } = self;
        let subjects = [
            landmark.as_ref().map(|symbol| {
                let landmark = named("landmark", symbol, Landmark::ALL, Landmark::symbol)?;
                Ok(Problem::Landmark { landmark, weight })
            }),
            state.as_ref().map(|state| {
                let arch = arch(weight, &state.half_opening, &state.friction)?;
                Ok(Problem::State { mode: mode(&state.mode, &arch, &state.friction)?, arch })
            }),
            slides.as_ref().map(|slides| {
                let arch = limited_arch(weight, &slides.half_opening, &slides.friction)?;
                Ok(Problem::Verdict { verdict: Verdict::Slides, arch })
            }),
            too_wide.as_ref().map(|wide| {
                let arch = arch(weight, &wide.half_opening, &wide.friction)?;
                Ok(Problem::Verdict { verdict: Verdict::TooWide, arch })
            }),
            too_thin.as_ref().map(|thin| {
                let arch = arch(weight, &thin.half_opening, &thin.friction)?;
                let mode = mode(&thin.mode, &arch, &thin.friction)?;
                let thickness = thickness(&thin.thickness)?;
                Ok(Problem::Verdict { verdict: Verdict::TooThin { mode, thickness }, arch })
            }),
            stands.as_ref().map(|stands| {
                let arch = arch(weight, &stands.half_opening, &stands.friction)?;
                let standing = Standing {
                    thickness: thickness(&stands.thickness)?,
                    thrust: stands.thrust.clone(),
                    crown_moment: stands.crown_moment.clone(),
                    nearest: named("place", &stands.nearest, Nearest::ALL, Nearest::name)?,
                };
                Ok(Problem::Verdict { verdict: Verdict::Stands(standing), arch })
            }),
            asymmetric.as_ref().map(|asymmetric| {
                let arch = limited_arch(weight, &asymmetric.half_opening, &asymmetric.friction)?;
                let (all, name) = (AsymmetricMode::ALL, AsymmetricMode::name);
                let mode = named("mode", &asymmetric.mode, all, name)?;
                let expected = contacts(mode);
                match asymmetric.contacts == expected {
                    true => Ok(Problem::Asymmetric { mode, arch }),
                    false => Err(mismatch("contacts", &expected)),
                }
            }),
        ];
        let mut subjects = subjects.into_iter().flatten();
        let (Some(problem), None) = (subjects.next(), subjects.next()) else {
            return Err(Refusal::Subject);
        };
        let problem = problem?;
        self.require_system(problem.system())?;
        Ok(problem)
    }

    /// Refuses a system other than the one that the claim names: its unknowns and its equations, in their order.
    fn require_system(&self, system: System) -> Result<(), Refusal> {
        let System { unknowns, equations, .. } = system;
        let unknowns: Vec<&str> = unknowns.iter().copied().map(Unknown::name).collect();
        let equations: Vec<&str> = equations.iter().copied().map(Equation::label).collect();
        for (place, given, expected) in
            [("unknowns", &self.unknowns, unknowns), ("equations", &self.equations, equations)]
        {
            if *given != expected {
                return Err(mismatch(place, &expected));
            }
        }
        Ok(())
    }
}

impl ArchFile {
    fn new(arch: &Arch) -> Self {
        let half_opening = given_text(arch.half_opening());
        Self { half_opening, friction: friction_text(arch.friction()) }
    }
}

fn named<T: Copy, const N: usize>(
    place: &'static str,
    text: &str,
    all: [T; N],
    name: fn(T) -> &'static str,
) -> Result<T, Refusal> {
    all.into_iter()
        .find(|x| name(*x) == text)
        .ok_or_else(|| Refusal::Name { place, text: shortened(text) })
}

fn mismatch(place: &'static str, expected: &[impl AsRef<str>]) -> Refusal {
    let expected: Vec<&str> = expected.iter().map(AsRef::as_ref).collect();
    Refusal::Mismatch { place, expected: expected.join(", ") }
}

/// The joints that give way, in words.
fn contacts(mode: AsymmetricMode) -> Vec<String> {
    let words = |(contact, side, place): &(Contact, Side, Place)| {
        format!("{}, {} {}", contact.name(), side.name(), place.name())
    };
    mode.contacts().iter().map(words).collect()
}

fn refused(place: &'static str, text: &str) -> Refusal {
    Refusal::Given { place, text: shortened(text) }
}

/// The arch of a claim.
fn arch(weight: SelfWeight, half_opening: &str, friction: &str) -> Result<Arch, Refusal> {
    let mu = read_friction(friction).ok_or_else(|| refused("friction", friction))?;
    let alpha = read_given(half_opening).ok_or_else(|| refused("half_opening", half_opening))?;
    Arch::new_with(weight, alpha, mu, false).map_err(|error| match error {
        ArchError::HalfOpening(_) => refused("half_opening", half_opening),
        _ => refused("friction", friction),
    })
}

/// The arch of a claim that is made of a limited friction alone.
fn limited_arch(weight: SelfWeight, half_opening: &str, friction: &str) -> Result<Arch, Refusal> {
    let arch = arch(weight, half_opening, friction)?;
    Some(arch).filter(Arch::is_limited).ok_or_else(|| refused("friction", friction))
}

/// The mode of a claim: one that has a thickness, and exists with the friction.
fn mode(label: &str, arch: &Arch, friction: &str) -> Result<Mode, Refusal> {
    let mode = named("mode", label, Mode::ALL, Mode::label)?;
    if mode == Mode::Sliding {
        return Err(Refusal::Name { place: "mode", text: label.to_owned() });
    }
    match mode.exists_with(arch.is_limited()) {
        true => Ok(mode),
        false => Err(refused("friction", friction)),
    }
}

/// A thickness above 0 and up to the physical limit 2.
fn thickness(text: &str) -> Result<ExactNumber, Refusal> {
    read_given(text).filter(is_thickness).ok_or_else(|| refused("thickness", text))
}
