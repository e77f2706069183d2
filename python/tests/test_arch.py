"""An arch by every name that it may have, in metres, of stones, tilted; as the command takes it."""

import json
import re
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest
from shell import words_of_a_shell

import couplet

METRES = {"span": "10m", "rise": "3m", "friction": "0.6"}


def command(name, **arch):
    """The command with an arch; its exit code, what it writes, and its sentence as a function says it."""
    options = [f"--{key.replace('_', '-')}={value}" for key, value in arch.items()]
    line = [sys.executable, "-m", "couplet", *name.split(), *options]
    done = subprocess.run(line, capture_output=True, text=True)
    sentence = done.stderr.removeprefix("couplet: ").strip()
    return done.returncode, done.stdout, re.sub("; for example: .*", "", sentence)


def same(sentence):
    """A sentence, whether its names are options or keywords."""
    sentence = re.sub("^invalid value .* for '<WHAT>': ", "", str(sentence))
    sentence = re.sub(r"`couplet (\w+)`", r"couplet.\1", sentence)
    return sentence.replace("--", "").replace("_", "-")


def test_an_arch_in_metres():
    state = couplet.state(**METRES, density="2400kg/m3", depth="1m", digits=12)
    told = json.loads(command("state", **METRES, density="2400kg/m3", depth="1m", digits=12, format="json")[1])
    for name in ["span_m", "rise_m", "radius_m", "least_thickness_m", "weight_kn", "thrust_kn"]:
        value = getattr(state, name)
        assert value == state.values[name] and value.text == told[name]["value"]
        assert value.unit == ("kN" if name.endswith("kn") else "m")
        low, high = value.fractions()
        assert low <= Fraction(value.text) <= high and value.lower <= value.double <= value.upper
    assert state.measured_at == told["measured_at"] == "intrados"
    assert state.thickness.unit == "r" and state.thrust.unit == "w r" and state.rotation_joint.unit == "rad"
    assert state.values["half_opening_degrees"].unit == "deg" and state.sliding_friction.unit == "1"
    assert state.intrinsic_thrust.unit == "gamma d r^2"
    other = couplet.state(**METRES, measured_at="centreline", digits=12)
    assert other.radius_m.text != state.radius_m.text and other.thrust_kn is None
    plain = couplet.state("2atan(3/5)", "0.6", digits=12)
    assert plain.thickness.text == state.thickness.text
    assert (plain.radius_m, plain.measured_at) == (None, None)


def test_metres_that_stay_open_are_not_the_arch():
    state = couplet.state("1e-400", "0.6", radius="1m", digits=5)
    assert state.verdict == "stands" and state.thickness is not None and state.radius_m is None
    assert list(state.open) == ["radius_m"] and state.open["radius_m"] in state.reason
    assert couplet.state(**METRES, digits=5).open == {}


def test_an_arch_of_a_thickness_in_metres():
    arch = couplet.assess(**METRES, thickness="60cm", density="24kN/m3", depth="1m", digits=10)
    told = json.loads(command("assess", **METRES, thickness="60cm", density="24kN/m3", depth="1m", digits=10, format="json")[1])
    for name in ["geometric_safety", "thickness_m", "radius_m", "least_thickness_m", "least_thrust_kn", "largest_thrust_kn"]:
        assert getattr(arch, name).text == told[name]["value"]
    assert arch.thickness_m.text == "0.6"
    of_radius = couplet.assess("90deg", "0.6", "60cm", radius="5m", measured_at="centreline", digits=10)
    assert of_radius.geometric_safety == couplet.assess("2atan(1)", "0.6", Fraction(3, 25), digits=10).geometric_safety


def test_forces_of_stones_and_of_a_tilted_arch():
    given = dict(**METRES, thickness="60cm", density="24kN/m3", depth="1m", digits=10)
    stones = couplet.voussoirs(**given, stones=21)
    told = json.loads(command("voussoirs", **given, stones=21, format="json")[1])
    for name in ["least_thickness_m", "least_thrust_kn", "largest_thrust_kn", "weight_kn"]:
        assert getattr(stones.assessment, name).text == told[name]["value"]
    least = {name: value for name, value in given.items() if name != "thickness"}
    assert couplet.voussoirs(**least, stones=21).thrust_kn.unit == "kN"
    tilted = couplet.tilt(**given, tilt="5deg")
    told = json.loads(command("assess", **given, tilt="5deg", format="json")[1])
    for name in ["thrust_kn", "vertical_force_kn", "largest_tilt_degrees"]:
        assert getattr(tilted, name).text == told[name]["value"]
    survey = couplet.assess(**{**given, "thickness": "60cm±1cm"})
    assert [of["quantity"] for of in survey["ranges"]][-1] == "weight_kn"


