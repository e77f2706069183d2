#!/usr/bin/env python3
"""Makes the bundle: every certificate with its statement, the checkers that accept it and its command; the map of what is
proved; hashes; and two scripts that replay it.

    make.py FOLDER COUPLET --checker COUPLET_CHECK --arb PYTHON --verified COUPLET_VERIFIED
    make.py FOLDER COUPLET --few [the checkers that are there]

FOLDER/couplet-reference-VERSION and .tar.gz appear there; two runs are equal byte for byte. PYTHON has python-flint."""

import argparse
import concurrent.futures
import gzip
import hashlib
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tarfile
import tempfile

sys.dont_write_bytecode = True
from arches import PROOFS, Program, requests  # noqa: E402
from replay_arb import described  # noqa: E402
from theorem_map import theorem_map  # noqa: E402

HOUSE = PROOFS.parent
THEN = 315532800  # 1980, the first time that every archive can hold
COPIED = ["LICENSE-APACHE", "LICENSE-MIT", "CITATION.cff", "codemeta.json", ".zenodo.json"]
COQ = ("*.v", "*.txt", "*.sh", "Makefile", "_CoqProject")


def name_of(request):
    return f"certificates/{request.folder}/{request.name}.json"


def command_of(request):
    return f"couplet {shlex.join(request.words)}"


def certify(program, bundle, request):
    """Writes the certificate of a request; says whether there is one."""
    return program.run(*request.words, "--output", str(bundle / name_of(request)))[0] == 0


