//! Memory that long work needs, beside that which there is: GMP ends the process where it is given none.

use crate::sweep::failure::Failure;
use std::fs;

/// Bytes of a process that has computed nothing, and of a digit of a landmark, while it is refined and afterwards.
const EMPTY: u64 = 40_000_000;
const REFINED: u64 = 75;
const KEPT: u64 = 20;

/// Checks that constants of so many digits have room; where the system tells of no limit they have.
pub(super) fn has_room(sizes: &[usize]) -> Result<(), Failure> {
    let digits = |size: usize| u64::try_from(size).unwrap_or(u64::MAX);
    let largest = digits(sizes.iter().copied().max().unwrap_or(0));
    let at_once = rayon::current_num_threads().min(sizes.len());
    let refined = largest.saturating_mul(REFINED).saturating_mul(digits(at_once));
    let kept = digits(sizes.iter().sum()).saturating_mul(KEPT);
    let needed = EMPTY.saturating_add(refined).saturating_add(kept);
    match available().filter(|available| *available < needed) {
        Some(available) => {
            let [needed, available] = [needed, available].map(|bytes| bytes.div_ceil(1_000_000));
            let words = format!(
                "so many digits need about {needed} MB of memory, and there are {available} MB"
            );
            Err(Failure::Io(format!("{words}; --threads 1 needs the least")))
        }
        None => Ok(()),
    }
}

/// Bytes that this process may have, as far as Linux tells.
fn available() -> Option<u64> {
    let limit = told("/proc/self/limits", "Max address space");
    let free =
        told("/proc/meminfo", "MemAvailable:").map(|kilobytes| kilobytes.saturating_mul(1024));
    limit.into_iter().chain(free).min()
}

/// First number of a line of a file, after its name.
fn told(path: &str, name: &str) -> Option<u64> {
    let text = fs::read_to_string(path).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    line.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_digits_have_room_and_endless_ones_do_not() {
        assert!(has_room(&[100, 100]).is_ok());
        if available().is_some() {
            let Err(Failure::Io(words)) = has_room(&[usize::MAX / 2]) else { panic!() };
            assert!(words.contains("MB of memory"), "{words}");
        }
        assert_eq!(told("/proc/self/limits", "Max nothing"), None);
        assert_eq!(told("/nowhere", "Max address space"), None);
    }
}
