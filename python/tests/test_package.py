"""The package as it is installed."""

import doctest
import importlib
import importlib.metadata
import inspect
import json
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

import couplet

HOME = Path(__file__).parents[2]
OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


def test_it_is_the_installed_one():
    assert "site-packages" in couplet.__file__


def test_versions():
    assert couplet.__version__ == importlib.metadata.version("couplet")
    stated = (HOME / "Cargo.toml").read_text().split('version = "')[1].split('"')[0]
    assert couplet.__version__ == stated


def test_importing_brings_nothing_expensive():
    program = "import sys; before = set(sys.modules); import couplet; print(*set(sys.modules) - before)"
    done = subprocess.run([sys.executable, "-S", "-c", program], capture_output=True, text=True, env=path())
    new = set(done.stdout.split())
    assert "couplet._core" in new
    assert not new & {"numpy", "decimal", "fractions", "json", "typing", "dataclasses", "multiprocessing", "mpmath"}


def test_without_numpy_arrays_are_one_sentence():
    program = """
import sys
sys.modules["numpy"] = None
import couplet
print(couplet.state(1, 1, digits=5).thickness)
try:
    couplet.states([1.0], [1.0])
except ImportError as error:
    print(error)
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    thickness, sentence = done.stdout.splitlines()
    assert thickness == str(couplet.state(1, 1, digits=5).thickness)
    assert sentence == "states and states_columns need NumPy, which is not installed: pip install numpy"


def path():
    return {**os.environ, "PYTHONPATH": str(Path(couplet.__file__).parents[1])}


def test_licences_are_in_the_package():
    metadata = importlib.metadata.metadata("couplet")
    assert metadata["License-Expression"] == "(MIT OR Apache-2.0) AND LGPL-3.0-or-later AND Bitstream-Vera"
    files = {Path(str(file)).name: file for file in importlib.metadata.files("couplet")}
    names = ["LICENSE-MIT", "LICENSE-APACHE", "LGPL-3.0.md", "GPL-3.0.md", "LICENCES.txt", "NOTICES.txt", "DejaVuSans.LICENSE"]
    texts = {name: files[name].locate().read_text(encoding="utf-8") for name in names}
    assert "GMP 6" in texts["LICENCES.txt"] and "MPFR 4" in texts["LICENCES.txt"]
    assert "Lesser General Public License" in texts["LGPL-3.0.md"]
    for crate in ["pyo3", "rayon", "serde", "astro-float-num", "num-bigint", "clap", "resvg"]:
        assert f"{crate} " in texts["NOTICES.txt"], crate
    assert "rug 1" not in texts["NOTICES.txt"]
    assert "py.typed" in files and "_core.pyi" in files


def test_the_page_of_the_package_is_in_it():
    metadata = importlib.metadata.metadata("couplet")
    page = (HOME / "python" / "README.md").read_text(encoding="utf-8")
    told = metadata.get_payload() or metadata["Description"]
    assert told.strip() == page.strip() and metadata["Description-Content-Type"].startswith("text/markdown")
    # Nothing there leads out of the package: what has no address has no links.
    assert "](" not in page and not metadata.get_all("Project-URL")
    assert "hypothesis" in metadata.get_all("Provides-Extra")


def test_what_is_missing_is_named_in_one_line():
    sys.path.insert(0, str(HOME / "python" / "build_backend"))
    from needs import missing

    assert missing(lambda name: name) is None
    for program, words in [("m4", "please install m4"), ("make", "please install make"), ("cargo", "please install cargo")]:
        line = missing(lambda name, gone=program: None if name == gone else name)
        assert words in line and "\n" not in line
    both = missing(lambda name: None if name in ("cc", "gcc", "clang", "m4") else name)
    assert "C compiler" in both and "m4" in both
    assert missing(lambda name: None if name in ("cc", "gcc") else name) is None


def test_the_wheel_tells_what_is_in_it():
    files = [file for file in importlib.metadata.files("couplet") if "sboms" in file.parts]
    assert len(files) == 1
    text = files[0].locate().read_text(encoding="utf-8")
    sbom = json.loads(text)
    found = {component["name"]: component for component in sbom["components"]}
    assert {"rug", "gmp-mpfr-sys", "gmp", "mpfr", "pyo3", "rayon", "couplet", "couplet-check"} <= set(found)
    assert found["gmp"]["version"].startswith("6.") and "LGPL-3.0-or-later" in str(found["mpfr"]["licenses"])
    # Whatever is depended on is listed, once; and no folder of whoever built it is named.
    listed = [component["bom-ref"] for component in [sbom["metadata"]["component"], *sbom["components"]]]
    used = {name for crate in sbom["dependencies"] for name in [crate["ref"], *crate.get("dependsOn", [])]}
    assert used <= set(listed) and len(set(listed)) == len(listed)
    assert set(re.findall(r"file:///([^/#\"]*)", text)) == {"couplet"}


# Where no address of the repository is known, what lists the crates writes an empty one.
ADDRESSES = [{"type": "vcs", "url": ""}, {"type": "website", "url": "https://example.org"}]
SBOM = {
    "metadata": {"component": {"bom-ref": "path+file:///home/a%20b/c#1.0.0", "externalReferences": ADDRESSES[:1]}},
    "components": [{"bom-ref": "path+file:///home/a%20b/c/crates/check#1.0.0", "externalReferences": ADDRESSES}],
    "dependencies": [{"ref": "registry+https://crates#gmp-mpfr-sys@1.7.0"}, {"ref": "path+file:///home/a%20b/c#1.0.0"}],
}


@pytest.fixture
def sbom(monkeypatch):
    monkeypatch.syspath_prepend(HOME / "python" / "build_backend")
    return importlib.import_module("sbom")


def a_wheel(path, sbom, recorded=SBOM):
    """A wheel with a program and an SBOM, of which RECORD has these contents."""
    files = {"a/program": b"a program\n" * 1000, "a.dist-info/sboms/a.json": json.dumps(SBOM).encode()}
    record = sbom.line("a/program", files["a/program"]) + sbom.line("a.dist-info/sboms/a.json", json.dumps(recorded).encode())
    with zipfile.ZipFile(path, "w") as wheel:
        for name, data in {**files, "a.dist-info/RECORD": record.encode()}.items():
            member = zipfile.ZipInfo(name, (2020, 2, 2, 2, 2, 2))
            member.compress_type, member.external_attr = zipfile.ZIP_DEFLATED, 0o100755 << 16
            wheel.writestr(member, data)


def test_the_folder_is_taken_out_and_nothing_else_is_changed(tmp_path, sbom):
    wheel = tmp_path / "a.whl"
    a_wheel(wheel, sbom)
    before = zipfile.ZipFile(wheel)
    sbom.complete(wheel, Path("/home/a b/c"), {"gmp": "6.3.0"})
    after = zipfile.ZipFile(wheel)
    facts = lambda zip_file: [(m.filename, m.date_time, m.external_attr, m.compress_type) for m in zip_file.infolist()]
    assert facts(before) == facts(after) and os.listdir(tmp_path) == ["a.whl"]
    assert before.read("a/program") == after.read("a/program")
    told = after.read("a.dist-info/sboms/a.json")
    made = json.loads(told)
    assert b"/home" not in told and made["components"][0]["bom-ref"] == "path+file:///couplet/crates/check#1.0.0"
    assert made["metadata"]["component"] == {"bom-ref": "path+file:///couplet#1.0.0"}
    assert made["components"][0]["externalReferences"] == ADDRESSES[1:]
    assert made["dependencies"][0]["dependsOn"] == [made["components"][1]["bom-ref"]] == ["pkg:generic/gmp@6.3.0"]
    record = after.read("a.dist-info/RECORD").decode()
    assert record == sbom.line("a/program", after.read("a/program")) + sbom.line("a.dist-info/sboms/a.json", told)


def test_a_wheel_that_is_not_as_its_record_says_stays(tmp_path, sbom):
    wheel = tmp_path / "a.whl"
    a_wheel(wheel, sbom, recorded={})
    whole = wheel.read_bytes()
    with pytest.raises(ValueError, match="RECORD has another a.dist-info/sboms/a.json"):
        sbom.complete(wheel, Path("/home/a b/c"), {})
    assert wheel.read_bytes() == whole and os.listdir(tmp_path) == ["a.whl"]


def test_an_sbom_keeps_the_crates_that_are_linked_and_no_other(sbom):
    crates = [{"bom-ref": f"{name} {version}", "name": name, "version": version} for name, version in (("a", "1"), ("a", "2"), ("b", "1"))]
    whole = {
        "metadata": {"component": {"bom-ref": "top"}},
        "components": crates,
        "dependencies": [{"ref": "top", "dependsOn": ["a 1", "b 1"]}, {"ref": "a 1"}, {"ref": "a 2"}, {"ref": "b 1", "dependsOn": ["a 2"]}],
    }
    kept = json.loads(sbom.only(json.dumps(whole), [crates[0]]))
    assert kept["components"] == [crates[0]]
    assert kept["dependencies"] == [{"ref": "top", "dependsOn": ["a 1"]}, {"ref": "a 1"}]
    assert json.loads(sbom.only(json.dumps(whole), crates)) == whole


@pytest.mark.parametrize("module", ["couplet", "couplet._arches", "couplet._arrays", "couplet._certified", "couplet._answers", "couplet._commands", "couplet._sweeps"])
def test_the_examples_of_the_documentation(module):
    pytest.importorskip("numpy")
    module = importlib.import_module(module)
    assert doctest.testmod(module, optionflags=OPTIONS, extraglobs={"couplet": couplet}).failed == 0


@pytest.mark.parametrize("page, examples", [("docs/python.md", 10), ("README.md", 2), ("python/README.md", 5), ("docs/surveys.md", 3)])
def test_the_examples_of_a_page(page, examples):
    pytest.importorskip("numpy")
    pytest.importorskip("hypothesis")
    done = doctest.testfile(str(HOME / page), module_relative=False, optionflags=OPTIONS)
    assert done.failed == 0 and done.attempted >= examples


def test_everything_public_has_words():
    for name in couplet.__all__:
        thing = getattr(couplet, name)
        if callable(thing):
            assert thing.__doc__ and len(thing.__doc__) > 40, name
            for inner, member in vars(thing).items() if isinstance(thing, type) else ():
                if not inner.startswith("_") and (callable(member) or isinstance(member, property)):
                    assert member.__doc__, f"{name}.{inner}"


def test_what_classes_are_made_of_is_public():
    for thing in [thing for thing in vars(couplet).values() if isinstance(thing, type)]:
        if thing.__module__.startswith("couplet") and not issubclass(thing, Exception):
            names = set(re.findall(r"\b[A-Z]\w*", str(inspect.signature(thing))))
            assert names <= {*couplet.__all__, "Any", "None"}, thing
