//! `couplet equation`.

use super::by_value::option;
use super::output::OutputFile;
use crate::certify::Error;
use crate::certify::equation::NumberedEquation;
use crate::number::ExactNumber;
use crate::problem::Quantity;
use crate::report::words::list;
use crate::report::{EvaluatedEquation, Format, Reported};
use crate::sweep::failure::Failure;
use crate::sweep::parse::{self, Weights};
use clap::Args;

/// Evaluate an equation of the paper, (2) to (18), with a proof.
///
/// At a rotational joint, (7): the cubics in A, eta and h with all of their real roots, and which of them are states;
/// for Heyman's weight the quadratics. (8): the identity between f, g, S, C and beta. (9), (10), (11): the closed forms
/// of A, eta and h, as printed and in trigonometric form, with the digits that they lose. (12): the radicand and its
/// sign. The others give a value: the thrusts of (2) to (5), the centroid factor (6), purely overturning states (13) to
/// (15), the end of rotation (16), the frictions of (17) and (18).
#[derive(Args)]
#[command(
    override_usage = "couplet equation <7 to 12> --rotation-joint <ANGLE> [OPTIONS]\n       \
                            couplet equation <NUMBER> [--half-opening <ANGLE>] [--rotation-joint <ANGLE>] \
                            [--thickness <ETA>] [--thrust <H>] [--opening-variable <A>] [OPTIONS]"
)]
pub(crate) struct Arguments {
    /// Number of the equation: 2 to 18.
    #[arg(value_name = "NUMBER", value_parser = equation)]
    equation: NumberedEquation,

    /// Half opening, in radians or degrees (80deg), between 0 and pi.
    #[arg(long, value_name = "ANGLE", visible_alias = "alpha", allow_hyphen_values = true)]
    half_opening: Option<String>,

    /// Rotational joint from the crown, in radians (1.0, pi/3) or degrees (57deg), between 0 and pi.
    #[arg(long, value_name = "ANGLE", visible_alias = "beta", allow_hyphen_values = true)]
    rotation_joint: Option<String>,

    /// Thickness-to-radius ratio, above 0 and up to 2.
    #[arg(long, value_name = "ETA", visible_alias = "eta", allow_hyphen_values = true)]
    thickness: Option<String>,

    /// Thrust H/(w r), between 0 and 1.
    #[arg(long, value_name = "H", allow_hyphen_values = true)]
    thrust: Option<String>,

    /// A = alpha cot(alpha/2), between 0 and 2.
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    opening_variable: Option<String>,

    /// Self-weight model: heyman, milankovitch or both.
    #[arg(long, default_value = "milankovitch", value_parser = parse::weights)]
    weight: Weights,

    /// Significant digits, 1 to 1000000; values are correctly rounded to them.
    #[arg(long, default_value = "30", value_parser = parse::digits, allow_negative_numbers = true)]
    digits: usize,

    #[arg(long, value_parser = parse::format(EvaluatedEquation::content()), help = parse::format_help(EvaluatedEquation::content()))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,
}

fn equation(text: &str) -> Result<NumberedEquation, &'static str> {
    NumberedEquation::named(text).ok_or("an equation is a number from 2 to 18")
}

impl Arguments {
    /// Values that are given, those that the equation needs and no others.
    fn given(&self) -> Result<Vec<(Quantity, ExactNumber)>, Failure> {
        let all = [
            (Quantity::HalfOpening, &self.half_opening),
            (Quantity::RotationJoint, &self.rotation_joint),
            (Quantity::Thickness, &self.thickness),
            (Quantity::Thrust, &self.thrust),
            (Quantity::OpeningVariable, &self.opening_variable),
        ];
        let choices = self.equation.choices();
        let misfit = |choice: &&[Quantity]| {
            all.iter().find(|(of, text)| choice.contains(of) != text.is_some())
        };
        let misfits: Option<Vec<_>> = choices.iter().map(misfit).collect();
        if let Some(misfits) = misfits {
            let takes =
                if misfits.iter().all(|(_, text)| text.is_some()) { "takes only" } else { "needs" };
            let number = self.equation.number();
            let names = |choice: &&[Quantity]| {
                let names: Vec<String> = choice.iter().map(|of| option(*of)).collect();
                list(names.iter().map(String::as_str))
            };
            let choices = choices.iter().map(names).collect::<Vec<_>>().join("; or ");
            return Err(format!("equation ({number}) {takes} {choices}").into());
        }
        let given = all.into_iter().filter_map(|(of, text)| Some((of, text.as_ref()?)));
        given.map(|(of, text)| Ok((of, text.parse()?))).collect()
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let given = arguments.given()?;
    let format = arguments.file.format(arguments.format, EvaluatedEquation::content(), "table")?;
    let file = arguments.file.open_for(format)?;
    let answer = |weight| -> Result<EvaluatedEquation, Failure> {
        let equation = arguments.equation;
        let found = Error::apart(equation.evaluate(weight, &given, arguments.digits))?;
        let given = given.iter().map(|(of, value)| (*of, value.to_string())).collect();
        Ok(EvaluatedEquation { equation, weight, given, found })
    };
    let weights = arguments.weight.iter().copied();
    let answers: Vec<EvaluatedEquation> = weights.map(answer).collect::<Result<_, _>>()?;
    let open = answers.iter().find_map(EvaluatedEquation::first_open);
    file.report((&answers, format), open)
}
