#!/usr/bin/env python3
"""Writes what each fuzz target begins with to seeds/TARGET, from files of the repository."""

import json
import re
from pathlib import Path

HERE = Path(__file__).resolve().parent
TOP = HERE.parent
RESULTS = {"mode": "rrr", "thickness": "0.1075", "thrust": "0.62", "rotation_joint": "0.95"}


def questions():
    """The fields of the questions that every door is asked."""
    for line in (TOP / "tests/questions.txt").read_text().splitlines():
        words = line.removeprefix("! ").split()
        if words and words[0] in ("state", "assess"):
            yield dict(word.split("=", 1) for word in words[1:] if "=" in word)


def tables(questions):
    """Questions as CSV, those with the same columns together."""
    by_columns = {}
    for fields in questions:
        by_columns.setdefault(tuple(fields), []).append(",".join(fields.values()))
    for columns, rows in by_columns.items():
        yield "\n".join([",".join(columns), *rows]) + "\n"


def plans():
    """The example of a plan, and one with each of the tables that it may have."""
    text = (TOP / "crates/sweep/src/scene/sweep.toml").read_text()
    yield text
    plain = re.sub(r"^# (?=\[\w+\]$|\w+ = )", "", text, flags=re.M)
    head, *tables = re.split(r"^(?=\[)", re.sub(r"^#.*\n", "", plain, flags=re.M), flags=re.M)
    for table in tables:
        yield head + table


def seeds():
    asked = list(questions())
    judged = [{**fields, **RESULTS} for fields in asked if "half_opening" in fields and "thickness" not in fields]
    scenes = [*TOP.glob("examples/*.toml"), TOP / "crates/sweep/src/scene/example.toml"]
    yield "arch", ["; ".join(f"{name}={value}" for name, value in fields.items()) for fields in asked]
    yield "arch", ["half_opening=80deg..82deg; friction=0.5..0.6; thickness=0.1", "span=10m±1cm; rise=3m; friction=0.6"]
    yield "certificate", [path.read_text() for path in sorted(TOP.glob("proofs/*/*.json"))]
    yield "scene", [path.read_text() for path in scenes]
    yield "plan", list(plans())
    yield "rows_csv", [*tables(asked), "# x\nhalf_opening;friction\n1,5;0,6\n", "\ufeffhalf_opening\tfriction\n1\t1\n"]
    yield "rows_json", [json.dumps(fields) for fields in asked]
    yield "rows_json", [json.dumps(asked), json.dumps({"arches": asked}, indent=1)]
    yield "judged", [*tables(judged), *(json.dumps(fields) for fields in judged)]


def main():
    for target, texts in seeds():
        folder = HERE / "seeds" / target
        folder.mkdir(parents=True, exist_ok=True)
        for text in texts:
            name = "".join(c if c.isalnum() else "-" for c in text[:40]) + f"-{len(text)}"
            (folder / name).write_text(text, newline="")


main()
