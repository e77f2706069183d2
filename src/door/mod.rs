//! Questions and answers of every door: the command, Python and C.
//!
//! | file | what it does |
//! |---|---|
//! | `find` | questions asked the other way round |
//! | `pool` | the threads that work is shared among |

pub mod find;
pub mod pool;
