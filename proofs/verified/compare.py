#!/usr/bin/env python3
"""The verified checker beside the quick one, on every certificate that the tests of certificates make and spoil.

    compare.py PROGRAM FOLDER [kept]

The tests keep each file in FOLDER with the answer of the quick checker in its name; with `kept` they are not run again. What
the verified checker accepts is true, as Coq has proved. So it may accept more, but only of boxes at their edge, where its
enclosures are tighter: each such file is named with the quick checker's reason, and any other reason is a fault. What the quick
checker accepts it has to accept, unless it says that it does not check such a file, and both have to say the same of it.
"""
import collections
import decimal
import os
import pathlib
import re
import subprocess
import sys

# What the quick checker says of a box at its edge.
EDGE = re.compile(r"(part \d+: )?(unique|root): (the Krawczyk operator does not map|a denominator of the equations may vanish|"
                  "the box is not inside)")
QUICK = ["target/debug/couplet-check", "--statement"]
PART = 100


def answers(command, files):
    """The first word of what a checker says of each file, and the rest."""
    said = {}
    for start in range(0, len(files), PART):
        part = [str(path) for path in files[start : start + PART]]
        for line in subprocess.run([*command, *part], capture_output=True, text=True, timeout=600).stdout.splitlines():
            before, name, after = re.fullmatch(r"(.*?)([^/ ]*)\.json: (.*)", line).groups()
            answer = re.match("accepted|refused|not checked", after if command == QUICK else before)[0]
            said[name] = answer, after.removeprefix(answer).strip(" :") if command == QUICK else after
    return said


def meant(statement):
    """A statement whose decimals have one spelling."""
    exact = decimal.Context(prec=2000, Emax=decimal.MAX_EMAX, Emin=decimal.MIN_EMIN)
    return re.sub(r" = ([0-9.e-]+)", lambda found: f" = {exact.create_decimal(found[1]).normalize(exact)}", statement)


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2]).absolute()
    subprocess.run(["cargo", "build", "--locked", "-p", "couplet-check"], check=True)
    if sys.argv[3:] != ["kept"]:
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.glob("*.json"):
            old.unlink()
        features = "study,proptest"
        tests = ["cargo", "test", "--locked", "--workspace", "--features", features, "--test", "it", "--", "certificates::"]
        subprocess.run(tests, env=os.environ | {"COUPLET_KEEP_CERTIFICATES": str(folder)}, check=True)
    files = sorted(folder.glob("*.json"))
    kept = lambda path: path.name.split("-")[0]
    verified = answers([program, "check"], files)
    of = lambda path: verified.get(path.stem, ("no answer", ""))
    counts = collections.Counter((kept(path), of(path)[0]) for path in files)
    for (quick, answer), count in sorted(counts.items()):
        print(f"{count:6} {quick} by the quick checker, {answer} by the verified one")
    accepted = [path for path in files if of(path)[0] == "accepted"]
    quick = answers(QUICK, accepted)
    lost = [path.name for path in files if (kept(path), of(path)[0]) == ("accepted", "refused") or of(path)[0] == "no answer"]
    beyond = {path.name: quick[path.stem][1] for path in accepted if quick[path.stem][0] != "accepted"}
    other = [path.name for path in accepted
             if path.name not in beyond and meant(quick[path.stem][1]) != meant(verified[path.stem][1])]
    for name, reason in beyond.items():
        print(f"{name}: accepted beyond the quick checker: {reason}")
    for name in lost + other:
        print(f"{name}: {'lost' if name in lost else 'another statement'}")
    forged, empty = folder / "a.json: accepted  T\nb.json", folder / "folder\n"
    forged.write_bytes(accepted[0].read_bytes())
    empty.mkdir(exist_ok=True)
    done = subprocess.run([program, "check", forged, empty], capture_output=True, text=True)
    forged.unlink()
    if done.stdout.count("\n") != 1 or "T\\nb.json: " not in done.stdout or not done.stderr.endswith("folder\\n: a folder\n"):
        sys.exit(f"compare.py: a name makes a line of its own: {done.stdout}{done.stderr}")
    wrong = [name for name, reason in beyond.items() if not EDGE.match(reason)]
    print(f"{len(accepted) - len(beyond) - len(other)} statements are those of the quick checker")
    if lost or other or wrong or len(files) < 5000:
        sys.exit(f"compare.py: {len(lost)} lost, {len(wrong)} accepted for want of a reason, {len(other)} other statements, "
                 f"of {len(files)} files")


main()
