//! What is given of an arch, read as the command reads it.

use crate::question::Question;
use crate::rounding::{BITS, rounded};
use couplet_ask::{ArchAsked, ArchGiven, ArchQuestion, Spelling};
use couplet_check::arch::{NoWeight, SelfWeight};
use couplet_check::problem::measures::Measures;
use couplet_check::problem::{Arch, Friction, Known};
use couplet_number::number::{DoubleDouble, DoubleDoubleBall, ExactNumber, Field, Form, Real};

/// What is given of an arch.
pub(crate) struct Given {
    /// The arch.
    pub(crate) arch: Arch,
    /// Its thickness, if it has one.
    pub(crate) thickness: Option<ExactNumber>,
    /// Its size, if it is measured.
    pub(crate) measures: Option<Measures>,
    /// What may have been meant otherwise.
    pub(crate) note: Option<String>,
}

/// Reads it; span and rise are those of the intrados, unless another circle is named.
pub(crate) fn given(question: &Question) -> Result<Given, String> {
    let Question { weight, half_opening, span, rise, radius, measured_at, .. } = question;
    let asked = ArchAsked {
        half_opening: half_opening.clone(),
        span: span.clone(),
        rise: rise.clone(),
        measured_at: measured_at.clone(),
        radius: radius.clone(),
        friction: question.friction.clone(),
        thickness: question.thickness.clone(),
        ..ArchAsked::default()
    };
    let weight: SelfWeight = weight.parse().map_err(|none: NoWeight| none.to_string())?;
    if asked.has_range() {
        return Err(ranges(&asked, weight));
    }
    let given = ArchGiven::read(&ArchQuestion::ANY, &asked, Spelling::Key);
    let given = given.map_err(|misfit| misfit.to_string())?;
    let arch = given.arch(weight).map_err(|misfit| misfit.to_string())?;
    let note = given.notes().into_iter().next();
    Ok(Given { arch, thickness: given.thickness, measures: given.measures, note })
}

/// Sentence on ranges, which have no place here: with the command that tells of every arch inside.
fn ranges(asked: &ArchAsked, weight: SelfWeight) -> String {
    let question = if asked.thickness.is_some() { "assess" } else { "state" };
    let (options, weight) = (asked.options(), weight.name());
    format!(
        "a range is every arch inside, of which the command tells: couplet {question}{options} --weight {weight}; \
         give one value here"
    )
}

/// As a shell reads it.
fn quoted(value: &impl ToString) -> String {
    let text = value.to_string();
    if text.contains('(') { format!("'{text}'") } else { text }
}

impl Given {
    /// The command that makes the certificate or, where none can have the half opening, that proves the answer.
    pub(crate) fn command(&self) -> String {
        let thickness = self.thickness.as_ref().map(|eta| format!(" --thickness {}", quoted(eta)));
        let has_file = self.arch.half_opening().form() != Form::ArctangentOfRoot;
        let (command, file) = match (has_file, &thickness) {
            (true, Some(_)) => ("certify arch", " -o arch.json"),
            (true, None) => ("certify state", " -o arch.json"),
            (false, Some(_)) => ("assess", ""),
            (false, None) => ("state", ""),
        };
        let thickness = thickness.unwrap_or_default();
        let (weight, arch) = (self.arch.weight().name(), &self.arch);
        let [alpha, mu] = [quoted(arch.half_opening()), quoted(arch.friction())];
        format!(
            "couplet {command} --weight {weight} --half-opening {alpha} --friction {mu}{thickness}{file}"
        )
    }

