//! Counts that are proved: "none", "all" and "no other" come from one, never from a search that found no more.

use super::Undecided;

/// Proved number of the candidates of a question: everything that can be an answer is one of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Count {
    number: usize,
    because: &'static str,
}

/// Proof that there is none, which only a count can give.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Absence(&'static str);

impl Absence {
    /// Reason why there is none.
    pub fn reason(self) -> &'static str {
        self.0
    }
}

/// Answers that are left of all candidates, those that stay open among them, and the reason why there is none.
pub(crate) type Left<T> = (Vec<Result<T, Undecided>>, Option<Absence>);

impl Count {
    /// As many candidates as `because` says; whoever makes a count has that proof at hand.
    pub(crate) fn proved(number: usize, because: &'static str) -> Self {
        Self { number, because }
    }

    /// Answers among the candidates: a `None` is one that is proved to be no answer, for the reason `excluded`.
    /// Undecided unless as many are found as there are.
    pub(crate) fn sieved<T>(
        self,
        candidates: Vec<Result<Option<T>, Undecided>>,
        excluded: &'static str,
    ) -> Result<Left<T>, Undecided> {
        if candidates.len() != self.number {
            let (found, all) = (candidates.len(), self.number);
            return Err(Undecided::root(format!("{found} are found, and there are {all}")));
        }
        let why = if self.number == 0 { self.because } else { excluded };
        let left: Vec<_> = candidates.into_iter().filter_map(Result::transpose).collect();
        let absence = left.is_empty().then_some(Absence(why));
        Ok((left, absence))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn none_is_told_where_every_candidate_is_excluded_and_nowhere_else() {
        let open = || Undecided::root("a root");
        let two = Count::proved(2, "of two");
        let (left, none) = two.sieved::<i32>(vec![Ok(None), Ok(None)], "neither").unwrap();
        assert_eq!((left, none.unwrap().reason()), (vec![], "neither"));
        let (left, none) = two.sieved(vec![Ok(Some(7)), Ok(None)], "neither").unwrap();
        assert_eq!((left, none), (vec![Ok(7)], None));
        let (left, none) = two.sieved::<i32>(vec![Err(open()), Ok(None)], "neither").unwrap();
        assert_eq!((left, none), (vec![Err(open())], None), "what stays open is not absent");
        for found in [vec![], vec![Ok(None)], vec![Ok(None::<i32>); 3]] {
            assert!(two.sieved(found, "neither").is_err(), "fewer or more than there are");
        }
        let (_, none) = Count::proved(0, "as none can be").sieved::<i32>(vec![], "").unwrap();
        assert_eq!(none.unwrap().reason(), "as none can be");
    }
}
