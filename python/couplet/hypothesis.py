"""Strategies of arches for property tests with Hypothesis (``pip install couplet[hypothesis]``).

    from hypothesis import given
    from couplet.hypothesis import arches

    @given(arches(doubles=True))
    def test_my_solver(arch):
        truth = couplet.state(**arch)
        mine = my_solver(arch["half_opening"], arch["friction"])
        ...

An arch is a dictionary of keywords of ``couplet.state``, ``assess`` or ``voussoirs``. Its numbers are exact texts, or doubles. A failing
arch is made simple, with few digits. Of every strategy ``hard=True`` draws hard ones alone, ``hard=False`` ordinary ones alone.
"""

from __future__ import annotations

import math
from decimal import ROUND_DOWN, Context, Decimal
from functools import lru_cache

from hypothesis import strategies as st

import couplet

TYPE_CHECKING = False
if TYPE_CHECKING:
    from hypothesis.strategies import DrawFn, SearchStrategy

    from ._types import Any, Landmark

__all__ = ["arches", "arches_of_stones", "frictions", "half_openings", "thicknesses"]

_WEIGHTS = ("milankovitch", "heyman")
#: The digits that a hard arch shares with a landmark or a threshold.
_SHARED = st.integers(3, 40)


def half_openings(hard: bool | None = None) -> SearchStrategy[str]:
    """Half openings as exact texts: ordinary decimals from 0.01 to 3.14; hard ones: tiny, next to half a turn, exact fractions of pi."""
    tiny = st.builds("{}e-{}".format, st.integers(1, 9), st.integers(3, 60))
    wide = st.builds(lambda nines: f"0.{'9' * nines}pi", st.integers(1, 30))
    exact = st.builds("{}pi/12".format, st.integers(1, 11))
    return _either(_decimals("0.01", "3.14"), st.one_of(exact, wide, tiny), hard)


def frictions(hard: bool | None = None) -> SearchStrategy[str]:
    """Frictions as exact texts: ordinary coefficients from 0.01 to 4; hard ones: none, tiny, huge, unlimited, tangents of exact angles."""
    special = st.sampled_from(["0", "inf", "1e80", "1e-30"])
    tangents = st.builds("tan(pi/{})".format, st.integers(3, 60))
    angles = st.builds("{}deg".format, st.integers(1, 89))
    return _either(_decimals("0.01", "4"), st.one_of(special, angles, tangents), hard)


def thicknesses(hard: bool | None = None) -> SearchStrategy[str]:
    """Ratios of thickness to radius as exact texts: ordinary ones from 0.001 to 2; hard ones: tiny, and next to 2."""
    tiny = st.builds("1e-{}".format, st.integers(4, 60))
    thick = st.one_of(st.just("2"), st.builds(lambda nines: f"1.{'9' * nines}", st.integers(1, 30)))
    return _either(_decimals("0.001", "2"), st.one_of(thick, tiny), hard)


def arches(
    *, hard: bool | None = None, weight: str | None = None, thickness: bool = False, doubles: bool = False
) -> SearchStrategy[dict[str, Any]]:
    """Arches: ``half_opening``, ``friction``, ``weight`` and, if it is asked for, ``thickness``.

    Hard (``hard=True`` alone, False: none) are arches next to a landmark, of which they share 3 to 40 digits; next to a friction at which
    one mode becomes another or nothing stands any more; with a thickness next to their least; and with hard numbers.

    Args:
        weight: the model of self-weight of all, 'heyman' or 'milankovitch'; both if it is not given.
        thickness: arches of a thickness, for ``assess``.
        doubles: half opening, friction and thickness are the doubles next to the numbers, as a solver in doubles has them.
    """
    weights = st.just(weight) if weight else st.sampled_from(_WEIGHTS)
    ordinary = st.fixed_dictionaries({"half_opening": half_openings(False), "friction": frictions(False), "weight": weights})
    odd = st.fixed_dictionaries({"half_opening": half_openings(), "friction": frictions(), "weight": weights})
    found = _either(ordinary, st.one_of(odd, _next_to_landmarks(weights), _next_to_thresholds(weights)), hard)
    if thickness:
        found = found.flatmap(lambda arch: _with_thickness(arch, hard))
    return found.map(_in_doubles).filter(_is_arch) if doubles else found


