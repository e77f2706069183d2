"""What is answered to one question."""

from __future__ import annotations

from . import _core
from ._asked import texts_of
from ._certified import Certified, Told
from ._command import options
from ._exact import exact

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ._types import Any, Iterator, Literal, NoReturn

    Standing = Literal["stands", "falls", "undecided"]


def plain(value: Any) -> Any:
    """A value as ``json.dumps`` takes it: numbers that JSON has not are their exact texts."""
    if value is None or isinstance(value, (bool, str)):
        return value
    if hasattr(value, "to_dict"):
        return value.to_dict()
    if isinstance(value, dict):
        return {name: plain(inner) for name, inner in value.items()}
    if isinstance(value, (list, tuple, range)):
        return [plain(inner) for inner in value]
    if type(value) is int or type(value) is float and abs(value) < float("inf"):
        return value
    return exact(value, "number")


class _Value(Told["Certified | None"]):
    """A value, which is None where there is none."""

    def _of(self, answer: Answer) -> Certified | None:
        told = answer._told["values"].get(self.at)
        return None if told is None else Certified(self.at, told)


def _certified(values: dict[str, Any]) -> dict[str, Certified]:
    return {name: Certified(name, told) for name, told in values.items() if told is not None}


def _standing(stands: bool | None) -> Standing:
    return "undecided" if stands is None else "stands" if stands else "falls"


class Answer:
    """An answer. It has three verdicts, and so no truth value: look at ``verdict``. ``==`` says whether two are one record: the
    same question with the same answer, to the same digits.
    """

    __slots__ = ("_given", "_told")

    def __init__(self, given: tuple[tuple[str, Any], ...], told: dict[str, Any]) -> None:
        self._given, self._told = given, told

    @property
    def given(self) -> dict[str, Any]:
        """What was asked, as it was given."""
        return {name: value for name, value in self._given if value is not None}

    verdict = Told[str]("What is proved, or ``'undecided'``: neither it nor its contrary is known.", at="status")
    reason = Told["str | None"]("Why an arch falls, or why something is undecided; else None.")
    values = Told["dict[str, Certified]"]("The proved values, by the name of their quantity.", _certified)

    def to_dict(self) -> dict[str, Any]:
        """All of the answer, for ``json.dumps``: values with their digits, doubles, bounds and units."""
        names = ("verdict", "reason", *self._more)
        said = {name: plain(getattr(self, name)) for name in names}
        return {"given": plain(self.given), **said, "values": plain(getattr(self, self._valued))}

    # What a class tells besides, what it shows, and which are its values, by the names of its properties.
    _more: tuple[str, ...] = ()
    _shown: tuple[str, ...] = ()
    _valued = "values"

    def __bool__(self) -> NoReturn:
        raise TypeError(f"{type(self).__name__} has three verdicts and no truth value: look at .verdict")

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return (self._given, self._told) == (other._given, other._told)

    def __hash__(self) -> int:
        return hash((type(self), self._given, self.verdict, self.reason))

    def __reduce__(self) -> tuple[type, tuple[tuple[tuple[str, Any], ...], dict[str, Any]]]:
        return type(self), (self._given, self._told)

    def _said(self) -> list[tuple[str, Any]]:
        return [(name, getattr(self, name)) for name in self._shown]

    def __repr__(self) -> str:
        texts = [(name, str(value) if isinstance(value, Certified) else value) for name, value in self._said()]
        said = [(name, value) for name, value in texts if value is not None]
        inside = [*self.given.items(), ("verdict", self.verdict), *said]
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in inside)})"


class _OfArch(Answer):
    """About an arch, which can be drawn."""

    __slots__ = ()

    weight = Told[str]("The model of self-weight, ``'heyman'`` or ``'milankovitch'``.")
    measured_at = Told["str | None"](
        "The circle at which the arch is measured, ``'intrados'``, ``'centreline'`` or ``'extrados'``; None if it has no size."
    )
    span_m = _Value("The span in metres, of an arch that is measured.")
    rise_m = _Value("The rise in metres, of an arch that is measured.")
    radius_m = _Value("The radius of the centreline in metres, of an arch that is measured.")
    least_thickness_m = _Value("The least thickness in metres, of an arch that is measured.")
    weight_kn = _Value("The weight of the arch in kN, where ``density`` and ``depth`` are given.")
    asymmetric_thickness = _Value(
        "The largest thickness above the least at which an asymmetric mechanism is found and proved: there the arch stands, as an "
        "admissible symmetric state exists, and friction without dilatancy may let it move. None if none is found; that there is "
        "none is not proved."
    )
    open = Told["dict[str, str]"]("The quantities that could not be decided, and why.", dict)
    can_stand = Told["bool | None"]("Whether the arch stands at some thickness; None if that is not asked or undecided.")

    def svg(self) -> str | None:
        """A picture of the arch with its lines of thrust, and how it falls, as SVG, proved anew; None where there is nothing to draw."""
        words = ["draw", *options({**texts_of(self.given)[0], "weight": self.weight})]
        code, written, _ = _core.command([*words, "--format=svg"], 1)
        # There is none of joints that are no stones of one angle, and of more than 500 stones.
        return written.decode() if code == 0 else None

    def _repr_svg_(self) -> str | None:
        return self.svg()


