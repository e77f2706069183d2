//! How an arch seems to collapse, in doubles: a plan says beforehand which equations it will need.
//! Nothing of it enters a result.

use crate::certify::state::{Arch, Friction};
use crate::problem::{Equation, Mode};
use crate::solve::start::{quick_state, seems_to_rotate};
use rug::Float;

/// The mode that an arch seems to have; `[s,s]` if it seems that nothing stands.
pub fn mode(arch: &Arch) -> Mode {
    const BITS: u32 = 64;
    let alpha = Float::with_val(BITS, arch.half_opening().enclosure(BITS).mid());
    let mu = match arch.friction() {
        Friction::Coefficient(mu) => mu.enclosure(BITS).mid().to_f64(),
        Friction::Angle(phi) => phi.enclosure(BITS).mid().to_f64().tan(),
        Friction::Infinite => f64::INFINITY,
    };
    if mu.is_finite() {
        return quick_state(arch.weight(), alpha.to_f64(), mu).mode.unwrap_or(Mode::Sliding);
    }
    if seems_to_rotate(arch.weight(), &alpha) { Mode::Rotational } else { Mode::Overturning }
}

/// The mode in words, with its equations.
pub fn in_words(arch: &Arch) -> String {
    let mode = mode(arch);
    let (_, equations) = mode.system();
    let equations: Vec<&str> = equations.iter().copied().map(Equation::label).collect();
    let seems = match mode {
        Mode::Sliding => "seems not to stand".to_owned(),
        mode => format!("seems {}", mode.label()),
    };
    format!("{seems}: {}", equations.join(", "))
}
