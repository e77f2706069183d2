"""One arch at a time: its state, with a thickness, of stones, tilted; what is sought; certificates."""

from __future__ import annotations

from . import _core
from ._answers import Assessment, Found, State, Survey, Tilted, Voussoirs
from ._asked import FIELDS, asked, of_json, ranged, texts_of
from ._core import CoupletError
from ._exact import text_of, whole
from ._named import Arches, Beside, Certifiable, named

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import overload

    from ._named import Arch, OfStones, OfThickness, Sizes
    from ._types import Any, Exact, Given, Landmark, LandmarkName, Literal, Range, Sequence, Stones, Unpack
else:

    def overload(function):
        return function


@overload
def state(half_opening: Exact | None, friction: Exact, *, frictions: bool = True, **arch: Unpack[Arch]) -> State: ...
@overload
def state(half_opening: Exact | None = None, *, friction: Exact, frictions: bool = True, **arch: Unpack[Arch]) -> State: ...
@overload
def state(half_opening: Exact | None = None, *, friction_angle: Exact, frictions: bool = True, **arch: Unpack[Arch]) -> State: ...
@overload
def state(half_opening: Range | None, friction: Range, *, frictions: bool = True, **arch: Unpack[Arches]) -> State | Survey: ...
@overload
def state(half_opening: Range | None = None, *, friction: Range, frictions: bool = True, **arch: Unpack[Arches]) -> State | Survey: ...
@overload
def state(
    half_opening: Range | None = None, *, friction_angle: Range, frictions: bool = True, **arch: Unpack[Arches]
) -> State | Survey: ...
@named(Beside, Arches)
def state(half_opening: Range | None = None, friction: Range | None = None, *, frictions: bool = True, **arch: Any) -> State | Survey:
    """The state of an arch at its least thickness, proved. A float is exactly the double that it is; text is exact.

    Args:
        half_opening: from the crown to the shoulder, between 0 and pi: radians, or text with a unit ('80deg').
        friction: the coefficient, 0 or more, float('inf') for no limit; or text: 'inf', an angle ('31deg').
        friction_angle: the angle instead of the coefficient ('21deg').
        stones: how many stones of one angle the arch has, with joints between them alone: the answer is one of ``voussoirs``.
        joints: the angles of its joints instead, from the crown to the shoulder.
        span, rise, radius: any two, or one with the half opening, with a unit ('10m', '60cm', '33ft'); sizes are then told in metres.
        measured_at: the circle at which these are measured, 'intrados' if it is not given, 'centreline' or 'extrados'.
        density, depth: of the material ('2400kg/m3', '24kN/m3') and across the span; forces are then told in kN.
        thickness, tilt: not here: see ``assess`` and ``tilt``.
        weight: the model of self-weight, 'heyman' or 'milankovitch'.
        digits: significant digits, 1 to 1,000,000. Up to 33 cost at most three times what few cost.
        frictions: also the frictions at which the mode changes, and what would be enough for an arch that falls.

    Half opening, friction, span, rise and radius may be ranges, (least, largest), or text ('10m±2cm', '0.5..inf'). Then the
    answer is a ``Survey``: what is proved of every arch inside, without probability.

        >>> couplet.state("pi/2", "0.38", weight="heyman", digits=12)
        State(half_opening='pi/2', friction='0.38', weight='heyman', verdict='stands', mode='[s,r,r]', thickness='0.122191586363')
        >>> couplet.state(span="10m", rise="3m", friction="0.6", digits=6).least_thickness_m
        Certified('least_thickness_m', '0.148126')
    """
    question = _Question("state", ranged({"half_opening": half_opening, "friction": friction, **arch}))
    survey = question.survey()
    if survey is not None:
        return survey
    if question.has_joints():
        return question.of_stones()[0]
    told = asked(_core.state, *question.words, frictions)
    return State((*question.fields, ("weight", told["weight"])), told)


