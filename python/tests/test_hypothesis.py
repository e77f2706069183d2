"""Strategies of arches."""

from decimal import Decimal

import pytest

import couplet

pytest.importorskip("hypothesis")

from hypothesis import HealthCheck, find, given, settings  # noqa: E402

from hypothesis.errors import NoSuchExample  # noqa: E402

from couplet.hypothesis import arches, arches_of_stones, frictions, half_openings, thicknesses  # noqa: E402

FEW = settings(max_examples=60, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))


@FEW
@given(arches())
def test_every_arch_is_one(arch):
    state = couplet.state(**arch, digits=12)
    assert set(arch) == {"half_opening", "friction", "weight"}
    assert state.verdict in ("stands", "falls", "undecided")
    if state.thickness is not None:
        assert 0 < state.thickness.double <= 2


@FEW
@given(arches(thickness=True))
def test_an_arch_of_a_thickness_agrees_with_its_state(arch):
    found = couplet.assess(**arch, digits=17)
    least = couplet.state(**{name: arch[name] for name in ("half_opening", "friction", "weight")}, digits=50).thickness
    if least is None:
        assert found.verdict != "stands"
    elif "undecided" != found.verdict:
        low, high = least.decimals()
        eta = Decimal(arch["thickness"])
        assert found.verdict == ("stands" if eta >= high else "falls") or low <= eta <= high


@FEW
@given(arches(doubles=True, thickness=True, weight="heyman"))
def test_doubles_are_doubles(arch):
    assert {type(arch[name]) for name in ("half_opening", "friction", "thickness")} == {float} and arch["weight"] == "heyman"
    assert couplet.assess(**arch, digits=9).verdict in ("stands", "falls", "undecided")


@FEW
@given(arches_of_stones())
def test_arches_of_stones_are_some(arch):
    assert couplet.voussoirs(**arch, digits=9).stones == arch["stones"] >= 2


@pytest.mark.parametrize("numbers", [half_openings, frictions, thicknesses])
def test_what_is_simplest(numbers):
    ordinary = find(numbers(False), lambda text: True)
    assert len(ordinary) <= 5 and Decimal(ordinary) > 0
    # A hard one is none of the ordinary ones.
    with pytest.raises(NoSuchExample):
        find(numbers(True), lambda text: text == ordinary, settings=FEW)
    assert find(numbers(), lambda text: text == ordinary) == ordinary


@pytest.mark.parametrize(
    "is_there",
    [
        lambda arch: arch["friction"] == "inf",
        lambda arch: arch["friction"] == "0",
        lambda arch: arch["half_opening"].endswith("99pi"),
        lambda arch: "e-" in arch["half_opening"],
        lambda arch: arch["half_opening"].startswith("2.4") and len(arch["half_opening"]) > 30 and len(arch["friction"]) > 30,
        lambda arch: couplet.state(**arch, digits=9, frictions=False).verdict == "falls",
        lambda arch: couplet.state(**arch, digits=9, frictions=False).mode == "[r,s,r]",
    ],
)
def test_hard_arches_are_of_every_kind(is_there):
    many = settings(max_examples=4000, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
    assert is_there(find(arches(hard=True), is_there, settings=many))


def test_ordinary_ones_are_not_hard():
    with pytest.raises(NoSuchExample):
        find(arches(hard=False), lambda arch: "pi" in arch["half_opening"] or not arch["friction"][0].isdigit(), settings=FEW)


def test_a_wrong_solver_is_found_out_by_a_simple_arch():
    def wrong(arch):
        return float(couplet.state(**arch, digits=17).thickness or 0) > 0.3

    arch = find(arches(doubles=True, weight="milankovitch"), wrong, settings=settings(max_examples=2000, deadline=None, derandomize=True))
    assert len(repr(arch["half_opening"])) <= 6
