"""What the command makes, as functions: the same as in a shell."""

import json
import math
import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

import pytest
from shell import words_of_a_shell

import couplet
from couplet._asked import spoken


def command(*arguments):
    return subprocess.run([sys.executable, "-m", "couplet", *arguments], capture_output=True, text=True)


MINE = {"half_opening": [1.3, 1.3, 4.0, 2.5], "friction": [0.5, 0.5, 0.5, 1.5], "thickness": [0.0523, 0.0417, 1.0, float("nan")]}
VERDICTS = ["correctly rounded", "thinner than the least thickness", "bad row", "claims that an arch falls which stands"]


def test_rows_are_judged(tmp_path):
    judged = couplet.judge(MINE)
    assert [row["verdict"] for row in judged] == VERDICTS and len(judged) == 4 and judged.accepted == 1
    assert "did you mean 4deg?" in judged[2]["reason"] and judged[1]["numbers"]["thickness"]["error"] == "0.0106"
    assert judged.verdicts == dict.fromkeys(VERDICTS, 1) and json.loads(json.dumps(judged.to_dict()))["accepted"] == 1
    rows = [dict(zip(MINE, row)) for row in zip(*MINE.values())]
    assert couplet.judge(rows).rows == judged.rows
    file = tmp_path / "mine.csv"
    file.write_text("half_opening,friction,thickness\n" + "".join(f"{a},{m},{t}\n" for a, m, t in zip(*MINE.values())))
    assert [row["verdict"] for row in couplet.judge(file)] == VERDICTS
    assert command("judge", str(file), "--format", "jsonl", "--inputs", "double").stdout.splitlines() == [
        json.dumps(row, separators=(",", ":")) for row in judged
    ]


def test_doubles_are_judged_as_doubles():
    # At the nearest double of 2.45 and 1.35 the least thickness differs from that of the decimals in the 16th digit.
    value = couplet.state(2.45, 1.35, digits=17).thickness.double
    row = {"half_opening": [2.45], "friction": [1.35], "thickness": [value]}
    assert couplet.judge(row)[0]["numbers"]["thickness"]["nearest_double"]
    assert not couplet.judge(row, inputs="exact")[0]["numbers"]["thickness"]["nearest_double"]


def test_other_names_and_other_demands():
    theirs = {"alpha_deg": [80.0], "mu": [0.5], "t": [0.0653], "run": ["a7"]}
    columns = {"alpha_deg": "half_opening:deg", "mu": "friction", "t": "thickness"}
    judged = couplet.judge(theirs, columns=columns, keep="run", inputs="exact")
    assert judged[0]["kept"] == {"run": "a7"} or judged[0].get("run") == "a7"
    as_listed = [f"{name}={ours}" for name, ours in columns.items()]
    assert couplet.judge(theirs, columns=as_listed, keep=["run"], inputs="exact", threads=1).rows == judged.rows
    truth = couplet.state("80deg", "0.5", digits=6).thickness.text
    judged = couplet.judge({"half_opening": ["80deg"], "friction": ["0.5"], "thickness": [truth]}, inputs="exact")
    assert judged.accepted == 1
    strict = couplet.judge({"half_opening": ["80deg"], "friction": ["0.5"], "thickness": [truth]}, inputs="exact", accept=8)
    assert strict.accepted == 0
    heyman = couplet.judge({"half_opening": ["80deg"], "friction": ["0.5"], "thickness": [truth]}, inputs="exact", weight="heyman")
    assert heyman[0]["weight"] == "heyman" and heyman.accepted == 0


def test_what_states_answers_is_accepted():
    pytest.importorskip("numpy")
    arches = [1.3, 2.5, 1.3], [0.5, 1.5, 0.01]
    columns = couplet.states_columns(*arches, quantities=["thickness", "thrust"])
    judged = couplet.judge(columns)
    assert judged.accepted == 3, judged
    assert [row["claimed_mode"] for row in judged] == ["[r,r,r]", "[r,r,s]", None]
    columns["mode"][0] = couplet.Mode.SRR
    assert couplet.judge(columns)[0]["verdict"] == "wrong mode"
    judged = couplet.judge(couplet.states_columns(1.0, 0.5, [0.1, 0.01]))
    assert judged.accepted == 2 and [row["claimed_stands"] for row in judged] == [True, False]


