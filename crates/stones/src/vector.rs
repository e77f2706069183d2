//! Vectors of three balls: forces `(h, p, v)`, conditions on them, and the lines on which two of these are zero.

use crate::number::{DoubleBall, Enclosure};

pub(crate) type Vector = [DoubleBall; 3];
/// Coefficients of `h, p, v` and one in a condition.
pub(crate) type ForceRow = [DoubleBall; 4];

pub(crate) fn dot(a: &Vector, b: &Vector) -> DoubleBall {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: &Vector, b: &Vector) -> Vector {
    let minor = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// Coefficients of the forces, and the part that is free of them.
pub(crate) fn parts(row: &ForceRow) -> (Vector, DoubleBall) {
    let [h, p, v, load] = *row;
    ([h, p, v], load)
}

/// The left side of a condition at some forces.
pub(crate) fn at(row: &ForceRow, forces: &Vector) -> DoubleBall {
    let (row, load) = parts(row);
    dot(&row, forces) + load
}

/// Forces `place + along t`.
pub(crate) struct ForceLine {
    place: Vector,
    along: Vector,
}

impl ForceLine {
    /// The forces at which two conditions are zero; `None` if their rows may be parallel.
    pub(crate) fn of(one: &ForceRow, other: &ForceRow) -> Option<Self> {
        let ((a, load_a), (b, load_b)) = (parts(one), parts(other));
        let along = cross(&a, &b);
        let size = dot(&along, &along);
        if !size.is_positive().is_proved() {
            return None;
        }
        let (by_a, by_b) = (cross(&b, &along), cross(&along, &a));
        let place = [0, 1, 2].map(|k| -(by_a[k] * load_a + by_b[k] * load_b) / size);
        Some(Self { place, along })
    }

    /// A condition on the line: what is free of `t`, and what multiplies it.
    pub(crate) fn value(&self, row: &ForceRow) -> [DoubleBall; 2] {
        [at(row, &self.place), dot(&parts(row).0, &self.along)]
    }

    /// The forces at a `t`.
    pub(crate) fn at(&self, t: DoubleBall) -> Vector {
        [0, 1, 2].map(|k| self.place[k] + self.along[k] * t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both conditions are zero all along their line, and a third one is not. Rows that may be parallel have none.
    #[test]
    fn two_conditions_are_zero_on_their_line() {
        let row = |entries: [f64; 4]| entries.map(|entry| DoubleBall::new(entry, 1e-9));
        let [a, b, c] =
            [[3.0, -1.0, 2.0, 0.7], [1.0, 4.0, -2.0, -5.0], [1.0, 4.0, -2.0, 5.0]].map(row);
        let line = ForceLine::of(&a, &b).unwrap();
        for of in [&a, &b] {
            let [value, slope] = line.value(of);
            assert!(!value.excludes_zero() && !slope.excludes_zero());
            assert!(value.rad() < 1e-6 && slope.rad() < 1e-6);
        }
        let [value, slope] = line.value(&c);
        assert!(value.excludes_zero() && !slope.excludes_zero(), "false twin");
        let nearly = row([1.0 + 1e-10, 4.0, -2.0, 5.0]);
        assert!(ForceLine::of(&b, &c).is_none() && ForceLine::of(&b, &nearly).is_none());
        assert!(ForceLine::of(&b, &row([1.01, 4.0, -2.0, 5.0])).is_some());
    }
}
