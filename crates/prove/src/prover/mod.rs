//! Tools of every proof: one root in a box, its digits, signs, more bits, and why nothing is known.
//!
//! | file | what it does |
//! |---|---|
//! | `arithmetic` | the numbers in which a proof runs |
//! | `operator` | one root of equations in a box, in balls of MPFR |
//! | `root` | one root next to a start value, in as many bits as are asked for |
//! | `ladder`, `sines` | the way from few bits to many, on which each sine is computed once |
//! | `in_doubles` | the same in doubles |
//! | `posed`, `isolate`, `refine` | the printed equations of a system, their root alone in a box, and its digits |
//! | `linear` | linear equations |
//! | `decide` | signs |
//! | `halve`, `cover` | halved until proved, and so a statement on an interval |
//! | `raise` | more bits until everything is decided |
//! | `count` | how many there are, and that there is none |
//! | `ties` | what is exactly zero in an arch |
//! | `figure` | a proved value with its digits |
//! | `undecided`, `refused`, `error` | why nothing is known, or was asked |

pub mod arithmetic;
pub(crate) mod count;
pub(crate) mod cover;
pub mod decide;
pub(crate) mod error;
pub mod figure;
pub mod halve;
pub mod in_doubles;
pub(crate) mod isolate;
pub mod ladder;
pub mod linear;
pub mod operator;
pub(crate) mod posed;
pub(crate) mod raise;
pub(crate) mod refine;
pub(crate) mod refused;
pub mod root;
pub mod sines;
pub mod ties;
pub(crate) mod undecided;

pub use count::Absence;
pub use error::Error;
pub use figure::Figure;
pub use isolate::Isolated;
pub use raise::raise;
pub use refused::Refused;
pub use undecided::{Answered, Open, Undecided};
