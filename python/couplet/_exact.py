"""What a number is that is given: exact text."""

from __future__ import annotations

from ._core import CoupletError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from decimal import Decimal
    from fractions import Fraction
    from typing import Union

    Exact = Union[str, int, float, Fraction, Decimal]


def exact(value: Exact, what: str) -> str:
    """The text of a number; a float is the double that it is, as a fraction."""
    if isinstance(value, str):
        return value
    if not isinstance(value, bool):
        try:
            return _text(value)
        except _NoNumber:
            pass
        except ValueError as error:
            raise CoupletError(f"the {what} is too long: {error}") from None
    kind = type(value).__name__
    raise TypeError(f"the {what} is a str, int, float, Fraction or Decimal, not {kind}")


def text_of(value: object) -> str:
    """A whole number as ``int`` writes it, whatever its own class says; anything else as ``str`` does."""
    return int.__repr__(value) if isinstance(value, int) and not isinstance(value, bool) else str(value)


class _NoNumber(Exception):
    pass


def _text(value: object) -> str:
    # Of a Decimal str() has all digits.
    if isinstance(value, int) or hasattr(value, "as_tuple"):
        return text_of(value)
    if hasattr(value, "numerator") and hasattr(value, "denominator"):
        return f"{int(value.numerator)}/{int(value.denominator)}"
    if not hasattr(value, "as_integer_ratio"):
        raise _NoNumber
    try:
        numerator, denominator = value.as_integer_ratio()
    except (ValueError, OverflowError):
        # Not a number, or infinite.
        return str(float(value))  # type: ignore[arg-type]
    return str(int(numerator)) if denominator == 1 else f"{int(numerator)}/{int(denominator)}"
