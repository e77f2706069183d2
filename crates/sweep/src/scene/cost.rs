//! Cost of a piece of work, and the threads that do it.
//!
//! Evaluations are counted by thread, so the work is done by threads of its own: one that belongs to a
//! pool may take up other work while it waits, and count that too.

use crate::certify::processor_time;
use crate::problem::tally::{self, Tally};
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

/// Processor time and evaluations.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cost {
    /// Time of the processor, in the thread that did it, whatever else the machine has to do.
    pub time: Duration,
    /// Number of evaluations.
    pub tally: Tally,
}

impl<'a> std::iter::Sum<&'a Cost> for Cost {
    fn sum<I: Iterator<Item = &'a Self>>(costs: I) -> Self {
        costs.fold(Self::default(), |mut sum, cost| {
            sum.time += cost.time;
            sum.tally += cost.tally;
            sum
        })
    }
}

/// Does jobs on all cores; the results are in the order of the jobs, each with what it cost.
pub(super) fn measured<J: Sync, T: Send>(
    jobs: &[J],
    work: impl Fn(&J) -> T + Sync,
) -> Vec<(T, Cost)> {
    let next = AtomicUsize::new(0);
    let worker = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(job) = jobs.get(index) else { return done };
            let start = processor_time();
            let (result, tally) = tally::measure(|| work(job));
            let time = processor_time().saturating_sub(start);
            done.push((index, (result, Cost { time, tally })));
        }
    };
    let mut done: Vec<(usize, (T, Cost))> = thread::scope(|scope| {
        let threads = rayon::current_num_threads().min(jobs.len());
        let start = |_| thread::Builder::new().spawn_scoped(scope, worker).ok();
        let workers: Vec<_> = (0..threads).map_while(start).collect();
        // Where no thread can be started, this one works.
        let here = if workers.is_empty() { worker() } else { Vec::new() };
        let joined = workers.into_iter().map(|worker| worker.join());
        let done = joined.flat_map(|done| done.unwrap_or_else(|panic| resume_unwind(panic)));
        here.into_iter().chain(done).collect()
    });
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::{Configuration, SelfWeight};
    use crate::problem::System;

    #[test]
    fn results_are_in_order_and_each_counts_its_own() {
        let jobs: Vec<usize> = (0..100).collect();
        let done = measured(&jobs, |&n| {
            let at = Configuration::zero(&0.0);
            for _ in 0..n {
                System::inner_sliding(SelfWeight::Heyman).residuals(&at);
            }
            n * n
        });
        assert_eq!(done.len(), 100);
        for (n, (square, cost)) in done.iter().enumerate() {
            assert_eq!((*square, cost.tally.evaluations()), (n * n, 2 * n as u64));
        }
        let sum: Cost = done.iter().map(|(_, cost)| cost).sum();
        assert_eq!(sum.tally.evaluations(), 2 * 99 * 50);
    }

    #[test]
    fn no_jobs_are_no_work() {
        assert!(measured(&[(); 0], |()| ()).is_empty());
    }
}