def test_what_is_found_and_certified_in_metres():
    found = couplet.find("friction", span="10m", rise="3m", thickness="60cm", digits=10)
    assert couplet.assess(span="10m", rise="3m", friction=found.value.text_upper, thickness="60cm").verdict == "stands"
    assert couplet.assess(span="10m", rise="3m", friction=found.value.text_lower, thickness="60cm").verdict == "falls"
    made = couplet.certify(**METRES, thickness="60cm", digits=12)
    assert couplet.check(made).verdict == "accepted"
    assert made == command("certify arch", **METRES, thickness="60cm", digits=12)[1]


def test_an_angle_instead_of_a_coefficient():
    assert couplet.state(1, friction_angle="31deg", digits=9).thickness == couplet.state(1, "31deg", digits=9).thickness
    assert couplet.find("half_opening", friction_angle="0.5", digits=5).value.quantity == "half_opening"


def test_stones():
    arch = couplet.voussoirs("pi/2", "0.6", 11, thickness="0.12", digits=8)
    told = json.loads(command("voussoirs", half_opening="pi/2", friction="0.6", stones=11, thickness="0.12", digits=8, format="json")[1])
    for name in ["thickness", "thrust", "rotation_joint", "continuous_thickness"]:
        value = getattr(arch, name)
        assert value.text == told[name]["value"] and value.lower <= value.double <= value.upper
    assert (arch.verdict, arch.mode, arch.stones, arch.contacts) == ("stands", told["mode"], 11, tuple(told["contacts"]))
    assert arch.loss == (told["loss"]["lower"], told["loss"]["upper"]) and arch.relative_loss
    assert not arch.may_move and couplet.voussoirs("pi/2", "0.6", 41, digits=8).may_move
    assert arch.assessment.verdict == "stands"
    for name in ["geometric_safety", "required_friction", "friction_safety"]:
        assert getattr(arch.assessment, name).text == told["assessment"][name]["value"]
    assert arch.assessment.least_thrust.text == told["assessment"]["least_thrust"]["thrust"]["value"]
    assert arch.assessment.least_thickness == couplet.assess("pi/2", "0.6", "0.12", stones=11, digits=8).least_thickness
    assert couplet.state("pi/2", "0.6", stones=11, digits=8).thickness == arch.thickness
    assert couplet.assess("pi/2", "0.6", arch.thickness.text_lower, stones=11, digits=8).verdict == "falls"
    assert couplet.assess("pi/2", "0.6", arch.thickness.text_upper, stones=11, digits=8).verdict == "stands"


def test_a_range_of_stones():
    found = couplet.voussoirs("80deg", "0.6", range(5, 9), digits=10)
    assert [arch.stones for arch in found] == [arch.given["stones"] for arch in found] == [5, 6, 7, 8]
    assert [arch.thickness for arch in found] == [couplet.voussoirs("80deg", "0.6", n, digits=10).thickness for n in range(5, 9)]
    # Stones of one angle, by their joints.
    joints = couplet.voussoirs(friction="0.6", joints=["0", "0.5", "1"], digits=10)
    assert joints.thickness == couplet.voussoirs(1, "0.6", 4, digits=10).thickness
    assert joints.joints == ("0", "0.5", "1") and joints.stones is None
    assert joints == couplet.voussoirs(friction="0.6", joints=("0", "0.5", "1"), digits=10) and hash(joints)


def test_joints_and_numbers_of_numpy():
    np = pytest.importorskip("numpy")
    joints = couplet.voussoirs(friction=np.float64(0.5), joints=np.array([0.0, 0.5, 1.0]), digits=10)
    assert joints.thickness == couplet.voussoirs(friction=0.5, joints="0,0.5,1", digits=10).thickness
    assert couplet.voussoirs(1, np.float64(0.5), joints=None, stones=np.int64(4), digits=10).thickness == joints.thickness
    for question in [lambda: couplet.assess(1, 1, np.array([0.1, 0.2])), lambda: couplet.state(1, np.array([0.1]))]:
        with pytest.raises(TypeError, match="is a str, int, float"):
            question()


