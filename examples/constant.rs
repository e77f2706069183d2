//! A landmark constant to any number of digits: `cargo run --example constant -- 100`.

use couplet::arch::SelfWeight;
use couplet::certify::{CertifiedLandmark, Value};
use couplet::problem::{Landmark, Quantity};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let digits = std::env::args().nth(1).map_or(Ok(50), |text| text.parse())?;
    // Found, isolated and proved; without a proof there is no value of this type.
    let triple = CertifiedLandmark::new(Landmark::Triple, SelfWeight::Milankovitch)?;
    let constants = triple.constants(digits)?;

    for constant in &constants {
        println!("{:24} {constant}", constant.quantity.name());
    }

    let thickness = constants.iter().find(|constant| constant.quantity == Quantity::Thickness);
    let Some(Value::Finite(thickness)) = thickness.map(|constant| &constant.value) else {
        return Err("T has a thickness".into());
    };
    // The value is the true one correctly rounded; the true one lies between the bounds.
    let [value, lower, upper] =
        [&thickness.value, &thickness.lower, &thickness.upper].map(|decimal| decimal.to_rational());
    assert!(lower <= value && value <= upper);
    assert_eq!(thickness.value.significant_digits(), digits);
    Ok(())
}