def certified(program, bundle, states, wanted):
    """The requests that have a certificate, of states as many as asked, and the commands of those that have none."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(lambda request: certify(program, bundle, request), wanted))
    kept = [request for request, there in zip(wanted, found) if there]
    left = [command_of(request) for request, there in zip(wanted, found) if not there]
    more = [request for request in kept if request.folder == "states"][states:]
    for request in more:
        (bundle / name_of(request)).unlink()
    kept = sorted((request for request in kept if request not in more), key=name_of)
    if sum(request.folder == "states" for request in kept) < states or any(" state " not in command for command in left):
        raise SystemExit(f"make.py: too many have no certificate: {left}")
    return kept, left


def checkers(asked):
    """Name and command of each checker, those that are asked for."""
    yield "couplet check", [asked.couplet, "check", "--statement"]
    yield "couplet check --engine mpfr", [asked.couplet, "check", "--engine", "mpfr", "--statement"]
    if asked.checker:
        yield "couplet-check", [asked.checker, "--statement"]
    if asked.arb:
        yield "check_with_arb.py", [asked.arb, str(PROOFS / "check_with_arb.py"), "--statement"]
    if asked.verified:
        yield "couplet-verified", [asked.verified, "check"]


def checked(bundle, names, command):
    """What a checker says of each file: its statement, nothing of one that it does not check. A refusal ends all."""
    done = subprocess.run([*command, *names], cwd=bundle, capture_output=True, text=True)
    said = {}
    for line in done.stdout.splitlines():
        if line.startswith("accepted  "):  # the verified checker, whose words have other spellings of the values
            said[line.removeprefix("accepted  ").split(": ", 1)[0]] = None
        elif ": accepted  " in line:
            name, said[name] = line.split(": accepted  ", 1)
        elif not line.startswith("not checked  "):
            raise SystemExit(f"make.py: {command[0]}: {line}")
    if done.returncode not in (0, 3):
        raise SystemExit(f"make.py: {command[0]}: {done.stderr.strip()}")
    return said


def index(bundle, requested, asked):
    """A row for each certificate, and how many each checker accepts."""
    names = [name_of(request) for request in requested]
    parts, said = [names[at:at + 50] for at in range(0, len(names), 50)], {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for checker, command in checkers(asked):
            each = pool.map(lambda part: checked(bundle, part, command), parts)
            said[checker] = {name: words for part in each for name, words in part.items()}
    rows = []
    for name, request in zip(names, requested):
        statements = {words[name] for words in said.values() if words.get(name)}
        if len(statements) != 1:
            raise SystemExit(f"make.py: {name}: the checkers do not say one thing: {sorted(statements)}")
        rows.append({
            "file": name, "statement": statements.pop(), **described(json.loads((bundle / name).read_text())),
            "edge": request.edge, "command": command_of(request),
            "accepted_by": [checker for checker, words in said.items() if name in words],
            "schema": "couplet.reference_index/1",
        })
    two_modes(rows)
    return rows, {checker: len(words) for checker, words in said.items()}


def two_modes(rows):
    """Refuses a curve between two modes whose point has not one of them on either side."""
    sides = {row["file"]: row["case"] or "[s,s]" for row in rows if row["file"].startswith("certificates/curves/")}
    for below, mode in sides.items():
        if below.endswith("-below.json"):
            found = {mode, sides[below.replace("-below", "-above")]}
            first, second = below.split("/")[-1].split("-")[:2]
            if found != {f"[{','.join(first)}]", f"[{','.join(second)}]"}:
                raise SystemExit(f"make.py: {below}: on both sides are {sorted(found)}")


def copy(source, target):
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(source, target)
    target.chmod(0o755 if os.access(source, os.X_OK) else 0o644)


def write(path, text):
    path.write_text(text, encoding="utf-8")
    path.chmod(0o644)


def manifest(bundle):
    """Hashes of all files, as sha256sum writes them; the last line is the hash of the lines before it."""
    names = sorted(str(path.relative_to(bundle)) for path in bundle.rglob("*") if path.is_file())
    digest = lambda data: hashlib.sha256(data).hexdigest()
    lines = "".join(f"{digest((bundle / name).read_bytes())}  {name}\n" for name in names)
    write(bundle / "MANIFEST", lines + f"{digest(lines.encode())}  MANIFEST\n")


def pack(bundle):
    """The bundle as an archive in which nothing tells when, where and by whom it was made."""
    def plain(entry):
        entry.mtime, entry.uid, entry.gid, entry.uname, entry.gname = THEN, 0, 0, "", ""
        entry.mode = 0o755 if entry.isdir() or entry.mode & 0o100 else 0o644
        return entry

    path = bundle.with_name(bundle.name + ".tar.gz")
    with open(path, "wb") as raw, gzip.GzipFile("", "wb", 9, raw, THEN) as packed, \
            tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for one in [bundle, *sorted(bundle.rglob("*"))]:
            archive.add(one, f"{bundle.name}/{one.relative_to(bundle)}".removesuffix("/."), recursive=False, filter=plain)
    return path


def make(asked):
    program = Program(asked.couplet)
    version = program.run("--version")[1].split()[1]
    bundle = pathlib.Path(asked.folder) / f"couplet-reference-{version}"
    shutil.rmtree(bundle, ignore_errors=True)
    bundle.mkdir(parents=True)

    with tempfile.TemporaryDirectory() as folder:
        states, wanted = requests(program, folder, asked.few)
    for folder in {request.folder for request in wanted}:
        (bundle / "certificates" / folder).mkdir(parents=True)
    if len(set(map(name_of, wanted))) != len(wanted):
        raise SystemExit("make.py: two certificates of one name")
    wanted, left = certified(program, bundle, states, wanted)
    write(bundle / "left_out.txt", "".join(f"{command}\n" for command in left))

    rows, counts = index(bundle, wanted, asked)
    write(bundle / "index.jsonl", "".join(json.dumps(row, ensure_ascii=False) + "\n" for row in rows))
    write(bundle / "THEOREM_MAP.json", json.dumps(theorem_map(program), indent=1, ensure_ascii=False) + "\n")
    for name in COPIED:
        copy(HOUSE / name, bundle / name)
    for name in ("theorem_map-1.json", "reference_index-1.json"):
        copy(HOUSE / "docs/schemas" / name, bundle / "schemas" / name)
    copy(HOUSE / "docs/certificate.md", bundle / "certificate.md")
    copy(PROOFS / "check_with_arb.py", bundle / "check_with_arb.py")
    for name in ("replay_arb.py", "replay_check.sh"):
        copy(PROOFS / "reference" / name, bundle / name)
    for source in sorted(path for pattern in COQ for path in (PROOFS / "coq").rglob(pattern)):
        copy(source, bundle / source.relative_to(HOUSE))
    by_folder = {folder: sum(request.folder == folder for request in wanted)
                 for folder in sorted({request.folder for request in wanted})}
    readme = (PROOFS / "reference/bundle.md").read_text(encoding="utf-8")
    table = lambda counts: "\n".join(f"| {name} | {count} |" for name, count in counts.items())
    write(bundle / "README.md", readme.replace("VERSION", version).replace("FOLDERS", table(by_folder))
          .replace("CHECKERS", table(counts)).replace("LEFT", str(len(left))))
    manifest(bundle)
    archive = pack(bundle)
    print(f"{archive}: {archive.stat().st_size} bytes, {len(rows)} certificates; accepted by "
          + ", ".join(f"{checker}: {count}" for checker, count in counts.items()))


def main():
    parser = argparse.ArgumentParser(prog="make.py", description=__doc__.split("\n\n")[0])
    parser.add_argument("folder")
    parser.add_argument("couplet", type=os.path.abspath)
    parser.add_argument("--checker", type=os.path.abspath, help="couplet-check")
    parser.add_argument("--arb", type=lambda name: os.path.abspath(shutil.which(name) or name), help="a Python with python-flint")
    parser.add_argument("--verified", type=os.path.abspath, help="couplet-verified")
    parser.add_argument("--few", action="store_true", help="a few certificates of each kind, for tests")
    asked = parser.parse_args()
    if not asked.few and not (asked.checker and asked.arb and asked.verified):
        parser.error("every checker has to be there, or --few is said")
    make(asked)


if __name__ == "__main__":
    main()