def test_stones_that_stand_at_no_thickness():
    arch = couplet.voussoirs("80deg", "0.1", 11)
    assert (arch.verdict, arch.reason, arch.thickness, arch.mode, arch.contacts) == ("falls", "sliding", None, None, ())


def test_a_tilted_arch():
    arch = couplet.tilt("pi/2", "0.6", "0.15", digits=10)
    told = json.loads(command("assess", half_opening="pi/2", friction="0.6", thickness="0.15", tilt=0, digits=10, format="json")[1])
    assert arch.verdict == "stands" and arch.largest_tilt.text == told["largest_tilt"]["value"]
    assert arch.limited_by == tuple(told["limited_by"]) and arch.may_move
    assert couplet.tilt("pi/2", "0.6", "0.15", arch.largest_tilt.text_lower).verdict == "stands"
    assert couplet.assess("pi/2", "0.6", "0.15", tilt=arch.largest_tilt.text_upper).verdict == "falls"
    assert couplet.tilt("pi/2", "0.6", "0.15", stones=11, digits=10).largest_tilt.double > arch.largest_tilt.double
    assert couplet.tilt("pi/2", "0.6", "0.01").verdict == "falls"
    picture = arch.svg()
    assert picture == arch._repr_svg_() and "couplet assess --half-opening=pi/2 --friction=0.6" in picture and "gravity" in picture
    assert "It does not stand without tilt either" in couplet.tilt("pi/2", "0.6", "0.01").svg()


def test_pictures():
    assert "10 m" in couplet.state(**METRES, digits=5).svg()
    assert couplet.voussoirs("pi/2", "0.6", 11).svg() != couplet.state("pi/2", "0.6").svg()
    assert couplet.voussoirs(friction="0.6", joints="0,0.5,1").svg() is None


REFUSED = [
    ("state", couplet.state, {}),
    ("state", couplet.state, {"half_opening": 1}),
    ("state", couplet.state, {"half_opening": 1, "friction": 1, "thickness": "0.1"}),
    ("state", couplet.state, {"half_opening": 1, "friction": 1, "tilt": "0.1"}),
    ("state", couplet.state, {"half_opening": 1, "friction": 1, "span": "1m"}),
    ("state", couplet.state, {"half_opening": 1, "friction": 1, "friction_angle": "31deg"}),
    ("state", couplet.state, {"friction": 1, "span": "10m"}),
    ("state", couplet.state, {"friction": 1, "span": "10", "rise": "3m"}),
    ("state", couplet.state, {"half_opening": 1, "friction": 1, "density": "24kN/m3", "depth": "1m"}),
    ("state", couplet.state, {"half_opening": 1, "friction": 1, "measured_at": "intrados"}),
    ("state", couplet.state, {"half_opening": 1, "friction": 1, "radius": "1m", "measured_at": "top"}),
    ("state", couplet.state, {"half_opening": 4, "friction": 1, "radius": "1m"}),
    ("state", couplet.state, {"half_opening": 1, "friction": 1, "stones": 1}),
    ("state", couplet.state, {"half_opening": 1, "friction": 1, "stones": 11, "joints": "0,1"}),
    ("state", couplet.state, {"half_opening": 1, "friction": 1, "stones": 11, "thickness": "0.1"}),
    ("assess", couplet.assess, {"half_opening": 1, "friction": 1}),
    ("assess", couplet.assess, {"half_opening": 1, "friction": 1, "thickness": "60cm"}),
    ("assess", couplet.assess, {"span": "10m", "rise": "3m", "friction": 1, "thickness": "0.1"}),
    ("assess", couplet.assess, {"half_opening": 1, "friction": 1, "thickness": "0.1", "tilt": "-1"}),
    ("assess", couplet.assess, {"half_opening": 1, "friction": 0, "thickness": "0.1", "tilt": "0.1"}),
    ("assess", couplet.assess, {**METRES, "thickness": "60cm", "density": "24kN/m3", "tilt": 0}),
    ("assess", couplet.tilt, {"half_opening": 1, "friction": 1, "tilt": 0}),
    ("assess", couplet.tilt, {"half_opening": 1, "friction": 1, "thickness": "0.1", "tilt": 0, "stones": 3001}),
    ("voussoirs", couplet.voussoirs, {"half_opening": 1, "friction": 1}),
    ("voussoirs", couplet.voussoirs, {**METRES, "stones": 11, "density": "24kN/m3"}),
    ("find friction", couplet.find, {"half_opening": 1, "stones": 11}),
    ("find friction", couplet.find, {"half_opening": 1, "tilt": 0}),
    ("find friction", couplet.find, {}),
    ("find friction", couplet.find, {"half_opening": 1, "friction": 1}),
    ("find half_opening", couplet.find, {}),
    ("find thickness", couplet.find, {"friction": 1}),
    ("find thrust", couplet.find, {"friction": 1}),
    ("find boundary rrs/rsr", couplet.find, {}),
    ("find boundary rrs/rsr", couplet.find, {"friction": 1, "thickness": "0.1"}),
    ("certify state", couplet.certify, {"half_opening": 1, "friction": 1, "stones": 11}),
    ("certify state", couplet.certify, {"half_opening": 1, "friction": 1, "tilt": 0}),
    ("certify state", couplet.certify, {"half_opening": 1}),
]