class State(_OfArch):
    """An arch at its least thickness. ``verdict`` is ``'stands'``, ``'falls'`` or ``'undecided'``.

    Lengths are in units of the radius r of the centreline, forces of w r, angles in radians from the crown; what there is not is None.
    """

    __slots__ = ()
    _more: tuple[str, ...] = ("weight", "can_stand", "mode", "open", "enough", "between", "gap", "measured_at")
    _shown: tuple[str, ...] = ("mode", "thickness", "asymmetric_thickness", "reason")

    thrust_kn = _Value("The horizontal thrust in kN, where ``density`` and ``depth`` are given.")
    verdict = Told["Standing"](
        "``'stands'``: at some thickness an admissible symmetric state exists; ``'falls'``: at none; ``'undecided'``.",
        _standing, "can_stand",
    )  # fmt: skip
    mode = Told["str | None"](
        "How it collapses, joints from the shoulder inward: ``'[r,r,s]'``; one of ``couplet.MODES``.",
        lambda modes: next(iter(modes), None), "modes",
    )  # fmt: skip
    thickness = _Value("The least thickness, t/r, in (0, 2].")
    thrust = _Value("The horizontal thrust, H/(w r).")
    intrinsic_thrust = _Value("Thickness times thrust, H/(gamma d r²).")
    rotation_joint = _Value("The inner joint that opens, rad from the crown.")
    sliding_joint = _Value("The inner joint that slides, rad from the crown; None if none does.")
    sliding_friction = _Value("The friction below which the half opening stands at no thickness.")
    rotational_friction = _Value("The friction from which collapse is purely rotational; infinite where none is enough.")

    enough = Told["dict[str, Certified]"](
        "What would be enough for an arch that falls: the least ``friction`` at its half opening, the widest ``half_opening`` at its "
        "friction, as far as there are such.",
        _certified,
    )
    between = Told["tuple[str, ...]"]("The modes between which an undecided arch lies.", tuple)
    gap = Told["float | None"]("A bound of the difference that could not be told from zero, where it is undecided.")


class Assessment(_OfArch):
    """An arch of a given thickness. ``verdict`` is ``'stands'``, ``'falls'`` or ``'undecided'``.

    Each value is decided on its own: one that stays open is missing, and ``open`` says why.
    """

    __slots__ = ()
    _more: tuple[str, ...] = ("weight", "open", "measured_at")
    _shown: tuple[str, ...] = ("geometric_safety", "asymmetric_thickness", "reason")

    thickness_m = _Value("The thickness in metres, of an arch that is measured.")
    least_thrust_kn = _Value("The least admissible thrust in kN, where ``density`` and ``depth`` are given.")
    largest_thrust_kn = _Value("The largest admissible thrust in kN, where ``density`` and ``depth`` are given.")
    verdict = Told["Standing"](
        "``'stands'``: with this thickness an admissible symmetric state exists; ``'falls'``; ``'undecided'``.", _standing, "stands"
    )
    least_thickness = _Value("The least thickness of the arch, t/r; None if it stands at none.")
    geometric_safety = _Value("The thickness over the least thickness.")
    required_friction = _Value("The least friction with which it stands; None if none is enough.")
    friction_safety = _Value("The friction over the required one.")
    least_thrust = _Value("The least admissible thrust, H/(w r); ``limited_by`` says what limits it.")
    largest_thrust = _Value("The largest admissible thrust, H/(w r); infinite where it has no bound.")


def _bounds(said: dict[str, str] | None) -> tuple[str, str] | None:
    return None if said is None else (said["lower"], said["upper"])


