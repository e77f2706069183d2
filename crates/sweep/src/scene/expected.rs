//! Expected collapse of an arch, in doubles: a plan says beforehand which equations it will need. Nothing of
//! it enters a result.

use crate::number::Ball;
use crate::problem::{Arch, Equation, Mode};
use crate::solve::start::{quick_state, seems_to_rotate};

/// The mode that an arch seems to have; `[s,s]` if it seems that nothing stands.
pub(super) fn mode(arch: &Arch) -> Mode {
    let given = arch.given::<Ball>(64);
    let alpha = given.half_opening.rad.mid();
    let mu = if arch.is_limited() { given.friction.mid().to_f64() } else { f64::INFINITY };
    if mu.is_finite() {
        return quick_state(arch.weight(), alpha.to_f64(), mu).mode.unwrap_or(Mode::Sliding);
    }
    if seems_to_rotate(arch.weight(), alpha) { Mode::Rotational } else { Mode::Overturning }
}

/// The mode in words, with its equations.
pub(super) fn in_words(arch: &Arch) -> String {
    let mode = mode(arch);
    let equations = mode.system(arch.weight()).equations;
    let equations: Vec<&str> = equations.iter().copied().map(Equation::label).collect();
    let seems = match mode {
        Mode::Sliding => "seems not to stand".to_owned(),
        mode => format!("seems {}", mode.label()),
    };
    format!("{seems}: {}", equations.join(", "))
}
