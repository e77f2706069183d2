//! `couplet draw`.

use super::arch::RANGE_DIGITS;
use super::look::{ArchLook, LookArguments, only_upright};
use super::notes;
use super::output::{OutputFile, Printed};
use super::{survey, tilt};
use crate::arch::SelfWeight;
use crate::ask::{
    ArchAsked, ArchGiven, ArchQuestion, Field, Misfit, Spelling, StonesAsked, SurveyGiven,
};
use crate::atlas::{Passed, Sketch};
use crate::cli::line::typed;
use crate::number::{Ball, shown};
use crate::problem::{Landmark, Mode};
use crate::report::{Format, Reported, Shown, Sketched, Style, Understood};
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use crate::sweep::scene::{DrawnArch, Pose};
use clap::Args;

/// Draw an arch as it stands, at its least thickness, or falling.
///
/// Without --thickness: the arch at its least thickness, its lines of thrust and of friction, and its mechanism.
/// With it: the lines of the least and of the largest thrust, what limits each, and the safety. An arch that does not
/// stand: where a line of thrust leaves it or friction is passed, and how it falls. --at: a landmark,
/// one picture for each mode that is possible there. --mode [s,s] with --thickness and no friction: an arch at the
/// friction at which it slides. --stones: an arch of 2 to 500 stones, as couplet voussoirs proves it. Measured,
/// with --span and --rise or with --radius: sizes in the picture and its caption, JSON and DXF, in the unit of the
/// first length.
///
/// With --thickness a number may be a range, as of `assess`: then the picture has the band in which every line of
/// thrust of every arch inside lies, and what is proved of all of them. With --tilt: the arch at the largest horizontal
/// acceleration that it bears, and how it falls there.
#[derive(Args)]
#[command(mut_arg("joints", |arg| arg.hide(true)))]
#[command(
    override_usage = "couplet draw --half-opening <ANGLE> --friction <MU> [--thickness <ETA>] [OPTIONS]\n       \
                            couplet draw --at <LANDMARK> [--mode <MODE>] [OPTIONS]"
)]
pub(crate) struct Arguments {
    #[command(flatten)]
    arch: ArchAsked,

    /// Self-weight model: heyman or milankovitch.
    #[arg(long, default_value = "milankovitch", value_parser = parse::weight)]
    weight: SelfWeight,

    /// A landmark instead of an arch, by symbol or name: T, S, J, B, l or L.
    #[arg(
        long, value_name = "LANDMARK", value_parser = parse::landmark,
        conflicts_with_all = ["half_opening", "friction", "friction_angle", "thickness", "joints", "span", "radius", "density"]
    )]
    at: Option<Landmark>,

    /// Only this mode, where several are possible (rrs, [s,s]).
    #[arg(long, value_name = "MODE", value_parser = parse::mode)]
    mode: Option<Mode>,

    /// The modes that the half opening passes as this quantity grows: friction, and from where to where (0.2..3).
    #[arg(
        long, num_args = 2, value_names = ["QUANTITY", "FROM..TO"],
        conflicts_with_all = ["friction", "friction_angle", "thickness", "at", "mode", "stones", "joints", "dilatant"]
    )]
    along: Option<Vec<String>>,

    /// Format: svg, png, pdf, json or dxf. If none is given, what the name of the file ends with tells it.
    #[arg(long, value_parser = parse::format(Sketched::content()))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,

    #[command(flatten)]
    look: LookArguments,
}

/// Message why there are no stones.
const STONES: &str = "--stones is for an arch with --half-opening and --friction: a landmark, and an arch at the \
                      friction at which it slides, have a joint at every angle";

/// Question about an arch that is drawn.
pub const QUESTION: ArchQuestion = ArchQuestion {
    refuses: &[
        (Field::Tilt, "one arch of a thickness is drawn tilted, by `couplet draw`"),
        (Field::Joints, "stones of one angle are drawn, with --stones"),
    ],
    needs: &[],
    unlimited: false,
    example: "couplet draw --half-opening 80deg --friction 0.35 -o arch.svg",
};
/// Question about all arches between two ends.
const RANGES: ArchQuestion = ArchQuestion {
    needs: &[Field::Thickness],
    example: "couplet draw --half-opening 78deg..80deg --friction 0.6 --thickness 0.1..0.12 -o arches.svg",
    ..QUESTION
};
/// Question about a tilted arch.
const TILTED: ArchQuestion = ArchQuestion {
    refuses: &[],
    needs: &[Field::Thickness],
    example: "couplet draw --half-opening 80deg --friction 0.6 --thickness 0.12 --tilt 2deg -o arch.svg",
    ..QUESTION
};
/// An arch at the friction at which it slides, which has none of its own.
const SLIDING: ArchQuestion = ArchQuestion { unlimited: true, ..QUESTION };

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let format = arguments.file.format(arguments.format, Sketched::content(), "svg")?;
    let printed = (&arguments.file, format, arguments.look.of(format, true)?);
    if arguments.arch.has_range() {
        return arguments.ranges(printed);
    }
    if arguments.arch.tilt.is_some() {
        return arguments.tilted(printed);
    }
    let (sketches, between, given) = match &arguments.along {
        Some(path) => arguments.along(path)?,
        None => {
            let (sketch, given) = arguments.sketch(&printed.2)?;
            (vec![sketch], Vec::new(), given)
        }
    };
    write((sketches, between), &given, printed)
}

/// Draws the arch that any question was about, as it stands or at its least thickness.
pub(super) fn arch(
    given: &ArchGiven,
    weight: SelfWeight,
    printed: Printed<'_>,
) -> Result<(), Failure> {
    let sketch = sketched(Pose::of(given, weight, false)?, given, &printed.2, None)?;
    write((vec![sketch], Vec::new()), given, printed)
}

