"""Asks what is compiled."""

from __future__ import annotations

from ._core import CoupletError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import ParamSpec, TypeVar

    P = ParamSpec("P")
    T = TypeVar("T")


def asked(function: Callable[P, T], *arguments: P.args, **named: P.kwargs) -> T:
    """What a function of ``_core`` answers; a text that is none is bad input like any other."""
    try:
        return function(*arguments, **named)
    except UnicodeEncodeError as error:
        raise CoupletError(f"{error.object!r} is no text: it has half a surrogate pair, which is no character") from None
