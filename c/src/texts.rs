//! Small helpers for texts.

use crate::border::{c_text, or_else, write_text};
use couplet::number::ExactNumber;
use couplet::problem::Mode;
use couplet::rug::Rational;
use std::ffi::{CStr, CString, c_char, c_int};
use std::sync::LazyLock;

/// The version of the library, as "0.1.0". The text is never freed.
#[unsafe(no_mangle)]
pub extern "C" fn couplet_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

/// The label of a mode by its code in arrays, as "[r,r,s]"; empty if there is none. The text is never freed.
#[unsafe(no_mangle)]
pub extern "C" fn couplet_mode_name(code: c_int) -> *const c_char {
    static LABELS: LazyLock<Vec<CString>> =
        LazyLock::new(|| Mode::ALL.map(|mode| c_text(mode.label())).to_vec());
    let label = || usize::try_from(code).ok().and_then(|code| LABELS.get(code));
    or_else(c"".as_ptr(), || label().map_or(c"".as_ptr(), |label| label.as_ptr()))
}

/// Copies a text into a buffer of `size` bytes, zero included, for languages that have no pointers to texts, and
/// returns its length without the zero. If that is not below `size`, the buffer gets the empty text: a number is not
/// cut. A NULL text is empty; with a NULL buffer only the length is told.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_copy(
    text: *const c_char,
    buffer: *mut c_char,
    size: usize,
) -> usize {
    let text = match text.is_null() {
        true => c"",
        // SAFETY: the caller promises that it ends with a zero.
        false => unsafe { CStr::from_ptr(text) },
    };
    // SAFETY: the caller promises so many bytes.
    unsafe { write_text(text.to_bytes(), buffer, size) }
}

/// Writes a double as the exact text of the number that it is, a fraction or "inf", which the functions of one question
/// read; as `couplet_copy` does. What is not a number, and minus infinity, have no text: 0. 1100 bytes are always
/// enough.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn couplet_exact(x: f64, buffer: *mut c_char, size: usize) -> usize {
    let text = or_else(String::new(), || exact(x));
    // SAFETY: the caller promises so many bytes.
    unsafe { write_text(text.as_bytes(), buffer, size) }
}

/// The exact text of a double; empty if there is none.
pub(crate) fn exact(x: f64) -> String {
    if x == f64::INFINITY {
        return "inf".into();
    }
    Rational::from_f64(x).map(|x| ExactNumber::from(&x).to_string()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn copied(text: &CStr, size: usize) -> (usize, Vec<u8>) {
        let mut buffer = [b'x'; 8];
        // SAFETY: at most as many bytes as there are.
        let length = unsafe { couplet_copy(text.as_ptr(), buffer.as_mut_ptr().cast(), size) };
        (length, buffer.to_vec())
    }

    #[test]
    fn a_text_that_does_not_fit_is_not_cut() {
        assert_eq!(copied(c"0.123", 6), (5, b"0.123\0xx".to_vec()));
        assert_eq!(copied(c"0.123", 5), (5, b"\0xxxxxxx".to_vec()));
        assert_eq!(copied(c"0.123", 0), (5, b"xxxxxxxx".to_vec()));
        assert_eq!(copied(c"", 1), (0, b"\0xxxxxxx".to_vec()));
    }

    #[test]
    fn a_double_has_the_text_of_the_number_that_it_is() {
        for (x, text) in [(0.1, "3602879701896397/36028797018963968"), (-0.0, "0"), (2.0, "2")] {
            assert_eq!(exact(x), text);
        }
        assert_eq!([exact(f64::INFINITY), exact(f64::NAN), exact(-f64::INFINITY)], ["inf", "", ""]);
        for x in [f64::MAX, f64::MIN_POSITIVE.next_up(), 5e-324, -f64::MIN_POSITIVE.next_up()] {
            let text = exact(x);
            assert!(text.len() < 1100, "{}", text.len());
            assert_eq!(text.parse::<ExactNumber>().unwrap().nearest_double(), Some(x));
        }
    }

    #[test]
    fn every_mode_has_a_name_and_nothing_else_has() {
        // SAFETY: a text of this library.
        let name = |code| unsafe { CStr::from_ptr(couplet_mode_name(code)) };
        let names: Vec<_> = (0..7).map(|code| name(code).to_str().unwrap()).collect();
        assert_eq!(names, Mode::ALL.map(Mode::label));
        assert!([-1, 7, 255, c_int::MIN, c_int::MAX].iter().all(|code| name(*code).is_empty()));
    }
}
