//! Assemblies of stones near a threshold, for programs that tell whether such stand: CSV and JSON
//! (`couplet.assembly/1`) with the proved answers, and the bodies alone as OBJ and DXF.

mod assembly;
mod dxf;
mod obj;
mod record;

pub use assembly::Assembled;
pub use dxf::dxf;
pub use obj::obj;
pub use record::{header, json, row};
