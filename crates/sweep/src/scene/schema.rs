//! Content that a scene may hold: `couplet.scene/1`. Keys may be added, none changes its meaning.

use super::drawn::DrawnArch;
use super::fault::{Fault, Position};
use super::scene_map::SceneMap;
use crate::arch::SelfWeight;
use crate::ask::{ArchAsked, ArchGiven, Field};
use crate::claims::Claim;
use crate::number::{ExactNumber, list, worded};
use crate::picture::Print;
use crate::problem::Arch;
use crate::problem::measures::Measures;
use crate::problem::{Landmark, Mode, Quantity};
use crate::report::{
    Answers, Audit, Claims, Content, Format, Map, Reported, Sketched, Style, SurveyedRows,
    Understood,
};
use std::path::PathBuf;

/// The name and the version of the schema, which every scene begins with.
pub const SCHEMA: &str = "couplet.scene/1";

/// A scene with every key and what it means, which is itself a scene.
pub const EXAMPLE: &str = include_str!("example.toml");

/// Digits where a scene does not say how many.
pub(super) const DIGITS: usize = 30;
/// Digits of the ends of ranges where it does not.
pub(super) const RANGE_DIGITS: usize = 6;
/// The most arches of a scene, and the most steps of a range.
pub const MAX_ARCHES: usize = 100_000;
/// The most ranges that are not boxes: each has an answer of many lines.
pub(super) const MAX_RANGES: usize = 10_000;
/// The most items of a scene.
pub const MAX_ITEMS: usize = 1_000;
/// The most bytes of a scene.
pub const MAX_BYTES: usize = 1 << 20;

/// A valid scene.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Items that are asked for, in the order of the file.
    pub items: Vec<SceneItem>,
    /// Remarks on what is answered all the same.
    pub notes: Vec<Fault>,
}

impl Scene {
    /// Scene that asks for nothing but this.
    pub fn one(kind: ItemKind, what: Request, (format, print): (&'static Format, &Print)) -> Self {
        let (place, print, output) = (Position { line: 1, column: 1 }, print.clone(), None);
        let items = vec![SceneItem { place, kind, what, format, print, output }];
        Self { items, notes: Vec::new() }
    }
}

/// Something that is asked for, and where it goes.
#[derive(Clone, Debug)]
pub struct SceneItem {
    /// Place where the file asks for it.
    pub place: Position,
    /// The kind of item.
    pub kind: ItemKind,
    /// The request of the item.
    pub what: Request,
    /// Format in which it is written.
    pub format: &'static Format,
    /// Printing of a picture.
    pub print: Print,
    /// The file, relative to the folder of outputs; standard output if there is none.
    pub output: Option<PathBuf>,
}

/// Request that an item makes.
#[derive(Clone, Debug)]
pub enum Request {
    /// Landmark constants.
    Constants {
        /// The landmarks.
        points: Vec<(Landmark, SelfWeight)>,
        /// Quantities of them, where they exist.
        quantities: Vec<Quantity>,
        /// Significant digits.
        digits: usize,
    },
    /// Arches at their least thickness, or with a thickness.
    Arches {
        /// The arches.
        arches: Vec<SceneArch>,
        /// Quantities of them.
        quantities: Vec<Quantity>,
        /// True if the arches have a thickness.
        with_thickness: bool,
        /// Significant digits.
        digits: usize,
    },
    /// Arches between two ends.
    Surveys {
        /// The ranges.
        surveys: Vec<SceneSurvey>,
        /// The question about all of them, if they are its boxes.
        boxes: Option<Box<SceneBoxes>>,
        /// Quantities of them.
        quantities: Vec<Quantity>,
        /// Significant digits.
        digits: usize,
    },
    /// Claims of the paper to prove or refute.
    Claims {
        /// The claims, in the order of the paper.
        claims: Vec<Claim>,
        /// True if the derivations are given.
        show: bool,
    },
    /// Printed numbers against certified values.
    Audit {
        /// The landmarks whose printed numbers are compared.
        points: Vec<(Landmark, SelfWeight)>,
    },
    /// Curves of the map, as data or as a picture, any or those of a figure of the paper.
    Map(SceneMap),
    /// Arches to be drawn, any or those of a figure.
    Drawing(SceneDrawing),
}

/// Arches that are drawn.
#[derive(Clone, Debug)]
pub struct SceneDrawing {
    /// Arches, each with the modes that are shown; all if none is named.
    pub arches: Vec<(DrawnArch, Vec<Mode>)>,
    /// Style in which they are drawn.
    pub style: Style,
    /// Sizes, if they are measured.
    pub measures: Option<Measures>,
    /// The command that asks for the same.
    pub command: String,
}

/// An arch of a scene.
#[derive(Clone, Debug)]
pub struct SceneArch {
    /// The arch.
    pub arch: Arch,
    /// Thickness of the arch, if it has one.
    pub thickness: Option<ExactNumber>,
    /// Question in metres, if it is one.
    pub measured: Option<Box<MeasuredArch>>,
}

/// An arch in metres, as it is asked about and as it is understood.
#[derive(Clone, Debug)]
pub struct MeasuredArch {
    /// The texts.
    pub asked: ArchAsked,
    /// The reading of the texts.
    pub given: ArchGiven,
}

/// All arches between two ends, as they are asked about: of many the reading of each would fill the memory.
#[derive(Clone, Debug)]
pub struct SceneSurvey {
    /// The texts, which were found to make sense.
    pub asked: ArchAsked,
    /// The self-weight model.
    pub weight: SelfWeight,
}

/// A question whose ranges are cut into boxes.
#[derive(Clone, Debug)]
pub struct SceneBoxes {
    /// The question as it is understood.
    pub asked: Understood,
    /// Fields that are cut, with the numbers of parts.
    pub cut: Vec<(Field, usize)>,
    /// Columns of a table of them.
    pub rows: SurveyedRows,
}

/// Fields that an arch is given by.
pub(super) const FIELDS: [Field; 10] = list![
    Field: HalfOpening Friction FrictionAngle Thickness Span Rise Radius MeasuredAt Density Depth
];

worded! {
    /// A kind of item, by the table that asks for it.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum ItemKind {
        /// `[[constants]]`.
        Constants = "constants",
        /// `[[arches]]`.
        Arches = "arches",
        /// `[[claims]]`.
        Claims = "claims",
        /// `[[audit]]`.
        Audit = "audit",
        /// `[[map]]`.
        Map = "map",
        /// `[[figure]]`.
        Figure = "figure",
        /// `[[drawing]]`.
        Drawing = "drawing",
    }
    /// All kinds.
    pub const ALL;
    /// The name of the table.
    pub fn name -> &'static str;
}

