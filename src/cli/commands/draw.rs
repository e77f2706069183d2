//! `couplet draw`.

use super::arch::{Missing, ShapeArguments};
use super::measures::{MeasureArguments, MeasuredArch};
use super::notes;
use super::output::OutputFile;
use crate::arch::SelfWeight;
use crate::atlas::Sketch;
use crate::cli::line::typed;
use crate::problem::{Landmark, Mode};
use crate::report::{Content, Format, Report, Sketched, Style};
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use crate::sweep::scene::{DrawnArch, Pose};
use clap::Args;

/// Draw an arch at its least thickness, how it falls there, or an arch as it stands.
///
/// Without --thickness: the arch at its least thickness, its lines of thrust and of friction, and its mechanism.
/// With it: the lines of the least and of the largest thrust, what limits each, and the safety. --at: a landmark,
/// one picture for each mode that is possible there. --mode [s,s] with --thickness and no friction: an arch at the
/// friction at which it slides. --stones: an arch of so many stones, as couplet voussoirs proves it. In metres,
/// with --span and --rise or with --radius: sizes in the picture and its caption, and JSON and DXF in metres.
#[derive(Args)]
#[command(
    override_usage = "couplet draw --half-opening <ANGLE> --friction <MU> [--thickness <ETA>] [OPTIONS]\n       \
                            couplet draw --at <LANDMARK> [--mode <MODE>] [OPTIONS]"
)]
pub(crate) struct Arguments {
    #[command(flatten)]
    shape: ShapeArguments,

    /// Self-weight model: heyman or milankovitch.
    #[arg(long, default_value = "milankovitch", value_parser = parse::weight)]
    weight: SelfWeight,

    /// Thickness-to-radius ratio of an arch as it stands, between 0 and 2 (0.12, 3/25, 0.12r); of an arch in metres a
    /// length (60cm), or a ratio with its r.
    #[arg(long, visible_alias = "eta", value_name = "ETA", allow_hyphen_values = true)]
    thickness: Option<String>,

    /// A landmark instead of an arch, by symbol or name: T, S, J, B, l or L.
    #[arg(
        long, value_name = "LANDMARK", value_parser = parse::landmark,
        conflicts_with_all = ["half_opening", "friction", "friction_angle", "thickness", "span", "radius", "density"]
    )]
    at: Option<Landmark>,

    /// Only this mode, where several are possible (rrs, [s,s]).
    #[arg(long, value_name = "MODE", value_parser = parse::mode)]
    mode: Option<Mode>,

    /// How far the corner that moves most is moved, in units of r, from 0.001 to 1.
    #[arg(long, default_value = "0.12", value_name = "R", value_parser = amplitude, allow_negative_numbers = true)]
    amplitude: f64,

    /// Joints that slide open too, as the associated flow rule has it; the thickness is the same.
    #[arg(long)]
    dilatant: bool,

    /// Only the right half.
    #[arg(long)]
    half: bool,

    /// For svg and png: arrows from where the blocks were to where they are.
    #[arg(long)]
    arrows: bool,

    /// An arch of so many stones, 2 to 500, which opens and slides between them alone: at its own least thickness,
    /// or as it stands.
    #[arg(long, value_name = "N", value_parser = stones, allow_negative_numbers = true)]
    stones: Option<u32>,

    /// For svg: the blocks move, again and again; where nothing moves the picture is a still.
    #[arg(long)]
    animate: bool,

    /// Format: svg, png, json or dxf. If none is given, what the name of the file ends with tells it.
    #[arg(long, value_parser = parse::format(Content::Drawing))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,

    #[command(flatten)]
    measures: MeasureArguments,
}

/// Message why there are no stones.
const STONES: &str = "--stones is for an arch with --half-opening and --friction: a landmark, and an arch at the \
                      friction at which it slides, have a joint at every angle";

/// A command line that has everything.
const EXAMPLE: &str = "couplet draw --half-opening 80deg --friction 0.35 -o arch.svg";

fn amplitude(text: &str) -> Result<f64, String> {
    let amplitude = text.parse().ok().filter(|r| Style::AMPLITUDES.contains(r));
    amplitude.ok_or_else(|| "an amplitude is a number from 0.001 to 1, in units of r".to_owned())
}

fn stones(text: &str) -> Result<u32, String> {
    let stones = text.parse().ok().filter(|n| Style::STONES.contains(n));
    stones.ok_or_else(|| "stones are a whole number from 2 to 500".to_owned())
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let format = arguments.file.format(arguments.format, Content::Drawing, "svg")?;
    if arguments.animate && format.name != "svg" {
        return Err(format!("only svg moves, not {}", format.name).into());
    }
    if arguments.arrows && !format.is_picture {
        return Err(format!("only svg and png have arrows, not {}", format.name).into());
    }
    let measured = arguments.measures.measured()?;
    let sketch = arguments.sketch(&measured)?;
    let style = Style {
        amplitude: arguments.amplitude,
        half: arguments.half,
        arrows: arguments.arrows,
        animate: arguments.animate,
        notation: false,
    };
    let drawn =
        Sketched { sketches: vec![sketch], style, measures: measured.measures, command: typed() };
    if !drawn.can_be_drawn() {
        let message =
            "a drawing has a radius from 1mm to 1000000m, and forces of a size that doubles hold";
        return Err(message.into());
    }
    let file = arguments.file.open_for(format)?;
    notes::frictions(&arguments.shape.friction());
    let report = Report::Sketched(drawn);
    file.write(|out| report.write(format, out))
}

impl Arguments {
    /// Sketch of what is asked for, in the modes asked for.
    fn sketch(&self, measured: &MeasuredArch) -> Result<Sketch, Failure> {
        let (stones, is_dilatant) = (self.stones.map(u64::from), self.dilatant);
        let shape = self.shape.with_half_opening(measured.half_opening.as_ref());
        let is_sliding = self.mode == Some(Mode::Sliding) && !shape.has_friction();
        if stones.is_some() && (self.at.is_some() || is_sliding && self.thickness.is_some()) {
            return Err(STONES.into());
        }
        let thickness = |eta: &String| measured.thickness(eta);
        let needs = Missing { option: None, example: EXAMPLE };
        let pose = match (self.at, self.thickness.as_ref().map(thickness).transpose()?) {
            (Some(landmark), _) => Pose::Landmark(landmark, self.weight),
            (None, Some(thickness)) if is_sliding => {
                Pose::Sliding(shape.without_friction(self.weight, &needs)?, thickness)
            }
            (None, Some(_)) if self.mode.is_some() || is_dilatant || self.animate => {
                let message = "an arch as it stands does not move: leave out --mode, --dilatant and --animate, or \
                               --thickness";
                return Err(message.into());
            }
            (None, Some(thickness)) => Pose::Standing(shape.arch(self.weight, &needs)?, thickness),
            (None, None) => Pose::Least(shape.arch(self.weight, &needs)?),
        };
        let is_moved = matches!(pose, Pose::Landmark(..) | Pose::Least(_));
        let sketch = DrawnArch { pose, stones, is_dilatant }.sketch()?;
        Ok(if is_moved { sketch.in_modes(self.mode.as_slice())? } else { sketch })
    }
}
