"""Answers as dictionaries, codes with names, reasons, and frames."""

import json
from decimal import Decimal
from fractions import Fraction

import pytest

import couplet

ANSWERS = [
    lambda: couplet.state(Fraction(49, 20), Decimal("1.35"), digits=9),
    lambda: couplet.state("80deg", "0.1", digits=9),
    lambda: couplet.state(1, float("inf"), digits=9),
    lambda: couplet.state(span="10m", rise="3m", friction="0.6", density="24kN/m3", depth="1m", digits=9),
    lambda: couplet.assess("80deg", "0.6", "0.12", digits=9),
    lambda: couplet.voussoirs("pi/2", "0.6", 11, thickness="0.12", digits=9),
    lambda: couplet.voussoirs("pi/2", "0.6", range(5, 6), digits=9)[0],
    lambda: couplet.tilt("pi/2", "0.6", "0.15", digits=9),
    lambda: couplet.find("friction", half_opening="80deg", thickness="0.1", digits=9),
    lambda: couplet.constants("l", digits=9),
    lambda: couplet.check(couplet.certify("T", digits=9)),
    lambda: couplet.prove("eq-8")[0],
    lambda: couplet.state(1, 1, digits=9).thickness,
]


@pytest.mark.parametrize("answer", ANSWERS)
def test_every_answer_is_a_dictionary_that_json_takes(answer):
    answer = answer()
    told = answer.to_dict()
    assert json.loads(json.dumps(told, allow_nan=False)) == told
    if isinstance(answer, couplet.Answer):
        assert told["verdict"] == answer.verdict and told["reason"] == answer.reason
        values = getattr(answer, "texts", None) or {name: value.to_dict() for name, value in answer.values.items()}
        assert told["values"] == values and list(told["given"]) == list(answer.given)


def test_what_a_dictionary_has():
    told = couplet.state("2.3", "1.05", digits=12).to_dict()
    assert told["given"] == {"half_opening": "2.3", "friction": "1.05", "weight": "milankovitch"}
    assert (told["mode"], told["can_stand"]) == ("[s,r,r]", True)
    thickness = told["values"]["thickness"]
    assert thickness["text_lower"] <= thickness["text"] <= thickness["text_upper"] and thickness["unit"] == "r"
    assert set(couplet.state("80deg", "0.1").to_dict()["enough"]) == {"friction", "half_opening"}
    assert couplet.state(2.45, Fraction(1, 3)).to_dict()["given"] == {"half_opening": 2.45, "friction": "1/3", "weight": "milankovitch"}
    assert couplet.constants("L", digits=4).to_dict()["values"]["friction"]["double"] == "inf"
    limited = couplet.assess("80deg", "0.6", "0.12").to_dict()["values"]["least_thrust"]
    assert limited["limited_by"] == "intrados at the haunch"
    assert couplet.voussoirs("pi/2", "0.6", 11, thickness="0.12").to_dict()["assessment"]["verdict"] == "stands"


def test_letters_are_names():
    constants = couplet.constants("T", digits=9)
    assert constants["eta"] == constants["thickness"] and constants["mu"].quantity == "friction"
    assert "eta" in constants and "weight" not in constants and 3 not in constants
    for missing in ["weight", "geometric_safety", "nothing", 3]:
        with pytest.raises(KeyError):
            constants[missing]