@overload
def assess(half_opening: Exact | None, friction: Exact, thickness: Exact, **arch: Unpack[Arch]) -> Assessment: ...
@overload
def assess(half_opening: Exact | None = None, *, friction: Exact, thickness: Exact, **arch: Unpack[Arch]) -> Assessment: ...
@overload
def assess(half_opening: Exact | None = None, *, friction_angle: Exact, thickness: Exact, **arch: Unpack[Arch]) -> Assessment: ...
@overload
def assess(half_opening: Range | None, friction: Range, thickness: Range, **arch: Unpack[Arches]) -> Assessment | Survey: ...
@overload
def assess(half_opening: Range | None = None, *, friction: Range, thickness: Range, **arch: Unpack[Arches]) -> Assessment | Survey: ...
@overload
def assess(
    half_opening: Range | None = None, *, friction_angle: Range, thickness: Range, **arch: Unpack[Arches]
) -> Assessment | Survey: ...
@named(Beside, Arches)
def assess(
    half_opening: Range | None = None, friction: Range | None = None, thickness: Range | None = None, **arch: Any
) -> Assessment | Survey:
    """Whether an arch of a given thickness stands, its safety factors, and the thrusts it can bear, proved.

    Args:
        thickness: t/r, above 0 and at most 2; of an arch in metres a length ('60cm'), or a ratio with its r ('0.12r').
        tilt: a horizontal acceleration, or the angle by which the ground is tilted: the answer is one of ``tilt``.
        half_opening and others: as for ``state``; ranges too, also of the thickness.

        >>> a = couplet.assess("80deg", "0.6", "0.12", digits=8)
        >>> a.verdict, str(a.geometric_safety), a.least_thrust.limited_by
        ('stands', '1.7479853', 'intrados at the haunch')
        >>> couplet.assess(("79deg", "81deg"), "0.6±10%", (0.125, 0.15)).verdict
        'stands'
    """
    question = _Question("assess", ranged({"half_opening": half_opening, "friction": friction, "thickness": thickness, **arch}))
    survey = question.survey()
    if survey is not None:
        return survey
    if "tilt" in question.texts:
        return question.tilted()
    if question.has_joints():
        found = question.of_stones()[0].assessment
        assert found is not None
        return found
    return Assessment(question.given, asked(_core.assess, *question.words))


@overload
def tilt(half_opening: Exact | None, friction: Exact, thickness: Exact, tilt: Exact = 0, **arch: Unpack[OfStones]) -> Tilted: ...
@overload
def tilt(half_opening: Exact | None = None, *, friction: Exact, thickness: Exact, tilt: Exact = 0, **arch: Unpack[OfStones]) -> Tilted: ...
@overload
def tilt(
    half_opening: Exact | None = None, *, friction_angle: Exact, thickness: Exact, tilt: Exact = 0, **arch: Unpack[OfStones]
) -> Tilted: ...
@named(Beside, Arches)
def tilt(
    half_opening: Exact | None = None, friction: Exact | None = None, thickness: Exact | None = None, tilt: Exact = 0, **arch: Any
) -> Tilted:
    """Whether an arch of a given thickness stands under a horizontal acceleration, and the largest with which it does, proved.

    Args:
        tilt: the acceleration over that of gravity ('0.1'), or the angle by which the ground is tilted ('5deg').
        thickness and others: as for ``assess``; of stones at most 2001.

        >>> couplet.tilt("pi/2", "0.6", "0.15", "5deg", digits=8)
        Tilted(half_opening='pi/2', friction='0.6', thickness='0.15', tilt='5deg', weight='milankovitch', verdict='stands', largest_tilt='0.14432644')
    """
    given = {"half_opening": half_opening, "friction": friction, "thickness": thickness, "tilt": tilt, **arch}
    return _Question("tilt", given).tilted()


@overload
def voussoirs(half_opening: Exact | None, friction: Exact, stones: range, **arch: Unpack[Sizes]) -> list[Voussoirs]: ...
@overload
def voussoirs(half_opening: Exact | None = None, *, friction: Exact, stones: range, **arch: Unpack[Sizes]) -> list[Voussoirs]: ...
@overload
def voussoirs(half_opening: Exact | None = None, *, friction_angle: Exact, stones: range, **arch: Unpack[Sizes]) -> list[Voussoirs]: ...
@overload
def voussoirs(half_opening: Exact | None, friction: Exact, stones: Stones = None, **arch: Unpack[OfThickness]) -> Voussoirs: ...
@overload
def voussoirs(half_opening: Exact | None = None, *, friction: Exact, stones: Stones = None, **arch: Unpack[OfThickness]) -> Voussoirs: ...
@overload
def voussoirs(
    half_opening: Exact | None = None, *, friction_angle: Exact, stones: Stones = None, **arch: Unpack[OfThickness]
) -> Voussoirs: ...
@named(Beside, Arches)
def voussoirs(
    half_opening: Exact | None = None, friction: Exact | None = None, stones: Stones | range = None, **arch: Any
) -> Voussoirs | list[Voussoirs]:
    """The state of an arch of stones at its least thickness, with joints between them alone, proved.

    Args:
        stones: how many, of one angle; an odd number has a keystone. A range, ``range(2, 201)``, asks for each of its numbers.
        joints: instead, the angles of the joints of the half arch, from the crown (0, or half a keystone) to the shoulder.
        thickness: then also whether the arch stands with it, in ``assessment``; of one number of stones.
        half_opening and others: as for ``state``. Of a tilted arch ``tilt`` tells.

    Returns: an answer; of a range a list of answers.

        >>> [str(arch.thickness) for arch in couplet.voussoirs("pi/2", "0.6", range(7, 10), digits=4)]
        ['0.09625', '0.1009', '0.1021']
    """
    if arch["tilt"] is not None:
        raise CoupletError("tilt does not belong here: couplet.tilt tells of an arch of a thickness that is tilted")
    found = _Question("voussoirs", {"half_opening": half_opening, "friction": friction, "stones": stones, **arch}).of_stones()
    return found if isinstance(stones, range) else found[0]


