//! The border to C: pointers become texts and slices, or a code; a panic becomes a code; nothing else of this crate
//! reads or writes where a pointer says.

use crate::answer::Answer;
use crate::failure::Failure;
use crate::threads::give_back_at_the_end;
use std::any::Any;
use std::ffi::{CStr, CString, c_char, c_int};
use std::mem::MaybeUninit;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::slice;

/// Runs the body of a function. Whatever becomes of it, there is an answer, and where it is asked for it is handed
/// over.
///
/// # Safety
///
/// The pointer is null, or a pointer can be written there.
pub(crate) unsafe fn answered(
    out: *mut *mut Answer,
    body: impl FnOnce() -> Result<Answer, Failure>,
) -> c_int {
    let answer = caught(body).unwrap_or_else(Answer::failed);
    let code = answer.code();
    if !out.is_null() {
        // SAFETY: as the caller promises.
        unsafe { out.write(Box::into_raw(Box::new(answer))) };
    }
    code
}

/// What a body makes; a panic is a fault.
fn caught<T>(body: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
    give_back_at_the_end();
    let words = |panic: Box<dyn Any + Send>| {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
        format!("a fault of couplet, please report it: {}", text.unwrap_or_default())
    };
    catch_unwind(AssertUnwindSafe(body)).unwrap_or_else(|panic| Err(Failure::Fault(words(panic))))
}

/// The same of a body that cannot fail and has something in place of what a panic leaves.
pub(crate) fn or_else<T>(instead: T, body: impl FnOnce() -> T) -> T {
    caught(|| Ok(body())).unwrap_or(instead)
}

/// Takes an answer back.
///
/// # Safety
///
/// The pointer is null, or from [`answered`] and not taken back yet.
pub(crate) unsafe fn taken(answer: *mut Answer) -> Option<Box<Answer>> {
    // SAFETY: it was made of a box, and the caller promises that nobody has it any more.
    (!answer.is_null()).then(|| unsafe { Box::from_raw(answer) })
}

/// A text that has to be given.
///
/// # Safety
///
/// The pointer is null, or to bytes that end with a zero and stay as they are while the text is in use.
pub(crate) unsafe fn text<'a>(pointer: *const c_char, name: &str) -> Result<&'a str, Failure> {
    // SAFETY: as the caller promises.
    let text = unsafe { optional(pointer, name) }?;
    text.ok_or_else(|| Failure::Usage(format!("{name} is NULL")))
}

/// A text that may be left out, as a null pointer.
///
/// # Safety
///
/// As of [`text`].
pub(crate) unsafe fn optional<'a>(
    pointer: *const c_char,
    name: &str,
) -> Result<Option<&'a str>, Failure> {
    if pointer.is_null() {
        return Ok(None);
    }
    // SAFETY: as the caller promises.
    let text = unsafe { CStr::from_ptr(pointer) }.to_str();
    text.map(Some).map_err(|_| Failure::Usage(format!("{name} is not UTF-8")))
}

/// A text for C. What is a zero in it, which C could not read on from, becomes the sign of what cannot be shown.
pub(crate) fn c_text(text: impl Into<String>) -> CString {
    CString::new(text.into().replace('\0', "\u{fffd}")).unwrap_or_default()
}

/// Writes a text with its zero, if it fits; else nothing but a zero, as no part of a number is that number. The length
/// of the whole text without its zero.
///
/// # Safety
///
/// The buffer is null, or so many bytes can be written there.
pub(crate) unsafe fn write_text(text: &[u8], buffer: *mut c_char, size: usize) -> usize {
    if buffer.is_null() || size == 0 {
        return text.len();
    }
    let fits = if text.len() < size { text } else { &[] };
    // SAFETY: at most `size` bytes, as the caller promises.
    let buffer =
        unsafe { slice::from_raw_parts_mut(buffer.cast::<MaybeUninit<u8>>(), fits.len() + 1) };
    for (place, byte) in buffer.iter_mut().zip(fits.iter().chain(&[0])) {
        place.write(*byte);
    }
    text.len()
}

/// An array of a call that was looked at: where it is, and what it is called.
pub(crate) struct Array<T> {
    start: *mut T,
    count: usize,
    name: &'static str,
}

impl<T: Copy> Array<T> {
    /// An array of so many, which may be null if they are none.
    pub(crate) fn new(
        start: *const T,
        count: Option<usize>,
        name: &'static str,
    ) -> Result<Self, Failure> {
        let wrong = |how: &str| Err(Failure::Usage(format!("{name} {how}")));
        let limit = isize::MAX as usize / size_of::<T>();
        match count {
            Some(count) if count > limit => wrong("has more values than there is memory"),
            None => wrong("has more values than there is memory"),
            Some(count) if count > 0 && start.is_null() => wrong("is NULL"),
            Some(count) if count > 0 && !start.is_aligned() => {
                wrong("is not where values of its type can be")
            }
            Some(count) => Ok(Self { start: start.cast_mut(), count, name }),
        }
    }

