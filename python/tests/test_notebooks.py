"""The notebooks: as they are stored, and that they print the same when they are run."""

import base64
import copy
import json
import sys
from pathlib import Path

import pytest

HOME = Path(__file__).parents[2]
sys.path.insert(0, str(HOME / "python" / "notebooks"))
import run

MOST_OF_A_PICTURE = 150_000
named = pytest.mark.parametrize("path", run.NOTEBOOKS, ids=lambda path: path.stem)


def read(path):
    return json.loads(path.read_text(encoding="utf-8"))


def code(notebook):
    return [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]


def test_there_are_five():
    assert len(run.NOTEBOOKS) == 5
    page = (HOME / "docs" / "python.md").read_text(encoding="utf-8")
    assert [path.name for path in run.NOTEBOOKS if f"](../python/notebooks/{path.name})" not in page] == []


@named
def test_what_is_stored_has_no_trace_of_a_machine(path):
    notebook = read(path)
    assert notebook["metadata"] == run.METADATA
    assert [cell["id"] for cell in notebook["cells"]] == [f"cell-{place}" for place in range(1, len(notebook["cells"]) + 1)]
    assert notebook["cells"][0]["source"][0].startswith("# ")
    for cell in code(notebook):
        assert cell["execution_count"] is None and set(cell["metadata"]) <= {"tags"}
        for output in cell["outputs"]:
            assert output["output_type"] in ("stream", "display_data", "execute_result")
            assert output.get("name") != "stderr", output["text"]
    assert not [trace for trace in ("/tmp", "/home", "/root", "site-packages", "0x", "<Figure") if trace in printed(notebook)]


def printed(notebook):
    """All that is printed, without pictures."""
    texts = []
    for cell in code(notebook):
        for output in cell["outputs"]:
            texts += output.get("text", [])
            data = output.get("data", {})
            if not any(kind.startswith("image/") for kind in data):
                texts += data.get("text/plain", [])
    return "".join(texts)


@named
def test_it_shows_pictures_that_are_small(path):
    sizes = []
    for cell in code(read(path)):
        for output in cell["outputs"]:
            for kind, data in output.get("data", {}).items():
                if kind == "image/png":
                    sizes.append(len(base64.b64decode(data)))
                elif kind.startswith("image/"):
                    sizes.append(len("".join(data)))
    assert sizes and max(sizes) < MOST_OF_A_PICTURE


@named
def test_it_prints_the_same(path):
    nbformat = pytest.importorskip("nbformat")
    for need in ("nbclient", "ipykernel", "scipy", "matplotlib", "pandas", "pyarrow"):
        pytest.importorskip(need)
    stored = nbformat.read(path, as_version=4)
    made = run.executed(path)
    assert run.differences(stored, made) == []


@named
def test_a_number_that_is_changed_is_found(path):
    nbformat = pytest.importorskip("nbformat")
    stored = nbformat.read(path, as_version=4)
    assert run.differences(stored, copy.deepcopy(stored)) == []
    changed = 0
    for place, cell in enumerate(stored.cells):
        for number, output in enumerate(cell.get("outputs", [])):
            told = run.NUMBER.search(output.text) if output.output_type == "stream" else None
            if told:
                spoiled = copy.deepcopy(stored)
                # Of a cell in doubles by a factor of a hundred, of another by a digit more.
                tagged = "doubles" in cell.metadata.get("tags", [])
                other = repr(100 * float(told[0])) if tagged else told[0] + "1"
                text = output.text[: told.start()] + other + output.text[told.end() :]
                spoiled.cells[place].outputs[number].text = text
                (line,) = run.differences(stored, spoiled)
                assert line.startswith(f"{cell.id}: ")
                changed += 1
    assert changed > 2


@named
def test_a_picture_that_is_missing_is_found(path):
    nbformat = pytest.importorskip("nbformat")
    stored = nbformat.read(path, as_version=4)
    for place, cell in enumerate(stored.cells):
        for number, output in enumerate(cell.get("outputs", [])):
            if any(kind.startswith("image/") for kind in output.get("data", {})):
                spoiled = copy.deepcopy(stored)
                del spoiled.cells[place].outputs[number]
                assert len(run.differences(stored, spoiled)) == 1


def test_doubles_are_alike_within_a_factor_of_ten():
    for one, other in [
        ("error 1e-14, too thin", "error 9e-15, too thin"),
        ("a  -3 b", "a -12 b"),
        ("units\n < 1000", "units\n < 1000"),
        ("0 and nan", "0 and nan"),
    ]:
        assert run.alike(one, other), (one, other)
    for one, other in [
        ("error 1e-14", "error 1e-16"),
        ("error 1e-14, too thin", "error 1e-14, too thick"),
        ("1e-3", "-1e-3"),
        ("0", "1e-9"),
        ("3 rows", "3 rows 4"),
        ("nan", "1.0"),
    ]:
        assert not run.alike(one, other), (one, other)
