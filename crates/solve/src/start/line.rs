//! Start values on the lines of the map, at a given half opening or at a given friction.

use super::rotation::{before_end, rotational, rotational_with_thrust};
use super::scale::Start;
use super::sliding::{friction_inside, inner_sliding, sliding};
use super::touch::{ring_at_crown, rotational_sliding, touched_ring};
use super::wide::{widest_rotational, widest_sliding, widest_touching};
use crate::arch::{Configuration, SelfWeight, Unknown, sliding as friction};
use crate::number::Angle;
use crate::problem::{Line, Sought};
use crate::zero::zero;

/// Below this friction the rotational state at which the shoulder slides is found from the leading term.
const SLIPPERY: f64 = 1e-5;
/// A thrust below all others.
const LEAST_THRUST: f64 = 1e-12;

/// A candidate on a line, where the half opening or the friction is `given` and the other is sought. Only what
/// the equations of the line read is set.
pub fn on_line<T: Start>(
    weight: SelfWeight,
    line: Line,
    sought: Sought,
    given: &T,
) -> Configuration<T> {
    match sought {
        Sought::Friction => at_half_opening(weight, line, given),
        Sought::HalfOpening => at_friction(weight, line, given),
    }
}

/// Puts values to what is given.
fn point<T: Start>(given: Configuration<T>, values: &[(Unknown, T)]) -> Configuration<T> {
    values.iter().fold(given, |at, (unknown, value)| at.with(*unknown, value.clone()))
}

fn at_half_opening<T: Start>(weight: SelfWeight, line: Line, alpha: &T) -> Configuration<T> {
    use Unknown as U;
    let given = Configuration::zero(alpha).with(U::HalfOpening, alpha.clone());
    match line {
        Line::RotationShoulder | Line::RotationInner => {
            let [beta, eta, h] = rotational(weight, alpha);
            let joint = friction::steepest_joint(&h);
            let mu = match line {
                Line::RotationInner => friction::inner(&Angle::new(joint.clone()), &h).value(),
                _ => friction::shoulder(&Angle::new(alpha.clone()), &h).value(),
            };
            let rotation = [(U::RotationJoint, beta), (U::Thickness, eta), (U::Thrust, h)];
            point(given, &rotation).with(U::SlidingJoint, joint).with(U::Friction, mu)
        }
        Line::ShoulderEnd | Line::AboveHaunchEnd | Line::BelowHaunchEnd | Line::CrownEnd => {
            let [mu, h, joint] = sliding(alpha);
            let slides = [(U::Friction, mu), (U::Thrust, h), (U::SlidingJoint, joint)];
            with_haunch(weight, line, point(given, &slides))
        }
        Line::Joints | Line::Crown => {
            let wide = alpha.to_double();
            let [_, most, _] = sliding(alpha).map(|x| x.to_double());
            let least = match before_end(weight, wide) > 0.0 {
                true => rotational(weight, alpha)[2].to_double(),
                false => LEAST_THRUST,
            };
            // Where the thrust is h, how far the rotational joint is below the other, or the crown.
            let joint = |h: f64| rotational_sliding(weight, wide, h).joint.unwrap_or(0.0);
            let rings = |h: f64| [touched_ring(weight, 1.0, h), ring_at_crown(weight, wide, h)];
            let h = zero(least, most, |h| match line {
                Line::Joints => joint(h) - friction::steepest_joint(&h),
                _ => {
                    let [touched, at_crown] = rings(h).map(|ring| ring.thickness);
                    touched - at_crown
                }
            });
            let steepest = friction::steepest_joint(&h);
            let mu = friction_inside([h, steepest]).value();
            let eta = rotational_sliding(weight, wide, h).thickness;
            let values = [
                (U::Friction, mu),
                (U::Thrust, h),
                (U::SlidingJoint, steepest),
                (U::Thickness, eta),
            ];
            point(given, &values.map(|(unknown, value)| (unknown, alpha.like(value))))
        }
    }
}