/// Sketch of an arch, in a mode if one is named.
fn sketched(
    pose: Pose,
    given: &ArchGiven,
    look: &ArchLook,
    mode: Option<Mode>,
) -> Result<Sketch, Failure> {
    let is_dilatant = look.is_dilatant;
    let sketch = DrawnArch { pose, stones: stones(given)?, is_dilatant }.sketch()?;
    if sketch.stands() && (mode.is_some() || is_dilatant || look.style.animate) {
        let message = "the arch stands with that thickness, and does not move: leave out --mode, --dilatant and \
                       --animate, or --thickness";
        return Err(message.into());
    }
    Ok(sketch.in_modes(mode.as_slice())?)
}

/// Number of stones that are drawn.
fn stones(given: &ArchGiven) -> Result<Option<u64>, Misfit> {
    let wrong = |message: &str| Err(Misfit { field: Some(Field::Stones), message: message.into() });
    match given.stones {
        None => Ok(None),
        Some(StonesAsked::Numbers { first, is_range: false, .. })
            if u32::try_from(first).is_ok_and(|n| Style::STONES.contains(&n)) =>
        {
            Ok(Some(first))
        }
        Some(StonesAsked::Numbers { .. }) => {
            wrong("the stones that are drawn are a whole number from 2 to 500")
        }
        Some(StonesAsked::Joints(_)) => wrong("stones of one angle are drawn: give --stones"),
    }
}

/// The frictions between which each arch collapses as it is drawn, or none.
type Between = Vec<[Option<Ball>; 2]>;

fn write(
    (sketches, between): (Vec<Sketch>, Between),
    given: &ArchGiven,
    (file, format, look): Printed<'_>,
) -> Result<(), Failure> {
    let (measures, style) = (given.measures.clone(), look.style);
    let drawn = Sketched { sketches, style, measures, between, command: typed() };
    if !drawn.can_be_drawn() {
        let message =
            "a drawing has a radius from 1mm to 1000000m, and forces of a size that doubles hold";
        return Err(message.into());
    }
    let file = file.open_for(format)?;
    notes::frictions(&given.friction);
    file.printed((&drawn, format, &look.print), [""; 0])
}

impl Arguments {
    /// Refuses what is of a picture of one upright arch beside what is not drawn so.
    fn refuse_modes(&self, what: &str) -> Result<(), Failure> {
        let one_arch = [
            ("--at", self.at.is_some()),
            ("--mode", self.mode.is_some()),
            ("--along", self.along.is_some()),
        ];
        let given = one_arch.into_iter().find(|(_, is_given)| *is_given);
        given.map_or(Ok(()), |(name, _)| Err(only_upright(name, what)))
    }

    /// An arch under the largest acceleration that it bears.
    fn tilted(&self, printed: Printed<'_>) -> Result<(), Failure> {
        self.refuse_modes("--tilt")?;
        let given = ArchGiven::read(&TILTED, &self.arch, Spelling::Option)?;
        let (asked, arches) = (Understood::new(&self.arch, &given), [given.arch(self.weight)?]);
        let stones = given.divisions()?;
        let of = (&asked, &arches[..]);
        match tilt::draw(&given, of, stones.first(), &printed, RANGE_DIGITS)? {
            true => Ok(()),
            false => arch(&given, self.weight, printed),
        }
    }

    /// All arches between two ends.
    fn ranges(&self, printed: Printed<'_>) -> Result<(), Failure> {
        self.refuse_modes("a range")?;
        let given = SurveyGiven::read(&RANGES, &self.arch, Spelling::Option)?;
        survey::draw(&self.arch, &given, self.weight, &printed)
    }

    /// The modes of a half opening as its friction grows.
    fn along(&self, path: &[String]) -> Result<(Vec<Sketch>, Between, ArchGiven), Failure> {
        let wrong = "--along takes a quantity and a range: --along friction 0.2..3";
        let [quantity, range] = path else { return Err(wrong.into()) };
        if !"friction".eq_ignore_ascii_case(quantity) {
            return Err(format!(
                "the modes are passed along the friction, not '{}': {wrong}",
                shown(quantity)
            )
            .into());
        }
        let [from, to] = Shown::range_of(range)?;
        let given = ArchGiven::read(&SLIDING, &self.arch, Spelling::Option)?;
        let Some(alpha) = &given.half_opening else { return Err(wrong.into()) };
        let passed = Passed::along_friction(self.weight, alpha, [from, to])?;
        let (sketches, between) = passed.into_iter().map(|one| (one.sketch, one.between)).unzip();
        Ok((sketches, between, given))
    }

    /// Sketch of what is asked for, in the modes asked for, with what is given.
    fn sketch(&self, look: &ArchLook) -> Result<(Sketch, ArchGiven), Failure> {
        let is_sliding = self.mode == Some(Mode::Sliding) && self.arch.friction_text().is_none();
        let has_thickness = self.arch.thickness.is_some();
        let is_any = self.at.is_some() || is_sliding && has_thickness;
        if is_any && self.arch.stones.is_some() {
            return Err(STONES.into());
        }
        let given = match self.at {
            Some(_) => ArchGiven::new(&self.arch, Spelling::Option)?,
            None if is_any => ArchGiven::read(&SLIDING, &self.arch, Spelling::Option)?,
            None => ArchGiven::read(&QUESTION, &self.arch, Spelling::Option)?,
        };
        let landmark = self.at.map(|landmark| Pose::Landmark(landmark, self.weight));
        let pose = landmark.map_or_else(|| Pose::of(&given, self.weight, is_sliding), Ok)?;
        let sketch = sketched(pose, &given, look, self.mode.filter(|_| !is_sliding))?;
        Ok((sketch, given))
    }
}
