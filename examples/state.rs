//! The state of an arch, from exact input: `cargo run --example state`.

use couplet::arch::SelfWeight;
use couplet::certify::state::{Answer, Certify};
use couplet::problem::Mode;
use couplet::problem::{Arch, Friction};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    // Exact: `2.45` is 245/100, and neither number is rounded to a double on the way.
    let friction = Friction::Coefficient("1.35".parse()?);
    let arch = Arch::new(SelfWeight::Milankovitch, "2.45".parse()?, friction)?;

    let state = match arch.certify(20) {
        Ok(Answer::Stands(state)) => state,
        Ok(Answer::Falls(fall)) => return Err(format!("no thickness is enough: {fall:?}").into()),
        // On a boundary between two modes nothing can be decided, and that is the answer.
        Err(doubt) => return Err(format!("{} of {:?}", doubt.reason, doubt.between).into()),
    };
    println!("mode            {}", state.mode.label());
    println!("thickness t/r   {}", state.thickness.decimal.value);
    println!("thrust H/(w r)  {}", state.thrust.decimal.value);

    assert_eq!(state.mode, Mode::RotationalSliding);
    // It is the least thickness: with a little more the arch stands, with a little less it does not.
    assert!(arch.certify_thickness(&"0.6503".parse()?, 6).is_ok_and(|found| found.stands));
    assert!(arch.certify_thickness(&"0.6502".parse()?, 6).is_ok_and(|found| !found.stands));
    Ok(())
}