    /// Its bytes, by their addresses, and its name.
    pub(crate) fn place(&self) -> (Range<usize>, &'static str) {
        let start = self.start.addr();
        (start..start.wrapping_add(self.count * size_of::<T>()), self.name)
    }

    /// Its values.
    ///
    /// # Safety
    ///
    /// They are there, and stay as they are while the slice is in use.
    pub(crate) unsafe fn values<'a>(&self) -> &'a [T] {
        match self.count {
            0 => &[],
            // SAFETY: neither null nor misaligned, of a size that can be; the rest the caller promises.
            count => unsafe { slice::from_raw_parts(self.start, count) },
        }
    }

    /// Places for values.
    ///
    /// # Safety
    ///
    /// They can be written, and nobody else uses them while the slice is in use.
    pub(crate) unsafe fn places<'a>(&self) -> &'a mut [MaybeUninit<T>] {
        match self.count {
            0 => &mut [],
            // SAFETY: as above, and what is not written yet is not read.
            count => unsafe { slice::from_raw_parts_mut(self.start.cast(), count) },
        }
    }
}

/// Refuses arrays of which one is written where another is.
pub(crate) fn apart(
    read: &[(Range<usize>, &'static str)],
    written: &[(Range<usize>, &'static str)],
) -> Result<(), Failure> {
    for (at, (one, name)) in written.iter().enumerate() {
        let others = read.iter().chain(&written[..at]);
        let meets = |other: &Range<usize>| one.start.max(other.start) < one.end.min(other.end);
        if let Some((_, other)) = others.into_iter().find(|(other, _)| meets(other)) {
            return Err(Failure::Usage(format!("{name} and {other} overlap")));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::slice::from_ref;

    fn answer_of(body: impl FnOnce() -> Result<Answer, Failure>) -> (c_int, String) {
        let mut answer = std::ptr::null_mut();
        // SAFETY: a pointer of our own, and its answer once.
        let (code, answer) = unsafe { (answered(&raw mut answer, body), taken(answer).unwrap()) };
        (code, answer.reason().to_str().unwrap().to_owned())
    }

    #[test]
    fn a_panic_becomes_a_code_with_its_words() {
        let (code, words) = answer_of(|| panic!("the roof fell"));
        assert_eq!((code, &words[words.len() - 13..]), (4, "the roof fell"), "{words}");
        let (code, words) = answer_of(|| panic!("{} roofs", 2));
        assert!(code == 4 && words.ends_with("2 roofs"), "{words}");
        assert_eq!(or_else(7, || panic!("again")), 7);
    }

    #[test]
    fn a_failure_has_its_code_and_its_sentence() {
        for (code, failure) in [(2, Failure::Usage("a".into())), (3, Failure::Resource("a".into()))]
        {
            assert_eq!(answer_of(|| Err(failure)), (code, "a".to_owned()));
        }
        // SAFETY: null is allowed.
        let code = unsafe { answered(std::ptr::null_mut(), || Err(Failure::Usage(String::new()))) };
        assert_eq!(code, 2);
    }

    #[test]
    fn a_zero_in_a_text_does_not_end_it() {
        assert_eq!(c_text("a\0b").to_str(), Ok("a\u{fffd}b"));
    }

    #[test]
    fn arrays_that_overlap_are_seen() {
        let place = |range: Range<usize>, name| (range, name);
        let (a, b) = (place(0..16, "a"), place(16..32, "b"));
        assert_eq!(apart(from_ref(&a), from_ref(&b)), Ok(()));
        assert_eq!(apart(&[], &[a.clone(), place(8..8, "none")]), Ok(()));
        let wrong = |text: &str| Err(Failure::Usage(text.into()));
        assert_eq!(apart(from_ref(&a), &[place(15..17, "c")]), wrong("c and a overlap"));
        assert_eq!(apart(&[], &[a, b, place(20..21, "c")]), wrong("c and b overlap"));
    }

    #[test]
    fn an_array_that_cannot_be_is_refused() {
        let x = [0.0f64; 4];
        let is_refused = |start: *const f64, count| Array::new(start, count, "x").is_err();
        assert!(!is_refused(x.as_ptr(), Some(4)) && !is_refused(std::ptr::null(), Some(0)));
        assert!(is_refused(std::ptr::null(), Some(1)));
        assert!(is_refused(x.as_ptr().wrapping_byte_add(1), Some(1)));
        assert!(is_refused(x.as_ptr(), Some(usize::MAX / 8)) && is_refused(x.as_ptr(), None));
    }
}
