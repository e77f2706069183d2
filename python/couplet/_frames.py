"""Tables of any kind with the states of their rows: what engines call for each batch."""

from __future__ import annotations

import sys

from . import _core
from ._arrays import VERDICTS, asked_for, need_numpy
from ._asked import asked, spoken
from ._core import CoupletError
from ._exact import is_text, no_text, whole
from ._kinds import NO_SIDE, NO_WORD, kind_of
from ._rows import in_tables

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ._kinds import Columns
    from ._types import Any, Iterator, Sequence, TypeVar

    Table = TypeVar("Table")

_WEIGHTS = ("heyman", "milankovitch")
_UNITS = ("deg", "rad")
# How engines are asked, whose tables are elsewhere.
_MAPS = ("mapInArrow", "map_partitions", "map_batches")


def add_states(
    data: Table,
    /,
    *,
    half_opening: str = "half_opening",
    friction: str | None = None,
    friction_angle: str | None = None,
    thickness: str | None = None,
    weight: str = "milankovitch",
    quantities: str | Sequence[str] | None = None,
    prefix: str = "",
    suffix: str = "",
    threads: int = 1,
) -> Table:
    """A table with the proved state of the arch in each row: what an engine calls for each batch (docs/python.md, "Engines").

    A row is that of ``couplet states``: numbers are the numbers that they are (degrees too: 30 of them are 30deg, and
    no double), texts and decimals are exact. Rows keep their order and their index, columns their types. A bad row is a row,
    ``refused`` with its reason; so is one that lacks a value.

    Args:
        data: a ``DataFrame`` of pandas or polars, a ``LazyFrame``, a ``Table``, ``RecordBatch`` or ``RecordBatchReader`` of pyarrow, a
            dictionary of arrays; anything else that speaks Arrow's C interface, which becomes a ``pyarrow.Table``.
        half_opening: its column, in radians, or with its unit: 'alpha_deg:deg'.
        friction, friction_angle: the column of coefficients, 'friction' if neither is given; or of angles, as the half opening.
        thickness: the column of thicknesses, t/r; then each row is asked whether it stands with it.
        weight: the model of self-weight, 'heyman' or 'milankovitch', or the column that names it (where that is empty: milankovitch).
        quantities: as for ``states``.
        prefix, suffix: what the names of new columns begin and end with.
        threads: threads to compute with: 1 where an engine has the others; 0 for one on each core.

    Returns: the same kind of table with the columns
        verdict: stands, falls, undecided or refused; reason: why it is one of the last two.
        mode: how it collapses at its least thickness (not where a thickness is given).
        and for each quantity NAME, the double nearest to the true value, and NAME_side, where that lies: -1 below the double, 0 on it,
        1 above it; nothing where there is no such value.
        Words are categories of pandas, an Enum of polars and texts of Arrow. A dictionary of arrays has codes, places in
        couplet.VERDICTS and couplet.MODES, and for nothing 255, a side of -128 and what is not a number.

    Raises: CoupletError if there is no such column, it has no numbers, or the table has one of a new name or one that no row is asked
        (tilt, stones, joints); TypeError if it is no table.
    """
    need_numpy()
    given = {"half_opening": half_opening, "friction": friction, "friction_angle": friction_angle, "given_thickness": thickness}
    if friction is None and friction_angle is None:
        given["friction"] = "friction"
    roles = {role: name for role, name in given.items() if name is not None}
    for role, name in {**roles, "weight": weight}.items():
        if not isinstance(name, str):
            raise TypeError(f"the {role.replace('given_', '')} is the name of a column, a str, not {type(name).__name__}")
    if friction is not None and friction_angle is not None:
        raise CoupletError("friction and friction_angle are both named: choose one")
    question = _Question(roles, weight, quantities, (prefix, suffix), whole(threads))
    return question.answered(data)  # type: ignore[no-any-return]


