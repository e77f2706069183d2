//! The state of an arch, from exact input: `cargo run --example state`.

use couplet::prelude::*;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    // Exact: `2.45` is 245/100, and neither number is rounded to a double on the way.
    let arch = Arch::parse("milankovitch", "2.45", "1.35")?;

    // That no thickness is enough, or that nothing is decided, is an error here; `certify` tells them apart.
    let state = arch.least(20)?;
    println!("mode            {}", state.mode);
    println!("thickness t/r   {}", state.thickness);
    println!("thrust H/(w r)  {}", state.thrust);

    assert_eq!(state.mode, Mode::RotationalSliding);
    // It is the least thickness: with a little more the arch stands, with a little less it does not.
    assert!(
        arch.certify_thickness(&"0.6503".parse()?, 6).is_ok_and(|found| found.stands == Ok(true))
    );
    assert!(
        arch.certify_thickness(&"0.6502".parse()?, 6).is_ok_and(|found| found.stands == Ok(false))
    );
    Ok(())
}
