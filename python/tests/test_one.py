"""One question at a time."""

import copy
import enum
import json
import pickle
from decimal import Decimal
from fractions import Fraction

import pytest
from shell import words_of_a_shell

import couplet


def test_input_is_exact():
    text = couplet.state("49/20", "1.35", digits=20).thickness.text
    for half_opening, friction in [
        (Fraction(49, 20), Decimal("1.35")),
        ("2.45", Fraction(27, 20)),
        (Decimal("245e-2"), "1.350"),
    ]:
        assert couplet.state(half_opening, friction, digits=20).thickness.text == text
    # A float is the double that it is, which is not the decimal that it shows.
    double = couplet.state(2.45, 1.35, digits=20).thickness.text
    assert double != text
    assert couplet.state(Fraction(2.45), Fraction(1.35), digits=20).thickness.text == double
    assert couplet.state(1, 1, digits=5).thickness.text == couplet.state("1", "1/1", digits=5).thickness.text
    assert couplet.state(1, float("inf"), digits=5).thickness.text == couplet.state("1", "inf", digits=5).thickness.text
    assert couplet.state(1, Decimal("Infinity")).verdict == "stands"


def test_a_whole_number_is_one_whatever_its_class_says():
    class Odd(int):
        def __str__(self):
            return "2"

        __repr__ = __str__

    class Kind(enum.IntEnum):
        ONE = 1

    for one in [Odd(1), Kind.ONE]:
        assert couplet.state(one, "0.5", digits=5).thickness.text == couplet.state("1", "0.5", digits=5).thickness.text
        assert couplet.state(1, "0.5", digits=one + 4).thickness.text == couplet.state(1, "0.5", digits=5).thickness.text
        assert couplet.state("0.5", 1, digits=one).thickness.text == couplet.state("0.5", 1, digits=1).thickness.text


def test_an_arch_that_stands_and_may_move():
    state = couplet.state("2.3", "1.05", digits=12)
    arch = couplet.assess("2.3", "1.05", "0.55", digits=12)
    for answer in (state, arch):
        assert answer.verdict == "stands"
        assert answer.asymmetric_thickness.text == answer.values["asymmetric_thickness"].text == "0.583084449604"
        assert "asymmetric_thickness='0.583084449604'" in repr(answer)
    assert couplet.state("1.5", "0.6", digits=5).asymmetric_thickness is None
    assert couplet.assess("2.3", "1.05", "0.5", digits=5).asymmetric_thickness is None
    assert couplet.find("friction", half_opening="2.3", thickness="0.55", digits=5).some_may_move
    assert not couplet.find("friction", half_opening="80deg", thickness="0.1", digits=5).some_may_move


def test_a_state():
    state = couplet.state(half_opening="pi/2", friction="0.38", weight="heyman", digits=12)
    assert (state.verdict, state.mode, state.can_stand, state.reason) == ("stands", "[s,r,r]", True, None)
    thickness = state.thickness
    assert str(thickness) == thickness.text == "0.122191586363"
    low, high = thickness.decimals()
    assert low < high and low <= thickness.decimal() <= high
    assert thickness.lower <= thickness.double <= thickness.upper
    assert float(thickness) == thickness.double
    assert thickness.fractions() == (Fraction(thickness.text_lower), Fraction(thickness.text_upper))
    assert set(state.values) == {
        "thickness", "thrust", "intrinsic_thrust", "rotation_joint", "sliding_friction", "rotational_friction"
    }  # fmt: skip
    assert state.sliding_joint is None
    assert state.given == {"half_opening": "pi/2", "friction": "0.38", "weight": "heyman"}
    alone = couplet.state("pi/2", "0.38", weight="heyman", digits=12, frictions=False)
    assert alone.sliding_friction is None and alone.thickness.text == thickness.text


