//! The pieces of a plan, computed: a landmark, an arch. Each answers whatever any item asks of it.

use super::plan::{ArchNode, LandmarkNode};
use crate::certify::state::{Answer, AssessmentDigits, Doubt, Inquiry};
use crate::certify::{CertifiedLandmark, Constant, Undecided, fingerprint};
use crate::judge::{Enclosed, enclosed};
use crate::problem::{Quantity, System};
use crate::report::Proved;
use std::collections::BTreeMap;

/// What was found of a landmark.
pub struct LandmarkFound {
    system: System,
    relative_radii: Vec<f64>,
    /// In the order in which they are asked for.
    constants: Vec<Constant>,
    /// The hash of its certificate, or why there is none, by the number of digits.
    pub certificates: BTreeMap<usize, Result<String, String>>,
    /// For the printed numbers, if they are asked for.
    pub enclosed: Option<Enclosed>,
}

/// What was found of an arch.
pub struct ArchFound {
    /// By the number of digits.
    pub states: BTreeMap<usize, Result<Answer, Doubt>>,
    /// In the order in which they are asked for.
    pub thicknesses: Vec<Result<AssessmentDigits, Doubt>>,
}

impl LandmarkFound {
    /// Isolates the landmark and refines it once, to the most digits that are asked for.
    pub fn new(node: &LandmarkNode, tick: &(dyn Fn() + Sync)) -> Result<Self, Undecided> {
        let point = CertifiedLandmark::new(node.landmark, node.weight)?;
        let constants = match node.asked.as_slice() {
            [] => Vec::new(),
            asked => point.constants_of(asked, tick)?,
        };
        let isolated = point.isolated();
        let (system, relative_radii) = (*isolated.system(), isolated.relative_radii());
        let hash = |&digits: &usize| {
            let hash = fingerprint(node.landmark, node.weight, digits);
            (digits, hash.map_err(|undecided| undecided.0))
        };
        let certificates = node.certificates.iter().map(hash).collect();
        let enclosed = if node.audited { Some(enclosed(point)?) } else { None };
        Ok(Self { system, relative_radii, constants, certificates, enclosed })
    }

    /// What one item asks for.
    pub fn proved(&self, node: &LandmarkNode, quantities: &[Quantity], digits: usize) -> Proved {
        let all = node.asked.iter().zip(&self.constants);
        let mine = all.filter(|((quantity, of), _)| quantities.contains(quantity) && *of == digits);
        let mut constants: Vec<Constant> = mine.map(|(_, constant)| constant.clone()).collect();
        // In the order in which they are always shown, whoever asked first.
        constants.sort_by_key(|one| Quantity::ALL.iter().position(|of| *of == one.quantity));
        Proved { system: self.system, relative_radii: self.relative_radii.clone(), constants }
    }
}

impl ArchFound {
    /// Proves the state once, and what is asked of each thickness.
    pub fn new(node: &ArchNode) -> Self {
        let mut inquiry = Inquiry::new(node.arch, node.digits(), node.frictions());
        let states = node.states.iter();
        let states = states
            .map(|(&digits, &frictions)| (digits, inquiry.state(digits, frictions)))
            .collect();
        let thicknesses = node
            .thicknesses
            .iter()
            .map(|asked| inquiry.assess(&asked.thickness, asked.digits, asked.wanted))
            .collect();
        Self { states, thicknesses }
    }
}