@pytest.mark.parametrize(("name", "function", "arch"), REFUSED)
def test_a_refusal_is_that_of_the_command_word_for_word(name, function, arch):
    code, _, sentence = command(name, **arch)
    with pytest.raises(couplet.CoupletError) as caught:
        function(*name.split()[1:] if function is couplet.find else (), **arch)
    assert code == 2 and same(caught.value) == same(sentence) != ""
    assert words_of_a_shell(caught.value) == []


@pytest.mark.parametrize(
    ("question", "sentence"),
    [
        (lambda: couplet.state(1, 1, stones=range(2, 9)), "couplet.voussoirs tells"),
        (lambda: couplet.state(1, 1, stones="2..9"), "range(2, 201)"),
        (lambda: couplet.voussoirs(1, 1, range(2, 9, 2)), "all numbers from its first to its last"),
        (lambda: couplet.voussoirs(1, 1, range(2, 9), thickness="0.1"), "thickness"),
        (lambda: couplet.voussoirs(1, 1, 9, tilt=0), "couplet.tilt"),
    ],
)
def test_what_python_alone_says(question, sentence):
    with pytest.raises(couplet.CoupletError) as caught:
        question()
    assert sentence in str(caught.value) and "\n" not in str(caught.value)


def test_what_has_another_type():
    for question in [
        lambda: couplet.state(1, 1, stones=1.5),
        lambda: couplet.state(1, 1, radius="1m", measured_at=1),
        lambda: couplet.voussoirs(friction=1, joints=[None]),
        lambda: couplet.assess(1, 1, [0.1]),
    ]:
        with pytest.raises(TypeError):
            question()


def questions():
    """The questions that every door is asked: what is asked, its fields, whether it makes sense."""
    path = Path(__file__).parents[2] / "tests" / "questions.txt"
    for line in path.read_text().splitlines():
        if not line.startswith("#"):
            question, *fields = line.removeprefix("! ").split(" ")
            yield question, dict(field.split("=", 1) for field in fields), not line.startswith("!")


@pytest.mark.parametrize(("question", "arch", "makes_sense"), list(questions()))
def test_every_question_has_the_answer_of_the_command(question, arch, makes_sense):
    ask = {"state": couplet.state, "assess": couplet.assess}[question]
    code, told, sentence = command(question, **arch, digits=12, format="json")
    if not makes_sense:
        assert code == 2
        with pytest.raises(couplet.CoupletError) as refused:
            ask(**arch, digits=12)
        assert same(refused.value) == same(sentence)
        return
    told, found = json.loads(told), ask(**arch, digits=12)
    values = {name: value["value"] for name, value in told.items() if isinstance(value, dict) and "value" in value}
    assert values and all(found.values[name].text == text for name, text in values.items())
    stands = told.get("stands", told.get("can_stand"))
    assert (found.verdict == "stands") == stands