def test_the_verdicts_are_values():
    falls = couplet.state("80deg", "0.1", digits=10)
    assert (falls.verdict, falls.can_stand, falls.reason, falls.thickness) == ("falls", False, "sliding", None)
    assert set(falls.enough) == {"friction", "half_opening"}
    assert couplet.state("80deg", falls.enough["friction"].text_upper).verdict == "stands"
    assert couplet.state("2atan(1)", "tan(pi/2)", digits=5).verdict == "stands"
    thin = couplet.assess("80deg", "0.6", "0.01", digits=5)
    assert (thin.verdict, thin.can_stand) == ("falls", None)
    assert couplet.assess("80deg", "0.6", "0.12").verdict == "stands"
    assert couplet.check(b"{}").verdict == "refused"
    for answer in [falls, thin, couplet.check(b"{}")]:
        with pytest.raises(TypeError, match="verdict"):
            bool(answer)


def test_next_to_the_least_thickness():
    least = couplet.state("pi/2", "inf", digits=30).thickness
    assert couplet.assess("pi/2", "inf", least.text_lower).verdict == "falls"
    assert couplet.assess("pi/2", "inf", least.text_upper).verdict == "stands"


def test_constants():
    constants = couplet.constants("T", "heyman", digits=40)
    assert constants["thickness"].text == "0.6796047320988855147875348962096841095455"
    assert (constants.landmark, constants.weight, constants.verdict) == ("T", "heyman", "proved")
    assert dict(constants)["thrust"].text == constants["thrust"].text
    assert "A" in constants and len(constants) == len(list(constants)) == len(constants.items())
    with pytest.raises(KeyError):
        constants["weight"]
    assert couplet.constants("triple", digits=5, quantities=["eta"]).keys() == ["thickness"]
    assert couplet.constants("triple", digits=5, quantities="eta").keys() == ["thickness"]
    assert couplet.constants("B", digits=5)["thickness"].text == "2"
    infinite = couplet.constants("l", digits=5)
    assert "friction" not in infinite or infinite["friction"].text == "inf"
    for landmark in couplet.LANDMARKS:
        assert couplet.constants(landmark, digits=3).verdict == "proved"


def test_an_exact_value_says_so():
    exact = {name: value.exact for name, value in couplet.constants("L", "heyman", digits=6).items() if value.exact}
    assert any("√" in text or "/" in text for text in exact.values()), exact


def test_find_takes_the_words_of_its_page():
    assert couplet.find("half opening", friction=1, digits=5) == couplet.find("half_opening", friction=1, digits=5)


def test_find():
    found = couplet.find("half_opening", friction="0.5", thickness="0.2", digits=20)
    assert found.verdict == "found" and found.value.quantity == "half_opening"
    assert couplet.assess(found.value.text_lower, "0.5", "0.2").verdict == "stands"
    assert couplet.assess(found.value.text_upper, "0.5", "0.2").verdict == "falls"
    assert "no wider one" in found.proved
    line = couplet.find("boundary", "rrs/rsr", friction="1.6", digits=10)
    assert line.modes == ("[r,r,s]", "[r,s,r]")
    none = couplet.find("boundary", "rsr/rs", half_opening=1.0)
    assert (none.verdict, none.value) == ("nothing", None) and "there is none" in none.proved
    again = couplet.find("boundary", list(line.modes), friction="1.6", digits=10)
    assert again.value == line.value and again in {again}
    nothing = couplet.find("friction", half_opening="80deg", thickness="0.01")
    assert (nothing.verdict, nothing.value) == ("nothing", None)
    assert couplet.find("mu", half_opening="80deg", digits=5).value.quantity == "friction"


def test_an_asymmetric_solution_is_certified_by_the_kind_that_it_is():
    arch = {"half_opening": "2.3", "friction": "1.05", "digits": 20}
    made = couplet.certify(**arch, asymmetric=True)
    kind = json.loads(made)["claim"]["asymmetric"]["mode"]
    assert couplet.certify(**arch, asymmetric=kind) == made
    for other in {"inner_sliding", "shoulder_opening", "shoulder_sliding"} - {kind}:
        with pytest.raises(couplet.UndecidedError):
            couplet.certify(**arch, asymmetric=other)
    with pytest.raises(couplet.UndecidedError, match="no asymmetric solution is found"):
        couplet.certify(half_opening="80deg", friction="0.6", asymmetric=True)