@overload
def find(what: Literal["half_opening", "alpha"], *, friction: Exact, **arch: Unpack[OfThickness]) -> Found: ...
@overload
def find(what: Literal["half_opening", "alpha"], *, friction_angle: Exact, **arch: Unpack[OfThickness]) -> Found: ...
@overload
def find(what: Literal["friction", "mu"], *, half_opening: Exact | None = None, **arch: Unpack[OfThickness]) -> Found: ...
@overload
def find(
    what: Literal["boundary"],
    modes: str | Sequence[str],
    *,
    half_opening: Exact | None = None,
    friction: Exact | None = None,
    friction_angle: Exact | None = None,
    **arch: Unpack[Sizes],
) -> Found: ...
@named(Beside, Arches)
def find(
    what: str, modes: str | Sequence[str] | None = None, *, half_opening: Exact | None = None, friction: Exact | None = None, **arch: Any
) -> Found:
    """A question the other way round: the one answer, with the proof that there is no other.

    Args:
        what: 'half_opening', the widest that stands with a ``friction``; 'friction', the least with which a
            ``half_opening`` stands; 'boundary', where one mode becomes another, at either.
        modes: the two modes of a boundary ('rrs/rsr'), also as ``Found.modes`` has them: ('[r,r,s]', '[r,s,r]').
        thickness: t/r, above 0 and at most 2, of an arch in metres a length; any if it is not given. Not of a boundary.
        half_opening and others: as for ``state``. stones, joints, tilt, density, depth: not here; the refusal says why.

        >>> couplet.find("friction", half_opening="80deg", thickness="0.1", digits=10).value
        Certified('friction', '0.2573157331')
    """
    question = _Question("find", {"half_opening": half_opening, "friction": friction, **arch})
    target = target_of(what, modes)
    return Found((("modes", target[1]), *question.given), asked(_core.find, target, *question.words))


def target_of(what: str, modes: str | Sequence[str] | None) -> tuple[str, str | None]:
    """What is sought, as what is compiled has it."""
    return str(what).replace(" ", "_"), modes if modes is None or isinstance(modes, str) else "/".join(map(str, modes))


@overload
def certify(landmark: Landmark | LandmarkName, *, weight: str = "milankovitch", digits: int = 30, threads: int = 0) -> str: ...
@overload
def certify(*, half_opening: Range | None = None, friction: Range, **arch: Unpack[Certifiable]) -> str: ...
@overload
def certify(*, half_opening: Range | None = None, friction_angle: Range, **arch: Unpack[Certifiable]) -> str: ...
@named(Beside, Certifiable)
def certify(landmark: str | None = None, *, half_opening: Range | None = None, friction: Range | None = None, **arch: Any) -> str:
    """A certificate that ``check`` accepts without trusting the solver, as JSON (``couplet.certificate/1``); with ranges, as of ``assess``,
    of the verdict on all arches inside (``couplet.survey-certificate/1``); an UndecidedError if the proof does not succeed.

    Args:
        landmark: of a landmark; or
        half_opening, friction: of the state of an arch at its least thickness, or why it stands at none; with
        thickness: that the arch stands with it, or does not; or with
        asymmetric: of its asymmetric solution of the complementarity problem (19). True for the one that there is, or how its
            mechanism closes: 'inner_sliding', 'shoulder_opening', 'shoulder_sliding'.
        friction_angle and others: as for ``state``. stones, joints, tilt, density, depth: not here; the refusal says why.
        threads: threads to compute a landmark with, or the arches that decide for all; 0 for one on each core.

        >>> made = couplet.certify(half_opening="2.3", friction="1.05", asymmetric=True, digits=12)
        >>> couplet.check(made, engine="mpfr").verdict
        'accepted'
    """
    asymmetric, threads = arch["asymmetric"], arch["threads"]
    values = {"half_opening": half_opening, "friction": friction, **arch}
    if landmark is not None:
        if asymmetric is not False or any(values[name] is not None for name in FIELDS):
            raise CoupletError("a half opening, a friction, a thickness and asymmetric belong to an arch, not to a landmark")
        return asked(_core.certify_landmark, landmark, arch["weight"], text_of(arch["digits"]), whole(threads))
    question = _Question("certify", ranged(values))
    weight, texts, digits = question.words
    if texts.keys().isdisjoint(("half_opening", "span", "rise", "joints")):
        raise CoupletError("a landmark, or a half opening and a friction, are missing")
    if asymmetric is False:
        return asked(_core.certify_arch, *question.words, whole(threads))
    if "thickness" in texts:
        raise CoupletError("an asymmetric solution has its own thickness: leave it out")
    return asked(_core.certify_asymmetric, weight, texts, None if asymmetric is True else str(asymmetric), digits)


