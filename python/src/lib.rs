//! What is compiled of the Python package `couplet`: thin, over the library. Its classes and documentation are in
//! Python, in `python/couplet`.
//!
//! | file | what it does |
//! |---|---|
//! | `asked` | one question at a time |
//! | `certified` | certificates, and their check |
//! | `rows` | many searches |
//! | `tables` | the rows of a table, in doubles or exact texts |
//! | `told` | an answer as Python gets it |
//! | `sweeps` | any number of arches, in Parquet files |
//! | `pool` | threads of our own |

mod asked;
mod certified;
mod pool;
mod rows;
#[cfg(feature = "parquet")]
mod sweeps;
mod tables;
mod told;

use pyo3::prelude::*;

pyo3::create_exception!(
    couplet,
    CoupletError,
    pyo3::exceptions::PyValueError,
    "The input makes no sense: what was wrong, and what is allowed, in the words of the command."
);
pyo3::create_exception!(
    couplet,
    UndecidedError,
    pyo3::exceptions::PyArithmeticError,
    "A certificate was asked for, and the proof did not succeed; nothing is known."
);

#[pymodule(gil_used = false)]
mod _core {
    #[pymodule_export]
    use super::asked::{
        assess, claims, command, constants, fields, find, modes, prove, quantity_name, run, state,
        surveyed, tilted, voussoirs,
    };
    #[pymodule_export]
    use super::certified::{certify_arch, certify_asymmetric, certify_landmark, check};
    #[pymodule_export]
    use super::rows::finds;
    #[cfg(feature = "parquet")]
    #[pymodule_export]
    use super::sweeps::{sweep_begin, sweep_part, sweep_survey, sweep_verify};
    #[pymodule_export]
    use super::tables::{table, unanswered};
    #[pymodule_export]
    use super::{CoupletError, UndecidedError};

    #[pymodule_export]
    #[allow(non_upper_case_globals, reason = "Python's name for it")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
