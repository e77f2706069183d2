"""Ranges: what is proved of every arch inside, as a dictionary."""

import json

import pytest

import couplet


def test_a_range_is_two_ends_or_a_text():
    pair = couplet.assess(("79deg", "81deg"), ("0.54", "0.66"), ("0.1", "0.12"), digits=6)
    text = couplet.assess("80deg±1deg", "0.6±10%", "0.11±0.01", digits=6)
    assert pair["outcome"] == text["outcome"] == "all_stand" and pair["schema"] == "couplet.survey/1"
    assert pair["ranges"] == text["ranges"] and json.loads(json.dumps(pair)) == pair
    one = couplet.assess("81deg", "0.54", "0.1", digits=6)
    lower = next(of["lower"] for of in pair["ranges"] if of["quantity"] == "geometric_safety")
    assert float(lower["value"]) <= float(str(one.geometric_safety))


def test_doubles_are_the_doubles_that_they_are():
    survey = couplet.state(1.25, (0.5, float("inf")), digits=6)
    assert survey["outcome"] == "all_can_stand" and survey["asked"]["friction"] == "1/2..inf"
    assert isinstance(couplet.state(1.25, 0.5, digits=6), couplet.State)


@pytest.mark.parametrize(
    ("ask", "why"),
    [
        (lambda: couplet.state((1, 2, 3), 1), r"a range of the half opening is \(lower, upper\), not 3 values"),
        (lambda: couplet.state((2, 1), 1), "give the lower end first"),
        (lambda: couplet.state("80..82deg", 1), "write 80deg..82deg"),
        (lambda: couplet.assess((1, 2), 1), "thickness is missing"),
        (lambda: couplet.assess((1, 2), 1, 0.1, stones=5), "stones does not go with the range of half_opening"),
        (lambda: couplet.find("half_opening", friction="0.5..0.6", thickness=0.1), "one value"),
    ],
)
def test_what_is_no_range_is_refused(ask, why):
    with pytest.raises(couplet.CoupletError, match=why):
        ask()