class Voussoirs(State):
    """An arch of stones at its least thickness, with joints between them alone; with a thickness also that arch, in ``assessment``."""

    __slots__ = ()
    _more: tuple[str, ...] = (*State._more, "stones", "joints", "contacts", "loss", "relative_loss", "may_move", "assessment")
    _shown = ("mode", "thickness", "reason")

    stones = Told["int | None"]("How many stones of one angle it has.")
    joints = Told["tuple[str, ...] | None"]("The angles of its joints, where they were given.", lambda joints: joints and tuple(joints))
    contacts = Told["tuple[str, ...]"](
        "The conditions that hold with equality, each with the number of its joint from the crown.", lambda all_: tuple(all_ or ())
    )
    continuous_thickness = _Value("The least thickness with a joint at every angle.")
    loss = Told["tuple[str, str] | None"](
        "Bounds of how much thinner it may be than with a joint at every angle; None where the digits do not tell it.", _bounds
    )
    relative_loss = Told["tuple[str, str] | None"]("Bounds of the part that this is of the other thickness.", _bounds)
    may_move = Told[bool]("Whether it stands with a limited friction, and a motion above its least thickness is not excluded.", bool)

    @property
    def assessment(self) -> Assessment | None:
        """The arch at the thickness that was given."""
        told = self._told["assessment"]
        return None if told is None else Assessment(self._given, told)


class Tilted(Assessment):
    """An arch of a given thickness under a uniform horizontal acceleration, which a tilt of the ground is too. ``verdict`` is
    ``'stands'`` if an admissible state of the whole arch is left, ``'falls'`` or ``'undecided'``."""

    __slots__ = ()
    _more: tuple[str, ...] = ("weight", "limited_by", "may_move")
    _shown = ("largest_tilt", "reason")

    largest_tilt = _Value(
        "The largest acceleration over that of gravity with which there is an admissible state; infinite if any; None if it "
        "stands with none, or that is undecided."
    )
    largest_tilt_degrees = _Value("The same as the angle of the ground, in degrees.")
    thrust = _Value("The thrust in the crown at the largest acceleration, H/(w r).")
    vertical_force = _Value("The vertical force in the crown then, V/(w r).")
    thrust_kn = _Value("That thrust in kN, where ``density`` and ``depth`` are given.")
    vertical_force_kn = _Value("That vertical force in kN.")
    limited_by = Told["tuple[str, ...]"]("What limits it: the hinges and joints of the mechanism.", tuple)
    may_move = Told[bool]("Whether it stands with a limited friction, which does not exclude a motion.", bool)

    def svg(self) -> str | None:
        """A picture of the arch under the largest acceleration, and how it falls, as SVG. It is proved anew for this."""
        texts = texts_of(self.given)[0]
        words = ["couplet assess", *options({**texts, "weight": self.weight})]
        return _core.tilted(self.weight, texts, "12", " ".join(words))[0]


class Found(Answer):
    """What was found. ``verdict`` is ``'found'``, ``'nothing'`` if it is proved that there is none, or ``'undecided'``."""

    __slots__ = ()
    _more: tuple[str, ...] = ("modes", "proved", "some_may_move")

    verdict = Told["Literal['found', 'nothing', 'undecided']"]("``'found'``, ``'nothing'`` or ``'undecided'``.", at="search")

    @property
    def value(self) -> Certified | None:
        """What was asked for."""
        return next(iter(self.values.values()), None)

    modes = Told["tuple[str, ...]"]("How the arch collapses there; both modes on a boundary.", tuple)
    proved = Told["str | None"]("Why there is no other answer.")
    some_may_move = Told[bool](
        "Whether asymmetric mechanisms are known of some of the arches of which ``proved`` says that they stand: friction without "
        "dilatancy may let these move.",
        bool,
    )

    def _said(self) -> list[tuple[str, Any]]:
        value = self.value
        return [(value.quantity, value)] if value else [("reason", self.reason or self.proved)]


class Constants(Answer):
    """The constants of a landmark: a mapping of names or letters of quantities. ``verdict`` is ``'proved'`` or ``'undecided'``."""

    __slots__ = ()
    _more: tuple[str, ...] = ("landmark", "weight")

    landmark = Told[str]("The symbol of the landmark.")
    weight = Told[str]("The model of self-weight.")

    def __getitem__(self, quantity: str) -> Certified:
        name = self._name(quantity)
        return Certified(name, self._told["values"][name])

    def _name(self, quantity: object) -> Any:
        """The name of a quantity that is there under it or under its letter (``'eta'``)."""
        if quantity not in self._told["values"] and isinstance(quantity, str):
            try:
                return _core.quantity(quantity)
            except ValueError:
                pass
        return quantity

    def keys(self) -> list[str]:
        """The names of the quantities."""
        return list(self._told["values"])

    def items(self) -> list[tuple[str, Certified]]:
        """The names with the values."""
        return list(self.values.items())

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __len__(self) -> int:
        return len(self._told["values"])

    def __contains__(self, quantity: object) -> bool:
        return self._name(quantity) in self._told["values"]

    def _said(self) -> list[tuple[str, Any]]:
        return [("quantities", self.keys())]


