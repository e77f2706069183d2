"""Ranges: what is proved of every arch inside, as a dictionary."""

import json
import pickle

import pytest

import couplet


def test_a_range_is_two_ends_or_a_text():
    pair = couplet.assess(("79deg", "81deg"), ("0.54", "0.66"), ("0.1", "0.12"), digits=6)
    text = couplet.assess("80deg±1deg", "0.6±10%", "0.11±0.01", digits=6)
    assert pair["outcome"] == text["outcome"] == "all_stand" and pair["schema"] == "couplet.survey/1"
    assert pair["ranges"] == text["ranges"] and json.loads(json.dumps(pair)) == pair
    assert type(pair.to_dict()) is dict and pair.to_dict() == pair and json.loads(json.dumps(pair.to_dict())) == pair
    one = couplet.assess("81deg", "0.54", "0.1", digits=6)
    lower = next(of["lower"] for of in pair["ranges"] if of["quantity"] == "geometric_safety")
    assert float(lower["value"]) <= float(str(one.geometric_safety))


def test_what_to_measure_better_is_the_answer_with_one_range():
    middles = {"span": "10m", "rise": "3m", "thickness": "60cm", "friction": "0.6"}
    ranges = {"span": "10m±10cm", "rise": "3m±1cm", "thickness": "60cm±3cm", "friction": "0.6±0.1"}
    alone = couplet.assess(**ranges, digits=6).measures_alone
    assert list(alone)[0] == "thickness" and set(alone) == set(ranges)
    for measure, ends in alone.items():
        one = couplet.assess(**{**middles, measure: ranges[measure]}, digits=6)
        safety = next(of for of in one["ranges"] if of["quantity"] == "geometric_safety")
        assert ends == (safety["lower"]["value"], safety["upper"]["value"]) and one.measures_alone == {}
    open_ended = couplet.assess("80deg±1deg", (0.5, float("inf")), 0.125, digits=6).measures_alone
    assert open_ended["half_opening"] is None and open_ended["friction"] is not None


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        (lambda: couplet.assess("80deg", "0.6±10%", "0.11±0.01", digits=6), "stands"),
        (lambda: couplet.assess("80deg", "0.6±10%", (0.01, 0.02), digits=6), "falls"),
        (lambda: couplet.assess("80deg", "0.6±10%", (0.05, 0.1), digits=6), "both"),
        (lambda: couplet.state("80deg", (0.5, 0.6), digits=6), "stands"),
        (lambda: couplet.state("80deg", (0.01, 0.02), digits=6), "falls"),
        (lambda: couplet.state("80deg", (0.1, 0.6), digits=6), "both"),
    ],
)
def test_a_range_has_a_verdict_as_an_arch_has(answer, verdict):
    survey = answer()
    assert isinstance(survey, couplet.Survey) and survey.verdict == verdict and survey.reason is None
    assert pickle.loads(pickle.dumps(survey)).verdict == verdict and json.loads(json.dumps(survey)) == survey
    assert couplet.Survey({**survey, "outcome": "undecided"}).verdict == "undecided"


def test_doubles_are_the_doubles_that_they_are():
    survey = couplet.state(1.25, (0.5, float("inf")), digits=6)
    assert survey["outcome"] == "all_can_stand" and survey["asked"]["friction"] == "1/2..inf"
    assert isinstance(couplet.state(1.25, 0.5, digits=6), couplet.State)


def test_a_certificate_of_every_arch_is_accepted():
    made = couplet.certify(half_opening=("78deg", "80deg"), friction="0.6", thickness=("0.06", "0.12"), digits=10)
    told = json.loads(made)
    assert (told["schema"], told["verdict"]) == ("couplet.survey-certificate/1", "both_occur")
    for engine in ["astro", "mpfr"]:
        checked = couplet.check(made, engine=engine)
        assert (checked.verdict, checked.digits, checked.texts) == ("accepted", None, {})
        assert checked.summary.startswith("one arch stands") and checked.to_dict()["summary"] == checked.summary
    spoiled = json.dumps({**told, "verdict": "all_stand"})
    assert (couplet.check(spoiled).verdict, couplet.check(spoiled).summary) == ("refused", None)
    # However many threads make it, and in metres.
    measured = dict(span="10m±2cm", rise=("2.99m", "3.01m"), thickness="60cm±1cm", friction=(0.5, 0.625))
    one, several = (couplet.certify(**measured, digits=5, threads=threads) for threads in (1, 3))
    assert one == several and couplet.check(one).summary.startswith("all arches stand")


@pytest.mark.parametrize(
    ("ask", "why"),
    [
        (lambda: couplet.state((1, 2, 3), 1), r"a range of the half opening is \(lower, upper\), not 3 values"),
        (lambda: couplet.state((2, 1), 1), "give the lower end first"),
        (lambda: couplet.state("80..82deg", 1), "write 80deg..82deg"),
        (lambda: couplet.assess((1, 2), 1), "thickness is missing"),
        (lambda: couplet.assess((1, 2), 1, 0.1, stones=5), "stones does not go with the range of half_opening"),
        (lambda: couplet.certify(half_opening=(1, 1.1), friction=1), "thickness is missing"),
        (lambda: couplet.certify(half_opening=(1, 1.1), friction=1, asymmetric=True), "one value"),
        (lambda: couplet.certify("T", friction=(1, 1.1)), "belong to an arch, not to a landmark"),
        (lambda: couplet.find("half_opening", friction="0.5..0.6", thickness=0.1), "one value"),
    ],
)
def test_what_is_no_range_is_refused(ask, why):
    with pytest.raises(couplet.CoupletError, match=why):
        ask()