class _Question:
    """What is asked of each row of a table."""

    def __init__(self, roles: dict[str, str], weight: str, quantities: Any, around: tuple[str, str], threads: int) -> None:
        is_column = weight not in _WEIGHTS
        self.roles = {**roles, "weight": weight} if is_column else roles
        self.weight = _WEIGHTS[-1] if is_column else weight
        self.around, self.threads = around, threads
        self.has_thickness = "given_thickness" in roles
        names = asked_for(quantities, self.has_thickness)
        self.quantities = list(dict.fromkeys(asked(_core.quantity, name) for name in names))

    def answered(self, data: Any) -> Any:
        """The table with its answers."""
        polars, pyarrow = map(sys.modules.get, ("polars", "pyarrow"))
        if polars is not None and isinstance(data, polars.LazyFrame):
            # Nothing may be pushed below that asks for what is not there yet.
            schema = self.answered(polars.DataFrame(schema=data.collect_schema())).schema
            return data.map_batches(
                self.answered, predicate_pushdown=False, projection_pushdown=False, slice_pushdown=True, schema=schema, streamable=True
            )
        if pyarrow is not None and isinstance(data, pyarrow.RecordBatchReader):
            return type(data).from_batches(self.answered(data.schema.empty_table()).schema, map(self.answered, data))
        name = type(data).__name__
        for method in _MAPS:
            if hasattr(data, method):
                raise TypeError(f'a {name} is asked to map its batches: data.{method}(…) as in docs/python.md, "Engines"')
        kind = kind_of(data)
        if kind is None:
            raise TypeError(f"a table is a frame of pandas or polars, one of Arrow or a dictionary of arrays, not {name}")
        return self._with_states(kind)

    def _with_states(self, kind: Columns) -> Any:
        np = need_numpy()
        texts = [name for name in kind.names if isinstance(name, str) and is_text(name)]
        for why in filter(None, map(_core.unanswered, texts)):
            raise CoupletError(spoken(f"{why}; under another name the column is handed on"))
        columns, refused = self._read(np, kind)
        names = ["verdict", *([] if self.has_thickness else ["mode"])]
        names += [name + end for name in self.quantities for end in ("", "_side")]
        names = [name.join(self.around) for name in (*names, "reason")]
        taken = next((name for name in names if name in kind.names), None)
        if taken is not None:
            raise CoupletError(f"the table has a column '{taken}'; with prefix='…' or suffix='…' the new ones have other names")
        # What is wrong with a name is said though there is no row.
        asked(_core.table, self.weight, list(columns), [b""] * len(columns), self.quantities, 1)
        answers = _Answers(np, kind.size, len(self.quantities))
        for rows, why in refused:
            answers.refuse(rows, why)
        places = (answers.why == NO_WORD).nonzero()[0] if refused else kind.size
        for here, told in in_tables(np, places, (self.weight, columns, self.quantities, self.threads)):
            answers.put(here, told)
        return kind.with_columns(dict(zip(names, answers.columns(kind, not self.has_thickness))))

    def _read(self, np: Any, kind: Columns) -> tuple[dict[str, Any], list[tuple[Any, str]]]:
        """The columns by what the command calls them; and the rows that are refused, for a cell that is empty or no text, with reasons."""
        columns, empty = {}, []
        no_texts: dict[int, str] = {}
        for role, text in self.roles.items():
            name, unit = _column(kind.names, text)
            column, present = kind.cells(name)
            if len(column) != kind.size:
                raise CoupletError(f"the column '{name}' has {len(column)} rows, where others have {kind.size}")
            if isinstance(column, list) and not is_text("\n".join(column)):
                for row in [row for row, text in enumerate(column) if not is_text(text)]:
                    no_texts.setdefault(row, no_text(column[row]))
                    column[row] = ""
            columns[f"{name}={role}{unit}"] = column
            # A weight that is not there is the usual one.
            if present is not None and role != "weight":
                empty.append(((~present).nonzero()[0], f"the {role.replace('given_', '')} is empty"))
        return columns, [*((np.array([row]), why) for row, why in no_texts.items()), *empty]


class _Answers:
    """What is known of each row: codes of words, numbers with their sides, and reasons; refused at first."""

    def __init__(self, np: Any, size: int, quantities: int) -> None:
        self.np, self.size = np, size
        self.verdicts = np.full(size, VERDICTS.index("refused"), np.int8)
        self.modes = np.full(size, NO_WORD, np.int8)
        self.values = [(np.full(size, np.nan), np.full(size, NO_SIDE, np.int8)) for _ in range(quantities)]
        self.why = np.full(size, NO_WORD, np.int32)
        self.reasons: dict[str, int] = {}

    def refuse(self, rows: Any, why: str) -> None:
        """Says why rows are refused, unless it is known."""
        self.why[rows[self.why[rows] == NO_WORD]] = self.reasons.setdefault(why, len(self.reasons))

    def put(self, here: Any, told: Any) -> None:
        """Puts down what is told of some rows."""
        array, where = self.np.frombuffer, self.np.where
        verdicts, modes, values, reasons = told
        self.verdicts[here], self.modes[here] = array(verdicts, "i1"), array(modes, "i1")
        for (numbers, sides), bounds in zip(self.values, values):
            doubles, lower, upper = (array(bound, "f8") for bound in bounds)
            numbers[here] = doubles
            sides[here] = where(lower >= doubles, where(upper <= doubles, 0, 1), where(upper <= doubles, -1, NO_SIDE))
        rows = range(self.size)[here] if isinstance(here, slice) else here
        for row, why in reasons:
            self.why[rows[row]] = self.reasons.setdefault(spoken(why), len(self.reasons))

    def columns(self, kind: Columns, have_modes: bool) -> Iterator[Any]:
        """The columns, as a kind of tables has them."""
        yield kind.column(self.verdicts, NO_WORD, VERDICTS)
        if have_modes:
            yield kind.column(self.modes, NO_WORD, _core.modes())
        for numbers, sides in self.values:
            yield kind.column(numbers)
            yield kind.column(sides, NO_SIDE)
        yield kind.column(self.why, NO_WORD, list(self.reasons), are_few=False)


def _column(names: Sequence[Any], text: str) -> tuple[str, str]:
    """The column that a text names, and the unit behind it with its colon; what is a name of the table is one."""
    column, colon, unit = text.rpartition(":")
    if text in names:
        column, unit = text, ""
    elif colon and column in names:
        unit = colon + unit
    else:
        shown = ", ".join(f"'{name}'" for name in list(names)[:20]) + (f" and {len(names) - 20} more" if len(names) > 20 else "")
        raise CoupletError(f"the table has no column '{column if unit in _UNITS else text}'; its columns are {shown or 'none'}")
    if list(names).count(column) > 1:
        raise CoupletError(f"the table has two columns '{column}'")
    return column, unit