class _Question:
    """A question about an arch: its name, what is given, and that in the words of what is compiled: weight, texts, digits."""

    def __init__(self, name: str, values: dict[str, Any]) -> None:
        self.name, weight = name, values["weight"]
        self.texts, self.fields = texts_of(values)
        self.given: Given = (*self.fields, ("weight", weight))
        self.words: tuple[str, dict[str, str], str] = (weight, self.texts, text_of(values["digits"]))

    def has_joints(self) -> bool:
        """Whether the arch has joints only where stones meet."""
        return "stones" in self.texts or "joints" in self.texts

    def survey(self) -> Survey | None:
        """What is proved of every arch of a question with ranges; None if it has no range."""
        told = asked(_core.surveyed, self.name, *self.words)
        return None if told is None else Survey(of_json(told))

    def of_stones(self) -> list[Voussoirs]:
        """The answers about an arch of stones."""
        stones = dict(self.given).get("stones")
        if isinstance(stones, str) and ".." in stones:
            raise CoupletError("several numbers of stones are a range: couplet.voussoirs(…, stones=range(2, 201))")
        if self.name != "voussoirs" and isinstance(stones, range):
            raise CoupletError("one number of stones at a time; of several couplet.voussoirs tells")
        text, values = asked(_core.voussoirs, self.name, *self.words)
        said = of_json(text)
        return [_stones_told(self.given, *of) for of in zip(said if isinstance(said, list) else [said], values)]

    def tilted(self) -> Tilted:
        """The answer about a tilted arch."""
        text, values = asked(_core.tilted, *self.words, None)
        said = of_json(text)
        stands = {"stands": True, "collapses": False}.get(said["outcome"])
        told = {**_with_nothing(said), "status": "undecided" if stands is None else "proved", "stands": stands, "values": values}
        return Tilted(self.given, told)


def _with_nothing(said: dict[str, Any]) -> dict[str, Any]:
    """What is said of stones or a tilt, and nothing of what else is said of any arch."""
    nothing = dict.fromkeys(("gap", "can_stand", "stands", "measured_at", "stones", "joints", "assessment"))
    return {**nothing, **said, "open": [], "modes": [], "enough": {}, "between": []}


def _stones_told(given: Any, said: dict[str, Any], values: list[dict[str, Any]]) -> Voussoirs:
    """An answer about an arch of stones, as those about any arch are told."""
    stones, outcome, assessed = said.get("stones"), said["outcome"], said.pop("assessment", None)
    if stones is not None:
        given = tuple((name, stones if isinstance(value, range) else value) for name, value in given)
    told = {**_with_nothing(said), "values": values[0], "modes": [said["mode"]] if said["mode"] else []}
    told["status"] = "undecided" if outcome == "undecided" else "proved"
    told["can_stand"] = {"stands": True, "any_thickness": True, "undecided": None}.get(outcome, False)
    told["reason"] = said["reason"] or (outcome if told["can_stand"] is False else None)
    if assessed is not None:
        stands = assessed["stands"]
        standing = {"stands": stands, "status": "undecided" if stands is None else "proved", "can_stand": None}
        told["assessment"] = {**told, **standing, "values": values[1], "reason": assessed["reason"]}
    return Voussoirs(given, told)