def test_frames_are_judged():
    pytest.importorskip("numpy")
    pandas = pytest.importorskip("pandas")
    assert couplet.judge(pandas.DataFrame(MINE)).rows == couplet.judge(MINE).rows
    assert couplet.judge(couplet.states_frame([1.3, 2.5, 1.3], [0.5, 1.5, 0.01])).accepted == 3
    assert couplet.judge(couplet.states_frame(1.0, 0.5, [0.1, 0.01])).accepted == 2
    arrow = pytest.importorskip("pyarrow")
    assert couplet.judge(arrow.table(MINE)).rows == couplet.judge(MINE).rows


def test_pictures(tmp_path):
    picture = couplet.draw("80deg", "0.35", half=True, arrows=True, amplitude=0.2)
    assert picture.svg == str(picture) == picture._repr_svg_() and picture.svg.startswith("<svg")
    words = ["draw", "--half-opening=80deg", "--friction=0.35", "--weight=milankovitch", "--half", "--arrows", "--amplitude=0.2"]
    assert picture.svg.count("</svg>") == 1 and len(picture.svg) == len(command(*words, "--format=svg").stdout)
    picture.save(tmp_path / "arch.svg")
    assert (tmp_path / "arch.svg").read_text().startswith("<svg")
    couplet.draw("80deg", "0.35").save(tmp_path / "arch.dxf")
    assert "SECTION" in (tmp_path / "arch.dxf").read_text()
    assert couplet.draw("80deg", "0.35").to_dict()["schema"].startswith("couplet.draw")
    assert couplet.draw(span="10m", rise="3m", thickness="60cm", friction=0.6, stones=21).svg != couplet.draw("80deg", "0.35").svg
    assert couplet.draw(at="T", mode="rrs").svg != couplet.draw(at="T").svg
    with pytest.raises(couplet.CoupletError, match="the end .txt tells no format"):
        picture.save(tmp_path / "arch.txt")
    assert not list(tmp_path.glob("*.txt"))
    with pytest.raises(OSError, match="cannot write"):
        picture.save("/dev/null/arch.svg")


def test_figures_and_maps():
    assert couplet.figure(1).svg != couplet.figure(9, weight="heyman").svg
    map_ = couplet.map(plane="opening-friction", thickness=["0.1", 0.25], mark=["80deg,0.6", "70deg,0.3"], tolerance=1e-3)
    assert map_.svg.startswith("<svg") and map_.svg.count("70deg") + map_.svg.count("70°") > 0


def test_pictures_have_the_options_of_the_command(tmp_path):
    assert "serif" in couplet.draw("80deg", "0.35", font="serif").svg
    narrow = couplet.draw("80deg", "0.35", width="84mm", font_size="6pt", no_caption=True, no_title=True, threads=1)
    assert 'width="238' in narrow.svg and 'id="caption"' not in narrow.svg
    assert '<g id="caption">\n<text' in couplet.draw("80deg", "0.35").svg
    for picture in [narrow, couplet.figure(7, width="84mm", no_caption=True), couplet.map(curve="limit", lines=True, tolerance=1e-2)]:
        picture.save(tmp_path / "picture.png")
        assert (tmp_path / "picture.png").read_bytes().startswith(b"\x89PNG")
        picture.save(tmp_path / "picture.pdf")
        assert (tmp_path / "picture.pdf").read_bytes().startswith(b"%PDF")
    assert "half opening 78deg to 80deg" in couplet.draw(("78deg", "80deg"), "0.6", thickness=("0.1", "0.12")).svg
    assert couplet.draw("130deg", along=("friction", "0.2..3")).svg.count("[") >= 3
    difference = couplet.map(difference=True, tolerance=1e-2)
    assert difference.to_dict()["schema"].startswith("couplet.map_difference") and difference.svg != couplet.map(tolerance=1e-2).svg


