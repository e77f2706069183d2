"""Sweeps: any number of arches, each proved, as a partitioned Parquet data set.

Everything that is guaranteed is in one part: a function of the folder and of a number, which writes the same bytes whoever
calls it. An engine only calls it for the parts that are missing, and may call it twice.
"""

from __future__ import annotations

import os
import warnings
from functools import partial
from importlib import import_module
from itertools import islice

from . import _core
from ._arrays import VERDICTS, telling
from ._asked import asked
from ._core import CoupletError
from ._exact import exact, is_text, no_text, of_numpy, text_of, whole

TYPE_CHECKING = False
if TYPE_CHECKING:
    from re import Match

    from ._types import Any, Callable, Iterable, Iterator, Mapping

    #: A part, the counts of its verdicts if it was written, and otherwise what is wrong and whether that ends the sweep.
    Done = tuple[int, tuple[int, int, int, int] | None, str, bool]
    #: What computes parts: of a folder, the one where its paths begin, the parts, so many workers.
    Engine = Callable[[str, str, list[int], int], Iterator[Done]]

#: Parts that are asked of an engine at a time, for each core: it is never without work, and holds few.
_IN_FLIGHT = 4
#: A part is tried so often, where its process dies.
_TRIES = 20


class Swept:
    """What a sweep has made.

    Attributes:
        folder: the data set, for any reader of Parquet.
        rows, counts: the rows that are there, of the share that was asked for, and how many have which verdict.
        computed, kept: parts that were computed now, and that were there.
        lost: files or pieces of a data set that cannot be read, and why.
        others: sweeps beside this one, which are as they were.
    """

    __slots__ = ("folder", "rows", "computed", "kept", "counts", "lost", "others", "_base", "_share")

    def __init__(self, folder: str, base: str, share: tuple[int, int], others: list[str], lost: list[str]) -> None:
        self.folder, self._base, self._share, self.others, self.lost = folder, base, share, others, lost
        self.rows = self.computed = self.kept = 0
        self.counts = dict.fromkeys(VERDICTS, 0)

    def _add(self, counts: Iterable[int]) -> None:
        for verdict, count in zip(VERDICTS, counts):
            self.counts[verdict] += count
            self.rows += count

    def __repr__(self) -> str:
        counts = ", ".join(f"{verdict} {count}" for verdict, count in self.counts.items() if count)
        return f"Swept({self.folder!r}, rows={self.rows}, computed={self.computed}, kept={self.kept}: {counts})"

    def to_dict(self) -> dict[str, Any]:
        """All of it, for ``json.dumps``."""
        return {name: getattr(self, name) for name in self.__slots__ if not name.startswith("_")}

    def verify(self, sample: int = 100, *, threads: int = 0) -> dict[str, Any]:
        """Looks through the parts: content, notes and inputs of each, and that no row is missing. ``sample`` rows are proved
        again bit for bit, up to 20 of them with a certificate that the second arithmetic checks.

        Returns: a dictionary of ``parts`` and ``rows`` that are as the plan asks, rows proved ``again``, rows
        ``certified``, and ``faults``, a list of what is wrong.
        """
        found = _core.sweep_verify(self.folder, self._base, self._share, sample, whole(threads))
        return dict(zip(("parts", "rows", "again", "certified", "faults"), found))


