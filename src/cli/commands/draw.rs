//! `couplet draw`.

use super::arch::RANGE_DIGITS;
use super::notes;
use super::output::{OutputFile, Printed};
use super::print::PrintArguments;
use super::{survey, tilt};
use crate::arch::SelfWeight;
use crate::ask::{
    ArchAsked, ArchGiven, ArchQuestion, Field, Misfit, Spelling, StonesAsked, SurveyGiven,
};
use crate::atlas::{Passed, Sketch};
use crate::cli::line::typed;
use crate::number::{Ball, shown};
use crate::picture::Print;
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
/// friction at which it slides. --stones: an arch of 2 to 500 stones, as couplet voussoirs proves it. In metres,
/// with --span and --rise or with --radius: sizes in the picture and its caption, and JSON and DXF in metres.
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

    /// How far the corner that moves most is moved, in units of r, from 0.001 to 1.
    #[arg(long, default_value = "0.12", value_name = "R", value_parser = amplitude, allow_negative_numbers = true)]
    amplitude: f64,

    /// Joints that slide open too, as the associated flow rule has it; the thickness is the same.
    #[arg(long)]
    dilatant: bool,

    /// Only the right half.
    #[arg(long)]
    half: bool,

    /// For svg, png and pdf: arrows from where the blocks were to where they are.
    #[arg(long)]
    arrows: bool,

    /// For svg: the blocks move, again and again; where nothing moves the picture is a still.
    #[arg(long)]
    animate: bool,

    /// Format: svg, png, pdf, json or dxf. If none is given, what the name of the file ends with tells it.
    #[arg(long, value_parser = parse::format(Sketched::content()))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,

    #[command(flatten)]
    print: PrintArguments,
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

fn amplitude(text: &str) -> Result<f64, String> {
    let amplitude = text.parse().ok().filter(|r| Style::AMPLITUDES.contains(r));
    amplitude.ok_or_else(|| "an amplitude is a number from 0.001 to 1, in units of r".to_owned())
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let format = arguments.file.format(arguments.format, Sketched::content(), "svg")?;
    if arguments.animate && format.name != "svg" {
        return Err(format!("only svg moves, not {}", format.name).into());
    }
    if arguments.arrows && !format.is_picture {
        return Err(format!("only svg, png and pdf have arrows, not {}", format.name).into());
    }
    let print = arguments.print.of(format)?;
    if arguments.arch.has_range() {
        return arguments.ranges(format, &print);
    }
    if arguments.arch.tilt.is_some() {
        return arguments.tilted((&arguments.file, format, print));
    }
    let style = Style {
        amplitude: arguments.amplitude,
        half: arguments.half,
        arrows: arguments.arrows,
        animate: arguments.animate,
        notation: false,
    };
    let (sketches, between, given) = match &arguments.along {
        Some(path) => arguments.along(path)?,
        None => {
            let (sketch, given) = arguments.sketch()?;
            (vec![sketch], Vec::new(), given)
        }
    };
    write((sketches, between), &given, style, (format, &print), &arguments.file)
}

/// Draws the arch that any question was about, as it stands or at its least thickness.
pub(super) fn arch(
    given: &ArchGiven,
    weight: SelfWeight,
    (file, format, print): Printed<'_>,
) -> Result<(), Failure> {
    let sketches = vec![drawn(given, weight)?.sketch()?];
    write((sketches, Vec::new()), given, Style::default(), (format, &print), file)
}

/// Arch of any question, as it is drawn.
fn drawn(given: &ArchGiven, weight: SelfWeight) -> Result<DrawnArch, Misfit> {
    let arch = given.arch(weight)?;
    let pose = match &given.thickness {
        Some(thickness) => Pose::Standing(arch, thickness.clone()),
        None => Pose::Least(arch),
    };
    Ok(DrawnArch { pose, stones: stones(given)?, is_dilatant: false })
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
    style: Style,
    (format, print): (&Format, &Print),
    file: &OutputFile,
) -> Result<(), Failure> {
    let measures = given.measures.clone();
    let drawn = Sketched { sketches, style, measures, between, command: typed() };
    if !drawn.can_be_drawn() {
        let message =
            "a drawing has a radius from 1mm to 1000000m, and forces of a size that doubles hold";
        return Err(message.into());
    }
    let file = file.open_for(format)?;
    notes::frictions(&given.friction);
    file.printed((&drawn, format, print), [""; 0])
}

impl Arguments {
    /// Refuses what is of a picture of one arch beside what is not drawn so.
    fn refuse_motion(&self, what: &str) -> Result<(), Failure> {
        let one_arch = [
            ("--at", self.at.is_some()),
            ("--mode", self.mode.is_some()),
            ("--along", self.along.is_some()),
            ("--dilatant", self.dilatant),
            ("--half", self.half),
            ("--arrows", self.arrows),
            ("--animate", self.animate),
        ];
        match one_arch.into_iter().find(|(_, is_given)| *is_given) {
            Some((name, _)) => Err(format!(
                "{name} is of a picture of one upright arch: leave it out beside {what}"
            )
            .into()),
            None => Ok(()),
        }
    }

    /// An arch under the largest acceleration that it bears.
    fn tilted(&self, printed: Printed<'_>) -> Result<(), Failure> {
        self.refuse_motion("--tilt")?;
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
    fn ranges(&self, format: &'static Format, print: &Print) -> Result<(), Failure> {
        self.refuse_motion("a range")?;
        let given = SurveyGiven::read(&RANGES, &self.arch, Spelling::Option)?;
        survey::draw(&self.arch, &given, self.weight, (&self.file, format, print))
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
    fn sketch(&self) -> Result<(Sketch, ArchGiven), Failure> {
        let is_dilatant = self.dilatant;
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
        let pose = match (self.at, given.thickness.clone()) {
            (Some(landmark), _) => Pose::Landmark(landmark, self.weight),
            (None, Some(thickness)) if is_sliding => {
                Pose::Sliding(given.arch(self.weight)?, thickness)
            }
            (None, Some(thickness)) => Pose::Standing(given.arch(self.weight)?, thickness),
            (None, None) => Pose::Least(given.arch(self.weight)?),
        };
        let sketch = DrawnArch { pose, stones: stones(&given)?, is_dilatant }.sketch()?;
        if sketch.stands() && (self.mode.is_some() || is_dilatant || self.animate) {
            let message = "the arch stands with that thickness, and does not move: leave out --mode, --dilatant and \
                           --animate, or --thickness";
            return Err(message.into());
        }
        let modes = if is_sliding { &[] } else { self.mode.as_slice() };
        Ok((sketch.in_modes(modes)?, given))
    }
}