def test_they_run_within_this_process(monkeypatch):
    monkeypatch.setattr(subprocess, "run", None)
    handler = signal.getsignal(signal.SIGINT)
    arches = [("80deg", f"0.{number}") for number in range(3, 9)]
    with ThreadPoolExecutor(6) as threads:
        pictures = list(threads.map(lambda arch: couplet.draw(*arch, threads=1).svg, arches))
    for (_, friction), picture in zip(arches, pictures):
        assert f"--friction={friction}" in picture
    assert couplet.sample(2) and couplet.audit(only="T", weight="heyman") and signal.getsignal(signal.SIGINT) is handler


def test_a_curve():
    np = pytest.importorskip("numpy")
    line = couplet.curve("rrr/srr", tolerance="1e-3")
    told = json.loads(command("map", "--curve", "rrr/srr", "--tolerance", "1e-3", "--format", "json").stdout)["curves"][0]
    assert (line.name, line.weight, line.parameter, line.ends) == ("rrr/srr", "milankovitch", "half_opening", (told["from"], told["to"]))
    assert len(line) == len(told["nodes"]) == len(line["proved"]) and line.widest_tube == told["widest_tube"] <= 1e-3
    assert line["thickness_lower"].tolist() == [node["thickness_lower"] for node in told["nodes"]]
    inner = slice(1, -1)
    # The node is a double; the friction there is between the bounds.
    for alpha, low, high in list(zip(line["parameter"], line["friction_lower"], line["friction_upper"]))[inner][:5]:
        found = couplet.find("boundary", "rrr/srr", half_opening=float(alpha), digits=20).value
        assert low <= found.double <= high and low <= high
    assert np.isnan(line["sliding_joint_lower"]).all() and line["proved"].dtype == bool
    assert json.loads(json.dumps(line.to_dict(), allow_nan=False))["name"] == "rrr/srr"


def test_samples():
    arches = couplet.sample(5, hard=True, seed=3)
    assert arches == couplet.sample(5, hard=True, seed=3) != couplet.sample(5, hard=True, seed=4)
    assert len(arches) == 5 and "ordinary" not in {arch["family"] for arch in arches}
    truth = [couplet.state(arch["half_opening"], arch["friction"], weight=arch["weight"], digits=17) for arch in arches]
    claims = [{**arch, "thickness": state.thickness or "falls"} for arch, state in zip(arches, truth)]
    assert couplet.judge(claims, inputs="exact").accepted == 5


def test_unlimited_friction_is_a_number():
    arches = couplet.sample(200, hard=True)
    unlimited = [arch for arch in arches if arch["friction"] == "inf"]
    assert unlimited and all(arch["friction_double"] == math.inf for arch in unlimited)
    assert all(isinstance(arch["friction_double"], float) for arch in arches)
    claims = [{"half_opening": arch["half_opening"], "friction": arch["friction_double"], "can_stand": "yes"} for arch in unlimited]
    assert not [row for row in couplet.judge(claims) if row["verdict"] == "bad row"]


def test_assemblies():
    drawn = couplet.sample(2, assemblies=True)
    assert len(drawn) == 4 and drawn == couplet.sample(2, assemblies=True) and {one["stands"] for one in drawn} == {True, False}


def test_the_audit():
    told = couplet.audit(only=["T", "S"])
    assert {number["landmark"] for number in told["printed"]} == {"T", "S"} and told["comparisons"]
    assert {number["weight"] for number in couplet.audit(only="T", weight="heyman")["printed"]} == {"heyman"}


def test_a_scene(tmp_path):
    arches = {"half_opening": ["80deg", 2.0], "friction": "0.6", "digits": 9}
    scene = {"arches": [{**arches, "output": "arches.json"}, {**arches, "half_opening": "1"}]}
    ran = couplet.run(scene, tmp_path)
    assert ran.outputs == [str(tmp_path / "arches.json")] and ran.undecided is None and "1" in ran.text
    told = json.loads((tmp_path / "arches.json").read_text())
    assert told["arches"][0]["thickness"]["value"] == couplet.state("80deg", "0.6", digits=9).thickness.text
    again = couplet.run(scene, tmp_path, resume=True)
    assert again.outputs == ran.outputs
    assert json.loads(json.dumps(ran.to_dict()))["folder"] == str(tmp_path)
    file = tmp_path / "scene.toml"
    file.write_text('schema = "couplet.scene/1"\n[[arches]]\nhalf_opening = 1\nfriction = 0.5\nquantities = "thickness"\ndigits = 4\n')
    assert "0.01913" in couplet.run(file, tmp_path).text
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "arches.json").write_text("mine")
    with pytest.raises(couplet.CoupletError, match="overwrite"):
        couplet.run(scene, tmp_path / "other")
    assert couplet.run(scene, tmp_path / "other", overwrite=True).outputs


