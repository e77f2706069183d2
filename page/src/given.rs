//! What is given of an arch, read as the command reads it.

use crate::question::Question;
use crate::rounding::{BITS, rounded};
use couplet_check::problem::measures::{Circle, Length, Measures, of_span_and_rise};
use couplet_check::problem::{self, Arch, Friction, Known};
use couplet_number::number::{DoubleDouble, DoubleDoubleBall, ExactNumber, Field, Real};

/// What is given of an arch.
pub(crate) struct Given {
    /// The arch.
    pub(crate) arch: Arch,
    /// Its thickness, if it has one.
    pub(crate) thickness: Option<ExactNumber>,
    /// Its size, if it is measured.
    pub(crate) measures: Option<Measures>,
}

/// Reads it; span and rise are those of the intrados, unless another circle is named.
pub(crate) fn given(question: &Question) -> Result<Given, String> {
    let Question { weight, half_opening, span, rise, measured_at, friction, .. } = question;
    let circle = measured_at.as_deref().map_or(Ok(Circle::default()), str::parse);
    let circle = circle.map_err(|names| format!("an arch is measured at {names}"))?;
    let length = |text: &str| text.parse::<Length>().map_err(|error| error.to_string());
    let mut measures = None;
    let half_opening = match (half_opening, span, rise) {
        (Some(half_opening), None, None) => half_opening.clone(),
        (None, Some(span), Some(rise)) => {
            let (half_opening, radius) = of_span_and_rise(&length(span)?, &length(rise)?);
            measures = Some(Measures::new(circle, radius, None));
            half_opening.to_string()
        }
        _ => return Err("an arch has a half opening, or a span and a rise".into()),
    };
    let arch = Arch::parse(weight, &half_opening, friction).map_err(|error| error.to_string())?;
    let thickness = question.thickness.as_deref();
    let thickness = thickness.map(|text| problem::thickness(text, measures.as_ref()));
    let thickness = thickness.transpose().map_err(|error| error.to_string())?;
    Ok(Given { arch, thickness, measures })
}

/// As a shell reads it.
fn quoted(value: &impl ToString) -> String {
    let text = value.to_string();
    if text.contains('(') { format!("'{text}'") } else { text }
}

impl Given {
    /// The command that makes the certificate.
    pub(crate) fn command(&self) -> String {
        let (subject, thickness) = match &self.thickness {
            Some(eta) => ("arch", format!(" --thickness {}", quoted(eta))),
            None => ("state", String::new()),
        };
        let (weight, arch) = (self.arch.weight().name(), &self.arch);
        let [alpha, mu] = [quoted(arch.half_opening()), quoted(arch.friction())];
        format!(
            "couplet certify {subject} --weight {weight} --half-opening {alpha} --friction {mu}{thickness} -o arch.json"
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
