"""Asks what is compiled, in its words and for the words of Python."""

from __future__ import annotations

from . import _core
from ._core import CoupletError
from ._exact import exact, no_text, of_numpy, text_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ._types import Any, Callable, Given, ParamSpec, Sequence, TypeVar

    P = ParamSpec("P")
    T = TypeVar("T")

#: What an arch may be given by.
FIELDS: tuple[str, ...] = tuple(_core.fields())


def asked(function: Callable[P, T], *arguments: P.args, **named: P.kwargs) -> T:
    """What a function of ``_core`` answers; a text that is none is bad input like any other."""
    try:
        return function(*arguments, **named)
    except UnicodeEncodeError as error:
        raise CoupletError(no_text(error.object)) from None
    except (CoupletError, _core.UndecidedError) as error:
        said = spoken(str(error))
        if said == str(error):
            raise
        raise type(error)(said) from None


def of_json(text: str | bytes) -> Any:
    """What a text says in JSON, whose reader is imported by the first."""
    import json

    return json.loads(text)


def warn(note: str) -> None:
    """Warns, where the package was called, of what may have been meant otherwise."""
    import sys
    import warnings

    level, frame = 1, sys._getframe()
    while frame is not None and frame.f_globals.get("__name__", "").partition(".")[0] == "couplet":
        level, frame = level + 1, frame.f_back  # type: ignore[assignment]
    warnings.warn(spoken(note), stacklevel=level)


# What a shell has in a sentence, and Python instead.
_SPOKEN: tuple[tuple[str, Any], ...] = (
    # What a whole line is, and how to build the command.
    (r"; (?:usage|for example): couplet .*|, or give --format| \(cargo [^)]*\)", ""),
    (r"^unexpected argument '--([\w-]+)' found.*", r"--\1 does not belong here"),
    (r"`?\bcouplet ([a-z]+)`?, with -o [\w.]+", r"couplet.\1(…).svg()"),
    (r"`couplet (\w+) --([\w-]+)`(?= answers)", r"couplet.\1(--\2=…)"),
    (r"\bcouplet prove --list", "couplet.claims()"),
    (r"`couplet (\w+)[^`]*`|\bcouplet ([a-z]+)(?= tells\b)", r"couplet.\1\2"),
    # An option of which the value is wrong.
    (r"invalid value '(.*?)' for '--([\w-]+) <[^']*>'(?:: |; \[possible values: (.*)\])", r"--\2='\1': \3"),
    (r"invalid value '(.*?)' for '<\w+>': ", ""),
    (r"(?:the argument )?'--([\w-]+)(?: <[^']*>)?'", r"--\1"),
    # An option with a value that is right.
    (r"--columns (\w+)=(\w+)", r"columns={'\1': '\2'}"),
    (r"--along (friction) ([\d.]+)", r"along=('\1', '\2')"),
    (r"--keep (\w+)", r"keep='\1'"),
    (r"--(\w+) (\d\S*)", r"--\1=\2"),
    (r"--([a-z]+(?:-[a-z]+)*)", lambda option: option[1].replace("-", "_")),
)


def spoken(sentence: str) -> str:
    """A sentence of the command as Python says it: keywords in place of options, functions of commands, and its own doubles."""
    import re

    for shell, python in _SPOKEN if "--" in sentence or "couplet " in sentence or "invalid" in sentence else ():
        sentence = re.sub(shell, python, sentence)
    return re.sub(r"(?<![\d/])(-?\d+)/(\d{7,})(?![\d/])", _double, sentence) if "/" in sentence else sentence


def _double(found: Any) -> str:
    """A fraction that is a double, as Python writes it."""
    numerator, denominator = int(found[1]), int(found[2])
    is_double = denominator & (denominator - 1) == 0 and numerator.bit_length() <= 53
    return repr(numerator / denominator) if is_double else found[0]


def texts_of(values: dict[str, Any]) -> tuple[dict[str, str], Given]:
    """The texts of an arch, and what is given, by its names."""
    given = tuple([(name, _plain(values[name])) for name in FIELDS if values.get(name) is not None])
    return {name: value if isinstance(value, str) else _text(name, value) for name, value in given}, given


def _plain(value: Any) -> Any:
    value = of_numpy(value)
    return tuple(value) if isinstance(value, list) else value


def _text(name: str, value: Any) -> str:
    if name == "joints" and isinstance(value, tuple):
        return ",".join(exact(angle, "angle of a joint") for angle in value)
    if name == "stones":
        return _stones(value)
    if name == "measured_at":
        raise TypeError(f"the circle at which an arch is measured is a str, not {type(value).__name__}")
    return exact(value, name.replace("_", " "))


def _stones(value: Any) -> str:
    if isinstance(value, range):
        if value.step != 1 or not value:
            raise CoupletError("a range of stones has all numbers from its first to its last: range(2, 201)")
        return f"{value[0]}..{value[-1]}"
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"stones are an int, a str or a range, not {type(value).__name__}")
    return text_of(value.__index__())


def ranged(values: dict[str, Any]) -> dict[str, Any]:
    """The values of arches, of which each may be two ends, with texts of these ranges."""
    return {name: _range(name, value) if name in FIELDS else value for name, value in values.items()}


def _range(name: str, value: Any) -> Any:
    """The text of a range of two ends; any other value as it is."""
    if not isinstance(value, tuple) or name in ("joints", "stones"):
        return value
    if len(value) != 2:
        raise CoupletError(f"a range of the {name.replace('_', ' ')} is (lower, upper), not {len(value)} values")
    lower, upper = (exact(end, f"end of the {name.replace('_', ' ')}") for end in value)
    return f"{lower}..{upper}"


def words(values: str | Sequence[str]) -> list[str]:
    """Names, of which one may be given alone."""
    return [values] if isinstance(values, str) else list(values)