def test_the_faults_of_a_scene_name_its_keys(tmp_path):
    with pytest.raises(couplet.CoupletError) as caught:
        couplet.run({"arch": 1, "arches": [{"half_opening": 4, "friction": 1}], "digits": "x"}, tmp_path)
    said = str(caught.value).split("\n")
    assert len(said) == 3 and said[0].startswith("arch: unknown key") and said[1].startswith("arches.half_opening: ")
    assert said[2].startswith("digits: ") or said[0].startswith("digits: ")
    file = tmp_path / "scene.toml"
    file.write_text('schema = "couplet.scene/1"\narch = 1\n')
    with pytest.raises(couplet.CoupletError, match=r"scene.toml:2:1: unknown key"):
        couplet.run(file, tmp_path)


WRONG = [
    (lambda: couplet.judge({"x": [1]}), couplet.CoupletError, "half_opening"),
    (lambda: couplet.judge({"half_opening": [1], "friction": [1, 2]}), couplet.CoupletError, "do not fit each other"),
    (lambda: couplet.judge([]), couplet.CoupletError, ""),
    (lambda: couplet.judge("/nowhere/mine.csv"), OSError, "cannot read"),
    (lambda: couplet.judge(MINE, weight="mine"), couplet.CoupletError, "a weight is one of"),
    (lambda: couplet.judge(MINE, accept=0), couplet.CoupletError, "digits are a whole number"),
    (lambda: couplet.judge(3), TypeError, "rows are a frame"),
    (lambda: couplet.judge([3]), TypeError, "rows are a frame"),
    (lambda: couplet.draw(4, 1), couplet.CoupletError, "the half opening 4 is not between 0 and pi"),
    (lambda: couplet.draw(1, 1, tilt=0), couplet.CoupletError, "thickness is missing"),
    (lambda: couplet.draw(1, 1, span="1m"), couplet.CoupletError, "make a radius that is no exact number"),
    (lambda: couplet.draw("80deg", "0.5", amplitude=2), couplet.CoupletError, "an amplitude is a number from 0.001 to 1"),
    (lambda: couplet.draw("80deg", "0.5", at="T"), couplet.CoupletError, "half_opening"),
    (lambda: couplet.draw("\ud800", "0.5"), couplet.CoupletError, "is no text"),
    (lambda: couplet.draw("1\0", "0.5"), couplet.CoupletError, "is not a number"),
    (lambda: couplet.judge("1\0"), couplet.CoupletError, "of the code 0"),
    (lambda: couplet.draw(friction=1), couplet.CoupletError, "half_opening is missing"),
    (lambda: couplet.draw((1, 2), 1), couplet.CoupletError, "thickness is missing"),
    (lambda: couplet.draw((1, 2), 1, 0.1), TypeError, "positional"),
    (lambda: couplet.draw((1, 2), 1, thickness=0.1, half=True), couplet.CoupletError, "half is of a picture of one upright arch"),
    (lambda: couplet.draw(1, 1, width="84"), couplet.CoupletError, "width='84': a width is a length"),
    (lambda: couplet.draw(1, along="friction"), couplet.CoupletError, "2 values required for along but 1 was provided"),
    (lambda: couplet.draw(1, along=("thrust", "1..2")), couplet.CoupletError, "along=('friction', '0.2..3')"),
    (lambda: couplet.figure(6, weight="both"), couplet.CoupletError, "figure 6 shows one weight"),
    (lambda: couplet.figure(1, font_size="1mm"), couplet.CoupletError, "font_size='1mm': a font size"),
    (lambda: couplet.map(scale="sqrt"), couplet.CoupletError, "scale='sqrt': linear, log"),
    (lambda: couplet.map(lines=True, asymmetric=True), couplet.CoupletError, "lines cannot be used with asymmetric"),
    (lambda: couplet.map(difference=True, lines=True), couplet.CoupletError, "lines does not belong here"),
    (lambda: couplet.sample(hard=True, assemblies=True), couplet.CoupletError, "hard cannot be used with assemblies"),
    (lambda: couplet.equation(7, thrust="0.1"), couplet.CoupletError, "needs rotation_joint"),
    (lambda: couplet.judge({"half_opening": [1], "friction": [1], "\ud800": [1]}), couplet.CoupletError, "no column for anything to judge"),
    (lambda: couplet.run({"constants": [{"landmarks": "\ud800"}]}), couplet.CoupletError, "'\\ud800' is no text"),
    (lambda: couplet.run({"\ud800": 1}), couplet.CoupletError, "'\\ud800' is no text"),
    (lambda: couplet.run("\ud800"), couplet.CoupletError, "is no text"),
    (lambda: couplet.run({1: 2}), TypeError, "a key is a str, not int: 1"),
    (lambda: couplet.run({"arches": [{None: 2}]}), TypeError, "a key is a str, not NoneType: None"),
    (lambda: couplet.figure(13), couplet.CoupletError, "a figure is a number from 1 to 12"),
    (lambda: couplet.figure(1, tolerance=1e-3), couplet.CoupletError, "leave out tolerance"),
    (lambda: couplet.figure(1).to_dict(), couplet.CoupletError, "svg, png"),
    (lambda: couplet.map("nothing"), couplet.CoupletError, "nothing"),
    (lambda: couplet.map(tolerance=7), couplet.CoupletError, "from 1e-12 to 1"),
    (lambda: couplet.curve("rotation,sliding"), couplet.CoupletError, "one curve at a time"),
    (lambda: couplet.curve("rotation", weight="both"), couplet.CoupletError, "one curve at a time"),
    (lambda: couplet.sample(-1), couplet.CoupletError, "-1"),
    (lambda: couplet.audit(only="Q"), couplet.CoupletError, "a landmark is one of"),
    (lambda: couplet.run({}), couplet.CoupletError, "nothing"),
    (lambda: couplet.run("/nowhere/scene.toml"), OSError, "cannot read"),
]