    /// What is given in other units, each correctly rounded to as many of `digits` digits as are decided. The names are
    /// not those of results: a limit may be one of the same quantity.
    pub(crate) fn values(&self, digits: usize) -> Vec<(&'static str, String)> {
        let at = self.arch.given::<DoubleDoubleBall>(BITS);
        let alpha = &at.half_opening.rad;
        let radian = alpha.int(180) / alpha.pi();
        let mut all = vec![
            ("given_half_opening", rounded(alpha, digits)),
            ("given_half_opening_degrees", rounded(&(radian * alpha), digits)),
        ];
        if *self.arch.friction() == Friction::Infinite {
            let infinite = |name| (name, Some("∞".to_owned()));
            all.extend([infinite("given_friction")]);
            all.push(("given_friction_angle_degrees", Some("90".to_owned())));
        } else {
            let near = at.friction.mid().hi().atan();
            let near = DoubleDoubleBall::exact(DoubleDouble::exact(near));
            let angle = Known::AngleOfTangent(at.friction).enclosed(&near, BITS as usize);
            let angle = angle.map(|angle| radian * angle);
            all.push(("given_friction", rounded(&at.friction, digits)));
            all.push((
                "given_friction_angle_degrees",
                angle.and_then(|angle| rounded(&angle, digits)),
            ));
        }
        let exact = |x: &ExactNumber| rounded(&x.enclosure(BITS), digits);
        all.extend(self.thickness.as_ref().map(|eta| ("given_thickness", exact(eta))));
        if let (Some(eta), Some(measures)) = (&self.thickness, &self.measures) {
            let sizes = measures.sizes(&eta.enclosure(BITS), alpha, BITS);
            all.push(("radius_m", rounded(&sizes.radius, digits)));
            all.push(("given_thickness_m", rounded(&sizes.thickness, digits)));
        }
        all.into_iter().filter_map(|(name, value)| Some((name, value?))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_gets_the_command_that_answers_it() {
        let text = |text: &str| Some(text.to_owned());
        let asked = Question {
            weight: "heyman".to_owned(),
            half_opening: text("79deg..81deg"),
            friction: text("0.6±10%"),
            ..Question::default()
        };
        let refused = given(&asked).err().unwrap();
        let command =
            "couplet state --half-opening 79deg..81deg --friction '0.6±10%' --weight heyman;";
        assert!(refused.contains(command), "{refused}");
        let refused = given(&Question { thickness: text("0.1"), ..asked }).err().unwrap();
        assert!(
            refused.contains("couplet assess") && refused.contains("--thickness 0.1"),
            "{refused}"
        );
    }

    /// Of a span and a radius there is no certificate, but an answer.
    #[test]
    fn the_command_is_one_that_answers() {
        let text = |text: &str| Some(text.to_owned());
        let [span, radius, friction] = ["3300mm", "1995mm", "0.6"].map(text);
        let weight = "heyman".to_owned();
        let asked = Question { weight, span, radius, friction, ..Question::default() };
        let of = |asked: &Question| given(asked).ok().unwrap().command();
        let arch = "--weight heyman --half-opening 'atan(√(12100/5589))' --friction 0.6";
        assert_eq!(of(&asked), format!("couplet state {arch}"));
        let thick = Question { thickness: text("0.1r"), ..asked.clone() };
        assert_eq!(of(&thick), format!("couplet assess {arch} --thickness 0.1"));
        let by_rise = Question { rise: text("1m"), radius: None, ..asked };
        assert!(
            of(&by_rise).starts_with("couplet certify state ")
                && of(&by_rise).ends_with(" -o arch.json")
        );
    }

    /// What every door is asked.
    #[test]
    fn every_question_is_read_or_refused_as_elsewhere() {
        let mut seen = [0, 0];
        for line in include_str!("../../tests/questions.txt").lines() {
            let Some((_, fields)) = line.trim_start_matches("! ").split_once(' ') else { continue };
            if line.starts_with('#') {
                continue;
            }
            let mut question = Question { weight: "heyman".to_owned(), ..Question::default() };
            for (name, text) in fields.split(' ').filter_map(|pair| pair.split_once('=')) {
                let field = match name {
                    "friction" => &mut question.friction,
                    "half_opening" => &mut question.half_opening,
                    "span" => &mut question.span,
                    "rise" => &mut question.rise,
                    "radius" => &mut question.radius,
                    "measured_at" => &mut question.measured_at,
                    "thickness" => &mut question.thickness,
                    _ => panic!("the page has no field {name}"),
                };
                *field = Some(text.to_owned());
            }
            let makes_sense = !line.starts_with('!');
            assert_eq!(given(&question).is_ok(), makes_sense, "{line}");
            seen[usize::from(makes_sense)] += 1;
        }
        assert!(seen[0] > 5 && seen[1] > 5, "{seen:?}");
    }
}