impl ItemKind {
    /// Content that is written of it.
    pub fn content(self) -> Content {
        match self {
            Self::Constants | Self::Arches => Answers::content(),
            Self::Claims => Claims::content(),
            Self::Audit => Audit::content(),
            Self::Map => Map::content(),
            Self::Figure => Content::FIGURE,
            Self::Drawing => Sketched::content(),
        }
    }

    /// The keys that an item of this kind may have.
    pub fn keys(self) -> Vec<&'static str> {
        let own = match self {
            Self::Constants => "landmarks quantities weight digits",
            Self::Arches => "quantities weight digits",
            Self::Claims => "prove show",
            Self::Audit => "landmarks weight",
            Self::Map => {
                "curves half_opening thickness friction weight tolerance plane lines bare asymmetric half_opening_unit \
                 friction_unit scale half_opening_range friction_range thickness_range marks"
            }
            Self::Figure => "number weight tolerance",
            Self::Drawing => "at weight mode amplitude stones dilatant half arrows animate",
        };
        let fields = if matches!(self, Self::Arches | Self::Drawing) { &FIELDS[..] } else { &[] };
        let print =
            if self.is_drawn() { "width font_size font caption full_caption title" } else { "" };
        let rest = [own, print, "format output"];
        let rest = rest.into_iter().flat_map(str::split_whitespace);
        fields.iter().map(|field| field.name()).chain(rest).collect()
    }

    /// Tells whether it may be a picture.
    pub(super) fn is_drawn(self) -> bool {
        matches!(self, Self::Map | Self::Figure | Self::Drawing)
    }
}

/// The keys of a scene beside its items.
pub(super) const SCENE_KEYS: [&str; 3] = ["schema", "digits", "weight"];

impl SceneItem {
    /// Description of all that its output depends on: everything that was read, the same however the file has it.
    pub fn description(&self) -> String {
        format!("{:?} {:?} {}", self.what, self.print, self.format.name)
    }
}
