"""Many arches at once, over NumPy, which is imported by the first call."""

from __future__ import annotations

from contextlib import contextmanager

from . import _core
from ._arches import assess, state, target_of
from ._asked import asked, words
from ._core import CoupletError
from ._exact import exact, whole
from ._named import Batch, named
from ._rows import in_pieces, in_tables

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ._types import Any, Callable, Iterator, Literal, Sequence, Unpack, np

#: What ``verdict`` is a place in. An arch with a thickness stands or falls with it; one without, at some or at none.
VERDICTS: tuple[str, ...] = ("stands", "falls", "undecided", "refused")
# The columns of what is asked.
ASKED = ("half_opening", "friction", "given_thickness")


@named(Batch)
def states(half_opening: Any, friction: Any, thickness: Any = None, **batch: Unpack[Batch]) -> np.ndarray[Any, Any]:
    """The states of many arches, each proved, as a structured array. A double is exactly the number that it is.

    The arrays are broadcast against each other: ``states(alpha[:, None], mu[None, :])`` is a grid. Rows of one half opening share its
    proofs, wherever they stand, and no bit depends on that. A bad row is a row, with the verdict 3; the others are answered. The
    interpreter lock is released, and Ctrl-C stops it within a second or so.

    Args:
        half_opening: rad, between 0 and pi: an array of numbers, or anything that NumPy reads without a change.
        friction: coefficients, 0 or more; infinite for no limit.
        thickness: t/r, above 0 and at most 2; then each row is asked whether it stands with it.
        weight: the model of self-weight of all, 'heyman' or 'milankovitch'.
        quantities: the values that are computed. Without a thickness of 'thickness' (usual), 'thrust', 'intrinsic_thrust',
            'rotation_joint', 'sliding_joint', 'sliding_friction', 'rotational_friction'; with one of 'geometric_safety'
            (usual), 'least_thickness', 'required_friction', 'friction_safety', 'least_thrust', 'largest_thrust'; and always
            'asymmetric_thickness', the largest at which an asymmetric mechanism is found and proved of an arch that stands.
        threads: threads to compute with; 0 for one on each core, 1 where other processes have the others.
        progress: True for a bar, if tqdm is installed; or what is called with the rows done and all rows.

    Returns: an array of the common shape with the fields
        verdict: a couplet.Verdict, and a place in couplet.VERDICTS: 0 stands (an admissible symmetric state exists, which with friction
            does not exclude an asymmetric mechanism), 1 falls, 2 undecided, 3 refused; of the last two ``reasons`` tells why.
        mode: a couplet.Mode, and a place in couplet.MODES, how it collapses at its least thickness; 255 where there is none.
        and for each quantity NAME, NAME_lower, NAME_upper: the double nearest to the true value, correctly rounded, and doubles not
        above and not below it. Not a number where there is no such value, or it is undecided: an arch that falls at every thickness
        has a sliding_friction, with which it would not slide, and nothing else.

    Raises: CoupletError if the arrays are not of doubles, do not fit each other, or a name is unknown.

        >>> grid = couplet.states([1.3, 1.4], [[0.2], [0.5]])
        >>> grid["verdict"].tolist(), float(grid["thickness"][1, 0])
        ([[0, 1], [0, 0]], 0.052296358975188306)
    """
    rows = _Rows((half_opening, friction, thickness), **batch)
    # Aligned, so that every field can be used as it is.
    found = rows.np.zeros(rows.size, dtype=rows.np.dtype(rows.kinds, align=True))
    rows.answer(found)
    return found.reshape(rows.shape)  # type: ignore[no-any-return]


@named(Batch)
def states_columns(half_opening: Any, friction: Any, thickness: Any = None, **batch: Unpack[Batch]) -> dict[str, np.ndarray[Any, Any]]:
    """The same as ``states`` as columns, a dictionary of flat arrays, as pandas, polars and pyarrow take it: half_opening, friction, where
    it is given given_thickness, and the fields of ``states``."""
    return _Rows((half_opening, friction, thickness), **batch).columns()


@named(Batch)
def states_frame(half_opening: Any, friction: Any, thickness: Any = None, **batch: Unpack[Batch]) -> Any:
    """The same as ``states_columns`` as a ``pandas.DataFrame`` for people: ``verdict`` and ``mode`` are categories, words that pandas
    counts and filters by, and ``reason`` says why a row is refused or undecided. It needs pandas."""
    import pandas  # type: ignore[import-not-found, import-untyped, unused-ignore]

    rows = _Rows((half_opening, friction, thickness), **batch)
    columns = rows.columns()
    codes = columns["verdict"]
    why = rows.reasons(codes)
    columns["verdict"] = pandas.Categorical.from_codes(codes, list(VERDICTS))
    # 255 is -1, which is none.
    columns["mode"] = pandas.Categorical.from_codes(columns["mode"].view("int8"), _core.modes())
    columns["reason"] = [why.get(row) for row in range(len(codes))]
    return pandas.DataFrame(columns)


