"""What is answered to one question."""

from __future__ import annotations

from . import _core
from ._asked import named_arch
from ._certified import Certified
from ._exact import exact

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any, NoReturn


def plain(value: Any) -> Any:
    """A value as ``json.dumps`` takes it: numbers that JSON has not are their exact texts."""
    if value is None or isinstance(value, (bool, str)):
        return value
    if hasattr(value, "to_dict"):
        return value.to_dict()
    if isinstance(value, dict):
        return {name: plain(inner) for name, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(inner) for inner in value]
    if isinstance(value, range):
        return list(value)
    if type(value) is int or type(value) is float and abs(value) < float("inf"):
        return value
    return exact(value, "number")


class Answer:
    """An answer. It has three verdicts, and so no truth value: look at ``verdict``. ``==`` says whether two are one record: the
    same question with the same answer, to the same digits.

    Attributes:
        verdict: what is proved, or ``'undecided'``: neither it nor its contrary is known.
        reason: why an arch falls, or why something is undecided; else None.
        given: what was asked, as it was given.
        values: the proved values, by the name of their quantity.
    """

    __slots__ = ("_given", "_told")

    def __init__(self, given: tuple[tuple[str, Any], ...], told: dict[str, Any]) -> None:
        self._given, self._told = given, told

    @property
    def given(self) -> dict[str, Any]:
        """What was asked, as it was given."""
        return {name: value for name, value in self._given if value is not None}

    @property
    def verdict(self) -> str:
        """What is proved, or ``'undecided'``."""
        return str(self._told["status"])

    @property
    def reason(self) -> str | None:
        """Why an arch falls, or why something is undecided."""
        return self._told["reason"]  # type: ignore[no-any-return]

    @property
    def values(self) -> dict[str, Certified]:
        """The proved values, by the name of their quantity."""
        return {name: Certified(name, told) for name, told in self._told["values"].items()}

    def to_dict(self) -> dict[str, Any]:
        """All of the answer, for ``json.dumps``: values with their digits, doubles, bounds and units."""
        names = ("verdict", "reason", *self._more)
        said = {name: plain(getattr(self, name)) for name in names}
        return {"given": plain(self.given), **said, "values": plain(self._all())}

    # What a class tells besides, by the names of its properties.
    _more: tuple[str, ...] = ()

    def _all(self) -> Any:
        return self.values

    def _value(self, name: str) -> Certified | None:
        told = self._told["values"].get(name)
        return None if told is None else Certified(name, told)

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
        return []

    def __repr__(self) -> str:
        texts = [(name, str(value) if isinstance(value, Certified) else value) for name, value in self._said()]
        said = [(name, value) for name, value in texts if value is not None]
        inside = [*self.given.items(), ("verdict", self.verdict), *said]
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in inside)})"


class _OfArch(Answer):
    """About an arch, which can be drawn."""

    __slots__ = ()

    @property
    def weight(self) -> str:
        """The model of self-weight, ``'heyman'`` or ``'milankovitch'``."""
        return str(self._told["weight"])

    @property
    def measured_at(self) -> str | None:
        """The circle at which the arch is measured, ``'intrados'``, ``'centreline'`` or ``'extrados'``; None if it has no size."""
        return self._told.get("measured_at")

    @property
    def span_m(self) -> Certified | None:
        """The span in metres, of an arch that is measured."""
        return self._value("span_m")

    @property
    def rise_m(self) -> Certified | None:
        """The rise in metres, of an arch that is measured."""
        return self._value("rise_m")

    @property
    def radius_m(self) -> Certified | None:
        """The radius of the centreline in metres, of an arch that is measured."""
        return self._value("radius_m")

    @property
    def least_thickness_m(self) -> Certified | None:
        """The least thickness in metres, of an arch that is measured."""
        return self._value("least_thickness_m")

    @property
    def weight_kn(self) -> Certified | None:
        """The weight of the arch in kN, where ``density`` and ``depth`` are given."""
        return self._value("weight_kn")

    @property
    def asymmetric_thickness(self) -> Certified | None:
        """The largest thickness above the least at which an asymmetric mechanism is found and proved: there the arch stands, as an
        admissible symmetric state exists, and friction without dilatancy may let it move. None if none is found; that there is
        none is not proved."""
        return self._value("asymmetric_thickness")

    @property
    def open(self) -> dict[str, str]:
        """The quantities that could not be decided, and why."""
        return dict(self._told["open"])

    @property
    def can_stand(self) -> bool | None:
        """Whether the arch stands at some thickness; None if that is not asked or undecided."""
        return self._told["can_stand"]  # type: ignore[no-any-return]

    def svg(self) -> str | None:
        """A picture of the arch with its lines of thrust, and how it falls, as SVG; None where there is nothing to
        draw. It is proved anew for this."""
        given = {name: value for name, value in self._given if name not in ("weight", "tilt")}
        try:
            return _core.drawing(self.weight, named_arch(given)[0], self._command())
        except _core.CoupletError:
            # Joints that are no stones of one angle, more than 500 stones.
            return None

    def _command(self) -> str:
        texts = [(name, plain(value)) for name, value in self._given if value is not None]
        return "couplet draw " + " ".join(f"--{name.replace('_', '-')} {text}" for name, text in texts)

    def _repr_svg_(self) -> str | None:
        return self.svg()