def sweep(
    plan: str | os.PathLike[str] | Mapping[str, Any],
    output: str | os.PathLike[str] = "",
    engine: Any = None,
    *,
    workers: int = 0,
    only: tuple[int, int] = (1, 1),
    progress: bool | Callable[[int, int], object] = False,
) -> Swept:
    """Proves any number of arches and writes them as a partitioned Parquet data set (docs/sweeps.md).

    The bytes are those of the command ``couplet sweep``, whatever the engine and however many workers. A sweep that was
    stopped goes on where it was: parts that are there are kept, by their names and sizes; ``Swept.verify`` reads them.

    Args:
        plan: the path of a plan (TOML), or its keys as a dictionary. Of a dictionary a float is the double that it is, text is
            exact, and files are looked for from the working folder.
        output: where the folder of the sweep is, made if need be. Workers on other machines have to see the same one.
        engine: None, threads of this process; 'processes', new ones (a script needs ``if __name__ == "__main__"``); 'ray';
            'dask', on this machine; or a ``distributed.Client``.
        workers: how many; 0 for one on each core, or what the engine has.
        only: (k, n) for the k-th of n shares of the parts, from 1.
        progress: True for a bar, if tqdm is installed; or what is called with the rows done and all rows.

    Raises: CoupletError if the plan makes no sense, with the line and the column, or of a dictionary the key; OSError if something
        cannot be written. A value that is listed twice counts once, with a warning.

        >>> import tempfile
        >>> grid = {"half_opening": ["80deg", 2.25], "friction": {"from": "0.1", "to": 1, "steps": 10}}
        >>> couplet.sweep({"grid": grid}, tempfile.mkdtemp()).counts
        {'stands': 9, 'falls': 11, 'undecided': 0, 'refused': 0}
    """
    if not hasattr(_core, "sweep_begin"):
        raise CoupletError("this couplet was built without the feature parquet, and a sweep is Parquet")
    run = _engine(engine)
    k, n = only
    if not 1 <= k <= n:
        raise CoupletError("only is (k, n), the k-th of n: (1, 4), (2, 4), (3, 4), (4, 4)")
    workers = whole(workers)
    if isinstance(plan, (str, os.PathLike)):
        base, toml = os.path.dirname(os.path.abspath(plan)), _Toml({})
        with asked(open, plan, "rb") as file:
            text = file.read()
    else:
        base, toml = os.getcwd(), _Toml({"schema": "couplet.sweep/1", **plan})
        text = toml.text.encode()
    try:
        path, others, lost, notes = asked(_core.sweep_begin, text, base, os.path.abspath(output))
    except CoupletError as error:
        raise CoupletError(toml.named(str(error))) from None
    for note in notes:
        warnings.warn(toml.named(note), stacklevel=2)
    made = Swept(os.fspath(path), base, (k, n), others, lost)
    survey = _core.sweep_survey(made.folder, base, (k, n), workers)
    rows = {part: length for part, length, counts in survey if counts is None}
    for _, _, there in survey:
        if there is not None:
            made.kept += 1
            made._add(there)
    done = 0
    with telling(progress, sum(rows.values())) as tell:
        for part, counts, fault, ends in run(made.folder, base, list(rows), workers):
            if ends:
                raise OSError(fault)
            if counts is None:
                made.lost.append(f"part {part}: {fault}")
            else:
                made.computed += 1
                made._add(counts)
            done += rows[part]
            tell(done)
    made.lost.sort()
    return made


def _part(folder: str, base: str, threads: int, part: int) -> Done:
    """A part; what is wrong is told, not raised: engines wrap exceptions, each in its own way."""
    try:
        return part, _core.sweep_part(folder, base, part, threads), "", False
    except CoupletError as error:
        return part, None, str(error), False
    except OSError as error:
        return part, None, str(error), True


def _engine(engine: Any) -> Engine:
    known: dict[Any, Engine] = {None: _threads, "processes": _processes, "ray": _ray, "dask": partial(_dask, None)}
    if hasattr(engine, "submit") and hasattr(engine, "scheduler_info"):
        return partial(_dask, engine)
    if engine is not None and not isinstance(engine, str) or engine not in known:
        raise CoupletError("an engine is one of None, processes, ray, dask, or a distributed.Client")
    return known[engine]


def _threads(folder: str, base: str, parts: list[int], workers: int) -> Iterator[Done]:
    from concurrent.futures import ThreadPoolExecutor

    workers = workers or os.cpu_count() or 1
    yield from _in_pool(ThreadPoolExecutor(workers), partial(_part, folder, base, workers), parts)


def _in_pool(pool: Any, ask: Callable[[int], Done], parts: Iterable[int]) -> Iterator[Done]:
    from concurrent.futures import as_completed

    try:
        for future in as_completed([pool.submit(ask, part) for part in parts]):
            yield future.result()
    finally:
        pool.shutdown(cancel_futures=True)


def _processes(folder: str, base: str, parts: list[int], workers: int) -> Iterator[Done]:
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool
    from multiprocessing import get_context

    left, tries = dict.fromkeys(parts), 0
    while left:
        pool = ProcessPoolExecutor(workers or None, get_context("spawn"), _end_with_the_driver)
        try:
            for done in _in_pool(pool, partial(_part, folder, base, 1), left):
                del left[done[0]]
                yield done
        except BrokenProcessPool:
            # A worker was killed, and with it the pool: what is left goes to a new one.
            tries += 1
            if tries == _TRIES:
                raise


