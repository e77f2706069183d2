//! `couplet equation`.

use super::output::OutputFile;
use crate::certify::Error;
use crate::certify::equation::{JointEquation, evaluate};
use crate::number::ExactNumber;
use crate::report::words::list;
use crate::report::{Content, EquationAtJoint, Format, Report};
use crate::sweep::failure::Failure;
use crate::sweep::parse::{self, Weights};
use clap::Args;

/// Evaluate an equation of the paper, (7) to (12), at a rotational joint, to any number of digits, with a proof.
///
/// (7): the cubics in A, eta and h with all of their real roots, and which of them are states; for Heyman's weight the
/// quadratics. (8): the identity between f, g, S, C and beta. (9), (10), (11): the closed forms of A, eta and h, as
/// printed and in trigonometric form, with the digits that they lose. (12): the radicand and its sign.
#[derive(Args)]
#[command(
    override_usage = "couplet equation <NUMBER> --rotation-joint <ANGLE> [--weight <WEIGHT>] [--digits <N>] [OPTIONS]"
)]
pub(crate) struct Arguments {
    /// Number of the equation: 7 to 12.
    #[arg(value_name = "NUMBER", value_parser = equation)]
    equation: JointEquation,

    /// Rotational joint from the crown, in radians (1.0, pi/3) or degrees (57deg), between 0 and pi.
    #[arg(long, value_name = "ANGLE", visible_alias = "beta", allow_hyphen_values = true)]
    rotation_joint: String,

    /// Self-weight model: heyman, milankovitch or both.
    #[arg(long, default_value = "milankovitch", value_parser = parse::weights)]
    weight: Weights,

    /// Significant digits, 1 to 10000; values are correctly rounded to them.
    #[arg(long, default_value = "30", value_parser = parse::state_digits, allow_negative_numbers = true)]
    digits: usize,

    #[arg(long, value_parser = parse::format(Content::Equation), help = parse::format_help(Content::Equation))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,
}

fn equation(text: &str) -> Result<JointEquation, String> {
    let numbers = JointEquation::ALL.map(|equation| equation.number().to_string());
    let numbers = list(numbers.iter().map(String::as_str));
    JointEquation::named(text).ok_or_else(|| format!("an equation at a joint is one of {numbers}"))
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let joint: ExactNumber = arguments.rotation_joint.parse()?;
    let format = arguments.file.format(arguments.format, Content::Equation, "table")?;
    let file = arguments.file.open_for(format)?;
    let answer = |weight| -> Result<EquationAtJoint, Failure> {
        let found = evaluate(arguments.equation, weight, &joint, arguments.digits);
        let (equation, joint) = (arguments.equation, joint.to_string());
        Ok(EquationAtJoint { equation, weight, joint, found: Error::apart(found)? })
    };
    let weights = arguments.weight.all().into_iter();
    let answers: Vec<EquationAtJoint> = weights.map(answer).collect::<Result<_, _>>()?;
    let open = answers.iter().find_map(EquationAtJoint::first_open);
    file.report((&Report::Equations(answers), format), open)
}
