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


def test_codes_are_numbers_and_words():
    assert [str(verdict) for verdict in couplet.Verdict] == list(couplet.VERDICTS)
    assert [str(mode) for mode in couplet.Mode][:-1] == list(couplet.MODES) and str(couplet.Mode(255)) == "none"
    assert (couplet.Verdict.STANDS, couplet.Verdict.REFUSED, couplet.Mode.RRR, couplet.Mode.NONE) == (0, 3, 0, 255)
    for code in [*couplet.Verdict, *couplet.Mode]:
        assert f"{code}" == f"{code:>1}" == code.word == str(code) and isinstance(code, int)
    for place, label in enumerate(couplet.MODES):
        assert couplet.Mode[label.upper().strip("[]").replace(",", "")] == place
    with pytest.raises(AttributeError, match="no attribute 'Modes'"):
        couplet.Modes


def test_codes_are_those_of_arrays():
    pytest.importorskip("numpy")
    found = couplet.states([1.3, 1.3, 2.5, 4.0], [0.5, 0.01, 1.5, 1.0])
    verdicts = [couplet.Verdict(code) for code in found["verdict"]]
    assert [str(verdict) for verdict in verdicts] == ["stands", "falls", "stands", "refused"]
    assert (found["verdict"] == couplet.Verdict.STANDS).tolist() == [True, False, True, False]
    assert (found["mode"] == couplet.Mode.RRS).tolist() == [False, False, True, False]
    assert couplet.state(2.5, 1.5, digits=9).mode == str(couplet.Mode(found["mode"][2]))


def test_a_bad_row_has_a_reason():
    np = pytest.importorskip("numpy")
    alpha, mu = [1.0, 4.0, float("nan"), 1.0], [0.5, 0.5, 0.5, -1.0]
    found = couplet.states(alpha, mu)
    why = couplet.reasons(found, alpha, mu)
    assert list(why) == [1, 2, 3] and "did you mean 4deg?" in why[1] and "'nan'" in why[2] and "negative" in why[3]
    for row, sentence in why.items():
        with pytest.raises(couplet.CoupletError) as caught:
            couplet.state(alpha[row], mu[row])
        assert str(caught.value) == sentence
    grid = np.array(alpha)[:, None], np.array([0.5, -1.0])[None, :]
    assert list(couplet.reasons(couplet.states(*grid), *grid)) == [(0, 1), (1, 0), (1, 1), (2, 0), (2, 1), (3, 1)]
    thick = couplet.reasons(couplet.states(1.0, 0.5, [0.1, 3.0]), 1.0, 0.5, [0.1, 3.0])
    assert list(thick) == [1] and "the thickness 3 is not between 0 and 2" in thick[1]
    assert couplet.reasons(couplet.states(1.0, 0.5), 1.0, 0.5) == {}
    with pytest.raises(couplet.CoupletError, match="the answers have the shape"):
        couplet.reasons(found, 1.0, 0.5)


def test_an_undecided_row_has_a_reason():
    pytest.importorskip("numpy")
    found = couplet.states([1.0, 1.0], 0.5)
    found["verdict"] = [0, 2]
    assert couplet.reasons(found, [1.0, 1.0], 0.5) == {1: "it is undecided in doubles"}


def test_a_frame():
    pandas = pytest.importorskip("pandas")
    frame = couplet.states_frame([1.3, 1.3, 2.5, 4.0], [0.5, 0.01, 1.5, 1.0])
    assert frame["verdict"].tolist() == ["stands", "falls", "stands", "refused"]
    assert frame["mode"].astype(object).where(frame["mode"].notna(), None).tolist() == ["[r,r,r]", None, "[r,r,s]", None]
    for name, words in [("verdict", couplet.VERDICTS), ("mode", couplet.MODES)]:
        assert isinstance(frame[name].dtype, pandas.CategoricalDtype) and list(frame[name].cat.categories) == list(words)
    assert frame["reason"].isna().tolist() == [True, True, True, False] and "4deg" in frame["reason"][3]
    assert list(frame.columns)[-1] == "reason" and "given_thickness" in couplet.states_frame(1.0, 0.5, 0.1)
    assert frame["thickness"][2] == couplet.states(2.5, 1.5)["thickness"].item()
