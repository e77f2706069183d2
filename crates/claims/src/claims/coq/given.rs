//! Given values of an arch, as Coq reads them.

use super::names::symbol;
use super::numeral::text;
use crate::arch::Unknown;
use crate::number::{ExactNumber, Form};
use crate::problem::{Arch, Friction, System};

/// Names and values of what a system is given.
pub(super) fn given(system: &System, arch: &Arch) -> Vec<(&'static str, String)> {
    let values = [
        (Unknown::HalfOpening, Some(number(arch.half_opening()))),
        (Unknown::Friction, friction(arch)),
    ];
    let asked = values.into_iter().filter(|(unknown, _)| !system.knows(*unknown));
    asked.filter_map(|(unknown, value)| Some((symbol(unknown), value?))).collect()
}

/// The friction, where it has a limit.
pub(super) fn friction(arch: &Arch) -> Option<String> {
    match arch.friction() {
        Friction::Coefficient(mu) => Some(number(mu)),
        Friction::Angle(phi) => Some(format!("tan ({})", number(phi))),
        Friction::Infinite => None,
    }
}

fn number(x: &ExactNumber) -> String {
    let factor = x.to_rational();
    match x.form() {
        Form::Rational => return text(&factor),
        Form::TwiceArctangent => return format!("2 * atan ({})", text(&factor)),
        Form::TimesPi => {}
    }
    let above = match factor.numer() {
        one if *one == 1 => "PI".into(),
        n => format!("{n} * PI"),
    };
    if factor.is_integer() { above } else { format!("{above} / {}", factor.denom()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::Mode;

    #[test]
    fn what_is_given_reads_as_one_writes_it() {
        let arch = |alpha, mu| Arch::parse("heyman", alpha, mu).unwrap();
        let of = |mode: Mode, arch: &Arch| given(&mode.system(arch.weight()), arch);
        let exact = arch("70deg", "tan(1/3)");
        let expected = [("alpha", "7 * PI / 18".into()), ("mu", "tan (1/3)".into())];
        assert_eq!(of(Mode::Rotational, &exact), expected);
        assert_eq!(of(Mode::Sliding, &exact), expected[..1], "its friction is what is asked for");
        let unlimited = arch("2.45", "inf");
        assert_eq!(of(Mode::Rotational, &unlimited), [("alpha", "2.45".into())]);
    }
}
