"""Asks what is compiled."""

from __future__ import annotations

from . import _core
from ._core import CoupletError
from ._exact import exact, no_text, text_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any, Optional, ParamSpec, TypeVar

    #: The half opening and the friction of an arch, and what else there is in the order of FIELDS.
    Texts = tuple[Optional[str], Optional[str], Optional[list[Optional[str]]]]
    #: What is given, by its names.
    Given = tuple[tuple[str, Any], ...]
    P = ParamSpec("P")
    T = TypeVar("T")

#: What an arch may be given by.
FIELDS: tuple[str, ...] = tuple(_core.fields())
_NOTHING_ELSE = (None,) * (len(FIELDS) - 2)


def asked(function: Callable[P, T], *arguments: P.args, **named: P.kwargs) -> T:
    """What a function of ``_core`` answers; a text that is none is bad input like any other."""
    try:
        return function(*arguments, **named)
    except UnicodeEncodeError as error:
        raise CoupletError(no_text(error.object)) from None
    except (CoupletError, _core.UndecidedError) as error:
        said = keyed(str(error))
        if said == str(error):
            raise
        raise type(error)(said) from None


def warn(note: str) -> None:
    """Warns, where the package was called, of what may have been meant otherwise."""
    import sys
    import warnings

    level, frame = 1, sys._getframe()
    while frame is not None and frame.f_globals.get("__name__", "").partition(".")[0] == "couplet":
        level, frame = level + 1, frame.f_back  # type: ignore[assignment]
    warnings.warn(with_doubles(note), stacklevel=level)


def keyed(sentence: str) -> str:
    """A sentence of the command, with the names of keywords in place of options, and doubles as Python writes them."""
    import re

    sentence = re.sub(r"--([a-z]+(?:-[a-z]+)*)", lambda option: option[1].replace("-", "_"), sentence)
    return with_doubles(sentence)


def with_doubles(sentence: str) -> str:
    """A sentence in which doubles are written as Python writes them."""
    import re

    return re.sub(r"(?<![\d/])(-?\d+)/(\d{7,})(?![\d/])", _double, sentence)


def _double(found: Any) -> str:
    """A fraction that is a double, as Python writes it."""
    numerator, denominator = int(found[1]), int(found[2])
    is_double = denominator & (denominator - 1) == 0 and numerator.bit_length() <= 53
    return repr(numerator / denominator) if is_double else found[0]


def arch(half_opening: Any, friction: Any, others: tuple[Any, ...]) -> tuple[Texts, Given]:
    """The texts of an arch, and what is given, by its names."""
    # What is asked most is asked by two texts or three, in a hurry.
    if half_opening is not None and friction is not None:
        try:
            if others == _NOTHING_ELSE:
                texts = exact(half_opening, "half opening"), exact(friction, "friction"), None
                return texts, (("half_opening", half_opening), ("friction", friction))
            thickness = others[1]
            if others[0] is None and others[2:] == _NOTHING_ELSE[2:]:
                three = exact(half_opening, "half opening"), exact(friction, "friction"), [None, exact(thickness, "thickness")]
                return three, (("half_opening", half_opening), ("friction", friction), ("thickness", thickness))
        except ValueError as error:
            # An array is not compared.
            if isinstance(error, CoupletError):
                raise
    return named_arch(dict(zip(FIELDS, (half_opening, friction, *others))))


def named_arch(named: dict[str, Any]) -> tuple[Texts, Given]:
    """The same of an arch by its names."""
    values = [_plain(named.get(name)) for name in FIELDS]
    half_opening, friction, *others = (_text(name, value) for name, value in zip(FIELDS, values))
    return (half_opening, friction, others), tuple(zip(FIELDS, values))


def _plain(value: Any) -> Any:
    value = value.tolist() if hasattr(value, "tolist") else value
    return tuple(value) if isinstance(value, list) else value


def _text(name: str, value: Any) -> str | None:
    if value is None or isinstance(value, str):
        return value
    what = name.replace("_", " ")
    if name == "joints" and isinstance(value, tuple):
        return ",".join(exact(angle, "angle of a joint") for angle in value)
    if name == "stones":
        return _stones(value)
    if name == "measured_at":
        raise TypeError(f"the circle at which an arch is measured is a str, not {type(value).__name__}")
    return exact(value, what)


def _stones(value: Any) -> str:
    if isinstance(value, range):
        if value.step != 1 or not value:
            raise CoupletError("a range of stones has all numbers from its first to its last: range(2, 201)")
        return f"{value[0]}..{value[-1]}"
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"stones are an int, a str or a range, not {type(value).__name__}")
    return text_of(value.__index__())


def survey(question: str, weight: str, values: tuple[Any, ...], digits: str) -> dict[str, Any] | None:
    """What is proved of every arch of a question with ranges, as in JSON; None if it has no range."""
    if not any(map(_is_range, values)):
        return None
    import json

    told = asked(_core.surveyed, question, weight, ranges(values), digits)
    return None if told is None else dict(json.loads(told))


def ranges(values: tuple[Any, ...]) -> Texts:
    """The texts of arches of which each value may be two ends."""
    return named_arch({name: _range(name, value) for name, value in zip(FIELDS, values)})[0]


def _is_range(value: Any) -> bool:
    """Whether a value is two ends, or a text with the sign of a range."""
    return isinstance(value, tuple) or isinstance(value, str) and asked(_core.is_range, value)


def _range(name: str, value: Any) -> Any:
    """The text of a range of two ends; any other value as it is."""
    if not isinstance(value, tuple) or name == "joints":
        return value
    if len(value) != 2:
        raise CoupletError(f"a range of the {name.replace('_', ' ')} is (lower, upper), not {len(value)} values")
    lower, upper = (exact(end, f"end of the {name.replace('_', ' ')}") for end in value)
    return f"{lower}..{upper}"


def words(values: str | Sequence[str]) -> list[str]:
    """Names, of which one may be given alone."""
    return [values] if isinstance(values, str) else list(values)
