//! A scene: what a study needs, in a file, and exactly that computed and written.
//!
//! | file | what it does |
//! |---|---|
//! | `schema` | what a scene may hold, `couplet.scene/1` |
//! | `read` | TOML to a valid scene, or all its faults; with `table`, `axes`, `read_arches`, `read_drawing`, `read_map`, `figure`, `read_output`, `value`, `fault` |
//! | `scene_map` | which lines a map shows, and what each is |
//! | `plan`, `same` | what has to be computed, each part once |
//! | `computable` | what a part is, and what parts share; `landmark_node`, `arch_node`, `scene_map`, `drawn`, `survey_node` are the kinds |
//! | `run` | computes the parts, item by item; `cost` counts |
//! | `item_report` | what an item asked for, as a report |
//! | `explain` | the plan as a tree, with what it leaves out and what `expected` says of the arches |
//! | `manifest`, `hash` | which outputs are complete, told by their content |
//! | `read_sweep`, `sweep_record` | the plan of a sweep, `couplet.sweep/1`, and its one form, which names it |
//!
//! ```
//! use couplet_sweep::scene::{Plan, SceneRun, read};
//!
//! let text = r#"
//!     schema = "couplet.scene/1"
//!     [constants]
//!     landmarks = "T"
//!     quantities = "thickness"
//!     weight = "milankovitch"
//!     digits = 12
//! "#;
//! let scene = read(text).unwrap();
//! let plan = Plan::new(&scene, vec![false]);
//! let mut run = SceneRun::new(&plan);
//! let mut table = Vec::new();
//! run.item(0, &|| ()).write(&mut table)?;
//! assert!(String::from_utf8_lossy(&table).contains("0.618318241074"));
//! # Ok::<(), std::io::Error>(())
//! ```

mod arch_node;
mod axes;
mod computable;
mod cost;
mod drawn;
mod expected;
mod explain;
mod fault;
mod figure;
mod hash;
mod item_report;
mod landmark_node;
mod manifest;
mod plan;
mod read;
mod read_arches;
mod read_drawing;
mod read_map;
mod read_output;
mod read_sweep;
mod run;
mod same;
mod scene_map;
mod schema;
mod survey_node;
mod sweep_record;
mod table;
mod value;

pub use cost::Cost;
pub use drawn::{DrawnArch, Pose};
pub use explain::explain;
pub use fault::{Fault, Position};
pub use figure::figure;
pub use hash::Hashing;
#[cfg(feature = "parquet")]
pub(crate) use hash::hash_of;
pub use item_report::ItemReport;
pub use manifest::{Manifest, NAME as MANIFEST};
#[cfg(feature = "parquet")]
pub(crate) use manifest::{content_of, record_bytes};
pub use plan::Plan;
pub use read::{read, read_bytes};
pub use read_sweep::{SWEEP_EXAMPLE, read_sweep};
pub use run::{Costs, SceneRun, answered};
pub use same::contour_key;
pub use scene_map::{MapLine, SceneMap};
pub use schema::{
    EXAMPLE, ItemKind, MAX_ARCHES, MAX_BYTES, MAX_ITEMS, Request, SCHEMA, Scene, SceneArch,
    SceneBoxes, SceneDrawing, SceneItem, SceneSurvey,
};
#[cfg(feature = "parquet")]
pub(crate) use sweep_record::VERSION;
pub use sweep_record::{
    DataFile, FilePiece, GROUP, SWEEP_DIGITS, SWEEP_SCHEMA, SweepArches, SweepRecord, TextSlice,
};