fn at_friction<T: Start>(weight: SelfWeight, line: Line, mu: &T) -> Configuration<T> {
    use Unknown as U;
    let given = Configuration::zero(mu).with(U::Friction, mu.clone());
    let alpha = match line {
        Line::RotationShoulder => rotating(weight, mu),
        Line::RotationInner => {
            let [h, _] = inner_sliding(mu);
            let [_, eta, _] = rotational_with_thrust(weight, &h);
            widest_rotational(weight, &eta, &h)
        }
        Line::ShoulderEnd | Line::AboveHaunchEnd | Line::BelowHaunchEnd | Line::CrownEnd => {
            let [alpha, h, joint] = widest_sliding(mu);
            let slides = [(U::Thrust, h), (U::SlidingJoint, joint), (U::HalfOpening, alpha)];
            return with_haunch(weight, line, point(given, &slides));
        }
        Line::Joints | Line::Crown => {
            let [h, joint] = inner_sliding(mu);
            let beta = if line == Line::Joints { joint.to_double() } else { 0.0 };
            let times_cotangent = if beta > 0.0 { beta / beta.tan() } else { 1.0 };
            let eta = touched_ring(weight, times_cotangent, h.to_double()).thickness;
            let alpha = mu.like(widest_touching(weight, eta, h.to_double(), beta));
            let values = [(U::HalfOpening, alpha), (U::Thickness, mu.like(eta)), (U::Thrust, h)];
            return point(given, &values).with(U::SlidingJoint, joint);
        }
    };
    at_half_opening(weight, line, &alpha).with(U::Friction, mu.clone())
}

/// The half opening whose rotational state asks for a friction at the shoulder.
fn rotating<T: Start>(weight: SelfWeight, mu: &T) -> T {
    if *mu < SLIPPERY {
        // alpha³/6.
        return (mu.int(6) * mu).cube_root();
    }
    let end = zero(2.0, 3.0, |alpha| before_end(weight, alpha));
    let target = mu.to_double();
    let found = zero(1e-3, end, |alpha| {
        let [_, _, h] = rotational(weight, &mu.clone().cut(64).like(alpha)).map(|x| x.to_double());
        friction::shoulder(&Angle::new(alpha), &h).value() - target
    });
    mu.like(found)
}

/// The thickness and the rotational joint at the thrust of a purely sliding state.
fn with_haunch<T: Start>(weight: SelfWeight, line: Line, at: Configuration<T>) -> Configuration<T> {
    let h = at.thrust.clone();
    let [beta, eta] = match line {
        Line::ShoulderEnd => {
            let [beta, eta, _] = rotational_with_thrust(weight, &h);
            [beta, eta]
        }
        _ => {
            let start = rotational_sliding(weight, at.half_opening.rad.to_double(), h.to_double());
            [h.like(start.joint.unwrap_or(0.0)), h.like(start.thickness)]
        }
    };
    at.with(Unknown::RotationJoint, beta).with(Unknown::Thickness, eta)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight::{Heyman, Milankovitch};
    use rug::Float;

    /// On every line, at a friction and at the half opening found there.
    #[test]
    fn the_equations_hold_at_the_start() {
        for (line, weight, mu) in [
            (Line::RotationShoulder, Heyman, 0.6),
            (Line::RotationShoulder, Milankovitch, 1e-9),
            (Line::RotationInner, Milankovitch, 2.0),
            (Line::ShoulderEnd, Heyman, 0.3),
            (Line::ShoulderEnd, Heyman, 1e-9),
            (Line::AboveHaunchEnd, Milankovitch, 1.4),
            (Line::BelowHaunchEnd, Milankovitch, 1.542),
            (Line::CrownEnd, Heyman, 2.2),
            (Line::Joints, Milankovitch, 1.8),
            (Line::Crown, Heyman, 3.0),
        ] {
            let friction = Float::with_val(300, mu);
            let at = on_line(weight, line, Sought::HalfOpening, &friction);
            let alpha = at.half_opening.rad.clone();
            let back = on_line(weight, line, Sought::Friction, &alpha);
            approx::assert_relative_eq!(back.friction.to_f64(), mu, max_relative = 1e-2);
            for (found, sought) in [(at, Sought::HalfOpening), (back, Sought::Friction)] {
                let system = line.system(weight, sought);
                let placed = system.place(found.clone(), &system.values(&found));
                for (equation, residual) in system.equations.iter().zip(system.residuals(&placed)) {
                    assert!(residual.clone().abs() < 1e-3, "{line} {equation:?}: {residual}");
                }
            }
        }
    }
}
