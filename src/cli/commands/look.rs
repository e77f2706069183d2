//! The options of every picture of an arch.

use super::print::PrintArguments;
use crate::picture::Print;
use crate::report::{Format, Reported, Sketched, Style};
use crate::sweep::failure::Failure;
use clap::Args;

/// Look of an arch in a picture.
#[derive(Args)]
#[command(next_help_heading = "Options of pictures")]
pub(super) struct LookArguments {
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

    #[command(flatten)]
    print: PrintArguments,
}

/// Look of an arch, with its printing.
#[derive(Clone, Default)]
pub(super) struct ArchLook {
    pub style: Style,
    pub is_dilatant: bool,
    pub print: Print,
}

fn amplitude(text: &str) -> Result<f64, String> {
    let amplitude = text.parse().ok().filter(|r| Style::AMPLITUDES.contains(r));
    amplitude.ok_or_else(|| "an amplitude is a number from 0.001 to 1, in units of r".to_owned())
}

impl LookArguments {
    /// The look in a format of drawings; what is no drawing has none.
    pub(super) fn of(&self, format: &Format, is_drawn: bool) -> Result<ArchLook, Failure> {
        let Self { amplitude, dilatant, half, arrows, animate, ref print } = *self;
        let style = Style { amplitude, half, arrows, animate, notation: false };
        let look = ArchLook { style, is_dilatant: dilatant, print: print.of(format)? };
        let drawn = Format::names(Sketched::content());
        match look.unusual() {
            Some(name) if !is_drawn => {
                Err(format!("{name} is for a drawing of one arch ({drawn})").into())
            }
            _ if animate && format.name != "svg" => {
                Err(format!("only svg moves, not {}", format.name).into())
            }
            _ if arrows && !format.is_picture => {
                Err(format!("only svg, png and pdf have arrows, not {}", format.name).into())
            }
            _ => Ok(look),
        }
    }
}

impl ArchLook {
    /// An option of the look that is given.
    fn unusual(&self) -> Option<&'static str> {
        let is_moved = self.style.amplitude != Style::default().amplitude;
        self.of_one_upright().or(is_moved.then_some("--amplitude"))
    }

    fn of_one_upright(&self) -> Option<&'static str> {
        let all = [
            ("--dilatant", self.is_dilatant),
            ("--half", self.style.half),
            ("--arrows", self.style.arrows),
            ("--animate", self.style.animate),
        ];
        all.into_iter().find(|(_, is_given)| *is_given).map(|(name, _)| name)
    }

    /// Refuses what is of a picture of one upright arch beside a range or a tilt; blocks fall in the latter.
    pub(super) fn refuse_motion(&self, what: &str, falls: bool) -> Result<(), Failure> {
        match if falls { self.of_one_upright() } else { self.unusual() } {
            Some(name) => Err(only_upright(name, what)),
            None => Ok(()),
        }
    }
}

/// Refusal of an option that is of a picture of one upright arch.
pub(super) fn only_upright(name: &str, what: &str) -> Failure {
    format!("{name} is of a picture of one upright arch: leave it out beside {what}").into()
}
