"""Many rows, asked some at a time: Ctrl-C ends them soon, memory is that of a piece, and a note is a warning once."""

from __future__ import annotations

import math
import time

from . import _core
from ._asked import asked, warn

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ._types import Any, Callable, Iterator, TypeVar

    Told = TypeVar("Told")

# The time that rows are computed for before Python is asked for its signals.
_SECONDS = 0.2
_FIRST = 512
#: The most rows of a piece: more are not in the caches when their columns are written.
_MOST = 1 << 15
#: Pairs among the rows that are looked at where each number comes three times.
_PAIRS = 256


def in_tables(
    np: Any, rows: Any, question: tuple[str, dict[str, Any], list[str], int], tell: Callable[[int], object] = lambda done: None
) -> Iterator[tuple[Any, Any]]:
    """The answers of a table, of some rows at a time. The question: the model of self-weight, the columns, doubles or exact texts, by what
    the command calls each, ``theirs=ours:deg``, the quantities, the threads."""
    weight, columns, quantities, threads = question
    names, cells = list(columns), list(columns.values())

    def some(column: Any, here: Any) -> Any:
        if not isinstance(column, list):
            return column[here].tobytes()
        return column[here] if isinstance(here, slice) else [column[row] for row in here.tolist()]

    def ask(here: Any) -> Any:
        return asked(_core.table, weight, names, [some(column, here) for column in cells], quantities, threads)

    return in_pieces(np, None if isinstance(cells[0], list) else cells[0], rows, ask, tell)


def in_pieces(
    np: Any, keys: Any, rows: Any, ask: Callable[[Any], tuple[str | None, Told]], tell: Callable[[int], object]
) -> Iterator[tuple[Any, Told]]:
    """What is told of some rows at a time, with the places of these.

    Args:
        keys: the half openings, if they are an array of doubles: rows of one are asked together, as they share its proofs.
        rows: the places of the rows that are asked, or how many there are if they are all.
        ask: what tells of the rows of some places, behind a note. tell: what is called with the number of rows done.
    """
    size = rows if isinstance(rows, int) else len(rows)
    order = None if isinstance(rows, int) else rows
    if keys is not None and size > _MOST:
        given = keys if order is None else keys[order]
        if _come_again(np, given) and not (given[1:] >= given[:-1]).all():
            places = np.argsort(given)
            order = places if order is None else order[places]
    begin, count, is_noted = 0, _FIRST, False
    while begin < size:
        end = min(begin + count, size)
        here = slice(begin, end) if order is None else order[begin:end]
        start = time.perf_counter()
        note, told = ask(here)
        if note is not None and not is_noted:
            warn(note)
            is_noted = True
        yield here, told
        tell(end)
        speed = (end - begin) / max(time.perf_counter() - start, 1e-6)
        count = int(min(max(speed * _SECONDS, _FIRST), 8 * count, _MOST))
        begin = end


def _come_again(np: Any, keys: Any) -> bool:
    """Whether many of the numbers come more than once."""
    places = np.random.default_rng(0).integers(0, len(keys), math.isqrt(_PAIRS * len(keys)))
    some = np.sort(keys[np.unique(places)])
    return bool((some[1:] == some[:-1]).sum() > _PAIRS >> 4)
