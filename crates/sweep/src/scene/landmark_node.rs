//! A landmark: isolated once, and refined to the most digits that any item asks for.

use super::computable::Computable;
use crate::arch::SelfWeight;
use crate::certify::{CertifiedLandmark, Constant, Enclosed, Error, fingerprint, quantities};
use crate::judge::enclosed;
use crate::problem::{Landmark, Quantity};
use crate::report::words::list;
use std::collections::{BTreeMap, BTreeSet};

/// A landmark and what is asked of it.
#[derive(Debug)]
pub(super) struct LandmarkNode {
    /// The landmark.
    pub landmark: Landmark,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// Each quantity with each number of digits in which it is asked for.
    pub asked: Vec<(Quantity, usize)>,
    /// The digits of the certificates whose hashes the outputs name.
    pub certificates: BTreeSet<usize>,
    /// True if printed numbers are compared with it.
    pub audited: bool,
}

/// A proved landmark.
pub(super) struct LandmarkPiece {
    /// The proof.
    pub point: CertifiedLandmark,
    /// Constants, each with the number of digits in which it is asked for.
    constants: Vec<(usize, Constant)>,
    /// The hash of its certificate, or why there is none, by the number of digits.
    pub certificates: BTreeMap<usize, Result<String, Error>>,
    /// Enclosures for the printed numbers, if they are asked for.
    pub enclosed: Option<Enclosed>,
}

impl LandmarkNode {
    /// A landmark of which nothing is asked.
    pub(super) fn new((landmark, weight): (Landmark, SelfWeight)) -> Self {
        let (asked, certificates) = (Vec::new(), BTreeSet::new());
        Self { landmark, weight, asked, certificates, audited: false }
    }

    /// Asks for quantities, those that the landmark has.
    pub(super) fn ask(&mut self, asked: &[Quantity], digits: usize) {
        for quantity in quantities(self.landmark).filter(|quantity| asked.contains(quantity)) {
            if !self.asked.contains(&(quantity, digits)) {
                self.asked.push((quantity, digits));
            }
        }
    }

    /// The most digits that are asked for.
    pub(super) fn digits(&self) -> usize {
        self.asked.iter().map(|(_, digits)| *digits).max().unwrap_or(0)
    }

    /// Number of times that it reports progress.
    pub(super) fn ticks(&self) -> u64 {
        match self.asked.len() {
            0 => 0,
            asked => CertifiedLandmark::ticks_of(self.landmark, asked),
        }
    }
}

impl Computable for LandmarkNode {
    fn key(&self) -> String {
        format!("{} {}", self.landmark.symbol(), self.weight.name())
    }

    fn lines(&self) -> Vec<String> {
        let system = self.landmark.system(self.weight);
        let equations = list(system.equations.iter().map(|equation| equation.label()));
        let mut lines = vec![self.key(), format!("from {equations}")];
        let all: BTreeSet<usize> = self.asked.iter().map(|(_, digits)| *digits).collect();
        for digits in all {
            let asked = self.asked.iter().filter(|(_, of)| *of == digits);
            let names = list(asked.map(|(quantity, _)| quantity.name()));
            lines.push(format!("to {digits} digits: {names}"));
        }
        if !self.certificates.is_empty() {
            let digits: Vec<String> = self.certificates.iter().map(ToString::to_string).collect();
            lines.push(format!("the hash of its certificate, to {} digits", digits.join(", ")));
        }
        if self.audited {
            lines.push("for the printed numbers".to_owned());
        }
        lines
    }
}

impl LandmarkPiece {
    /// Proves what is asked of it.
    pub(super) fn new(node: &LandmarkNode, tick: &(dyn Fn() + Sync)) -> Result<Self, Error> {
        let point = CertifiedLandmark::new(node.landmark, node.weight)?;
        let constants = match node.asked.as_slice() {
            [] => Vec::new(),
            asked => point.constants_of_with(asked, tick)?,
        };
        let constants = node.asked.iter().map(|(_, digits)| *digits).zip(constants).collect();
        let certificates =
            node.certificates.iter().map(|&digits| (digits, fingerprint(&point, digits))).collect();
        let enclosed = if node.audited { Some(enclosed(&point)?) } else { None };
        Ok(Self { point, constants, certificates, enclosed })
    }

    /// Constants that an item asks for, in its order, whoever asked first.
    pub(super) fn constants(&self, quantities: &[Quantity], digits: usize) -> Vec<Constant> {
        let of = |quantity: &Quantity| {
            let is_it = |one: &&(usize, Constant)| (one.0, one.1.quantity) == (digits, *quantity);
            self.constants.iter().find(is_it).map(|(_, one)| one.clone())
        };
        quantities.iter().filter_map(of).collect()
    }
}
