"""Threads of a call."""

from __future__ import annotations

import operator

from ._core import CoupletError

_MOST_THREADS = 1024


def whole(threads: int) -> int:
    """A number of threads."""
    try:
        number = -1 if isinstance(threads, bool) else operator.index(threads)
    except TypeError:
        number = -1
    if not 0 <= number <= _MOST_THREADS:
        raise CoupletError(f"threads are a whole number from 1 to {_MOST_THREADS}, or 0 for one on each core")
    return number
