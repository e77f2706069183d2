"""Many rows, asked some at a time: Ctrl-C ends them soon, and memory is that of a piece."""

from __future__ import annotations

import math
import time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any, TypeVar

    Told = TypeVar("Told")

# The time that rows are computed for before Python is asked for its signals.
_SECONDS = 0.2
_FIRST = 512
#: The most rows of a piece: more are not in the caches when their columns are written.
_MOST = 1 << 15
#: Pairs among the rows that are looked at where each number comes three times.
_PAIRS = 256


def in_pieces(
    np: Any, keys: Any, rows: Any, ask: Callable[[Any], Told], tell: Callable[[int], object] = lambda done: None
) -> Iterator[tuple[Any, Told]]:
    """What is told of some rows at a time, with the places of these.

    Args:
        keys: the half openings, if they are an array of doubles: rows of one are asked together, as they share its proofs.
        rows: the places of the rows that are asked, or how many there are if they are all.
        ask: what tells of the rows of some places. tell: what is called with the number of rows done.
    """
    size = rows if isinstance(rows, int) else len(rows)
    order = None if isinstance(rows, int) else rows
    if keys is not None and size > _MOST:
        given = keys if order is None else keys[order]
        if _come_again(np, given) and not (given[1:] >= given[:-1]).all():
            places = np.argsort(given)
            order = places if order is None else order[places]
    begin, count = 0, _FIRST
    while begin < size:
        end = min(begin + count, size)
        here = slice(begin, end) if order is None else order[begin:end]
        start = time.perf_counter()
        yield here, ask(here)
        tell(end)
        speed = (end - begin) / max(time.perf_counter() - start, 1e-6)
        count = int(min(max(speed * _SECONDS, _FIRST), 8 * count, _MOST))
        begin = end


def _come_again(np: Any, keys: Any) -> bool:
    """Whether many of the numbers come more than once."""
    places = np.random.default_rng(0).integers(0, len(keys), math.isqrt(_PAIRS * len(keys)))
    some = np.sort(keys[np.unique(places)])
    return bool((some[1:] == some[:-1]).sum() > _PAIRS >> 4)
