//! A piece of a curve that can be halved.

use super::cubic::exact;
use super::form::CurveForm;
use super::search;
use super::trace::Piece;
use super::tube::{Node, Tube};
use super::variable::Variable;
use crate::number::{Ball, Enclosure, Ternary};

/// A piece, or a part of one, with a tube of its own.
#[derive(Clone)]
pub(super) struct TubeCell<'a> {
    pub form: &'a CurveForm,
    pub nodes: [Node; 2],
    pub tube: Tube,
}

impl<'a> TubeCell<'a> {
    pub(super) fn new(piece: &Piece<'a>) -> Option<Self> {
        let nodes = piece.nodes().map(Node::clone);
        Some(Self { form: piece.form, nodes, tube: piece.tube?.clone() })
    }

    pub(super) fn range(&self) -> [f64; 2] {
        self.nodes.each_ref().map(|node| node.sketch.s)
    }

    /// The values of a variable in its nodes.
    pub(super) fn ends(&self, variable: Variable) -> Option<[Ball; 2]> {
        let [from, to] = self
            .nodes
            .each_ref()
            .map(|node| self.form.value(variable, &exact(node.sketch.s), &node.root).cloned());
        Some([from?, to?])
    }

    /// Tells whether the value may be on the cell.
    pub(super) fn may_have(&self, variable: Variable, value: &Ball) -> bool {
        let [low, high] = self.range().map(exact);
        let all = low.hull(&high);
        let values = self.form.value(variable, &all, &self.tube.enclosure(&all)).cloned();
        values.is_none_or(|values| values.overlaps(value))
    }

    /// Tells whether the variable rises on all of the cell, or falls.
    pub(super) fn rises(&self, variable: Variable) -> Option<bool> {
        let one = exact(1.0);
        let slope = self.form.value(variable, &one, &self.tube.slopes)?;
        match (slope.is_positive(), slope.excludes_zero()) {
            (Ternary::True, _) => Some(true),
            (Ternary::False, true) => Some(false),
            _ => None,
        }
    }

    /// Halves of the cell, in tubes of their own, which hold the same branch: the root between them is in its tube.
    pub(super) fn halves(&self) -> Option<[Self; 2]> {
        let [low, high] = self.range();
        let middle = low + (high - low) / 2.0;
        let s = exact(middle);
        let start = self.tube.enclosure(&s).iter().map(|x| x.mid().to_f64()).collect();
        let node = Node::prove(self.form, search::point(self.form, middle, start)?)?;
        if !self.tube.holds(&s, &node.root) {
            return None;
        }
        let half = |nodes: [Node; 2]| {
            let tube = Tube::prove(self.form, &nodes[0], &nodes[1])?;
            Some(Self { form: self.form, nodes, tube })
        };
        let [from, to] = self.nodes.clone();
        Some([half([from, node.clone()])?, half([node, to])?])
    }
}