class State(_OfArch):
    """An arch at its least thickness. ``verdict`` is ``'stands'``, ``'falls'`` or ``'undecided'``.

    Lengths are in units of the radius r of the centreline, forces in units of w r, angles in radians from the crown. A value
    that there is not is None.
    """

    __slots__ = ()
    _more: tuple[str, ...] = ("weight", "can_stand", "mode", "open", "enough", "between", "gap", "measured_at")

    @property
    def thrust_kn(self) -> Certified | None:
        """The horizontal thrust in kN, where ``density`` and ``depth`` are given."""
        return self._value("thrust_kn")

    @property
    def verdict(self) -> str:
        """``'stands'``: at some thickness an admissible symmetric state exists; ``'falls'``: at none; ``'undecided'``."""
        stands = self._told["can_stand"]
        return "undecided" if stands is None else "stands" if stands else "falls"

    @property
    def mode(self) -> str | None:
        """How it collapses, joints from the shoulder inward: ``'[r,r,s]'``; one of ``couplet.MODES``."""
        return next(iter(self._told["modes"]), None)

    @property
    def thickness(self) -> Certified | None:
        """The least thickness, t/r, in (0, 2]."""
        return self._value("thickness")

    @property
    def thrust(self) -> Certified | None:
        """The horizontal thrust, H/(w r)."""
        return self._value("thrust")

    @property
    def intrinsic_thrust(self) -> Certified | None:
        """Thickness times thrust, H/(gamma d r²)."""
        return self._value("intrinsic_thrust")

    @property
    def rotation_joint(self) -> Certified | None:
        """The inner joint that opens, rad from the crown."""
        return self._value("rotation_joint")

    @property
    def sliding_joint(self) -> Certified | None:
        """The inner joint that slides, rad from the crown; None if none does."""
        return self._value("sliding_joint")

    @property
    def sliding_friction(self) -> Certified | None:
        """The friction below which the half opening stands at no thickness."""
        return self._value("sliding_friction")

    @property
    def rotational_friction(self) -> Certified | None:
        """The friction from which collapse is purely rotational; infinite where none is enough."""
        return self._value("rotational_friction")

    @property
    def enough(self) -> dict[str, Certified]:
        """What would be enough for an arch that falls: the least ``friction`` at its half opening, the widest
        ``half_opening`` at its friction, as far as there are such."""
        told = self._told["enough"].items()
        return {name: Certified(name, value) for name, value in told if value is not None}

    @property
    def between(self) -> tuple[str, ...]:
        """The modes between which an undecided arch lies."""
        return tuple(self._told["between"])

    @property
    def gap(self) -> float | None:
        """A bound of the difference that could not be told from zero, where it is undecided."""
        return self._told["gap"]  # type: ignore[no-any-return]

    def _said(self) -> list[tuple[str, Any]]:
        moves = self.asymmetric_thickness
        return [("mode", self.mode), ("thickness", self.thickness), ("asymmetric_thickness", moves), ("reason", self.reason)]


