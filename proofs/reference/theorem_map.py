#!/usr/bin/env python3
"""The map of what is proved: claim, statement, file, checkers, command, expected output.

    proofs/reference/theorem_map.py COUPLET

Prints JSON, docs/schemas/theorem_map-1.json. Nothing is typed here: the claims and what each rests on are asked of the program
(`couplet prove --show`), so are the curves (`couplet map`); the theorems are those of proofs/coq/hand_theorems.txt, and those
that the program prints."""

import json
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from arches import Program  # noqa: E402

HOUSE = pathlib.Path(__file__).resolve().parent.parent.parent
STATES = "^ *(?:Theorem|Lemma|Corollary|Proposition|Fact) "


def the_one(found, what):
    if len(found) != 1:
        raise SystemExit(f"theorem_map.py: {what} is in {len(found)} files")
    return str(found[0].relative_to(HOUSE))


def files(pattern):
    return {path: path.read_text() for path in sorted(HOUSE.glob(pattern))}


def claims(program):
    provers = files("crates/claims/src/*.rs")
    said = program.json("prove", "--show")["claims"]
    for claim in said:
        steps = {support: [step["words"].split(": ")[0] for step in claim["derivation"] if step["support"] == support]
                 for support in ("claim", "theorem")}
        shows = [f"{claim['as_printed']} {claim['id']} {claim['place']}"]
        shows += [f"corrected: {claim['corrected']}"] if claim["corrected"] else []
        yield {
            "id": claim["id"], "kind": "claim", "place": claim["place"], "statement": claim["statement"],
            "verdict": claim["verdict"], "corrected": claim["corrected"], "method": claim["method"],
            "words": claim["argument"], "rests_on": steps["claim"] + steps["theorem"],
            "file": the_one([path for path, text in provers.items() if f'("{claim["id"]}"' in text], claim["id"]),
            "name": claim["id"], "checkers": ["couplet prove"] + ["coqc"] * bool(steps["theorem"]),
            "command": f"couplet prove {claim['id']}", "expected": {"exit": 0, "shows": shows},
        }


def theorems():
    sources = files("proofs/coq/**/*.v")
    for line in (HOUSE / "proofs/coq/hand_theorems.txt").read_text().splitlines():
        if line.startswith("#") or not line:
            continue
        theorem, place, says = line.split("\t")
        module, name = theorem.split(".")
        stated = re.compile(rf"{STATES}{re.escape(name)}\b", re.M)
        found = [path for path, text in sources.items() if path.stem == module and stated.search(text)]
        yield by_coq("theorem", theorem, place, says, the_one(found, theorem))
    # What the program prints for Coq says in its first line what it is about, and the name of a theorem what of it.
    for path, text in files("proofs/coq/generated/*.v").items():
        about = re.match(r"\(\*\* \* (.*)", text)[1]
        for name in re.findall(r"^(?:Theorem|Corollary) (\w+)", text, re.M):
            says = f"{about}: {name.replace('_', ' ')}"
            yield by_coq("printed", f"{path.stem}.{name}", "", says, str(path.relative_to(HOUSE)))


def by_coq(kind, theorem, place, says, file):
    return {
        "id": theorem, "kind": kind, "place": place, "statement": says, "verdict": "proved", "corrected": None, "method": "Coq",
        "words": None, "rests_on": [], "file": file, "name": theorem.split(".")[1], "checkers": ["coqc"],
        "command": "make -C proofs/coq -j2 check",
        "expected": {"exit": 0, "shows": ["theorems assume only the axioms of the real numbers"]},
    }


def curves(program):
    for curve in program.json("map", "--weight", "both")["curves"]:
        name, weight = curve["curve"], curve["weight"] or "any"
        ends = f"{curve['from']} {curve['to']}"
        yield {
            "id": f"curve-{name.replace('/', '-')}-{weight}", "kind": "curve", "place": "Sec. 3, Fig. 5, 6",
            "statement": f"for each {curve['parameter']} from {curve['from']} to {curve['to']} the equations of the curve {name} "
                         f"({weight} weight) have exactly one solution in a tube, and the pieces join",
            "verdict": "undecided" if curve["gaps"] else "proved", "corrected": None, "method": "balls along the curve",
            "words": "beneath", "rests_on": ["map-lines"], "file": "crates/atlas/src", "name": name,
            "checkers": ["couplet map"],
            "command": f"couplet map --curve {name}" + (f" --weight {weight}" if curve["weight"] else ""),
            "expected": {"exit": 0, "shows": [f"{name} {weight} {curve['parameter']} {ends} {curve['pieces']}",
                                              "proved: for each value of the parameter exactly one solution"]},
        }


def theorem_map(program):
    rows = [*claims(program), *curves(program), *theorems()]
    known = {row["id"] for row in rows}
    unknown = {one for row in rows for one in row["rests_on"]} - known
    if unknown or len(known) != len(rows):
        raise SystemExit(f"theorem_map.py: names that are not there, or twice: {sorted(unknown)}")
    version = program.run("--version")[1].split()[1]
    return {"schema": "couplet.theorem_map/1", "version": version, "rows": rows}


def main(arguments):
    if len(arguments) != 1:
        print("theorem_map.py: usage: theorem_map.py COUPLET", file=sys.stderr)
        return 2
    json.dump(theorem_map(Program(arguments[0])), sys.stdout, indent=1, ensure_ascii=False)
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