def test_a_cell_that_is_no_text_is_a_bad_row():
    rows = couplet.judge({"half_opening": [1.3, 1.3], "friction": [0.5, 0.5], "thickness": ["\ud800", 0.0523]})
    assert [row["verdict"] for row in rows] == ["bad row", "correctly rounded"] and "UTF-8" in rows[0]["reason"]


@pytest.mark.parametrize(("question", "kind", "sentence"), WRONG)
def test_what_makes_no_sense_is_said_in_the_words_of_the_command(question, kind, sentence):
    with pytest.raises(kind) as caught:
        question()
    said = str(caught.value)
    assert sentence in said and words_of_a_shell(said) == [] and not said.startswith("couplet") and said


@pytest.mark.parametrize(
    ("shell", "python"),
    [
        ("this couplet was built without the feature plots (cargo install --path . --features plots)", "this couplet was built without the feature plots"),
        ("--half-opening, --friction are missing; for example: couplet draw --half-opening 80deg -o arch.svg", "half_opening, friction are missing"),
        ("name one, --columns theirs=thickness; its columns are 'x'", "name one, columns={'theirs': 'thickness'}; its columns are 'x'"),
        ("`couplet assess` tells of an arch of a thickness", "couplet.assess tells of an arch of a thickness"),
        ("'tilt' is not read here: `couplet assess --tilt` answers it, and --keep tilt hands it on", "'tilt' is not read here: couplet.assess(tilt=…) answers it, and keep='tilt' hands it on"),
        ("a claim; couplet prove --list shows the claims", "a claim; couplet.claims() shows the claims"),
        ("an item has at most 9, `couplet states --ranges` reads any number", "an item has at most 9, couplet.states reads any number"),
        ("cannot start threads (it ended); --threads 1 asks for fewer", "cannot start threads (it ended); threads=1 asks for fewer"),
        ("the end .txt tells no format: name the file .svg or .png, or give --format", "the end .txt tells no format: name the file .svg or .png"),
        ("invalid value 'Q' for '--at <LANDMARK>': a landmark is one of T, S", "at='Q': a landmark is one of T, S"),
        ("the argument '--along <QUANTITY> <FROM..TO>' cannot be used with '--mode <MODE>'", "along cannot be used with mode"),
        ("unexpected argument '--difference' found; --help lists the options", "difference does not belong here"),
        ("--no-caption and --no-title are for svg, png and pdf, not json", "no_caption and no_title are for svg, png and pdf, not json"),
        ("the friction 3602879701896397/36028797018963968 is negative", "the friction 0.1 is negative"),
    ],
)
def test_a_sentence_of_the_command_has_no_word_of_a_shell_in_python(shell, python):
    assert spoken(shell) == python and words_of_a_shell(python) == []


