#!/usr/bin/env python3
"""The size of the house: lines, files, public items, names and conditions by crate, crates by build; with `--time` the processor
seconds of builds too, with an empty cache of GMP, which takes half an hour; with `--limit` only whether each crate, and what
else `benches/budget.txt` names, keeps to its number.

Code lines are those without comments, blanks and what is compiled for tests only; they are counted in every `src`."""

import collections
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

HOUSE = pathlib.Path(__file__).resolve().parent.parent
TEST = re.compile(r"#\[cfg\((all\()?test\b")
WORDS = re.compile(r"\"(\\.|[^\"\\])*\"|'(\\.|[^'])'|//.*")
TYPE = re.compile(r"^(?:pub(?:\([\w: ]+\))? )?(?:struct|enum|trait|type|union) ([A-Z]\w*)", re.M)
PUBLIC = re.compile(r"^\s*pub (?:const |unsafe |async )*(?:fn|struct|enum|trait|type|mod|const|static|use)\b", re.M)
CONDITION = re.compile(r"cfg(?:_attr)?!?\(.*feature = ")


def without_tests(text):
    """The lines of a text without what stands below `#[cfg(test)]`."""
    lines, kept, at = text.split("\n"), [], 0
    while at < len(lines):
        if not TEST.match(lines[at].strip()):
            kept.append(lines[at])
            at += 1
            continue
        at += 1
        while lines[at].strip().startswith("#["):
            at += 1
        depth, began = 0, False
        while at < len(lines):
            bare = WORDS.sub("", lines[at])
            depth += bare.count("{") - bare.count("}")
            began |= "{" in bare
            at += 1
            if depth <= 0 and (began or bare.strip().endswith(";")):
                break
    return kept


def code(path):
    """The code lines of a file."""
    lines = (line.strip() for line in without_tests(path.read_text()))
    return sum(1 for line in lines if line and not line.startswith("//"))


def is_tests(path):
    """Whether a file is compiled for tests only."""
    folder = path.parent / "mod.rs"
    declared = folder.read_text() if folder.exists() else ""
    return path.name == "tests.rs" or "tests" in path.parts or f"#[cfg(test)]\nmod {path.stem};" in declared


def floors():
    """The folders of the sources, by crate."""
    crates = sorted(HOUSE.glob("crates/*/src"))
    found = {f"couplet-{path.parent.name}": path for path in crates} | {"couplet": HOUSE / "src"}
    return found | {f"couplet-{name}": HOUSE / name / "src" for name in ("c", "python", "page")}


def tracked(*patterns):
    """The texts that git tracks below some patterns."""
    said = subprocess.run(["git", "ls-files", "--", *patterns], cwd=HOUSE, capture_output=True, text=True, check=True).stdout
    return [(HOUSE / name).read_text() for name in said.splitlines()]


def sizes():
    """What has a budget: the code lines of each crate, and what stands beside them."""
    found = {name: sum(code(path) for path in floor.rglob("*.rs") if not is_tests(path)) for name, floor in floors().items()}
    found["the house"] = sum(lines for name, lines in found.items() if name not in OWN)
    lines = lambda *patterns: sum(text.count("\n") for text in tracked(*patterns))
    words = lambda *patterns: sum(len(text.split()) for text in tracked(*patterns))
    tests = (line.strip() for text in tracked("tests/*.rs") for line in text.split("\n"))
    found["lines of Coq"] = lines("*.v")
    found["code lines of tests"] = sum(1 for line in tests if line and not line.startswith("//"))
    found["words of docs"] = words("docs/*.md", "README.md")
    found["words of README.md"] = words("README.md")
    found["lines of Makefile and .ci"] = lines("Makefile", ".ci")
    return found


# A number that is further above what is there than this part of it no longer holds anything.
SLACK = 0.02