class Assessment(_OfArch):
    """An arch of a given thickness. ``verdict`` is ``'stands'``, ``'falls'`` or ``'undecided'``.

    Each value is decided on its own: one that stays open is missing, and ``open`` says why.
    """

    __slots__ = ()
    _more: tuple[str, ...] = ("weight", "open", "measured_at")

    @property
    def thickness_m(self) -> Certified | None:
        """The thickness in metres, of an arch that is measured."""
        return self._value("thickness_m")

    @property
    def least_thrust_kn(self) -> Certified | None:
        """The least admissible thrust in kN, where ``density`` and ``depth`` are given."""
        return self._value("least_thrust_kn")

    @property
    def largest_thrust_kn(self) -> Certified | None:
        """The largest admissible thrust in kN, where ``density`` and ``depth`` are given."""
        return self._value("largest_thrust_kn")

    @property
    def verdict(self) -> str:
        """``'stands'``: with this thickness an admissible symmetric state exists; ``'falls'``; ``'undecided'``."""
        stands = self._told["stands"]
        return "undecided" if stands is None else "stands" if stands else "falls"

    @property
    def least_thickness(self) -> Certified | None:
        """The least thickness of the arch, t/r; None if it stands at none."""
        return self._value("least_thickness")

    @property
    def geometric_safety(self) -> Certified | None:
        """The thickness over the least thickness."""
        return self._value("geometric_safety")

    @property
    def required_friction(self) -> Certified | None:
        """The least friction with which it stands; None if none is enough."""
        return self._value("required_friction")

    @property
    def friction_safety(self) -> Certified | None:
        """The friction over the required one."""
        return self._value("friction_safety")

    @property
    def least_thrust(self) -> Certified | None:
        """The least admissible thrust, H/(w r); ``limited_by`` says what limits it."""
        return self._value("least_thrust")

    @property
    def largest_thrust(self) -> Certified | None:
        """The largest admissible thrust, H/(w r); infinite where it has no bound."""
        return self._value("largest_thrust")

    def _said(self) -> list[tuple[str, Any]]:
        moves = self.asymmetric_thickness
        return [("geometric_safety", self.geometric_safety), ("asymmetric_thickness", moves), ("reason", self.reason)]


class Voussoirs(State):
    """An arch of stones at its least thickness, with joints between them alone; with a thickness also that arch, in
    ``assessment``."""

    __slots__ = ()
    _more: tuple[str, ...] = (*State._more, "stones", "joints", "contacts", "loss", "relative_loss", "may_move", "assessment")

    @property
    def stones(self) -> int | None:
        """How many stones of one angle it has."""
        return self._told["said"].get("stones")  # type: ignore[no-any-return]

    @property
    def joints(self) -> tuple[str, ...] | None:
        """The angles of its joints, where they were given."""
        joints = self._told["said"].get("joints")
        return None if joints is None else tuple(joints)

    @property
    def contacts(self) -> tuple[str, ...]:
        """The conditions that hold with equality, each with the number of its joint from the crown."""
        return tuple(self._told["said"]["contacts"] or ())

    @property
    def continuous_thickness(self) -> Certified | None:
        """The least thickness with a joint at every angle."""
        return self._value("continuous_thickness")

    @property
    def loss(self) -> tuple[str, str] | None:
        """Bounds of how much thinner it may be than with a joint at every angle; None where the digits do not tell it."""
        return self._bounds("loss")

    @property
    def relative_loss(self) -> tuple[str, str] | None:
        """Bounds of the part that this is of the other thickness."""
        return self._bounds("relative_loss")

    @property
    def may_move(self) -> bool:
        """Whether it stands with a limited friction, which does not exclude a motion."""
        return bool(self._told["said"]["may_move"])

    @property
    def assessment(self) -> Assessment | None:
        """The arch at the thickness that was given."""
        told = self._told["assessment"]
        return None if told is None else Assessment(self._given, told)

    def _bounds(self, name: str) -> tuple[str, str] | None:
        said = self._told["said"][name]
        return None if said is None else (said["lower"], said["upper"])

    def _said(self) -> list[tuple[str, Any]]:
        return [("mode", self.mode), ("thickness", self.thickness), ("reason", self.reason)]


class Tilted(Assessment):
    """An arch of a given thickness under a uniform horizontal acceleration, which a tilt of the ground is too. ``verdict`` is
    ``'stands'`` if an admissible state of the whole arch is left, ``'falls'`` or ``'undecided'``."""

    __slots__ = ()
    _more: tuple[str, ...] = ("weight", "limited_by", "may_move")

    @property
    def largest_tilt(self) -> Certified | None:
        """The largest acceleration over that of gravity with which there is an admissible state; infinite if any; None if it
        stands with none, or that is undecided."""
        return self._value("largest_tilt")

    @property
    def limited_by(self) -> tuple[str, ...]:
        """What limits it: the hinges and joints of the mechanism."""
        return tuple(self._told["said"]["limited_by"])

    @property
    def may_move(self) -> bool:
        """Whether it stands with a limited friction, which does not exclude a motion."""
        return bool(self._told["said"]["may_move"])

    def svg(self) -> None:
        """None: a tilted arch is not drawn."""

    def _said(self) -> list[tuple[str, Any]]:
        return [("largest_tilt", self.largest_tilt), ("reason", self.reason)]