def test_a_note_is_a_warning():
    with pytest.warns(UserWarning, match="the friction 15 is a coefficient"):
        couplet.draw("80deg", 15)
    for question in [
        lambda: couplet.state("80deg", 15),
        lambda: couplet.assess("80deg", "15", "0.1"),
        lambda: couplet.assess("80deg", ("0.6", "15"), "0.1"),
        lambda: couplet.voussoirs("80deg", 15, 11),
        lambda: couplet.find("half_opening", friction=15),
        lambda: couplet.certify(half_opening="80deg", friction=15, digits=12),
    ]:
        with pytest.warns(UserWarning, match="the friction 15 is a coefficient; an angle of 15 degrees is written 15deg") as warned:
            question()
        assert [warning.filename for warning in warned] == [__file__]
    with pytest.warns(UserWarning, match="the tilt 5 is 5 times gravity"):
        couplet.tilt("80deg", "0.6", "0.15", 5)


def test_it_runs_from_any_folder_with_whatever_lies_there(tmp_path, monkeypatch):
    for name in ["signal.py", "couplet.py", "subprocess.py"]:
        (tmp_path / name).write_text("raise SystemExit(7)")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    assert couplet.sample(1)[0]["family"] == "ordinary"


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_an_interrupt_ends_it(tmp_path):
    # Nobody writes rows there: the command waits for them.
    os.mkfifo(tmp_path / "rows.csv")
    program = """
import couplet, signal, sys
# A job in the background ignores them.
signal.signal(signal.SIGINT, signal.default_int_handler)
handler = signal.getsignal(signal.SIGINT)
couplet.sample(1)
print("begins", flush=True)
try:
    couplet.judge(sys.argv[1])
except KeyboardInterrupt:
    print("interrupted", signal.getsignal(signal.SIGINT) is handler)
"""
    line = [sys.executable, "-c", program, str(tmp_path / "rows.csv")]
    with subprocess.Popen(line, stdout=subprocess.PIPE, text=True, env=path()) as driver:
        try:
            assert driver.stdout.readline() == "begins\n"
            # One that comes while something else is cleared away is lost.
            for _ in range(5):
                time.sleep(0.5)
                driver.send_signal(signal.SIGINT)
                try:
                    driver.wait(timeout=8)
                    break
                except subprocess.TimeoutExpired:
                    continue
        finally:
            driver.kill()
        assert driver.stdout.read() == "interrupted True\n"
    with pytest.raises(OSError):
        # Nobody reads there any more.
        os.close(os.open(tmp_path / "rows.csv", os.O_WRONLY | os.O_NONBLOCK))


def path():
    return {**os.environ, "PYTHONPATH": os.path.dirname(os.path.dirname(couplet.__file__))}


def test_equations_and_states_by_a_value():
    roots = couplet.equation(7, rotation_joint="1.0", digits=8)
    assert roots == json.loads(command("equation", "7", "--rotation-joint", "1.0", "--digits", "8", "--format", "json").stdout)
    states = couplet.states_of(rotation_joint="1.0", digits=8)["states"]
    for state in states:
        again = couplet.state(state["half_opening"]["value"], "inf", digits=6)
        assert again.rotation_joint.double == pytest.approx(1, abs=1e-6) and again.mode == state["mode"]
    assert len(states) == 2
    with pytest.raises(couplet.CoupletError, match="2 to 18"):
        couplet.equation(1)
    with pytest.raises(couplet.CoupletError):
        couplet.states_of(thrust="0.5", thickness="0.1")