def limit():
    """Compares the sizes with the budget: none is above, and no number is far above what is there."""
    budget = dict(line.rsplit(" ", 1) for line in (HOUSE / "benches/budget.txt").read_text().splitlines() if line[:1] != "#")
    found, wrong = sizes(), []
    for name in sorted(found.keys() | budget.keys()):
        size, most = found.get(name), int(budget.get(name, 0))
        if size is None:
            wrong.append(f"{name} is not there")
        elif size > most:
            wrong.append(f"{name}: {size}, allowed are {most}: say in the commit what it buys and what goes for it")
        elif size < most * (1 - SLACK) - 20:
            wrong.append(f"{name}: {size}, allowed are {most}: lower the number")
    sys.exit("\n".join(wrong) or None)


OWN = ("couplet-c", "couplet-python", "couplet-page")


def table():
    names, all_rows = collections.Counter(), []
    for name, floor in floors().items():
        files = sorted(floor.rglob("*.rs"))
        texts = [path.read_text() for path in files]
        ours = [path for path in files if not is_tests(path)]
        row = [len(files), sum(text.count("\n") for text in texts), sum(map(code, ours))]
        row.append(sum(len(PUBLIC.findall(text)) for text in texts))
        row.append(sum(1 for text in texts for line in text.split("\n") if CONDITION.search(line)))
        all_rows.append((name, row))
        if name not in OWN:
            for path in ours:
                names.update(TYPE.findall("\n".join(without_tests(path.read_text()))))
    print(f"{'crate':<16}{'files':>7}{'lines':>8}{'code':>8}{'pub':>7}{'cfg':>5}")
    for name, row in all_rows:
        print(f"{name:<16}{row[0]:>7}{row[1]:>8}{row[2]:>8}{row[3]:>7}{row[4]:>5}")
    house = [row for name, row in all_rows if name not in OWN]
    total = [sum(column) for column in zip(*house)]
    print(f"{'the house':<16}{total[0]:>7}{total[1]:>8}{total[2]:>8}{total[3]:>7}{total[4]:>5}  (without c, python, page)")
    twice = {name: count for name, count in names.items() if count > 1}
    print(f"\ntype names given twice or more: {len(twice)}")
    print("  " + ", ".join(f"{name} {count}" for name, count in sorted(twice.items(), key=lambda x: (-x[1], x[0]))))


def crates(*choice):
    """How many crates a build has, its own among them."""
    command = ["cargo", "tree", "--locked", "--prefix", "none", "-e", "normal,build", *choice]
    said = subprocess.run(command, cwd=HOUSE, capture_output=True, text=True, check=True).stdout
    return len({line.split(" (")[0] for line in said.splitlines() if line})


BUILDS = {
    "the checker alone": ["-p", "couplet-check"],
    "the library": ["-p", "couplet", "--no-default-features"],
    "the command (default)": ["-p", "couplet"],
    "everything tested": ["-p", "couplet", "--features", "proptest"],
    "the library for C": ["-p", "couplet-c"],
    "the Python package": ["-p", "couplet-python"],
    "the page": ["-p", "couplet-page"],
}


def seconds(target, *choice):
    """Processor seconds of a build."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = ["cargo", "build", "--locked", "--quiet", "--release", "--target-dir", target, *choice]
    subprocess.run(command, cwd=HOUSE, check=True, env=os.environ | {"GMP_MPFR_SYS_CACHE": "_"})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def times():
    """What is built again after a change. A file is touched, so that nothing of it is really changed."""
    with tempfile.TemporaryDirectory() as target:
        print(f"{seconds(target):8.0f}  from nothing")
        for words, touched in {
            "after a change of README.md": "README.md",
            "after a change in report": "crates/report/src/tilt.rs",
            "after a change in number": "crates/number/src/number/angle.rs",
        }.items():
            os.utime(HOUSE / touched)
            print(f"{seconds(target):8.0f}  {words}")
        print(f"{os.path.getsize(os.path.join(target, 'release', 'couplet')) / 1e6:8.1f}  MB: the binary")


if "--limit" in sys.argv[1:]:
    limit()
    sys.exit()
table()
print("\ncrates of a build:")
for name, choice in BUILDS.items():
    print(f"{crates(*choice):5}  {name}")
if "--time" in sys.argv[1:]:
    print("\nprocessor seconds of release builds:")
    times()