class Found(Answer):
    """What was found. ``verdict`` is ``'found'``, ``'nothing'`` if it is proved that there is none, or ``'undecided'``."""

    __slots__ = ()
    _more: tuple[str, ...] = ("modes", "proved", "some_may_move")

    @property
    def verdict(self) -> str:
        """``'found'``, ``'nothing'`` or ``'undecided'``."""
        if self._told["status"] == "undecided":
            return "undecided"
        return "nothing" if self._told["stands"] is False else "found"

    @property
    def value(self) -> Certified | None:
        """What was asked for."""
        return next(iter(self.values.values()), None)

    @property
    def modes(self) -> tuple[str, ...]:
        """How the arch collapses there; both modes on a boundary."""
        return tuple(self._told["modes"])

    @property
    def proved(self) -> str | None:
        """Why there is no other answer."""
        return self._told["proved"]  # type: ignore[no-any-return]

    @property
    def some_may_move(self) -> bool:
        """Whether asymmetric mechanisms are known of some of the arches of which ``proved`` says that they stand: friction
        without dilatancy may let these move."""
        return bool(self._told["some_may_move"])

    def _said(self) -> list[tuple[str, Any]]:
        value = self.value
        return [(value.quantity, value)] if value else [("reason", self.reason or self.proved)]


class Constants(Answer):
    """The constants of a landmark, by the name of their quantity or its letter: a mapping. ``verdict`` is ``'proved'`` or
    ``'undecided'``."""

    __slots__ = ()
    _more: tuple[str, ...] = ("landmark", "weight")

    @property
    def landmark(self) -> str:
        """The symbol of the landmark."""
        return str(self._told["landmark"])

    @property
    def weight(self) -> str:
        """The model of self-weight."""
        return str(self._told["weight"])

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
        return iter(self._told["values"])

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

    @property
    def verdict(self) -> str:
        """``'accepted'``, ``'refused'`` or ``'not checked'``."""
        return str(self._told["verdict"])

    @property
    def digits(self) -> int | None:
        """How many digits each value has that was accepted; None if it has none."""
        return self._told["digits"]  # type: ignore[no-any-return]

    @property
    def summary(self) -> str | None:
        """What is accepted, in the words of ``couplet check``."""
        return self._told["summary"]  # type: ignore[no-any-return]

    @property
    def texts(self) -> dict[str, str]:
        """The values accepted, each the correct rounding of the true one, by the name of their quantity."""
        return dict(self._told["values"])

    @property
    def values(self) -> dict[str, Certified]:
        """Not of a certificate: it has no bounds and no doubles. See ``texts``."""
        raise AttributeError("the values of a certificate are in .texts")

    _more: tuple[str, ...] = ("digits", "summary")

    def _all(self) -> Any:
        return self.texts

    def _said(self) -> list[tuple[str, Any]]:
        return [("digits", self.digits), ("reason", self.reason)]


class Decision:
    """A claim of the paper and what became of it.

    Attributes: ``id``, ``place``, ``statement``; ``verdict`` (``'proved'``, ``'refuted'`` or ``'undecided'``), ``reason``; ``as_printed``
    (``'proved'``, ``'equality'``, ``'measured'``, ``'refuted'``, ``'not stated'``, ``'undecided'``); ``counterexample`` and
    ``corrected`` of a misprint; ``equal``, ``holds_with``, ``fails_with``; ``hypotheses``, ``method``; ``argument``
    (``'own'`` or ``'beneath'``: an argument in words carries it, or a claim that it uses; ``None``: neither); ``derivation`` (its
    steps), ``seconds``, which ``==`` leaves out.
    """

    def __init__(self, told: dict[str, Any]) -> None:
        self.__dict__.update(told)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(name)

    def to_dict(self) -> dict[str, Any]:
        """All of the decision, for ``json.dumps``."""
        return dict(vars(self))

    def _lasting(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name != "seconds"}

    def __eq__(self, other: object) -> bool:
        if type(other) is not Decision:
            return NotImplemented
        return self._lasting() == other._lasting()

    def __hash__(self) -> int:
        return hash((self.id, self.verdict, self.as_printed))

    def __repr__(self) -> str:
        return f"Decision({self.id!r}, verdict={self.verdict!r}, as_printed={self.as_printed!r})"
