//! An arch that is drawn: at its least thickness, at a landmark, as it stands, or where it slides.

use super::computable::Computable;
use super::same::{arch_key, number_key};
use crate::arch::SelfWeight;
use crate::ask::{ArchGiven, Misfit};
use crate::atlas::{NoSketch, Sketch};
use crate::number::ExactNumber;
use crate::problem::{Arch, Landmark};

/// An arch that is drawn.
#[derive(Clone, Debug)]
pub struct DrawnArch {
    /// The arch, and the state in which it is drawn.
    pub pose: Pose,
    /// Number of stones, if the joints are between them alone.
    pub stones: Option<u64>,
    /// True if sliding joints open too.
    pub is_dilatant: bool,
}

/// An arch, and in which of its states it is drawn.
#[derive(Clone, Debug)]
pub enum Pose {
    /// At its least thickness.
    Least(Arch),
    /// At a landmark.
    Landmark(Landmark, SelfWeight),
    /// As it stands, with a thickness.
    Standing(Arch, ExactNumber),
    /// At the friction at which it slides, with a thickness; the friction of the arch is not read.
    Sliding(Arch, ExactNumber),
}

impl Pose {
    /// Pose of an arch as it is given: as it stands, at its least thickness where it has none, or where it slides.
    pub fn of(given: &ArchGiven, weight: SelfWeight, slides: bool) -> Result<Self, Misfit> {
        let arch = given.arch(weight)?;
        Ok(match given.thickness.clone() {
            Some(thickness) if slides => Self::Sliding(arch, thickness),
            Some(thickness) => Self::Standing(arch, thickness),
            None => Self::Least(arch),
        })
    }
}

impl DrawnArch {
    /// The self-weight model.
    pub fn weight(&self) -> SelfWeight {
        match &self.pose {
            Pose::Landmark(_, weight) => *weight,
            Pose::Least(arch) | Pose::Standing(arch, _) | Pose::Sliding(arch, _) => arch.weight(),
        }
    }

    /// Proves what is drawn.
    pub fn sketch(&self) -> Result<Sketch, NoSketch> {
        let is_dilatant = self.is_dilatant;
        match (&self.pose, self.stones) {
            (Pose::Landmark(landmark, weight), _) => {
                Sketch::landmark(*landmark, *weight, is_dilatant)
            }
            (Pose::Least(arch), Some(n)) => Sketch::least_of_stones(arch, n, is_dilatant),
            (Pose::Least(arch), None) => Sketch::least(arch, is_dilatant),
            (Pose::Standing(arch, eta), Some(n)) => {
                Sketch::standing_of_stones(arch, n, eta, is_dilatant)
            }
            (Pose::Standing(arch, eta), None) => Sketch::standing(arch, eta, is_dilatant),
            (Pose::Sliding(arch, eta), _) => Sketch::sliding(arch, eta, is_dilatant),
        }
    }
}

impl Computable for DrawnArch {
    fn key(&self) -> String {
        let pose = match &self.pose {
            Pose::Least(arch) => arch_key(arch),
            Pose::Landmark(landmark, weight) => format!("{} {}", landmark.symbol(), weight.name()),
            Pose::Standing(arch, eta) => format!("{} {}", arch_key(arch), number_key(eta)),
            Pose::Sliding(arch, eta) => format!("slides {} {}", arch_key(arch), number_key(eta)),
        };
        format!("{pose} {:?} {}", self.stones, self.is_dilatant)
    }

    fn lines(&self) -> Vec<String> {
        let stones = self.stones.map_or(String::new(), |stones| format!("{stones} stones, "));
        let of = |arch: &Arch| format!("half opening {}", arch.half_opening());
        let pose = match &self.pose {
            Pose::Landmark(landmark, _) => landmark.symbol().to_owned(),
            Pose::Least(arch) => {
                format!("least thickness of {}, friction {},", of(arch), arch.friction())
            }
            Pose::Standing(arch, eta) => {
                format!("{}, friction {}, thickness {eta},", of(arch), arch.friction())
            }
            Pose::Sliding(arch, eta) => format!("sliding of {}, thickness {eta},", of(arch)),
        };
        vec![format!("{stones}{pose} {}", self.weight().name())]
    }
}
