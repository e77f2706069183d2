//! Questions and answers of every door: the command, Python and C.
//!
//! | file | what it does |
//! |---|---|
//! | `answer` | an answer about one arch, with what is known of it besides |
//! | `find` | questions asked the other way round |
//! | `pool` | the threads that work is shared among |

pub mod answer;
pub mod find;
pub mod pool;
