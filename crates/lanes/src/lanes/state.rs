//! A purely rotational state that is proved.

use crate::number::{DoubleDouble, DoubleDoubleBall, Enclosure};

/// Purely rotational state at the least thickness of an arch, in enclosures, all proved.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct RotationalState {
    /// `eta`.
    pub thickness: DoubleDoubleBall,
    /// `h`.
    pub thrust: DoubleDoubleBall,
    /// `eta h`.
    pub intrinsic_thrust: DoubleDoubleBall,
    /// `beta_r`, rad.
    pub rotation_joint: DoubleDoubleBall,
}

impl RotationalState {
    /// The state whose values, in this order, are each within a radius of the sum of two doubles; `None` if one of
    /// these is no number.
    pub(super) fn new(values: [[f64; 3]; 4]) -> Option<Self> {
        let [thickness, thrust, intrinsic_thrust, rotation_joint] =
            values.map(|[high, low, rad]| DoubleDoubleBall::new(DoubleDouble::sum(high, low), rad));
        let found = Self { thickness, thrust, intrinsic_thrust, rotation_joint };
        [thickness, thrust, intrinsic_thrust, rotation_joint]
            .iter()
            .all(Enclosure::is_bounded)
            .then_some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_no_state() {
        let values = [[0.5, 1e-18, 1e-30]; 4];
        let state = RotationalState::new(values).unwrap();
        assert_eq!(state.thickness.nearest_double(), Some(0.5));
        for spoiled in 0..12 {
            for with in [f64::NAN, f64::INFINITY] {
                let mut values = values;
                values[spoiled / 3][spoiled % 3] = with;
                assert!(RotationalState::new(values).is_none(), "{spoiled} {with}");
            }
        }
    }
}
