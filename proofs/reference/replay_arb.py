#!/usr/bin/env python3
"""Replays this bundle by Python and Arb, without couplet: every file is the one of MANIFEST, every certificate is accepted
by `check_with_arb.py` beside this script, and proves what index.jsonl says.

    python3 replay_arb.py

Exit codes: 0 all holds; 1 a file is named that does not; 2 bad usage; 3 something could not be run or read. Needs Python
3.10 and python-flint 0.8, or newer.

Of THEOREM_MAP.json it looks at the rows of theorems: that proofs/coq states each, and that each says what hand_theorems.txt
says. That the theorems hold is Coq's part, that the claims do is couplet's."""

import hashlib
import json
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # a file more would be no file of MANIFEST
HERE = pathlib.Path(__file__).resolve().parent
FLAG = {"state": "mode", "too_thin": "mode", "asymmetric": "mode"}


class Fault(Exception):
    """What is wrong, with the file before it."""


def need(holds, words):
    if not holds:
        raise Fault(words)


def manifest():
    """The files that MANIFEST names, each as it was; its last line is the hash of those before it."""
    path = HERE / "MANIFEST"
    need(path.is_file(), "MANIFEST: missing")
    *lines, last = path.read_bytes().splitlines(keepends=True) or [b""]
    need(last == f"{hashlib.sha256(b''.join(lines)).hexdigest()}  MANIFEST\n".encode(), "MANIFEST: changed")
    named = dict(reversed(line.decode().rstrip("\n").split("  ", 1)) for line in lines)
    found = {str(path.relative_to(HERE)) for path in HERE.rglob("*") if not path.is_dir() or path.is_symlink()} - {"MANIFEST"}
    faults = [f"{name}: not in MANIFEST" for name in sorted(found - named.keys())]
    faults += [f"{name}: missing" for name in sorted(named.keys() - found)]
    for name in sorted(found & named.keys()):
        if hashlib.sha256((HERE / name).read_bytes()).hexdigest() != named[name]:
            faults.append(f"{name}: changed")
    need(not faults, "\n".join(faults))
    return sorted(found)


def certificates(names, arb):
    """How many certificates prove what the index says of them."""
    rows = [json.loads(line) for line in (HERE / "index.jsonl").read_text(encoding="utf-8").splitlines()]
    told = [row["file"] for row in rows]
    need(len(set(told)) == len(told), "index.jsonl: a file stands twice")
    there = {name for name in names if name.startswith("certificates/") and name.endswith(".json")}
    need(there, "certificates: there are none")
    need(there == set(told), f"index.jsonl: not the certificates that are there: {sorted(there ^ set(told))[:3]}")
    faults = []
    for row in rows:
        data = (HERE / row["file"]).read_bytes()
        try:
            arb.check(data)
        except arb.Refused as reason:
            faults.append(f"{row['file']}: refused: {reason}")
            continue
        file = arb.parse(data)
        if arb.statement(file) != row["statement"]:
            faults.append(f"{row['file']}: index.jsonl says something else of it")
        elif described(file) != {name: row[name] for name in ("subject", "case", "weight", "digits")}:
            faults.append(f"{row['file']}: index.jsonl names another subject")
    need(not faults, "\n".join(faults))
    return len(rows)


def described(file):
    """What the index has of a certificate besides its statement."""
    if "survey" in file:
        digits = max(part["certificate"]["digits"] for part in file["parts"])
        return {"subject": "survey", "case": file["verdict"], "weight": file["survey"]["weight"], "digits": digits}
    claim = file["claim"]
    (kind,) = claim.keys() - {"weight", "unknowns", "equations"}
    case = claim[kind] if kind == "landmark" else claim[kind][FLAG[kind]] if kind in FLAG else None
    return {"subject": kind, "case": case, "weight": claim["weight"], "digits": file["digits"]}


def theorems():
    """How many rows of the map are theorems that proofs/coq states."""
    listed = (HERE / "proofs/coq/hand_theorems.txt").read_text(encoding="utf-8").splitlines()
    listed = {tuple(line.split("\t")) for line in listed}
    rows = json.loads((HERE / "THEOREM_MAP.json").read_text(encoding="utf-8"))["rows"]
    rows = [row for row in rows if row["kind"] in ("theorem", "printed")]
    for row in rows:
        path = HERE / row["file"]
        stated = rf"^(Theorem|Lemma|Corollary|Proposition|Fact) {re.escape(row['name'])}\b"
        need(path.is_file() and re.search(stated, path.read_text(encoding="utf-8"), re.M),
             f"THEOREM_MAP.json: {row['file']} does not state {row['id']}")
        need(row["kind"] == "printed" or (row["id"], row["place"], row["statement"]) in listed,
             f"THEOREM_MAP.json: hand_theorems.txt has no such {row['id']}")
    need(sum(row["kind"] == "theorem" for row in rows) == len(listed), "THEOREM_MAP.json: not every theorem of hand_theorems.txt")
    return len(rows)


def main(arguments):
    if arguments:
        print("replay_arb.py: usage: replay_arb.py", file=sys.stderr)
        return 2
    try:
        names = manifest()
        try:
            import check_with_arb as arb
        except ImportError as error:
            print(f"replay_arb.py: {error}; pip install 'python-flint>=0.8'", file=sys.stderr)
            return 3
        done, stated = certificates(names, arb), theorems()
    except Fault as fault:
        print(fault)
        print("replay_arb.py: the bundle is not what it says", file=sys.stderr)
        return 1
    except (ValueError, KeyError, TypeError) as error:
        print(f"index.jsonl or THEOREM_MAP.json: not of its form: {error!r}")
        return 1
    except OSError as error:
        print(f"replay_arb.py: {error.filename}: {error.strerror}", file=sys.stderr)
        return 3
    print(f"replay_arb.py: {len(names)} files are those of MANIFEST, {done} certificates prove what index.jsonl says, "
          f"{stated} theorems are stated in proofs/coq")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