def _end_with_the_driver() -> None:
    """A worker whose driver was killed would wait for parts for ever."""
    from multiprocessing import connection, parent_process
    from threading import Thread

    driver = parent_process()
    if driver is not None:

        def watch(sentinel: int = driver.sentinel) -> None:
            connection.wait([sentinel])
            os._exit(1)

        Thread(target=watch, daemon=True).start()


def _ray(folder: str, base: str, parts: list[int], workers: int) -> Iterator[Done]:
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    ray: Any = import_module("ray")
    if not ray.is_initialized():
        ray.init(num_cpus=workers or None, include_dashboard=False, log_to_driver=False)
    task = ray.remote(num_cpus=1, max_retries=_TRIES)(_part)
    left = iter(parts)
    many = _IN_FLIGHT * int(ray.cluster_resources().get("CPU", 1))
    waiting = [task.remote(folder, base, 1, part) for part in islice(left, many)]
    while waiting:
        done, waiting = ray.wait(waiting)
        waiting += [task.remote(folder, base, 1, part) for part in islice(left, len(done))]
        yield from ray.get(done)


def _dask(client: Any, folder: str, base: str, parts: list[int], workers: int) -> Iterator[Done]:
    distributed: Any = import_module("distributed")
    if client is None:
        # A worker that dies makes every part that it was given suspect, not only the one that it had.
        with distributed.dask.config.set({"distributed.scheduler.allowed-failures": _TRIES}):
            with distributed.Client(n_workers=workers or os.cpu_count(), threads_per_worker=1, dashboard_address=None) as own:
                yield from _dask(own, folder, base, parts, workers)
        return
    left = iter(parts)
    many = _IN_FLIGHT * max(1, sum(client.nthreads().values()))
    ask = partial(client.submit, _part, folder, base, 1, pure=False, retries=_TRIES)
    waiting = distributed.as_completed([ask(part) for part in islice(left, many)])
    for future in waiting:
        for part in islice(left, 1):
            waiting.add(ask(part))
        yield future.result()


class _Toml:
    """A plan as TOML, with numbers as they are, and the place of each of its keys; it is empty where the plan is a file."""

    def __init__(self, table: Mapping[str, Any]) -> None:
        self.text, self.line = "", ""
        self.places: list[tuple[int, int, str]] = []
        for number, (key, value) in enumerate(table.items(), 1):
            self.line = ""
            self._pair(number, "", key, value)
            self.text += self.line + "\n"

    def named(self, sentences: str, place: str = "line {}, column {}: ") -> str:
        """Sentences about lines and columns, which nobody wrote, with the keys there."""
        import re

        def key(found: Match[str]) -> str:
            at = int(found[1]), int(found[2])
            before = [name for line, column, name in self.places if (1, 1) < at >= (line, column)]
            return f"{before[-1]}: " if before else ""

        return re.sub("^" + place.replace("{}", r"(\d+)"), key, sentences, flags=re.MULTILINE) if self.places else sentences

    def _pair(self, number: int, within: str, key: Any, value: Any) -> None:
        if not isinstance(key, str):
            raise TypeError(f"a key is a str, not {type(key).__name__}: {key!r}")
        name = f"{within}.{key}" if within else key
        self.places.append((number, len(self.line) + 1, name))
        self.line += (key if key.isidentifier() and key.isascii() else _text(key)) + " = "
        self._value(number, name, value)

    def _value(self, number: int, name: str, value: Any) -> None:
        value = of_numpy(value)
        is_table = hasattr(value, "items")
        if not is_table and not isinstance(value, (list, tuple, range)):
            self.line += _plain(value)
            return
        self.line += "{ " if is_table else "["
        for place, inner in enumerate(value.items() if is_table else value):
            self.line += ", " if place else ""
            if is_table:
                self._pair(number, name, *inner)
            else:
                self._value(number, name, inner)
        self.line += " }" if is_table else "]"


def _text(text: str) -> str:
    import json

    if not is_text(text):
        raise CoupletError(no_text(text))
    return json.dumps(text, ensure_ascii=False)


def _plain(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return _text(value)
    return text_of(value) if isinstance(value, int) else _text(exact(value, "number"))
