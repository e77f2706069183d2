#!/usr/bin/env python3
"""The verified checker beside the quick one, on every certificate that the tests of certificates make and spoil.

    compare.py PROGRAM FOLDER

The tests keep each file in FOLDER with the answer of the quick checker in its name. What the verified checker accepts is
true, as Coq has proved, so that it may accept more: an enclosure may be tighter at the edge of a box. What the quick checker
accepts it has to accept, unless it says that it does not check such a file.
"""
import collections
import os
import pathlib
import subprocess
import sys

# What is left of the whole: files at the edge of a box.
EDGE = 0.01


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2]).absolute()
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.json"):
        old.unlink()
    features = "study,proptest"
    tests = ["cargo", "test", "--locked", "--workspace", "--features", features, "--test", "it", "--", "certificates::"]
    subprocess.run(tests, env=os.environ | {"COUPLET_KEEP_CERTIFICATES": str(folder)}, check=True)
    # A survey has a file of another kind.
    files = [path for path in sorted(folder.glob("*.json")) if b'"survey' not in path.read_bytes()]
    answers = {}
    for start in range(0, len(files), 100):
        part = [str(path) for path in files[start : start + 100]]
        lines = subprocess.run([program, "check", *part], capture_output=True, text=True, timeout=600).stdout
        for line in lines.splitlines():
            answer, rest = line.split("  ", 1)
            answers[pathlib.Path(rest.split(".json")[0]).name] = answer
    counts = collections.Counter((path.name.split("-")[0], answers.get(path.stem, "no answer")) for path in files)
    for (quick, verified), count in sorted(counts.items()):
        print(f"{count:6} {quick} by the quick checker, {verified} by the verified one")
    lost = counts["accepted", "refused"] + sum(n for (_, answer), n in counts.items() if answer == "no answer")
    more = counts["refused", "accepted"]
    if lost or more > EDGE * len(files) or len(files) < 5000:
        sys.exit(f"compare.py: {lost} lost, {more} accepted beyond the quick checker, of {len(files)} files")


main()
