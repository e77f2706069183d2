//! The tangents of the lines between modes in the landmarks.
//!
//! A line is an analytic curve up to its ends and, in the equations of its form, beyond them; there the slopes of
//! the unknowns to the parameter solve `F_x x' = -F_s`, by elimination over balls about the landmark's proved root.

use super::curve::Curve;
use super::end::{CurveEnd, EndValues};
use super::variable::Variable;
use crate::arch::SelfWeight;
use crate::certify::{Eliminated, Error, Refused, Undecided};
use crate::number::{Ball, Dual, Enclosure};
use crate::problem::{Landmark, Line};

/// `d eta/d phi`, `phi` in rad, of a line in one of the two landmarks between which it runs. Refused if it does not
/// end there, undecided if it may be upright.
pub fn tangent(line: Line, weight: SelfWeight, at: Landmark) -> Result<Ball, Error> {
    let curve = Curve::Line(line);
    let failed =
        |what: &str| Undecided::new(format!("the tangent of {line} at {}: {what}", at.symbol()));
    let mut legs = curve.legs(weight);
    let leg = match line.ends() {
        [_, Some(end)] if end == at => legs.pop(),
        [Some(end), _] if end == at => legs.into_iter().next(),
        _ => return Err(Refused::NoEnd { line, at }.into()),
    };
    let form = leg.ok_or_else(|| failed("it has no equations"))?.form;
    let values = EndValues::of(CurveEnd::Landmark(at), weight)?;
    let (s, x) = form.point(|variable| values.value(variable));
    let number = |given: &Ball| Dual::constant(given.clone());
    let rows = form.residuals(&number, &Dual::variable(s.clone(), x.len()), &Dual::variables(&x));
    let right = rows.iter().map(|row| -row.derivative(x.len())).collect();
    let eliminated = Eliminated::new(&rows).ok_or_else(|| failed("its form may be singular"))?;
    let slopes = eliminated.solve(right);
    let one = Ball::integer(1, s.prec());
    let slope = |variable| form.value(variable, &one, &slopes).cloned();
    let both = slope(Variable::Thickness).zip(slope(Variable::FrictionAngle));
    let tangent = both.map(|(eta, phi)| eta / phi).filter(Enclosure::is_bounded);
    Ok(tangent.ok_or_else(|| failed("it may be upright"))?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rounded;

    fn digits(line: Line, weight: SelfWeight, at: Landmark) -> String {
        let slope = tangent(line, weight, at).unwrap();
        Rounded::from_ball(&slope, 10).unwrap().value.to_string()
    }

    /// Beside slopes found at 110 digits by other equations.
    #[test]
    fn tangents_are_as_they_were_found_otherwise() {
        use {Landmark as L, Line as D, SelfWeight as W};
        for (line, at, heyman, milankovitch) in [
            (D::RotationShoulder, L::Triple, "1.849504241", "1.793726983"),
            (D::ShoulderEnd, L::Triple, "0.6352481888", "0.5887923569"),
            (D::RotationInner, L::Triple, "0.6352481888", "0.5887923569"),
            (D::AboveHaunchEnd, L::Triple, "2.046332889", "2.038806656"),
            (D::AboveHaunchEnd, L::Shift, "4.218155183", "5.278523015"),
            (D::BelowHaunchEnd, L::Shift, "4.218155183", "5.278523015"),
            (D::Joints, L::Shift, "0.1908056539", "0.2022514248"),
            (D::BelowHaunchEnd, L::Junction, "4.452488531", "5.878379089"),
            (D::CrownEnd, L::Junction, "4.452488531", "5.878379089"),
            (D::Crown, L::Junction, "0.1436731766", "0.1532026836"),
            (D::CrownEnd, L::Border, "9.695841849", "137.7709862"),
            // 1/√6 and (2 √3 - 3)/3^(1/4).
            (D::RotationInner, L::RotationEnd, "0.4082482904639", "0.3526409689502"),
        ] {
            for (weight, known) in [(W::Heyman, heyman), (W::Milankovitch, milankovitch)] {
                let known: f64 = known.parse().unwrap();
                let found: f64 = digits(line, weight, at).parse().unwrap();
                approx::assert_relative_eq!(found, known, max_relative = 1e-9);
            }
        }
    }

    #[test]
    fn a_line_has_no_tangent_where_it_does_not_end() {
        let nowhere = tangent(Line::RotationShoulder, SelfWeight::Heyman, Landmark::Junction);
        let refused = nowhere.unwrap_err().to_string();
        assert_eq!(refused, "the line rrr/srr does not end at J, but at T");
    }
}
