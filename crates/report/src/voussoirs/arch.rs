//! An arch of voussoirs and what is proved of it, as every format sees it.

use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::certify::state::Figure;
use crate::number::{Ball, ExactNumber, Rounded, degrees};
use crate::numbers::decided;
use crate::problem::stones::{JointContact, Stones};
use crate::problem::{Friction, Quantity};
use crate::record::Record;
use crate::sizes::Sizes;
use crate::understood::Understood;
use crate::words::{self, DOUBLE_DIGITS};
use couplet_stones::{
    VoussoirAssessment, VoussoirDigits, VoussoirLoss, VoussoirStanding, Voussoirs,
};

/// Bits of an angle that is told.
const BITS: u32 = 256;
/// Digits of an angle among words.
const DIGITS: usize = 6;

/// The place of a joint at the crown, in words.
const CROWN: &str = "at the crown";

/// An arch of voussoirs, what is proved of it, and the same arch without end of joints.
#[derive(Debug)]
pub struct VoussoirArch {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The friction as given.
    pub friction: String,
    /// Stones of the arch.
    pub stones: Stones,
    /// Result that is proved.
    pub found: Result<Voussoirs, Undecided>,
    /// The least thickness with a joint at every angle; `None` where there is none, or it is not proved.
    pub continuous: Option<Figure>,
    /// Savings over an arch with a joint at every angle; `None` where the digits do not tell it.
    pub loss: Option<VoussoirLoss>,
    /// Result at a thickness that is given.
    pub given: Option<GivenThickness>,
    /// True if it is proved that the complementarity problem (19) has no solution above the least thickness.
    pub is_still: bool,
    /// Sizes, where the arch is measured: at its given thickness, else at its least one.
    pub sizes: Option<Sizes>,
}

/// Result for an arch of voussoirs of a given thickness.
#[derive(Debug)]
pub struct GivenThickness {
    /// The thickness.
    pub thickness: ExactNumber,
    /// Assessment at that thickness.
    pub found: VoussoirAssessment,
}

impl GivenThickness {
    /// Tells whether the arch stands; `None` if that stays open.
    pub(super) fn stands(&self) -> Option<bool> {
        let standing = self.found.standing.as_ref().ok()?;
        Some(matches!(standing, VoussoirStanding::Stands(_)))
    }
}

/// An arch for each weight asked for, or one for each number of stones too.
#[derive(Debug)]
pub struct VoussoirArches {
    /// Question as it is understood.
    pub asked: Understood,
    /// The arches.
    pub arches: Vec<VoussoirArch>,
    /// True if a range of numbers of stones was asked for.
    pub is_range: bool,
    /// The command that makes it, for the caption of a figure.
    pub command: String,
}

impl VoussoirArch {
    /// Outcome in a word.
    pub(super) fn outcome(&self) -> &'static str {
        match &self.found {
            Ok(Voussoirs::Stands(_)) => "stands",
            Ok(Voussoirs::AnyThickness) => "any_thickness",
            Ok(Voussoirs::Slides) => "sliding",
            Ok(Voussoirs::TooThick) => "thickness",
            Err(_) => "undecided",
        }
    }

    /// Reason why something stays open, if anything does.
    pub fn first_open(&self) -> Option<&Undecided> {
        let open = match &self.given {
            Some(given) => given.found.first_open(),
            None => self.found.as_ref().err(),
        };
        open.or_else(|| self.sizes.as_ref()?.found.as_ref().err())
    }

    /// Tells whether the arch's friction is limited.
    fn is_limited(&self) -> bool {
        self.friction != Friction::Infinite.to_string()
    }

    /// Tells whether the arch stands with limited friction, and a motion above its least thickness is not excluded.
    pub fn may_move(&self) -> bool {
        let stands = match &self.given {
            Some(given) => given.stands() == Some(true),
            None => matches!(self.found, Ok(Voussoirs::Stands(_) | Voussoirs::AnyThickness)),
        };
        stands && self.is_limited() && !self.is_still
    }

    /// Statement in words of what may move, with the command that looks for one.
    pub(super) fn may_move_in_words(&self) -> Option<String> {
        self.may_move().then(|| words::stones_may_move(&self.stones))
    }

    /// The state, where it has one.
    pub(super) fn state(&self) -> Option<&VoussoirDigits> {
        match &self.found {
            Ok(Voussoirs::Stands(state)) => Some(state),
            _ => None,
        }
    }

    /// The quantities of the state, which none has where there is no state.
    pub fn figures(&self) -> Vec<(Quantity, Option<&Figure>)> {
        let state = self.state();
        vec![
            (Quantity::Thickness, state.map(|state| &state.thickness)),
            (Quantity::Thrust, state.map(|state| &state.thrust)),
            (Quantity::RotationJoint, state.map(|state| &state.rotation_joint)),
            (Quantity::SlidingJoint, state.and_then(|state| state.sliding_joint.as_ref())),
        ]
    }

    /// Place of a joint in words: its number, and its angle from the crown on both sides.
    pub(super) fn place(&self, joint: u64) -> String {
        let place = self.stones.place(joint);
        let angle = degrees(&self.stones.angle::<Ball>(joint, BITS).rad);
        match decided(&angle, DIGITS) {
            Some(angle) if place != CROWN => format!("{place} ({angle} deg)"),
            _ => place,
        }
    }

    /// The joints that give way, each with what happens there; at the crown once, elsewhere on both sides.
    pub(super) fn gives_way(&self) -> Vec<Record> {
        let one = |contact: &JointContact| {
            let mut fields = Record::default();
            fields.add("happens", at_limit(self, contact));
            let is_crown = self.stones.place(contact.1) == CROWN;
            fields.add("side", if is_crown { "crown" } else { "both" });
            let angle = self.stones.angle::<Ball>(contact.1, BITS).rad;
            fields.add_rounded("angle", Rounded::around(&angle, DOUBLE_DIGITS).as_ref());
            fields.add("joint", contact.1);
            fields
        };
        self.state().iter().flat_map(|state| &state.contacts).map(one).collect()
    }
}

/// A contact in words.
pub(super) fn at_limit(arch: &VoussoirArch, contact: &JointContact) -> &'static str {
    arch.stones.at_limit(*contact, arch.is_limited())
}