def test_a_certificate_is_accepted_and_a_spoiled_one_is_not():
    for made in [
        couplet.certify("S", weight="heyman", digits=20),
        couplet.certify(half_opening="80deg", friction="0.35", digits=20),
        couplet.certify(half_opening="80deg", friction="0.35", thickness="0.05", digits=20),
        couplet.certify(half_opening="2.3", friction="1.05", asymmetric=True, digits=20),
    ]:
        checked = couplet.check(made)
        assert (checked.verdict, checked.digits) == ("accepted", 20)
        assert couplet.check(made.encode(), engine="mpfr").texts == checked.texts
        assert couplet.check(memoryview(made.encode())).verdict == "accepted"
        spoiled = json.loads(made)
        name = next(iter(spoiled["values"]), None) if isinstance(spoiled["values"], dict) else 0
        spoiled["values"][name]["value"] = "0.5"
        refused = couplet.check(json.dumps(spoiled))
        assert refused.verdict == "refused" and refused.reason


def test_a_certificate_is_read_from_its_file(tmp_path):
    file = tmp_path / "T.json"
    file.write_text(couplet.certify("T", digits=12))
    assert couplet.check(file).texts["thickness"] == couplet.constants("T", digits=12)["thickness"].text


def test_claims():
    (misprint,) = couplet.prove("eq-16")
    assert (misprint.verdict, misprint.as_printed) == ("refuted", "refuted")
    assert misprint.corrected and misprint.counterexample and misprint.derivation
    assert "eq-16" in [name for name, _, _ in couplet.claims()]


def test_a_drawing():
    state = couplet.state("80deg", "0.35", digits=5)
    assert state._repr_svg_().startswith("<svg") and "80deg" in state.svg()
    assert couplet.assess("80deg", "0.35", "0.2", digits=5).svg() != state.svg()
    assert "It stands at no thickness: it slides" in couplet.state("80deg", "0.1", digits=5)._repr_svg_()


def test_answers_can_be_sent_to_other_processes():
    for answer in [
        couplet.state("80deg", "0.35"),
        couplet.assess("80deg", "0.35", "0.1"),
        couplet.constants("T"),
        couplet.state("80deg", "0.35").thickness,
        couplet.voussoirs("pi/2", "0.6", 11, thickness="0.12"),
        couplet.voussoirs(friction="0.6", joints=["0", "0.5", "1"]),
        couplet.tilt("pi/2", "0.6", "0.15", digits=9),
        couplet.state(span="10m", rise="3m", friction=0.6),
    ]:
        for other in (pickle.loads(pickle.dumps(answer)), copy.deepcopy(answer)):
            assert repr(other) == repr(answer)
            assert other == answer and hash(other) == hash(answer) and len({other, answer}) == 1


def test_answers_are_equal_where_they_say_the_same():
    first = couplet.state("80deg", "0.35", digits=10)
    assert first == couplet.state("80deg", "0.35", digits=10)
    others = [
        couplet.state("80deg", "0.25", digits=10),
        couplet.state("80deg", "0.35", digits=11),
        # The same number, which is not the same question.
        couplet.state("80deg", "0.350", digits=10),
        couplet.assess("80deg", "0.35", "0.1", digits=10),
    ]
    assert not any(first == other for other in [*others, first.thickness, None, "stands"])
    assert first.thickness != others[0].thickness and first.thickness != first.thrust
    assert first.thickness != first.thickness.double
    with pytest.raises(TypeError):
        first.thickness < others[0].thickness
    (decision,) = couplet.prove("eq-8")
    assert pickle.loads(pickle.dumps(decision)) == decision == couplet.prove("eq-8")[0]
    assert decision not in couplet.prove("eq-16") and len({decision, *couplet.prove("eq-8")}) == 1


