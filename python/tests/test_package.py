"""The package as it is installed."""

import doctest
import importlib
import importlib.metadata
import inspect
import os
import re
import subprocess
import sys
import types
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
    assert metadata["License-Expression"] == "(MIT OR Apache-2.0) AND LGPL-3.0-or-later"
    files = {Path(str(file)).name: file for file in importlib.metadata.files("couplet")}
    names = ["LICENSE-MIT", "LICENSE-APACHE", "LGPL-3.0.md", "GPL-3.0.md", "LICENCES.txt", "NOTICES.txt"]
    texts = {name: files[name].locate().read_text(encoding="utf-8") for name in names}
    assert "GMP 6" in texts["LICENCES.txt"] and "MPFR 4" in texts["LICENCES.txt"]
    assert "Lesser General Public License" in texts["LGPL-3.0.md"]
    for crate in ["pyo3", "rayon", "serde", "astro-float-num", "num-bigint", "clap"]:
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


def a_wheel(path):
    with zipfile.ZipFile(path, "w") as wheel:
        for name, mode in [("package/text.py", 0o100644), ("package/program", 0o100755)]:
            member = zipfile.ZipInfo(name, (2020, 2, 2, 2, 2, 2))
            member.compress_type, member.external_attr = zipfile.ZIP_DEFLATED, mode << 16
            wheel.writestr(member, f"what {name} says\n" * 1000)
    return path.read_bytes()


class Spoils(zipfile.ZipFile):
    """Writes something else."""

    def writestr(self, member, data):
        super().writestr(member, data.replace(b"says", b"said"))


class Stops(zipfile.ZipFile):
    """Has no room for a second file."""

    def writestr(self, member, data):
        if self.namelist():
            raise OSError("no space left")
        super().writestr(member, data)


def packing(monkeypatch, zip_file):
    """`pack` with this in place of zopfli's."""
    monkeypatch.setitem(sys.modules, "zopfli", types.SimpleNamespace(ZipFile=zip_file))
    monkeypatch.delitem(sys.modules, "pack", raising=False)
    monkeypatch.syspath_prepend(HOME / "python" / "build_backend")
    import pack

    return pack.pack


def test_a_packed_wheel_has_the_same_files(tmp_path, monkeypatch):
    wheel = tmp_path / "a.whl"
    a_wheel(wheel)
    facts = lambda zip_file: [(m.filename, m.date_time, m.external_attr, zip_file.read(m)) for m in zip_file.infolist()]
    before = facts(zipfile.ZipFile(wheel))
    packing(monkeypatch, zipfile.ZipFile)(str(wheel))
    assert facts(zipfile.ZipFile(wheel)) == before and os.listdir(tmp_path) == ["a.whl"]


@pytest.mark.parametrize("fault", [Spoils, Stops])
def test_a_wheel_that_cannot_be_packed_stays(tmp_path, monkeypatch, fault):
    wheel = tmp_path / "a.whl"
    whole = a_wheel(wheel)
    with pytest.raises((SystemExit, OSError), match="it is left as it was|no space left"):
        packing(monkeypatch, fault)(str(wheel))
    assert wheel.read_bytes() == whole and os.listdir(tmp_path) == ["a.whl"]


@pytest.mark.parametrize("module", ["couplet", "couplet._arches", "couplet._arrays", "couplet._certified", "couplet._answers", "couplet._codes", "couplet._commands", "couplet._frames", "couplet._sweeps"])
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