class Checked(Answer):
    """What became of a certificate. ``verdict`` is ``'accepted'``, ``'refused'``, or ``'not checked'`` if it has more
    digits than the arithmetic is meant for. That of a survey has no values of its own: ``summary`` tells what it proves."""

    __slots__ = ()

    verdict = Told["Literal['accepted', 'refused', 'not checked']"]("``'accepted'``, ``'refused'`` or ``'not checked'``.")
    digits = Told["int | None"]("How many digits each value has that was accepted; None if it has none.")
    summary = Told["str | None"]("What is accepted, in the words of ``couplet check``.")
    texts = Told["dict[str, str]"](
        "The values accepted, each the correct rounding of the true one, by the name of their quantity.", dict, "values"
    )

    @property
    def values(self) -> NoReturn:  # type: ignore[override]
        """Not of a certificate: it has no bounds and no doubles. See ``texts``."""
        raise AttributeError("the values of a certificate are in .texts")

    _more: tuple[str, ...] = ("digits", "summary")
    _shown = ("digits", "reason")
    _valued = "texts"


class Decision:
    """A claim of the paper and what became of it: ``id``, ``place``, ``statement``; ``verdict`` (``'proved'``, ``'refuted'`` or
    ``'undecided'``), ``reason``; ``as_printed`` (``'proved'``, ``'equality'``, ``'measured'``, ``'refuted'``, ``'not stated'``,
    ``'undecided'``); ``counterexample`` and ``corrected`` of a misprint; ``equal``, ``holds_with``, ``fails_with``; ``hypotheses``,
    ``method``; ``argument`` (``'own'`` or ``'beneath'``: an argument in words carries it, or a claim that it uses; ``None``: neither);
    ``derivation`` (its steps), ``seconds``, which ``==`` leaves out."""

    def __init__(self, told: dict[str, Any]) -> None:
        self.__dict__.update(told)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(name)

    def to_dict(self) -> dict[str, Any]:
        """All of the decision, for ``json.dumps``."""
        return dict(vars(self))

    def __eq__(self, other: object) -> bool:
        if type(other) is not Decision:
            return NotImplemented
        return {**vars(self), "seconds": None} == {**vars(other), "seconds": None}

    def __hash__(self) -> int:
        return hash((self.id, self.verdict, self.as_printed))

    def __repr__(self) -> str:
        return f"Decision({self.id!r}, verdict={self.verdict!r}, as_printed={self.as_printed!r})"


class Survey(dict):  # type: ignore[type-arg]
    """What is proved of every arch between the ends of ranges: the dictionary of ``couplet assess --format json`` (couplet.survey/1)."""

    def __init__(self, told: dict[str, Any]) -> None:
        super().__init__(told)

    def to_dict(self) -> dict[str, Any]:
        """The same as a plain dictionary, for ``json.dumps``."""
        return dict(self)

    @property
    def verdict(self) -> Literal["stands", "falls", "both", "undecided"]:
        """``'stands'`` if all arches do, ``'falls'`` if none does, ``'both'`` if some do and others do not, or ``'undecided'``."""
        kinds: Any = {"all": "stands", "none": "falls", "both": "both"}
        return kinds.get(self["outcome"].partition("_")[0], "undecided")  # type: ignore[no-any-return]

    @property
    def reason(self) -> str | None:
        """Why it is undecided; else None."""
        return self["reason"]  # type: ignore[no-any-return]

    @property
    def measures_alone(self) -> dict[str, tuple[str | None, str | None] | None]:
        """What to measure better: bounds of the geometric safety if one measure alone keeps its tolerance and all others are at
        the middle of theirs, by the measure, the widest first; a bound is None where there is no number, both are where it stays
        open. Empty where fewer than two measures have a tolerance."""
        return {
            of["measure"]: None if of["reason"] is not None else (of["lower"]["value"], of["upper"]["value"])
            for of in self.get("measures_alone", ())
        }
