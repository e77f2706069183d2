//! The part of `couplet state` that is given another quantity than the half opening.

use super::arch::ArchArguments;
use super::notes;
use super::output::{AnswerOutput, is_written};
use crate::ask::{ArchAsked, ArchGiven, Field, Spelling};
use crate::certify::Error;
use crate::certify::state::find::StatesByValue;
use crate::number::ExactNumber;
use crate::problem::{Friction, Quantity};
use crate::report::{ByValue, Reported};
use crate::sweep::failure::Failure;
use clap::Args;

/// Quantities that may be given in place of the half opening; the thickness is a field of every arch.
#[derive(Args)]
#[group(skip)]
pub(super) struct ValueArguments {
    /// Rotational joint instead of the half opening (1.0, pi/3, 57deg): all states with it.
    #[arg(long, value_name = "ANGLE", visible_alias = "beta", allow_hyphen_values = true)]
    rotation_joint: Option<String>,

    /// Thrust H/(w r) instead, between 0 and 1.
    #[arg(long, value_name = "H", allow_hyphen_values = true)]
    thrust: Option<String>,

    /// A = alpha cot(alpha/2) instead, between 0 and 2.
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    opening_variable: Option<String>,
}

/// Fields that go with a quantity in place of the half opening.
const WITH: [Field; 3] = [Field::Friction, Field::FrictionAngle, Field::Thickness];
const ONE: &str =
    "give one of --half-opening, --rotation-joint, --thrust, --thickness and --opening-variable";

/// Spelling of a quantity as an option; the variable `A` has a long one.
pub(super) fn option(quantity: Quantity) -> String {
    match quantity {
        Quantity::OpeningVariable => "--opening-variable".to_owned(),
        other => format!("--{}", other.name().replace('_', "-")),
    }
}

impl ValueArguments {
    /// Question that is asked by another quantity, if it is.
    pub(super) fn question(&self, asked: &ArchAsked) -> Result<Option<StatesByValue>, Failure> {
        let texts = [
            (Quantity::RotationJoint, &self.rotation_joint),
            (Quantity::Thrust, &self.thrust),
            (Quantity::OpeningVariable, &self.opening_variable),
        ];
        let given: Vec<(Quantity, &String)> =
            texts.into_iter().filter_map(|(of, text)| Some((of, text.as_ref()?))).collect();
        let other = asked.fields().find(|field| !WITH.contains(field));
        let by_thickness = asked.thickness.is_some() && other.is_none();
        let (quantity, text) = match (&given[..], by_thickness) {
            ([], false) => return Ok(None),
            ([], true) => (Quantity::Thickness, None),
            ([one], false) => (one.0, Some(one.1)),
            _ => return Err(ONE.into()),
        };
        match other {
            Some(Field::HalfOpening) => return Err(ONE.into()),
            Some(other) => {
                let (name, quantity) = (Spelling::Option.of(other), option(quantity));
                return Err(format!("{name} does not go with {quantity}").into());
            }
            None if given.len() == 1 && asked.thickness.is_some() => return Err(ONE.into()),
            None => {}
        }
        let read = ArchGiven::new(asked, Spelling::Option)?;
        let value: Option<ExactNumber> = match text {
            Some(text) => Some(text.parse()?),
            None => read.thickness,
        };
        let Some(value) = value else { return Ok(None) };
        let friction = read.friction.unwrap_or(Friction::Infinite);
        Ok(Some(StatesByValue::new((quantity, value), friction)?))
    }
}

/// Prints all states with a value.
pub(super) fn print(
    asked: &StatesByValue,
    arch: &ArchArguments,
    output: &AnswerOutput,
) -> Result<(), Failure> {
    let quantities = output.quantities(&StatesByValue::VALUES)?;
    let format = output.format()?;
    is_written("a state by another quantity", ByValue::content(), format)?;
    notes::frictions([asked.friction()]);
    let file = output.file().open_for(format)?;
    let answer = |weight| -> Result<ByValue, Failure> {
        let found = Error::apart(asked.find(weight, arch.digits()))?;
        Ok(ByValue { weight, asked: asked.clone(), quantities: quantities.clone(), found })
    };
    let all: Vec<ByValue> = arch.weight.iter().copied().map(answer).collect::<Result<_, _>>()?;
    let open: Vec<String> =
        all.iter().filter_map(ByValue::first_open).map(ToString::to_string).collect();
    file.report((&all, format), open.first())
}