def test_other_numbers():
    value = couplet.state("80deg", "0.35", digits=40).thickness
    mpmath = pytest.importorskip("mpmath")
    mpmath.mp.dps = mpmath.iv.dps = 50
    interval = value.mpi()
    assert interval.a <= value.mpf() <= interval.b
    assert interval.delta < mpmath.mpf(10) ** -39
    flint = pytest.importorskip("flint")
    flint.ctx.prec = 200
    ball = value.arb()
    assert ball.contains(flint.arb(value.text)) and ball.rad() < flint.arb("1e-39")


WRONG = [
    (lambda: couplet.state(4, 1), "the half opening 4 is not between 0 and pi (180deg); did you mean 4deg?"),
    (lambda: couplet.state("abc", 1), "'abc' is not a number: give a decimal (0.1), a fraction"),
    (lambda: couplet.state(1, "0,5"), "has a comma"),
    (lambda: couplet.state(1, -1.0), "the friction -1 is negative"),
    (lambda: couplet.state(1, -1.4), "the friction -1.4 is negative"),
    (lambda: couplet.state(1, "-7/5000000"), "the friction -7/5000000 is negative"),
    (lambda: couplet.assess(1, 1, 2.1), "the thickness 2.1 is not between 0 and 2"),
    (lambda: couplet.state(1, float("nan")), "'nan' is not a friction"),
    (lambda: couplet.state(float("nan"), 1), "'nan' is not a number"),
    (lambda: couplet.state(1, 1, digits=0), "digits are a whole number from 1 to 1000000"),
    (lambda: couplet.state(1, 1, digits=1.5), "digits are a whole number from 1 to 1000000"),
    (lambda: couplet.state(1, 1, weight="heymann"), 'a weight is one of heyman, milankovitch (did you mean "heyman"?)'),
    (lambda: couplet.state(10**5000, 1), "the half opening is too long"),
    (lambda: couplet.assess(1, 1, 3), "the thickness 3 is not between 0 and 2"),
    (lambda: couplet.assess(1, 1, "pi/4"), "the thickness pi/4 is no ratio"),
    (lambda: couplet.constants("Q"), "a landmark is one of T, S, J, B, l, L, sb"),
    (lambda: couplet.constants("T", "both"), "one weight at a time"),
    (lambda: couplet.constants("T", digits=10**7), "digits are a whole number from 1 to 1000000"),
    (lambda: couplet.constants("T", quantities=["thiknes"]), 'did you mean "thickness"?'),
    (lambda: couplet.constants("T", threads=-1), "threads are a whole number from 1 to 1024"),
    (lambda: couplet.prove("eq-8", threads=1.5), "threads are a whole number"),
    (lambda: couplet.find("thrust"), "what is found is one of"),
    (lambda: couplet.find(None), "what is found is one of"),
    (lambda: couplet.find("friction", friction=1), "friction does not belong here"),
    (lambda: couplet.find("friction"), "half_opening is missing"),
    (lambda: couplet.find("boundary", friction=1), "the pair of modes is missing"),
    (lambda: couplet.find("boundary", "rrs/rsr"), "friction or half_opening is missing"),
    (lambda: couplet.find("boundary", "rrs/rsr", friction=1, half_opening=1), "give friction or half_opening; the other"),
    (lambda: couplet.state(None, 1), "half_opening is missing"),
    (lambda: couplet.find("boundary", "rrs/rsr", friction="inf"), "needs a limited friction"),
    (lambda: couplet.find("half_opening", friction=1, thickness=3), "the thickness 3 is not between 0 and 2"),
    (lambda: couplet.certify("T", friction=1), "belong to an arch"),
    (lambda: couplet.certify("T", asymmetric=True), "belong to an arch"),
    (lambda: couplet.certify(friction=1), "are missing"),
    (lambda: couplet.certify(friction=1, asymmetric=True), "are missing"),
    (lambda: couplet.certify(half_opening=1, friction="inf", asymmetric=True), "needs a limited friction"),
    (lambda: couplet.certify(half_opening=1, friction=1, thickness=1, asymmetric=True), "has its own thickness"),
    (lambda: couplet.certify(half_opening=1, friction=1, asymmetric="rrs"), "asymmetric: it is one of inner_sliding, "),
    (lambda: couplet.certify(half_opening=1, friction=1, asymmetric=None), "asymmetric: it is one of inner_sliding, "),
    (lambda: couplet.check(b"{}", engine="gmp"), "an arithmetic is one of astro, mpfr"),
    (lambda: couplet.check("proofs/T.json"), "'proofs/T.json' is no JSON; for the file of that name give pathlib.Path("),
    (lambda: couplet.check("T.json"), "'T.json' is no JSON"),
    (lambda: couplet.check(b"{}", engine="gmp"), "an arithmetic is one of astro, mpfr"),
    (lambda: couplet.prove("eq-99"), "unknown claim 'eq-99' (did you mean \"eq-9\"?); couplet.claims() lists the claims"),
    (lambda: couplet.state("\ud800", 1), "'\\ud800' is no text"),
    (lambda: couplet.find("boundary", "\ud800", friction=1), "'\\ud800' is no text"),
    (lambda: couplet.prove("\ud800"), "'\\ud800' is no text"),
]


