//! Questions the other way round: the half opening or the friction that goes with what is given.
//!
//! | file | what it finds |
//! |---|---|
//! | `widest` | the widest half opening that stands at a thickness and a friction |
//! | `line` | where one mode becomes another |
//! | `question` | the questions, and the least friction, with the answers in digits |
//! | `by_value` | all states with a joint, a thrust, a thickness or an opening variable |
//!
//! Every answer is a root that is proved to be the state of its arch, and **the only answer**:
//!
//! **A part of an arch that stands, stands.** The conditions on a joint do not see the half opening
//! ([`arch::contact`](crate::arch::contact)): thrust and crown moment of an arch that stands are admissible in every
//! narrower one. So the least thickness does not fall with the half opening.
//!
//! **It grows strictly.** At its least thickness an arch has one admissible pair of thrust and crown moment, and the
//! shoulder is on its extrados or just slides. If a wider arch stood at that thickness, its pair would be this one.
//! But beyond the shoulder it fails: the margin at the extrados first grows and then falls, strictly, from a value
//! at the crown that is not negative, so that it falls where it is zero below the crown; and `T/N` falls strictly
//! from `beta_s` on. So the half opening whose least thickness is the given one is the widest that stands. The
//! same holds where friction is used up inside and at the shoulder, `[s,s]`, at any thickness that has room for
//! the line of thrust: the thrust is the only one, and a wider shoulder slides.
//!
//! **At the physical limit.** An arch stands at some thickness exactly if it stands at `eta = 2`. There the
//! intrados asks for `p >= 0`, and the crown for `p <= 2 h`. With `cos(alpha) < 0` the margin at the shoulder falls
//! with the thrust; where `2 N = fac (1 - cos alpha)` at the least thrust that friction allows, `p = 0` and that
//! thrust are the only pair, and no wider arch has one.
//!
//! **The lines.** At a half opening more friction never makes an arch thicker, so that with less friction an inner
//! joint slides at a larger thrust, and the thickness is not smaller; at a friction the thrust is fixed and the
//! thickness grows with the half opening. By (5) `beta cot(beta) = h - 1 + 2 fac/(2 - eta)` grows strictly either
//! way: `beta_r` falls and the slope at the crown grows, while `beta_s` does not fall (as `h < 1/2`, which is
//! checked for the largest thrust of the half opening, that of pure sliding). So each is crossed once. The
//! frictions that a purely rotational state asks for, and the friction of the purely sliding states, grow with the
//! half opening (the claims `friction-rotation` and `sliding-order` of `couplet prove`).

mod by_value;
mod line;
mod question;
mod widest;

pub use by_value::{OtherState, StateOfValue, StatesByValue, StatesOfValue};
pub use question::{Finding, Found, Given, Question, find};
pub(in crate::certify::state) use widest::{at_thickness, bits_lost, widest};