#: What ``verdict`` of ``finds`` is a place in.
FOUND: tuple[str, ...] = ("found", "nothing", "undecided", "refused")


def finds(
    what: Literal["half_opening", "alpha", "friction", "mu", "boundary"],
    modes: str | Sequence[str] | None = None,
    *,
    half_opening: Any = None,
    friction: Any = None,
    thickness: Any = None,
    weight: str = "milankovitch",
    threads: int = 0,
    progress: bool | Callable[[int, int], object] = False,
) -> np.ndarray[Any, Any]:
    """The questions of ``find`` over arrays of doubles, each answered with its proof, as a structured array.

    Args:
        what, modes, weight: as for ``find``. threads, progress: as for ``states``.
        half_opening, friction, thickness: arrays of doubles that are broadcast against each other, as far as the question has them.

    Returns: an array of the common shape with the fields
        verdict: 0 found, 1 nothing (proved), 2 undecided, 3 refused: a place in couplet.FOUND.
        value, value_lower, value_upper: the double nearest to what is found, and doubles not above and not below it; else not a
            number. ``couplet.find`` says of one question why.

    Raises: CoupletError if the arrays are not of doubles, do not fit each other, or something does not belong there.

        >>> found = couplet.finds("half_opening", friction=[0.3, 0.5], thickness=[[0.05], [0.2]])
        >>> found.shape, float(found["value"][1, 1]) == couplet.find("half_opening", friction=0.5, thickness=0.2).value.double
        ((2, 2), True)
    """
    np = need_numpy()
    whole(threads)
    given = {"half openings": half_opening, "frictions": friction, "thicknesses": thickness}
    shape, flat = _flat(np, {name: array for name, array in given.items() if array is not None})
    target = target_of(what, modes)
    columns = [flat.get(name) for name in given]
    kinds = [("verdict", np.uint8), *((name, np.float64) for name in ("value", "value_lower", "value_upper"))]
    found = np.zeros(int(np.prod(shape)), dtype=np.dtype(kinds, align=True))
    # Of a question that makes no sense, whatever the numbers, the first row says so.
    names = [None if column is None else "1" for column in columns]
    _, ((code, _, why),) = asked(_core.finds, target, weight, [names], 1)
    if code == FOUND.index("refused"):
        raise CoupletError(str(why))

    def ask(here: Any) -> Any:
        texts = [
            [None] * (here.stop - here.start) if column is None else [exact(x, "number") for x in column[here].tolist()]
            for column in columns
        ]
        return asked(_core.finds, target, weight, list(map(list, zip(*texts))), threads)

    with telling(progress, found.size) as tell:
        for here, told in in_pieces(np, None, found.size, ask, tell):
            found[here] = [(code, *bounds) for code, bounds, _ in told]
    return found.reshape(shape)  # type: ignore[no-any-return]


def reasons(
    found: np.ndarray[Any, Any], half_opening: Any, friction: Any, thickness: Any = None, *, weight: str = "milankovitch"
) -> dict[Any, str]:
    """Why rows of ``states`` are refused or undecided, by their places: numbers, or of a grid tuples. Worked out for these alone.

    Args:
        found: the array that ``states`` has answered to the other arguments.

        >>> arrays = [1.0, 1.0], [0.5, -1.0]
        >>> couplet.reasons(couplet.states(*arrays), *arrays)
        {1: 'the friction -1 is negative'}
    """
    rows = _Rows((half_opening, friction, thickness), weight)
    if rows.shape != found.shape:
        raise CoupletError(f"the answers have the shape {found.shape}, and the questions {rows.shape}")
    why = rows.reasons(found["verdict"].reshape(-1))
    if found.ndim == 1:
        return why
    return {tuple(map(int, rows.np.unravel_index(row, rows.shape))): reason for row, reason in why.items()}


def need_numpy() -> Any:
    """NumPy, or one sentence."""
    try:
        import numpy

        return numpy
    except ModuleNotFoundError as error:
        if error.name != "numpy":
            raise
        message = "states and states_columns need NumPy, which is not installed: pip install numpy"
        raise ModuleNotFoundError(message, name="numpy") from None


