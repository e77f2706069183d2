//! Arches under a horizontal acceleration: for a person, CSV, and JSON (`couplet.tilt/2`).

use super::format::Content;
use super::record::Record;
use super::reported::Reported;
use super::tabular::Tabular;
use super::understood::Understood;
use super::words::division;
use crate::arch::SelfWeight;
use crate::arch::whole::Side;
use crate::certify::state::Figure;
use crate::certify::{LargestTilt, TiltDigits, TiltLimit, Undecided};
use crate::problem::asymmetric_region::MAY_MOVE;
use crate::problem::stones::Stones;
use std::io;

/// An arch of a given thickness under an acceleration, and what is proved of it.
#[derive(Debug)]
pub struct TiltedArch {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// Question as it is understood.
    pub asked: Understood,
    /// Half opening, friction, thickness and acceleration as given.
    pub given: [String; 4],
    /// Stones of the arch, where it has joints between these only.
    pub stones: Option<Stones>,
    /// True if the arch's friction is limited.
    pub is_limited: bool,
    /// Result that is proved; `None` if the arch does not even stand without acceleration.
    pub found: Result<Option<TiltDigits>, Undecided>,
}

impl TiltedArch {
    /// Tells whether there is an admissible state; `None` if that stays open.
    fn is_admissible(&self) -> Option<bool> {
        match &self.found {
            Ok(None) => Some(false),
            Ok(Some(found)) => found.is_admissible.as_ref().ok().copied(),
            Err(_) => None,
        }
    }

    /// Reason why something stays open, if anything does.
    pub fn first_open(&self) -> Option<&Undecided> {
        match &self.found {
            Ok(None) => None,
            Ok(Some(found)) => found.is_admissible.as_ref().err().or(found.largest.as_ref().err()),
            Err(undecided) => Some(undecided),
        }
    }

    /// Outcome in a word.
    fn outcome(&self) -> &'static str {
        match self.is_admissible() {
            Some(true) => "stands",
            Some(false) => "collapses",
            None => "undecided",
        }
    }

    /// Tells whether an admissible state does not exclude a motion: joints that slide do not open.
    fn may_move(&self) -> bool {
        self.is_limited && self.is_admissible() == Some(true)
    }

    /// The largest acceleration, where it is known.
    fn largest(&self) -> Option<&LargestTilt> {
        self.found.as_ref().ok()?.as_ref()?.largest.as_ref().ok()
    }

    /// Largest acceleration as a figure.
    fn figure(&self) -> Option<&Figure> {
        match self.largest()? {
            LargestTilt::Limited(figure, _) => Some(figure),
            LargestTilt::Unlimited => None,
        }
    }

    /// Limits of the acceleration, in words.
    fn limits(&self) -> Vec<String> {
        let words = |limit: &TiltLimit| {
            let side = if limit.is_right { Side::Right } else { Side::Left };
            let name = side.name();
            let words = match side.contact(limit.contact) {
                slip if !slip.is_hinge() && !self.is_limited => "opens",
                other => other.name(),
            };
            let place = match (limit.is_springing, limit.joint.zip(self.stones.as_ref())) {
                (true, _) => format!("at the {name} springing"),
                (false, None) => format!("on the {name}"),
                (false, Some((0, stones))) if stones.has_joint_at_crown() => "at the crown".into(),
                (false, Some((joint, stones))) => {
                    let number = joint + u64::from(!stones.has_joint_at_crown());
                    format!("at joint {number} on the {name}")
                }
            };
            format!("{words} {place}")
        };
        match self.largest() {
            Some(LargestTilt::Limited(_, limits)) => limits.iter().map(words).collect(),
            _ => Vec::new(),
        }
    }
}

fn table(arch: &TiltedArch, out: &mut dyn io::Write) -> io::Result<()> {
    {
        writeln!(out, "Arch of {}\n", arch.asked.with_weight(arch.weight))?;
        let joints = if arch.stones.is_some() { "between the stones" } else { "on the whole arch" };
        let outcome = match (arch.is_admissible(), &arch.found) {
            (_, Ok(None)) => "collapses, proved: it does not stand without tilt either".to_owned(),
            (Some(true), _) => format!(
                "stands, proved: an admissible state exists, {joints} no joint slides or is under tension"
            ),
            (Some(false), _) => "collapses, proved: no state is admissible".to_owned(),
            (None, _) => arch.first_open().map_or(String::new(), ToString::to_string),
        };
        writeln!(out, "{outcome}")?;
        if arch.may_move() {
            writeln!(out, "{MAY_MOVE}: that is not excluded")?;
        }
        if let Some(largest) = arch.largest() {
            let text = match largest {
                LargestTilt::Limited(figure, _) => figure.to_string(),
                LargestTilt::Unlimited => "unbounded".to_owned(),
            };
            let words = if arch.is_limited { "falls from the tilt" } else { "largest tilt" };
            writeln!(out, "\n   {words:<24} {text}")?;
            arch.limits().iter().enumerate().try_for_each(|(index, limit)| {
                let words = if index == 0 { "        limited by" } else { "" };
                writeln!(out, "   {words:<24} {limit}")
            })?;
        }
        Ok(())
    }
}

impl Reported for TiltedArch {
    fn content() -> Content {
        Content::RECORDS
    }

    fn records(&self) -> Vec<Record> {
        let mut record = fields(self);
        let mut lines = Vec::new();
        let _ = table(self, &mut lines);
        record.say(String::from_utf8_lossy(&lines).trim_end());
        vec![record]
    }

    fn tabular(&self) -> Tabular {
        let mut row = fields(self);
        if let Some(LargestTilt::Unlimited) = self.largest() {
            row.add("largest_tilt", "inf");
        }
        let columns = "weight half_opening friction thickness tilt outcome largest_tilt limited_by reason may_move stones";
        Tabular::of(columns, [row])
    }
}

fn fields(arch: &TiltedArch) -> Record {
    let mut fields = Record::of("couplet.tilt/2");
    fields.add_record("asked", Some(arch.asked.fields()));
    fields.add("weight", arch.weight.name());
    let given = arch.given.each_ref().map(|text| text.as_str().into());
    fields.append(Record::named("half_opening friction thickness tilt", given));
    fields.add("outcome", arch.outcome());
    fields.add("may_move", arch.may_move());
    fields.add("reason", arch.first_open().map(|open| open.reason.to_string()));
    fields.add_bounds("largest_tilt", arch.figure());
    let is_unbounded = arch.largest().map(|largest| matches!(largest, LargestTilt::Unlimited));
    fields.add("is_unbounded", is_unbounded);
    fields.add("limited_by", arch.limits());
    fields.add("stones", arch.stones.as_ref().map(division));
    fields
}