@pytest.mark.parametrize(("question", "sentence"), WRONG)
def test_bad_input_is_one_sentence(question, sentence):
    with pytest.raises(couplet.CoupletError) as caught:
        question()
    assert sentence in str(caught.value) and "\n" not in str(caught.value) and words_of_a_shell(caught.value) == []
    assert isinstance(caught.value, ValueError)


class OddFraction(Fraction):
    """Its numerator is no whole number."""

    numerator = "x"


def test_a_quantity_that_is_no_text_is_not_there():
    with pytest.raises(KeyError):
        couplet.constants("T", digits=5)["\ud800"]


@pytest.mark.parametrize("value", [[1], 1j, True, b"1", object(), OddFraction(1, 2)])
def test_what_is_no_number_is_a_type_error(value):
    with pytest.raises(TypeError, match="half opening is a str, int, float, Fraction or Decimal"):
        couplet.state(value, 1)


@pytest.mark.parametrize("value", [3, None, ["a"]])
def test_what_is_no_certificate_is_a_type_error(value):
    with pytest.raises(TypeError, match="a certificate is bytes, a str or the path of its file, not"):
        couplet.check(value)


def test_a_certificate_that_is_no_text_is_refused():
    assert couplet.check("\ud800").verdict == couplet.check(b"\xff").verdict == "refused"


def test_a_value_shows_no_digit_that_is_not_proved():
    value = couplet.state("80deg", "0.35", digits=5).thickness
    with pytest.raises(ValueError, match="do not tell"):
        f"{value:.20f}"
    assert f"{value}" == value.text


def test_a_value_is_formatted_as_it_is_proved():
    value = couplet.state("80deg", "0.6", digits=12).thickness
    assert value.text == "0.0686504633304"
    assert (f"{value}", f"{value:>16}|", f"{value:.4f}", f"{value:.3e}") == (value.text, " 0.0686504633304|", "0.0687", "6.865e-2")
    # Of this thickness 17 digits are 0.068650463330373536.
    with pytest.raises(ValueError, match="do not tell how '.13f' rounds it: it is between 0.0686504633303 and 0.0686504633304"):
        format(value, ".13f")
    with pytest.raises(ValueError, match="would cut a number off; .* '.5f'"):
        format(value, ".5")
    assert f"{couplet.constants('L', quantities='friction')['friction']:8.2f}" == "     inf"