def arches_of_stones(*, hard: bool | None = None, weight: str | None = None, thickness: bool = False) -> SearchStrategy[dict[str, Any]]:
    """Arches of stones, for ``voussoirs``: as ``arches`` has them, with ``stones``, from 2 to 60; of hard ones up to 1,000,000,000."""
    stones = _either(st.integers(2, 60), st.integers(61, 10**9), hard)
    with_stones = st.tuples(arches(hard=hard, weight=weight, thickness=thickness), stones)
    return with_stones.map(lambda both: {**both[0], "stones": both[1]})


def _either(ordinary: SearchStrategy[Any], hard_ones: SearchStrategy[Any], hard: bool | None) -> SearchStrategy[Any]:
    return st.one_of(ordinary, hard_ones) if hard is None else hard_ones if hard else ordinary


def _decimals(least: str, most: str) -> SearchStrategy[str]:
    """Decimals as texts, few places first."""
    places = st.integers(max(2, len(least) - 2), 16)
    return places.flatmap(lambda places: st.decimals(least, most, places=places)).map("{:f}".format)


@lru_cache(maxsize=None)
def _landmark(landmark: Landmark, weight: str) -> tuple[str, str]:
    """The half opening and the friction of a landmark."""
    constants = couplet.constants(landmark, weight, digits=50, quantities=["half_opening", "friction"])
    texts = [constants[name].text if name in constants else "inf" for name in ("half_opening", "friction")]
    return texts[0], texts[1]


def _cut(text: str, digits: int) -> str:
    """A number with so many of its digits, of which the rest are cut off."""
    return text if text == "inf" else format(Context(prec=digits, rounding=ROUND_DOWN).create_decimal(Decimal(text)), "f")


@st.composite
def _next_to_landmarks(draw: DrawFn, weights: SearchStrategy[str]) -> dict[str, Any]:
    weight = draw(weights)
    half_opening, friction = _landmark(draw(st.sampled_from(couplet.LANDMARKS)), weight)
    shared = draw(_SHARED)
    return {"half_opening": _cut(half_opening, shared), "friction": _cut(friction, shared), "weight": weight}


@st.composite
def _next_to_thresholds(draw: DrawFn, weights: SearchStrategy[str]) -> dict[str, Any]:
    """Next to the friction below which an arch slides, or from which it does not."""
    weight, half_opening = draw(weights), draw(half_openings(False))
    state = couplet.state(half_opening, "inf", weight=weight, digits=45)
    thresholds = [value.text for value in (state.sliding_friction, state.rotational_friction) if value is not None]
    friction = draw(st.sampled_from(thresholds)) if thresholds else "inf"
    return {"half_opening": half_opening, "friction": _cut(friction, draw(_SHARED)), "weight": weight}


@st.composite
def _with_thickness(draw: DrawFn, arch: dict[str, Any], hard: bool | None) -> dict[str, Any]:
    """With any thickness, or one next to the least."""
    if hard is False or draw(st.booleans()):
        return {**arch, "thickness": draw(thicknesses(hard))}
    least = couplet.state(**arch, digits=45, frictions=False).thickness
    thickness = draw(thicknesses()) if least is None else _cut(least.text, draw(_SHARED))
    return {**arch, "thickness": thickness}


def _in_doubles(arch: dict[str, Any]) -> dict[str, Any]:
    numbers = {name: _double(text) for name, text in arch.items() if name != "weight"}
    return {**arch, **numbers}


def _double(text: str) -> float:
    """The double next to a number; of an angle or a tangent nearly so."""
    if text.startswith("tan("):
        return math.tan(_double(text[4:-1]))
    if text.endswith("deg"):
        return math.tan(math.radians(float(text[:-3])))
    if "pi" in text:
        times, _, over = text.partition("pi")
        return float(times or 1) * math.pi / float(over[1:] or 1)
    return float(text)


def _is_arch(arch: dict[str, Any]) -> bool:
    """Whether doubles are between their limits, which they may be rounded to."""
    return bool(0 < arch["half_opening"] < math.pi and 0 < arch.get("thickness", 1) <= 2)