def asked_for(quantities: str | Sequence[str] | None, has_thickness: bool) -> list[str]:
    """The names of what is computed: those that are given, or what is usual."""
    return words(quantities if quantities is not None else "geometric_safety" if has_thickness else "thickness")


class _Rows:
    """Arrays of one shape, flat, and what is asked of each row."""

    def __init__(self, arrays: tuple[Any, ...], weight: str, quantities: Any = None, threads: int = 0, progress: Any = False) -> None:
        self.np, self.progress = need_numpy(), progress
        given = zip(("half openings", "frictions", "thicknesses"), arrays)
        self.shape, flat = _flat(self.np, {what: array for what, array in given if array is not None})
        self.asked = dict(zip(ASKED, flat.values()))
        self.size = self.asked["friction"].size
        columns = {f"{name}={name}": array for name, array in self.asked.items()}
        names = list(dict.fromkeys(asked_for(quantities, len(flat) > 2)))
        # Nothing is computed before every name is known, nor under a name of the paper.
        asked(_core.table, weight, list(columns), [b""] * len(flat), names, 1)
        names = list(dict.fromkeys(map(_core.quantity, names)))
        self.question = weight, columns, names, whole(threads)
        # What is answered, and what it is.
        values = [(name + end, self.np.float64) for name in names for end in ("", "_lower", "_upper")]
        self.kinds = [("verdict", self.np.uint8), ("mode", self.np.uint8), *values]

    def answer(self, found: Any) -> None:
        """Writes every field, some rows at a time."""
        with telling(self.progress, self.size) as tell:
            for places, (verdict, mode, values, _) in in_tables(self.np, self.size, self.question, tell):
                columns = [verdict, mode, *(bound for value in values for bound in value)]
                for (name, kind), column in zip(self.kinds, columns):
                    found[name][places] = self.np.frombuffer(column, kind)

    def columns(self) -> dict[str, Any]:
        """What is asked and what is answered, as flat arrays."""
        found = {name: self.np.zeros(self.size, kind) for name, kind in self.kinds}
        self.answer(found)
        return {**{name: self.np.array(array) for name, array in self.asked.items()}, **found}

    def reasons(self, codes: Any) -> dict[int, str]:
        """The reasons of the rows that have no verdict, of which these are the codes."""
        why = {}
        for row in (codes >= VERDICTS.index("undecided")).nonzero()[0].tolist():
            arch: Any = [float(array[row]) for array in self.asked.values()]
            try:
                answer = (assess if len(arch) > 2 else state)(*arch, weight=self.question[0], digits=17)
                why[row] = answer.reason or "it is undecided in doubles"
            except CoupletError as error:
                why[row] = str(error)
        return why


def _flat(np: Any, given: dict[str, Any]) -> tuple[Any, dict[str, Any]]:
    """The common shape of arrays of doubles, and each of them flat."""
    arrays = [_doubles(np, array, what) for what, array in given.items()]
    try:
        arrays = np.broadcast_arrays(*arrays)
    except ValueError as error:
        raise CoupletError(f"the arrays do not fit each other: {error}") from None
    return arrays[0].shape if arrays else (), {what: array.reshape(-1) for what, array in zip(given, arrays)}


def _doubles(np: Any, values: Any, what: str) -> Any:
    """An array of doubles that are the numbers given, without a rounding."""
    try:
        array = np.asanyarray(values)
        if isinstance(array, np.ma.MaskedArray):
            # What is masked is no number.
            array = array.astype(np.float64).filled(np.nan) if array.mask.any() else array.data
        array = np.asarray(array)
    except (ValueError, TypeError) as error:
        raise CoupletError(f"the {what} are no array: {error}") from None
    if array.dtype.kind == "f" and array.dtype.itemsize <= 8 or array.dtype.kind in "iu":
        doubles = array.astype(np.float64, copy=False)
        if array.dtype.kind == "f" or (doubles.astype(array.dtype) == array).all():
            return doubles
    if array.size == 0:
        return array.astype(np.float64)
    raise CoupletError(f"the {what} are no doubles but {array.dtype}; couplet.state takes exact text and fractions")


@contextmanager
def telling(progress: Any, size: int) -> Iterator[Callable[[int], object]]:
    """What is told how many rows are done: what was given, or a bar if tqdm is there, or nothing."""
    if progress and not callable(progress):
        try:
            from tqdm.auto import tqdm  # type: ignore[import-not-found, import-untyped, unused-ignore]
        except ImportError:
            pass
        else:
            with tqdm(total=size, unit=" arches") as bar:
                yield lambda done: bar.update(done - bar.n)
            return
    yield lambda done: progress(done, size) if callable(progress) else None
