"""What a number is that is given: exact text, or threads."""

from __future__ import annotations

import operator

from ._core import CoupletError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ._types import Any, Exact

_MOST_THREADS = 1024


def of_numpy(value: Any) -> Any:
    """What NumPy has, as Python has it; anything else as it is."""
    return value.tolist() if hasattr(value, "tolist") else value


def listed(column: Any) -> Any:
    """The members of a column of any library."""
    lister = getattr(column, "tolist", None) or getattr(column, "to_list", None) or getattr(column, "to_pylist", None)
    return lister() if lister else list(column)


def exact(value: Exact, what: str) -> str:
    """The text of a number; a float is the double that it is, as a fraction."""
    if isinstance(value, str):
        return value
    try:
        text = None if isinstance(value, bool) else _text(value)
    except ValueError as error:
        raise CoupletError(f"the {what} is too long: {error}") from None
    if text is None:
        raise TypeError(f"the {what} is a str, int, float, Fraction or Decimal, not {type(value).__name__}")
    return text


def text_of(value: object) -> str:
    """A whole number as ``int`` writes it, whatever its own class says; anything else as ``str`` does."""
    return int.__repr__(value) if isinstance(value, int) and not isinstance(value, bool) else str(value)


def is_text(text: str) -> bool:
    """Whether a str is a text, which one with half a surrogate pair is not."""
    try:
        text.encode()
    except UnicodeEncodeError:
        return False
    return True


def no_text(text: str) -> str:
    """What is said of a str that is none, or of the value of an option."""
    text = text.partition("=")[2] if text.startswith("--") else text
    return f"{text!r} is no text: it has half a surrogate pair, which is no character"


def _text(value: object) -> str | None:
    """The text of a number; None if it is none."""
    # What most give; neither infinite nor no number.
    if type(value) is float and value - value == 0:
        numerator, denominator = value.as_integer_ratio()
        return f"{numerator}/{denominator}" if denominator != 1 else str(numerator)
    # Of a Decimal str() has all digits.
    if isinstance(value, int) or hasattr(value, "as_tuple"):
        return text_of(value)
    if hasattr(value, "numerator") and hasattr(value, "denominator"):
        return _ratio(value.numerator, value.denominator)
    if not hasattr(value, "as_integer_ratio"):
        return None
    try:
        numerator, denominator = value.as_integer_ratio()
    except (ValueError, OverflowError):
        # Not a number, or infinite.
        return str(float(value))  # type: ignore[arg-type]
    return _ratio(numerator) if denominator == 1 else _ratio(numerator, denominator)


def _ratio(*parts: Any) -> str | None:
    """The text of parts that are whole numbers, whatever their class says that they are; None if they are not."""
    return "/".join(text_of(part.__index__()) for part in parts) if all(hasattr(part, "__index__") for part in parts) else None


def whole(threads: int) -> int:
    """A number of threads."""
    try:
        number = -1 if isinstance(threads, bool) else operator.index(threads)
    except TypeError:
        number = -1
    if not 0 <= number <= _MOST_THREADS:
        raise CoupletError(f"threads are a whole number from 1 to {_MOST_THREADS}, or 0 for one on each core")
    return number
