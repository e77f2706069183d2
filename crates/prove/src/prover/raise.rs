//! The precision is raised until a proof decides everything.

use super::Undecided;

/// The precision is doubled up to this many bits, and at least twice, before a comparison or a rounding
/// counts as undecided.
const ENOUGH: u32 = 8192;

/// A proof that decides everything: `first` bits, and twice as many until they are enough.
pub fn raise<T>(
    first: u32,
    mut proof: impl FnMut(u32) -> Result<Option<T>, Undecided>,
) -> Result<T, Undecided> {
    let mut bits = first;
    let rounding = || Undecided::rounding("the rounding");
    let mut last = rounding();
    while bits <= ENOUGH.max(4 * first) {
        match proof(bits) {
            Ok(Some(answer)) => return Ok(answer),
            Ok(None) => last = rounding().at(bits),
            Err(undecided) => last = undecided.at(bits),
        }
        bits *= 2;
    }
    Err(last)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prover::Open;

    #[test]
    fn what_stays_open_says_of_which_kind_it_is_and_how_many_bits_were_tried() {
        let rounding = raise(64, |_| Ok::<Option<()>, _>(None)).unwrap_err();
        assert_eq!((rounding.kind, rounding.bits), (Open::Rounding, Some(ENOUGH)));
        let root = raise(100, |_| Err::<Option<()>, _>(Undecided::root("a root"))).unwrap_err();
        assert_eq!((root.kind, root.bits), (Open::Root, Some(6400)));
        assert_eq!(root.to_string(), "undecided: a root");
    }
}
