"""What the command makes, as Python has it: pictures, curves, judged results, samples, audits, scenes."""

from __future__ import annotations

import os

from ._arrays import VERDICTS
from ._asked import FIELDS, of_json, ranged, spoken, texts_of, words
from ._command import answer, options
from ._command import run as _run
from ._core import CoupletError, modes
from ._exact import listed, of_numpy
from ._named import Drawn, Paper, Values, named
from ._sweeps import _Toml

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ._types import Any, Exact, Iterator, Landmark, LandmarkName, Literal, Mapping, Range, Sequence, Union, Unpack, np

    Several = Union[Exact, Sequence[Exact], None]


class Picture:
    """A picture, which a notebook shows. ``str()`` and the attribute ``svg`` are its SVG."""

    __slots__ = ("svg", "_words", "_threads")

    def __init__(self, words: list[str], threads: int = 0) -> None:
        self._words, self._threads = words, threads
        self.svg = answer([*words, "--format=svg"], threads).decode()

    def __str__(self) -> str:
        return self.svg

    _repr_svg_ = __str__

    def __repr__(self) -> str:
        return f"Picture({' '.join(self._words)!r}, {len(self.svg)} characters of SVG)"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes it anew in the format that the end of the name tells, among those of the command: svg, png, pdf; of an arch json
        and dxf too, of a map html, json, csv and parquet. The file appears whole or not at all."""
        answer([*self._words, f"--output={os.fspath(path)}"], self._threads)

    def to_dict(self) -> Any:
        """What it shows, as data (the command's JSON), where there is such."""
        return of_json(answer([*self._words, "--format=json"], self._threads))


@named(Drawn)
def draw(
    half_opening: Range | None = None, friction: Range | None = None, *, along: tuple[str, str] | None = None, **drawn: Unpack[Drawn]
) -> Picture:
    """An arch at its least thickness and how it falls there, or with a thickness as it stands; or those of a landmark; an
    UndecidedError if there is nothing to draw, or nothing is proved.

    Args:
        half_opening and others: as for ``state``, but for joints; with thickness as for ``assess``, with ranges too: then the bands in
            which the lines of thrust of all arches inside lie. Of stones there are 2 to 500.
        tilt: with a thickness, the arch at the largest tilt that it bears.
        at: a landmark instead of an arch, by symbol or name.
        mode: only this mode, where several are possible.
        along: the modes that a half opening passes as its friction grows: ('friction', '0.2..3').
        amplitude: how far the corner that moves most is moved, in units of r, from 0.001 to 1; 0.12 if it is not given.
        dilatant: joints that slide open too.
        half: only the right half. arrows: from where the blocks were. animate: the blocks move.
        width, font_size: on paper ('84mm', '3.3in'; '7pt'); as wide as the picture needs if it is not given.
        font: the family of letters, of PNG and PDF one of this machine; DejaVu Sans if it is not given.
        full_caption: all the words below; no_caption, no_title: without them, and without the headings above.
        threads: threads to compute with; 0 for one on each core.
    """
    texts, _ = texts_of(ranged({"half_opening": half_opening, "friction": friction, **drawn}))
    line = ["draw", *(["--along", *words(along)] if along else [])]
    return _picture(line, {**texts, **{name: value for name, value in drawn.items() if name not in FIELDS}})


def _picture(line: list[str], named: dict[str, Any]) -> Picture:
    """A picture of the command, with options."""
    threads = named.pop("threads")
    return Picture([*line, *options(named)], threads)


@named(Paper)
def figure(number: int, *, weight: str | None = None, tolerance: float | str | None = None, **paper: Unpack[Paper]) -> Picture:
    """A figure of the paper, 1 to 12, drawn from proved curves and states; an UndecidedError if one is not proved.

    Args:
        weight: the model of self-weight, 'heyman' or 'milankovitch'; of the figures 2 to 5 both if none is named.
        tolerance: of the figures 2 to 6, the largest half-width of a tube, from 1e-12 to 1; 1e-4 if it is not given.
        width, font_size, font, full_caption, no_caption, no_title, threads: as for ``draw``.
    """
    return _picture(["figure", str(number)], {"weight": weight, "tolerance": tolerance, **paper})


class _Lines(Paper, total=False):
    """What a map shows, and how."""

    half_opening: Several
    thickness: Several
    friction: Several
    plane: Literal["thickness-friction", "opening-friction", "opening-thickness"] | None
    lines: bool
    asymmetric: bool
    bare: bool
    half_opening_unit: Literal["deg", "rad", "A"] | None
    friction_unit: Literal["deg", "rad", "mu"] | None
    scale: Literal["linear", "log"] | None
    half_opening_range: str | None
    friction_range: str | None
    thickness_range: str | None


@named(_Lines)
def map(
    curve: str | Sequence[str] | None = None,
    *,
    weight: str | None = None,
    tolerance: float | str | None = None,
    mark: str | Sequence[str] = (),
    difference: bool = False,
    **shown: Unpack[_Lines],
) -> Picture:
    """The map of the modes, from curves that are proved for every value of their parameter; an UndecidedError if one is not.

    Args:
        curve: only these curves (see ``curve``); all if none is named.
        half_opening, thickness, friction: the lines of these values, one or several.
        weight: 'heyman', 'milankovitch' or, of lines, 'both'.
        tolerance: the largest half-width of a tube, from 1e-12 to 1; 1e-4 if it is not given.
        plane: 'thickness-friction' (usual), 'opening-friction' or 'opening-thickness'.
        lines: only the lines. asymmetric: what asymmetric branches reach. bare: without lines of equal values.
        mark: arches to mark ('80deg,0.6,0.15').
        difference: instead, by how much the one weight is above the other on each dividing curve.
        half_opening_unit, friction_unit, scale: 'deg', 'rad' or 'A'; 'deg', 'rad' or 'mu'; 'linear' or 'log'.
        half_opening_range, friction_range, thickness_range: what is shown ('120..160').
        width, font_size, font, full_caption, no_caption, no_title, threads: as for ``draw``.
    """
    line = ["map", *(["difference"] if difference else []), *(f"--mark={arch}" for arch in words(mark))]
    return _picture(line, {"curve": curve, "weight": weight, "tolerance": tolerance, **shown})


def _told(line: list[str], named: dict[str, Any], threads: int = 0) -> Any:
    """What the command says in JSON."""
    return of_json(answer([*line, *options(named), "--format=json"], threads))


class Curve:
    """A curve of the map: arrays over its nodes, with bounds that are proved. Between two nodes there is, for each value of the
    parameter, exactly one solution, in a tube about the cubic through them.

    Attributes:
        name, weight: the curve and the model of self-weight.
        parameter: the name of its parameter.
        ends: the landmarks from which and to which it goes.
        gaps: where nothing is proved.
        widest_tube: the largest half-width.
        columns: a dictionary of arrays, which pandas, polars and pyarrow take: ``parameter``, of each coordinate NAME_lower and
            NAME_upper (``half_opening``, ``friction``, ``friction_angle``, ``thickness``, ``thrust``, ``rotation_joint``, ``sliding_joint``;
            not a number where there is none), value and slope of the cubic NAME_node and NAME_rate, ``tube`` and ``proved`` of its piece.
    """

    __slots__ = ("name", "weight", "parameter", "ends", "gaps", "widest_tube", "columns")

    def __init__(self, told: dict[str, Any]) -> None:
        import numpy as np

        self.name, self.weight, self.parameter = told["curve"], told["weight"], told["parameter"]
        self.ends, self.gaps, self.widest_tube = (told["from"], told["to"]), told["gaps"], told["widest_tube"]
        nodes = told["nodes"]
        names = [name for name in nodes[0] if name not in ("end", "proved")]
        # None is not a number.
        self.columns: dict[str, np.ndarray[Any, Any]] = {name: np.array([node[name] for node in nodes], float) for name in names}
        self.columns["proved"] = np.array([bool(node["proved"]) for node in nodes])

    def __getitem__(self, name: str) -> np.ndarray[Any, Any]:
        return self.columns[name]

    def __len__(self) -> int:
        return len(self.columns["parameter"])

    def __repr__(self) -> str:
        return f"Curve({self.name!r}, weight={self.weight!r}, {self.ends[0]} to {self.ends[1]}, {len(self)} nodes)"

    def to_dict(self) -> dict[str, Any]:
        """All of it, for ``json.dumps``; what is not a number is None."""
        columns = {name: [None if x != x else x for x in array.tolist()] for name, array in self.columns.items()}
        return {**{name: getattr(self, name) for name in self.__slots__}, "ends": list(self.ends), "columns": columns}


def curve(name: str, *, weight: str = "milankovitch", tolerance: float | str = "1e-4", threads: int = 0) -> Curve:
    """A curve of the map as arrays with bounds (needs NumPy); an UndecidedError if it is not proved.

    Args:
        name: 'rotation', 'overturning', 'sliding'; two modes that meet ('rrr/srr'); 'limit', where the thickness reaches 2.
        weight: the model of self-weight, 'heyman' or 'milankovitch'.
        tolerance: the largest half-width of a tube, from 1e-12 to 1.
        threads: threads to compute with; 0 for one on each core.
    """
    curves = _told(["map"], {"curve": name, "weight": weight, "tolerance": tolerance}, threads)["curves"]
    if len(curves) != 1:
        raise CoupletError("one curve at a time, of one weight")
    return Curve(curves[0])


class Judged:
    """Somebody's results, judged: a sequence, ``rows``, with a dictionary for each row, as in docs/columns.md: ``verdict``, ``accepted``,
    ``reason``, ``numbers`` with errors and digits of each number, …"""

    __slots__ = ("rows",)

    def __init__(self, rows: list[dict[str, Any]]) -> None:
        self.rows = rows

    @property
    def accepted(self) -> int:
        """How many rows are accepted."""
        return sum(row["accepted"] for row in self.rows)

    @property
    def verdicts(self) -> dict[str, int]:
        """How many rows have which verdict, the most first."""
        from collections import Counter

        return dict(Counter(row["verdict"] for row in self.rows).most_common())

    def __len__(self) -> int:
        return len(self.rows)

    def __getitem__(self, row: int) -> dict[str, Any]:
        return self.rows[row]

    def __iter__(self) -> Iterator[dict[str, Any]]:
        return iter(self.rows)

    def __repr__(self) -> str:
        return f"Judged({len(self)} rows, {self.accepted} accepted: {self.verdicts})"

    def to_dict(self) -> dict[str, Any]:
        """All of it, for ``json.dumps``."""
        return {"rows": self.rows, "accepted": self.accepted, "verdicts": self.verdicts}


def judge(
    rows: Any,
    *,
    columns: Any = None,
    keep: str | Sequence[str] | None = None,
    weight: str | None = None,
    inputs: str | None = None,
    accept: int | None = None,
    threads: int = 0,
) -> Judged:
    """Judges somebody else's results, each row against the certified state of its arch, in a process of its own, which an interrupt ends.

    Args:
        rows: a frame of pandas or polars, a table of Arrow, a dictionary of columns, a list of dictionaries, or the path of a file.
            The columns are ``half_opening`` and ``friction``, perhaps ``weight``, and what is claimed: ``thickness``, ``mode``,
            ``can_stand``, ``thrust``, …; with ``given_thickness`` also ``stands``, ``geometric_safety``, …; codes as of ``states`` too.
        columns: other names, {"alpha_deg": "half_opening:deg", "t": "thickness"}, or ["t=thickness"]; then only these are read.
        keep: columns that are handed on to each row, or 'all' that are not read.
        weight: the model of self-weight of rows that have none; 'milankovitch' if it is not given.
        inputs: half openings and frictions are 'exact', what is written (usual of a file), or 'double', the double next to it (of a frame).
        accept: correct digits that every number of an accepted row must have.
        threads: threads to compute with; 0 for one on each core.

    Raises: CoupletError if there are no rows, or columns are missing; a row that makes no sense is a row, with its ``reason``.
    """
    is_file, are_pairs = isinstance(rows, (str, os.PathLike)), hasattr(columns, "items")
    data = b"" if is_file else _table(rows, columns if are_pairs else {})
    pairs = [f"{theirs}={ours}" for theirs, ours in columns.items()] if are_pairs else columns
    named = {"columns": pairs, "keep": keep, "weight": weight, "accept": accept, "threads": threads or None}
    named["inputs"] = inputs or ("exact" if is_file else "double")
    done = _run(["judge", *options(named), "--format=jsonl", "--", os.path.abspath(rows) if is_file else "-"], data)
    if done.code and not done.output:
        raise done.failure()
    return Judged([of_json(line) for line in done.output.splitlines()])


def _table(rows: Any, columns: Mapping[str, str]) -> bytes:
    """Rows as CSV, with every digit of their doubles."""
    import csv
    import io

    table = _columns(rows)
    lengths = {len(column) for column in table.values()}
    if len(lengths) > 1:
        raise CoupletError(f"the columns do not fit each other: they have {', '.join(str(n) for n in sorted(lengths))} rows")
    for name, column in table.items():
        if columns.get(name, name).lower() == "mode":
            table[name] = [_word(mode, modes()) for mode in column]
    if not columns and "verdict" in table and not {"stands", "can_stand"} & {*table}:
        # What ``states`` says.
        words = [_word(verdict, list(VERDICTS)) for verdict in table["verdict"]]
        name = "stands" if "given_thickness" in table else "can_stand"
        table[name] = [{"stands": "true", "falls": "false"}.get(word, "") for word in words]
    text = io.StringIO()
    write = csv.writer(text)
    write.writerow(table)
    write.writerows(zip(*table.values()))
    # What is no text is a bad row, as the command has it.
    return text.getvalue().encode(errors="surrogatepass")


def _columns(rows: Any) -> dict[str, list[Any]]:
    if isinstance(rows, (list, tuple)) and all(hasattr(row, "get") for row in rows):
        keys = dict.fromkeys(name for row in rows for name in row)
        return {str(name): [_cell(row.get(name)) for row in rows] for name in keys}
    # Of Arrow; of pandas and polars; of NumPy.
    names: Any = getattr(rows, "column_names", getattr(rows, "columns", None))
    names = getattr(getattr(rows, "dtype", None), "names", names)
    if names is None and not hasattr(rows, "keys"):
        raise TypeError("rows are a frame, a dictionary of columns, a list of dictionaries or the path of a file")
    names = rows.keys() if names is None else names
    return {str(name): [_cell(value) for value in listed(rows[name])] for name in names}


def _cell(value: Any) -> Any:
    """A cell: doubles with all their digits; no other number loses any."""
    value = of_numpy(value)
    return repr(value) if type(value) is float else "" if value is None else value


def _word(code: Any, words: list[str]) -> Any:
    """A word, of which the code may be given; of one that a frame lacks nothing is claimed."""
    if not isinstance(code, int):
        return "" if code == "nan" else code
    return words[code] if 0 <= code < len(words) else ""


def sample(count: int = 100, *, hard: bool = False, assemblies: bool = False, seed: int = 1) -> list[dict[str, Any]]:
    """Arches to test a solver with, the same for the same seed: ordinary ones, or hard ones: next to landmarks, tiny, next to half a
    turn, with frictions like 0, 1e80 and inf. ``couplet.hypothesis`` has strategies of them.

    Returns: a dictionary for each: exact texts ``weight``, ``half_opening``, ``friction``; their doubles ``half_opening_rad``,
    ``friction_double``, ``math.inf`` where it is unlimited; ``family``, the kind. Of ``assemblies`` stones next to a threshold
    instead, two for each of the count, as in docs/assemblies.md.

        >>> arch = couplet.sample(1)[0]
        >>> couplet.state(arch["half_opening"], arch["friction"], weight=arch["weight"], digits=6).verdict
        'stands'
    """
    named = {"count": count, "hard": hard, "assemblies": assemblies, "seed": seed}
    if assemblies:
        return _told(["sample"], named)  # type: ignore[no-any-return]
    arches = [of_json(line) for line in answer(["sample", *options(named), "--format=jsonl"]).splitlines()]
    return [{**arch, "friction_double": float("inf")} if arch["friction_double"] is None else arch for arch in arches]


def audit(*, only: Landmark | LandmarkName | Sequence[Landmark | LandmarkName] | None = None, weight: str = "both") -> dict[str, Any]:
    """Every number the paper prints, and its claims on the weights, against certified values; an UndecidedError if one is not proved.

    Args:
        only: the numbers of these landmarks alone.
        weight: 'heyman', 'milankovitch' or 'both'.

    Returns: a dictionary (``couplet.audit/2``) with ``printed``, a list of numbers with their verdicts, and ``comparisons``.

        >>> [number["verdict"] for number in couplet.audit(only="T", weight="heyman")["printed"]][:3]
        ['wrong', 'faithful', 'correctly rounded']
    """
    return _told(["audit"], {"only": only, "weight": weight})  # type: ignore[no-any-return]


@named(Values)
def equation(number: int, *, half_opening: Exact | None = None, **values: Unpack[Values]) -> dict[str, Any]:
    """An equation of the paper, (2) to (18), at given values: ``couplet.equation/1``; an UndecidedError if something is not proved.

    Args:
        number: of the equation; (7) to (12) are at a rotational joint.
        half_opening, rotation_joint: angles, in radians or text with a unit ('57deg').
        thickness, thrust, opening_variable: eta, h and A = alpha cot(alpha/2), where the equation has them.
        weight: the model of self-weight, 'heyman' or 'milankovitch'.
        digits: significant digits, 1 to 1,000,000.

        >>> couplet.equation(12, rotation_joint="1.2", digits=5)["radicand"]["value"]
        '5.2334'
    """
    return _told(["equation", str(number)], {"half_opening": half_opening, **values})  # type: ignore[no-any-return]


@named(Values)
def states_of(friction: Exact | None = None, **values: Unpack[Values]) -> dict[str, Any]:
    """All states with one value, on both branches of (9) to (11): ``couplet.states_of/1``; an UndecidedError if one is not proved.

    Args:
        friction: as for ``state``; unlimited if it is not given.
        rotation_joint, thrust, thickness, opening_variable: one of them.

        >>> [state["half_opening"]["value"] for state in couplet.states_of(rotation_joint=1, digits=5)["states"]]
        ['1.6921', '2.4677']
    """
    return _told(["state"], {"friction": friction, **values})  # type: ignore[no-any-return]


class Ran:
    """What a scene has made: ``outputs``, paths of files written or kept, in its ``folder``; ``text``, what has no file; ``undecided``, what
    was not proved, or None."""

    __slots__ = ("folder", "outputs", "text", "undecided")

    def __init__(self, folder: str, outputs: list[str], text: str, undecided: str | None) -> None:
        self.folder, self.outputs, self.text, self.undecided = folder, outputs, text, undecided

    def __repr__(self) -> str:
        return f"Ran({self.folder!r}, outputs={self.outputs!r}, undecided={self.undecided!r})"

    def to_dict(self) -> dict[str, Any]:
        """All of it, for ``json.dumps``."""
        return {name: getattr(self, name) for name in self.__slots__}


def run(
    scene: str | os.PathLike[str] | Mapping[str, Any], output: str | os.PathLike[str] = "", *, resume: bool = False, overwrite: bool = False
) -> Ran:
    """Computes and writes what a scene asks for (``couplet run --schema`` shows every key), in a process that an interrupt ends.

    Args:
        scene: the path of a scene (TOML), or its keys as a dictionary, of which a float is the double that it is.
        output: the folder of its outputs, made if need be; the working folder if it is not given.
        resume: keep an output that is there if what is asked has not changed. overwrite: replace files that no run wrote.

    Raises: CoupletError with all faults of a scene, of a dictionary with their keys; OSError if something cannot be read or written.

        >>> couplet.run({"arches": [{"half_opening": "80deg", "friction": "0.6", "quantities": "thickness", "digits": 5}]}).text.split()[-1]
        '0.068650'
    """
    if isinstance(scene, (str, os.PathLike)):
        path, toml = os.path.abspath(scene), _Toml({})
    else:
        path, toml = "-", _Toml({"schema": "couplet.scene/1", **scene})
    folder = os.path.abspath(output)
    named = options({"resume": resume, "overwrite": overwrite})
    done = _run(["run", *named, f"--output={folder}", "--", path], toml.text.encode())
    if done.code > 1 or done.code < 0:
        faults = "\n".join(spoken(toml.named(line, "standard input:{}:{}: ")) for line in done.lines)
        raise CoupletError(faults) if done.code == 2 and faults else done.failure()
    outputs = [line.split(None, 1)[1] for line in done.lines if line.startswith(("written ", "kept "))]
    return Ran(folder, outputs, done.output.decode(), done.sentence or None)
